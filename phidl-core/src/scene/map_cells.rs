//! Each distinct cell of a hierarchy once, to read it or to make a changed copy.

use std::collections::{BTreeMap, HashMap, HashSet};

use super::{Cell, Device, DeviceBuilder};
use crate::error::Result;
use crate::layer::Layer;
use crate::param::Value;

impl Device {
    /// Every distinct cell of the hierarchy once: this one first, and every cell before those that it places.
    #[must_use]
    pub fn cells(&self) -> Vec<Device> {
        let mut seen = HashSet::new();
        let mut finished = Vec::new();
        // Depth first, finishing children before parents; the reverse of that is the promised order. An explicit stack,
        // since a chain of cells can be deep.
        let mut stack = vec![(self, 0)];
        seen.insert(self.ptr_id());
        while let Some((device, next)) = stack.pop() {
            match device.references().get(next) {
                None => finished.push(device.clone()),
                Some(reference) => {
                    stack.push((device, next + 1));
                    if seen.insert(reference.device().ptr_id()) {
                        stack.push((reference.device(), 0));
                    }
                }
            }
        }
        finished.reverse();
        finished
    }

    /// The same hierarchy of changed copies. `change` is called once for each distinct cell, placed cells before those that
    /// place them. The originals do not change; a cell that is placed twice is one cell in the copy as well.
    ///
    /// ```
    /// # use phidl_core::prelude::*;
    /// # let mut d = Device::builder("dot");
    /// # d.add_polygon([(0, 0), (1, 0), (0, 1)], 1)?;
    /// # let dot = d.build()?;
    /// let mut d = Device::builder("pair");
    /// d.add(&dot);
    /// d.add(dot.place().moved_by((5, 0)));
    /// let reviewed = d.build()?.map_cells(|cell| Ok(drop(cell.info("reviewed", true))))?;
    /// assert!(reviewed.references()[0].device().same_cell(reviewed.references()[1].device()));
    /// assert!(dot.info().is_empty() && reviewed.references()[0].device().info().contains_key("reviewed"));
    /// # Ok::<(), phidl_core::Error>(())
    /// ```
    ///
    /// # Errors
    /// The error of `change`.
    pub fn map_cells(&self, mut change: impl FnMut(&mut DeviceBuilder) -> Result<()>) -> Result<Device> {
        let mut copies: HashMap<usize, Device> = HashMap::new();
        for device in self.cells().iter().rev() {
            let mut copy = device.edit();
            retarget(&mut copy.cell, &copies);
            change(&mut copy)?;
            copies.insert(device.ptr_id(), copy.build()?);
        }
        Ok(copies.remove(&self.ptr_id()).expect("invariant: the walk over the cells ends with this one"))
    }

    /// The info of every distinct cell of the hierarchy below this one, in the order of [`Device::cells`], each with
    /// its cell. The cell's own info is [`Device::info`].
    #[must_use]
    pub fn descendant_info(&self) -> Vec<(Device, BTreeMap<String, Value>)> {
        let below = self.cells().into_iter().skip(1);
        below.map(|cell| (cell.clone(), cell.info().clone())).collect()
    }

    /// The area of all polygons of the hierarchy by layer (µm²); where polygons overlap, both count.
    #[must_use]
    pub fn area_by_layer(&self) -> BTreeMap<Layer, f64> {
        let mut areas: HashMap<usize, BTreeMap<Layer, f64>> = HashMap::new();
        for cell in self.cells().iter().rev() {
            let mut area: BTreeMap<Layer, f64> = BTreeMap::new();
            for polygon in cell.polygons() {
                *area.entry(polygon.layer).or_default() += polygon.area();
            }
            for reference in cell.references() {
                let factor = reference.transform().magnification.powi(2) * reference.count() as f64;
                for (layer, below) in &areas[&reference.device().ptr_id()] {
                    *area.entry(*layer).or_default() += below * factor;
                }
            }
            areas.insert(cell.ptr_id(), area);
        }
        areas.remove(&self.ptr_id()).unwrap_or_default()
    }

    /// The area of all polygons of the hierarchy (µm²); where polygons overlap, both count.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.area_by_layer().values().sum()
    }
}

/// Changes a cell and all cells below it, each distinct one once, into copies; `change` says whether it changed anything.
/// A cell that neither changes nor places a changed cell stays the same object.
pub(super) fn rewrite_below(cell: &mut Cell, mut change: impl FnMut(&mut Cell) -> bool) {
    let roots: Vec<Device> = cell.references.iter().map(|reference| reference.device().clone()).collect();
    let mut changed: HashMap<usize, Device> = HashMap::new();
    for root in roots {
        if changed.contains_key(&root.ptr_id()) {
            continue;
        }
        for device in root.cells().iter().rev() {
            if changed.contains_key(&device.ptr_id()) {
                continue;
            }
            let mut copy = Cell { source: None, ..device.cell().clone() };
            let below = retarget(&mut copy, &changed);
            let own = change(&mut copy);
            let result = if below || own { Device::from_cell(copy) } else { device.clone() };
            changed.insert(device.ptr_id(), result);
        }
    }
    retarget(cell, &changed);
    change(cell);
}

/// Points references to the changed cells; says whether there were any.
fn retarget(cell: &mut Cell, changed: &HashMap<usize, Device>) -> bool {
    let mut any = false;
    for reference in &mut cell.references {
        let Some(device) = changed.get(&reference.device().ptr_id()) else { continue };
        if !device.same_cell(reference.device()) {
            reference.set_device(device.clone());
            any = true;
        }
    }
    any
}
