//! Welding: joints that do not gap, hierarchy kept.
//!
//! A file rounds twice, the corners inside a cell and the origin of the cell, and only then does the reader turn the sum.
//! So corners of two cells that are one point in the design are two points of the grid at most odd angles. Welding gives
//! each such point one grid point. A cell in an open joint is written as a *form* of its own, in coordinates that are
//! placed already, and everything else stays a reference.
//!
//! ```
//! # use phidl_core::prelude::*;
//! use phidl_core::num::grid::Grid;
//! use phidl_io::weld::{self, WeldOptions};
//! let mut d = Device::builder("strip");
//! d.add_polygon([(0.0, -0.25), (1.0, -0.25), (1.0, 0.25), (0.0, 0.25)], 1)?;
//! d.add_port("1", ((0, 0), 0.5, 180))?;
//! d.add_port("2", ((1, 0), 0.5, 0))?;
//! let strip = d.build()?;
//! let mut chain = Device::builder("chain");
//! let first = strip.place().rotated(10);
//! let mut second = strip.place();
//! second.connect("1", &first.port("2")?)?;
//! chain.add(first);
//! chain.add(second);
//! let report = weld::inspect(&chain.build()?, &Grid::new(1e-3)?, &WeldOptions::default())?;
//! assert_eq!(report.to_string(), "1 joint: 0 closed, 1 welded (2 forms of 1 cell); corners up to 0.50 steps from their true positions");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How it works
//! | stage | what it does | module |
//! |---|---|---|
//! | ports | the free ports of each cell, children first; arrays as lattices | `ports` |
//! | joints | sites where ports meet, faces across their normals, contacts, seam points | `joints`, `faces`, `sites` |
//! | plan | top down: anchors, and the placements below them that are written in place | `plan` |
//! | classes | one grid point for each position | `classes` |
//! | forms | cells in coordinates on the grid, shared by what they draw | `write`, `polygon` |
//!
//! The result is a hierarchy of ordinary cells whose coordinates lie on the grid already, so every format can write it and
//! rounding it once more changes nothing. Layouts whose joints are all exact come back as they are.
//!
//! # Rejected
//! A finer grid only shrinks the gap, and mask houses fix it. Overlaps change doses. Snapping ports moves designs.
//! Flattening loses names and size. Rounding seam corners alone would leave the bodies off by a step, so that the gap between
//! two coupled guides varies by two. Rounding parent by parent adds up with depth.
//!
//! # Limits
//! Abutments without any port outside turned cells are not looked for. Joints between different files are not known. A
//! rigid cell is never varied: where two of them disagree, the joint stays open and is listed.

mod cells;
mod classes;
mod corner;
mod faces;
mod joints;
mod linear;
mod options;
mod plan;
mod polygon;
mod ports;
mod report;
mod sites;
mod write;

use std::collections::{BTreeMap, BTreeSet};

use phidl_core::num::grid::Grid;
use phidl_core::scene::Device;

use self::cells::Cells;
use self::faces::FaceSearch;
use self::joints::{Found, Joint, JointSearch, Side, State};
use self::linear::Linear;
use self::plan::{AnchorKey, Layout, Plan, Rest};
use self::ports::Owner;
use self::write::FormWriter;
use crate::error::{IoError, Result};

pub use options::{Beneath, Joints, Listing, WeldOptions};
pub use report::{FormReport, JointReport, WeldReport, WeldStatus};

/// Cell names of GDSII files end here by default.
const NAME_LIMIT: usize = 32;

/// Finds the joints of a device and says what writing it would do, without a file.
///
/// # Errors
/// [`IoError::Option`] for an option that breaks its rule, and as for writing with `strict`.
pub fn inspect(device: &Device, grid: &Grid, options: &WeldOptions) -> Result<WeldReport> {
    Ok(weld(device, grid, options, NAME_LIMIT)?.1)
}

/// The device as a file should hold it, with what was done. Names of forms have at most `name_limit` bytes.
pub(crate) fn weld(
    top: &Device,
    grid: &Grid,
    options: &WeldOptions,
    name_limit: usize,
) -> Result<(Device, WeldReport)> {
    let reach = options.reach(grid)?;
    if options.joints == Joints::Ignore {
        return Ok((top.clone(), WeldReport::default()));
    }
    let cells = Cells::of(top, options);
    let found = find(&cells, grid, reach, options)?;
    if found.iter().all(|found| found.joints.is_empty() && found.near_misses.is_empty()) {
        return Ok((top.clone(), WeldReport::default()));
    }
    let has_joints = below(&cells, |cell, _| found[cell].joints.iter().any(|joint| !joint.seams.is_empty()));
    let is_open = open_cells(&cells, &found, &has_joints, options);
    let layout =
        Layout { cells: &cells, found: &found, has_joints: &has_joints, is_open: &is_open, grid, reach, options };
    let plans = plan_all(&layout)?;
    let mut writer = FormWriter::new(&layout, name_limit);
    for (key, plan) in &plans {
        writer.write(*key, plan)?;
    }
    let top_key = top_key(&cells);
    let welded = writer.anchors.get(&top_key).cloned().unwrap_or_else(|| top.clone());
    let report = summarize(&layout, &plans, &writer, options)?;
    Ok((if options.joints == Joints::Report { top.clone() } else { welded }, report))
}

fn top_key(cells: &Cells) -> AnchorKey {
    (cells.list.len() - 1, 0.0_f64.to_bits(), 1.0_f64.to_bits())
}

/// Joints and free ports of every cell, children first.
fn find(cells: &Cells, grid: &Grid, reach: f64, options: &WeldOptions) -> Result<Vec<Found>> {
    let mut found: Vec<Found> = Vec::with_capacity(cells.list.len());
    for cell in &cells.list {
        let search = JointSearch {
            faces: FaceSearch { cells, grid, reach },
            cell,
            bare: options.bare,
            most_elements: options.most_forms,
        };
        let next = search.run(|reference| &found[cells.number(reference.device())].free)?;
        found.push(next);
    }
    Ok(found)
}

/// For every cell, whether something holds of it or of a cell below it. The question is asked with the answers for the
/// cells that it places.
fn below(cells: &Cells, holds: impl Fn(usize, &[bool]) -> bool) -> Vec<bool> {
    let mut answers: Vec<bool> = Vec::with_capacity(cells.list.len());
    for (number, cell) in cells.list.iter().enumerate() {
        let own = !cell.rigid && holds(number, &answers);
        let placed = || cell.device.references().iter().any(|reference| answers[cells.number(reference.device())]);
        answers.push(own || (!cell.rigid && placed()));
    }
    answers
}

/// Whether a cell that stands upright has an open joint in it or below it.
fn open_cells(cells: &Cells, found: &[Found], has_joints: &[bool], options: &WeldOptions) -> Vec<bool> {
    let mut open: Vec<bool> = Vec::with_capacity(cells.list.len());
    for (number, cell) in cells.list.iter().enumerate() {
        let own = found[number].joints.iter().any(|joint| joint.state == State::Open);
        let placed = cell.device.references().iter().any(|reference| {
            let child = cells.number(reference.device());
            let exact = Linear::of(reference.transform()).is_exact() || options.beneath == Beneath::Trust;
            if exact { open[child] } else { has_joints[child] }
        });
        open.push(!cell.rigid && (own || placed));
    }
    open
}

/// The plans of the top cell and of all anchors below it: inner cells first.
fn plan_all(layout: &Layout<'_>) -> Result<BTreeMap<AnchorKey, Plan>> {
    let mut plans = BTreeMap::new();
    let mut waiting = BTreeSet::from([top_key(layout.cells)]);
    while let Some(key) = waiting.pop_last() {
        let plan = layout.plan(key)?;
        for node in &plan.nodes {
            for (number, reference) in layout.cells.list[node.cell].device.references().iter().enumerate() {
                if node.exposed.range((number, (0, 0))..=(number, (u32::MAX, u32::MAX))).count() == reference.count() {
                    continue;
                }
                if let Rest::Anchor { key, .. } = layout.rest(&node.placement, reference)
                    && !plans.contains_key(&key)
                {
                    waiting.insert(key);
                }
            }
        }
        plans.insert(key, plan);
        if plans.len() > layout.options.most_forms {
            let rule = "be enough for all turned circuits of the layout";
            return Err(IoError::option("weld.most_forms", layout.options.most_forms, rule));
        }
    }
    Ok(plans)
}

fn summarize(
    layout: &Layout<'_>,
    plans: &BTreeMap<AnchorKey, Plan>,
    writer: &FormWriter<'_>,
    options: &WeldOptions,
) -> Result<WeldReport> {
    let instances = instances(layout.cells);
    let mut in_place: BTreeMap<usize, bool> = BTreeMap::new();
    let mut unweldable = BTreeSet::new();
    for plan in plans.values() {
        for (number, node) in plan.nodes.iter().enumerate() {
            *in_place.entry(node.cell).or_default() |= !node.placement.is_exact();
            let disagreeing = plan.classes.unweldable.iter().filter(|_| number == 0);
            unweldable.extend(disagreeing.map(|at| (at.x.to_bits(), at.y.to_bits())));
        }
    }
    let mut report = WeldReport {
        forms: writer.forms.clone(),
        arrays_split: writer.counts.arrays_split,
        inserted_vertices: writer.counts.inserted_vertices,
        squeezed_outlines: writer.counts.squeezed,
        largest_move_steps: plans.values().map(|plan| plan.classes.largest_move).fold(0.0, f64::max),
        ..WeldReport::default()
    };
    for (cell, found) in layout.found.iter().enumerate() {
        let device = &layout.cells.list[cell].device;
        for joint in &found.joints {
            let turned = in_place.get(&cell).copied().unwrap_or(false);
            let disagree =
                joint.seams.iter().any(|seam| unweldable.contains(&(seam.at.x.to_bits(), seam.at.y.to_bits())));
            let status = status(joint, turned, disagree, options);
            report.joints += joint.times;
            report.closed += if status == WeldStatus::Closed { joint.times } else { 0 };
            report.welded += if status == WeldStatus::Welded { joint.times } else { 0 };
            report.largest_gap_steps = report.largest_gap_steps.max(joint.gap);
            let listed = match options.list {
                Listing::All => true,
                Listing::Open => status != WeldStatus::Closed,
                Listing::Problems => status.is_problem(),
            };
            let line = || JointReport {
                cell: device.name().to_owned(),
                position: joint.midpoint,
                instances: instances[cell].saturating_mul(joint.times),
                sides: joint.sides.map(|side| side_name(layout, cell, side)),
                status,
                gap_steps: joint.gap,
            };
            if options.strict && status.is_problem() {
                return Err(unwelded(&line()));
            }
            if listed {
                report.listed.push(line());
            }
        }
        report.near_misses.extend(&found.near_misses);
    }
    Ok(report)
}

fn status(joint: &Joint, turned: bool, disagree: bool, options: &WeldOptions) -> WeldStatus {
    match joint.state {
        _ if disagree => WeldStatus::Unweldable,
        State::Askew => WeldStatus::Askew,
        State::OneSided => WeldStatus::OneSided,
        State::Point => WeldStatus::Point,
        State::Closed if !turned => WeldStatus::Closed,
        State::Closed | State::Open if options.joints == Joints::Report => WeldStatus::Open,
        State::Closed | State::Open => WeldStatus::Welded,
    }
}

fn unwelded(joint: &JointReport) -> IoError {
    let [one, other] = &joint.sides;
    IoError::Unwelded {
        cell: joint.cell.as_str().into(),
        sides: [one.as_str().into(), other.as_str().into()],
        status: joint.status.to_string().into(),
        position: joint.position.to_string().into(),
    }
}

/// How often each cell is placed below the top cell, arrays counted by their elements.
fn instances(cells: &Cells) -> Vec<u64> {
    let mut counts = vec![0_u64; cells.list.len()];
    if let Some(top) = counts.last_mut() {
        *top = 1;
    }
    for (number, cell) in cells.list.iter().enumerate().rev() {
        for reference in cell.device.references() {
            let child = cells.number(reference.device());
            let placed = counts[number].saturating_mul(reference.count() as u64);
            counts[child] = counts[child].saturating_add(placed);
        }
    }
    counts
}

/// A side for people: the alias of the reference or its cell and number, then the port.
fn side_name(layout: &Layout<'_>, cell: usize, side: Side) -> String {
    let mut device = &layout.cells.list[cell].device;
    let mut owner = side.owner;
    let mut element = side.element;
    let mut path = Vec::new();
    loop {
        match owner {
            None => return "a polygon".to_owned(),
            Some(Owner::Own(port)) => {
                path.push(device.ports().nth(port).map_or_else(String::new, |port| port.name().to_owned()));
                return path.join(".");
            }
            Some(Owner::Reference { reference, free }) => {
                let placed = &device.references()[reference];
                let alias = device.aliases().find(|(_, aliased)| std::ptr::eq(*aliased, placed));
                let name =
                    alias.map_or_else(|| format!("{}#{reference}", placed.device().name()), |(a, _)| a.to_owned());
                let at = placed.array().map_or_else(String::new, |_| format!("[{},{}]", element.0, element.1));
                path.push(name + &at);
                let child = layout.cells.number(placed.device());
                device = &layout.cells.list[child].device;
                element = (0, 0);
                owner = layout.found[child].free.get(free).map(|port| port.owner);
            }
        }
    }
}
