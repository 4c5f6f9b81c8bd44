//! Layer properties from a [`LayerSet`], and back.

use phidl_core::layer::{Layer, LayerSet, NamedLayer};

use super::source::{Source, SourceLayer};
use super::style::{Pattern, brightened};
use super::{LayerView, Lyp, View};
use crate::error::{IoError, Result};
use crate::svg::palette;

/// The patterns that PHIDL gives to layers without one, in turn.
const PHIDL_PATTERNS: [u32; 8] = [2, 5, 9, 17, 19, 22, 33, 38];

/// How much darker PHIDL draws its layers.
const PHIDL_BRIGHTNESS: i16 = -25;

/// The opacity of layers that are read, as in PHIDL.
const ALPHA: f64 = 0.6;

/// How layers are called in a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LypNames {
    /// By their names, with the description in parentheses: `nb - (niobium)`.
    #[default]
    Plain,
    /// As PHIDL does: numbers first (`5/0 - nb - (niobium)`), and a little darker.
    Phidl,
}

/// The layers of a file, and what could not become one.
#[derive(Debug, Clone, PartialEq)]
pub struct LypLayers {
    /// The layers, in the order of the file.
    pub set: LayerSet,
    /// Lines of the list that are no layer of a set.
    pub problems: Vec<LypProblem>,
}

/// A line of the list that is no layer of a set.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LypProblem {
    /// The names of its groups and its own.
    pub path: Vec<String>,
    /// Its source.
    pub source: Source,
    /// Why it is none, as a sentence.
    pub reason: &'static str,
}

impl std::fmt::Display for LypProblem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "layer {:?} with the source {:?} is left out: {}", self.path.join("/"), self.source.0, self.reason)
    }
}

impl Lyp {
    /// The layers of a set in ascending order. A layer without a color gets that of the pictures.
    ///
    /// # Errors
    /// [`IoError::Option`] if a dither is not `I0` to `I46`: a set has no patterns of its own.
    pub fn from_layers(set: &LayerSet, names: LypNames) -> Result<Self> {
        let mut layers: Vec<&NamedLayer> = set.iter().collect();
        layers.sort_by_key(|named| named.layer);
        let mut views = Vec::with_capacity(layers.len());
        let mut patterns = PHIDL_PATTERNS.into_iter().cycle();
        for named in layers {
            views.push(view_of(named, &mut patterns, names)?);
        }
        Ok(Self { tabs: vec![View { layers: views, ..View::default() }], unknown: Vec::new() })
    }

    /// The layers of all tabs as a set. Groups are opened; a member takes what it does not say from its group.
    #[must_use]
    pub fn to_layers(&self) -> LypLayers {
        self.to_layers_named(parts)
    }

    /// As [`Lyp::to_layers`], with another rule for names: from the text of a line and its layer to name and description.
    #[must_use]
    pub fn to_layers_named(&self, naming: impl Fn(&str, Layer) -> (String, String)) -> LypLayers {
        let mut layers = LypLayers { set: LayerSet::new(), problems: Vec::new() };
        for tab in &self.tabs {
            // An explicit stack: the first one is looked at last.
            let mut open: Vec<(&LayerView, LayerView, Vec<String>)> =
                tab.layers.iter().rev().map(|view| (view, view.clone_leaf(), vec![view.name.clone()])).collect();
            while let Some((view, full, path)) = open.pop() {
                if view.members.is_empty() {
                    layers.add(&full, path, &naming);
                    continue;
                }
                for member in view.members.iter().rev() {
                    let path = path.iter().chain([&member.name]).cloned().collect();
                    open.push((member, member.below(&full), path));
                }
            }
        }
        layers
    }
}

impl LayerView {
    /// The same without members.
    fn clone_leaf(&self) -> Self {
        Self {
            name: self.name.clone(),
            source: self.source.clone(),
            members: Vec::new(),
            frame_color: self.frame_color,
            fill_color: self.fill_color,
            pattern: self.pattern,
            line_style: self.line_style,
            width: self.width,
            ..*self
        }
    }

    /// The same with what it does not say taken from its group.
    fn below(&self, group: &Self) -> Self {
        let mut full = self.clone_leaf();
        full.frame_color = full.frame_color.or(group.frame_color);
        full.fill_color = full.fill_color.or(group.fill_color);
        full.pattern = full.pattern.or(group.pattern);
        full.visible &= group.visible;
        full.valid &= group.valid;
        full.fill_brightness = (full.fill_brightness + group.fill_brightness).clamp(-255, 255);
        if let (SourceLayer::Numbers(layer, datatype), SourceLayer::Numbers(group_layer, group_datatype)) =
            (self.source.layer(), group.source.layer())
            && let (Some(layer), Some(datatype)) = (layer.or(group_layer), datatype.or(group_datatype))
        {
            full.source = Source::of(Layer::new(layer, datatype));
        }
        full
    }
}

impl LypLayers {
    fn add(&mut self, view: &LayerView, path: Vec<String>, naming: impl Fn(&str, Layer) -> (String, String)) {
        let layer = match view.source.layer() {
            SourceLayer::Numbers(Some(layer), Some(datatype)) => Ok(Layer::new(layer, datatype)),
            SourceLayer::Numbers(..) => Err("its source stands for several layers"),
            SourceLayer::Name(_) => Err("its source has a name without numbers"),
            SourceLayer::OtherFile => Err("its source is of another file than the first one"),
            SourceLayer::None => Err("it has no source"),
        };
        let layer = match layer {
            Ok(layer) => layer,
            Err(reason) => {
                self.problems.push(LypProblem { path, source: view.source.clone(), reason });
                return;
            }
        };
        let (name, description) = naming(&view.name, layer);
        let mut named = NamedLayer::new(name, layer).description(description);
        named.alpha = ALPHA;
        named.color = view.fill_color.map(|color| brightened(color, view.fill_brightness));
        named.dither = view.pattern.map(|pattern| pattern.to_string());
        if self.set.get(&named.name).is_ok() {
            named.name = format!("{} ({layer})", named.name);
        }
        if self.set.add(named).is_err() {
            let reason = "the set has a layer with its name and numbers";
            self.problems.push(LypProblem { path, source: view.source.clone(), reason });
        }
    }
}

/// Name and description of a line of the list: `NAME`, `NAME - description` or `NAME - (description)`, and PHIDL's
/// `1/0 - ` in front of any of them. A line without a name is called after its layer.
#[must_use]
pub fn parts(text: &str, layer: Layer) -> (String, String) {
    let text = text.trim();
    let rest = text.split_once(" - ").filter(|(head, _)| is_numbers(head)).map_or(text, |(_, rest)| rest);
    if rest.is_empty() {
        return (layer.to_string(), String::new());
    }
    let inside = rest.strip_suffix(')').and_then(|rest| rest.split_once(" - ("));
    match inside.or_else(|| rest.split_once(" - ")) {
        Some((name, description)) => (name.trim().to_owned(), description.to_owned()),
        None => (rest.to_owned(), String::new()),
    }
}

fn is_numbers(text: &str) -> bool {
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    text.trim().split_once('/').is_some_and(|(layer, datatype)| digits(layer) && digits(datatype))
}

fn view_of(named: &NamedLayer, patterns: &mut impl Iterator<Item = u32>, names: LypNames) -> Result<LayerView> {
    let pattern = match &named.dither {
        None => Pattern::BuiltIn(patterns.next().unwrap_or(0)),
        Some(text) => match Pattern::parse(text) {
            Some(pattern @ Pattern::BuiltIn(_)) if text.starts_with('I') => pattern,
            _ => {
                let value = format!("{text:?} of layer {:?}", named.name);
                return Err(IoError::option("dither", value, "be a pattern from I0 to I46"));
            }
        },
    };
    let mut name = named.name.clone();
    if !named.description.is_empty() || named.name.contains(" - ") {
        name = format!("{name} - ({})", named.description);
    }
    let phidl = names == LypNames::Phidl;
    if phidl {
        name = format!("{} - {name}", named.layer);
    }
    let color = Some(named.color.unwrap_or_else(|| palette(named.layer)));
    let brightness = if phidl { PHIDL_BRIGHTNESS } else { 0 };
    Ok(LayerView {
        name,
        source: Source::of(named.layer),
        frame_color: color,
        fill_color: color,
        frame_brightness: brightness,
        fill_brightness: brightness,
        pattern: Some(pattern),
        transparent: named.alpha < 1.0,
        ..LayerView::default()
    })
}
