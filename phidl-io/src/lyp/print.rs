//! Layer properties into XML.

use std::fmt::{Display, Write as _};

use super::{CustomLine, CustomPattern, LayerView, Lyp, View};

/// The text of a file, in the order of elements that KLayout writes.
pub(super) fn print(lyp: &Lyp) -> String {
    let mut printer = Printer { text: "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n".to_owned(), level: 0 };
    match &lyp.tabs[..] {
        [] => printer.view(&View::default()),
        [view] => printer.view(view),
        tabs => printer.element("layer-properties-tabs", |printer| tabs.iter().for_each(|view| printer.view(view))),
    }
    printer.text
}

struct Printer {
    text: String,
    level: usize,
}

impl Printer {
    fn element(&mut self, name: &str, content: impl FnOnce(&mut Self)) {
        let indent = self.level;
        let _ = writeln!(self.text, "{:indent$}<{name}>", "");
        self.level += 1;
        content(self);
        self.level -= 1;
        let _ = writeln!(self.text, "{:indent$}</{name}>", "");
    }

    fn value(&mut self, name: &str, value: impl Display) {
        let (indent, value) = (self.level, escaped(&value.to_string()));
        let _ = if value.is_empty() {
            writeln!(self.text, "{:indent$}<{name}/>", "")
        } else {
            writeln!(self.text, "{:indent$}<{name}>{value}</{name}>", "")
        };
    }

    /// An element that is empty if there is no value.
    fn optional(&mut self, name: &str, value: Option<impl Display>) {
        match value {
            Some(value) => self.value(name, value),
            None => self.value(name, ""),
        }
    }

    fn view(&mut self, view: &View) {
        self.element("layer-properties", |printer| {
            view.layers.iter().for_each(|layer| printer.layer("properties", layer));
            view.patterns.iter().for_each(|pattern| printer.pattern(pattern));
            view.lines.iter().for_each(|line| printer.line(line));
            printer.value("name", &view.name);
        });
    }

    fn layer(&mut self, name: &str, view: &LayerView) {
        self.element(name, |printer| {
            printer.value("expanded", view.expanded);
            printer.optional("frame-color", view.frame_color);
            printer.optional("fill-color", view.fill_color);
            printer.value("frame-brightness", view.frame_brightness);
            printer.value("fill-brightness", view.fill_brightness);
            printer.optional("dither-pattern", view.pattern);
            printer.optional("line-style", view.line_style);
            printer.value("valid", view.valid);
            printer.value("visible", view.visible);
            printer.value("transparent", view.transparent);
            printer.optional("width", view.width);
            printer.value("marked", view.marked);
            printer.value("xfill", view.xfill);
            printer.value("animation", view.animation);
            printer.value("name", &view.name);
            printer.value("source", &view.source);
            view.members.iter().for_each(|member| printer.layer("group-members", member));
        });
    }

    fn pattern(&mut self, pattern: &CustomPattern) {
        self.element("custom-dither-pattern", |printer| {
            printer.element("pattern", |printer| pattern.rows.iter().for_each(|row| printer.value("line", row)));
            printer.value("order", pattern.order);
            printer.value("name", &pattern.name);
        });
    }

    fn line(&mut self, line: &CustomLine) {
        self.element("custom-line-style", |printer| {
            printer.value("pattern", &line.pattern);
            printer.value("order", line.order);
            printer.value("name", &line.name);
        });
    }
}

/// The text with what XML would take for markup written as entities. What XML 1.0 has no character for is left out.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '\r' => out.push_str("&#13;"),
            '\t' | '\n' => out.push(c),
            '\u{fffe}' | '\u{ffff}' => {}
            c if c < ' ' => {}
            c => out.push(c),
        }
    }
    out
}
