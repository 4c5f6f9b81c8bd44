//! [`RouteWidth`]: how wide a route is.

use std::collections::BTreeMap;

use crate::port_pair::{PortPair, micrometers};
use phidl_core::Error;
use phidl_core::layer::Layers;
use phidl_core::param::{ConversionError, IntoOption, Param, ParamType, Value};
use phidl_path::{Beside, CrossSection, Profile, Section, Side};

/// The width of a route: one width, a change from one to another, or the sections of a cross-section.
///
/// As a parameter: `2.5`, `(2.5, 1)`, or a [`CrossSection`]. In JSON: `2.5`, `[2.5, 1]`, or
/// `{"sections": [{"width": 1, "offset": 3, "layer": 5, "start_port": "1", "end_port": "2", "name": "rib"}, …]}`. All keys
/// except `width` are optional; `"right_of": "rib"` or `"left_of"` takes the place of an offset, and `{"sine": [1, 2]}` that
/// of a number.
#[derive(Debug, Clone)]
pub enum RouteWidth {
    /// The same everywhere (µm).
    Constant(f64),
    /// From the first width to the second (µm), in proportion to the length.
    Linear(f64, f64),
    /// The sections of a cross-section, whose widths and offsets are numbers or laws between two numbers. Functions cannot
    /// be compared, and the cache of generators compares parameters: [`route_custom`](crate::route_custom) takes them.
    Sections(CrossSection),
}

/// The value of a profile that cannot be a parameter; reading it is an error.
const NO_NUMBER: &str = "a function or a list";

impl PartialEq for RouteWidth {
    fn eq(&self, other: &Self) -> bool {
        self.to_value() == other.to_value()
    }
}

impl RouteWidth {
    /// Whether the parameter value is complete.
    pub(crate) fn is_parameter(&self) -> bool {
        let is_law =
            |profile: &Profile| matches!(profile, Profile::Constant(_) | Profile::Linear(..) | Profile::Sine(..));
        match self {
            Self::Constant(_) | Self::Linear(..) => true,
            Self::Sections(x) => x.sections().iter().all(|s| is_law(&s.width) && is_law(&s.offset)),
        }
    }
}

/// The width of a Manhattan wire (µm): its widest part, or twice the largest distance of an edge from the centerline.
/// Without a width, both ports must have the same one.
pub(crate) fn wire_width(pair: &PortPair<'_>, width: Option<&RouteWidth>) -> Result<f64, Error> {
    match width {
        Some(RouteWidth::Constant(width)) => Ok(*width),
        Some(RouteWidth::Linear(from, to)) => Ok(from.max(*to)),
        Some(RouteWidth::Sections(x)) => x.reach().map(|[left, right]| 2.0 * left.max(right)),
        None => {
            let [own, other] = [pair.port1.width(), pair.port2.width()];
            match (own - other).abs() <= SAME_WIDTH {
                true => Ok(own),
                false => Err(pair.error(format_args!(
                    "port1 is {} wide and port2 {}; give a `width`, or a pair of widths for a taper",
                    micrometers(own),
                    micrometers(other)
                ))),
            }
        }
    }
}

/// Ports whose widths differ by no more than this (µm) are equally wide.
const SAME_WIDTH: f64 = 1e-6;

impl Param for RouteWidth {
    fn param_type() -> ParamType {
        ParamType::Other("number, pair of numbers, or {\"sections\": […]}")
    }

    fn to_value(&self) -> Value {
        match self {
            Self::Constant(width) => (*width).into(),
            Self::Linear(from, to) => vec![*from, *to].into(),
            Self::Sections(x) => {
                let sections: Vec<Value> = x.sections().iter().map(section_value).collect();
                BTreeMap::from([("sections".to_owned(), Value::List(sections))]).into()
            }
        }
    }

    fn from_value(value: &Value) -> Result<Self, ConversionError> {
        let rule = "be a number, a pair of numbers, or {\"sections\": […]}";
        let Value::Map(map) = value else {
            return match profile(value).map_err(|_| ConversionError::new(value, rule))? {
                Profile::Linear(from, to) => Ok(Self::Linear(from, to)),
                other => other.constant().map(Self::Constant).ok_or_else(|| ConversionError::new(value, rule)),
            };
        };
        match (map.len(), map.get("sections").and_then(Value::as_list)) {
            (1, Some(list)) => {
                let read = |(i, v)| section(v).map_err(|mismatch| mismatch.at(format_args!(".sections[{i}]")));
                let sections: Vec<Section> = list.iter().enumerate().map(read).collect::<Result<_, _>>()?;
                Ok(Self::Sections(sections.into_iter().fold(CrossSection::new(), CrossSection::add)))
            }
            _ => Err(ConversionError::new(value, rule)),
        }
    }
}

fn section_value(section: &Section) -> Value {
    let text = |text: &Option<String>| Value::from(text.clone());
    let entries = [
        ("width", profile_value(&section.width)),
        ("offset", profile_value(&section.offset)),
        ("layer", section.layers.to_value()),
        ("start_port", text(&section.start_port)),
        ("end_port", text(&section.end_port)),
        ("name", text(&section.name)),
    ];
    let beside = section.beside.as_ref().map(|beside| (key_of(beside.side), Value::from(beside.section.clone())));
    Value::Map(entries.into_iter().chain(beside).map(|(key, value)| (key.to_owned(), value)).collect())
}

fn profile_value(profile: &Profile) -> Value {
    match profile {
        Profile::Constant(v) => (*v).into(),
        Profile::Linear(from, to) => vec![*from, *to].into(),
        Profile::Sine(from, to) => BTreeMap::from([(SINE.to_owned(), Value::from(vec![*from, *to]))]).into(),
        _ => NO_NUMBER.into(),
    }
}

/// The key of a raised cosine between two numbers.
const SINE: &str = "sine";

/// The key of the section at whose edge another one begins.
fn key_of(side: Side) -> &'static str {
    match side {
        Side::Right => "right_of",
        Side::Left => "left_of",
    }
}

fn section(value: &Value) -> Result<Section, ConversionError> {
    let Value::Map(map) = value else {
        return Err(ConversionError::new(value, "be a section, {\"width\": …, …}"));
    };
    let known = ["width", "offset", "layer", "start_port", "end_port", "name", "right_of", "left_of"];
    if let Some(unknown) = map.keys().find(|key| !known.contains(&key.as_str())) {
        return Err(ConversionError::new(value, format!("be a section, without {unknown:?}")));
    }
    let width = map.get("width").ok_or_else(|| ConversionError::new(value, "have a width"))?;
    let text = |key: &str| match map.get(key) {
        None => Ok(None),
        Some(text) => Option::<String>::from_value(text).map_err(|mismatch| mismatch.at(format_args!(".{key}"))),
    };
    let mut section = Section::new(profile(width).map_err(|mismatch| mismatch.at(".width"))?);
    if let Some(offset) = map.get("offset") {
        section = section.offset(profile(offset).map_err(|mismatch| mismatch.at(".offset"))?);
    }
    if let Some(layer) = map.get("layer") {
        section = section.layer(Layers::from_value(layer).map_err(|mismatch| mismatch.at(".layer"))?);
    }
    for side in [Side::Right, Side::Left] {
        if let Some(other) = text(key_of(side))? {
            section.beside = Some(Beside { section: other, side });
        }
    }
    Ok(Section { start_port: text("start_port")?, end_port: text("end_port")?, name: text("name")?, ..section })
}

/// A number, a pair of numbers, or a raised cosine between two.
fn profile(value: &Value) -> Result<Profile, ConversionError> {
    if let Value::Map(map) = value {
        return match (map.len(), map.get(SINE).and_then(Value::as_list)) {
            (1, Some([from, to])) => Ok(Profile::Sine(f64::from_value(from)?, f64::from_value(to)?)),
            _ => Err(ConversionError::new(value, "be a number, a pair of numbers, or {\"sine\": [from, to]}")),
        };
    }
    match value.as_list() {
        Some([from, to]) => Ok(Profile::Linear(f64::from_value(from)?, f64::from_value(to)?)),
        _ => f64::from_value(value).map(Profile::Constant),
    }
}

macro_rules! from_number {
    ($($number:ty),*) => {$(
        impl From<$number> for RouteWidth {
            fn from(width: $number) -> Self {
                Self::Constant(width.into())
            }
        }

        impl IntoOption<RouteWidth> for $number {
            fn into_option(self) -> Option<RouteWidth> {
                Some(self.into())
            }
        }
    )*};
}

from_number!(f64, f32, i32, u32, i16, u16, i8, u8);

macro_rules! from_rest {
    ($(<$($letter:ident),*> $from:ty, $pattern:pat => $width:expr;)*) => {$(
        impl<$($letter: Into<f64>),*> From<$from> for RouteWidth {
            fn from($pattern: $from) -> Self {
                $width
            }
        }

        impl<$($letter: Into<f64>),*> IntoOption<RouteWidth> for $from {
            fn into_option(self) -> Option<RouteWidth> {
                Some(self.into())
            }
        }
    )*};
}

from_rest! {
    <A, B> (A, B), (from, to) => Self::Linear(from.into(), to.into());
    <N> [N; 2], [from, to] => Self::Linear(from.into(), to.into());
    <> CrossSection, sections => Self::Sections(sections);
    <> &CrossSection, sections => Self::Sections(sections.clone());
    <> Section, section => Self::Sections(section.into());
}

impl IntoOption<Self> for RouteWidth {
    fn into_option(self) -> Option<Self> {
        Some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_width_comes_back_from_its_value() {
        let rib = CrossSection::new()
            .add(Section::new(0.5).layer((1, 3)).ports("1", "2").named("core"))
            .add(Section::new((6, 4)).offset(-2).layer(Layers::NONE))
            .add(Section::new(Profile::Sine(1.0, 2.0)).right_of("core"))
            .add(Section::new(3).left_of("core"));
        for width in [RouteWidth::from(2), (2.5, 1).into(), [1, 2].into(), rib.into()] {
            assert_eq!(RouteWidth::from_value(&width.to_value()).unwrap(), width);
            assert!(width.is_parameter());
        }
    }

    #[test]
    fn a_function_cannot_be_a_parameter() {
        let wavy = RouteWidth::from(Section::new(|t: f64| 1.0 + t));
        assert!(!wavy.is_parameter() && RouteWidth::from_value(&wavy.to_value()).is_err());
    }

    #[test]
    fn an_invalid_width_is_refused_with_its_position() {
        let sections = |section: Value| {
            let map = BTreeMap::from([("sections".to_owned(), Value::List(vec![section]))]);
            RouteWidth::from_value(&map.into()).unwrap_err().to_string()
        };
        let map =
            |key: &str, value: Value| Value::Map([("width".to_owned(), 1.into()), (key.to_owned(), value)].into());
        assert!(sections(map("offset", "left".into())).starts_with(".sections[0].offset is \"left\""));
        assert!(sections(map("depth", 3.into())).ends_with("without \"depth\""));
        assert!(RouteWidth::from_value(&Value::from("wide")).is_err());
        assert!(RouteWidth::from_value(&Value::from(vec![1, 2, 3])).is_err());
    }
}
