//! `placement.json`: small scripts of placement methods, run on references and on the cell that holds them.

use std::collections::BTreeMap;

use phidl_core::param::Value;
use phidl_core::prelude::*;
use phidl_core::runtime::registry;
use serde::Deserialize;
use serde_json::Value as Json;
use testkit::golden::{Case, Kind, compare_device, compare_reference, load};

/// One line of a script.
#[derive(Debug, Deserialize)]
#[serde(tag = "op", rename_all = "snake_case")]
enum Op {
    AddRef { r#as: String, device: String, params: Json },
    Array { device: String, params: Json, columns: u32, rows: u32, spacing: [f64; 2], rotate: f64 },
    Move { on: Option<String>, by: Option<[f64; 2]>, origin: Option<[f64; 2]>, destination: Option<[f64; 2]> },
    Movex { on: Option<String>, by: f64 },
    Movey { on: Option<String>, by: f64 },
    Rotate { on: Option<String>, angle: f64, center: [f64; 2] },
    Mirror { on: Option<String>, p1: [f64; 2], p2: [f64; 2] },
    Set { on: String, what: String, value: Option<Json>, from: Option<(String, String)>, plus: Option<f64> },
    Align { on: Vec<String>, alignment: String },
    Distribute { on: Vec<String>, direction: String, spacing: f64, separation: bool, edge: String },
    Connect { on: String, port: String, to: (String, String), overlap: f64 },
    Whole { r#do: Box<Op> },
}

/// The cell that a script works on, and what it calls its references.
struct Script {
    cell: DeviceBuilder,
    names: BTreeMap<String, ReferenceKey>,
}

impl Script {
    fn run(&mut self, op: Op) -> Result<()> {
        match op {
            Op::AddRef { r#as, device, params } => {
                let key = self.cell.add(draw(&device, &params)?);
                self.names.insert(r#as, key);
            }
            Op::Array { device, params, columns, rows, spacing, rotate } => {
                self.cell.add(draw(&device, &params)?.array(columns, rows, spacing).rotated(rotate));
            }
            Op::Set { on, what, value, from, plus } => self.set(&on, &what, value, from, plus),
            Op::Align { on, alignment } => {
                let keys = self.keys(&on);
                self.cell.group(keys).align(edge(&alignment));
            }
            Op::Distribute { on, direction, spacing, separation: true, .. } => {
                let direction = if direction == "x" { Direction::X } else { Direction::Y };
                let keys = self.keys(&on);
                self.cell.group(keys).distribute(direction, spacing);
            }
            Op::Distribute { on, spacing, edge: name, .. } => {
                let keys = self.keys(&on);
                self.cell.group(keys).distribute_by(edge(&name), spacing);
            }
            Op::Connect { on, port, to: (other, target), overlap } => {
                let target = self.cell[self.names[&other]].port(&target)?;
                self.cell[self.names[&on]].connect_overlapping(&port, &target, overlap)?;
            }
            Op::Whole { r#do } => place(&mut self.cell, *r#do),
            Op::Move { on: Some(ref on), .. }
            | Op::Movex { on: Some(ref on), .. }
            | Op::Movey { on: Some(ref on), .. }
            | Op::Rotate { on: Some(ref on), .. }
            | Op::Mirror { on: Some(ref on), .. } => place(&mut self.cell[self.names[on]], op),
            op => panic!("{op:?} acts on nothing"),
        }
        Ok(())
    }

    fn set(&mut self, on: &str, what: &str, value: Option<Json>, from: Option<(String, String)>, plus: Option<f64>) {
        let element = self.names[on];
        if what == "center" {
            let center = <[f64; 2]>::deserialize(value.expect("a center is set from a value")).expect("a pair");
            self.cell[element].set_center(center);
            return;
        }
        let to = match (value, from) {
            (Some(value), _) => value.as_f64().expect("an edge is a number"),
            (None, Some((other, what))) => {
                let bbox = self.cell[self.names[&other]].bbox().expect("the scripts draw no empty references");
                edge(&what).of(bbox) + plus.unwrap_or(0.0)
            }
            (None, None) => panic!("set has neither a value nor a source"),
        };
        let reference = &mut self.cell[element];
        match edge(what) {
            Edge::X => reference.set_x(to),
            Edge::XMin => reference.set_xmin(to),
            Edge::XMax => reference.set_xmax(to),
            Edge::Y => reference.set_y(to),
            Edge::YMin => reference.set_ymin(to),
            Edge::YMax => reference.set_ymax(to),
        };
    }

    fn keys(&self, names: &[String]) -> Vec<ReferenceKey> {
        names.iter().map(|name| self.names[name]).collect()
    }
}

/// The placement methods that a reference and a cell have in common.
fn place(element: &mut impl Movable, op: Op) {
    match op {
        Op::Move { by: Some(by), .. } => element.move_by(by),
        Op::Move { origin: Some(origin), destination: Some(destination), .. } => element.move_to(origin, destination),
        Op::Movex { by, .. } => element.movex(by),
        Op::Movey { by, .. } => element.movey(by),
        Op::Rotate { angle, center, .. } => element.rotate_about(angle, center),
        Op::Mirror { p1, p2, .. } => element.mirror(p1, p2),
        op => panic!("{op:?} is no placement method"),
    };
}

fn edge(name: &str) -> Edge {
    match name {
        "x" => Edge::X,
        "xmin" => Edge::XMin,
        "xmax" => Edge::XMax,
        "y" => Edge::Y,
        "ymin" => Edge::YMin,
        "ymax" => Edge::YMax,
        other => panic!("{other:?} is no edge"),
    }
}

fn draw(name: &str, params: &Json) -> Result<Device> {
    let params = BTreeMap::<String, Value>::deserialize(params).expect("parameters are a map");
    registry::find(name)?.build(&params)
}

fn run(case: &Case) -> Result<(), String> {
    let ops = Vec::<Op>::deserialize(&case.rest["ops"]).map_err(|error| error.to_string())?;
    let mut script = Script { cell: Device::builder("script"), names: BTreeMap::new() };
    for op in ops {
        script.run(op).map_err(|error| error.report())?;
    }
    let references = case.expect["references"].as_object().ok_or("no references are expected")?;
    for (name, expected) in references {
        compare_reference(&script.cell[script.names[name]], expected).map_err(|why| format!("{name}: {why}"))?;
    }
    let device = script.cell.build().map_err(|error| error.report())?;
    compare_device(&device, &case.expect)
}

#[test]
fn scripts_of_placement_words_end_where_the_reference_does() {
    let cases = load(Kind::Placement);
    let failures: Vec<String> =
        cases.iter().filter_map(|case| run(case).err().map(|why| format!("{}: {why}", case.id))).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), cases.len(), failures.join("\n"));
}
