//! Generators as users write them: forms, caching, cycles, bounds, registry, sweeps.

mod bounds;
mod caching;
mod cycles;
mod forms;
mod hygiene;
mod parallel;
mod partials;
mod registered;
