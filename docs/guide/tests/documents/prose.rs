//! The sentences of a document.

use pulldown_cmark::{Event, Tag, TagEnd};

/// Collects sentences from the events of a parser. A span of code is one word.
#[derive(Default)]
pub(crate) struct Prose {
    /// The text of the paragraph, or entry of a list, that is being read.
    block: String,
    /// How many headings, tables, blocks of code and pictures are open: their text is no prose.
    silent: usize,
    pub(crate) sentences: Vec<String>,
}

impl Prose {
    pub(crate) fn hear(&mut self, event: &Event) {
        match event {
            Event::Start(
                Tag::Heading { .. }
                | Tag::Table(_)
                | Tag::CodeBlock(_)
                | Tag::HtmlBlock
                | Tag::Image { .. },
            ) => {
                self.end_block();
                self.silent += 1;
            }
            Event::End(
                TagEnd::Heading(_)
                | TagEnd::Table
                | TagEnd::CodeBlock
                | TagEnd::HtmlBlock
                | TagEnd::Image,
            ) => {
                self.silent -= 1;
            }
            Event::Start(Tag::Paragraph | Tag::Item | Tag::List(_))
            | Event::End(TagEnd::Paragraph | TagEnd::Item) => self.end_block(),
            _ if self.silent > 0 => {}
            Event::Text(text) => self.block.push_str(text),
            Event::Code(_) => self.block.push_str("`code`"),
            Event::SoftBreak | Event::HardBreak => self.block.push(' '),
            _ => {}
        }
    }

    /// A paragraph is cut behind each full stop, question mark or exclamation mark that a space follows.
    fn end_block(&mut self) {
        let block = std::mem::take(&mut self.block);
        let mut from = 0;
        for (at, _) in block.match_indices(['.', '?', '!']) {
            if block[at + 1..].starts_with(' ') {
                self.sentence(&block[from..=at]);
                from = at + 1;
            }
        }
        self.sentence(&block[from..]);
    }

    fn sentence(&mut self, text: &str) {
        if words(text) > 0 {
            self.sentences.push(text.trim().to_owned());
        }
    }
}

/// The number of words: pieces between spaces that have a letter or a digit.
pub(crate) fn words(text: &str) -> usize {
    let is_word = |piece: &&str| piece.contains(char::is_alphanumeric);
    text.split_whitespace().filter(is_word).count()
}

#[test]
fn sentences_of_a_document() {
    let text = "# No sentence\n\nOne `a.b` of 3.5 m. Is this\ntwo?\n\n- three\n- four: **4**\n\n```text\nno. more\n```\n";
    let mut prose = Prose::default();
    pulldown_cmark::Parser::new(text).for_each(|event| prose.hear(&event));
    let found = ["One `code` of 3.5 m.", "Is this two?", "three", "four: 4"];
    assert_eq!(prose.sentences, found);
    assert_eq!(words(found[0]), 5);
}
