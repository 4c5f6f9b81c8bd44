//! [`Problem`]: what a reader could not keep as it was.

/// The most problems that are listed; the others are counted.
const MOST_LISTED: usize = 10_000;

/// An element or record of a file that was left out or read as something else. The rest of the file is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The cell in which it stands; empty outside cells.
    pub cell: String,
    /// Where it stands in the file (bytes).
    pub offset: usize,
    /// What it is.
    pub kind: ProblemKind,
}

/// What was left out or read as something else.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProblemKind {
    /// A node element: kept in the layout, not drawn.
    Node,
    /// A box element: read as a polygon.
    Box,
    /// An outline or path that encloses nothing: left out.
    Empty,
    /// A placement whose angle or magnification does not follow its parents: read as one that does.
    Absolute,
    /// A text that is not UTF-8: read as Latin-1.
    Latin1,
    /// A record of a kind that the format does not know or that means nothing here: left out.
    Record(u8),
    /// An element that breaks a rule, which is the text: left out.
    Element(Box<str>),
    /// Points of a reference or text after those that it has: left out.
    FurtherPoints,
    /// A second property with the same attribute on one element: the first one is kept.
    RepeatedProperty(u16),
    /// A property of a cell or of the library, which GDSII does not have: left out.
    CellProperty,
    /// A cell that is placed and not defined: read as an empty cell.
    MissingCell(Box<str>),
    /// KLayout's notes on the origin of cells (`$$$CONTEXT_INFO$$$`): left out.
    ContextInfo,
    /// Bytes after the end of the library that are not zero.
    Trailing(usize),
    /// A property whose name means nothing here: left out. Each name is listed once.
    Property(Box<str>),
    /// A circle of OASIS: read as a polygon.
    Circle,
    /// A polygon of OASIS whose list of alternating directions has an odd number of corners: read, but not by all tools.
    OddList,
    /// What an OASIS file states of its tables or its end and does not keep, as a sentence. It is read by its records.
    Strict(Box<str>),
    /// A checksum that is not that of the bytes.
    Checksum {
        /// What the file states.
        stated: u32,
        /// What its bytes have.
        found: u32,
    },
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if !self.cell.is_empty() {
            write!(f, "cell {:?}, ", self.cell)?;
        }
        write!(f, "byte {}: ", self.offset)?;
        match &self.kind {
            ProblemKind::Node => f.write_str("a node is not drawn"),
            ProblemKind::Box => f.write_str("a box is read as a polygon"),
            ProblemKind::Empty => f.write_str("an outline that encloses nothing is left out"),
            ProblemKind::Absolute => f.write_str("an absolute angle or magnification is read as a relative one"),
            ProblemKind::Latin1 => f.write_str("a text that is not UTF-8 is read as Latin-1"),
            ProblemKind::Record(kind) => write!(f, "a record of kind {kind:#04x} is left out"),
            ProblemKind::Element(rule) => write!(f, "an element is left out: {rule}"),
            ProblemKind::FurtherPoints => f.write_str("points after the first ones are left out"),
            ProblemKind::RepeatedProperty(attribute) => {
                write!(f, "a second property with the attribute {attribute} is left out")
            }
            ProblemKind::CellProperty => f.write_str("a property outside of elements is left out"),
            ProblemKind::MissingCell(name) => {
                write!(f, "cell {name:?} is not in the file and is read as an empty cell")
            }
            ProblemKind::ContextInfo => f.write_str("KLayout's notes on the origin of cells are left out"),
            ProblemKind::Property(name) => write!(f, "the property {name:?} has no counterpart and is left out"),
            ProblemKind::Circle => f.write_str("a circle is read as a polygon"),
            ProblemKind::OddList => {
                f.write_str("a polygon has an odd number of alternating edges, which some tools refuse")
            }
            ProblemKind::Strict(what) => f.write_str(what),
            ProblemKind::Checksum { stated, found } => {
                write!(f, "the checksum is {stated:08x}, but that of the bytes is {found:08x}")
            }
            ProblemKind::Trailing(count) => write!(f, "{count} bytes after the end of the library are left out"),
        }
    }
}

/// The problems of a file in the order in which they were found: the first 10,000, and the number of the others.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Problems {
    list: Vec<Problem>,
    unlisted: usize,
}

impl Problems {
    /// Adds a problem.
    pub fn push(&mut self, cell: &str, offset: usize, kind: ProblemKind) {
        if self.list.len() < MOST_LISTED {
            self.list.push(Problem { cell: cell.to_owned(), offset, kind });
        } else {
            self.unlisted += 1;
        }
    }

    /// The problems that are listed.
    #[must_use]
    pub fn as_slice(&self) -> &[Problem] {
        &self.list
    }

    /// How many further problems there are.
    #[must_use]
    pub fn unlisted(&self) -> usize {
        self.unlisted
    }

    /// The list in the order of the file.
    #[must_use]
    pub fn into_sorted(mut self) -> Vec<Problem> {
        self.list.sort_by_key(|problem| problem.offset);
        self.list
    }
}
