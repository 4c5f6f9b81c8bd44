//! The scenes of testkit on a grid of 1e-4 µm.

use phidl_boolean::grid::{self, Contours};
use testkit::scenes::{self, Outlines};

/// Rectangles, discs and stars; see [`scenes::confetti`].
pub(crate) fn confetti(n: usize, seed: u64) -> Contours {
    snapped(&scenes::confetti(n, seed))
}

/// Discs of twelve points, which do not touch.
pub(crate) fn dots(n: usize) -> Contours {
    snapped(&scenes::dots(n, 12))
}

/// Outlines in micrometers on the grid.
pub(crate) fn snapped(outlines: &Outlines) -> Contours {
    let steps = grid::with_step(1e-4).expect("a positive length");
    let pairs = outlines.iter().map(|outline| outline.iter().map(|p| (p.x, p.y)));
    grid::snap(&steps, pairs).expect("scenes are far smaller than the range")
}
