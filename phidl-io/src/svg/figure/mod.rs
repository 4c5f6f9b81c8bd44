//! Figures: one device, small, with its ports and a scale, for documentation.
//!
//! A figure is for the eye, [`to_string`](super::to_string) for the whole truth. So a figure is flat, in whole tenths of
//! a pixel, and leaves out every point that nobody could see; a few kilobytes, whatever the device. It has neither blank
//! lines nor ids, and its lettering takes the color of the text around it: it can stand in the middle of Markdown, many
//! times on one page, light or dark.
//!
//! The same figure comes out on every machine, although sines differ there in their last bits: the noise is removed
//! before coordinates are rounded, by the rule of [`phidl_core::num::grid`], and everything after that is decided on
//! whole numbers.

mod notes;
mod outlines;
mod scale;
mod view;

use phidl_core::geom::Size;
use phidl_core::layer::{Color, LayerSet};
use phidl_core::scene::Device;

use super::number::escaped;
use super::positive;
use crate::counts::Counts;
use crate::error::{IoError, Result};
use notes::Notes;
pub use scale::ScaleBar;
use view::{PER_PIXEL, View, step};

/// Devices with more instances or corners are not drawn flat.
const MOST_FLAT: u64 = 1 << 24;

/// The largest size and margin, in pixels.
const MOST_PIXELS: f64 = 1e6;

/// How a figure is drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct FigureOptions {
    /// Colors and opacities, as in [`SvgOptions`](super::SvgOptions); and what lies over what, the first layer lowest.
    /// Layers that are not in the set lie above, ascending.
    pub layers: LayerSet,
    /// The largest width and height of what the device draws, in pixels; ports and scale come on top.
    pub size: Size,
    /// Space around everything, in pixels.
    pub margin: f64,
    /// Whether ports are shown, as arrows that leave the device, with their names.
    pub ports: bool,
    /// Whether labels are shown.
    pub labels: bool,
    /// Whether there is a bar that tells the scale.
    pub scale_bar: bool,
    /// What the device was made from: shown as dashed outlines over it.
    pub sources: Vec<Device>,
    /// What lies behind; nothing, unless given.
    pub background: Option<Color>,
}

impl Default for FigureOptions {
    fn default() -> Self {
        Self {
            layers: LayerSet::new(),
            size: Size::new(420.0, 240.0),
            margin: 4.0,
            ports: true,
            labels: true,
            scale_bar: true,
            sources: Vec::new(),
            background: None,
        }
    }
}

/// Draws a device as a small figure. The same device gives the same text on every machine.
///
/// What is narrower than a tenth of a pixel is not seen.
///
/// ```
/// # use phidl_core::prelude::*;
/// use phidl_io::svg::{FigureOptions, figure};
/// let mut d = Device::builder("pad");
/// d.add_polygon([(0, 0), (4, 0), (4, 2), (0, 2)], 1)?;
/// d.add_port("e", ((4, 1), 2, 0))?;
/// let options = FigureOptions { size: (100, 100).into(), ..FigureOptions::default() };
/// let picture = figure(&d.build()?, &options)?;
/// assert!(picture.contains(r#"d="M0 500h1000v-500h-1000z""#), "{picture}"); // 100 px, tenths, y down
/// assert!(picture.contains(">e</text>") && picture.contains(">1 µm</text>"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`IoError::Option`] for a size that is not positive, a margin that is negative, either of more than a million pixels;
/// [`IoError::TooLarge`] beyond 2²⁴ instances or corners.
pub fn figure(device: &Device, options: &FigureOptions) -> Result<String> {
    for (option, pixels) in [("size.width", options.size.width), ("size.height", options.size.height)] {
        positive(option, pixels)?;
        at_most_pixels(option, pixels)?;
    }
    if options.margin.is_nan() || options.margin < 0.0 {
        return Err(IoError::option("margin", options.margin, "be at least 0"));
    }
    at_most_pixels("margin", options.margin)?;
    Counts::check_flat(device, MOST_FLAT)?;
    let view = View::of(device, options);
    let mut notes = Notes::new(&view);
    if options.labels {
        notes.labels(device);
    }
    if options.ports {
        notes.ports(device);
    }
    if options.scale_bar {
        notes.scale_bar();
    }
    let (left, top, right, bottom) = notes.reach.grown(step(options.margin * PER_PIXEL as f64));
    let (w, h) = (right - left, bottom - top);
    let (width, height) = (w / PER_PIXEL, h / PER_PIXEL);
    let background = options.background.map_or_else(String::new, |color| {
        format!("<rect x=\"{left}\" y=\"{top}\" width=\"{w}\" height=\"{h}\" fill=\"{color}\"/>\n")
    });
    Ok(format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"{left} {top} {w} {h}\" style=\"max-width:100%;height:auto\">\n\
         <title>{title}</title>\n{background}{shapes}{notes}</svg>\n",
        title = escaped(device.name()),
        shapes = outlines::draw(device, &view, &options.layers) + &outlines::dashed(&options.sources, &view),
        notes = notes.text,
    ))
}

fn at_most_pixels(option: &'static str, pixels: f64) -> Result<()> {
    match pixels <= MOST_PIXELS {
        true => Ok(()),
        false => Err(IoError::option(option, pixels, format!("be at most {MOST_PIXELS}"))),
    }
}

#[cfg(test)]
mod tests {
    use phidl_core::prelude::*;

    use super::*;

    fn pad(noise: f64) -> Device {
        let mut d = Device::builder("pad & port");
        let ring = (0..40).map(|i| Point::polar(10.0 + noise * f64::from(i % 3), 9.0 * f64::from(i)));
        d.add_polygon(ring.collect::<Vec<_>>(), 3).unwrap();
        d.add_polygon([(0.0, 0.0), (20.0 + noise, 0.0), (20.0, 5.0 - noise), (0.0, 5.0)], 1).unwrap();
        d.add_port("<in>", ((20.0, 2.5 + noise), 5, 0)).unwrap();
        d.add_label("here", (5, 2), 1).unwrap();
        d.build().unwrap()
    }

    fn drawn(device: &Device) -> String {
        figure(device, &FigureOptions::default()).unwrap()
    }

    #[test]
    fn the_last_bits_of_coordinates_do_not_show() {
        let exact = drawn(&pad(0.0));
        for noise in [1e-15, -1e-15, 3e-14, -1e-12] {
            assert_eq!(drawn(&pad(noise)), exact, "{noise}");
        }
    }

    #[test]
    fn how_deep_a_shape_lies_does_not_show() {
        let inner = pad(0.0);
        let mut outer = Device::builder("pad & port");
        outer.add(inner.place().rotated(90).rotated(-90));
        outer.add_port("<in>", inner.port("<in>").unwrap()).unwrap();
        outer.add_label("here", (5, 2), 1).unwrap();
        assert_eq!(drawn(&outer.build().unwrap()), drawn(&inner));
    }

    #[test]
    fn figures_can_stand_in_markdown() {
        let text = drawn(&pad(0.0));
        assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
        assert!(!text.contains("\n\n") && !text.contains(" id="));
        assert!(text.contains(">&lt;in&gt;</text>") && text.contains("<title>pad &amp; port</title>"));
    }

    #[test]
    fn layers_lie_as_the_set_says_and_the_others_above() {
        let mut layers = LayerSet::new();
        layers.add(NamedLayer::new("lowest", 3).color("gold".parse().unwrap())).unwrap();
        let text = figure(&pad(0.0), &FigureOptions { layers, ..FigureOptions::default() }).unwrap();
        let fills: Vec<&str> = text.matches("fill=\"#ffd700\"").chain(text.matches("fill=\"#2b0fff\"")).collect();
        assert_eq!(fills.len(), 2);
        assert!(text.find("#ffd700") < text.find("#2b0fff"));
    }

    #[test]
    fn devices_without_size_can_be_drawn() {
        assert!(drawn(&Device::builder("nothing").build().unwrap()).contains("viewBox=\"-40 -40 "));
        let mut d = Device::builder("point");
        d.add_port("p", ((3, 4), 0, 45)).unwrap();
        assert!(drawn(&d.build().unwrap()).contains(">p</text>"));
    }

    #[test]
    fn sizes_and_margins_that_are_none_are_refused() {
        let refused = |options: FigureOptions| figure(&pad(0.0), &options).unwrap_err().to_string();
        let size = Size::new(0.0, 10.0);
        assert_eq!(
            refused(FigureOptions { size, ..FigureOptions::default() }),
            "the option size.width is 0, but it must be greater than 0 and finite"
        );
        for margin in [-1.0, f64::NAN, 1e9] {
            assert!(refused(FigureOptions { margin, ..FigureOptions::default() }).starts_with("the option margin is "));
        }
        let huge = FigureOptions { size: Size::new(1e300, 1e300), ..FigureOptions::default() };
        assert!(refused(huge).starts_with("the option size.width"));
    }
}
