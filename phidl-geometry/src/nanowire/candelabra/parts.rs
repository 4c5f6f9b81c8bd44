//! Parts of the detector: straight wires, bends, and turns of a hairpin on two bends.

use std::f64::consts::SQRT_2;

use phidl_core::prelude::*;

use crate::nanowire::right_angle::{inner_edge, lead_end};
use crate::{OptimalHairpinParams, arc, compass, optimal_90deg};

/// Pitch of a turn's hairpin in wire widths.
const PIN_PITCH: f64 = 10.0 / 3.0;
/// Length of a turn's hairpin in wire widths: standard, and with `xwing`.
const PIN_LENGTH: f64 = 8.0;
const XWING_PIN_LENGTH: f64 = 15.0;
/// Radius of the bends with `xwing` in wire widths, and their angular resolution in degrees.
const XWING_RADIUS: f64 = 3.0;
const XWING_RESOLUTION: f64 = 2.5;
/// Points and length of the bends at the terminals and of the standard turns.
const BEND_POINTS: usize = 15;
const BEND_LENGTH: f64 = 1.0;

/// What all parts have in common.
pub(super) struct Wire {
    pub(super) width: f64,
    pub(super) pitch: f64,
    pub(super) layer: Layers,
    pub(super) xwing: bool,
}

/// Position in a turn of the straight wire that sets the distance of its ports to one pitch.
#[derive(Clone, Copy, PartialEq)]
enum Pass {
    BeforePin,
    AfterPin,
}

impl Wire {
    /// From the left at port 1 around and back to the left at port 2, one pitch lower; its hairpin stands `pad / 2`
    /// further out.
    pub(super) fn turn(&self, pad: f64) -> Result<Device> {
        let (bend, angle) = if self.xwing { (self.round_bend(45.0)?, 270) } else { (self.bend()?, 90) };
        let pin = self.pin()?;
        let (at, length) = self.pass();
        let pass = self.upright(length)?;
        let chain = match at {
            Pass::BeforePin => [(&pass, "S", "N"), (&pin, "1", "2")],
            Pass::AfterPin => [(&pin, "1", "2"), (&pass, "N", "S")],
        };

        let mut d = Device::builder("candelabra_turn");
        let first = bend.place().rotated(angle);
        let outward = first.port("2")?;
        let mut end = outward.clone();
        d.add_port("1", first.port("1")?)?;
        d.add(first);
        for (part, near, far) in chain.into_iter().chain([(&bend, "2", "1")]) {
            let mut part = part.place();
            part.connect(near, &end)?;
            end = part.port(far)?;
            if pad > 0.0 && part.device().same_cell(&pin) {
                self.lengthen(&mut d, &mut part, outward.normal() * (pad / 2.0))?;
            }
            d.add(part);
        }
        d.add_port("2", end)?;
        d.build()
    }

    /// Moves a hairpin outwards and adds the two legs that it then stands on.
    fn lengthen(&self, d: &mut DeviceBuilder, pin: &mut Reference, by: Point) -> Result<()> {
        pin.move_by(by);
        let leg = self.upright(by.norm())?;
        for name in ["1", "2"] {
            let mut leg = leg.place();
            leg.connect("N", &pin.port(name)?)?;
            d.add(leg);
        }
        Ok(())
    }

    fn pin(&self) -> Result<Device> {
        let length = if self.xwing { XWING_PIN_LENGTH } else { PIN_LENGTH };
        OptimalHairpinParams {
            width: self.width,
            pitch: PIN_PITCH * self.width,
            length: length * self.width,
            layer: self.layer.clone(),
            ..Default::default()
        }
        .build()
    }

    /// Position and length of the straight wire that sets the distance of the ports to one pitch.
    fn pass(&self) -> (Pass, f64) {
        if !self.xwing {
            return (Pass::AfterPin, self.pitch);
        }
        let excess = PIN_PITCH * self.width - SQRT_2 * self.pitch;
        (if excess > 0.0 { Pass::BeforePin } else { Pass::AfterPin }, excess.abs())
    }

    /// The bend at the terminal: port 1 facing up, port 2 facing right.
    pub(super) fn terminal_bend(&self) -> Result<Reference> {
        if self.xwing {
            return Ok(self.round_bend(90.0)?.place().rotated(180));
        }
        Ok(optimal_90deg(self.width, BEND_POINTS, BEND_LENGTH, self.layer.clone())?.place())
    }

    fn round_bend(&self, angle: f64) -> Result<Device> {
        arc(XWING_RADIUS * self.width, self.width, angle, 0, XWING_RESOLUTION, self.layer.clone())
    }

    /// A bend of a standard turn: what the edge of an optimal right angle covers more than the same edge shifted by one
    /// wire width towards the corner.
    fn bend(&self) -> Result<Device> {
        let w = self.width;
        let outer = inner_edge(w, BEND_POINTS, BEND_LENGTH);
        let end = lead_end(&outer);
        let inner = outer.iter().rev().map(|p| *p - Point::new(w, w));
        let mut outline = vec![Point::new(end, w)];
        outline.extend(&outer);
        outline.extend([(w, end), (0.0, end), (0.0, end - w)].map(Point::from));
        outline.extend(inner);
        outline.extend([(end - w, 0.0), (end, 0.0)].map(Point::from));

        let mut d = Device::builder("candelabra_bend");
        d.add_polygon(outline, &self.layer)?;
        d.add_port("1", ((w / 2.0, end), w, 90))?;
        d.add_port("2", ((end, w / 2.0), w, 0))?;
        d.build()
    }

    /// A straight wire along x.
    pub(super) fn bar(&self, length: f64) -> Result<Reference> {
        Ok(compass((length, self.width), self.layer.clone())?.place())
    }

    /// A straight wire along y.
    fn upright(&self, length: f64) -> Result<Device> {
        compass((self.width, length), self.layer.clone())
    }
}
