//! Shapes that connect others: pads, adapters and branches with ports.

mod compass;
mod compass_multi;
mod connector;
mod flagpole;
mod polygon_ports;
mod tee;

pub use compass::{CompassParams, compass};
pub use compass_multi::{CompassMultiParams, compass_multi};
pub use connector::{ConnectorParams, connector};
pub use flagpole::{FlagpoleParams, PoleShape, PoleTaper, flagpole};
pub use polygon_ports::{PolygonPortsParams, polygon_ports};
pub use tee::{TeeParams, tee};
