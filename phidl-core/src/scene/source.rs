//! [`Source`]: the generator of a cell and its parameters.

use crate::param::Value;
use crate::runtime::{GeneratorInfo, ParamValues, registry};

/// The generator of a finished cell with every parameter it was called with.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// The name of the generator, as registered.
    pub generator: &'static str,
    /// The path of its module.
    pub module: &'static str,
    /// The version of its crate.
    pub version: &'static str,
    /// Every parameter in the generator's order, by its registered name.
    pub params: ParamValues,
}

impl Source {
    /// The generator, if it is linked into this program.
    #[must_use]
    pub fn info(&self) -> Option<&'static GeneratorInfo> {
        registry::all().find(|info| (info.module, info.name) == (self.module, self.generator))
    }

    /// The name for the cell in a file, if its generator has a template for it: `snspd_W0p08_P0p16` for
    /// `#[device(cell_name = "snspd_W{wire_width}_P{wire_pitch}")]`. `None` also if a parameter in the template has a value
    /// without a short form, such as a device.
    #[must_use]
    pub fn cell_name(&self) -> Option<String> {
        fill(self.info()?.cell_name?, &self.params)
    }
}

/// The template with the short forms of the values in place of the names in braces.
fn fill(template: &str, params: &[(&'static str, Value)]) -> Option<String> {
    let mut parts = template.split('{');
    let mut name = parts.next()?.to_owned();
    for part in parts {
        let (param, rest) = part.split_once('}')?;
        let (_, value) = params.iter().find(|(name, _)| *name == param)?;
        name.push_str(&value.short()?);
        name.push_str(rest);
    }
    Some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_template_is_filled_with_the_short_forms_of_values() {
        let params = [("width", Value::from(0.08)), ("shift", (-3).into()), ("cell", Value::Null)];
        let filled = |template| fill(template, &params);
        assert_eq!(filled("W{width}_S{shift}").as_deref(), Some("W0p08_Sm3"));
        assert_eq!(filled("{width}"), Some("0p08".to_owned()));
        assert_eq!(filled("all_alike"), Some("all_alike".to_owned()));
        assert_eq!((filled("{cell}"), filled("{height}"), filled("{width")), (None, None, None));
    }
}
