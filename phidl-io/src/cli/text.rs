//! Documentation comments as plain text, for listings and pages.

/// The first paragraph in one line, without code marks and without what only a browser can follow: `[text](target)` is
/// its text.
#[must_use]
pub fn first_paragraph(markdown: &str) -> String {
    let paragraph = markdown.trim().split("\n\n").next().unwrap_or_default();
    let mut text = paragraph.split_whitespace().collect::<Vec<_>>().join(" ");
    while let Some(joint) = text.find("](") {
        let (Some(open), Some(close)) = (text[..joint].rfind('['), text[joint..].find(')')) else { break };
        text = format!("{}{}{}", &text[..open], &text[open + 1..joint], &text[joint + close + 1..]);
    }
    text.replace('`', "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_are_their_text_and_brackets_stay() {
        let docs = " Takes [0, 1] of an\n [`arc`](fn@crate::arc), see [its docs](x). Or `[a, b]`.\n\nMore.";
        assert_eq!(first_paragraph(docs), "Takes [0, 1] of an arc, see its docs. Or [a, b].");
        assert_eq!(first_paragraph("an end](of no link"), "an end](of no link");
    }
}
