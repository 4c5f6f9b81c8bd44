//! What the reader could not keep as it was.

/// Something in a file that was left out or read as something else; the rest of the file is read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// The cell that it stands in.
    pub cell: String,
    /// Where, in bytes from the start of the file.
    pub offset: usize,
    /// What it is.
    pub kind: ProblemKind,
}

/// What was left out or read as something else.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum ProblemKind {
    /// A node element: left out, it is not drawn.
    Node,
    /// A box element: read as a polygon.
    Box,
    /// An outline or path that encloses nothing: left out.
    Empty,
    /// A placement with an angle or magnification that shall not follow its parents: read as one that does.
    Absolute,
    /// A text that is not UTF-8: read as Latin-1.
    Latin1,
    /// A record of a kind that the format does not know or that says nothing here: left out.
    Record(u8),
}

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "cell \"{}\", byte {}: ", self.cell, self.offset)?;
        match self.kind {
            ProblemKind::Node => f.write_str("a node is left out"),
            ProblemKind::Box => f.write_str("a box is read as a polygon"),
            ProblemKind::Empty => f.write_str("an outline that encloses nothing is left out"),
            ProblemKind::Absolute => f.write_str("an absolute angle or magnification is read as a relative one"),
            ProblemKind::Latin1 => f.write_str("a text that is not UTF-8 is read as Latin-1"),
            ProblemKind::Record(kind) => write!(f, "a record of kind {kind:#04x} is left out"),
        }
    }
}
