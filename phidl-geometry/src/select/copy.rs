//! [`copy`], [`deepcopy`] and [`flatten`].
//!
//! A finished cell never changes, so copies are never needed for safety: a clone of a `Device` is the same cell, and
//! `device.edit()` opens a copy for changes. These generators serve scripts that copy by name. `copy` and `deepcopy` are not
//! cached: each call makes a new cell. A file merges equal drawings unless the writer is told to keep all cells.

use phidl_core::prelude::*;
use phidl_macros::device;

use crate::basic::CrossParams;
use crate::connect::TeeParams;

/// Makes a new cell with the same content: polygons, labels, ports, aliases, info and properties, and references to the
/// same cells.
///
/// # Ports
/// Those of the original.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::compass((4, 2), 1)?;
/// let twin = pg::copy(&pad)?;
/// assert!(!twin.same_cell(&pad) && twin.references()[0].device().same_cell(pad.references()[0].device()));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `copy`, which loses arrays, properties and parts of labels.
#[device(no_cache, picture = "docs/copy.svg", example = CopyParams::new(TeeParams::default().build()?))]
pub fn copy(
    /// The original.
    #[param(name = "D")]
    device: Device,
) -> Result<Device> {
    device.edit().build()
}

/// Makes a new hierarchy with the same content: as [`copy`](fn@copy), with copies of all cells below. A cell that is
/// placed several times is copied once. The copies do not record the generators that drew the originals.
///
/// # Ports
/// Those of the original.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::compass((4, 2), 1)?;
/// let twin = pg::deepcopy(&pad)?;
/// assert!(!twin.references()[0].device().same_cell(pad.references()[0].device()));
/// assert_eq!(twin.hash_geometry(1e-4)?, pad.hash_geometry(1e-4)?);
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `deepcopy`.
#[device(no_cache, picture = "docs/deepcopy.svg", example = DeepcopyParams::new(TeeParams::default().build()?))]
pub fn deepcopy(
    /// The original.
    #[param(name = "D")]
    device: Device,
) -> Result<Device> {
    device.map_cells(|_| Ok(()))
}

/// Draws the whole hierarchy in one cell without references; name, ports and info stay. Aliases go with the references
/// that they name.
///
/// # Ports
/// Those of the original.
///
/// # Examples
/// ```
/// # use phidl_core::prelude::*;
/// # use phidl_geometry as pg;
/// let pad = pg::compass((4, 2), 1)?;
/// let flat = pg::flatten(&pad, (9, 8))?;
/// assert_eq!((flat.references().len(), flat.layers()), (0, vec![Layer::new(9, 8)]));
/// # Ok::<(), Error>(())
/// ```
///
/// # Source
/// Own design, compatible with PHIDL's `flatten`, which loses arrays and does not look at `single_layer`.
#[device(picture = "docs/flatten.svg", example = FlattenParams::new(CrossParams::default().build()?))]
pub fn flatten(
    /// The original.
    #[param(name = "D")]
    device: Device,
    /// The layer for all polygons and labels; none leaves them where they are.
    #[default(None)]
    single_layer: Option<Layer>,
) -> Result<Device> {
    let mut d = device.edit();
    match single_layer {
        Some(layer) => d.flatten_onto(layer)?,
        None => d.flatten()?,
    };
    d.build()
}
