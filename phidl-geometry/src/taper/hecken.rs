//! [`hecken_taper`]: a near-optimum impedance taper.
//!
//! The profile is Hecken's integral of a Bessel function, summed as a power series. All its terms are positive, so no
//! digit is lost. A quadrature over a Bessel function from a crate was rejected: two more dependencies and less accuracy.
//! Widths come from [`Microstrip::width_for`].

use phidl_core::num::count::linspace;
use phidl_core::prelude::*;
use phidl_macros::device;

use super::Microstrip;

/// Speed of light that the record `v/c` refers to (m/s); the round number is PHIDL's.
const C: f64 = 3e8;
/// Meters in a micrometer.
const METERS: f64 = 1e-6;

/// Draws a microstrip whose impedance follows Hecken's curve, without steps at its ends.
///
/// It lies along x, from (0, 0) to (`length`, 0), symmetric about the axis.
///
/// Each end is given by its impedance or by its width; if both are given, the width counts.
///
/// # Ports
/// `1` at the start, facing 180°; `2` at the end, facing 0°; both as wide as the line there.
///
/// # Info
/// `width1`, `width2` (µm), `Z1`, `Z2` (Ω): the ends. `x`, `w` (µm), `Z` (Ω), `v/c`: position, width, impedance and
/// velocity at every point, the last in units of 3e8 m/s. `num_squares`: length over width, summed. `time_length` (s):
/// travel time of a wave. `f_cutoff` (Hz): lowest matched frequency, `1 / (2 time_length)`. `length` (µm).
///
/// # Errors
/// An end with neither impedance nor width; an impedance that no strip on this dielectric has.
///
/// # Numerics
/// `num_pts` points on each side at equal steps of phase: steps are longer where the wave is faster. The integral is exact
/// to 1e-15; widths have a relative error below 1e-12.
///
/// # Differences from PHIDL
/// Widths are exact. PHIDL's minimum search stops early, with errors of up to 0.6 %.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let taper = pg::HeckenTaperParams::default().length(200).z1(50).width2(0.3).build()?;
/// assert!((taper.port("1")?.width() - 37.238373).abs() < 1e-6);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// R. P. Hecken, "A near-optimum matching section without discontinuities", IEEE Trans. Microwave Theory Tech. MTT-20,
/// 734–739 (1972).
#[device(picture = "docs/hecken_taper.svg", example = HeckenTaperParams::default().z1(50).width2(0.3))]
pub fn hecken_taper(
    /// Length.
    #[default(200.0)]
    #[param(unit = "um", above = 0.0)]
    length: f64,
    /// Hecken's B, a pure number. A larger B reduces reflections above the cutoff and raises the cutoff.
    #[default(4.0091)]
    #[param(name = "B", min = 0.0, max = 100.0)]
    b: f64,
    /// Thickness of the dielectric between strip and ground.
    #[default(0.25)]
    #[param(unit = "um", above = 0.0)]
    dielectric_thickness: f64,
    /// Relative permittivity of the dielectric.
    #[default(2.0)]
    #[param(min = 1.0)]
    eps_r: f64,
    /// Kinetic inductance of the film.
    #[default(250e-12)]
    #[param(name = "Lk_per_sq", unit = "H/sq", min = 0.0)]
    lk_per_sq: f64,
    /// Impedance at the start, unless `width1` is given.
    #[default(None)]
    #[param(name = "Z1", unit = "ohm", above = 0.0)]
    z1: Option<f64>,
    /// Impedance at the end, unless `width2` is given.
    #[default(None)]
    #[param(name = "Z2", unit = "ohm", above = 0.0)]
    z2: Option<f64>,
    /// Width at the start.
    #[default(None)]
    #[param(unit = "um", above = 0.0)]
    width1: Option<f64>,
    /// Width at the end.
    #[default(None)]
    #[param(unit = "um", above = 0.0)]
    width2: Option<f64>,
    /// Number of points on each side.
    #[default(100)]
    #[param(min = 2, max = 100000)]
    num_pts: usize,
    /// Where it is drawn.
    #[default(0)]
    layer: Layers,
) -> Result<Device> {
    let line = Microstrip::new(dielectric_thickness, eps_r, lk_per_sq)?;
    let z1 = end_impedance(check, &line, ("Z1", z1), ("width1", width1))?;
    let z2 = end_impedance(check, &line, ("Z2", z2), ("width2", width2))?;

    let profile = LineProfile::hecken(&line, b, (z1, z2), length, num_pts)?;
    let LineProfile { x, w, z, v } = &profile;
    let last = num_pts - 1;

    let mut d = Device::builder("hecken");
    d.add_polygon(profile.outline(), layer)?;
    d.add_port("1", ((0, 0), w[0], 180))?;
    d.add_port("2", ((length, 0), w[last], 0))?;
    let time = profile.sum_over_cells(|dx, k| dx * METERS / v[k]);
    d.info("num_squares", profile.sum_over_cells(|dx, k| dx / w[k]));
    d.info("width1", w[0]).info("width2", w[last]).info("Z1", z[0]).info("Z2", z[last]);
    d.info("w", w.clone()).info("x", x.clone()).info("Z", z.clone());
    d.info("v/c", v.iter().map(|v| v / C).collect::<Vec<_>>());
    d.info("time_length", time).info("f_cutoff", 1.0 / (2.0 * time)).info("length", length);
    d.build()
}

fn end_impedance(
    check: Check<'_>,
    line: &Microstrip,
    (z, impedance): (&str, Option<f64>),
    (w, width): (&str, Option<f64>),
) -> Result<f64> {
    let given = width.map(|width| line.impedance(width)).or(impedance);
    let rule = format!("be given, or {w} instead");
    check.that(z, "missing", given.is_some(), &rule)?;
    let impedance = given.unwrap_or_default();
    // Solved here so that an error names the given impedance.
    line.width_for(impedance).map(|_| impedance)
}

/// Samples along the line: positions and widths (µm), impedances (Ω) and velocities (m/s).
struct LineProfile {
    x: Vec<f64>,
    w: Vec<f64>,
    z: Vec<f64>,
    v: Vec<f64>,
}

impl LineProfile {
    fn hecken(line: &Microstrip, b: f64, (z1, z2): (f64, f64), length: f64, points: usize) -> Result<Self> {
        let (middle, half_ratio) = ((z1 * z2).ln() / 2.0, (z2 / z1).ln() / 2.0);
        let z: Vec<f64> =
            linspace(-1.0, 1.0, points).map(|xi| (middle + half_ratio * hecken_integral(b, xi)).exp()).collect();
        let w: Vec<f64> = z.iter().map(|z| line.width_for(*z)).collect::<Result<_>>()?;
        let v: Vec<f64> = w.iter().map(|w| line.velocity(*w)).collect();
        // Equal steps of phase: the length of a step is proportional to the velocity at its start.
        let total: f64 = v[..points - 1].iter().sum();
        let position = |sum: &mut f64, v: &f64| {
            let here = length * (*sum / total);
            *sum += v;
            Some(here)
        };
        let x = v.iter().scan(0.0, position).collect();
        Ok(Self { x, w, z, v })
    }

    /// The upper side from left to right, then the lower one back.
    fn outline(&self) -> Vec<Point> {
        let side = |sign: f64| self.x.iter().zip(&self.w).map(move |(x, w)| Point::new(*x, sign * w / 2.0));
        side(1.0).chain(side(-1.0).rev()).collect()
    }

    /// The sum of `f(dx, k)` over the steps from point `k` to the next.
    fn sum_over_cells(&self, f: impl Fn(f64, usize) -> f64) -> f64 {
        self.x.windows(2).enumerate().map(|(k, x)| f(x[1] - x[0], k)).sum()
    }
}

/// Hecken's curve, `B / sinh B · ∫₀^ξ I₀(B √(1 − t²)) dt`: odd, and ±1 at ξ = ±1.
///
/// With the power series of I₀ it is `Σ (B²/4)ᵏ/k!² · uₖ`, where `uₖ = ∫₀^ξ (1 − t²)ᵏ dt` obeys
/// `(2k + 1) uₖ = ξ (1 − ξ²)ᵏ + 2k uₖ₋₁`.
fn hecken_integral(b: f64, xi: f64) -> f64 {
    let quarter = b * b / 4.0;
    let mut u = xi;
    let mut power = 1.0;
    let mut coefficient = 1.0;
    let mut sum = u;
    // The terms grow up to about k = B/2 and fall faster than a geometric series from there.
    for k in (1..).map(f64::from) {
        power *= 1.0 - xi * xi;
        u = (xi * power + 2.0 * k * u) / (2.0 * k + 1.0);
        coefficient *= quarter / (k * k);
        sum += coefficient * u;
        if k > b && coefficient * u.abs() <= f64::EPSILON / 4.0 * sum.abs() {
            break;
        }
    }
    if b > 0.0 { sum * b / b.sinh() } else { sum }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::outlines_are_simple;
    use proptest::prelude::*;

    #[test]
    fn the_curve_is_that_of_the_specification() {
        for (xi, g) in [(0.25, 0.3999763258067535), (0.5, 0.7206294070786872), (0.9, 0.9790136457097777)] {
            assert!((hecken_integral(4.0091, xi) - g).abs() < 2e-15, "{}", hecken_integral(4.0091, xi));
        }
        assert_eq!(hecken_integral(0.0, 0.3), 0.3, "the limit of a straight line");
    }

    fn list(d: &Device, key: &str) -> Vec<f64> {
        d.info()[key].as_list().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
    }

    #[test]
    fn impedances_and_exact_widths_are_those_of_the_specification() {
        let d = HeckenTaperParams::default().length(200).z1(50).width2(0.3).build().unwrap();
        let (w, z) = (list(&d, "w"), list(&d, "Z"));
        for (k, impedance, width) in [
            (0, 50.0, 37.238373),
            (1, 50.353736, 36.974616),
            (10, 56.841246, 32.719833),
            (49, 440.860969, 4.004703),
            (75, 2335.070491, 0.625691),
            (99, 4186.392002, 0.3),
        ] {
            assert!((z[k] - impedance).abs() < 1e-6 && (w[k] - width).abs() < 1e-6, "{k}: {} {}", z[k], w[k]);
        }
        let line = Microstrip::new(0.25, 2.0, 250e-12).unwrap();
        assert!(w.iter().zip(&z).all(|(w, z)| (line.impedance(*w) / z - 1.0).abs() < 1e-12));
    }

    #[test]
    fn a_short_taper_is_close_to_the_measured_one() {
        let d = HeckenTaperParams::default().length(10).width1(1).width2(0.3).num_pts(5).build().unwrap();
        // Measured with widths that are off by up to 1e-4, so no closer than that.
        let measured = [2.683373737711382, 5.308707156333865, 7.759642209785468];
        assert!(list(&d, "x")[1..4].iter().zip(measured).all(|(x, m)| (x - m).abs() < 1e-3), "{:?}", list(&d, "x"));
        assert!((list(&d, "w")[2] - 0.5589508056640616).abs() < 1e-3);
        assert_eq!(d.polygons().next().unwrap().points.len(), 10);
        assert!((list(&d, "w")[0] - 1.0).abs() < 1e-12);
    }

    #[test]
    fn records_of_the_whole_line_are_near_those_measured() {
        let d = HeckenTaperParams::default().length(200).z1(50).width2(0.3).build().unwrap();
        let near = |key: &str, measured: f64| (d.info()[key].as_f64().unwrap() / measured - 1.0).abs() < 1e-3;
        assert!(near("num_squares", 143.94598134783558) && near("time_length", 3.00640986070228e-11));
        assert!(near("f_cutoff", 16631132252.979069));
    }

    #[test]
    fn an_end_without_impedance_and_width_is_refused() {
        let error = HeckenTaperParams::default().width2(0.3).build().unwrap_err();
        assert_eq!(error.to_string(), "hecken_taper: Z1 is missing, but it must be given, or width1 instead");
    }

    #[test]
    fn impedances_without_a_strip_are_refused() {
        let error = HeckenTaperParams::default().z1(1e12).z2(50).build().unwrap_err();
        assert!(error.report().contains("microstrip: the impedance is 1000000000000 Ω"), "{}", error.report());
    }

    proptest! {
        #[test]
        fn the_curve_is_odd_rises_and_ends_at_one(b in 0.0..100.0_f64, xi in 0.0..0.999_f64) {
            prop_assert!((hecken_integral(b, 1.0) - 1.0).abs() < 1e-13);
            prop_assert_eq!(hecken_integral(b, -xi), -hecken_integral(b, xi));
            // For a large B the curve reaches 1 long before its end, to the last digit.
            prop_assert!(hecken_integral(b, xi + 0.001) >= hecken_integral(b, xi) * (1.0 - 1e-14));
        }

        #[test]
        fn the_slope_is_the_bessel_function(b in 0.0..20.0_f64, xi in -0.9..0.9_f64) {
            // I₀(x) as the mean of exp(x cos φ) over a turn, an independent formula that converges at once.
            let bessel = |x: f64| (0..64).map(|i| (x * (TAU * f64::from(i) / 64.0).cos()).exp()).sum::<f64>() / 64.0;
            let h = 1e-4;
            let slope = (hecken_integral(b, xi + h) - hecken_integral(b, xi - h)) / (2.0 * h);
            let factor = if b > 0.0 { b / b.sinh() } else { 1.0 };
            let exact = factor * bessel(b * (1.0 - xi * xi).sqrt());
            prop_assert!((slope - exact).abs() < 1e-5 * (1.0 + exact), "{slope} {exact}");
        }

        #[test]
        fn tapers_stay_between_their_end_widths(w1 in 0.05..50.0_f64, w2 in 0.05..50.0_f64, n in 2..40_usize) {
            let d = HeckenTaperParams::default().width1(w1).width2(w2).num_pts(n).build().unwrap();
            prop_assert!(outlines_are_simple(&d));
            let x = list(&d, "x");
            prop_assert!(x.windows(2).all(|x| x[0] < x[1]));
            prop_assert!(x[0] == 0.0 && (x[n - 1] - 200.0).abs() < 1e-9);
            prop_assert!((d.size().height / w1.max(w2) - 1.0).abs() < 1e-9);
            prop_assert!((d.port("1").unwrap().width() / w1 - 1.0).abs() < 1e-10);
            prop_assert!((d.port("2").unwrap().width() / w2 - 1.0).abs() < 1e-10);
        }
    }
}
