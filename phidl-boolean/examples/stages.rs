//! Draws the stages of the engine: `cargo run -p phidl-boolean --example stages > phidl-boolean/docs/stages.svg`.

mod support;

use std::io::Write;

fn main() -> std::io::Result<()> {
    std::io::stdout().write_all(support::picture().as_bytes())
}
