//! The contact sheet: every device with its name and a scale, packed by our own packer and lettered in our own font.

use anyhow::Context;
use phidl_core::geom;
use phidl_core::prelude::*;
use phidl_geometry::text::Justify;
use phidl_geometry::{PackerParams, rectangle, text};
use phidl_io::cli::gallery::{Plate, add_layers};
use phidl_io::svg::{self, FigureOptions, ScaleBar};
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// Cards, lettering and scales: layers that no example uses.
const CARD: Layer = Layer::new(900, 0);
const NAME: Layer = Layer::new(901, 0);
const SCALE: Layer = Layer::new(902, 0);

/// On the sheet, a micrometer is a pixel. A device covers about this area, and is not wider or higher than this.
const AREA: f64 = 110.0 * 66.0;
const WIDEST: f64 = 180.0;
const HIGHEST: f64 = 66.0;
/// Height of names and of the words beside scales, and the space between lines.
const NAME_SIZE: f64 = 11.0;
const SCALE_SIZE: f64 = 8.0;
const GAP: f64 = 8.0;
/// Thickness of a scale's bar, and the longest part of a device's width that it takes.
const BAR: f64 = 1.5;
const BAR_PART: f64 = 0.6;
/// Space inside a card and between two; the sizes of cards with that space are multiples of a module.
const PADDING: f64 = 12.0;
const SPACING: f64 = 8.0;
const MODULE: (f64, f64) = (32.0, 142.0);
/// Widths of the sheet in modules, of which the one with the fewest gaps is taken, and a height that is never reached.
const MODULES: std::ops::RangeInclusive<u16> = 36..=44;
const ENDLESS: f64 = 1e5;
/// By which factor a sheet grows on which not everything fits.
const GROWTH: f64 = 1.01;
/// Margin around everything.
const MARGIN: f64 = 16.0;
/// The color behind.
const PAPER: &str = "#ffffff";

/// The sheet as an SVG picture.
pub(super) fn draw(plates: &[Plate]) -> anyhow::Result<String> {
    let sheet = sheet(plates).map_err(crate::report)?;
    let mut layers = LayerSet::new();
    for (name, layer, color) in [("card", CARD, "#f3f5f8"), ("name", NAME, "#20262e"), ("scale", SCALE, "#8792a0")] {
        layers.add(NamedLayer { alpha: 1.0, ..NamedLayer::new(name, layer).color(color.parse()?) })?;
    }
    add_layers(&mut layers, &sheet)?;
    let options = FigureOptions {
        layers,
        size: sheet.size(),
        margin: MARGIN,
        ports: false,
        labels: false,
        scale_bar: false,
        sources: Vec::new(),
        background: Some(PAPER.parse()?),
    };
    svg::figure(&sheet, &options).map_err(|error| anyhow::anyhow!(error.report()))
}

/// All devices that draw something on one sheet.
fn sheet(plates: &[Plate]) -> Result<Device> {
    let tiles = plates.iter().filter(|plate| !plate.device.is_empty()).map(tile).collect::<Result<Vec<_>>>()?;
    // So flat that it has its full width from the start, and grows in height only.
    let packer = PackerParams::new(tiles).spacing(SPACING).density(GROWTH).aspect_ratio((ENDLESS, 1));
    let packed = |modules| packer.clone().max_size((f64::from(modules) * MODULE.0, ENDLESS)).build();
    let sheets = MODULES.map(packed).collect::<Result<Vec<_>>>()?;
    let area = |sheet: &Device| sheet.size().width * sheet.size().height;
    let smallest = sheets.into_iter().min_by(|a, b| area(a).total_cmp(&area(b)));
    smallest.ok_or_else(|| Error::custom("gallery", "no width to choose from"))
}

/// A card with a device, as large as there is room, above its name and its scale.
fn tile(plate: &Plate) -> Result<Device> {
    let size = plate.device.size();
    let scale = (AREA / (size.width * size.height)).sqrt().min(WIDEST / size.width).min(HIGHEST / size.height);
    let mut shape = plate.device.place().with_transform(geom::Transform::scaling(scale));
    let legend = legend(plate.name, scale, shape.size().width)?;
    let whole = |content: f64, module: f64| ((content + 2.0 * PADDING + SPACING) / module).ceil() * module - SPACING;
    let width = whole(shape.size().width.max(legend.size().width), MODULE.0);
    let height = whole(shape.size().height + PADDING + legend.size().height, MODULE.1);
    let mut legend = legend.place();
    legend.set_xmin(PADDING).set_ymin(PADDING);
    shape.set_x(width / 2.0).set_y((legend.ymax() + height) / 2.0);

    let mut d = Device::builder(plate.name);
    d.add(rectangle((width, height), CARD)?);
    d.add(shape);
    d.add(legend);
    d.build()
}

/// The name, and below it the scale.
fn legend(name: &str, scale: f64, width: f64) -> Result<Device> {
    let mut d = Device::builder("legend");
    let name = d.add(text(name, NAME_SIZE, Justify::Left, NAME, "DEPLOF")?);
    d[name].set_xmin(0.0);
    if let Some(ScaleBar { um, label }) = ScaleBar::within(BAR_PART * width / scale) {
        let mut bar = rectangle((um * scale, BAR), SCALE)?.place();
        // Below the tails of letters, whether the name has some or not.
        bar.set_xmin(0.0).set_ymax(-0.3 * NAME_SIZE - GAP);
        let mut label = text(label, SCALE_SIZE, Justify::Left, SCALE, "DEPLOF")?.place();
        label.set_xmin(bar.xmax() + GAP / 2.0).set_y(bar.y());
        d.add(bar);
        d.add(label);
    }
    d.build()
}

/// A picture as PNG.
pub(super) fn to_png(picture: &str, width: u32) -> anyhow::Result<Vec<u8>> {
    let tree = Tree::from_str(picture, &Options::default())?;
    let scale = width as f32 / tree.size().width();
    let height = (tree.size().height() * scale).ceil();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the height of a picture")]
    let mut pixels = Pixmap::new(width, height as u32).context("a picture of no size")?;
    resvg::render(&tree, Transform::from_scale(scale, scale), &mut pixels.as_mut());
    Ok(pixels.encode_png()?)
}
