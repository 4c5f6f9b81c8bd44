//! [`Solver`]: opens placements from the top down until the repeated clusters are isolated.

use std::collections::{BTreeMap, HashMap};

use phidl_core::geom::Transform;
use phidl_core::layer::Layers;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Array, Device, DeviceBuilder};

use super::{
    cluster::{InteractionCluster, clusters},
    congruence::{CongruenceClass, Key, Placed},
    lattice::{Lattice, gathered},
    placement::{FlatGeometry, Placement},
};
use crate::{
    device::{operation::DeviceOperation, options::Options},
    error::BooleanError,
    options::RunOptions,
    point::GridPoint,
    progress::ProgressMonitor,
};

/// Most congruence classes with one key: nine for the sides of zero, and some for noise.
const MOST_VARIANTS: usize = 16;

/// Runs an operation on one hierarchy, each congruence class once.
pub(super) struct Solver<'a> {
    pub(super) operation: DeviceOperation,
    pub(super) name: &'a str,
    pub(super) layers: &'a Layers,
    pub(super) grid: Grid,
    pub(super) options: &'a Options<'a>,
    classes: Vec<CongruenceClass>,
    /// The result of each class relative to its anchor, once it is known.
    solved: Vec<Option<Device>>,
    known: HashMap<Key, Vec<usize>>,
}

/// The positions of the clusters of a class.
#[derive(Default)]
struct Repeated {
    singles: Vec<GridPoint>,
    lattices: Vec<Lattice>,
}

impl<'a> Solver<'a> {
    pub(super) fn new(
        operation: DeviceOperation,
        name: &'a str,
        layers: &'a Layers,
        grid: Grid,
        options: &'a Options<'a>,
    ) -> Self {
        let (classes, solved, known) = (Vec::new(), Vec::new(), HashMap::new());
        Self { operation, name, layers, grid, options, classes, solved, known }
    }

    /// Draws the result for placements and outlines into a cell whose origin is at `anchor`.
    pub(super) fn draw(
        &mut self,
        cell: &mut DeviceBuilder,
        placements: Vec<Placement>,
        mut flat: FlatGeometry,
        anchor: GridPoint,
    ) -> Result<(), BooleanError> {
        let repeated = self.take_all_repeated(placements, &mut flat)?;
        let run: &RunOptions = &self.options.run;
        let region = self.operation.region(&flat.relative_to(anchor), &self.grid, run)?;
        drop(flat);
        region.draw(cell, self.layers, self.options)?;
        for (class, Repeated { singles, lattices }) in repeated {
            let device = self.solve(class)?;
            if !device.is_empty() {
                for lattice in lattices.into_iter().chain(gathered(singles)) {
                    self.place(cell, &device, lattice, anchor);
                }
            }
        }
        Ok(())
    }

    fn place(&self, cell: &mut DeviceBuilder, device: &Device, lattice: Lattice, anchor: GridPoint) {
        let um = |p: GridPoint| (self.grid.um(p.x), self.grid.um(p.y));
        let at = GridPoint::new(lattice.at.x - anchor.x, lattice.at.y - anchor.y);
        let reference = device.place().with_transform(Transform::translation(um(at)));
        cell.add(if lattice.is_single() {
            reference
        } else {
            reference.with_array(Array {
                columns: lattice.columns,
                rows: lattice.rows,
                column_step: um(lattice.column_step).into(),
                row_step: um(lattice.row_step).into(),
            })
        });
    }

    /// The result of a class, computed on first use.
    fn solve(&mut self, class: usize) -> Result<Device, BooleanError> {
        if let Some(device) = &self.solved[class] {
            return Ok(device.clone());
        }
        ProgressMonitor::check(self.options.run.monitor)?;
        let (mut placements, mut flat) = (Vec::new(), FlatGeometry::default());
        let anchor = self.classes[class].anchor;
        let closed = std::mem::take(&mut self.classes[class].placements);
        let name = format!("{}_{}", self.name, closed.first().map_or("nothing", |placement| placement.cell.name()));
        for placement in closed {
            placement.open(&self.grid, &mut placements, &mut flat)?;
        }
        let mut cell = Device::builder(name);
        self.draw(&mut cell, placements, flat, anchor)?;
        let device = cell.build()?;
        self.solved[class] = Some(device.clone());
        Ok(device)
    }

    /// Takes out repeated clusters, by class, and opens the others until only outlines are left.
    fn take_all_repeated(
        &mut self,
        mut placements: Vec<Placement>,
        flat: &mut FlatGeometry,
    ) -> Result<BTreeMap<usize, Repeated>, BooleanError> {
        let distance = self.operation.interaction_distance(&self.grid);
        let mut repeated = BTreeMap::new();
        while !placements.is_empty() {
            ProgressMonitor::check(self.options.run.monitor)?;
            let clusters = clusters(&placements, flat, distance);
            let is_taken = self.take_repeated(&placements, &clusters, distance, &mut repeated);
            let mut items_left: Vec<Option<Placement>> = placements.into_iter().map(Some).collect();
            placements = Vec::new();
            for (cluster, is_taken) in clusters.iter().zip(is_taken) {
                let members = cluster.members.iter().filter_map(|&i| items_left[i].take());
                if !is_taken {
                    open_largest(members.collect(), &self.grid, &mut placements, flat)?;
                }
            }
        }
        Ok(repeated)
    }

    /// Adds the clusters that occur more than once, and returns which those are.
    fn take_repeated(
        &mut self,
        placements: &[Placement],
        clusters: &[InteractionCluster],
        distance: f64,
        repeated: &mut BTreeMap<usize, Repeated>,
    ) -> Vec<bool> {
        let mut is_taken = vec![false; clusters.len()];
        for (key, alike) in self.alike(placements, clusters, distance) {
            let is_known = self.known.contains_key(&key);
            if !is_known && alike.iter().map(|(_, placed)| placed.count()).sum::<usize>() < 2 {
                continue;
            }
            for (cluster, placed) in alike {
                let (at, pitch) = (placed.anchor, placed.pitch);
                let members = || clusters[cluster].members.iter().map(|&i| &placements[i]).collect::<Vec<_>>();
                let Some(class) = self.class(&key, members, placed) else { continue };
                is_taken[cluster] = true;
                let positions = repeated.entry(class).or_default();
                match pitch {
                    None => positions.singles.push(at),
                    Some(pitch) => positions.lattices.push(Lattice {
                        at,
                        columns: pitch.count[0],
                        rows: pitch.count[1],
                        column_step: pitch.steps[0],
                        row_step: pitch.steps[1],
                    }),
                }
            }
        }
        is_taken
    }

    /// Clusters by key, in the order of their first occurrence; without those near flat geometry and those that cannot be referenced.
    fn alike(
        &self,
        placements: &[Placement],
        clusters: &[InteractionCluster],
        distance: f64,
    ) -> Vec<(Key, Vec<(usize, Placed)>)> {
        let mut indices: HashMap<Key, usize> = HashMap::new();
        let mut alike: Vec<(Key, Vec<(usize, Placed)>)> = Vec::new();
        for (i, cluster) in clusters.iter().enumerate().filter(|(_, cluster)| !cluster.is_blocked) {
            let members: Vec<&Placement> = cluster.members.iter().map(|&member| &placements[member]).collect();
            let Some(placed) = Placed::new(&members, &self.grid, distance) else { continue };
            let key = placed.key(&members);
            let index = *indices.entry(key.clone()).or_insert_with(|| {
                alike.push((key, Vec::new()));
                alike.len() - 1
            });
            alike[index].1.push((i, placed));
        }
        alike
    }

    /// The class of a cluster: a known one that contains it, or a new one.
    fn class<'i>(&mut self, key: &Key, placements: impl Fn() -> Vec<&'i Placement>, placed: Placed) -> Option<usize> {
        let known = self.known.entry(key.clone()).or_default();
        if let Some(&class) = known.iter().find(|&&class| self.classes[class].contains(&placed)) {
            return Some(class);
        }
        if known.len() >= MOST_VARIANTS {
            return None;
        }
        known.push(self.classes.len());
        self.classes.push(CongruenceClass::new(&placements(), placed, &self.grid));
        self.solved.push(None);
        self.classes.last().is_some_and(CongruenceClass::contains_itself).then(|| self.classes.len() - 1)
    }
}

/// Opens the placements of a cluster that are not much smaller than its largest, since their content may be separate.
fn open_largest(
    members: Vec<Placement>,
    grid: &Grid,
    placements: &mut Vec<Placement>,
    flat: &mut FlatGeometry,
) -> Result<(), BooleanError> {
    let largest = members.iter().map(|placement| placement.bounds.area()).fold(0.0, f64::max);
    for placement in members {
        if placement.bounds.area() * 2.0 >= largest {
            placement.open(grid, placements, flat)?;
        } else {
            placements.push(placement);
        }
    }
    Ok(())
}
