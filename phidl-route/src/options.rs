//! [`SmoothOptions`]: the bends of smooth routes, as a parameter.

use std::collections::BTreeMap;

use phidl_core::Result;
use phidl_core::param::{ConversionError, Param, ParamType, Value};
use phidl_path::{ArcBend, Bend, EulerBend, Path};

use crate::manhattan::recorded;

/// Default number of points per full turn.
const NUM_PTS: f64 = 720.0;

/// The bends of a smooth route.
///
/// ```
/// # use phidl_route::SmoothOptions;
/// let coarse = SmoothOptions::Arc { num_pts: 16.0 };
/// let euler = SmoothOptions::Euler { p: 0.5, use_eff: true, num_pts: 720.0 };
/// assert_eq!(SmoothOptions::default(), SmoothOptions::euler());
/// ```
///
/// In JSON, as in PHIDL: `{"corner_fun": "arc", "num_pts": 16}`, `{"corner_fun": "euler", "p": 0.5, "use_eff": true}`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SmoothOptions {
    /// Arcs.
    Arc {
        /// Points per full turn; more than 0.
        num_pts: f64,
    },
    /// Euler bends.
    Euler {
        /// Fraction of the turn in the clothoids, 0 to 1.
        p: f64,
        /// Whether the radius is that of the arc with the same ends; otherwise it is the smallest radius.
        use_eff: bool,
        /// Points per full turn; more than 0.
        num_pts: f64,
    },
}

impl SmoothOptions {
    /// Arcs with 720 points per turn.
    #[must_use]
    pub fn arc() -> Self {
        Self::Arc { num_pts: NUM_PTS }
    }

    /// Clothoids as large as the arc of the radius, with 720 points per turn.
    #[must_use]
    pub fn euler() -> Self {
        Self::Euler { p: 1.0, use_eff: true, num_pts: NUM_PTS }
    }

    /// Whether the bend at a right angle is as large as the arc of its radius.
    pub(crate) fn is_as_large_as_its_arc(self) -> bool {
        matches!(self, Self::Arc { .. } | Self::Euler { use_eff: true, .. })
    }

    /// The same with the default number of points, if it has fewer.
    pub(crate) fn finer(self) -> Option<Self> {
        match self {
            Self::Arc { num_pts } if num_pts < NUM_PTS => Some(Self::arc()),
            Self::Euler { p, use_eff, num_pts } if num_pts < NUM_PTS => {
                Some(Self::Euler { p, use_eff, num_pts: NUM_PTS })
            }
            _ => None,
        }
    }

    /// The smallest radius of the bend at a corner (µm).
    pub(crate) fn smallest_radius(self, radius: f64, angle: f64) -> Result<f64> {
        match self {
            Self::Arc { .. } => Ok(radius),
            // The info belongs to the curve, so the fewest points suffice.
            Self::Euler { p, use_eff, .. } => Ok(recorded(&euler(p, use_eff).num_pts(1).path(radius, angle)?, "Rmin")),
        }
    }
}

impl Default for SmoothOptions {
    fn default() -> Self {
        Self::euler()
    }
}

fn euler(p: f64, use_eff: bool) -> EulerBend {
    let bend = EulerBend::new().p(p);
    if use_eff { bend.use_eff() } else { bend }
}

impl Bend for SmoothOptions {
    fn bend(&self, radius: f64, angle: f64) -> Result<Path> {
        match *self {
            Self::Arc { num_pts } => ArcBend::new().num_pts(num_pts).path(radius, angle),
            Self::Euler { p, use_eff, num_pts } => euler(p, use_eff).num_pts(num_pts).path(radius, angle),
        }
    }
}

impl Param for SmoothOptions {
    fn param_type() -> ParamType {
        ParamType::Other("{\"corner_fun\": \"arc\" or \"euler\", …}")
    }

    fn to_value(&self) -> Value {
        let entries: Vec<(&str, Value)> = match *self {
            Self::Arc { num_pts } => vec![("corner_fun", "arc".into()), ("num_pts", num_pts.into())],
            Self::Euler { p, use_eff, num_pts } => vec![
                ("corner_fun", "euler".into()),
                ("p", p.into()),
                ("use_eff", use_eff.into()),
                ("num_pts", num_pts.into()),
            ],
        };
        Value::Map(entries.into_iter().map(|(key, value)| (key.to_owned(), value)).collect())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let Value::Map(map) = value else {
            return Err(ConversionError::new(value, format!("be {}", Self::param_type())));
        };
        let arc = match map.get("corner_fun").map(Value::as_str) {
            Some(Some("arc")) => true,
            // PHIDL's default, also if other options are given.
            Some(Some("euler")) | None => false,
            Some(_) => return Err(ConversionError::new(&map["corner_fun"], "be arc or euler").at(".corner_fun")),
        };
        let known: &[&str] = if arc { &["corner_fun", "num_pts"] } else { &["corner_fun", "p", "use_eff", "num_pts"] };
        if let Some(unknown) = map.keys().find(|key| !known.contains(&key.as_str())) {
            return Err(ConversionError::new(
                value,
                format!("have only known keys, not {unknown:?}; known are {}", known.join(", ")),
            ));
        }
        let num_pts = entry(map, "num_pts", NUM_PTS)?;
        match arc {
            true => Ok(Self::Arc { num_pts }),
            false => Ok(Self::Euler { p: entry(map, "p", 1.0)?, use_eff: entry(map, "use_eff", false)?, num_pts }),
        }
    }
}

/// An entry of a map, or its default.
fn entry<T: Param>(map: &BTreeMap<String, Value>, key: &str, default: T) -> Result<T, ConversionError> {
    let read = |value| T::from_value(value).map_err(|mismatch| mismatch.at(format_args!(".{key}")));
    map.get(key).map_or(Ok(default), read)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_come_back_from_their_values() {
        let euler = SmoothOptions::Euler { p: 0.3, use_eff: false, num_pts: 100.0 };
        for options in [SmoothOptions::arc(), SmoothOptions::euler(), euler] {
            assert_eq!(SmoothOptions::from_value(&options.to_value()).unwrap(), options);
        }
    }

    #[test]
    fn options_of_the_other_bend_are_refused() {
        let read = |entries: Vec<(&str, Value)>| {
            let map: BTreeMap<String, Value> = entries.into_iter().map(|(k, v)| (k.to_owned(), v)).collect();
            SmoothOptions::from_value(&map.into())
        };
        assert!(read(vec![("corner_fun", "arc".into()), ("use_eff", true.into())]).is_err());
        assert!(read(vec![("corner_fun", "spline".into())]).is_err());
        assert!(read(vec![("p", "x".into())]).unwrap_err().to_string().starts_with(".p is"));
        assert_eq!(read(vec![]).unwrap(), SmoothOptions::Euler { p: 1.0, use_eff: false, num_pts: 720.0 });
    }
}
