//! Generators as users write them.

mod forms;
