//! [`fill_rectangle`]: rectangles on a regular raster wherever nothing is near.

use phidl_core::num::count;
use phidl_core::param::{ConversionError, IntoOption, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::device;

use super::avoided::AvoidedArea;
use super::raster::{FreeBlock, Raster};
use crate::arguments::{LayerList, OneOrMany, PerAxis};
use crate::basic::{Corners, circle, rectangle};

/// Largest number of arrays that the free cells are placed in.
const MOST_ARRAYS: usize = 1_000_000;
/// Largest number of cells that touch, which are drawn as polygons.
const MOST_TOUCHING: usize = 1_000_000;

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

/// Fills the empty part of a box with equal cells on a regular raster: dummy fill, ground planes, vent holes.
///
/// ```text
///   ■ ■ ■ ■ ■ ■ ■ ■   fill_size: the raster
///   ■ ■ ■ ■     ■ ■   √density of it: the rectangles (inverted: the frames around them)
///   ■ ■     ┌─┐   ■
///   ■ ■ ↔   └─┘   ■   margin: no cell is nearer to what is avoided
///   ■ ■ ■ ■     ■ ■
/// ```
///
/// A cell of the raster has the size `fill_size`. It is used if its distance from all polygons on the avoided layers is at
/// least `margin`. Two different margins are the half axes of an ellipse. Area under polygons on `include_layers` is not
/// avoided. A remainder of the box smaller than a cell stays empty.
///
/// Rectangles smaller than a cell are drawn in one cell of their own, placed in arrays as large as possible. Patterns whose
/// cells touch (inverted ones and density 1) are drawn as polygons with shared corners, so that no grid opens a gap.
///
/// # Ports
/// None.
///
/// # Errors
/// Lists of different lengths; an inverted layer of density 1, where nothing is left to draw; a `cell` that is empty or
/// larger than `fill_size`; a box that is neither given nor drawn, or with more than 16 million cells, or with more than a million cells that touch.
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
    /// Layers whose polygons are filled, even where avoided layers are drawn.
    #[default(Layers::NONE)]
    include_layers: LayerList,
    /// Distance that is kept.
    #[default(100)]
    #[param(unit = "um", min = 0)]
    margin: PerAxis,
    /// The layers that are filled.
    #[default([0, 1, 3])]
    fill_layers: OneOrMany<Layer>,
    /// For each of them, which part of a cell is covered by its rectangle.
    #[default([0.5, 0.25, 0.7])]
    #[param(above = 0, max = 1)]
    fill_densities: OneOrMany<f64>,
    /// For each of them, whether the cell is covered except for that rectangle; none is inverted if the list is empty.
    #[default(OneOrMany(Vec::new()))]
    fill_inverted: OneOrMany<bool>,
    /// Where to fill, as two corners; none is the bounding box of what is drawn.
    #[default(None)]
    #[param(unit = "um")]
    bbox: Option<Corners>,
    /// Region to fill: only cells that lie in its polygons are used. None is the whole box.
    #[default(None)]
    #[param(named)]
    inside: Option<Device>,
    /// A cell of your own, placed with its center in the middle of every used cell of the raster, besides the rectangles.
    #[default(None)]
    #[param(named)]
    cell: Option<Device>,
) -> Result<Device> {
    let patterns = patterns(check, &fill_layers.0, &fill_densities.0, &fill_inverted.0)?;
    let within = match bbox {
        Some(Corners(a, c)) => Rect::new(a, c),
        None => inside.as_ref().unwrap_or(&device).bbox().ok_or_else(|| {
            Error::custom("fill_rectangle", "there is nothing to fill: bbox is not given and the device is empty")
        })?,
    };
    let mut raster = raster(check, within, fill_size)?;
    let avoided = |layer| match &avoid_layers {
        AvoidLayers::All => true,
        AvoidLayers::These(layers) => layers.contains(layer),
    };
    raster.take_near(&AvoidedArea::of(&device, avoided, &include_layers.0), margin);
    if let Some(inside) = &inside {
        raster.take_near(&AvoidedArea::outside(inside, within), PerAxis { x: 0.0, y: 0.0 });
    }

    let blocks = raster.free_blocks();
    check.at_most("number of arrays of free cells", blocks.len(), MOST_ARRAYS)?;
    let mut d = Device::builder("fill_pattern");
    let (touching, separate): (Vec<Pattern>, Vec<Pattern>) = patterns.into_iter().partition(Pattern::touches_neighbors);
    if !separate.is_empty() || cell.is_some() {
        let cell = fill_cell(fill_size, &separate, cell)?;
        for block in &blocks {
            let (columns, rows) = (as_u32(block.columns), as_u32(block.rows));
            let array = cell.array(columns, rows, (fill_size.width, fill_size.height));
            d.add(array.moved_by(raster.center(block.column, block.row)));
        }
    }
    for pattern in &touching {
        draw_touching(&mut d, pattern, &raster, &blocks)?;
    }
    d.build()
}

/// What one layer gets in every cell.
struct Pattern {
    layer: Layer,
    density: f64,
    inverted: bool,
}

impl Pattern {
    /// Whether the polygons of neighboring cells share an edge.
    fn touches_neighbors(&self) -> bool {
        self.inverted || self.density >= 1.0
    }
}

fn patterns(check: Check<'_>, layers: &[Layer], densities: &[f64], inverted: &[bool]) -> Result<Vec<Pattern>> {
    let rule = format!("be {}, one for each fill layer", layers.len());
    check.that("number of fill_densities", densities.len(), densities.len() == layers.len(), &rule)?;
    let fits = inverted.is_empty() || inverted.len() == layers.len();
    check.that("number of fill_inverted", inverted.len(), fits, &rule)?;
    let pattern = |(index, (layer, density)): (usize, (&Layer, &f64))| {
        let inverted = inverted.get(index).copied().unwrap_or(false);
        let param = format!("fill_densities[{index}]");
        check.that(&param, *density, !inverted || *density < 1.0, "be less than 1, since the layer is inverted")?;
        Ok(Pattern { layer: *layer, density: *density, inverted })
    };
    layers.iter().zip(densities).enumerate().map(pattern).collect()
}

fn raster(check: Check<'_>, within: Rect, fill_size: Size) -> Result<Raster> {
    /// A byte or two for each: 32 megabytes.
    const MOST: usize = count::MOST;
    let columns = Raster::cells_in(within.size().width, fill_size.width);
    let rows = Raster::cells_in(within.size().height, fill_size.height);
    let cells = columns.saturating_mul(rows);
    let limited = columns < count::MOST && rows < count::MOST && cells <= MOST;
    let rule = format!("give at most {MOST} cells in the box, {within}");
    check.that("fill_size", format!("{fill_size} µm"), limited, &rule)?;
    Ok(Raster::new(within, fill_size, columns, rows))
}

/// Draws a pattern whose cells touch, without references: neighbors have equal corners, so no rounding parts them.
fn draw_touching(d: &mut DeviceBuilder, pattern: &Pattern, raster: &Raster, blocks: &[FreeBlock]) -> Result<()> {
    let cells: usize = blocks.iter().map(|block| block.columns * block.rows).sum();
    FillRectangleParams::entry().check().at_most("number of cells that touch", cells, MOST_TOUCHING)?;
    for cell in blocks.iter().flat_map(FreeBlock::cells) {
        let outer = raster.bounds(&cell);
        if pattern.inverted {
            d.add_polygon(frame(outer, pattern.density.sqrt()), pattern.layer)?;
        } else {
            let (Point { x: l, y: b }, Point { x: r, y: t }) = (outer.min, outer.max);
            d.add_polygon([(r, t), (r, b), (l, b), (l, t)], pattern.layer)?;
        }
    }
    Ok(())
}

/// The cell of the raster, around the origin.
fn fill_cell(size: Size, patterns: &[Pattern], own: Option<Device>) -> Result<Device> {
    let mut d = Device::builder("fillcell");
    if let Some(own) = own {
        let Size { width, height } = own.size();
        let fits = !own.is_empty() && width <= size.width && height <= size.height;
        let rule = format!("draw something and fit into fill_size, {size} µm");
        FillRectangleParams::entry().check().that("cell", format_args!("{width} × {height} µm large"), fits, &rule)?;
        d.add(own.place().centered((0, 0)));
    }
    for pattern in patterns {
        let side = pattern.density.sqrt();
        let inner = Size::new(size.width * side, size.height * side);
        let shift = (-inner.width / 2.0, -inner.height / 2.0);
        d.add(rectangle(inner, pattern.layer)?.place().moved_by(shift));
    }
    d.build()
}

/// A frame around a hole whose sides are this part of the outer ones: one outline with a seam on the left of the hole,
/// since a polygon has no holes.
fn frame(outer: Rect, part: f64) -> [(f64, f64); 11] {
    let (Point { x: l, y: b }, Point { x: r, y: t }) = (outer.min, outer.max);
    let half = Point::new(outer.size().width, outer.size().height) * (part / 2.0);
    let (Point { x: p, y: q }, Point { x: u, y: v }) = (outer.center() - half, outer.center() + half);
    #[rustfmt::skip]
    let outline = [
        (r, t), (l, t), (l, q),
        (p, q), (p, v), (u, v), (u, q), (p, q),
        (l, q), (l, b), (r, b),
    ];
    outline
}

/// A number of cells, which is below the limit of the raster.
fn as_u32(n: usize) -> u32 {
    u32::try_from(n).unwrap_or(u32::MAX)
}
