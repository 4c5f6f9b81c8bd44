//! Cell names for a file: readable, unique, short enough, and the same in every run.
//!
//! A cell has the name that its generator makes by a template (`#[device(cell_name = …)]`), or else its own. It keeps
//! that if readers take it and no other cell has it. Where several cells share a name, each gets what distinguishes it:
//! the parameters of its generator that differ (`ring_radius12p5`; `ring_r12p5` if that is too long), or else the first
//! digits of its content's hash. PHIDL numbers them (`ring002`) instead, so that a cell added in front renames all that
//! follow. Here a name depends on what the cell is and not on its position.

use std::borrow::Cow;
use std::collections::{BTreeMap, HashSet};

use phidl_core::param::Value;
use phidl_core::scene::{Device, Source};

use super::limits::FileLimits;
use super::table::Naming;
use crate::error::{IoError, Result};

/// Digits of the hash that distinguish cells of one name; more where eight do not suffice.
const DIGITS: usize = 8;

/// A name for each of the distinct `cells`, of which the last `tops` are top cells.
pub(super) fn unique_names(cells: &[Device], tops: usize, naming: &Naming<'_>) -> Vec<String> {
    let mut names = Names { taken: HashSet::new(), naming };
    let mut given = vec![None; cells.len()];
    if let (Some(top), 1) = (cells.last(), tops) {
        let base = naming.top_name.map_or_else(|| naming.limits.legal(&own_name(top)), str::to_owned);
        given[cells.len() - 1] = names.keep(base.clone()).or_else(|| Some(names.by_hash(&base, top)));
    }
    let bases: Vec<String> = cells.iter().map(|cell| naming.limits.legal(&own_name(cell))).collect();
    let groups = groups(cells, &bases, &given);
    // Cells that keep a name come first, so that no made-up name takes it.
    for (base, group) in &groups {
        if let Some(cell) = group.owner(cells, base) {
            given[cell] = names.keep((*base).to_owned());
        }
    }
    let differing: BTreeMap<&str, Vec<&str>> =
        groups.iter().map(|(base, group)| (*base, differing_params(cells, group))).collect();
    for (index, cell) in cells.iter().enumerate() {
        if given[index].is_none() {
            let base = bases[index].as_str();
            let params = differing.get(base).map_or(&[][..], Vec::as_slice);
            let described = |label: Label| {
                cell.source()
                    .filter(|_| label_is_unique(label, params))
                    .and_then(|source| by_parameters(base, source, params, label))
            };
            given[index] = described(strict)
                .and_then(|name| names.make(name))
                .or_else(|| described(initials).and_then(|name| names.make(name)))
                .or_else(|| Some(names.by_hash(base, cell)));
        }
    }
    given.into_iter().flatten().collect()
}

/// The name that the generator of a cell gives it by a template, or the name of the cell.
fn own_name(cell: &Device) -> Cow<'_, str> {
    cell.source().and_then(Source::cell_name).map_or_else(|| Cow::Borrowed(cell.name()), Cow::Owned)
}

/// Refuses a name that the file cannot have.
pub(crate) fn check(option: &'static str, name: &str, limits: &FileLimits) -> Result<()> {
    if limits.is_legal(name) {
        return Ok(());
    }
    let (longest, characters) = (limits.cell_name, limits.characters());
    Err(IoError::option(option, format_args!("{name:?}"), format!("be 1 to {longest} {characters}")))
}

/// The cells that have one name, made legal, by index.
struct SharedName(Vec<usize>);

impl SharedName {
    /// The cell that keeps the name: the only cell, or the only one whose own name it is.
    fn owner(&self, cells: &[Device], base: &str) -> Option<usize> {
        if let [only] = self.0[..] {
            return Some(only);
        }
        let mut owners = self.0.iter().filter(|cell| own_name(&cells[**cell]) == base);
        owners.next().copied().filter(|_| owners.next().is_none())
    }
}

/// The cells without a name so far, by the name that they would keep.
fn groups<'a>(cells: &[Device], bases: &'a [String], given: &[Option<String>]) -> BTreeMap<&'a str, SharedName> {
    let mut groups: BTreeMap<&str, SharedName> = BTreeMap::new();
    for index in (0..cells.len()).filter(|index| given[*index].is_none()) {
        groups.entry(&bases[index]).or_insert(SharedName(Vec::new())).0.push(index);
    }
    groups
}

/// The parameters in which cells of one name differ, if one generator drew them all. One pass over the cells: a mask may
/// have 100,000 cells of one generator.
fn differing_params<'a>(cells: &'a [Device], group: &SharedName) -> Vec<&'a str> {
    let Some(first) = cells[group.0[0]].source() else { return Vec::new() };
    let mut differs = vec![false; first.params.iter().count()];
    for cell in &group.0[1..] {
        match cells[*cell].source() {
            Some(source) if (source.module, source.generator) == (first.module, first.generator) => {
                for ((differs, (_, a)), (_, b)) in differs.iter_mut().zip(first.params.iter()).zip(source.params.iter())
                {
                    *differs |= a != b;
                }
            }
            _ => return Vec::new(),
        }
    }
    first.params.iter().zip(differs).filter_map(|((name, _), differs)| differs.then_some(*name)).collect()
}

struct Names<'a> {
    taken: HashSet<String>,
    naming: &'a Naming<'a>,
}

impl Names<'_> {
    /// Takes a cell's own name if the file can have it and no other cell has it.
    fn keep(&mut self, name: String) -> Option<String> {
        self.take(name, self.naming.limits.cell_name)
    }

    /// Takes a made-up name if it fits and no other cell has it.
    fn make(&mut self, name: String) -> Option<String> {
        self.take(name, self.naming.max_cellname_length)
    }

    fn take(&mut self, name: String, longest: usize) -> Option<String> {
        (name.len() <= longest && self.taken.insert(name.clone())).then_some(name)
    }

    /// The base, as much of it as fits, and digits of the content's hash: as many as make the name unique.
    fn by_hash(&mut self, base: &str, cell: &Device) -> String {
        let limit = self.naming.max_cellname_length;
        let digest = cell.drawing_hash().to_string();
        let lengths = DIGITS..limit.min(digest.len());
        let by_digits = lengths.map(|length| ending(base, &digest[..length], limit));
        // Cells of one drawing and one name are numbered.
        let numbered = (2..).map(|n: u64| ending(base, &format!("{}_{n}", &digest[..DIGITS]), limit));
        let shortest = ending(base, &digest[..DIGITS], limit);
        let same_drawing = self.taken.contains(&shortest);
        let mut candidates: Box<dyn Iterator<Item = String>> =
            if same_drawing { Box::new(numbered) } else { Box::new(by_digits.chain(numbered)) };
        let name = candidates.find(|name| !self.taken.contains(name)).expect("invariant: numbers do not end");
        self.taken.insert(name.clone());
        name
    }
}

/// `base_suffix`, with the base cut to fit the limit.
fn ending(base: &str, suffix: &str, limit: usize) -> String {
    let room = limit.saturating_sub(suffix.len() + 1);
    format!("{}_{suffix}", &base[..base.len().min(room)])
}

/// How a parameter is written in a name.
type Label = fn(&str) -> String;

/// Whether no two parameters are written alike.
fn label_is_unique(label: Label, params: &[&str]) -> bool {
    let labels: HashSet<String> = params.iter().map(|param| label(param)).collect();
    labels.len() == params.len()
}

/// The first letters of the words of a parameter, for names that are too long otherwise: `wire_width` is `ww`.
fn initials(param: &str) -> String {
    strict(param).split('_').filter_map(|word| word.chars().next()).collect()
}

/// The base with those parameters that differ within its group.
fn by_parameters(base: &str, source: &Source, differing: &[&str], label: Label) -> Option<String> {
    let mut name = base.to_owned();
    for (param, value) in source.params.iter().filter(|(param, _)| differing.contains(param)) {
        name.push('_');
        name.push_str(&label(param));
        name.push_str(&short(value)?);
    }
    (name != base).then_some(name)
}

/// A value as part of a name: `0.5` is `0p5`, `-3` is `m3`, a list is `1x2`.
fn short(value: &Value) -> Option<String> {
    match value {
        Value::Int(_) | Value::Float(_) => Some(value.to_string().replace('-', "m").replace('.', "p")),
        Value::Bool(v) => Some(v.to_string()),
        Value::Text(text) => Some(strict(text)),
        Value::List(list) => {
            let parts: Option<Vec<String>> = list.iter().map(short).collect();
            Some(parts?.join("x"))
        }
        Value::Null | Value::Map(_) | Value::Device(_) => None,
    }
}

/// The text in the characters that made-up names have.
fn strict(text: &str) -> String {
    text.chars().map(|c| if c.is_ascii_alphanumeric() || matches!(c, '_' | '?' | '$') { c } else { '_' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::from_device::MergeCells;

    /// Cells of these names, each with another drawing.
    fn cells(names: &[&str]) -> Vec<Device> {
        let cell = |(i, name): (usize, &&str)| {
            let mut d = Device::builder(name);
            d.add_label(i.to_string(), (0, 0), 1).unwrap();
            d.build().unwrap()
        };
        names.iter().enumerate().map(cell).collect()
    }

    fn names_of(
        cells: &[Device],
        top_name: Option<&str>,
        limits: &FileLimits,
        max_cellname_length: usize,
    ) -> Vec<String> {
        let naming = Naming { top_name, max_cellname_length, limits, merge: MergeCells::default() };
        unique_names(cells, 1, &naming)
    }

    fn names(cells: &[Device], top_name: Option<&str>) -> Vec<String> {
        names_of(cells, top_name, &FileLimits::READERS, 32)
    }

    fn hash(cell: &Device) -> String {
        cell.drawing_hash().to_string()[..8].to_owned()
    }

    #[test]
    fn names_of_one_cell_are_kept_and_the_top_cell_goes_first() {
        let cells = cells(&["a", "b", "chip", "chip"]);
        assert_eq!(
            names(&cells, None),
            ["a".to_owned(), "b".into(), format!("chip_{}", hash(&cells[2])), "chip".into()]
        );
        assert_eq!(names(&cells, Some("mask"))[2..], ["chip", "mask"]);
    }

    #[test]
    fn cells_of_one_name_are_distinguished_by_content_and_not_by_order() {
        let mut list = cells(&["a", "a", "top"]);
        let before = names(&list, None);
        list.swap(0, 1);
        let swapped = names(&list, None);
        assert_eq!((&before[0], &before[1]), (&swapped[1], &swapped[0]));
        assert_eq!(before[0], format!("a_{}", hash(&list[1])));
    }

    #[test]
    fn cells_of_one_name_and_drawing_are_numbered() {
        let cell = |length: f64| {
            let mut d = Device::builder("a");
            d.info("length", length);
            d.build().unwrap()
        };
        let list = [cell(1.0), cell(2.0), cell(3.0), Device::builder("top").build().unwrap()];
        let first = format!("a_{}", hash(&list[0]));
        assert_eq!(names(&list, None)[..3], [first.clone(), format!("{first}_2"), format!("{first}_3")]);
    }

    #[test]
    fn names_that_readers_take_are_kept_whatever_their_characters_and_length() {
        let long = "nch_25_mac_w1.2-l0.06[3] of a foundry that names its cells at length";
        assert_eq!(names(&cells(&["a.b", "a-b", "a_b", long, "top"]), None), ["a.b", "a-b", "a_b", long, "top"]);
    }

    #[test]
    fn other_names_are_made_legal_and_do_not_take_the_name_of_a_legal_cell() {
        let list = cells(&["süß?$", "ä_b", "__b", "top"]);
        let names = names(&list, None);
        assert_eq!((names[0].as_str(), names[2].as_str()), ("s__?$", "__b"));
        assert_eq!(names[1], format!("__b_{}", hash(&list[1])));
    }

    #[test]
    fn the_manual_allows_fewer_characters_and_32_of_them() {
        let list = cells(&["a b.c-d", "a_very_long_name_without_any_end_to_it", "top"]);
        let names = names_of(&list, None, &FileLimits::MANUAL, 16);
        assert_eq!(names, ["a_b_c_d".to_owned(), format!("a_very__{}", hash(&list[1])), "top".into()]);
    }

    #[test]
    fn a_made_up_name_never_takes_one_that_was_given() {
        let two = cells(&["a", "a", "top"]);
        let stolen = format!("a_{}", hash(&two[0]));
        let list: Vec<Device> = two[..2].iter().cloned().chain(cells(&[&stolen, "top"])).collect();
        let names = names(&list, None);
        assert_eq!(names[2], stolen);
        assert_eq!(names.iter().collect::<HashSet<_>>().len(), 4);
    }

    #[test]
    fn parameters_that_differ_are_part_of_the_name() {
        let source = |radius: f64, layer: u16| Source {
            generator: "ring",
            module: "m",
            version: "1",
            params: [("radius", radius.into()), ("width", 0.5.into()), ("layer", layer.into())].into(),
        };
        let name = |source: &Source, params: &[&str]| by_parameters("ring", source, params, strict);
        assert_eq!(name(&source(12.5, 1), &["radius"]).unwrap(), "ring_radius12p5");
        assert_eq!(name(&source(-3.0, 1), &["radius", "layer"]).unwrap(), "ring_radiusm3_layer1");
        assert_eq!(name(&source(1.0, 1), &[]), None);
        assert_eq!(by_parameters("ring", &source(-3.0, 1), &["radius", "layer"], initials).unwrap(), "ring_rm3_l1");
        assert_eq!(initials("wire_width"), "ww");
        assert!(
            label_is_unique(initials, &["wire_width", "wire_pitch"]) && !label_is_unique(initials, &["width", "wire"])
        );
    }

    #[test]
    fn values_are_short_and_legal() {
        let cases = [(Value::from(0.5), "0p5"), ((-3).into(), "m3"), ([1, 2].into(), "1x2"), ("N E".into(), "N_E")];
        for (value, expected) in cases {
            assert_eq!(short(&value).unwrap(), expected);
        }
        assert_eq!(short(&Value::Null), None);
    }
}
