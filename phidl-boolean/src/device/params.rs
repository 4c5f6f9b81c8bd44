//! [`Border`] and [`OpenPorts`] as parameters of generators: how they look as plain values.

use phidl_core::param::{ConversionError, Param, ParamType, Value};

use super::{Border, OpenPorts};

impl From<bool> for OpenPorts {
    /// Open by the width of the port, or not at all.
    fn from(open: bool) -> Self {
        if open { Self::Wider(0.0) } else { Self::Closed }
    }
}

impl From<f64> for OpenPorts {
    fn from(margin: f64) -> Self {
        Self::Wider(margin)
    }
}

impl From<i32> for OpenPorts {
    fn from(margin: i32) -> Self {
        Self::Wider(margin.into())
    }
}

impl Param for OpenPorts {
    fn param_type() -> ParamType {
        ParamType::Other("false, true or a margin")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::Closed => false.into(),
            Self::Wider(margin) => (*margin).into(),
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match (bool::from_value(value), value.as_f64()) {
            (Ok(open), _) => Ok(open.into()),
            (_, Some(margin)) => Ok(Self::Wider(margin)),
            _ => Err(ConversionError::new(value, "be true, false or a length")),
        }
    }
}

impl Param for Border {
    fn param_type() -> ParamType {
        ParamType::Other("a length, or one in x and one in y")
    }

    fn to_value(&self) -> Value {
        Value::List(vec![self.x.into(), self.y.into()])
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match (value.as_f64(), value.as_list()) {
            (Some(border), _) => Ok(border.into()),
            (None, Some([x, y])) => Ok(Self { x: f64::from_value(x)?, y: f64::from_value(y)? }),
            _ => Err(ConversionError::new(value, "be a length or two lengths")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn openings_and_borders_come_back_from_their_values() {
        for open in [OpenPorts::Closed, OpenPorts::Wider(0.0), OpenPorts::Wider(2.5)] {
            assert_eq!(OpenPorts::from_value(&open.to_value()), Ok(open));
        }
        assert_eq!(OpenPorts::from_value(&true.into()), Ok(OpenPorts::Wider(0.0)));
        let border = Border { x: 1.0, y: -2.0 };
        assert_eq!(Border::from_value(&border.to_value()), Ok(border));
        assert_eq!(Border::from_value(&3.into()), Ok(3.into()));
        assert!(Border::from_value(&"wide".into()).is_err() && OpenPorts::from_value(&"wide".into()).is_err());
    }
}
