//! [`Layer`]: the pair of numbers that identifies a layer in a file.

/// A layer number with its datatype. `7` is short for `(7, 0)`.
///
/// Both are 16 bits wide, as GDSII stores them; a number that does not fit does not compile.
///
/// ```
/// # use phidl_core::layer::Layer;
/// assert_eq!(Layer::from(7), Layer::new(7, 0));
/// assert_eq!(Layer::from((7, 3)).to_string(), "7/3");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Layer {
    /// The layer number.
    pub number: u16,
    /// The datatype; for labels the texttype.
    pub datatype: u16,
}

impl Layer {
    /// A layer from its two numbers.
    #[must_use]
    pub const fn new(number: u16, datatype: u16) -> Self {
        Self { number, datatype }
    }
}

impl std::fmt::Display for Layer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.number, self.datatype)
    }
}

impl From<u16> for Layer {
    fn from(number: u16) -> Self {
        Self::new(number, 0)
    }
}

impl From<(u16, u16)> for Layer {
    fn from((number, datatype): (u16, u16)) -> Self {
        Self::new(number, datatype)
    }
}
