//! [`Margin`] and [`OpenPorts`] as parameters of generators: their form as values.

use phidl_core::param::{ConversionError, Param, ParamType, Value};

use super::{Margin, OpenPorts};

impl From<bool> for OpenPorts {
    /// Open by the width of the port, or not at all.
    fn from(open: bool) -> Self {
        if open { Self::WithMargin(0.0) } else { Self::Closed }
    }
}

impl From<f64> for OpenPorts {
    fn from(margin: f64) -> Self {
        Self::WithMargin(margin)
    }
}

impl From<i32> for OpenPorts {
    fn from(margin: i32) -> Self {
        Self::WithMargin(margin.into())
    }
}

impl Param for OpenPorts {
    fn param_type() -> ParamType {
        ParamType::Other("false, true or a margin")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::Closed => false.into(),
            Self::WithMargin(margin) => (*margin).into(),
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match (bool::from_value(value), value.as_f64()) {
            (Ok(open), _) => Ok(open.into()),
            (_, Some(margin)) => Ok(Self::WithMargin(margin)),
            _ => Err(ConversionError::new(value, "be true, false or a length")),
        }
    }
}

impl Param for Margin {
    fn param_type() -> ParamType {
        ParamType::Other("a length, or one in x and one in y")
    }

    fn to_value(&self) -> Value {
        Value::List(vec![self.x.into(), self.y.into()])
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match (value.as_f64(), value.as_list()) {
            (Some(margin), _) => Ok(margin.into()),
            (None, Some([x, y])) => Ok(Self { x: f64::from_value(x)?, y: f64::from_value(y)? }),
            _ => Err(ConversionError::new(value, "be a length or two lengths")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn openings_and_margins_round_trip_through_their_values() {
        for open in [OpenPorts::Closed, OpenPorts::WithMargin(0.0), OpenPorts::WithMargin(2.5)] {
            assert_eq!(OpenPorts::from_value(&open.to_value()), Ok(open));
        }
        assert_eq!(OpenPorts::from_value(&true.into()), Ok(OpenPorts::WithMargin(0.0)));
        let margin = Margin { x: 1.0, y: -2.0 };
        assert_eq!(Margin::from_value(&margin.to_value()), Ok(margin));
        assert_eq!(Margin::from_value(&3.into()), Ok(3.into()));
        assert!(Margin::from_value(&"wide".into()).is_err() && OpenPorts::from_value(&"wide".into()).is_err());
    }
}
