//! The vocabulary of `docs/glossary.md`: words that it replaced do not come back into comments and documents.

use std::fs;
use std::path::{Path, PathBuf};

/// Words that have no meaning of their own here, or had several. A pattern is a whole word, in any case of its letters.
const BANNED: [(&str, &str); 20] = [
    ("thing", "say what it is: an element, a shape, an object"),
    ("things", "say what they are"),
    ("whoever", "say who: the caller, the user"),
    ("nobody", "say who does not, or use the passive"),
    ("anew", "again"),
    ("as told", "say by what: a parameter, an option"),
    ("unless told", "by default"),
    ("way points", "waypoints"),
    ("way point", "waypoint"),
    ("so many", "this number of"),
    ("for sure", "certainly, or leave it out"),
    ("by the lot", "in batches"),
    ("gets over", "crosses"),
    ("placement word", "placement method"),
    ("placement words", "placement methods"),
    ("has it", "does it"),
    ("makro", "macro"),
    ("the specification", "PHIDL, or the page in docs/reference"),
    ("quirk of", "say what PHIDL does"),
    ("stubs", "port keep-outs, or poles"),
];

/// Folders and files that keep to the vocabulary; every crate joins when its language pass is done.
const CHECKED: [&str; 19] = [
    "phidl",
    "phidl-boolean",
    "phidl-core",
    "phidl-geometry",
    "phidl-macros",
    "phidl-path",
    "phidl-route",
    "xtask/src",
    "xtask/guide",
    "xtask/testkit",
    "benches",
    "examples",
    "fuzz",
    "docs/glossary.md",
    "docs/guide",
    "docs/reference",
    "README.md",
    "ARCHITECTURE.md",
    "CONTRIBUTING.md",
];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("xtask lies in the workspace").to_owned()
}

/// All Rust and Markdown files below a path.
fn files(path: PathBuf) -> Vec<PathBuf> {
    let (mut files, mut stack) = (Vec::new(), vec![path]);
    while let Some(path) = stack.pop() {
        if path.ends_with("target") {
            continue;
        } else if path.is_dir() {
            let entries = fs::read_dir(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            stack.extend(entries.map(|entry| entry.expect("a readable folder").path()));
        } else if path.extension().is_some_and(|ending| ending == "rs" || ending == "md") {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The prose of a line: all of a Markdown file, the comments of Rust; code in backticks is none.
fn prose(line: &str, is_markdown: bool) -> impl Iterator<Item = &str> {
    let text = match line.find("//") {
        _ if is_markdown => line,
        Some(start) => &line[start..],
        None => "",
    };
    text.split('`').step_by(2)
}

fn contains_word(text: &str, word: &str) -> bool {
    let text = text.to_lowercase();
    let is_letter = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    text.match_indices(word)
        .any(|(at, _)| !is_letter(text[..at].chars().next_back()) && !is_letter(text[at + word.len()..].chars().next()))
}

#[test]
fn words_that_the_glossary_replaced_do_not_come_back() {
    let mut found = Vec::new();
    for file in CHECKED.iter().flat_map(|path| files(root().join(path))) {
        let text = fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let is_markdown = file.extension().is_some_and(|ending| ending == "md");
        for (number, line) in text.lines().enumerate() {
            for (word, instead) in BANNED {
                if prose(line, is_markdown).any(|prose| contains_word(prose, word)) {
                    found.push(format!("{}:{}: {word:?}; {instead}", file.display(), number + 1));
                }
            }
        }
    }
    assert!(found.is_empty(), "{} words of the old vocabulary:\n{}", found.len(), found.join("\n"));
}

#[test]
fn words_are_found_whole_and_in_prose_only() {
    assert!(contains_word("One thing.", "thing") && !contains_word("anything", "thing"));
    assert!(prose("let thing = 1; // one thing", false).any(|text| contains_word(text, "thing")));
    assert!(!prose("let thing = 1;", false).any(|text| contains_word(text, "thing")));
    assert!(!prose("the field `thing`", true).any(|text| contains_word(text, "thing")));
}
