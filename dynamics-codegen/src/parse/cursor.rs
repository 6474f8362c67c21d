//! A position in the tokens of one group.

use proc_macro2::{Delimiter, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use syn::Lit;
use syn::buffer::{self, TokenBuffer};

use crate::diagnose::{Diagnostics, Reported};
use crate::mistake::expected::Expected;
use crate::mistake::{self, Mistake};
use crate::place::Place;
use crate::tree::{Fault, Found};
use crate::words::{LONGEST, shortened};

/// A position in the tokens of one group.
///
/// Groups without delimiters, in which `macro_rules!` wraps some of its fragments, are looked through:
/// looking does not open them. What a *value* is made of must ask [`Cursor::at_fragment`] first, for
/// there a fragment is one operand, whatever it holds.
#[derive(Clone)]
pub(crate) struct Cursor<'t> {
    rest: buffer::Cursor<'t>,
    /// The token read last, or what came before the first.
    last: Place,
    taken: usize,
    /// The number that was read last, where nothing was read behind it.
    number: Option<Literal>,
    diagnostics: &'t Diagnostics,
}

/// A group of tokens.
#[derive(Clone, Copy)]
pub(crate) struct Group<'t> {
    inside: buffer::Cursor<'t>,
    delimiter: Delimiter,
    span: Span,
}

impl Group<'_> {
    /// The place of the group, delimiters included.
    pub(crate) fn span(&self) -> Span {
        self.span
    }

    /// Whether it is a fragment of another macro.
    pub(crate) fn is_fragment(&self) -> bool {
        self.delimiter == Delimiter::None
    }
}

impl<'t> Cursor<'t> {
    /// The start of `tokens`, which stand behind `before`.
    pub(crate) fn new(
        tokens: &'t TokenBuffer,
        before: impl Into<Place>,
        diagnostics: &'t Diagnostics,
    ) -> Cursor<'t> {
        Cursor {
            rest: tokens.begin(),
            last: before.into(),
            taken: 0,
            number: None,
            diagnostics,
        }
    }

    /// The start of the group's content.
    pub(crate) fn inside(&self, group: &Group<'t>) -> Cursor<'t> {
        Cursor {
            rest: group.inside,
            last: group.span.into(),
            taken: 0,
            number: None,
            diagnostics: self.diagnostics,
        }
    }

    /// Reports an error.
    pub(crate) fn error(&self, at: impl Into<Place>, mistake: Mistake) -> Reported {
        self.diagnostics.error(at, mistake)
    }

    /// How many errors were reported.
    pub(crate) fn errors(&self) -> usize {
        self.diagnostics.count()
    }

    /// Takes out the errors behind so many.
    pub(crate) fn take_errors(&self, behind: usize) -> Vec<Fault> {
        self.diagnostics.take_behind(behind)
    }

    /// The same place, with errors reported elsewhere.
    pub(crate) fn reporting_to(self, diagnostics: &'t Diagnostics) -> Cursor<'t> {
        Cursor {
            diagnostics,
            ..self
        }
    }

    /// Reports that something else stands here, or that the tokens end.
    pub(crate) fn expected(&self, what: Expected) -> Reported {
        let found = self.found();
        self.error(self.here(), mistake::instead(&what, found.as_deref()))
    }

    /// What comes next, as a message shows it.
    pub(crate) fn found(&self) -> Option<String> {
        self.start().1.shown()
    }

    /// Where the next token is, or at the end the last one, and how a message shows it.
    pub(crate) fn start(&self) -> (Place, Found) {
        // A group as a token would be a copy of all that is in it.
        let mut delimiters = DELIMITERS.into_iter();
        let group = delimiters.find_map(|delimiter| Some((delimiter, self.rest.group(delimiter)?)));
        if let Some((delimiter, (_, span, _))) = group.filter(|_| !self.diagnostics.is_full()) {
            return (span.join().into(), Found::Sign(opening(delimiter)));
        }
        let Some(token) = self.peek() else {
            return (self.last, Found::Nothing);
        };
        let place = token.span().into();
        let is_colon = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ':');
        if is_colon && self.at_path_separator() {
            return (place, Found::Sign("`::`"));
        }
        (place, Found::Token(token))
    }

    /// The next token, or, at the end, the last one.
    pub(crate) fn here(&self) -> Place {
        self.start().0
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
    pub(crate) fn at_end(&self) -> bool {
        self.peek().is_none()
    }

    /// The tokens that are left.
    pub(crate) fn rest(&self) -> TokenStream {
        self.rest.token_stream()
    }

    /// The next token; none where there are errors enough.
    pub(crate) fn peek(&self) -> Option<TokenTree> {
        self.next().map(|(token, _)| token)
    }

    /// The next token and what follows it.
    fn next(&self) -> Option<(TokenTree, buffer::Cursor<'t>)> {
        match self.diagnostics.is_full() {
            true => None,
            false => next(self.rest),
        }
    }

    /// Goes to `rest`, behind the token or fragment at `last`.
    fn advance(&mut self, rest: buffer::Cursor<'t>, last: Span) {
        self.rest = rest;
        self.last = last.into();
        self.taken += 1;
        self.number = None;
    }

    /// Takes the next token.
    pub(crate) fn take(&mut self) -> Option<TokenTree> {
        let (token, rest) = self.next()?;
        self.advance(rest, token.span());
        if let TokenTree::Literal(literal) = &token {
            self.number = Some(literal.clone());
        }
        Some(token)
    }

    /// Takes the `,4` behind the `0` of `0,4` where an item starts otherwise, and reports it.
    pub(crate) fn take_decimal_comma(&mut self, at_item: impl Fn(&Self) -> bool) {
        let mut ahead = self.clone();
        if let Some(whole) = self.number.clone()
            && ahead.take_char(',').is_some()
            && let Some(TokenTree::Literal(fraction)) = ahead.peek()
            && [&whole, &fraction].into_iter().all(is_digits)
            && !at_item(&ahead)
        {
            let place = Place::from(whole.span()).to(fraction.span());
            self.error(place, mistake::number::decimal_comma(&whole, &fraction));
            self.take();
            self.take();
        }
    }

    /// Whether a fragment of another macro comes next that holds something.
    pub(crate) fn at_fragment(&self) -> bool {
        self.clone().take_fragment().is_some()
    }

    /// Takes the next fragment of another macro that holds something.
    pub(crate) fn take_fragment(&mut self) -> Option<Group<'t>> {
        let mut rest = self.rest;
        while !self.diagnostics.is_full()
            && let Some((inside, span, behind)) = rest.group(Delimiter::None)
        {
            rest = behind;
            if next(inside).is_some() {
                let span = span.join();
                self.advance(rest, span);
                return Some(Group {
                    inside,
                    delimiter: Delimiter::None,
                    span,
                });
            }
        }
        None
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
        // No more than will be shown, for the rest of the call may come before the next of them.
        let mut ahead = self.clone();
        let mut shown = TokenStream::new();
        while ahead.taken < self.taken + LONGEST
            && !characters.iter().any(|c| ahead.at(*c))
            && let Some(token) = ahead.take()
        {
            shown.extend([token]);
        }
        shortened(&shown.to_string())
    }

    /// The next token where it is an identifier or a keyword.
    pub(crate) fn peek_ident(&self) -> Option<Ident> {
        match self.peek() {
            Some(TokenTree::Ident(ident)) => Some(ident),
            _ => None,
        }
    }

    /// Takes the next token where it is an identifier or a keyword.
    pub(crate) fn take_ident(&mut self) -> Option<Ident> {
        let ident = self.peek_ident()?;
        self.take();
        Some(ident)
    }

    /// Whether the next token is this word.
    pub(crate) fn at_word(&self, word: &str) -> bool {
        self.peek_ident().is_some_and(|ident| ident == word)
    }

    /// Takes the next token where it is this word.
    pub(crate) fn take_word(&mut self, word: &str) -> Option<Ident> {
        self.at_word(word).then(|| self.take_ident())?
    }

    /// Whether the next token is this character.
    pub(crate) fn at(&self, character: char) -> bool {
        matches!(self.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == character)
    }

    /// Takes the next token where it is this character.
    pub(crate) fn take_char(&mut self, character: char) -> Option<Span> {
        self.at(character)
            .then(|| self.take().map(|token| token.span()))?
    }

    /// Takes the next token where it is a group of that kind.
    pub(crate) fn take_group(&mut self, delimiter: Delimiter) -> Option<Group<'t>> {
        if self.diagnostics.is_full() {
            return None;
        }
        let (inside, span, rest) = self.rest.group(delimiter)?;
        let span = span.join();
        self.advance(rest, span);
        Some(Group {
            inside,
            delimiter,
            span,
        })
    }

    /// Takes the next token where it is a group with delimiters; where they are not
    /// those expected, the error is reported and reading goes on.
    pub(crate) fn take_list(
        &mut self,
        delimiter: Delimiter,
        what: Expected,
    ) -> Result<Group<'t>, Reported> {
        if let Some(group) = self.take_group(delimiter) {
            return Ok(group);
        }
        let reported = self.expected(what);
        self.take_any_group().ok_or(reported)
    }

    /// Takes the next token where it is a group with delimiters.
    pub(crate) fn take_any_group(&mut self) -> Option<Group<'t>> {
        DELIMITERS
            .into_iter()
            .find_map(|delimiter| self.take_group(delimiter))
    }

    /// Takes the next token where it is a string.
    pub(crate) fn take_text(&mut self) -> Option<String> {
        let TokenTree::Literal(literal) = self.peek()? else {
            return None;
        };
        let Lit::Str(text) = Lit::new(literal) else {
            return None;
        };
        self.take();
        Some(text.value())
    }

    /// Whether `name:` comes next, the start of a keyed item.
    pub(crate) fn at_key(&self) -> bool {
        let colon = |rest| next_char(rest, ':');
        match self.behind_name().and_then(colon) {
            Some(behind) => colon(behind).is_none(),
            None => false,
        }
    }

    /// Whether a name and that character come next.
    pub(crate) fn at_name_before(&self, character: char) -> bool {
        let behind = self.behind_name();
        behind.is_some_and(|rest| next_char(rest, character).is_some())
    }

    /// What follows the name that comes next.
    fn behind_name(&self) -> Option<buffer::Cursor<'t>> {
        match self.next()? {
            (TokenTree::Ident(_), rest) => Some(rest),
            _ => None,
        }
    }

    /// Whether `::` comes next.
    pub(crate) fn at_path_separator(&self) -> bool {
        match self.next() {
            Some((TokenTree::Punct(punct), rest)) => {
                punct.as_char() == ':'
                    && punct.spacing() == Spacing::Joint
                    && next_char(rest, ':').is_some()
            }
            _ => false,
        }
    }

    /// After an error in an item: skips what is left of it, to behind the next `,` or
    /// `;` or to before the next `name:` or `let`. `taken` is [`Cursor::taken`] at
    /// the item's start.
    pub(crate) fn recover(&mut self, taken: usize) {
        while !self.at_end() {
            let progress = self.taken > taken;
            if progress && (self.at_key() || self.at_word("let")) {
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

/// The next token, looked for through fragments, and what follows it.
fn next(rest: buffer::Cursor) -> Option<(TokenTree, buffer::Cursor)> {
    match rest.token_tree()? {
        (TokenTree::Group(group), _) if group.delimiter() == Delimiter::None => {
            next_in_fragment(rest)
        }
        token => Some(token),
    }
}

/// The next token where a fragment comes next, and what follows it, in the fragment or behind it.
fn next_in_fragment(rest: buffer::Cursor) -> Option<(TokenTree, buffer::Cursor)> {
    if let Some((ident, rest)) = rest.ident() {
        return Some((ident.into(), rest));
    }
    if let Some((punct, rest)) = rest.punct() {
        return Some((punct.into(), rest));
    }
    if let Some((literal, rest)) = rest.literal() {
        return Some((literal.into(), rest));
    }
    if let Some((lifetime, rest)) = rest.lifetime() {
        let mut quote = Punct::new('\'', Spacing::Joint);
        quote.set_span(lifetime.span());
        return Some((quote.into(), rest));
    }
    DELIMITERS.into_iter().find_map(|delimiter| {
        let (inside, span, rest) = rest.group(delimiter)?;
        let mut group = proc_macro2::Group::new(delimiter, inside.token_stream());
        group.set_span(span.join());
        Some((group.into(), rest))
    })
}

/// The delimiters that can be seen.
const DELIMITERS: [Delimiter; 3] = [Delimiter::Parenthesis, Delimiter::Bracket, Delimiter::Brace];

/// What follows that character where it comes next.
fn next_char(rest: buffer::Cursor, character: char) -> Option<buffer::Cursor> {
    let (punct, rest) = rest.punct()?;
    (punct.as_char() == character).then_some(rest)
}

fn is_digits(literal: &Literal) -> bool {
    literal.to_string().chars().all(|c| c.is_ascii_digit())
}

/// The start of a group, as a message shows it.
fn opening(delimiter: Delimiter) -> &'static str {
    match delimiter {
        Delimiter::Parenthesis => "`(`",
        Delimiter::Brace => "`{`",
        Delimiter::Bracket => "`[`",
        Delimiter::None => "nothing",
    }
}
