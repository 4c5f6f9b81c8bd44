//! [`Microstrip`]: impedance and velocity of a thin strip over a ground plane, with kinetic inductance.
//!
//! The formulas are those of Hammerstad and Jensen for a strip without thickness, at low frequency, to which a kinetic
//! inductance per square is added. They are explicit in the width. The width of a given impedance is found by a
//! bracketing root search. Minimizing a squared error was rejected: a minimum has no sharp end.

use phidl_core::prelude::*;
use roots::{SimpleConvergency, find_root_brent};

/// Impedance of free space (Ω), rounded as in the published formulas.
const FREE_SPACE: f64 = 376.73;
/// Permittivity (F/m) and permeability (H/m) of free space, rounded as PHIDL does.
const EPS_0: f64 = 8.854e-12;
const MU_0: f64 = 4.0 * PI * 1e-7;
/// Meters in a micrometer.
const METERS: f64 = 1e-6;
/// Range of the width search, in thicknesses of the dielectric.
const NARROWEST: f64 = 1e-6;
const WIDEST: f64 = 1e6;
/// Tolerance of the search for the logarithm of a width: the relative error of the width.
const WIDTH_TOLERANCE: f64 = 1e-14;

/// A microstrip technology: dielectric over a ground plane and film on top. Methods take the width of a strip.
///
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry::Microstrip;
/// let line = Microstrip::new(0.25, 2.0, 250e-12)?; // µm, 1, H/sq
/// let width = line.width_for(50.0)?;
/// assert!((line.impedance(width) - 50.0).abs() < 1e-9);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// E. Hammerstad and Ø. Jensen, "Accurate models for microstrip computer-aided design", IEEE MTT-S 1980,
/// <https://doi.org/10.1109/MWSYM.1980.1124303>.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Microstrip {
    thickness: f64,
    eps_r: f64,
    lk_per_sq: f64,
}

impl Microstrip {
    /// A dielectric of some thickness (µm) and relative permittivity, and a film with a kinetic inductance (H/sq).
    ///
    /// # Errors
    /// The thickness must be greater than 0, the permittivity at least 1 and the inductance at least 0.
    pub fn new(thickness: f64, eps_r: f64, lk_per_sq: f64) -> Result<Self> {
        Check::new("microstrip").unit("µm").greater("thickness of the dielectric", thickness, 0)?;
        Check::new("microstrip").at_least("eps_r", eps_r, 1)?;
        Check::new("microstrip").unit("H/sq").at_least("Lk_per_sq", lk_per_sq, 0)?;
        Ok(Self { thickness, eps_r, lk_per_sq })
    }

    /// Effective relative permittivity of a strip of this width (µm).
    #[must_use]
    pub fn effective_permittivity(&self, width: f64) -> f64 {
        let u = width / self.thickness;
        let u4 = u.powi(4);
        let a = 1.0 + ((u4 + (u / 52.0).powi(2)) / (u4 + 0.432)).ln() / 49.0 + (u / 18.1).powi(3).ln_1p() / 18.7;
        let b = 0.564 * ((self.eps_r - 0.9) / (self.eps_r + 3.0)).powf(0.053);
        (self.eps_r + 1.0) / 2.0 + (self.eps_r - 1.0) / 2.0 * (1.0 + 10.0 / u).powf(-a * b)
    }

    /// Impedance (Ω) of a strip of this width (µm) without kinetic inductance.
    #[must_use]
    pub fn geometric_impedance(&self, width: f64) -> f64 {
        let u = width / self.thickness;
        let f = 6.0 + (TAU - 6.0) * (-(30.666 / u).powf(0.7528)).exp();
        // ln(f/u + √(1 + x²)), written so that wide strips keep their digits.
        let x2 = (2.0 / u).powi(2);
        let logarithm = (f / u + x2 / (1.0 + (1.0 + x2).sqrt())).ln_1p();
        FREE_SPACE / TAU * logarithm / self.effective_permittivity(width).sqrt()
    }

    /// Inductance of a strip of this width (µm), the kinetic one included (H/m).
    #[must_use]
    pub fn inductance(&self, width: f64) -> f64 {
        self.slowness(width) * self.geometric_impedance(width) + self.lk_per_sq / (width * METERS)
    }

    /// Capacitance of a strip of this width (µm) to the ground (F/m).
    #[must_use]
    pub fn capacitance(&self, width: f64) -> f64 {
        self.slowness(width) / self.geometric_impedance(width)
    }

    /// Impedance (Ω) of a strip of this width (µm).
    #[must_use]
    pub fn impedance(&self, width: f64) -> f64 {
        (self.inductance(width) / self.capacitance(width)).sqrt()
    }

    /// Phase velocity (m/s) on a strip of this width (µm).
    #[must_use]
    pub fn velocity(&self, width: f64) -> f64 {
        1.0 / (self.inductance(width) * self.capacitance(width)).sqrt()
    }

    /// Width (µm) of the strip with this impedance (Ω), with a relative error below 1e-12.
    ///
    /// The impedance falls monotonically with the width, so the strip is unique.
    ///
    /// # Errors
    /// The width must be between a millionth and a million thicknesses of the dielectric.
    pub fn width_for(&self, impedance: f64) -> Result<f64> {
        let (narrow, wide) = (NARROWEST * self.thickness, WIDEST * self.thickness);
        let (highest, lowest) = (self.impedance(narrow), self.impedance(wide));
        if !(lowest..=highest).contains(&impedance) {
            let problem = format!(
                "the impedance is {impedance} Ω, but it must be from {lowest} Ω ({wide} µm wide) to {highest} Ω ({narrow} µm wide)"
            );
            return Err(Error::Invalid { device: "microstrip".into(), problem: problem.into() });
        }
        // Impedance over width is close to a straight line if both are logarithms.
        let off = |ln_u: f64| (self.impedance(self.thickness * ln_u.exp()) / impedance).ln();
        let mut until = SimpleConvergency { eps: WIDTH_TOLERANCE, max_iter: 200 };
        let ln_u = find_root_brent(NARROWEST.ln(), WIDEST.ln(), off, &mut until)
            .map_err(|error| Error::custom("microstrip", format_args!("no width for {impedance} Ω: {error}")))?;
        Ok(self.thickness * ln_u.exp())
    }

    /// Reciprocal of the velocity that the geometry alone would give (s/m).
    fn slowness(&self, width: f64) -> f64 {
        (self.effective_permittivity(width) * EPS_0 * MU_0).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() <= 1e-13 * b.abs()
    }

    #[test]
    fn impedances_and_permittivities_are_those_of_the_specification() {
        for (w, h, eps_r, impedance, eps_eff) in [
            (1.0, 1.0, 1.0, 126.4237599430942, 1.0),
            (1.0, 0.25, 2.0, 43.50414890047531, 1.7603905438273357),
            (10.0, 1.0, 11.7, 9.186245409621906, 9.98021782819663),
            (0.01, 1.0, 4.2, 242.60387929698408, 2.72934208283351),
            (100.0, 1.0, 9.8, 1.1707444603148576, 9.514014169470679),
        ] {
            let line = Microstrip::new(h, eps_r, 0.0).unwrap();
            assert!(near(line.geometric_impedance(w), impedance), "{} {impedance}", line.geometric_impedance(w));
            assert!(near(line.effective_permittivity(w), eps_eff));
            assert!(near(line.impedance(w), impedance), "without kinetic inductance both are one");
        }
    }

    #[test]
    fn kinetic_inductance_raises_the_impedance_and_slows_the_wave_as_specified() {
        let line = Microstrip::new(0.25, 2.0, 250e-12).unwrap();
        for (w, geometric, capacitance, impedance, velocity) in [
            (0.1, 6.001273422048997e-07, 2.968853658181558e-11, 9177.570495320984, 3670147.1758603337),
            (0.3, 3.875611706744806e-07, 4.757084893053357e-11, 4186.392002143077, 5021335.113153929),
            (1.0, 1.925350850035916e-07, 1.0172987893303262e-10, 1568.2413833393252, 6268138.187282491),
            (10.0, 2.8710857178144984e-08, 7.511849040405927e-10, 182.53485902463535, 7293018.808129505),
            (100.0, 3.10082488409081e-09, 7.142145215205885e-09, 18.72081853681904, 7479050.923842003),
        ] {
            assert!(near(line.inductance(w), geometric + 250e-12 / (w * 1e-6)));
            assert!(near(line.capacitance(w), capacitance));
            assert!(near(line.impedance(w), impedance));
            assert!(near(line.velocity(w), velocity));
        }
    }

    #[test]
    fn impedances_out_of_reach_are_refused_with_what_can_be_reached() {
        let line = Microstrip::new(0.25, 2.0, 250e-12).unwrap();
        let error = line.width_for(1e9).unwrap_err().to_string();
        assert!(error.starts_with("microstrip: the impedance is 1000000000 Ω, but it must be from "), "{error}");
        assert!(line.width_for(0.0).is_err() && line.width_for(f64::NAN).is_err());
    }

    #[test]
    fn lines_that_cannot_be_are_refused() {
        assert_eq!(
            Microstrip::new(0.0, 2.0, 0.0).unwrap_err().to_string(),
            "microstrip: thickness of the dielectric is 0 µm, but it must be greater than 0 µm"
        );
        assert!(Microstrip::new(1.0, 0.5, 0.0).is_err() && Microstrip::new(1.0, 2.0, -1e-12).is_err());
    }

    proptest! {
        #[test]
        fn a_width_comes_back_from_its_impedance(
            ln_w in -5.0..7.0_f64, h in 0.01..100.0_f64, eps_r in 1.0..15.0_f64, lk in 0.0..1e-9_f64,
        ) {
            let line = Microstrip::new(h, eps_r, lk).unwrap();
            let w = h * ln_w.exp();
            let back = line.width_for(line.impedance(w)).unwrap();
            prop_assert!((back / w - 1.0).abs() < 1e-12, "{w} {back}");
        }

        #[test]
        fn wider_strips_have_lower_impedances(
            ln_w in -5.0..7.0_f64, h in 0.01..100.0_f64, eps_r in 1.0..15.0_f64, lk in 0.0..1e-9_f64,
        ) {
            let line = Microstrip::new(h, eps_r, lk).unwrap();
            let w = h * ln_w.exp();
            prop_assert!(line.impedance(1.01 * w) < line.impedance(w));
        }
    }
}
