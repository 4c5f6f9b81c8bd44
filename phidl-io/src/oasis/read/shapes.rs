//! Rectangles, polygons, paths, trapezoids and circles.

use phidl_core::layer::Layer;
use phidl_core::num::count;

use super::super::cursor::{Cursor, Fault, Position, Result};
use super::super::point_list::{self, Owner};
use super::super::repetition::Repetition;
use super::super::trapezoid::{self, Sides};
use super::elements::{Flags, Target, corner, moved, out_of_range};
use super::file::Parser;
use super::modal::{self, Extension, PointList, undefined};
use crate::model::{Path, PathEnd, ProblemKind};

/// No circle has more corners: ten bytes may ask for a circle of meters. It is enough for a millimeter in nanometers.
const MOST_CHORDS: usize = 4096;

impl Parser<'_> {
    pub(super) fn rectangle(&mut self, cursor: &mut Cursor<'_>, start: Position) -> Result<Option<Target>> {
        let flags = Flags::read(cursor)?;
        let layer = self.layer(flags, cursor)?;
        let square = flags.has(7);
        let modal = &mut self.modal;
        let width = modal::update(&mut modal.width, flags.has(6), "geometry width", cursor, modal::length)?;
        if square {
            if flags.has(5) {
                return Err(Fault::new(start, "a square states a height"));
            }
            modal.height = Some(width);
        }
        let height = modal::update(&mut modal.height, flags.has(5), "geometry height", cursor, modal::length)?;
        let at = self.geometry_position(flags, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        let corners = [[0, 0], [width, 0], [width, height], [0, height]];
        self.polygons(layer, &corners, at, repetition, start)
    }

    pub(super) fn polygon(&mut self, cursor: &mut Cursor<'_>, start: Position) -> Result<Option<Target>> {
        let flags = Flags::read(cursor)?;
        let layer = self.layer(flags, cursor)?;
        if flags.has(5) {
            let list = &mut self.modal.polygon;
            list.even = point_list::read(cursor, Owner::Polygon, &mut list.corners)?;
        } else if self.modal.polygon.corners.is_empty() {
            return Err(undefined("polygon point list", cursor));
        } else {
            self.spend(1, self.modal.polygon.corners.len() / 4, start)?;
        }
        let at = self.geometry_position(flags, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        if !self.modal.polygon.even {
            self.problem(start, ProblemKind::OddList);
        }
        // Taken out for the call: the parser lists problems while it looks at the corners.
        let list = std::mem::take(&mut self.modal.polygon);
        let target = self.polygons(layer, &list.corners, at, repetition, start);
        self.modal.polygon = list;
        target
    }

    pub(super) fn trapezoid(
        &mut self,
        cursor: &mut Cursor<'_>,
        start: Position,
        deltas: [bool; 2],
    ) -> Result<Option<Target>> {
        let flags = Flags::read(cursor)?;
        let layer = self.layer(flags, cursor)?;
        let modal = &mut self.modal;
        let width = modal::update(&mut modal.width, flags.has(6), "geometry width", cursor, modal::length)?;
        let height = modal::update(&mut modal.height, flags.has(5), "geometry height", cursor, modal::length)?;
        let mut delta = |present| if present { cursor.signed() } else { Ok(0) };
        let (a, b) = (delta(deltas[0])?, delta(deltas[1])?);
        let at = self.geometry_position(flags, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        match trapezoid::corners(flags.has(7), [width, height], a, b) {
            Some(corners) => self.polygons(layer, &corners, at, repetition, start),
            None => Err(Fault::new(start, "a trapezoid has a side of negative length")),
        }
    }

    pub(super) fn compact_trapezoid(&mut self, cursor: &mut Cursor<'_>, start: Position) -> Result<Option<Target>> {
        let flags = Flags::read(cursor)?;
        let layer = self.layer(flags, cursor)?;
        let modal = &mut self.modal;
        let kind = modal::update(&mut modal.ctrapezoid, flags.has(7), "ctrapezoid type", cursor, |c| c.unsigned())?;
        let Some(sides) = trapezoid::sides(kind) else {
            return Err(Fault::new(start, format!("a ctrapezoid has type {kind}, but types are 0 to 25")));
        };
        let mut side = |variable, present, needed, name| -> Result<i64> {
            if present || needed { modal::update(variable, present, name, cursor, modal::length) } else { Ok(0) }
        };
        let width = side(&mut modal.width, flags.has(6), sides != Sides::Height, "geometry width")?;
        let height = side(&mut modal.height, flags.has(5), sides != Sides::Width, "geometry height")?;
        let at = self.geometry_position(flags, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        match trapezoid::compact(kind, [width, height]) {
            Some(corners) => self.polygons(layer, &corners, at, repetition, start),
            None => Err(Fault::new(start, format!("a ctrapezoid of type {kind} has a side of negative length"))),
        }
    }

    pub(super) fn circle(&mut self, cursor: &mut Cursor<'_>, start: Position) -> Result<Option<Target>> {
        let flags = Flags::read(cursor)?;
        let layer = self.layer(flags, cursor)?;
        let modal = &mut self.modal;
        let radius = modal::update(&mut modal.radius, flags.has(5), "circle radius", cursor, modal::length)?;
        let at = self.geometry_position(flags, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        self.problem(start, ProblemKind::Circle);
        let tolerance = self.options.circle_tolerance.map_or(0.5, |um| self.layout.grid.scaled(um));
        let corners = circle(radius, tolerance);
        self.spend(1, corners.len() / 4, start)?;
        self.polygons(layer, &corners, at, repetition, start)
    }

    pub(super) fn path(&mut self, cursor: &mut Cursor<'_>, start: Position) -> Result<Option<Target>> {
        let flags = Flags::read(cursor)?;
        let layer = self.layer(flags, cursor)?;
        let modal = &mut self.modal;
        let half = modal::update(&mut modal.half_width, flags.has(6), "path half width", cursor, modal::length)?;
        if flags.has(7) {
            let scheme = cursor.unsigned()?;
            extension((scheme >> 2) & 3, &mut modal.start_extension, cursor)?;
            extension(scheme & 3, &mut modal.end_extension, cursor)?;
        }
        let begin = modal::needed(&modal.start_extension, "path start extension", cursor)?;
        let end = modal::needed(&modal.end_extension, "path end extension", cursor)?;
        if flags.has(5) {
            point_list::read(cursor, Owner::Path, &mut modal.path.corners)?;
        } else if modal.path.corners.is_empty() {
            return Err(undefined("path point list", cursor));
        } else {
            self.spend(1, self.modal.path.corners.len() / 4, start)?;
        }
        let at = self.geometry_position(flags, cursor)?;
        let repetition = self.repetition(flags.has(2), cursor)?;
        let path = Path {
            layer,
            points: Vec::new(),
            width: 2 * half,
            fixed_width: false,
            start: path_end(begin),
            end: path_end(end),
            properties: Default::default(),
            offset: start.file,
        };
        let list = std::mem::take(&mut self.modal.path);
        let target = self.paths(&path, &list, at, repetition, start);
        self.modal.path = list;
        target.map(Some)
    }

    fn paths(
        &mut self,
        path: &Path,
        list: &PointList,
        at: [i64; 2],
        repetition: Option<Repetition>,
        start: Position,
    ) -> Result<Target> {
        if let Some(repetition) = &repetition {
            self.spend(repetition.count(), 1 + list.corners.len() / 4, start)?;
        }
        let paths = &mut self.open_cell().paths;
        let first = paths.len();
        let mut add = |at: [i64; 2]| {
            let points: Result<Vec<[i32; 2]>> =
                list.corners.iter().map(|c| corner(moved(at, Some(*c), start)?, start)).collect();
            paths.push(Path { points: points?, ..path.clone() });
            Ok(())
        };
        match repetition {
            None => add(at)?,
            Some(repetition) => repetition.each(|vector| add(moved(at, vector, start)?))?,
        }
        let end = self.open_cell().paths.len();
        Ok(Target::Paths(first..end))
    }

    /// Adds a polygon and its copies; `None` if it encloses nothing.
    fn polygons(
        &mut self,
        layer: Layer,
        corners: &[[i64; 2]],
        at: [i64; 2],
        repetition: Option<Repetition>,
        start: Position,
    ) -> Result<Option<Target>> {
        if let Some(repetition) = &repetition {
            self.spend(repetition.count(), corners.len().div_ceil(4), start)?;
        }
        let Some(extent) = Extent::of(corners) else {
            self.problem(start, ProblemKind::Empty);
            return Ok(None);
        };
        let polygons = &mut self.open_cell().polygons;
        let first = polygons.len();
        let mut add = |at: [i64; 2]| {
            if !extent.fits(at) {
                return Err(out_of_range(start));
            }
            // Corners that are out of range were refused above, so that nothing is cut off here.
            #[expect(clippy::cast_possible_truncation, reason = "the box of all corners has 32 bits")]
            polygons.push(layer, corners.iter().map(|c| [(at[0] + c[0]) as i32, (at[1] + c[1]) as i32]));
            Ok(())
        };
        match repetition {
            None => add(at)?,
            Some(repetition) => repetition.each(|vector| add(moved(at, vector, start)?))?,
        }
        let end = self.open_cell().polygons.len();
        Ok(Some(Target::Polygons(first..end)))
    }
}

/// The bounding box of the corners of a polygon.
struct Extent {
    min: [i64; 2],
    max: [i64; 2],
}

impl Extent {
    /// `None` if there are fewer than three corners, or all are on a line along an axis.
    fn of(corners: &[[i64; 2]]) -> Option<Self> {
        let first = *corners.first()?;
        let (mut min, mut max) = (first, first);
        for corner in corners {
            for ((min, max), at) in min.iter_mut().zip(&mut max).zip(corner) {
                (*min, *max) = ((*min).min(*at), (*max).max(*at));
            }
        }
        (corners.len() > 2 && min[0] < max[0] && min[1] < max[1]).then_some(Self { min, max })
    }

    fn fits(&self, at: [i64; 2]) -> bool {
        let fits = |axis: usize| {
            let low = at[axis].checked_add(self.min[axis]);
            let high = at[axis].checked_add(self.max[axis]);
            low.is_some_and(|low| low >= i64::from(i32::MIN)) && high.is_some_and(|high| high <= i64::from(i32::MAX))
        };
        fits(0) && fits(1)
    }
}

/// Reads one half of an extension scheme.
fn extension(scheme: u64, variable: &mut Option<Extension>, cursor: &mut Cursor<'_>) -> Result<()> {
    let start = cursor.position();
    *variable = Some(match scheme {
        0 => return Ok(()),
        1 => Extension::None,
        2 => Extension::HalfWidth,
        _ => {
            let by = cursor.signed()?;
            if by.unsigned_abs() > u64::from(u32::MAX) {
                return Err(Fault::new(start, "a path extension reaches beyond 32-bit coordinates"));
            }
            Extension::By(by)
        }
    });
    Ok(())
}

fn path_end(extension: Extension) -> PathEnd {
    match extension {
        Extension::None => PathEnd::Flush,
        Extension::HalfWidth => PathEnd::Square,
        Extension::By(by) => PathEnd::Extended(by),
    }
}

/// The corners of a polygon on a circle, on whole grid steps, without repeated ones.
#[expect(clippy::cast_precision_loss, clippy::cast_possible_truncation, reason = "a radius has 33 bits")]
fn circle(radius: i64, tolerance: f64) -> Vec<[i64; 2]> {
    let chords = count::for_tolerance(radius as f64, 360.0, tolerance).clamp(4, MOST_CHORDS);
    let mut corners: Vec<[i64; 2]> = (0..chords)
        .map(|i| {
            let corner = phidl_core::geom::Point::polar(radius as f64, 360.0 * i as f64 / chords as f64);
            [corner.x.round() as i64, corner.y.round() as i64]
        })
        .collect();
    corners.dedup();
    corners
}
