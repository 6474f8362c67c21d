//! The struct item at the head of a call.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::parse::{ParseStream, Parser};
use syn::punctuated::Punctuated;
use syn::{Attribute, LitBool, Meta, Token, Visibility};

use super::cursor::Cursor;
use crate::call::{Field, Shape, Structure};
use crate::diagnose::Reported;
use crate::mistake::expected::{self, Expected};
use crate::mistake::structure as mistake;
use crate::place::Place;
use crate::words;

/// Reads the struct item. Where it cannot be read, reading goes on behind it.
pub(super) fn structure(cursor: &mut Cursor) -> Option<Structure> {
    let attributes = attributes(cursor);
    let visibility = visibility(cursor);
    let (name, is_struct) = item(cursor).ok()?;
    let mut structure = Structure {
        attributes: attributes.all,
        cfgs: attributes.cfgs,
        has_derive: attributes.has_derive,
        visibility,
        ..Structure::new(name)
    };
    if is_struct {
        let is_generic = skip_generics(cursor);
        read_body(cursor, &mut structure, is_generic);
    } else {
        skip_body(cursor);
    }
    Some(structure)
}

#[derive(Default)]
struct Attributes {
    all: TokenStream,
    cfgs: TokenStream,
    /// The last of the `cfg`s.
    switch: Option<Place>,
    has_derive: bool,
}

fn attributes(cursor: &mut Cursor) -> Attributes {
    let mut attributes = Attributes::default();
    while cursor.at('#') {
        let hash = cursor.take();
        let content = cursor.peek();
        if cursor.take_group(Delimiter::Bracket).is_none() {
            cursor.expected(expected::attribute());
            continue;
        }
        let written = quote!(#hash #content);
        // Brackets that do not hold an attribute are copied as they are: the compiler explains the mistake.
        let read = Attribute::parse_outer.parse2(written.clone());
        for attribute in read.iter().flatten() {
            attributes.note(&attribute.meta, &|meta| quote!(#hash [#meta]));
        }
        attributes.all.extend(written);
    }
    attributes
}

impl Attributes {
    /// Notes what the content of an attribute says about the item, be it under a
    /// condition. `attribute` puts around a part of the content what stands around it.
    fn note(&mut self, meta: &Meta, attribute: &dyn Fn(TokenStream) -> TokenStream) {
        if meta.path().is_ident("derive") {
            self.has_derive = true;
        }
        if let Some(word) = meta.path().get_ident().filter(|word| *word == "cfg") {
            let written = meta.to_token_stream();
            let end = written.clone().into_iter().last();
            let start = Place::from(word);
            self.switch = Some(end.map_or(start, |end| start.to(end.span())));
            self.cfgs.extend(attribute(written));
        }
        if let Meta::List(list) = meta
            && list.path.is_ident("cfg_attr")
            && let Ok((condition, conditional)) = list.parse_args_with(under_condition)
        {
            let attribute = |meta| attribute(quote!(cfg_attr(#condition, #meta)));
            for meta in &conditional {
                self.note(meta, &attribute);
            }
        }
    }
}

/// The arguments of `cfg_attr`: a condition, which may be `true` or `false`, and attributes.
fn under_condition(input: ParseStream) -> syn::Result<(TokenStream, Punctuated<Meta, Token![,]>)> {
    let condition = if input.peek(LitBool) {
        input.parse::<LitBool>()?.to_token_stream()
    } else {
        input.parse::<Meta>()?.to_token_stream()
    };
    input.parse::<Token![,]>()?;
    let conditional = Punctuated::parse_terminated(input)?;
    Ok((condition, conditional))
}

/// Takes `pub`, `pub(crate)` and the like.
fn visibility(cursor: &mut Cursor) -> TokenStream {
    let Some(public) = cursor.take_word("pub") else {
        return TokenStream::new();
    };
    let behind = cursor.peek();
    let restriction = restricts(quote!(#public #behind))
        .then(|| cursor.take())
        .flatten();
    quote!(#public #restriction)
}

/// Whether the parentheses behind `pub` are the `(crate)` of `pub(crate)`, not the type of a tuple field.
fn restricts(public: TokenStream) -> bool {
    let read = |input: ParseStream| {
        let visibility = input.parse()?;
        input.parse::<TokenStream>()?;
        Ok(matches!(visibility, Visibility::Restricted(_)))
    };
    read.parse2(public).unwrap_or(false)
}

/// Takes `struct Name`: the name, and whether that is the name of a struct. Where another word stands in place of
/// `struct`, or none, that is reported and the name, which the user's code knows, is read all the same.
fn item(cursor: &mut Cursor) -> Result<(Ident, bool), Reported> {
    if cursor.take_word("struct").is_some() {
        return Ok((name(cursor, expected::struct_name())?, true));
    }
    let reported = cursor.expected(expected::structure());
    // The table starts here: the struct was forgotten.
    if cursor.at_key() || cursor.at_word("let") {
        return Err(reported);
    }
    let word = cursor.take_ident().ok_or(reported)?;
    // The slip was in what stands in front of it, `pub` perhaps.
    if cursor.take_word("struct").is_some() {
        return Ok((name(cursor, expected::struct_name())?, true));
    }
    let is_slip = words::nearest(&word.to_string(), &["struct"]).is_some();
    let (name, is_struct) = match cursor.take_ident() {
        Some(name) => (name, is_slip),
        None => (word, true),
    };
    if words::is_keyword(&name) {
        return Err(reported);
    }
    Ok((name, is_struct))
}

/// Takes a name that stands in the generated code, where a keyword would be no name.
pub(super) fn name(cursor: &mut Cursor, what: Expected) -> Result<Ident, Reported> {
    let Some(name) = cursor.take_ident() else {
        return Err(cursor.expected(what));
    };
    if !words::is_keyword(&name) {
        return Ok(name);
    }
    let never_raw = ["self", "Self", "super", "crate", "_"];
    let can_be_raw = never_raw.iter().all(|word| name != word);
    Err(cursor.error(&name, mistake::keyword(&what, &name, can_be_raw)))
}

/// Generic parameters and `where` clauses are refused and skipped. Returns whether
/// there were any.
fn skip_generics(cursor: &mut Cursor) -> bool {
    if !cursor.at('<') && !cursor.at_word("where") {
        return false;
    }
    let start = cursor.here();
    while !cursor.at_end() && !cursor.at(';') && !at_body(cursor) {
        cursor.take();
    }
    cursor.error(start.to(cursor.last), mistake::generic());
    true
}

/// Skips the tokens of an item that is no struct.
fn skip_body(cursor: &mut Cursor) {
    while !cursor.at_end() && !cursor.at_key() {
        let is_last = cursor.at(';') || at_body(cursor);
        cursor.take();
        if is_last {
            return;
        }
    }
}

fn at_body(cursor: &Cursor) -> bool {
    matches!(cursor.peek(), Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Bracket)
}

/// Takes what follows the name. The types in a generic struct were refused before.
fn read_body(cursor: &mut Cursor, structure: &mut Structure, is_generic: bool) {
    if cursor.take_char(';').is_some() {
        structure.complete = true;
    } else if let Some(group) = cursor.take_group(Delimiter::Brace) {
        structure.shape = Shape::Named;
        (structure.fields, structure.complete) = fields(cursor.inside(&group), |cursor| {
            named_field(cursor, is_generic)
        });
    } else if let Some(group) = cursor.take_group(Delimiter::Parenthesis) {
        cursor.error(group.span, mistake::tuple());
        cursor.take_char(';');
        structure.shape = Shape::Tuple;
        (structure.fields, _) = fields(cursor.inside(&group), tuple_field);
    } else {
        cursor.expected(expected::struct_body(&structure.name));
        cursor.take_char(',');
    }
}

/// Reads the fields, and whether all of them could be read.
fn fields(
    mut cursor: Cursor,
    field: impl Fn(&mut Cursor) -> Result<Field, Reported>,
) -> (Vec<Field>, bool) {
    let mut fields = Vec::new();
    let mut complete = true;
    while !cursor.at_end() {
        let start = cursor.taken;
        match field(&mut cursor) {
            Ok(field) => fields.push(field),
            Err(_) => {
                complete = false;
                cursor.recover(start);
            }
        }
    }
    (fields, complete)
}

fn named_field(cursor: &mut Cursor, is_generic: bool) -> Result<Field, Reported> {
    let attributes = field_attributes(cursor);
    let visibility = visibility(cursor);
    let name = name(cursor, expected::field())?;
    let has_colon = cursor.take_char(':').is_some();
    let written = if !has_colon && (cursor.at_end() || cursor.at(',')) {
        cursor.error(&name, mistake::field_without_type(&name));
        cursor.take_char(',');
        TokenStream::new()
    } else {
        if !has_colon {
            cursor.expected(expected::colon_after(&name));
        }
        field_type(cursor, &name, is_generic)
    };
    Ok(Field {
        attributes,
        visibility,
        name: Some(name),
        written,
    })
}

fn tuple_field(cursor: &mut Cursor) -> Result<Field, Reported> {
    let attributes = field_attributes(cursor);
    let visibility = visibility(cursor);
    let (written, _) = type_tokens(cursor);
    // A type ends at `;` too.
    if cursor.at(',') || cursor.at(';') {
        cursor.take();
    }
    Ok(Field {
        attributes,
        visibility,
        name: None,
        written,
    })
}

/// The field's attributes. One that could take the field away is refused.
fn field_attributes(cursor: &mut Cursor) -> TokenStream {
    let attributes = attributes(cursor);
    if let Some(switch) = attributes.switch {
        cursor.error(switch, mistake::field_with_cfg());
        return TokenStream::new();
    }
    attributes.all
}

/// Takes the type and the comma behind it. Only `f64` is accepted.
fn field_type(cursor: &mut Cursor, name: &Ident, is_generic: bool) -> TokenStream {
    let (written, place) = type_tokens(cursor);
    let is_f64 = written.to_string() == "f64";
    if written.is_empty() {
        cursor.expected(expected::field_type(name));
    } else if !is_f64 && !is_generic {
        cursor.error(place, mistake::field_of_other_type(name));
    } else if is_f64 && cursor.at('=') {
        let start = cursor.here();
        cursor.take_until(&[',']);
        cursor.error(start.to(cursor.last), mistake::field_with_default(name));
    } else if is_f64 && !cursor.at_end() && !cursor.at(',') {
        cursor.expected(expected::comma_after_field(name));
        cursor.take_char(';');
    }
    cursor.take_char(',');
    written
}

/// The tokens up to where a type ends, and their place. A comma between angle
/// brackets belongs to it.
fn type_tokens(cursor: &mut Cursor) -> (TokenStream, Place) {
    let start = cursor.here();
    let mut tokens = TokenStream::new();
    let mut angles = 0usize;
    let mut is_f64 = false;
    while angles > 0 || !(is_f64 || at_separator(cursor)) {
        let Some(token) = cursor.take() else {
            break;
        };
        // Nothing belongs to `f64` but itself: behind it the next field starts.
        is_f64 = tokens.is_empty() && token.to_string() == "f64";
        match &token {
            TokenTree::Punct(punct) if punct.as_char() == '<' => angles += 1,
            TokenTree::Punct(punct) if punct.as_char() == '>' => angles = angles.saturating_sub(1),
            _ => {}
        }
        tokens.extend([token]);
    }
    (tokens, start.to(cursor.last))
}

fn at_separator(cursor: &Cursor) -> bool {
    cursor.at_end() || cursor.at(',') || cursor.at(';')
}
