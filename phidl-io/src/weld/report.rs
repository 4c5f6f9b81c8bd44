//! What welding found and did.

use phidl_core::geom::Point;

/// What the writer did about joints. Its `Display` is one line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WeldReport {
    /// Joints, each once per cell that holds it.
    pub joints: u64,
    /// Joints that are exact without welding.
    pub closed: u64,
    /// Joints that were written in place.
    pub welded: u64,
    /// Cells that the file has in addition: turned or patched forms.
    pub forms: Vec<FormReport>,
    /// Arrays of which some elements became references.
    pub arrays_split: u64,
    /// Vertices that edges got at seam points.
    pub inserted_vertices: u64,
    /// Outlines that would cross themselves if welded, and are written as they would be without.
    pub squeezed_outlines: u64,
    /// The largest distance of a seam corner from its true position (grid steps).
    pub largest_move_steps: f64,
    /// The largest distance of two corners that should be one, in a file without welding (grid steps).
    pub largest_gap_steps: f64,
    /// The joints that the options ask to be listed, by position.
    pub listed: Vec<JointReport>,
    /// Facing ports that miss each other by up to five grid steps: position and distance (µm).
    pub near_misses: Vec<(Point, f64)>,
}

/// One joint of a cell.
#[derive(Debug, Clone, PartialEq)]
pub struct JointReport {
    /// The cell that holds both sides.
    pub cell: String,
    /// Where it is, in the frame of that cell (µm).
    pub position: Point,
    /// How often it occurs below the top cell.
    pub instances: u64,
    /// The two sides: aliases or `cell#number` of references with the port, or `polygon` where there is no port.
    pub sides: [String; 2],
    /// What it is.
    pub status: WeldStatus,
    /// The largest distance of two corners that should be one, in a file without welding (grid steps).
    pub gap_steps: f64,
}

/// What became of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum WeldStatus {
    /// All corners lie on one grid point without welding.
    Closed,
    /// Both sides were written with the same grid points.
    Welded,
    /// Open, and not welded since the options say so.
    Open,
    /// Two rigid sides disagree; the joint stays open.
    Unweldable,
    /// The directions of the ports do not agree; the joint stays as it is.
    Askew,
    /// A layer has an edge on one side only.
    OneSided,
    /// The sides meet in a point; there is nothing to weld.
    Point,
}

impl WeldStatus {
    pub(super) fn is_problem(self) -> bool {
        matches!(self, Self::Unweldable | Self::Askew)
    }
}

impl std::fmt::Display for WeldStatus {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Closed => "closed",
            Self::Welded => "welded",
            Self::Open => "open",
            Self::Unweldable => "unweldable",
            Self::Askew => "askew",
            Self::OneSided => "one-sided",
            Self::Point => "point",
        })
    }
}

/// A cell that is written in other coordinates than its own.
#[derive(Debug, Clone, PartialEq)]
pub struct FormReport {
    /// Its name in the file.
    pub name: String,
    /// The cell whose form it is.
    pub cell: String,
    /// The angle that is in its coordinates (degrees, below 90).
    pub rotation: f64,
    /// The magnification that is in its coordinates.
    pub magnification: f64,
}

/// Counts of what forms needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Counts {
    pub(super) inserted_vertices: u64,
    pub(super) arrays_split: u64,
    pub(super) squeezed: u64,
}

impl WeldReport {
    /// Adds what was done for another top device of the same file.
    pub(crate) fn add(&mut self, other: Self) {
        self.joints += other.joints;
        self.closed += other.closed;
        self.welded += other.welded;
        self.forms.extend(other.forms);
        self.arrays_split += other.arrays_split;
        self.inserted_vertices += other.inserted_vertices;
        self.squeezed_outlines += other.squeezed_outlines;
        self.largest_move_steps = self.largest_move_steps.max(other.largest_move_steps);
        self.largest_gap_steps = self.largest_gap_steps.max(other.largest_gap_steps);
        self.listed.extend(other.listed);
        self.near_misses.extend(other.near_misses);
    }
}

impl std::fmt::Display for WeldReport {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let mut cells: Vec<&str> = self.forms.iter().map(|form| form.cell.as_str()).collect();
        cells.sort_unstable();
        cells.dedup();
        let count = |n: u64, one: &str| format!("{n} {one}{}", if n == 1 { "" } else { "s" });
        write!(f, "{}: {} closed, {} welded", count(self.joints, "joint"), self.closed, self.welded)?;
        if !self.forms.is_empty() {
            let (forms, of) = (self.forms.len() as u64, cells.len() as u64);
            write!(f, " ({} of {})", count(forms, "form"), count(of, "cell"))?;
        }
        let problems = self.listed.iter().filter(|joint| joint.status.is_problem()).count();
        if problems > 0 {
            write!(f, ", {problems} with a problem")?;
        }
        if self.welded > 0 {
            write!(f, "; corners up to {:.2} steps from their true positions", self.largest_move_steps)?;
        }
        if !self.near_misses.is_empty() {
            write!(f, "; {}", count(self.near_misses.len() as u64, "near miss").replace("misss", "misses"))?;
        }
        Ok(())
    }
}
