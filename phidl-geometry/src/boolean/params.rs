//! Parameter types of the boolean functions: devices, joins, divisions, threads.

use phidl_boolean::{Join, OffsetOptions, Options, RunOptions, Shapes, StripCount};
use phidl_core::param::{ConversionError, Param, ParamType};
use phidl_core::prelude::*;
use phidl_macros::Choice;

/// Fewer points than this mean no limit.
const FEWEST_POINTS: usize = 5;

/// One device, several, or none. A placement is given as a cell of its own,
/// [`Reference::to_device`](phidl_core::scene::Reference::to_device); phidl-boolean's functions take placements and bare outlines
/// as they are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DeviceList(pub Vec<Device>);

/// The most points of an operand of a generator. The functions of phidl-boolean take what the machine holds.
const MOST_POINTS: usize = 100_000_000;

impl Shapes for DeviceList {
    /// Refuses more than `MOST_POINTS` before memory is taken for them.
    fn add_to(&self, cell: &mut DeviceBuilder) -> Result<()> {
        let mut points = 0_usize;
        for device in &self.0 {
            points = points.saturating_add(device.flat_counts()?.1);
        }
        Check::new(cell.name()).at_most("number of points, drawn flat,", points, MOST_POINTS)?;
        self.0.add_to(cell)
    }
}

impl From<Device> for DeviceList {
    fn from(device: Device) -> Self {
        Self(vec![device])
    }
}

impl From<&Device> for DeviceList {
    fn from(device: &Device) -> Self {
        device.clone().into()
    }
}

impl<D: Into<Device>> From<Vec<D>> for DeviceList {
    fn from(devices: Vec<D>) -> Self {
        Self(devices.into_iter().map(Into::into).collect())
    }
}

impl<D: Into<Device>, const N: usize> From<[D; N]> for DeviceList {
    fn from(devices: [D; N]) -> Self {
        Self(devices.map(Into::into).into())
    }
}

impl From<()> for DeviceList {
    fn from((): ()) -> Self {
        Self::default()
    }
}

impl Param for DeviceList {
    fn param_type() -> ParamType {
        ParamType::Other("a device, a list of devices, or none")
    }

    fn to_value(&self) -> Value {
        self.0.to_value()
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Null => Ok(Self::default()),
            Value::List(_) => Vec::<Device>::from_value(value).map(Self),
            one => Device::from_value(one).map(Self::from),
        }
    }
}

/// Shape of the corners of a grown shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Choice)]
pub enum JoinName {
    /// The edges are extended until they meet, up to `tolerance` distances from the corner (at least 2).
    #[default]
    Miter,
    /// The corner is cut square, at the distance.
    Bevel,
    /// An arc: `tolerance` points a turn when growing, accurate to a quarter of a grid step when shrinking.
    Round,
}

impl JoinName {
    pub(super) fn growth(self, tolerance: f64, distance: f64, precision: f64, merge_first: bool) -> OffsetOptions {
        let join = match self {
            Self::Miter => Join::Miter { limit: tolerance.max(2.0) },
            Self::Bevel => Join::Bevel,
            Self::Round => Join::Round { points_per_turn: points_per_turn(tolerance, distance / precision) },
        };
        OffsetOptions { join, merge_first }
    }
}

/// Points of a full circle; the distance is in grid steps.
fn points_per_turn(tolerance: f64, distance: f64) -> f64 {
    const FEWEST: f64 = 3.0;
    if distance >= 0.0 {
        return tolerance.max(FEWEST);
    }
    // A chord over the angle a leaves the circle by d (1 - cos(a/2)): here by a quarter of a grid step.
    (PI / (1.0 - 0.25 / distance.abs()).max(-1.0).acos()).max(FEWEST)
}

/// Number of parts of the plane, in x and in y. It changes the run time only, never the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Divisions(pub u32, pub u32);

impl Divisions {
    /// Options of phidl-boolean; `[1, 1]` leaves the division to the engine.
    pub(super) fn options(self, precision: f64, max_points: usize) -> Options<'static> {
        let strips = match (self.0 as usize).saturating_mul(self.1 as usize) {
            1 => StripCount::default(),
            parts => StripCount::Fixed(parts),
        };
        let max_points = Some(max_points).filter(|&most| most >= FEWEST_POINTS);
        Options { precision, max_points, run: RunOptions { strips, ..RunOptions::default() }, ..Options::default() }
    }
}

impl From<u32> for Divisions {
    fn from(each: u32) -> Self {
        Self(each, each)
    }
}

impl From<[u32; 2]> for Divisions {
    fn from([x, y]: [u32; 2]) -> Self {
        Self(x, y)
    }
}

impl From<(u32, u32)> for Divisions {
    fn from((x, y): (u32, u32)) -> Self {
        Self(x, y)
    }
}

impl Param for Divisions {
    fn param_type() -> ParamType {
        ParamType::Other("a count, or one in x and one in y")
    }

    fn to_value(&self) -> Value {
        Value::List(vec![self.0.to_value(), self.1.to_value()])
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let counts = match value.as_list() {
            Some([x, y]) => Self(u32::from_value(x)?, u32::from_value(y)?),
            Some(_) => return Err(ConversionError::new(value, "be one or two counts")),
            None => u32::from_value(value)?.into(),
        };
        if counts.0 == 0 || counts.1 == 0 { Err(ConversionError::new(value, "be at least 1")) } else { Ok(counts) }
    }
}

/// A number of threads, or one for each core: `"all"`, none or 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NumCpu(pub Option<usize>);

impl NumCpu {
    /// One thread for each core.
    pub const ALL: Self = Self(None);
}

impl From<u32> for NumCpu {
    fn from(threads: u32) -> Self {
        Self(Some(threads as usize).filter(|&threads| threads > 0))
    }
}

impl Param for NumCpu {
    fn param_type() -> ParamType {
        ParamType::Other("a count or \"all\"")
    }

    fn to_value(&self) -> Value {
        self.0.map_or_else(|| "all".into(), |threads| threads.to_value())
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        match value {
            Value::Null => Ok(Self::ALL),
            Value::Text(text) if text == "all" => Ok(Self::ALL),
            count => match u32::from_value(count) {
                Ok(threads) => Ok(threads.into()),
                Err(_) => Err(ConversionError::new(value, "be a number of threads or \"all\"")),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_have_the_points_that_the_specification_counts() {
        assert_eq!(points_per_turn(8.0, 1e4), 8.0);
        assert_eq!(points_per_turn(2.0, 1e4), 3.0);
        // An L-shape, shrunk by 1 µm at 1e-4 µm, gets 116 vertices: 111 chords in its one quarter turn.
        assert_eq!((points_per_turn(2.0, -1e4) / 4.0).round(), 111.0);
        assert!(points_per_turn(2.0, -0.1) >= 3.0);
    }

    #[test]
    fn every_spelling_of_a_parameter_is_read() {
        let divisions = |value: Value| Divisions::from_value(&value);
        assert_eq!(divisions(3.into()), Ok(Divisions(3, 3)));
        assert_eq!(divisions(vec![2, 3].into()), Ok(Divisions(2, 3)));
        assert!(divisions(vec![0, 3].into()).is_err() && divisions(vec![1].into()).is_err());
        assert_eq!(NumCpu::from_value(&"all".into()), Ok(NumCpu::ALL));
        assert_eq!(NumCpu::from_value(&2.into()), Ok(NumCpu(Some(2))));
        assert_eq!(DeviceList::from_value(&Value::Null), Ok(DeviceList::default()));
    }

    #[test]
    fn fewer_than_five_points_mean_no_limit() {
        let limit = |most| Divisions(1, 1).options(1e-4, most).max_points;
        assert_eq!((limit(4), limit(5)), (None, Some(5)));
    }
}
