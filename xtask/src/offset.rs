//! `cargo xtask offset`: grows or shrinks a layer of a file.

use phidl_boolean::{Join, OffsetOptions, grid};

use crate::boolean::{options, print_result};
use crate::flags::{JoinFlag, OffsetFlags};
use crate::stages::Stages;

/// Grows or shrinks a layer of a file and writes the result to another.
pub(crate) fn run(flags: &OffsetFlags) -> anyhow::Result<()> {
    let steps = grid::with_step(flags.run.precision)?;
    let growth = OffsetOptions { join: join(flags), merge_first: true };
    let distance = steps.scaled(flags.distance);
    flags.out.ensure_is_none_of(&[&flags.input])?;
    let mut stages = Stages::new();
    let monitor = stages.monitor();
    let options = options(&flags.run, &monitor);
    let device = stages.run("read", || flags.input.read(flags.run.cell.as_deref()))?;
    let contours = stages.run("round", || flags.input.contours(&device, &steps))?;
    let region = stages.run("offset", || grid::offset(&contours, distance, &growth, &options))?;
    let device = stages.run("draw", || flags.out.drawn(&region, flags.run.precision))?;
    stages.run("write", || flags.out.write(&device, flags.run.precision))?;
    println!("input      {:>9} polygons {:>10} vertices  {}", contours.len(), contours.point_count(), flags.input);
    print_result(&region, &flags.out);
    stages.print(contours.point_count());
    Ok(())
}

fn join(flags: &OffsetFlags) -> Join {
    match flags.join {
        JoinFlag::Miter => Join::Miter { limit: flags.miter_limit },
        JoinFlag::Bevel => Join::Bevel,
        JoinFlag::Round => Join::Round { points_per_turn: flags.points_per_turn },
    }
}
