//! Cell names for the file: legal, unique, short enough, and the same in every run.
//!
//! A cell keeps its device's name where that is free. Where several cells share one, each gets what tells it from the
//! others: the generator's parameters that differ (`ring_radius12`), or else the first digits of its drawing's hash.
//! PHIDL numbers them (`ring002`) instead, so that a cell added in front renames all that follow; here, a name depends
//! on what the cell is and not on where it comes.

use std::collections::{BTreeMap, HashSet};

use phidl_core::param::Value;
use phidl_core::scene::{Device, Source};

use crate::error::{IoError, Result};

/// Digits of the hash that tell cells of one name apart; more where eight do not do.
const DIGITS: usize = 8;

/// A name for each of the distinct `cells`, of which the last is the top cell.
pub(super) fn unique_names(cells: &[Device], top_name: Option<&str>, limit: usize) -> Vec<String> {
    let Some((top, others)) = cells.split_last() else { return Vec::new() };
    let bases: Vec<String> = others.iter().map(|cell| legal(cell.name())).collect();
    let mut groups: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
    for (place, base) in bases.iter().enumerate() {
        groups.entry(base).or_default().push(place);
    }
    let mut names = Names { taken: HashSet::new(), limit };
    let mut given = vec![None; cells.len()];
    let top_base = top_name.map_or_else(|| legal(top.name()), str::to_owned);
    given[others.len()] = names.take(top_base.clone()).or_else(|| Some(names.by_hash(&top_base, top)));
    // Those who need not share come first, so that no made-up name can take theirs.
    for (base, group) in &groups {
        if let [place] = group[..] {
            given[place] = names.take((*base).to_owned());
        }
    }
    for (place, cell) in others.iter().enumerate() {
        if given[place].is_none() {
            let base = &bases[place];
            let group: Option<Vec<&Source>> =
                groups[base.as_str()].iter().map(|other| others[*other].source()).collect();
            let described = cell.source().zip(group).and_then(|(own, all)| by_parameters(base, own, &all));
            let described = described.and_then(|name| names.take(name));
            given[place] = described.or_else(|| Some(names.by_hash(base, cell)));
        }
    }
    given.into_iter().flatten().collect()
}

/// Refuses a name that no file can have.
pub(super) fn check(option: &'static str, name: &str, limit: usize) -> Result<()> {
    if name.is_empty() || name.len() > limit || !name.chars().all(is_legal) {
        let rule = format!("be 1 to {limit} characters of A–Z, a–z, 0–9, _, ? and $");
        return Err(IoError::option(option, format_args!("{name:?}"), rule));
    }
    Ok(())
}

struct Names {
    taken: HashSet<String>,
    limit: usize,
}

impl Names {
    /// Takes a name if it fits and is free.
    fn take(&mut self, name: String) -> Option<String> {
        (name.len() <= self.limit && self.taken.insert(name.clone())).then_some(name)
    }

    /// The base, as much of it as fits, and digits of the drawing's hash: as many as it takes to be unique.
    fn by_hash(&mut self, base: &str, cell: &Device) -> String {
        let digest = cell.drawing_hash().to_string();
        let lengths = DIGITS..self.limit.min(digest.len());
        let by_digits = lengths.map(|length| ending(base, &digest[..length], self.limit));
        // The numbers are never needed unless someone names cells after our hashes.
        let numbered = (2..).map(|n: u64| ending(base, &n.to_string(), self.limit));
        let free = by_digits.chain(numbered).find(|name| !self.taken.contains(name));
        let name = free.expect("invariant: among endless numbers, one is free");
        self.taken.insert(name.clone());
        name
    }
}

/// `base_suffix`, with the base cut to fit the limit.
fn ending(base: &str, suffix: &str, limit: usize) -> String {
    let room = limit.saturating_sub(suffix.len() + 1);
    format!("{}_{suffix}", &base[..base.len().min(room)])
}

/// The base with the parameters in which a cell differs from the others of its name, if one generator drew them all.
fn by_parameters(base: &str, own: &Source, all: &[&Source]) -> Option<String> {
    if all.iter().any(|other| (other.module, other.generator) != (own.module, own.generator)) {
        return None;
    }
    let mut name = base.to_owned();
    for (param, value) in own.params.iter() {
        let differs = all.iter().any(|other| other.params.iter().any(|(p, v)| p == param && v != value));
        if differs {
            name.push('_');
            name.push_str(&legal(param));
            name.push_str(&short(value)?);
        }
    }
    (name != base).then_some(name)
}

/// A value as part of a name: `0.5` is `0p5`, `-3` is `m3`, a list is `1x2`.
fn short(value: &Value) -> Option<String> {
    match value {
        Value::Int(_) | Value::Float(_) => Some(value.to_string().replace('-', "m").replace('.', "p")),
        Value::Bool(v) => Some(v.to_string()),
        Value::Text(text) => Some(legal(text)),
        Value::List(list) => {
            let parts: Option<Vec<String>> = list.iter().map(short).collect();
            Some(parts?.join("x"))
        }
        Value::Null | Value::Map(_) | Value::Device(_) => None,
    }
}

fn legal(name: &str) -> String {
    name.chars().map(|c| if is_legal(c) { c } else { '_' }).collect()
}

fn is_legal(c: char) -> bool {
    c.is_ascii_alphanumeric() || matches!(c, '_' | '?' | '$')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of these names, each with another drawing.
    fn cells(names: &[&str]) -> Vec<Device> {
        let cell = |(i, name): (usize, &&str)| {
            let mut d = Device::builder(name);
            d.add_label(i.to_string(), (0, 0), 1).unwrap();
            d.build().unwrap()
        };
        names.iter().enumerate().map(cell).collect()
    }

    fn hash(cell: &Device) -> String {
        cell.drawing_hash().to_string()[..8].to_owned()
    }

    #[test]
    fn names_that_are_free_are_kept_and_the_top_goes_first() {
        let cells = cells(&["a", "b", "chip", "chip"]);
        let names = unique_names(&cells, None, 32);
        assert_eq!(names, ["a".to_owned(), "b".into(), format!("chip_{}", hash(&cells[2])), "chip".into()]);
        assert_eq!(unique_names(&cells, Some("mask"), 32)[2..], ["chip", "mask"]);
    }

    #[test]
    fn cells_of_one_name_are_told_apart_by_what_they_are_and_not_by_their_order() {
        let mut list = cells(&["a", "a", "top"]);
        let names = unique_names(&list, None, 32);
        list.swap(0, 1);
        let swapped = unique_names(&list, None, 32);
        assert_eq!((&names[0], &names[1]), (&swapped[1], &swapped[0]));
        assert_eq!(names[0], format!("a_{}", hash(&list[1])));
    }

    #[test]
    fn names_are_made_legal_and_cut_to_the_limit() {
        let list = cells(&["a b.c-d", "süß?$", "a_very_long_name_without_end", "top"]);
        let names = unique_names(&list, None, 16);
        assert_eq!(names[..2], ["a_b_c_d", "s__?$"]);
        assert_eq!(names[2], format!("a_very__{}", hash(&list[2])));
        assert!(names.iter().all(|name| name.len() <= 16 && name.chars().all(is_legal)));
    }

    #[test]
    fn a_made_up_name_never_takes_one_that_was_given() {
        let plain = cells(&["a", "a", "top"]);
        let stolen = format!("a_{}", hash(&plain[0]));
        let list: Vec<Device> = plain[..2].iter().cloned().chain(cells(&[&stolen, "top"])).collect();
        let names = unique_names(&list, None, 32);
        assert_eq!(names[2], stolen);
        assert_eq!(names.iter().collect::<HashSet<_>>().len(), 4);
    }

    #[test]
    fn cells_of_one_generator_are_told_apart_by_the_parameters_that_differ() {
        let source = |generator, radius: f64, layer: u16| Source {
            generator,
            module: "m",
            version: "1",
            params: [("radius", radius.into()), ("width", 0.5.into()), ("layer", layer.into())].into(),
        };
        let (a, b, c) = (source("ring", 12.5, 1), source("ring", -3.0, 1), source("ring", 12.5, 2));
        assert_eq!(by_parameters("ring", &a, &[&a, &b]).unwrap(), "ring_radius12p5");
        assert_eq!(by_parameters("ring", &b, &[&a, &b, &c]).unwrap(), "ring_radiusm3_layer1");
        assert_eq!(by_parameters("ring", &a, &[&a, &a]), None);
        assert_eq!(by_parameters("ring", &a, &[&a, &source("disk", 1.0, 1)]), None);
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
