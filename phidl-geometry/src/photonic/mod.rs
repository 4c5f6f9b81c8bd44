//! Shapes of photonics.
