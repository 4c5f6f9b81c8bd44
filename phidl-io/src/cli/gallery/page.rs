//! One page with all devices, in one file: drawing, call in Rust, call by name. The page loads nothing else.

use super::plate::Plate;

const STYLE: &str = "\
:root { color-scheme: light dark; --ink: #20262e; --faint: #66717f; --paper: #fff; --card: #f6f7f9; --line: #e0e4e9 }
@media (prefers-color-scheme: dark) {
  :root { --ink: #dde3ea; --faint: #93a0af; --paper: #14181d; --card: #1c2229; --line: #2e3640 }
}
body { margin: 2rem auto; max-width: 84rem; padding: 0 1rem; font: 16px/1.5 sans-serif; color: var(--ink); background: var(--paper) }
h1, h2, h3 { font-weight: 600; line-height: 1.2 }
h2 { margin: 2.5rem 0 1rem; padding-bottom: .3rem; border-bottom: 1px solid var(--line) }
h3 { margin: 0; font: 600 1.05rem monospace }
p { margin: .3rem 0; color: var(--faint) }
nav a { margin-right: .8rem }
a { color: inherit }
.family { display: grid; grid-template-columns: repeat(auto-fill, minmax(26rem, 1fr)); gap: 1rem }
article { min-width: 0; padding: 1rem; background: var(--card); border: 1px solid var(--line); border-radius: .5rem }
.drawing { display: flex; min-height: 12rem; align-items: center; justify-content: center }
pre { margin: .5rem 0 0; overflow-x: auto; font: 13px/1.4 monospace }
";

/// The page.
#[must_use]
pub fn html(plates: &[Plate], command: &str) -> String {
    let mut families: Vec<&str> = plates.iter().map(|plate| plate.family.as_str()).collect();
    families.sort_unstable();
    families.dedup();
    let links: String = families.iter().map(|family| format!("<a href=\"#{family}\">{family}</a>\n")).collect();
    let sections: String = families.iter().map(|family| section(family, plates, command)).collect();
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>phidl: the gallery</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>The gallery</h1>\n\
         <p>{count} devices, each with its example: drawn, called in Rust, and called by name.</p>\n\
         <nav>\n{links}</nav>\n{sections}</body>\n</html>\n",
        count = plates.len()
    )
}

fn section(family: &str, plates: &[Plate], command: &str) -> String {
    let articles: String =
        plates.iter().filter(|plate| plate.family == family).map(|plate| article(plate, command)).collect();
    format!("<section id=\"{family}\">\n<h2>{family}</h2>\n<div class=\"family\">\n{articles}</div>\n</section>\n")
}

fn article(plate: &Plate, command: &str) -> String {
    let Plate { name, summary, figure, rust, json, .. } = plate;
    // In one pair of quotes for the shell; JSON itself has double ones.
    let params = match json.as_str() {
        "{}" => String::new(),
        json => format!(" --params '{}'", json.replace('\'', "'\\''")),
    };
    format!(
        "<article id=\"{name}\">\n<h3>{name}</h3>\n<p>{summary}</p>\n<div class=\"drawing\">\n{figure}</div>\n\
         <pre>{rust}</pre>\n<pre>{command} device {name}{params} --out {name}.svg</pre>\n</article>\n",
        summary = escaped(summary),
        rust = escaped(rust),
        params = escaped(&params),
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
