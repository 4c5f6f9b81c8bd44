//! `cargo xtask convert`: a layout file into another one, or into a picture, a description, layer properties.

use std::path::Path;

use anyhow::{Context, anyhow, ensure};
use phidl_core::layer::{LayerSet, NamedLayer};
use phidl_io::layout::{self, ConvertOptions, ReadOptions, WriteOptions};
use phidl_io::lyp::{self, Lyp, LypNames};
use phidl_io::oasis::{EncodeOptions, Shapes, Validation};
use phidl_io::svg::{self, SvgOptions};
use phidl_io::{IoError, atomic, json};

use crate::flags::{ChecksumFlag, ConvertFlags, ShapesFlag};
use crate::inspect::Strict;

/// Converts a file. What is lost is printed to stderr; with `--strict` nothing is written then.
pub(crate) fn run(flags: &ConvertFlags) -> anyhow::Result<()> {
    let ending = flags.output.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("svg" | "json" | "lyp") => picture(flags, ending.as_deref().unwrap_or_default()),
        _ => file(flags),
    }
}

fn file(flags: &ConvertFlags) -> anyhow::Result<()> {
    let conversion = layout::convert(&flags.input, &flags.output, &options(flags)?).map_err(report)?;
    let problems = conversion.problems.iter().map(ToString::to_string);
    let mut losses: Vec<String> = problems.chain(conversion.losses.iter().cloned()).collect();
    if conversion.unlisted_problems > 0 {
        losses.push(format!("{} more problems", conversion.unlisted_problems));
    }
    print_losses(&losses, flags.strict)?;
    let written = conversion.write(&flags.output).map_err(report)?;
    println!("{}: {} bytes of {}", flags.output.display(), written.bytes, written.format);
    Ok(())
}

fn print_losses(losses: &[String], strict: bool) -> anyhow::Result<()> {
    for loss in losses {
        eprintln!("loss: {loss}");
    }
    if strict && !losses.is_empty() {
        return Err(Strict(format!("{} losses, nothing is written", losses.len())).into());
    }
    Ok(())
}

fn options(flags: &ConvertFlags) -> anyhow::Result<ConvertOptions> {
    let layers = flags.layers.as_deref().map(str::parse).transpose().map_err(report)?;
    let oasis = EncodeOptions {
        validation: match flags.checksum {
            ChecksumFlag::Crc32 => Validation::Crc32,
            ChecksumFlag::Sum => Validation::Sum,
            ChecksumFlag::None => Validation::None,
        },
        compress: !flags.no_compress,
        level: flags.level,
        shapes: match flags.shapes {
            ShapesFlag::Rectangles => Shapes::Rectangles,
            ShapesFlag::Polygons => Shapes::Polygons,
        },
        merge_repeats: !flags.no_merge_repeats,
        layers: layer_set(flags)?,
        ..EncodeOptions::default()
    };
    Ok(ConvertOptions {
        read: read_options(flags),
        layers,
        grid: flags.grid,
        user_unit: flags.user_unit,
        top_name: flags.top.clone(),
        write: WriteOptions { oasis, gzip_level: flags.level, ..WriteOptions::default() },
    })
}

fn read_options(flags: &ConvertFlags) -> ReadOptions {
    ReadOptions { cellname: flags.cell.clone(), flatten: flags.flatten, ..ReadOptions::default() }
}

fn layer_set(flags: &ConvertFlags) -> anyhow::Result<Option<LayerSet>> {
    let Some(path) = &flags.lyp else { return Ok(None) };
    let layers = lyp::read(path).map_err(report)?.to_layers();
    for problem in &layers.problems {
        eprintln!("loss: {problem}");
    }
    Ok(Some(layers.set))
}

/// Formats that are only written.
fn picture(flags: &ConvertFlags, ending: &str) -> anyhow::Result<()> {
    ensure!(flags.layers.is_none() && flags.grid.is_none(), "--layers and --grid are for layout files");
    let import = layout::read(&flags.input, &read_options(flags)).map_err(report)?;
    let losses: Vec<String> = import.problems.iter().map(ToString::to_string).collect();
    print_losses(&losses, flags.strict)?;
    let set = layer_set(flags)?;
    let out: &Path = &flags.output;
    match ending {
        "svg" => {
            let options = SvgOptions { layers: set.unwrap_or_default(), ..SvgOptions::default() };
            svg::write(&import.device, out, &options).map(|_| ()).map_err(report)?;
        }
        "json" => {
            let described = json::describe(&import.device).map_err(report)?;
            atomic::write(out, format!("{}\n", serde_json::to_string_pretty(&described)?).as_bytes())
                .map_err(report)?;
        }
        _ => {
            let mut layers = LayerSet::new();
            for layer in import.device.layers() {
                let known = set.as_ref().and_then(|set| set.find(layer)).cloned();
                layers.add(known.unwrap_or_else(|| NamedLayer::new(layer.to_string(), layer))).context("layers")?;
            }
            let lyp = Lyp::from_layers(&layers, LypNames::Plain).map_err(report)?;
            lyp::write(&lyp, out).map_err(report)?;
        }
    }
    println!("{}", out.display());
    Ok(())
}

#[expect(clippy::needless_pass_by_value, reason = "it stands in map_err")]
fn report(error: IoError) -> anyhow::Error {
    anyhow!(error.report())
}
