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
/// looking does not open them. A reader of operands must ask [`Cursor::at_fragment`] first, because there a fragment is
/// one operand, whatever it holds.
#[derive(Clone)]
pub(crate) struct Cursor<'t> {
    rest: buffer::Cursor<'t>,
    /// The token read last, or what came before the first.
    pub(crate) last: Place,
    /// How many tokens were taken, by which progress is seen.
    pub(crate) taken: usize,
    /// Where the number is that was read last, unless something was read behind it.
    number: Option<buffer::Cursor<'t>>,
    diagnostics: &'t Diagnostics,
}

/// A group of tokens.
#[derive(Clone, Copy)]
pub(crate) struct Group<'t> {
    inside: buffer::Cursor<'t>,
    /// The place of the group, delimiters included.
    pub(crate) span: Span,
    /// Whether it is a fragment of another macro.
    pub(crate) is_fragment: bool,
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
            ..*self
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

    /// The next token, as a message shows it.
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
        next(self.open()?).map(|(token, _)| token)
    }

    /// The tokens that are left; none where there are errors enough.
    fn open(&self) -> Option<buffer::Cursor<'t>> {
        (!self.diagnostics.is_full()).then_some(self.rest)
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
        let start = self.open()?;
        let (token, rest) = next(start)?;
        self.advance(rest, token.span());
        self.number = matches!(token, TokenTree::Literal(_)).then_some(start);
        Some(token)
    }

    /// Takes the `,4` behind the `0` of `0,4` where an item starts otherwise, and reports it.
    pub(crate) fn take_decimal_comma(&mut self, at_item: impl Fn(&Self) -> bool) {
        let mut ahead = self.clone();
        if let Some((TokenTree::Literal(whole), _)) = self.number.and_then(next)
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
        let mut rest = self.open()?;
        loop {
            let (inside, span, behind) = rest.group(Delimiter::None)?;
            rest = behind;
            if next(inside).is_some() {
                return Some(self.enter(inside, span.join(), rest, true));
            }
        }
    }

    /// The group with that content, behind which `rest` is.
    fn enter(
        &mut self,
        inside: buffer::Cursor<'t>,
        span: Span,
        rest: buffer::Cursor<'t>,
        is_fragment: bool,
    ) -> Group<'t> {
        self.advance(rest, span);
        Group {
            inside,
            span,
            is_fragment,
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
        self.open()?.ident().map(|(ident, _)| ident)
    }

    /// Takes the next token where it is an identifier or a keyword.
    pub(crate) fn take_ident(&mut self) -> Option<Ident> {
        let (ident, rest) = self.open()?.ident()?;
        self.advance(rest, ident.span());
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

    /// The next token where it is this character, and what follows it.
    fn next_char(&self, character: char) -> Option<(Punct, buffer::Cursor<'t>)> {
        self.open()?
            .punct()
            .filter(|(punct, _)| punct.as_char() == character)
    }

    /// Whether the next token is this character.
    pub(crate) fn at(&self, character: char) -> bool {
        self.next_char(character).is_some()
    }

    /// Takes the next token where it is this character.
    pub(crate) fn take_char(&mut self, character: char) -> Option<Span> {
        let (punct, rest) = self.next_char(character)?;
        self.advance(rest, punct.span());
        Some(punct.span())
    }

    /// Takes the next token where it is a group of that kind.
    pub(crate) fn take_group(&mut self, delimiter: Delimiter) -> Option<Group<'t>> {
        let (inside, span, rest) = self.open()?.group(delimiter)?;
        Some(self.enter(inside, span.join(), rest, false))
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
        let mut ahead = self.clone();
        ahead.take_ident().is_some() && ahead.take_char(':').is_some() && !ahead.at(':')
    }

    /// Whether a name and that character come next.
    pub(crate) fn at_name_before(&self, character: char) -> bool {
        let mut ahead = self.clone();
        ahead.take_ident().is_some() && ahead.at(character)
    }

    /// Whether `::` comes next.
    pub(crate) fn at_path_separator(&self) -> bool {
        let mut ahead = self.clone();
        let is_joint = |(colon, _): (Punct, _)| colon.spacing() == Spacing::Joint;
        self.next_char(':').is_some_and(is_joint) && ahead.take_char(':').is_some() && ahead.at(':')
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
    if let Some((lifetime, rest)) = rest.lifetime() {
        let mut quote = Punct::new('\'', Spacing::Joint);
        quote.set_span(lifetime.span());
        return Some((quote.into(), rest));
    }
    let group = || {
        DELIMITERS.into_iter().find_map(|delimiter| {
            let (inside, span, rest) = rest.group(delimiter)?;
            let mut group = proc_macro2::Group::new(delimiter, inside.token_stream());
            group.set_span(span.join());
            Some((group.into(), rest))
        })
    };
    let ident = rest.ident().map(|(ident, rest)| (ident.into(), rest));
    ident
        .or_else(|| rest.punct().map(|(punct, rest)| (punct.into(), rest)))
        .or_else(|| rest.literal().map(|(literal, rest)| (literal.into(), rest)))
        .or_else(group)
}

/// The delimiters that can be seen.
const DELIMITERS: [Delimiter; 3] = [Delimiter::Parenthesis, Delimiter::Bracket, Delimiter::Brace];

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
