//! Manhattan routes: waypoints, the choice of waypoints, and the wires.

mod bend;
mod corners;
mod crossing;
mod detour;
mod footprint;
mod loops;
mod route;
mod router;
mod waypoints;

pub use bend::RouteBend;
pub(crate) use bend::recorded;
pub(crate) use corners::{l, straight, v, z};
pub use corners::{path_l, path_straight, path_v, path_z};
pub(crate) use loops::{c, j, u};
pub use loops::{path_c, path_j, path_u};
pub(crate) use route::ManhattanWire;
pub use route::{
    RouteManhattanAutoParams, RouteManhattanParams, manhattan_centerline, route_manhattan, route_manhattan_auto,
};
pub(crate) use router::{Allowed, Detour, RoutedPath};
pub(crate) use waypoints::manhattan;
pub use waypoints::path_manhattan;
