//! XML into layer properties.

use roxmltree::{Document, Node, ParsingOptions, TextPos};

use super::source::Source;
use super::style::{self, LineStyle, Pattern};
use super::{CustomLine, CustomPattern, LayerView, Lyp, MOST_LEVELS, UnknownElement, View};
use crate::error::{IoError, Result};

/// Reads a text; `file` is what errors call it.
pub(super) fn parse(text: &str, file: &str) -> Result<Lyp> {
    let fault = |position: TextPos, problem: String| IoError::Xml {
        file: file.into(),
        line: position.row,
        column: position.col,
        problem: problem.into(),
    };
    check_depth(text).map_err(|position| fault(position, too_deep()))?;
    let options = ParsingOptions { allow_dtd: false, ..ParsingOptions::default() };
    let document =
        Document::parse_with_options(text, options).map_err(|error| fault(error.pos(), error.to_string()))?;
    let root = document.root_element();
    let mut parser = Parser { document: &document, unknown: Vec::new() };
    let tabs = match root.tag_name().name() {
        "layer-properties" => parser.view(root).map(|view| vec![view]),
        "layer-properties-tabs" => {
            let mut tabs = Vec::new();
            let mut outcome = Ok(());
            for child in root.children().filter(Node::is_element) {
                match child.tag_name().name() {
                    "layer-properties" => match parser.view(child) {
                        Ok(view) => tabs.push(view),
                        Err(fault) => outcome = Err(fault),
                    },
                    _ => parser.unknown(child),
                }
            }
            outcome.map(|()| tabs)
        }
        other => {
            Err((parser.position(root), format!("the root element is <{other}>, but it must be <layer-properties>")))
        }
    };
    let tabs = tabs.map_err(|(position, problem)| fault(position, problem))?;
    Ok(Lyp { tabs, unknown: parser.unknown })
}

fn too_deep() -> String {
    format!("groups are nested deeper than {MOST_LEVELS} levels")
}

/// Refuses elements that are nested too deep before a tree is built of them. Tags in comments count, which no file has.
fn check_depth(text: &str) -> std::result::Result<(), TextPos> {
    let mut depth = 0_usize;
    for (at, _) in text.match_indices('<') {
        let rest = &text[at + 1..];
        if rest.starts_with(['!', '?']) {
            continue;
        }
        if rest.starts_with('/') {
            depth = depth.saturating_sub(1);
            continue;
        }
        // Up to the next tag only, so that tags without an end cost no more than their length.
        let closed = rest.find(['<', '>']).is_some_and(|end| rest[..end].ends_with('/'));
        depth += usize::from(!closed);
        // Root, tab, the groups, and the elements of the last one.
        if depth > MOST_LEVELS + 8 {
            let before = &text[..at];
            let row = before.matches('\n').count() + 1;
            let column = before.len() - before.rfind('\n').map_or(0, |last| last + 1) + 1;
            let number = |n: usize| u32::try_from(n).unwrap_or(u32::MAX);
            return Err(TextPos { row: number(row), col: number(column) });
        }
    }
    Ok(())
}

type Fault = (TextPos, String);

struct Parser<'a> {
    document: &'a Document<'a>,
    unknown: Vec<UnknownElement>,
}

impl Parser<'_> {
    fn position(&self, node: Node<'_, '_>) -> TextPos {
        self.document.text_pos_at(node.range().start)
    }

    fn unknown(&mut self, node: Node<'_, '_>) {
        let TextPos { row: line, col: column } = self.position(node);
        self.unknown.push(UnknownElement { line, column, name: node.tag_name().name().to_owned() });
    }

    fn view(&mut self, node: Node<'_, '_>) -> std::result::Result<View, Fault> {
        let mut view = View::default();
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "properties" => {
                    let layer = self.layer(child, 1)?;
                    view.layers.push(layer);
                }
                "custom-dither-pattern" => {
                    let pattern = self.pattern(child);
                    view.patterns.push(pattern);
                }
                "custom-line-style" => {
                    let line = self.line(child);
                    view.lines.push(line);
                }
                "name" => text(child).clone_into(&mut view.name),
                _ => self.unknown(child),
            }
        }
        Ok(view)
    }

    fn layer(&mut self, node: Node<'_, '_>, level: usize) -> std::result::Result<LayerView, Fault> {
        if level > MOST_LEVELS {
            return Err((self.position(node), too_deep()));
        }
        let mut view = LayerView::default();
        for child in node.children().filter(Node::is_element) {
            let value = text(child);
            let understood = match child.tag_name().name() {
                "expanded" => flag(value, &mut view.expanded),
                "valid" => flag(value, &mut view.valid),
                "visible" => flag(value, &mut view.visible),
                "transparent" => flag(value, &mut view.transparent),
                "marked" => flag(value, &mut view.marked),
                "xfill" => flag(value, &mut view.xfill),
                "frame-color" => optional(value, style::color, &mut view.frame_color),
                "fill-color" => optional(value, style::color, &mut view.fill_color),
                "frame-brightness" => number(value, -255..=255, &mut view.frame_brightness),
                "fill-brightness" => number(value, -255..=255, &mut view.fill_brightness),
                "dither-pattern" => optional(value, Pattern::parse, &mut view.pattern),
                "line-style" => optional(value, LineStyle::parse, &mut view.line_style),
                "width" => optional(value, |text| text.parse().ok(), &mut view.width),
                "animation" => number(value, 0..=3, &mut view.animation),
                "name" => {
                    full_text(child).clone_into(&mut view.name);
                    true
                }
                "source" => {
                    view.source = Source(value.to_owned());
                    true
                }
                "group-members" => {
                    let member = self.layer(child, level + 1)?;
                    view.members.push(member);
                    true
                }
                _ => {
                    self.unknown(child);
                    true
                }
            };
            if !understood {
                let problem = format!("<{}> is {value:?}, which the format does not have", child.tag_name().name());
                return Err((self.position(child), problem));
            }
        }
        Ok(view)
    }

    fn pattern(&mut self, node: Node<'_, '_>) -> CustomPattern {
        let mut pattern = CustomPattern::default();
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "pattern" => {
                    let lines = child.children().filter(|line| line.tag_name().name() == "line");
                    pattern.rows = lines.map(|line| text(line).to_owned()).collect();
                }
                "order" => pattern.order = text(child).parse().unwrap_or(0),
                "name" => text(child).clone_into(&mut pattern.name),
                _ => self.unknown(child),
            }
        }
        pattern
    }

    fn line(&mut self, node: Node<'_, '_>) -> CustomLine {
        let mut line = CustomLine::default();
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "pattern" => text(child).clone_into(&mut line.pattern),
                "order" => line.order = text(child).parse().unwrap_or(0),
                "name" => text(child).clone_into(&mut line.name),
                _ => self.unknown(child),
            }
        }
        line
    }
}

/// The text of an element, without space around it.
fn text<'a>(node: Node<'a, '_>) -> &'a str {
    full_text(node).trim()
}

fn full_text<'a>(node: Node<'a, '_>) -> &'a str {
    node.text().unwrap_or_default()
}

/// Sets a flag; an empty text leaves it as it is.
fn flag(text: &str, flag: &mut bool) -> bool {
    match text {
        "" => true,
        "true" | "1" => {
            *flag = true;
            true
        }
        "false" | "0" => {
            *flag = false;
            true
        }
        _ => false,
    }
}

/// Sets what may be missing; an empty text leaves it so.
fn optional<T>(text: &str, parse: impl FnOnce(&str) -> Option<T>, value: &mut Option<T>) -> bool {
    if text.is_empty() {
        return true;
    }
    *value = parse(text);
    value.is_some()
}

fn number<T: std::str::FromStr + PartialOrd>(text: &str, range: std::ops::RangeInclusive<T>, value: &mut T) -> bool {
    match text.parse() {
        Ok(number) if range.contains(&number) => {
            *value = number;
            true
        }
        _ => text.is_empty(),
    }
}
