//! [`fill_rectangle`]: rectangles on a regular raster wherever nothing is near.

use phidl_core::num::count;
use phidl_core::param::{ConversionError, IntoOption, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::raster::Raster;
use super::region::Region;
use crate::arguments::{Each, LayerList, PerAxis};
use crate::basic::{Corners, circle, rectangle};

/// Which layers a fill keeps away from.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry::fill::AvoidLayers;
/// assert_eq!(AvoidLayers::from(3), AvoidLayers::These(3.into()));
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub enum AvoidLayers {
    /// Every layer that is drawn on.
    #[default]
    All,
    /// These layers.
    These(Layers),
}

impl<L: Into<Layers>> From<L> for AvoidLayers {
    fn from(layers: L) -> Self {
        Self::These(layers.into())
    }
}

impl Param for AvoidLayers {
    fn param_type() -> ParamType {
        ParamType::Other("\"all\", a layer, or list of layers")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::All => "all".into(),
            Self::These(layers) => LayerList(layers.clone()).to_value(),
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Text(text) if text == "all" => Ok(Self::All),
            Value::Text(_) => Err(ConversionError::new(value, "be \"all\" or layers")),
            layers => LayerList::from_value(layers).map(|list| Self::These(list.0)),
        }
    }
}

impl IntoOption<Corners> for Rect {
    fn into_option(self) -> Option<Corners> {
        Some(self.into())
    }
}

impl<P: Into<Point>> IntoOption<Corners> for [P; 2] {
    fn into_option(self) -> Option<Corners> {
        Some(self.into())
    }
}

/// Fills the free part of a box with equal cells on a regular raster: dummy fill, ground planes, vent holes.
///
/// ```text
///   ■ ■ ■ ■ ■ ■ ■ ■   fill_size: the raster
///   ■ ■ ■ ■     ■ ■   √density of it: the rectangles (inverted: the frames around them)
///   ■ ■     ┌─┐   ■
///   ■ ■ ↔   └─┘   ■   margin: no cell is nearer to what is avoided
///   ■ ■ ■ ■     ■ ■
/// ```
///
/// A cell of the raster, as large as `fill_size`, is used if it lies at least `margin` away from everything that is
/// drawn on the avoided layers, round at corners. Two different margins are the half axes of an ellipse. What lies under
/// polygons on `include_layers` is not avoided. The rest of the box that no whole cell fits into stays free.
///
/// The result places one cell of its own, which holds the rectangles of all layers, in arrays as large as possible.
///
/// # Ports
/// None.
///
/// # Errors
/// Lists of different lengths; an inverted layer of density 1, where nothing is left to draw; a box that is neither
/// given nor drawn, or with more than 134 million cells.
///
/// # Numerics
/// The margin holds exactly, not from pixel to pixel: cells are compared with the polygons themselves, to 10⁻⁹ µm.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let mut d = Device::builder("chip");
/// d.add(pg::rectangle((10, 10), 0)?.place().moved_by((20, 20)));
/// let fill = pg::FillRectangleParams::new(d.build()?)
///     .fill_size((5, 5))
///     .margin(5)
///     .fill_layers(7)
///     .fill_densities(0.25)
///     .bbox([(0, 0), (50, 50)])
///     .build()?;
/// assert_eq!(fill.flat_polygons().on(7).count(), 84); // of 100: the square takes 4, its margin the 12 around it
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `fill_rectangle` in its parameters and its cell. Which cells are used differs:
/// there the margin is measured between pixels, and half a cell of it can be lost.
#[device(picture = "docs/fill_rectangle.svg", example = FillRectangleParams::new(circle(100, 2.5, 0)?).margin(20).bbox([(-250, -200), (250, 200)]))]
pub fn fill_rectangle(
    /// What is to be kept away from.
    #[param(name = "D")]
    device: Device,
    /// Width and height of a cell of the raster.
    #[default((40, 10))]
    #[param(unit = "um", min = 1e-6)]
    fill_size: Size,
    /// Layers to keep away from.
    #[default(AvoidLayers::All)]
    avoid_layers: AvoidLayers,
    /// Layers whose polygons are free for filling, whatever else is drawn there.
    #[default(Layers::NONE)]
    include_layers: LayerList,
    /// Distance that is kept.
    #[default(100)]
    #[param(unit = "um", min = 0)]
    margin: PerAxis,
    /// The layers that are filled.
    #[default([0, 1, 3])]
    fill_layers: Each<Layer>,
    /// For each of them, which part of a cell is covered by its rectangle.
    #[default([0.5, 0.25, 0.7])]
    #[param(above = 0, max = 1)]
    fill_densities: Each<f64>,
    /// For each of them, whether the cell is covered except for that rectangle; none is inverted if the list is empty.
    #[default(Each(Vec::new()))]
    fill_inverted: Each<bool>,
    /// Where to fill, as two corners; none is the bounding box of what is drawn.
    #[default(None)]
    #[param(unit = "um")]
    bbox: Option<Corners>,
) -> Result<Device> {
    let patterns = patterns(check, &fill_layers.0, &fill_densities.0, &fill_inverted.0)?;
    let within = match bbox {
        Some(Corners(a, c)) => Rect::new(a, c),
        None => {
            device.bbox().ok_or_else(|| Error::custom("fill_rectangle", "bbox is missing, and nothing is drawn"))?
        }
    };
    let mut raster = raster(check, within, fill_size)?;
    let avoided = |layer| match &avoid_layers {
        AvoidLayers::All => true,
        AvoidLayers::These(layers) => layers.contains(layer),
    };
    raster.take_near(&Region::of(&device, avoided, &include_layers.0), margin);

    let cell = fill_cell(fill_size, &patterns)?;
    let mut d = Device::builder("fill_pattern");
    for block in raster.free_blocks() {
        let (columns, rows) = (as_u32(block.columns), as_u32(block.rows));
        let array = cell.array(columns, rows, (fill_size.width, fill_size.height));
        d.add(array.moved_by(raster.center(block.column, block.row)));
    }
    d.build()
}

/// What one layer gets in every cell.
struct Pattern {
    layer: Layer,
    density: f64,
    inverted: bool,
}

fn patterns(check: Check<'_>, layers: &[Layer], densities: &[f64], inverted: &[bool]) -> Result<Vec<Pattern>> {
    let rule = format!("have one entry for each of the {} fill layers", layers.len());
    check.that("fill_densities", format!("{} long", densities.len()), densities.len() == layers.len(), &rule)?;
    let fits = inverted.is_empty() || inverted.len() == layers.len();
    check.that("fill_inverted", format!("{} long", inverted.len()), fits, &rule)?;
    let pattern = |(place, (layer, density)): (usize, (&Layer, &f64))| {
        let inverted = inverted.get(place).copied().unwrap_or(false);
        let param = format!("fill_densities[{place}]");
        check.that(&param, *density, !inverted || *density < 1.0, "be less than 1, since the layer is inverted")?;
        Ok(Pattern { layer: *layer, density: *density, inverted })
    };
    layers.iter().zip(densities).enumerate().map(pattern).collect()
}

fn raster(check: Check<'_>, within: Rect, fill_size: Size) -> Result<Raster> {
    /// A byte or two for each: a quarter of a gigabyte.
    const MOST: usize = 8 * count::MOST;
    let columns = Raster::cells_in(within.size().width, fill_size.width);
    let rows = Raster::cells_in(within.size().height, fill_size.height);
    let cells = columns.saturating_mul(rows);
    let limited = columns < count::MOST && rows < count::MOST && cells <= MOST;
    let rule = format!("give at most {MOST} cells in the box, {within}");
    check.that("fill_size", format!("{fill_size} µm"), limited, &rule)?;
    Ok(Raster::new(within, fill_size, columns, rows))
}

/// The cell of the raster, around the origin.
fn fill_cell(size: Size, patterns: &[Pattern]) -> Result<Device> {
    let mut d = Device::builder("fillcell");
    for pattern in patterns {
        let side = pattern.density.sqrt();
        let inner = Size::new(size.width * side, size.height * side);
        if pattern.inverted {
            d.add_polygon(frame(size, inner), pattern.layer)?;
        } else {
            let shift = (-inner.width / 2.0, -inner.height / 2.0);
            d.add(rectangle(inner, pattern.layer)?.place().moved_by(shift));
        }
    }
    d.build()
}

/// A frame around the origin: one outline with a seam on the left of its hole, since a polygon has no holes.
fn frame(outer: Size, hole: Size) -> [(f64, f64); 11] {
    let (a, b, p, q) = (outer.width / 2.0, outer.height / 2.0, hole.width / 2.0, hole.height / 2.0);
    #[rustfmt::skip]
    let outline = [
        (a, b), (-a, b), (-a, -q),
        (-p, -q), (-p, q), (p, q), (p, -q), (-p, -q),
        (-a, -q), (-a, -b), (a, -b),
    ];
    outline
}

/// A number of cells, which is below the limit of the raster.
fn as_u32(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}
