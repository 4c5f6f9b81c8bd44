//! [`Frame`]: the operation of [`outline`](super::outline()), with its openings at ports.

use phidl_core::geom::Point;
use phidl_core::num::grid::Grid;
use phidl_core::port::Port;

use super::operand::Operand;
use crate::{
    contours::Contours, error::BooleanError, grid, offset::OffsetOptions, op::Operation, options::RunOptions,
    region::Region,
};

/// Which ports an outline leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum OpenPorts {
    /// None.
    #[default]
    Closed,
    /// All ports of the given shapes, by their width and this margin on either side (µm). A margin of zero opens the width
    /// of the port; the distance of the outline makes its ends flush with the port.
    WithMargin(f64),
}

/// A frame around shapes, or inside them if `distance` is negative.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    /// The width of the frame (µm).
    pub(super) distance: f64,
    pub(super) options: OffsetOptions,
    pub(super) open_ports: OpenPorts,
}

impl Frame {
    /// The frame of some shapes, without the openings.
    pub(super) fn region(
        &self,
        shapes: &Contours,
        openings: &Contours,
        grid: &Grid,
        run: &RunOptions,
    ) -> Result<Region, BooleanError> {
        let moved = grid::offset(shapes, grid.scaled(self.distance), &self.options, run)?;
        let merged = Region::merged(shapes, run)?;
        let (frame, inside) = if self.distance > 0.0 { (moved, merged) } else { (merged, moved) };
        let kept_open = inside.combine(&Region::merged(openings, run)?, Operation::Or, run)?;
        frame.combine(&kept_open, Operation::Not, run)
    }

    /// The ports of the outline: those of a single device or reference, if there are openings.
    pub(super) fn inherited_ports(&self, operand: &Operand) -> Vec<Port> {
        if self.open_ports == OpenPorts::Closed { Vec::new() } else { operand.ports_of_only_element() }
    }

    /// The openings at the ports, on a grid of `step` µm.
    pub(super) fn openings(&self, operand: &Operand, step: f64) -> Result<Vec<[(f64, f64); 4]>, BooleanError> {
        let OpenPorts::WithMargin(margin) = self.open_ports else { return Ok(Vec::new()) };
        Ok(operand.ports()?.iter().map(|port| self.opening(port, margin, step)).collect())
    }

    /// The rectangle over a port, from two grid steps inside to four beyond the frame.
    fn opening(&self, port: &Port, margin: f64, step: f64) -> [(f64, f64); 4] {
        // An inner frame lies on the other side of the port.
        let (from, to) = if self.distance > 0.0 {
            (-2.0 * step, self.distance + 4.0 * step)
        } else {
            (self.distance - 4.0 * step, 2.0 * step)
        };
        let (out, half) = (port.normal(), port.width() / 2.0 + margin);
        let across = Point::new(-out.y, out.x);
        let corner = |along: f64, side: f64| {
            let p = port.midpoint() + out * along + across * (side * half);
            (p.x, p.y)
        };
        [corner(from, -1.0), corner(to, -1.0), corner(to, 1.0), corner(from, 1.0)]
    }
}
