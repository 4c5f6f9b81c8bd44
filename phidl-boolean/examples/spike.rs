#[path = "../benches/support/mod.rs"]
mod support;
use phidl_boolean::*;
use std::time::Instant;
fn main() {
    let n: usize = std::env::args().nth(1).map_or(10000, |s| s.parse().unwrap());
    let strip: usize = std::env::args().nth(2).map_or(4000, |s| s.parse().unwrap());
    let (a, b) = (support::confetti(n, 1), support::confetti(n, 2));
    println!("{} vertices", a.point_count() + b.point_count());
    for threads in [1, 2] {
        let opt = RunOptions { threads: Some(threads), strip_vertices: strip, ..Default::default() };
        for op in [Operation::Or, Operation::And, Operation::Not, Operation::Xor] {
            let mut best = 1e9f64;
            let mut r = Region::new();
            for _ in 0..3 {
                let t = Instant::now();
                r = boolean(&a, &b, op, &opt).unwrap();
                best = best.min(t.elapsed().as_secs_f64());
            }
            println!("{threads} threads {op:?}: {best:.3} s, {} polygons {} points area {}", r.polygons().len(), r.contours().point_count(), r.area());
        }
    }
}
