//! [`Equalization`]: how far a detector's turns are lengthened.

use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;

/// How much of the differences in length between rows is made up for in the turns: 0 to 1, or `true` for all.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Equalization(pub f64);

impl From<bool> for Equalization {
    fn from(all: bool) -> Self {
        Self(f64::from(u8::from(all)))
    }
}

impl From<f64> for Equalization {
    fn from(part: f64) -> Self {
        Self(part)
    }
}

impl Param for Equalization {
    fn param_type() -> ParamType {
        ParamType::Other("true, false, or a number from 0 to 1")
    }

    fn to_value(&self) -> Value {
        self.0.into()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Bool(all) => Ok((*all).into()),
            number => match number.as_f64() {
                Some(part) => Ok(Self(part)),
                None => Err(ConversionError::new(value, "be true, false or a number from 0 to 1")),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SnspdCandelabraParams;

    #[test]
    fn equalization_is_a_part_or_all() {
        assert_eq!(Equalization::from_value(&true.into()).unwrap(), Equalization(1.0));
        assert_eq!(Equalization::from_value(&0.5.into()).unwrap(), Equalization(0.5));
        assert!(Equalization::from_value(&"all".into()).is_err());
        assert!(SnspdCandelabraParams::default().equalize_path_lengths(1.5).build().is_err());
    }
}
