//! Generators as users write them: forms, caching, circles, bounds, registry, sweeps.

mod bounds;
mod caching;
mod circles;
mod forms;
mod hygiene;
mod parallel;
mod recipes;
mod registered;
