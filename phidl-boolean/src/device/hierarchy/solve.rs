//! [`Solver`]: opens placements from the top down until what repeats stands alone.

use std::collections::{BTreeMap, HashMap};

use phidl_core::geom::Transform;
use phidl_core::layer::Layers;
use phidl_core::num::grid::Grid;
use phidl_core::scene::{Array, Device, DeviceBuilder};

use super::{
    cluster::{Cluster, clusters},
    context::{Context, Key, Placed},
    item::{Item, Pile},
    lattice::{Lattice, gathered},
    work::Work,
};
use crate::{device::Options, error::BooleanError, options::RunOptions, point::GridPoint, progress::Watch};

/// Ways of rounding that are told apart for the same placements: nine for the sides of zero, and some for noise.
const MOST_VARIANTS: usize = 16;

/// Does some work in one hierarchy, and remembers what it has done.
pub(super) struct Solver<'a> {
    pub(super) work: Work,
    pub(super) name: &'a str,
    pub(super) layers: &'a Layers,
    pub(super) grid: Grid,
    pub(super) options: &'a Options<'a>,
    contexts: Vec<Context>,
    /// What each context draws, from its anchor, once it is known.
    solved: Vec<Option<Device>>,
    known: HashMap<Key, Vec<usize>>,
}

/// Where the clusters of a context are.
#[derive(Default)]
struct Repeated {
    singles: Vec<GridPoint>,
    lattices: Vec<Lattice>,
}

impl<'a> Solver<'a> {
    pub(super) fn new(work: Work, name: &'a str, layers: &'a Layers, grid: Grid, options: &'a Options<'a>) -> Self {
        let (contexts, solved, known) = (Vec::new(), Vec::new(), HashMap::new());
        Self { work, name, layers, grid, options, contexts, solved, known }
    }

    /// Draws the result for items and outlines into a cell whose origin is at `anchor`.
    pub(super) fn draw(
        &mut self,
        cell: &mut DeviceBuilder,
        items: Vec<Item>,
        mut pile: Pile,
        anchor: GridPoint,
    ) -> Result<(), BooleanError> {
        let repeated = self.sort_out(items, &mut pile)?;
        let run: &RunOptions = &self.options.run;
        let region = self.work.region(&pile.seen_from(anchor), &self.grid, run)?;
        drop(pile);
        region.draw(cell, self.layers, self.options)?;
        for (context, Repeated { singles, lattices }) in repeated {
            let device = self.solve(context)?;
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

    /// The result in a context, worked out when first asked for.
    fn solve(&mut self, context: usize) -> Result<Device, BooleanError> {
        if let Some(device) = &self.solved[context] {
            return Ok(device.clone());
        }
        Watch::check(self.options.run.watch)?;
        let (mut items, mut pile) = (Vec::new(), Pile::default());
        let anchor = self.contexts[context].anchor;
        let closed = std::mem::take(&mut self.contexts[context].items);
        let name = format!("{}_{}", self.name, closed.first().map_or("nothing", |item| item.cell.name()));
        for item in closed {
            item.open(&self.grid, &mut items, &mut pile)?;
        }
        let mut cell = Device::builder(name);
        self.draw(&mut cell, items, pile, anchor)?;
        let device = cell.build()?;
        self.solved[context] = Some(device.clone());
        Ok(device)
    }

    /// Takes out what repeats, by context, and opens the rest until only outlines are left.
    fn sort_out(&mut self, mut items: Vec<Item>, pile: &mut Pile) -> Result<BTreeMap<usize, Repeated>, BooleanError> {
        let margin = self.work.margin(&self.grid);
        let mut repeated = BTreeMap::new();
        while !items.is_empty() {
            Watch::check(self.options.run.watch)?;
            let clusters = clusters(&items, pile, margin);
            let is_taken = self.take_repeated(&items, &clusters, margin, &mut repeated);
            let mut items_left: Vec<Option<Item>> = items.into_iter().map(Some).collect();
            items = Vec::new();
            for (cluster, is_taken) in clusters.iter().zip(is_taken) {
                let members = cluster.members.iter().filter_map(|&i| items_left[i].take());
                if !is_taken {
                    open_largest(members.collect(), &self.grid, &mut items, pile)?;
                }
            }
        }
        Ok(repeated)
    }

    /// Adds the clusters that occur more than once, and tells which those are.
    fn take_repeated(
        &mut self,
        items: &[Item],
        clusters: &[Cluster],
        margin: f64,
        repeated: &mut BTreeMap<usize, Repeated>,
    ) -> Vec<bool> {
        let mut is_taken = vec![false; clusters.len()];
        for (key, alike) in self.alike(items, clusters, margin) {
            let is_known = self.known.contains_key(&key);
            if !is_known && alike.iter().map(|(_, placed)| placed.count()).sum::<usize>() < 2 {
                continue;
            }
            for (cluster, placed) in alike {
                let (at, pitch) = (placed.anchor, placed.pitch);
                let members = || clusters[cluster].members.iter().map(|&i| &items[i]).collect::<Vec<_>>();
                let Some(context) = self.context(&key, members, placed) else { continue };
                is_taken[cluster] = true;
                let places = repeated.entry(context).or_default();
                match pitch {
                    None => places.singles.push(at),
                    Some(pitch) => places.lattices.push(Lattice {
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

    /// Clusters by key, in the order of their first occurrence; those that are blocked or cannot be placed left out.
    fn alike(&self, items: &[Item], clusters: &[Cluster], margin: f64) -> Vec<(Key, Vec<(usize, Placed)>)> {
        let mut places: HashMap<Key, usize> = HashMap::new();
        let mut alike: Vec<(Key, Vec<(usize, Placed)>)> = Vec::new();
        for (i, cluster) in clusters.iter().enumerate().filter(|(_, cluster)| !cluster.is_blocked) {
            let members: Vec<&Item> = cluster.members.iter().map(|&member| &items[member]).collect();
            let Some(placed) = Placed::new(&members, &self.grid, margin) else { continue };
            let key = placed.key(&members);
            let place = *places.entry(key.clone()).or_insert_with(|| {
                alike.push((key, Vec::new()));
                alike.len() - 1
            });
            alike[place].1.push((i, placed));
        }
        alike
    }

    /// The context of a cluster: a known one that holds it, or a new one that does.
    fn context<'i>(&mut self, key: &Key, items: impl Fn() -> Vec<&'i Item>, placed: Placed) -> Option<usize> {
        let known = self.known.entry(key.clone()).or_default();
        if let Some(&context) = known.iter().find(|&&context| self.contexts[context].holds(&placed)) {
            return Some(context);
        }
        if known.len() >= MOST_VARIANTS {
            return None;
        }
        known.push(self.contexts.len());
        self.contexts.push(Context::new(&items(), placed, &self.grid));
        self.solved.push(None);
        self.contexts.last().is_some_and(Context::holds_itself).then(|| self.contexts.len() - 1)
    }
}

/// Opens the items of a cluster that are not much smaller than its largest: what they hold may stand apart.
fn open_largest(members: Vec<Item>, grid: &Grid, items: &mut Vec<Item>, pile: &mut Pile) -> Result<(), BooleanError> {
    let largest = members.iter().map(|item| item.bounds.area()).fold(0.0, f64::max);
    for item in members {
        if item.bounds.area() * 2.0 >= largest {
            item.open(grid, items, pile)?;
        } else {
            items.push(item);
        }
    }
    Ok(())
}
