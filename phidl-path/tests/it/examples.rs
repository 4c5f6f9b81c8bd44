//! The examples run, and the chapters of the tutorial match the reference.

#[path = "../../examples/bends.rs"]
mod bends;
#[path = "../../examples/waveguide_tutorial.rs"]
mod waveguide_tutorial;

#[test]
fn examples_run() {
    waveguide_tutorial::main().unwrap();
    bends::main().unwrap();
}

#[test]
fn the_path_of_the_tutorial_is_that_of_the_reference() {
    // Points, length and hash of the reference.
    let path = waveguide_tutorial::pieces().unwrap();
    assert_eq!(path.points().len(), 1112);
    assert!((path.length() - 107.699_010_586).abs() < 1e-8);
    assert_eq!(path.hash_geometry(1e-4).unwrap(), "146415d058fa5ae8fc178476ed2cf20aac00c699");
}
