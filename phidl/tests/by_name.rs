//! A program that names no shape and no route builds them by name: linking `phidl` is enough.

use phidl::registry;

#[test]
fn generators_are_linked_through_the_facade_alone() {
    let names: Vec<&str> = registry::all().map(|entry| entry.name).collect();
    for name in ["ring", "text", "boolean", "kl_offset", "route_quad", "delay_line"] {
        assert!(names.contains(&name), "{name} is not among {names:?}");
    }
}
