//! [`packer`]: cells into as few and as small bins as they fit.
//!
//! Packing gives one cell for each bin; a generator returns one cell. [`PackerParams::bins`] returns the list, and the
//! registered generator places the bins in a row.
//!
//! A bin starts with the area of its boxes and grows until they fit. At each size several placement rules are tried, PHIDL's
//! among them; growing ends when PHIDL's rule fits, and the smallest result is taken. So a bin is never larger than PHIDL's
//! for the same boxes. Boxes are rounded up to the packing grid: rounding down, as PHIDL does, can violate `spacing`.

use phidl_core::prelude::*;
use phidl_macros::device;

use super::maxrects::{PackedRect, Rule, pack};
use crate::arguments::PartialSize;
use crate::basic::rectangle;

/// Largest number of cells: the time of packing grows with the square of their number.
const MOST_CELLS: usize = 4_000;
/// Floating point noise in a size, in steps of the packing grid: less than this is not rounded up to a whole step.
const NOISE: f64 = 1e-6;

/// Packs cells by their bounding boxes and places the bins side by side.
///
/// ```text
///   ┌────────────┐   ┌─────────┐
///   │┌────┐┌────┐│   │┌───┐┌──┐│   spacing / 2 around every box:
///   ││    ││    ││   ││   │└──┘│   spacing between two
///   │└────┘└────┘│   │└───┘    │
///   └────────────┘   └─────────┘
///  (0,0)  bin0           bin1
/// ```
///
/// For the bins on their own, such as the reticles of a mask, call [`PackerParams::bins`]. Boxes are not turned and do
/// not overlap. The first bin takes as many cells as fit into `max_size`, the next one of those that are left, and so on.
///
/// # Ports
/// None. The bins have the aliases `bin0`, `bin1`, …
///
/// # Info
/// `bins`: how many there are. In each bin `density`: the area of the packed boxes over that of the box around them.
///
/// # Errors
/// A cell that draws nothing, or that does not fit into `max_size` with half of `spacing` around it. More than 4,000 cells.
///
/// # Numerics
/// Positions are multiples of `precision`; boxes with their spacing are rounded up to it, so there is up to `precision`
/// more between two cells than `spacing`. A bin grows by the factor `density` in both directions until its boxes fit:
/// closer to 1 is slower and denser.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let cells: Vec<Device> = (1..=8).map(|n| pg::rectangle((n, 10 - n), 0)).collect::<Result<_>>()?;
/// let bins = pg::PackerParams::new(&cells).spacing(1).max_size((16, 16)).bins()?;
/// assert_eq!(bins.iter().map(|bin| bin.references().len()).sum::<usize>(), 8);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// The maximal-rectangles method after J. Jylänki, "A thousand ways to pack the bin" (2010); compatible with PHIDL's
/// `packer`, at its density or above. Without its `verbose`: nothing here prints.
#[device(picture = "docs/packer.svg", example = PackerParams::new([rectangle((1, 8), 1)?, rectangle((2, 7), 2)?, rectangle((3, 6), 3)?, rectangle((4, 5), 4)?, rectangle((5, 4), 5)?, rectangle((6, 3), 6)?, rectangle((7, 2), 7)?, rectangle((8, 1), 8)?]).spacing(1))]
pub fn packer(
    /// The cells.
    #[param(name = "D_list")]
    devices: Vec<Device>,
    /// Distance between two bounding boxes.
    #[default(10)]
    #[param(unit = "um", min = 0)]
    spacing: f64,
    /// Width to height of the bins, unless `max_size` limits them.
    #[default((1, 1))]
    #[param(above = 0)]
    aspect_ratio: Size,
    /// Largest width and height of a bin, with half of `spacing` around every cell; none is without limit.
    #[default(PartialSize::NONE)]
    #[param(unit = "um", above = 0)]
    max_size: PartialSize,
    /// Whether large boxes are packed before small ones; otherwise in the order of the list.
    #[default(true)]
    sort_by_area: bool,
    /// By which factor a bin grows that is too small.
    #[default(1.1)]
    #[param(min = 1.01)]
    density: f64,
    /// Step of the positions.
    #[default(0.01)]
    #[param(unit = "um", above = 0)]
    precision: f64,
) -> Result<Device> {
    let params = PackerParams { devices, spacing, aspect_ratio, max_size, sort_by_area, density, precision };
    let bins = params.bins()?;
    let mut d = Device::builder("packer");
    let mut left = 0.0;
    for (number, bin) in bins.iter().enumerate() {
        d.add_as(&format!("bin{number}"), bin.place().moved_by((left, 0.0)));
        // A bin reaches as far beyond its cells on the right as on the left: half the spacing.
        left += bin.xmax() + spacing / 2.0;
    }
    d.info("bins", bins.len());
    d.build()
}

/// A cell to be packed.
#[derive(Clone, Copy)]
struct Item {
    /// Its index in the list.
    number: usize,
    /// Width and height of its box with spacing, in steps of the packing grid.
    size: (f64, f64),
}

impl PackerParams {
    /// The bins, each a cell of its own: the list that PHIDL's `packer` returns. No cells give no bins.
    ///
    /// # Errors
    /// As for [`packer`]. The result is not cached.
    pub fn bins(&self) -> Result<Vec<Device>> {
        self.check()?;
        let mut left = self.items()?;
        if self.sort_by_area {
            left.sort_by(|a, b| (b.size.0 * b.size.1).total_cmp(&(a.size.0 * a.size.1)));
        }
        let mut bins = Vec::new();
        while !left.is_empty() {
            let placed = self.fill_bin(&left);
            let mut rooms = placed.iter();
            bins.push(self.bin(left.iter().zip(&placed).filter_map(|(item, room)| Some((item.number, (*room)?))))?);
            left.retain(|_| rooms.next().is_some_and(Option::is_none));
        }
        Ok(bins)
    }

    fn check(&self) -> Result<()> {
        let check = Self::entry().check();
        check.at_most("number of cells in D_list", self.devices.len(), MOST_CELLS)?;
        check.at_least("spacing", self.spacing, 0)?;
        check.greater("aspect_ratio.width", self.aspect_ratio.width, 0)?;
        check.greater("aspect_ratio.height", self.aspect_ratio.height, 0)?;
        check.at_least("density", self.density, 1.01)?;
        check.greater("precision", self.precision, 0)?;
        for limit in [self.max_size.width, self.max_size.height].into_iter().flatten() {
            check.greater("max_size", limit, 0)?;
        }
        Ok(())
    }

    /// The largest bin, in steps.
    fn most(&self) -> (f64, f64) {
        let steps = |limit: Option<f64>| limit.map_or(f64::INFINITY, |limit| limit / self.precision);
        (steps(self.max_size.width), steps(self.max_size.height))
    }

    /// The boxes, with everything checked that can keep one from being packed.
    fn items(&self) -> Result<Vec<Item>> {
        let most = self.most();
        let check = Self::entry().check();
        // Rounding up must not push a box out of a bin into which it fits.
        let steps = |length: f64, most: f64| {
            let exact = (length + self.spacing) / self.precision;
            (exact <= most + NOISE).then(|| (exact - NOISE).ceil().max(1.0).min(most))
        };
        let item = |(number, device): (usize, &Device)| {
            let site = format!("D_list[{number}]");
            let empty = device.is_empty();
            check.that(
                &site,
                format!("\"{}\", which is empty", device.name()),
                !empty,
                "draw something to be packed",
            )?;
            let Size { width, height } = device.size();
            let size = steps(width, most.0).zip(steps(height, most.1));
            let rule = "fit into max_size with half of spacing around it";
            check.that(&site, format!("{width} × {height} µm large"), size.is_some(), rule)?;
            Ok(size.map(|size| Item { number, size }))
        };
        self.devices.iter().enumerate().filter_map(|device| item(device).transpose()).collect()
    }

    /// Where the items are in one bin; none for those that do not fit into the largest one.
    fn fill_bin(&self, items: &[Item]) -> Vec<Option<PackedRect>> {
        let sizes: Vec<(f64, f64)> = items.iter().map(|item| item.size).collect();
        let most = self.most();
        let area: f64 = sizes.iter().map(|(width, height)| width * height).sum();
        let largest = sizes.iter().fold((0.0_f64, 0.0_f64), |a, b| (a.0.max(b.0), a.1.max(b.1)));
        let Size { width, height } = self.aspect_ratio;
        let side = area.sqrt() / width.hypot(height);
        let mut bin = ((width * side).min(most.0), (height * side).min(most.1));
        let mut best: Option<Vec<Option<PackedRect>>> = None;
        loop {
            // Less than the area or the largest box needs no trial.
            let possible = bin.0 * bin.1 >= area && bin.0 >= largest.0 && bin.1 >= largest.1;
            let complete =
                |rule: &Rule| possible.then(|| pack(bin, &sizes, *rule)).filter(|placed| is_complete(placed));
            let trials: Vec<_> = Rule::ALL.iter().map(complete).collect();
            let enough = trials.first().is_some_and(Option::is_some);
            let candidates = best.take().into_iter().chain(trials.into_iter().flatten());
            best = candidates.reduce(|a, b| if self.extent(&b) < self.extent(&a) { b } else { a });
            match best {
                Some(best) if enough || bin == most => return best,
                None if bin == most => return fullest(bin, &sizes),
                _ => bin = ((bin.0 * self.density).min(most.0), (bin.1 * self.density).min(most.1)),
            }
        }
    }

    /// Area of the box around the packed cells, in square steps.
    fn extent(&self, placed: &[Option<PackedRect>]) -> f64 {
        let spacing = self.spacing / self.precision;
        let corner = placed
            .iter()
            .flatten()
            .fold((0.0_f64, 0.0_f64), |(x, y), room| (x.max(room.x + room.width), y.max(room.y + room.height)));
        (corner.0 - spacing) * (corner.1 - spacing)
    }

    fn bin(&self, placed: impl Iterator<Item = (usize, PackedRect)>) -> Result<Device> {
        let mut d = Device::builder("packed");
        let mut area = 0.0;
        for (number, room) in placed {
            let center = (room.x + room.width / 2.0, room.y + room.height / 2.0);
            let center = (center.0 * self.precision, center.1 * self.precision);
            area += self.devices[number].bbox().map_or(0.0, |bbox| bbox.area());
            d.add(self.devices[number].place().centered(center));
        }
        let whole = d.bbox().map_or(0.0, |bbox| bbox.area());
        // Lines have no area to fill.
        d.info("density", if whole > 0.0 { area / whole } else { 1.0 });
        d.build()
    }
}

fn is_complete(placed: &[Option<PackedRect>]) -> bool {
    placed.iter().all(Option::is_some)
}

/// The result of the rule that packs the largest area; the first one on ties.
fn fullest(bin: (f64, f64), sizes: &[(f64, f64)]) -> Vec<Option<PackedRect>> {
    let area =
        |placed: &[Option<PackedRect>]| placed.iter().flatten().map(|room| room.width * room.height).sum::<f64>();
    let mut best = pack(bin, sizes, Rule::ALL[0]);
    for rule in &Rule::ALL[1..] {
        let placed = pack(bin, sizes, *rule);
        if area(&placed) > area(&best) {
            best = placed;
        }
    }
    best
}
