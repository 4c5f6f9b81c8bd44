//! [`test_via`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;
use crate::connect::compass;

/// How far the first wire lies below the upper edge of the pads (µm).
const BELOW_PAD_TOP: f64 = 5.0;

/// Draws a chain of vias between two pads, to measure their resistance and yield.
///
/// ```text
///   ┌───────┐   ┌─┐   ┌─┐          ┌───────┐
///   │       ├─┐ │ │   │ │          │       │   links of two vias and two wires run down
///   │  pad  │ │ │ │   │ └──────────┤  pad  │   and up inside the height of the pads
///   │       │ └─┘ └───┘            │       │
///   └───────┘                      └───────┘
/// ```
///
/// The first pad has its lower left corner at the origin. Pads, and the wires that leave them, are drawn on `pad_layer` and
/// on `wiring1_layer`. The chain begins below the upper right corner of the first pad and turns sideways where the next
/// link would leave the height of the pads.
///
/// # Ports
/// None.
///
/// # Info
/// `num_vias`: how many vias there are. A link has two, so an odd number loses one.
///
/// # Numerics
/// `min_pad_spacing` is compared with an estimate of what the chain takes, and lengthens the wire behind it where that is
/// shorter. Where it is not, this wire is drawn twice on `wiring1_layer` and not on `pad_layer`. Links turn exactly over
/// their vias only if `via_spacing` is four times `wire_width`. All parts are polygons of one cell, so that no grid opens a gap
/// between them.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let chain = pg::TestViaParams::default().num_vias(10).pad_size((100, 100)).build()?;
/// assert_eq!(chain.size(), Size::new(380.0, 100.0));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `test_via`.
#[device(picture = "docs/test_via.svg")]
pub fn test_via(
    /// How many vias.
    #[default(100)]
    #[param(max = 1000000)]
    num_vias: usize,
    /// Width of the wires.
    #[default(10.0)]
    #[param(unit = "um", above = 0.0)]
    wire_width: f64,
    /// Width and height of the vias.
    #[default(15.0)]
    #[param(unit = "um", above = 0.0)]
    via_width: f64,
    /// Length of the wires, which overlap by their width at the vias.
    #[default(40.0)]
    #[param(unit = "um", above = 0.0)]
    via_spacing: f64,
    /// Width and height of the pads.
    #[default((300, 300))]
    #[param(unit = "um", above = 0.0)]
    pad_size: Size,
    /// Distance that the pads have at the least, by an estimate.
    #[default(0.0)]
    #[param(unit = "um", min = 0.0)]
    min_pad_spacing: f64,
    /// Where the pads are drawn.
    #[default(0)]
    pad_layer: Layers,
    /// Where every other wire is drawn, and the pads once more.
    #[default(1)]
    wiring1_layer: Layers,
    /// Where the wires between these are drawn.
    #[default(2)]
    wiring2_layer: Layers,
    /// Where the vias are drawn.
    #[default(3)]
    via_layer: Layers,
) -> Result<Device> {
    let params = TestViaParams {
        num_vias,
        wire_width,
        via_width,
        via_spacing,
        pad_size,
        min_pad_spacing,
        pad_layer,
        wiring1_layer,
        wiring2_layer,
        via_layer,
    };
    let mut d = params.assembled()?;
    d.flatten()?;
    d.build()
}

impl TestViaParams {
    /// Pads, wires and links, as references.
    fn assembled(&self) -> Result<DeviceBuilder> {
        let &Self { num_vias, wire_width, via_width, via_spacing, pad_size, min_pad_spacing, .. } = self;
        let Self { pad_layer, wiring1_layer, wiring2_layer, via_layer, .. } = self;
        let chain = Chain { wire_width, via_width, via_spacing, pad_height: pad_size.height };
        let pads = [pad_layer, wiring1_layer];
        let wire_y = pad_size.height - BELOW_PAD_TOP - wire_width / 2.0;
        let nub = Point::new(pad_size.width + 1.5 * wire_width, wire_y);
        let head = Point::new(pad_size.width + 3.5 * wire_width, wire_y);

        let mut d = Device::builder("test_via");
        for layer in pads {
            d.add(pad(pad_size, layer)?);
            d.add(chain.wire(3.0 * wire_width, layer)?.moved_by(nub));
            d.add(chain.wire(wire_width, layer)?.moved_by(head));
        }
        let link = chain.link(wiring1_layer, wiring2_layer, via_layer)?;
        let run = chain.run(&link, chain.wire(wire_width, wiring1_layer)?.moved_by(head), num_vias / 2)?;
        for link in run.links {
            d.add(link);
        }

        let missing = min_pad_spacing - run.used;
        let (length, layers) = match missing > 3.0 * wire_width {
            true => (missing + wire_width, pads),
            false => (3.0 * wire_width, [wiring1_layer; 2]),
        };
        let mut right = f64::NEG_INFINITY;
        for layer in layers {
            let mut tail = chain.wire(length, layer)?;
            tail.connect_overlapping("W", &run.end, wire_width)?;
            // Its ports are on all four edges; a chain that had no room to turn may end to the left.
            right = tail.ports().map(|port| port.midpoint().x).fold(right, f64::max);
            d.add(tail);
        }
        for layer in pads {
            d.add(pad(pad_size, layer)?.moved_by((right, 0)));
        }
        d.info("num_vias", num_vias / 2 * 2);
        Ok(d)
    }
}

fn pad(size: Size, layer: &Layers) -> Result<Reference> {
    Ok(rectangle(size, layer)?.place())
}

/// The measures that the chain is made of (µm).
#[derive(Debug, Clone, Copy)]
struct Chain {
    wire_width: f64,
    via_width: f64,
    via_spacing: f64,
    pad_height: f64,
}

/// A chain that was laid.
struct Run {
    links: Vec<Reference>,
    /// Where the wire behind it begins.
    end: Port,
    /// Estimate of the width that it takes, with the wires in front of it and behind it (µm).
    used: f64,
}

impl Chain {
    /// A wire along x around the origin.
    fn wire(&self, length: f64, layer: &Layers) -> Result<Reference> {
        Ok(compass((length, self.wire_width), layer)?.place())
    }

    /// Two vias, the wire between them and the one that ends on the first of them.
    ///
    /// `W` and `E` are at its ends; `S` and `N` at its sides, where a chain turns.
    fn link(&self, wiring1: &Layers, wiring2: &Layers, via: &Layers) -> Result<Device> {
        let Self { wire_width: w, via_width, via_spacing: s, .. } = *self;
        let via = compass((via_width, via_width), via)?;
        let mut d = Device::builder("test_via_iter");
        d.add(self.wire(s, wiring1)?.moved_by((w - s, 0)));
        d.add(self.wire(s, wiring2)?);
        d.add(via.place().moved_by(((w - s) / 2.0, 0)));
        d.add(via.place().moved_by(((s - w) / 2.0, 0)));
        d.add_port("W", ((w - 1.5 * s, 0), w, 180))?;
        d.add_port("E", ((s / 2.0, 0), w, 0))?;
        d.add_port("S", ((1.5 * w, -w / 2.0), w, 270))?;
        d.add_port("N", ((1.5 * w, w / 2.0), w, 90))?;
        d.build()
    }

    /// The box of a link, whichever of its layers are drawn.
    fn link_box(&self) -> Rect {
        let Self { wire_width: w, via_width, via_spacing: s, .. } = *self;
        let (half_via, half) = (via_width / 2.0, via_width.max(w) / 2.0);
        let left = (w - 1.5 * s).min(-s / 2.0).min((w - s) / 2.0 - half_via);
        let right = (w - s / 2.0).max(s / 2.0).max((s - w) / 2.0 + half_via);
        Rect::new((left, -half), (right, half))
    }

    /// Lays links down from `head`, then up and down in the height of the pads.
    fn run(&self, link: &Device, head: Reference, count: usize) -> Result<Run> {
        let w = self.wire_width;
        let (mut down, mut turned) = (true, true);
        let mut run = Run { links: Vec::new(), end: head.port("S")?, used: 4.0 * w };
        let mut last = head;
        for _ in 0..count {
            let mut next = link.place();
            next.connect_overlapping("W", &run.end, w)?;
            let (above, below) = self.leaves_pads(&next);
            turned = above || below;
            if turned {
                // Sideways: from the side of the last link, and on from the side of this one.
                down = above;
                let side = if above { "S" } else { "N" };
                next.connect_overlapping("W", &last.port(side)?, w)?;
                run.end = next.port(side)?;
                run.used += 2.0 * (self.via_spacing - w);
            } else {
                run.end = next.port("E")?;
            }
            run.links.push(next.clone());
            last = next;
        }
        let out = match (turned, down) {
            (true, _) => "E",
            (false, true) => "N",
            (false, false) => "S",
        };
        run.end = last.port(out)?;
        Ok(run)
    }

    /// Whether a link reaches above the pads, or else below them.
    fn leaves_pads(&self, link: &Reference) -> (bool, bool) {
        let placed = link.transform().apply_rect(self.link_box()).expect("invariant: links turn by quarters");
        let above = placed.max.y > self.pad_height;
        (above, !above && placed.min.y < 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ten_vias_run_down_sideways_up_and_down_again() {
        let d = TestViaParams::default().num_vias(10).pad_size((100, 100)).assembled().unwrap().build().unwrap();
        let links = d.references().iter().filter(|r| r.device().name() == "test_via_iter");
        let placed: Vec<(Point, f64)> = links.map(|r| (r.transform().origin, r.transform().rotation)).collect();
        let expected = [(135, 45, 270), (180, 30, 0), (195, 75, 90), (240, 90, 0), (255, 45, 270)];
        assert_eq!(placed, expected.map(|(x, y, turn)| (Point::from((x, y)), f64::from(turn))));
    }

    #[test]
    fn a_link_box_is_that_of_its_drawing() {
        for (wire_width, via_width, via_spacing) in [(10.0, 15.0, 40.0), (10.0, 50.0, 30.0), (10.0, 2.0, 12.0)] {
            let chain = Chain { wire_width, via_width, via_spacing, pad_height: 100.0 };
            let link = chain.link(&1.into(), &2.into(), &3.into()).unwrap();
            assert_eq!(link.bbox(), Some(chain.link_box()));
        }
    }

    #[test]
    fn layers_left_out_move_nothing() {
        let all = TestViaParams::default();
        let without = all.clone().wiring1_layer(Layers::NONE).via_layer(Layers::NONE).build().unwrap();
        let all = all.build().unwrap();
        assert_eq!(without.layers(), [0.into(), 2.into()]);
        assert_eq!(without.xmax(), all.xmax());
    }

    #[test]
    fn an_odd_number_of_vias_tells_how_many_there_are() {
        let d = TestViaParams::default().num_vias(7).build().unwrap();
        assert_eq!(d.info()["num_vias"], Value::from(6));
        assert_eq!(d.area_by_layer()[&3.into()], 6.0 * 15.0 * 15.0);
    }
}
