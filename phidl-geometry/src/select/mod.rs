//! Parts and copies of cells: by layer, without hierarchy, with ports drawn, and a sample of every layer.

mod copy;
mod extract;
mod ports;
mod preview;

pub use copy::{CopyParams, DeepcopyParams, FlattenParams, copy, deepcopy, flatten};
pub use extract::{CopyLayerParams, ExtractParams, copy_layer, extract};
pub use ports::{GeometryToPortsParams, PortsToGeometryParams, geometry_to_ports, ports_to_geometry};
pub use preview::{PreviewLayersetParams, SampleLayers, preview_layerset};
