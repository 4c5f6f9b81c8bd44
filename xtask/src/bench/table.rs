//! The figures of a section as a Markdown table.

use std::collections::BTreeMap;
use std::fmt;

/// Seconds by work and tool.
pub(crate) type Times = BTreeMap<String, BTreeMap<String, f64>>;

/// The figures of one section.
pub(crate) struct Section {
    pub(crate) title: &'static str,
    /// What each side does, where it is not the same.
    pub(crate) notes: &'static str,
    /// The tools that may take part, in the order of the columns.
    pub(crate) tools: &'static [&'static str],
    pub(crate) lines: Vec<Line>,
}

/// One work.
pub(crate) struct Line {
    pub(crate) work: String,
    /// Seconds.
    pub(crate) ours: f64,
    pub(crate) others: BTreeMap<String, f64>,
}

impl Section {
    pub(crate) fn new(title: &'static str, notes: &'static str, tools: &'static [&'static str]) -> Self {
        Self { title, notes, tools, lines: Vec::new() }
    }

    /// Adds a work; `key` is what the others' times stand under.
    pub(crate) fn add(&mut self, work: impl Into<String>, ours: f64, times: &Times, key: &str) {
        let others = times.get(key).cloned().unwrap_or_default();
        self.lines.push(Line { work: work.into(), ours, others });
    }
}

impl Line {
    /// How often ours fits into the fastest of the others.
    fn ratio(&self) -> Option<f64> {
        self.others.values().copied().reduce(f64::min).map(|fastest| fastest / self.ours)
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "### {}\n\n{}\n", self.title, self.notes)?;
        writeln!(f, "| work | phidl (ours) | {} | ratio |", self.tools.join(" | "))?;
        writeln!(f, "|---|{}", "---|".repeat(self.tools.len() + 2))?;
        for line in &self.lines {
            write!(f, "| {} | {} |", line.work, seconds(line.ours))?;
            for tool in self.tools {
                write!(f, " {} |", line.others.get(*tool).map(|time| seconds(*time)).unwrap_or_default())?;
            }
            writeln!(f, " {} |", line.ratio().map(digits).unwrap_or_default())?;
        }
        self.lowest(f)
    }
}

impl Section {
    /// The work in which ours leads by least.
    fn lowest(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let ratios = self.lines.iter().filter_map(|line| Some((line.ratio()?, &line.work)));
        match ratios.min_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((ratio, work)) => writeln!(f, "\nThe lowest ratio is {} ({work}).", digits(ratio)),
            None => Ok(()),
        }
    }
}

/// A time with three digits in a unit that suits it.
fn seconds(time: f64) -> String {
    let (value, unit) = match time {
        t if t < 1e-6 => (t * 1e9, "ns"),
        t if t < 1e-3 => (t * 1e6, "µs"),
        t if t < 1.0 => (t * 1e3, "ms"),
        t => (t, "s"),
    };
    format!("{} {unit}", digits(value))
}

/// A number of at least 0.01 with two or three digits.
fn digits(value: f64) -> String {
    match value {
        v if v < 10.0 => format!("{v:.2}"),
        v if v < 100.0 => format!("{v:.1}"),
        v => format!("{v:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_has_a_column_for_every_tool_and_the_ratio_of_the_fastest() {
        let mut section = Section::new("Paths", "Note.", &["PHIDL", "FlexPath"]);
        let times = [("a".to_owned(), [("PHIDL".to_owned(), 0.03), ("FlexPath".to_owned(), 0.012)].into())].into();
        section.add("extrude", 0.001, &times, "a");
        section.add("alone", 2.5e-7, &times, "b");
        let printed = section.to_string();
        assert!(printed.contains("| work | phidl (ours) | PHIDL | FlexPath | ratio |\n|---|---|---|---|---|\n"));
        assert!(printed.contains("| extrude | 1.00 ms | 30.0 ms | 12.0 ms | 12.0 |\n"));
        assert!(printed.contains("| alone | 250 ns |  |  |  |\n"));
        assert!(printed.ends_with("The lowest ratio is 12.0 (extrude).\n"));
    }
}
