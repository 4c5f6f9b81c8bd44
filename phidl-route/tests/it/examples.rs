//! The examples run to their ends.

#[path = "../../examples/around_a_chip.rs"]
mod around_a_chip;
#[path = "../../examples/routing_tutorial.rs"]
mod routing_tutorial;

#[test]
fn examples_run() {
    around_a_chip::main().unwrap();
    routing_tutorial::main().unwrap();
}

#[test]
fn a_route_is_what_its_three_steps_by_hand_are() {
    let [by_hand, route] = routing_tutorial::by_hand().unwrap();
    assert_eq!(by_hand.hash_geometry(1e-4).unwrap(), route.hash_geometry(1e-4).unwrap());
}
