//! Ways at right angles: the way points, their chooser, and the routes.

mod auto;
mod bend;
mod clear;
mod corners;
mod cover;
mod crossing;
mod detour;
mod loops;
mod route;

pub(crate) use auto::manhattan;
pub use auto::path_manhattan;
pub use bend::RouteBend;
pub(crate) use bend::recorded;
pub(crate) use clear::{Led, Site};
pub(crate) use corners::{l, straight, v, z};
pub use corners::{path_l, path_straight, path_v, path_z};
pub(crate) use loops::{c, j, u};
pub use loops::{path_c, path_j, path_u};
pub(crate) use route::bent;
pub use route::{
    RouteManhattanAutoParams, RouteManhattanParams, manhattan_centerline, route_manhattan, route_manhattan_auto,
};
