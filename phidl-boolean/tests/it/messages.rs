//! Every error sentence of the crate, by kind of use. A human reads this list; each line must be a true sentence.

use expect_test::expect;
use phidl_boolean::{
    BooleanError, Hierarchy, Join, OffsetOptions, Operation, Options, ProgressMonitor, Region, RunOptions, StripCount,
    boolean,
    grid::{self, Contours, GridPoint, MAX_COORDINATE},
    invert,
    klayout::{KLayoutOptions, kl_invert, kl_offset},
    offset, union,
};
use phidl_core::prelude::*;

fn refused<T: std::fmt::Debug>(result: std::result::Result<T, BooleanError>) -> String {
    Error::from(result.unwrap_err()).report()
}

fn square() -> Rect {
    Rect::new((0, 0), (10, 10))
}

fn far_cell() -> Device {
    let mut d = Device::builder("far");
    d.add_polygon([(0.0, 0.0), (1e9, 0.0), (0.0, 1.0)], 1).unwrap();
    d.build().unwrap()
}

fn with_join(join: Join) -> String {
    refused(offset(&square(), 1, &OffsetOptions { join, ..OffsetOptions::default() }, 1, &Options::default()))
}

fn with_run(run: RunOptions) -> String {
    refused(union(&square(), 1, &Options { run, ..Options::default() }))
}

#[test]
fn sentences_of_functions_on_devices() {
    let options = Options::default();
    let monitor = ProgressMonitor::new();
    monitor.cancel();
    let lines = [
        refused(boolean(&square(), &square(), "A*B", 1, &options)),
        refused(union(&far_cell(), 1, &options)),
        refused(union(&[vec![(0, 0), (1, 0), (0, 1)], vec![(0, 0), (1, 0)]], 1, &options)),
        refused(union(&square(), 1, &Options { precision: 0.0, ..options })),
        refused(union(&square(), 1, &Options { max_points: Some(2), ..options })),
        refused(offset(&square(), f64::NAN, &OffsetOptions::default(), 1, &options)),
        with_join(Join::Miter { limit: 0.5 }),
        with_join(Join::Extended { extension: -1.0 }),
        with_join(Join::Round { points_per_turn: 2.0 }),
        with_run(RunOptions { strips: StripCount::Fixed(0), ..RunOptions::default() }),
        with_run(RunOptions { threads: Some(0), ..RunOptions::default() }),
        with_run(RunOptions { monitor: Some(&monitor), ..RunOptions::default() }),
        refused(invert(&square(), f64::NAN, 1, &options)),
        refused(invert(&square(), 1, 1, &Options { hierarchy: Hierarchy::Keep, ..options })),
        refused(Region::of(&square(), &Options { hierarchy: Hierarchy::Keep, ..options })),
        refused(kl_offset(&square(), f64::INFINITY, 2, 1, &KLayoutOptions::default())),
        refused(kl_invert(
            &square(),
            1,
            1,
            &KLayoutOptions { tile_size: Some((0.0, 1.0)), ..KLayoutOptions::default() },
        )),
    ];
    expect![[r#"
        boolean: operation is "A*B", but it must be one of or, A+B, and, A&B, not, A-B, B-A, xor, A^B
        union: in cell far: shape 0: coordinate 1000000000 µm is not a number within ±2^40 grid steps (±109951162.7776 µm at this precision)
        in union: in shape 1 of a list: shapes: an outline has 2 points, but it needs at least 3
        union: precision is 0 µm, but it must be finite and greater than 0 µm
        union: max_points is 2, but it must be at least 3
        offset: distance is NaN, but it must be within ±2^40 grid steps
        offset: miter limit is 0.5, but it must be finite and at least 1
        offset: extension is -1, but it must be finite and at least 0
        offset: points_per_turn is 2, but it must be finite and at least 3
        union: strips is 0, but it must be at least 1
        union: threads is 0, but it must be at least 1
        union: the operation was cancelled
        invert: margin is NaN, but it must be finite
        invert: the hierarchy cannot be kept, because the box around all shapes touches every cell
        boolean: the hierarchy cannot be kept, because a region has no cells
        kl_offset: distance is inf, but it must be within ±2^40 grid steps
        kl_invert: tile_size is 0, but it must be greater than zero and finite"#]].assert_eq(&lines.join("\n"));
}

#[test]
fn sentences_of_operations_on_the_grid() {
    let far: Contours = [[(0, 0), (MAX_COORDINATE + 1, 0), (0, 1)].map(GridPoint::from)].into_iter().collect();
    let lines = [
        grid::boolean(&far, &Contours::new(), Operation::Or, &RunOptions::default()).unwrap_err(),
        grid::snap(&grid::with_step(1e-4).unwrap(), [[(0.0, 1.2e8)]]).unwrap_err(),
        grid::with_step(f64::NAN).unwrap_err(),
        BooleanError::TooLarge { edges: 1 << 31, limit: (1 << 31) - 1 },
        BooleanError::Memory { edges: 1_000_000, crossings: 200_000_000, limit: 16_000_000_000 },
        BooleanError::Threads { threads: 4, reason: "out of memory".into() },
    ];
    expect![[r#"
        shape 0: point (1099511627777, 0) must be within ±2^40 grid steps
        shape 0: coordinate 120000000 µm is not a number within ±2^40 grid steps (±109951162.7776 µm at this precision)
        precision is NaN µm, but it must be finite and greater than zero
        2147483648 edges are too many for one operation; the limit is 2147483647
        1000000 edges with 200000000 crossings or more need more memory than the limit of 16000 MB; raise `memory_limit` or divide the shapes
        cannot start 4 threads: out of memory"#]]
    .assert_eq(&lines.map(|error| error.to_string()).join("\n"));
}
