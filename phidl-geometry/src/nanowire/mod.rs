//! Shapes of superconducting electronics.
