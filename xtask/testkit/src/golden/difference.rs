//! One deliberate difference from the reference results.

use std::collections::BTreeMap;

use serde_json::Value as Json;

use super::Case;

/// One deliberate difference. Everything that none applies to must match.
#[derive(Debug, Clone, Copy)]
pub struct Difference {
    /// The generators, routes or path functions it is about; `*` is every shape.
    pub functions: &'static [&'static str],
    /// When it applies, in words.
    pub condition: &'static str,
    /// When it applies.
    pub applies: fn(&Case) -> bool,
    /// Why ours differs: a defect of the reference, or a proof.
    pub reason: &'static str,
    /// What is compared instead, in words.
    pub instead: &'static str,
    /// What is compared instead.
    pub compare: Instead,
    /// Whether the project's own cases hold none that it applies to; only further reference results may.
    pub further: bool,
}

/// What is compared where ours differs.
#[derive(Debug, Clone, Copy)]
pub enum Instead {
    /// The covered region, ports and info.
    Region,
    /// Ports and info.
    Ports,
    /// Ours refuses, for a reason of this class.
    Refused(Refusal),
    /// Ours refuses for a reason of this class, or draws what the reference draws.
    RefusedOrSame(Refusal),
    /// Ours draws, where the reference refuses.
    Drawn,
    /// Ours with one of these numbers changed by a hair draws what the reference draws.
    Nearby(&'static [&'static str]),
    /// Ours with other parameters draws what the reference draws.
    With(fn(&Case) -> BTreeMap<String, Json>),
    /// Every corner is within a step of the grid; ports, info and box.
    CornersToAStep,
    /// Area of each layer, box, port widths and info agree to this part of them.
    Within(f64),
    /// The layers that are drawn on are as they are when no layer is left out.
    OtherLayers,
    /// The polygons on the layer of this parameter, point by point.
    LayerOf(&'static str),
    /// The points of a path to this distance (µm).
    PointsTo(fn(&Case) -> f64),
    /// A comparison of its own, in the test of the crate that has the function; it is named.
    Test(&'static str),
}

/// The class of a refusal.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Refusal {
    /// A number is outside the bounds of its parameter.
    Bound,
    /// A layer is missing or is not one layer.
    Layer,
    /// A name or word is none of those that exist.
    Choice,
    /// Parameters or ports do not go together: what would be drawn is no valid shape.
    Geometry,
}

impl Difference {
    /// Whether it is about a function.
    #[must_use]
    pub fn is_about(&self, function: &str) -> bool {
        self.functions.contains(&function)
    }

    /// Whether it applies to a case.
    #[must_use]
    pub fn applies_to(&self, case: &Case) -> bool {
        let function = if case.device.is_empty() { &case.function } else { &case.device };
        let named = self.is_about(function) || (self.functions == ["*"] && !case.device.is_empty());
        named && (self.applies)(case)
    }
}
