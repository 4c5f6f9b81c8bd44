//! Joints of one cell: sites where ports meet, contacts of their faces, seam points.

use std::collections::BTreeMap;

use phidl_core::geom::{Point, Rect};
use phidl_core::layer::Layer;
use phidl_core::num::angle;
use phidl_core::place::Bounded;
use phidl_core::scene::Reference;

use super::cells::CellIndex;
use super::corner::{Corner, in_steps, is_on, rounded};
use super::faces::{FaceEdge, FaceSearch, Line, Rigid, Scope};
use super::ports::{FreePort, Lattice, Owner, placed_ports};
use super::sites::clusters;
use crate::error::{IoError, Result};

/// Ports whose directions differ by less are opposite or equal (degrees): what routes accept.
pub(super) const ASKEW: f64 = 0.001;
/// Opposite ports of one midpoint up to this angle are reported as askew (degrees).
const MOST_ASKEW: f64 = 5.0;

/// A joint of a cell: two sides that meet along faces.
#[derive(Debug, Clone)]
pub(super) struct Joint {
    pub(super) midpoint: Point,
    pub(super) sides: [Side; 2],
    pub(super) seams: Vec<Seam>,
    pub(super) state: State,
    /// The largest distance of vertices that should be one, as a reader of a file without welding finds them (steps).
    pub(super) gap: f64,
    /// How many joints this one stands for: those of an array that are alike.
    pub(super) times: u64,
}

/// One side of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Side {
    pub(super) owner: Option<Owner>,
    pub(super) element: (u32, u32),
}

/// What there is to weld at a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum State {
    /// Exact in an upright cell: all members lie on one grid point already.
    Closed,
    Open,
    /// Faces meet in nothing that is longer than a point.
    Point,
    /// A layer has an edge on one side only.
    OneSided,
    /// The directions do not agree.
    Askew,
}

/// An end of a contact: one position, one grid point.
#[derive(Debug, Clone)]
pub(super) struct Seam {
    pub(super) at: Point,
    /// The layers on which edges through it get a vertex.
    pub(super) layers: Vec<Layer>,
    /// Where exact members lie (steps).
    pub(super) exact: Vec<Corner>,
    pub(super) rigid: Vec<Rigid>,
    /// A rigid edge that runs through it, whose ends cannot be moved.
    pub(super) rigid_edge: Option<[Rigid; 2]>,
}

/// What was found in one cell.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub(super) joints: Vec<Joint>,
    pub(super) free: Vec<FreePort>,
    /// Facing ports that miss each other by a few steps: position and distance (µm).
    pub(super) near_misses: Vec<(Point, f64)>,
}

/// A port at one position.
#[derive(Debug, Clone, Copy)]
struct Entry {
    port: usize,
    midpoint: Point,
    orientation: f64,
    element: (u32, u32),
}

/// Finds the joints of one cell; those of the cells that it places are known.
pub(super) struct JointSearch<'a> {
    pub(super) faces: FaceSearch<'a>,
    pub(super) cell: &'a CellIndex,
    pub(super) bare: bool,
    /// An array with more elements in open joints is an error.
    pub(super) most_elements: usize,
}

impl JointSearch<'_> {
    pub(super) fn run<'f>(&self, free_of: impl Fn(&Reference) -> &'f [FreePort]) -> Result<Found> {
        let ports = placed_ports(&self.cell.device, free_of);
        if ports.is_empty() {
            return Ok(Found::default());
        }
        let mut found = Found::default();
        let mut used = vec![Vec::new(); ports.len()];
        let mut entries = self.single_entries(&ports);
        self.within_arrays(&ports, &mut entries, &mut found)?;
        self.lattice_entries(&ports, &mut entries)?;
        entries.sort_by_key(|entry| (entry.port, entry.element));
        entries.dedup_by_key(|entry| (entry.port, entry.element));
        let sites = clusters(entries.iter().map(|entry| entry.midpoint), self.reach());
        let mut lonely = Vec::new();
        for site in &sites {
            let site: Vec<Entry> = site.iter().map(|index| entries[*index]).collect();
            self.site(&ports, &site, &mut found, &mut used, &mut lonely);
        }
        found.near_misses = self.near_misses(&lonely);
        found.joints.sort_by(|a, b| position_order(a.midpoint, b.midpoint));
        found.free = self.still_free(ports, &used);
        Ok(found)
    }

    fn reach(&self) -> f64 {
        self.faces.reach
    }

    fn single_entries(&self, ports: &[FreePort]) -> Vec<Entry> {
        let singles = ports.iter().enumerate().filter(|(_, port)| port.lattice.is_none());
        singles.map(|(index, port)| entry(index, port, (0, 0))).collect()
    }

    /// Elements of lattices that meet single ports, and lattices that meet each other.
    fn lattice_entries(&self, ports: &[FreePort], entries: &mut Vec<Entry>) -> Result<()> {
        let lattices: Vec<(usize, &FreePort, Lattice)> =
            ports.iter().enumerate().filter_map(|(index, port)| Some((index, port, port.lattice?))).collect();
        let singles = entries.clone();
        for (place, (index, port, lattice)) in lattices.iter().enumerate() {
            let hull = lattice_box(port, lattice).grown(self.reach());
            for single in singles.iter().filter(|single| hull.contains(single.midpoint)) {
                let element = lattice.element_at(single.midpoint - port.midpoint, self.reach());
                entries.extend(element.map(|element| entry(*index, port, element)));
            }
            for (other_index, other, other_lattice) in &lattices[place + 1..] {
                let alike = angle::between(port.orientation, other.orientation).abs();
                let same_owner = owner_reference(port) == owner_reference(other);
                let apart = !hull.touches(&lattice_box(other, other_lattice));
                if same_owner || apart || (alike > ASKEW && alike < 180.0 - ASKEW) {
                    continue;
                }
                let (few, many) = match lattice.count() <= other_lattice.count() {
                    true => ((*index, *port, lattice), (*other_index, *other, other_lattice)),
                    false => ((*other_index, *other, other_lattice), (*index, *port, lattice)),
                };
                if few.2.count() > self.most_elements as u64 {
                    return Err(self.too_many(few.2.count()));
                }
                for element in few.2.elements() {
                    let at = few.1.midpoint + few.2.shift(element);
                    if let Some(met) = many.2.element_at(at - many.1.midpoint, self.reach()) {
                        entries.push(entry(few.0, few.1, element));
                        entries.push(entry(many.0, many.1, met));
                    }
                }
            }
        }
        Ok(())
    }

    /// Elements of one array that meet each other. Where all such joints are exact they are counted; else their elements
    /// become entries.
    fn within_arrays(&self, ports: &[FreePort], entries: &mut Vec<Entry>, found: &mut Found) -> Result<()> {
        for (p, first) in ports.iter().enumerate() {
            let Some(lattice) = first.lattice.filter(|lattice| lattice.of_reference) else { continue };
            for (q, second) in ports.iter().enumerate() {
                let opposite = angle::between(first.orientation, second.orientation).abs() >= 180.0 - ASKEW;
                if owner_reference(first) != owner_reference(second) || !opposite || second.lattice.is_none() {
                    continue;
                }
                // The element of `second` that meets element (0, 0) of `first`; each pair is found once, from one side.
                let Some((di, dj)) = lattice.solve(first.midpoint - second.midpoint, self.reach()) else { continue };
                if (di, dj) <= (0, 0) {
                    continue;
                }
                let pairs = self.pairs(&lattice, (di, dj));
                let Some(&(one, other)) = pairs.first() else { continue };
                let site = [entry(p, first, one), entry(q, second, other)];
                let mut sample = Found::default();
                let mut used = vec![Vec::new(); ports.len()];
                self.site(ports, &site, &mut sample, &mut used, &mut Vec::new());
                let on_grid = lattice.steps.iter().all(|step| self.is_whole(*step));
                let all_alike = on_grid && sample.joints.iter().all(|joint| joint.state != State::Open);
                if all_alike {
                    let times = pair_count(&lattice, (di, dj));
                    found.joints.extend(sample.joints.into_iter().map(|joint| Joint { times, ..joint }));
                    continue;
                }
                if pair_count(&lattice, (di, dj)) > self.most_elements as u64 {
                    return Err(self.too_many(pair_count(&lattice, (di, dj))));
                }
                for (one, other) in pairs {
                    entries.push(entry(p, first, one));
                    entries.push(entry(q, second, other));
                }
            }
        }
        Ok(())
    }

    fn too_many(&self, count: u64) -> IoError {
        let rule = format!("be at most {} (weld.most_forms)", self.most_elements);
        let what = format!("{count} elements of arrays in cell \"{}\"", self.cell.device.name());
        IoError::option("weld", format_args!("{what}"), rule)
    }

    /// The pairs of elements that are some columns and rows apart.
    fn pairs(&self, lattice: &Lattice, (di, dj): (i64, i64)) -> Vec<((u32, u32), (u32, u32))> {
        let [columns, rows] = lattice.counts;
        let most = self.most_elements.saturating_add(1);
        let other = |(i, j): (u32, u32)| {
            let i = u32::try_from(i64::from(i) + di).ok().filter(|i| *i < columns)?;
            let j = u32::try_from(i64::from(j) + dj).ok().filter(|j| *j < rows)?;
            Some((i, j))
        };
        lattice.elements().filter_map(|one| Some((one, other(one)?))).take(most).collect()
    }

    fn is_whole(&self, step: Point) -> bool {
        let steps = in_steps(self.faces.grid, step);
        steps.x.fract() == 0.0 && steps.y.fract() == 0.0
    }

    /// The joint at one site, if there is one.
    fn site(
        &self,
        ports: &[FreePort],
        site: &[Entry],
        found: &mut Found,
        used: &mut [Vec<(u32, u32)>],
        lonely: &mut Vec<Entry>,
    ) {
        // A port of a reference that the cell names as its own is that port once more.
        let repeated = |entry: &Entry| {
            let is_own = |e: &&Entry| matches!(ports[e.port].owner, Owner::Own(_));
            let own = site.iter().filter(is_own).any(|own| same_direction(own, entry));
            own && !matches!(ports[entry.port].owner, Owner::Own(_))
        };
        for entry in site.iter().filter(|entry| repeated(entry)) {
            used[entry.port].push(entry.element);
        }
        let drawn: Vec<&Entry> = {
            let own_has_child = |entry: &Entry| {
                matches!(ports[entry.port].owner, Owner::Own(_))
                    && site.iter().any(|e| repeated(e) && same_direction(e, entry))
            };
            site.iter().filter(|entry| !own_has_child(entry)).collect()
        };
        let Some(first) = drawn.first() else { return };
        let (positive, others): (Vec<&Entry>, Vec<&Entry>) = drawn.iter().partition(|e| same_direction(e, first));
        let (negative, askew): (Vec<&Entry>, Vec<&Entry>) =
            others.into_iter().partition(|e| opposite_direction(e, first));
        if let Some(other) = askew.iter().find(|e| is_askew(e, first)) {
            found.joints.push(self.without_seams(ports, first, other, State::Askew));
        }
        let line = Line::new(first.midpoint, first.orientation);
        if negative.is_empty() {
            let joint = self.bare.then(|| self.bare_joint(ports, first, &line)).flatten();
            match joint {
                Some(joint) => {
                    used[first.port].push(first.element);
                    found.joints.push(joint);
                }
                None => lonely.push(**first),
            }
            return;
        }
        let sides = [&positive, &negative].map(|side| self.side_edges(ports, side, &line, self.window(ports, side)));
        let owners_differ = positive.iter().any(|p| negative.iter().any(|n| scope(ports, p) != scope(ports, n)));
        if !owners_differ {
            return;
        }
        for entry in positive.iter().chain(&negative) {
            used[entry.port].push(entry.element);
        }
        let [front, back] = sides;
        let seams = contacts(&line, &front, &back, self.reach());
        let both = [side_of(ports, positive[0]), side_of(ports, negative[0])];
        found.joints.push(self.joint(&line, both, seams, &[front, back].concat()));
    }

    /// A joint between a port and an edge that has no port.
    fn bare_joint(&self, ports: &[FreePort], entry: &Entry, line: &Line) -> Option<Joint> {
        let span = self.window(ports, &[entry]);
        let front = self.side_edges(ports, &[entry], line, span);
        let behind: Vec<&FaceEdge> = front.iter().filter(|edge| edge.behind).collect();
        let low = behind.iter().map(|edge| edge.positions[0]).fold(f64::INFINITY, f64::min);
        let high = behind.iter().map(|edge| edge.positions[1]).fold(f64::NEG_INFINITY, f64::max);
        if low >= high {
            return None;
        }
        let rest = match scope(ports, entry) {
            Scope::Element(reference, element) => Scope::AllBut(reference, element),
            // What the cell draws itself is one piece with the port; only what it places can be joined to it.
            Scope::Own | Scope::AllBut(..) => return None,
        };
        let back = self.faces.edges(&self.cell.device, rest, line, (low, high));
        let seams = contacts(line, &front, &back, self.reach());
        if seams.is_empty() {
            return None;
        }
        let sides = [side_of(ports, entry), Side { owner: None, element: (0, 0) }];
        Some(self.joint(line, sides, seams, &[front, back].concat()))
    }

    fn without_seams(&self, ports: &[FreePort], one: &Entry, other: &Entry, state: State) -> Joint {
        let sides = [side_of(ports, one), side_of(ports, other)];
        Joint { midpoint: one.midpoint, sides, seams: Vec::new(), state, gap: 0.0, times: 1 }
    }

    /// The part of the face line that the owners of a side can reach.
    fn window(&self, ports: &[FreePort], side: &[&Entry]) -> (f64, f64) {
        let line = Line::new(side[0].midpoint, side[0].orientation);
        let spans = side.iter().filter_map(|entry| Some(line.span_of(&self.owner_box(ports, entry)?)));
        spans.fold((0.0, 0.0), |all, span| (span.0.min(all.0), span.1.max(all.1)))
    }

    fn owner_box(&self, ports: &[FreePort], entry: &Entry) -> Option<Rect> {
        match scope(ports, entry) {
            Scope::Element(reference, (column, row)) => {
                let reference = &self.cell.device.references()[reference];
                Reference::new(reference.device().clone(), reference.element(column, row)).bbox()
            }
            Scope::Own | Scope::AllBut(..) => self.cell.device.bbox(),
        }
    }

    fn side_edges(&self, ports: &[FreePort], side: &[&Entry], line: &Line, span: (f64, f64)) -> Vec<FaceEdge> {
        let mut scopes: Vec<Scope> = Vec::new();
        for entry in side {
            let scope = scope(ports, entry);
            if !scopes.contains(&scope) {
                scopes.push(scope);
            }
        }
        scopes.into_iter().flat_map(|scope| self.faces.edges(&self.cell.device, scope, line, span)).collect()
    }

    fn joint(&self, line: &Line, sides: [Side; 2], mut seams: Vec<Seam>, edges: &[FaceEdge]) -> Joint {
        let mut gap = 0.0_f64;
        let mut closed = true;
        for seam in &mut seams {
            let ends =
                || edges.iter().flat_map(|edge| &edge.ends).filter(|end| end.at.distance(seam.at) <= self.reach());
            let written: Vec<Point> = ends().map(|end| rounded(end.written)).collect();
            gap = written.iter().fold(gap, |gap, p| gap.max(p.distance(written[0])));
            seam.exact = ends().filter(|end| end.rigid.is_none()).filter_map(|end| end.exact).collect();
            seam.rigid = ends().filter_map(|end| end.rigid).collect();
            closed &= ends().all(|end| end.exact.is_some() && end.exact == ends().next().and_then(|e| e.exact));
            let Some(point) = ends().find_map(|end| end.exact) else {
                closed = false;
                continue;
            };
            let position = line.position(seam.at);
            let through = edges.iter().filter(|edge| {
                seam.layers.contains(&edge.layer)
                    && edge.positions[0] + self.reach() < position
                    && position < edge.positions[1] - self.reach()
            });
            for edge in through {
                match edge.ends.each_ref().map(|end| end.exact) {
                    [Some(a), Some(b)] => closed &= is_on(a, b, point),
                    _ => closed = false,
                }
                if let [Some(a), Some(b)] = edge.ends.each_ref().map(|end| end.rigid) {
                    seam.rigid_edge = Some([a, b]);
                }
            }
        }
        let state = match (seams.is_empty(), closed) {
            (true, _) => self.nothing_to_weld(edges),
            (false, true) => State::Closed,
            (false, false) => State::Open,
        };
        Joint { midpoint: line.midpoint, sides, seams, state, gap, times: 1 }
    }

    fn nothing_to_weld(&self, edges: &[FaceEdge]) -> State {
        let (behind, before) = (edges.iter().any(|edge| edge.behind), edges.iter().any(|edge| !edge.behind));
        if behind != before { State::OneSided } else { State::Point }
    }

    /// Facing ports that miss each other by up to five steps.
    fn near_misses(&self, lonely: &[Entry]) -> Vec<(Point, f64)> {
        const STEPS: f64 = 5.0;
        const DEGREES: f64 = 1.0;
        let size = STEPS * self.faces.grid.step();
        #[expect(clippy::cast_possible_truncation, reason = "positions on a mask, in fives of steps")]
        let bucket = |p: Point| ((p.x / size).floor() as i64, (p.y / size).floor() as i64);
        let mut buckets: BTreeMap<(i64, i64), Vec<&Entry>> = BTreeMap::new();
        for entry in lonely {
            buckets.entry(bucket(entry.midpoint)).or_default().push(entry);
        }
        let mut misses = Vec::new();
        for entry in lonely {
            let (x, y) = bucket(entry.midpoint);
            let around = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
            for other in around.filter_map(|key| buckets.get(&key)).flatten() {
                let distance = entry.midpoint.distance(other.midpoint);
                let facing = angle::between(entry.orientation, other.orientation).abs() >= 180.0 - DEGREES;
                let first = (entry.port, entry.element) < (other.port, other.element);
                if first && facing && distance > self.reach() && distance <= size {
                    misses.push((entry.midpoint, distance));
                }
            }
        }
        misses.sort_by(|a, b| position_order(a.0, b.0));
        misses
    }

    /// The ports that a cell hands up: own ports always, those of references unless a joint has used them.
    fn still_free(&self, ports: Vec<FreePort>, used: &[Vec<(u32, u32)>]) -> Vec<FreePort> {
        let is_free = |(index, port): &(usize, FreePort)| match (port.owner, port.lattice) {
            (Owner::Own(_), _) => true,
            (_, None) => used[*index].is_empty(),
            // Elements that are used do no harm above: what meets them there is a third party, which is found.
            (_, Some(lattice)) => (used[*index].len() as u64) < lattice.count(),
        };
        ports.into_iter().enumerate().filter(is_free).map(|(_, port)| port).collect()
    }
}

fn entry(port: usize, of: &FreePort, element: (u32, u32)) -> Entry {
    let shift = of.lattice.map_or(Point::ORIGIN, |lattice| lattice.shift(element));
    Entry { port, midpoint: of.midpoint + shift, orientation: of.orientation, element }
}

fn owner_reference(port: &FreePort) -> Option<usize> {
    match port.owner {
        Owner::Own(_) => None,
        Owner::Reference { reference, .. } => Some(reference),
    }
}

fn scope(ports: &[FreePort], entry: &Entry) -> Scope {
    let port = &ports[entry.port];
    match port.owner {
        Owner::Own(_) => Scope::Own,
        Owner::Reference { reference, .. } => {
            let of_reference = port.lattice.is_some_and(|lattice| lattice.of_reference);
            Scope::Element(reference, if of_reference { entry.element } else { (0, 0) })
        }
    }
}

fn side_of(ports: &[FreePort], entry: &Entry) -> Side {
    Side { owner: Some(ports[entry.port].owner), element: entry.element }
}

fn same_direction(a: &Entry, b: &Entry) -> bool {
    angle::between(a.orientation, b.orientation).abs() <= ASKEW
}

fn opposite_direction(a: &Entry, b: &Entry) -> bool {
    angle::between(a.orientation, b.orientation).abs() >= 180.0 - ASKEW
}

fn is_askew(a: &Entry, b: &Entry) -> bool {
    angle::between(a.orientation, b.orientation).abs() >= 180.0 - MOST_ASKEW
}

fn lattice_box(port: &FreePort, lattice: &Lattice) -> Rect {
    let [last_column, last_row] = lattice.counts.map(|count| count.saturating_sub(1));
    let corners = [(0, 0), (last_column, 0), (0, last_row), (last_column, last_row)];
    let points = corners.map(|element| port.midpoint + lattice.shift(element));
    Rect::around(points).unwrap_or(Rect::new(port.midpoint, port.midpoint))
}

fn pair_count(lattice: &Lattice, (di, dj): (i64, i64)) -> u64 {
    let left = |count: u32, by: i64| u64::from(count).saturating_sub(by.unsigned_abs());
    left(lattice.counts[0], di) * left(lattice.counts[1], dj)
}

/// By x, then by y.
pub(super) fn position_order(a: Point, b: Point) -> std::cmp::Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}

/// The ends of the contacts of two sides, layer by layer: where edges with the material behind and before the line lie on
/// each other for longer than `reach`.
fn contacts(line: &Line, front: &[FaceEdge], back: &[FaceEdge], reach: f64) -> Vec<Seam> {
    let mut layers: Vec<Layer> = front.iter().map(|edge| edge.layer).collect();
    layers.sort_unstable();
    layers.dedup();
    let mut ends: Vec<(f64, Layer, Point)> = Vec::new();
    for layer in layers {
        let on = |edges: &[FaceEdge], behind: bool| -> Vec<[(f64, Point); 2]> {
            let of_side = edges.iter().filter(|edge| edge.layer == layer && edge.behind == behind);
            of_side.map(|e| [(e.positions[0], e.ends[0].at), (e.positions[1], e.ends[1].at)]).collect()
        };
        for [low, high] in overlaps(&joined(on(front, true), reach), &joined(on(back, false), reach), reach) {
            ends.push((low.0, layer, low.1));
            ends.push((high.0, layer, high.1));
        }
    }
    ends.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let mut seams: Vec<Seam> = Vec::new();
    let mut last = f64::NEG_INFINITY;
    for (position, layer, at) in ends {
        debug_assert!(line.distance(at).abs() <= 2.0 * reach);
        match seams.last_mut() {
            Some(seam) if position - last <= reach => {
                if !seam.layers.contains(&layer) {
                    seam.layers.push(layer);
                }
            }
            _ => seams.push(Seam { at, layers: vec![layer], exact: vec![], rigid: vec![], rigid_edge: None }),
        }
        last = position;
    }
    seams
}

type Interval = [(f64, Point); 2];

/// The union of intervals; ends within `reach` are joined.
fn joined(mut intervals: Vec<Interval>, reach: f64) -> Vec<Interval> {
    intervals.sort_by(|a, b| a[0].0.total_cmp(&b[0].0));
    let mut union: Vec<Interval> = Vec::new();
    for interval in intervals {
        match union.last_mut() {
            Some(last) if interval[0].0 <= last[1].0 + reach => {
                if interval[1].0 > last[1].0 {
                    last[1] = interval[1];
                }
            }
            _ => union.push(interval),
        }
    }
    union
}

/// What two unions have in common, longer than `reach`.
fn overlaps(a: &[Interval], b: &[Interval], reach: f64) -> Vec<Interval> {
    let (mut i, mut j) = (0, 0);
    let mut common = Vec::new();
    while let (Some(x), Some(y)) = (a.get(i), b.get(j)) {
        let low = if x[0].0 >= y[0].0 { x[0] } else { y[0] };
        let high = if x[1].0 <= y[1].0 { x[1] } else { y[1] };
        if high.0 - low.0 > reach {
            common.push([low, high]);
        }
        if x[1].0 <= y[1].0 { i += 1 } else { j += 1 }
    }
    common
}
