//! [`litho_star`].

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::rectangle;

/// Draws a star of lines through the origin at equal angles. The radius at which the lines merge shows the resolution; its
/// roundness shows the astigmatism.
///
/// The lines are references to one [`rectangle`](fn@rectangle); line `i` is turned by `180° · i / num_lines`.
///
/// # Ports
/// None.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let star = pg::litho_star(20, 0.4, 20, 1)?;
/// assert_eq!(star.references().len(), 20);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `litho_star`.
#[device(picture = "docs/litho_star.svg")]
pub fn litho_star(
    /// How many lines.
    #[default(20)]
    #[param(min = 1, max = 1000000)]
    num_lines: usize,
    /// Width of the lines.
    #[default(2.0)]
    #[param(unit = "um", above = 0.0)]
    line_width: f64,
    /// Length of the lines.
    #[default(200.0)]
    #[param(unit = "um", above = 0.0)]
    diameter: f64,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let line = rectangle((line_width, diameter), layer)?.place().moved_by((-line_width / 2.0, -diameter / 2.0));
    let mut d = Device::builder("litho_star");
    for i in 0..num_lines {
        d.add(line.clone().rotated(180.0 * i as f64 / num_lines as f64));
    }
    d.build()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_second_of_three_lines_is_turned_by_sixty_degrees() {
        let star = litho_star(3, 1, 10, 0).unwrap();
        let line: Vec<Point> = star.flat_polygons().nth(1).unwrap().points().collect();
        let expected =
            [(-4.080_127, 2.933_013), (4.580_127, -2.066_987), (4.080_127, -2.933_013), (-4.580_127, 2.066_987)];
        assert!(line.iter().zip(expected).all(|(p, q)| p.distance(q.into()) < 1e-6), "{line:?}");
    }

    #[test]
    fn a_star_without_lines_is_refused() {
        let error = litho_star(0, 1, 10, 0).unwrap_err().to_string();
        assert_eq!(error, "litho_star: num_lines is 0, but it must be at least 1");
    }
}
