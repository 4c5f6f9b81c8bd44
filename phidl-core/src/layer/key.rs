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

impl From<&super::NamedLayer> for Layer {
    fn from(named: &super::NamedLayer) -> Self {
        named.layer
    }
}

impl TryFrom<i32> for Layer {
    type Error = crate::Error;

    /// A computed layer number, with datatype 0. (`From` would have to accept −1, or to panic.)
    fn try_from(number: i32) -> crate::Result<Self> {
        let problem = || format!("the number is {number}, but it must be from 0 to {}", u16::MAX);
        u16::try_from(number).map(Self::from).map_err(|_| crate::Error::invalid("layer", problem()))
    }
}

impl From<(u16, u16)> for Layer {
    fn from((number, datatype): (u16, u16)) -> Self {
        Self::new(number, datatype)
    }
}
