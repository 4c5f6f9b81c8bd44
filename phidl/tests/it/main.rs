//! The facade: the mental model in one screen, the examples, generators by name.

mod examples;
mod facade;
mod mental_model;
