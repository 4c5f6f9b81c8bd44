//! [`gridsweep`]: one generator over a grid of its parameters.

use std::collections::BTreeMap;

use phidl_core::prelude::*;
use phidl_macros::device;

use super::grid::{GridParams, GridShape};
use super::sweep::{Combination, MOST_CELLS};
use super::{EdgeX, EdgeY, GridCells, Sweep};
use crate::arguments::PerAxis;
use crate::basic::CircleParams;

/// Draws a generator for every combination of two sets of parameters, in rows and columns.
///
/// ```text
///             param_x →
///           ┌──┐ ┌───┐ ┌────┐
///   param_y └──┘ └───┘ └────┘   the first value of y in the top row
///      ↓    ┌──┐ ┌───┐ ┌────┐
///           │  │ │   │ │    │
///           └──┘ └───┘ └────┘
/// ```
///
/// The generator is any `#[device]`: its parameter struct in Rust, its registered name in JSON. Its parameters are
/// those it was given with, then `param_defaults`, then the swept ones, then `param_override`; a later one wins. All
/// parameters of all cells are checked before the first cell is drawn.
///
/// # Labels
/// One centered label on every cell that draws something, `name=value` in a line for every swept parameter, those of y
/// first, with the values that are drawn; and one at the lower left corner with the parameters that all cells share.
///
/// # Ports
/// None.
///
/// # Errors
/// A parameter that the generator does not have or take, one that is swept in both directions, a sweep without
/// values, more than 100,000 cells.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// use pg::arrange::Sweep;
/// let circles = pg::GridsweepParams::new(pg::CircleParams::default())
///     .param_x(Sweep::over("radius", [10, 20, 30, 40, 50]))
///     .param_y(Sweep::over("layer", [0, 5, 9]))
///     .spacing((30, 10))
///     .build()?;
/// assert_eq!(circles.references().len(), 15);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `gridsweep`. The labels differ: they stand in the grid, so that a cell that is
/// drawn twice has two, show overridden values as they are drawn, and are left out where they would be empty.
#[device(picture = "docs/gridsweep.svg", example = GridsweepParams::new(CircleParams::default())
    .param_x([("radius", [10, 20, 30])]).param_y([("layer", [1, 2])]).spacing((60, 20)))]
pub fn gridsweep(
    /// The generator, with the parameters that are not swept.
    function: Partial,
    /// What changes from left to right.
    #[default([("width", [1, 5, 6, 7])])]
    param_x: Sweep,
    /// What changes from top to bottom.
    #[default(Sweep::over("length", [Value::from(1.1), 2.into(), 70.into()]))]
    param_y: Sweep,
    /// Parameters for all cells, unless they are swept.
    #[default([])]
    param_defaults: BTreeMap<String, Value>,
    /// Parameters for all cells, even if they are swept.
    #[default([])]
    param_override: BTreeMap<String, Value>,
    /// Between columns and between rows: the gap, or without `separation` the pitch.
    #[default((50, 100))]
    #[param(unit = "um")]
    spacing: PerAxis,
    /// Whether `spacing` is the gap between bounding boxes; otherwise it is the pitch of `edge_x` and `edge_y`.
    #[default(true)]
    separation: bool,
    /// What the cells of a column have in common.
    #[default(EdgeX::X)]
    align_x: EdgeX,
    /// What the cells of a row have in common.
    #[default(EdgeY::Y)]
    align_y: EdgeY,
    /// Without `separation`: what the pitch of the columns is measured at.
    #[default(EdgeX::X)]
    edge_x: EdgeX,
    /// Without `separation`: what the pitch of the rows is measured at.
    #[default(EdgeY::YMin)]
    edge_y: EdgeY,
    /// Where the labels stand; none writes no labels.
    #[default(255)]
    label_layer: Option<Layer>,
) -> Result<Device> {
    let (columns, rows) = (param_x.combinations(check, "param_x")?, param_y.combinations(check, "param_y")?);
    let both = param_x.names().find(|name| param_y.names().any(|other| other == *name));
    let swept = format!("a sweep of {:?}", both.unwrap_or_default());
    check.that("param_x", swept, both.is_none(), "not sweep a parameter of param_y")?;
    check.at_most("number of cells", columns.len().saturating_mul(rows.len()), MOST_CELLS)?;

    let sweep = SweepPlan { function: &function, defaults: &param_defaults, fixed: &param_override };
    let combinations = rows.iter().flat_map(|y| columns.iter().map(move |x| [y.as_slice(), x.as_slice()].concat()));
    let combinations: Vec<Combination> = combinations.collect();
    let cells = sweep.draw(&combinations)?;
    let shape = GridShape { columns: as_i64(columns.len()), rows: as_i64(rows.len()) };
    let list: GridCells = cells.into_iter().collect();
    let grid =
        GridParams { spacing, separation, align_x, align_y, edge_x, edge_y, ..GridParams::new(list).shape(shape) };
    let grid = grid.build()?;

    let mut d = grid.edit();
    if let Some(layer) = label_layer {
        add_labels(&mut d, &sweep, &combinations, layer)?;
    }
    d.build()
}

/// A generator and the parameters that do not change.
struct SweepPlan<'a> {
    function: &'a Partial,
    defaults: &'a BTreeMap<String, Value>,
    fixed: &'a BTreeMap<String, Value>,
}

impl SweepPlan<'_> {
    /// All cells; nothing is drawn before the parameters of all were checked.
    fn draw(&self, combinations: &[Combination]) -> Result<Vec<Device>> {
        let common = self.function.with(self.defaults.clone())?;
        let recipe = |swept: &Combination| {
            let recipe = common.with(swept.iter().cloned())?.with(self.fixed.clone())?;
            recipe.record()?;
            Ok(recipe)
        };
        let recipes: Vec<Partial> = combinations.iter().map(recipe).collect::<Result<_>>()?;
        recipes.iter().map(Partial::build).collect()
    }

    /// What a cell of the sweep is labelled with.
    fn label(&self, swept: &Combination) -> String {
        let line = |(name, value): &(String, Value)| format!("{name}={}", shown(self.fixed.get(name).unwrap_or(value)));
        swept.iter().map(line).collect::<Vec<_>>().join("\n")
    }

    /// What all cells have in common.
    fn common_label(&self) -> String {
        let mut common = self.defaults.clone();
        common.extend(self.fixed.clone());
        let pairs: Vec<String> = common.iter().map(|(name, value)| format!("'{name}': {}", quoted(value))).collect();
        format!("{{{}}}", pairs.join(", "))
    }
}

fn add_labels(d: &mut DeviceBuilder, sweep: &SweepPlan<'_>, combinations: &[Combination], layer: Layer) -> Result<()> {
    let centers: Vec<Option<Point>> = d.references().map(|cell| cell.bbox().map(|bbox| bbox.center())).collect();
    for (center, swept) in centers.into_iter().zip(combinations) {
        if let (Some(center), false) = (center, swept.is_empty()) {
            d.add_label(sweep.label(swept), center, layer)?;
        }
    }
    if let Some(bbox) = d.bbox() {
        d.add_label(sweep.common_label(), bbox.min, layer)?;
    }
    Ok(())
}

/// A value as a label shows it: text bare, a float as one even if it is whole.
fn shown(value: &Value) -> String {
    match value {
        Value::Text(text) => text.clone(),
        other => quoted(other),
    }
}

fn quoted(value: &Value) -> String {
    match value {
        Value::Text(text) => format!("'{text}'"),
        Value::Float(v) => format!("{v:?}"),
        other => other.to_string(),
    }
}

/// A number of cells, which is far below the limit of either type.
fn as_i64(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}
