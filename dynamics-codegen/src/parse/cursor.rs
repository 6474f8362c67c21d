//! A position in the tokens of one group.

use std::fmt::Display;

use proc_macro2::{Delimiter, Group, Ident, Spacing, Span, TokenStream, TokenTree};

use crate::diagnose::{Diagnostics, Place, Reported};
use crate::words::{LONGEST, shortened};

/// A position in the tokens of one group.
///
/// Groups without delimiters, in which `macro_rules!` wraps some of its fragments,
/// are looked through, except by [`Cursor::take_fragment`].
#[derive(Clone)]
pub(crate) struct Cursor<'d> {
    /// What is left, the next token last.
    rest: Vec<TokenTree>,
    /// The token read last, or what came before the first.
    last: Place,
    taken: usize,
    diagnostics: &'d Diagnostics,
}

impl<'d> Cursor<'d> {
    /// The start of `tokens`, which stand behind `before`.
    pub(crate) fn new(
        tokens: TokenStream,
        before: impl Into<Place>,
        diagnostics: &'d Diagnostics,
    ) -> Cursor<'d> {
        let mut rest: Vec<TokenTree> = tokens.into_iter().collect();
        rest.reverse();
        Cursor {
            rest,
            last: before.into(),
            taken: 0,
            diagnostics,
        }
    }

    /// The start of the group's content.
    pub(crate) fn inside(&self, group: &Group) -> Cursor<'d> {
        Cursor::new(group.stream(), group.span(), self.diagnostics)
    }

    /// Reports an error.
    pub(crate) fn error(&self, at: impl Into<Place>, message: impl Display) -> Reported {
        self.diagnostics.error(at, message)
    }

    /// Reports that something else stands here, or that the tokens end.
    pub(crate) fn expected(&mut self, what: impl Display) -> Reported {
        let at = self.here();
        match self.peek().map(describe) {
            Some(found) => self.error(at, format!("expected {what}, found {found}")),
            None => self.error(at, format!("expected {what}")),
        }
    }

    /// The next token, or, at the end, the last one.
    pub(crate) fn here(&mut self) -> Place {
        let last = self.last;
        self.peek().map_or(last, |token| token.span().into())
    }

    /// The token that was read last.
    pub(crate) fn last(&self) -> Place {
        self.last
    }

    /// How many tokens were taken: what tells whether there was progress.
    pub(crate) fn taken(&self) -> usize {
        self.taken
    }

    /// Whether no token is left.
    pub(crate) fn at_end(&mut self) -> bool {
        self.peek().is_none()
    }

    /// The tokens that are left.
    pub(crate) fn rest(&self) -> TokenStream {
        self.rest.iter().rev().cloned().collect()
    }

    /// The next token; none where there are errors enough.
    pub(crate) fn peek(&mut self) -> Option<&TokenTree> {
        if self.diagnostics.is_full() {
            return None;
        }
        while matches!(self.rest.last(), Some(TokenTree::Group(group)) if is_fragment(group)) {
            if let Some(TokenTree::Group(group)) = self.rest.pop() {
                let content: Vec<TokenTree> = group.stream().into_iter().collect();
                self.rest.extend(content.into_iter().rev());
            }
        }
        self.rest.last()
    }

    /// Takes the next token.
    pub(crate) fn take(&mut self) -> Option<TokenTree> {
        self.peek()?;
        let token = self.rest.pop()?;
        self.last = token.span().into();
        self.taken += 1;
        Some(token)
    }

    /// Takes the next token where it is a group without delimiters.
    pub(crate) fn take_fragment(&mut self) -> Option<Group> {
        match self.rest.last() {
            Some(TokenTree::Group(group)) if is_fragment(group) => {
                let group = group.clone();
                self.rest.pop();
                self.last = group.span().into();
                self.taken += 1;
                Some(group)
            }
            _ => None,
        }
    }

    /// Takes the tokens in front of the next of these characters, or all that are left.
    pub(crate) fn take_until(&mut self, characters: &[char]) -> TokenStream {
        let mut tokens = TokenStream::new();
        while !characters.iter().any(|c| self.at(*c))
            && let Some(token) = self.take()
        {
            tokens.extend([token]);
        }
        tokens
    }

    /// The tokens in front of the next of these characters, as a message shows them.
    pub(crate) fn shown_until(&self, characters: &[char]) -> String {
        let stops = |token: &&TokenTree| characters.iter().any(|c| is_char(Some(token), *c));
        let tokens = self.rest.iter().rev().take_while(|token| !stops(token));
        // No more than will be shown, for the rest of the call may come before the next of them.
        let shown: TokenStream = tokens.take(LONGEST).cloned().collect();
        shortened(&shown.to_string())
    }

    /// The next token where it is an identifier or a keyword.
    pub(crate) fn peek_ident(&mut self) -> Option<&Ident> {
        match self.peek() {
            Some(TokenTree::Ident(ident)) => Some(ident),
            _ => None,
        }
    }

    /// Takes the next token where it is an identifier or a keyword.
    pub(crate) fn take_ident(&mut self) -> Option<Ident> {
        let ident = self.peek_ident()?.clone();
        self.take();
        Some(ident)
    }

    /// Takes the next token where it is this word.
    pub(crate) fn take_word(&mut self, word: &str) -> Option<Ident> {
        self.take_ident_if(|ident| ident == word)
    }

    fn take_ident_if(&mut self, condition: impl Fn(&Ident) -> bool) -> Option<Ident> {
        self.peek_ident()
            .is_some_and(condition)
            .then(|| self.take_ident())?
    }

    /// Whether the next token is this character.
    pub(crate) fn at(&mut self, character: char) -> bool {
        matches!(self.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == character)
    }

    /// Takes the next token where it is this character.
    pub(crate) fn take_char(&mut self, character: char) -> Option<Span> {
        self.at(character)
            .then(|| self.take().map(|token| token.span()))?
    }

    /// Takes the next token where it is a group of that kind.
    pub(crate) fn take_group(&mut self, delimiter: Delimiter) -> Option<Group> {
        match self.peek() {
            Some(TokenTree::Group(group)) if group.delimiter() == delimiter => {
                let group = group.clone();
                self.take();
                Some(group)
            }
            _ => None,
        }
    }

    /// Takes the next token where it is a group with delimiters; where they are not
    /// those expected, the error is reported and reading goes on.
    pub(crate) fn take_list(
        &mut self,
        delimiter: Delimiter,
        what: &str,
    ) -> Result<Group, Reported> {
        if let Some(group) = self.take_group(delimiter) {
            return Ok(group);
        }
        let reported = self.expected(what);
        match self.peek() {
            Some(TokenTree::Group(group)) => {
                let group = group.clone();
                self.take();
                Ok(group)
            }
            _ => Err(reported),
        }
    }

    /// Whether `name:` comes next, the start of a keyed item.
    pub(crate) fn at_key(&mut self) -> bool {
        self.at_name_before(':') && !is_char(self.rest.iter().rev().nth(2), ':')
    }

    /// Whether a name and that character come next.
    pub(crate) fn at_name_before(&mut self, character: char) -> bool {
        self.peek_ident().is_some() && is_char(self.rest.iter().rev().nth(1), character)
    }

    /// Whether `::` comes next.
    pub(crate) fn at_path_separator(&mut self) -> bool {
        matches!(self.peek(), Some(TokenTree::Punct(punct))
            if punct.as_char() == ':' && punct.spacing() == Spacing::Joint)
            && is_char(self.rest.iter().rev().nth(1), ':')
    }

    /// After an error in an item: skips what is left of it, to behind the next `,` or
    /// `;` or to before the next `name:` or `let`. `taken` is [`Cursor::taken`] at
    /// the item's start.
    pub(crate) fn recover(&mut self, taken: usize) {
        while !self.at_end() {
            let progress = self.taken > taken;
            if progress && (self.at_key() || self.peek_ident().is_some_and(|i| i == "let")) {
                return;
            }
            let separator = self.at(',') || self.at(';');
            self.take();
            if separator {
                return;
            }
        }
    }
}

/// The identifier or keyword that the group starts with.
pub(super) fn first_word(group: &Group) -> Option<String> {
    match group.stream().into_iter().next()? {
        TokenTree::Ident(ident) => Some(ident.to_string()),
        TokenTree::Group(group) if is_fragment(&group) => first_word(&group),
        _ => None,
    }
}

fn is_fragment(group: &Group) -> bool {
    group.delimiter() == Delimiter::None
}

fn is_char(token: Option<&TokenTree>, character: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == character)
}

/// The token as a message shows it.
fn describe(token: &TokenTree) -> String {
    match token {
        TokenTree::Group(group) => match group.delimiter() {
            Delimiter::Parenthesis => "`(`".to_owned(),
            Delimiter::Brace => "`{`".to_owned(),
            Delimiter::Bracket => "`[`".to_owned(),
            Delimiter::None => "nothing".to_owned(),
        },
        token => format!("`{}`", shortened(&token.to_string())),
    }
}
