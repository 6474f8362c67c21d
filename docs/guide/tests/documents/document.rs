//! The contents of a document: its headings, its links, its blocks of code.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use crate::prose::Prose;

#[derive(Default)]
pub(crate) struct Document {
    /// The texts behind `#` in links to its headings.
    pub(crate) anchors: Vec<String>,
    /// Where its links and pictures point.
    pub(crate) links: Vec<String>,
    /// Its blocks of code, with their language.
    pub(crate) blocks: Vec<(String, String)>,
    /// Its sentences: paragraphs and entries of lists, without headings, tables and blocks of code.
    pub(crate) sentences: Vec<String>,
}

impl Document {
    pub(crate) fn read(path: &Path) -> Self {
        let text = std::fs::read_to_string(path);
        let text = text.unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let mut document = Document::default();
        let mut heading: Option<String> = None;
        let mut in_block = false;
        let mut prose = Prose::default();
        for event in Parser::new_ext(&text, Options::ENABLE_TABLES) {
            prose.hear(&event);
            match event {
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => document.anchor(heading.take()),
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(language))) => {
                    document.blocks.push((language.into(), String::new()));
                    in_block = true;
                }
                Event::End(TagEnd::CodeBlock) => in_block = false,
                Event::Text(words) | Event::Code(words) if heading.is_some() => {
                    heading = heading.map(|text| text + &words);
                }
                Event::Text(words) if in_block => {
                    if let Some((_, block)) = document.blocks.last_mut() {
                        block.push_str(&words);
                    }
                }
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    document.links.push(dest_url.into());
                }
                Event::Html(tag) | Event::InlineHtml(tag) => document.links.extend(addresses(&tag)),
                _ => {}
            }
        }
        document.sentences = prose.sentences;
        document
    }

    /// A heading's name in links: small letters, digits, `-` for spaces, `-1` behind the second of that name.
    fn anchor(&mut self, heading: Option<String>) {
        let heading = heading.unwrap_or_default().to_lowercase();
        let kept = heading.chars().filter_map(|c| match c {
            ' ' => Some('-'),
            c if c.is_alphanumeric() || c == '-' || c == '_' => Some(c),
            _ => None,
        });
        let name: String = kept.collect();
        let same = |anchor: &&String| anchor.as_str() == name;
        let before = self.anchors.iter().filter(same).count();
        self.anchors.push(match before {
            0 => name,
            n => format!("{name}-{n}"),
        });
    }
}

/// Where the tags of HTML in a text point.
fn addresses(html: &str) -> Vec<String> {
    let attributes = ["src=\"", "href=\""].map(|attribute| html.split(attribute).skip(1));
    let values = attributes.into_iter().flatten();
    values
        .filter_map(|text| Some(text.split_once('"')?.0.to_owned()))
        .collect()
}

/// Documents that were read.
#[derive(Default)]
pub(crate) struct Library(HashMap<PathBuf, Document>);

impl Library {
    pub(crate) fn read(&mut self, path: &Path) -> &Document {
        self.0
            .entry(path.to_owned())
            .or_insert_with(|| Document::read(path))
    }
}
