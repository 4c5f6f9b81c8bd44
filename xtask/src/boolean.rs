//! `cargo xtask boolean`: a set operation between layers of files.

use phidl_boolean::{Operation, ProgressMonitor, Region, RunOptions, StripCount, grid};

use crate::flags::{BooleanFlags, RunFlags};
use crate::stages::Stages;

/// Combines two layers of files and writes the result to a third.
pub(crate) fn run(flags: &BooleanFlags) -> anyhow::Result<()> {
    let operation: Operation = flags.op.parse()?;
    let steps = grid::with_step(flags.run.precision)?;
    flags.out.ensure_is_none_of(&[&flags.a, &flags.b])?;
    let mut stages = Stages::new();
    let monitor = stages.monitor();
    let options = options(&flags.run, &monitor);
    let (a, b) = stages.run("read", || {
        let a = flags.a.read(flags.run.cell.as_deref())?;
        let b = flags.b.read(flags.cell_b.as_deref().or(flags.run.cell.as_deref()))?;
        anyhow::Ok((a, b))
    })?;
    let (a, b) = stages.run("round", || anyhow::Ok((flags.a.contours(&a, &steps)?, flags.b.contours(&b, &steps)?)))?;
    let region = stages.run("combine", || grid::boolean(&a, &b, operation, &options))?;
    let device = stages.run("draw", || flags.out.drawn(&region, flags.run.precision))?;
    stages.run("write", || flags.out.write(&device, flags.run.precision))?;
    println!("A          {:>9} polygons {:>10} vertices  {}", a.len(), a.point_count(), flags.a);
    println!("B          {:>9} polygons {:>10} vertices  {}", b.len(), b.point_count(), flags.b);
    print_result(&region, &flags.out);
    stages.print(a.point_count() + b.point_count());
    Ok(())
}

/// How to run what the flags ask for.
pub(crate) fn options<'a>(flags: &RunFlags, monitor: &'a ProgressMonitor) -> RunOptions<'a> {
    let strips = flags.divisions.map_or_else(StripCount::default, StripCount::Fixed);
    RunOptions { strips, threads: flags.threads, monitor: Some(monitor), ..RunOptions::default() }
}

pub(crate) fn print_result(region: &Region, out: &impl std::fmt::Display) {
    let (polygons, vertices) = (region.polygons().len(), region.contours().point_count());
    println!("result     {polygons:>9} polygons {vertices:>10} vertices  {out}");
}
