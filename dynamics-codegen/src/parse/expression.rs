//! Constant expressions.

use dynamics_symbolic::robot::Value;
use proc_macro2::{Delimiter, Ident, Literal, Span, TokenTree};

use super::cursor::{Cursor, Group};
use super::number::number;
use crate::description::{Elementary, Expr, ExprKind, Operator};
use crate::diagnose::Reported;
use crate::limits::{DEEPEST_VALUE, MOST_TERMS};
use crate::mistake::{Mistake, expected, number as mistake_of_number, size, value as mistake};
use crate::place::Place;
use crate::words;

/// Reads a value, and the `%` behind it where one stands there.
pub(super) fn expression(cursor: &mut Cursor) -> Result<(Expr, Option<Span>), Reported> {
    let value = sum(cursor, &mut Limits::default())?;
    let percent = cursor.take_char('%');
    no_other_operator(cursor)?;
    Ok((value, percent))
}

/// Whether a value may start here.
pub(super) fn at_value(cursor: &Cursor) -> bool {
    cursor.at('-')
        || matches!(
            cursor.peek(),
            Some(TokenTree::Ident(_) | TokenTree::Literal(_))
        )
}

/// The size of a value so far, against the [limits](crate::limits).
#[derive(Default)]
struct Limits {
    depth: usize,
    terms: usize,
}

fn sum(cursor: &mut Cursor, limits: &mut Limits) -> Result<Expr, Reported> {
    let operators = [('+', Operator::Add), ('-', Operator::Sub)];
    chain(cursor, limits, operators, product)
}

fn product(cursor: &mut Cursor, limits: &mut Limits) -> Result<Expr, Reported> {
    let operators = [('*', Operator::Mul), ('/', Operator::Div)];
    chain(cursor, limits, operators, operand)
}

/// Reads operands of one level of precedence, from the left.
fn chain(
    cursor: &mut Cursor,
    limits: &mut Limits,
    operators: [(char, Operator); 2],
    operand: impl Fn(&mut Cursor, &mut Limits) -> Result<Expr, Reported>,
) -> Result<Expr, Reported> {
    let mut left = operand(cursor, limits)?;
    while let Some((_, operator)) = operators.into_iter().find(|(c, _)| at_sign(cursor, *c)) {
        cursor.take();
        if operator == Operator::Mul && at_sign(cursor, '*') {
            return Err(power(cursor, &left));
        }
        let right = operand(cursor, limits)?;
        left = Expr {
            place: left.place.to(right.place),
            kind: ExprKind::Binary(operator, Box::new(left), Box::new(right)),
        };
    }
    Ok(left)
}

/// Whether that sign comes next, and not at the start of a fragment, which is an operand.
fn at_sign(cursor: &Cursor, sign: char) -> bool {
    cursor.at(sign) && !cursor.at_fragment()
}

/// Reports the power `left ** right`, at its second `*`.
fn power(cursor: &mut Cursor, left: &Expr) -> Reported {
    let start = cursor.last;
    cursor.take();
    let base = match &left.kind {
        ExprKind::Name(name) => name,
        _ => "x",
    };
    cursor.error(start.to(cursor.last), mistake::power("**", base))
}

/// Reads an operand with its signs.
fn operand(cursor: &mut Cursor, limits: &mut Limits) -> Result<Expr, Reported> {
    limits.terms += 1;
    if limits.terms > MOST_TERMS {
        return Err(cursor.error(cursor.here(), size::terms_written()));
    }
    limits.depth += 1;
    if limits.depth > DEEPEST_VALUE {
        return Err(cursor.error(cursor.here(), size::nested_value()));
    }
    let expr = match cursor.take_fragment() {
        Some(group) => within(cursor, &group, limits),
        None => plain_operand(cursor, limits),
    };
    limits.depth -= 1;
    expr
}

fn plain_operand(cursor: &mut Cursor, limits: &mut Limits) -> Result<Expr, Reported> {
    if let Some(minus) = cursor.take_char('-') {
        let value = operand(cursor, limits)?;
        return Ok(Expr {
            place: Place::from(minus).to(value.place),
            kind: ExprKind::Minus(Box::new(value)),
        });
    }
    if let Some(group) = cursor.take_group(Delimiter::Parenthesis) {
        return within(cursor, &group, limits);
    }
    match cursor.peek() {
        Some(TokenTree::Literal(literal)) => {
            cursor.take();
            number_literal(cursor, &literal)
        }
        Some(TokenTree::Ident(ident)) => {
            cursor.take();
            name(cursor, ident, limits)
        }
        _ => Err(no_operand(cursor)),
    }
}

fn number_literal(cursor: &mut Cursor, literal: &Literal) -> Result<Expr, Reported> {
    let place = Place::from(literal.span());
    let value = number(literal).map_err(|mistake| cursor.error(place, mistake))?;
    Ok(Expr::known(Value::Rational(value), place))
}

/// Reports what is no operand; a number may lack the digit in front of its point.
fn no_operand(cursor: &mut Cursor) -> Reported {
    let mut ahead = cursor.clone();
    if let (Some(point), Some(TokenTree::Literal(fraction))) = (ahead.take_char('.'), ahead.peek())
        && fraction
            .to_string()
            .starts_with(|c: char| c.is_ascii_digit())
    {
        let place = Place::from(point).to(fraction.span());
        return cursor.error(place, mistake_of_number::leading_point(&fraction));
    }
    cursor.expected(expected::value())
}

/// Reads what starts with a name: the name alone, or a function of a value.
fn name(cursor: &mut Cursor, ident: Ident, limits: &mut Limits) -> Result<Expr, Reported> {
    let word = ident.to_string();
    let place = Place::from(&ident);
    if let Some(mistake) = never_a_value(&word) {
        return Err(cursor.error(place, mistake));
    }
    if cursor.at_path_separator() {
        return Err(path(cursor, place));
    }
    // The parentheses of a fragment may be a part of it: `(1) + 2`.
    let is_call = !cursor.at_fragment();
    if let Some(arguments) = is_call
        .then(|| cursor.take_group(Delimiter::Parenthesis))
        .flatten()
    {
        let Some(of) = function(&word) else {
            return Err(cursor.error(place, mistake::other_function(&word)));
        };
        let argument = within(cursor, &arguments, limits)?;
        return Ok(Expr {
            kind: of(Box::new(argument)),
            place: place.to(arguments.span),
        });
    }
    word_alone(&word, place).map_err(|mistake| cursor.error(place, mistake))
}

/// The value of a word alone, where it can have one.
pub(crate) fn word_alone(word: &str, place: Place) -> Result<Expr, Mistake> {
    if let Some(mistake) = never_a_value(word) {
        return Err(mistake);
    }
    if word == "deg" {
        return Err(mistake::degrees_of_nothing());
    }
    Ok(Expr {
        kind: ExprKind::Name(word.to_owned()),
        place,
    })
}

/// The function of numbers of that name.
pub(super) fn function(word: &str) -> Option<fn(Box<Expr>) -> ExprKind> {
    Some(match word {
        "deg" => ExprKind::Degrees,
        "sqrt" => |x| ExprKind::Function(Elementary::Sqrt, x),
        "sin" => |x| ExprKind::Function(Elementary::Sin, x),
        "cos" => |x| ExprKind::Function(Elementary::Cos, x),
        _ => return None,
    })
}

/// Why that word never starts a value, where it never does.
fn never_a_value(word: &str) -> Option<Mistake> {
    if word == "self" {
        return Some(mistake::with_self());
    }
    construct(word).map(mistake::foreign)
}

/// The thing that a keyword starts, if that is never a value.
fn construct(keyword: &str) -> Option<&'static str> {
    match keyword {
        "if" => Some("`if`"),
        "match" => Some("`match`"),
        "unsafe" | "const" | "async" | "loop" | "while" | "for" => Some("a block"),
        "move" => Some("a closure"),
        "true" | "false" => Some("a truth value"),
        _ => None,
    }
}

fn path(cursor: &mut Cursor, start: Place) -> Reported {
    let mut last = None;
    while cursor.at_path_separator() {
        cursor.take();
        cursor.take();
        last = cursor.take_ident().or(last);
    }
    let place = start.to(cursor.last);
    let Some(last) = last.filter(|_| !cursor.at('!')) else {
        return cursor.error(place, mistake::foreign("a path"));
    };
    let word = last.to_string();
    let mistake = match words::constant_of_std(&word) {
        _ if word == "PI" => mistake::path_to_pi(),
        Some(ours) => mistake::constant_of_std(&word, ours),
        None if matches!(cursor.peek(), Some(TokenTree::Group(_))) => mistake::foreign("a path"),
        None => mistake::constant_by_path(&last),
    };
    cursor.error(place, mistake)
}

/// The value between delimiters.
fn within<'t>(
    cursor: &mut Cursor<'t>,
    group: &Group<'t>,
    limits: &mut Limits,
) -> Result<Expr, Reported> {
    let mut inside = cursor.inside(group);
    if inside.at_end() {
        return Err(cursor.error(group.span, mistake::empty_parentheses()));
    }
    let expr = sum(&mut inside, limits)?;
    no_other_operator(&mut inside)?;
    if !inside.at_end() {
        return Err(inside.expected(expected::end_of_parentheses()));
    }
    // The tokens of a fragment say more than its place in the other macro.
    Ok(if group.is_fragment {
        expr
    } else {
        Expr {
            kind: expr.kind,
            place: group.span.into(),
        }
    })
}

/// Refuses anything that would make more of a value than the operators of this grammar do.
fn no_other_operator(cursor: &mut Cursor) -> Result<(), Reported> {
    match other_operator(cursor) {
        Some(what) => Err(cursor.error(cursor.here(), mistake::foreign(what))),
        None => Ok(()),
    }
}

/// The next thing, if it would make more of a value than the operators of this grammar do.
fn other_operator(cursor: &Cursor) -> Option<&'static str> {
    if cursor.at_fragment() {
        return None;
    }
    Some(match cursor.peek()? {
        TokenTree::Punct(punct) => match punct.as_char() {
            '.' => "a method call",
            '<' | '>' | '=' | '!' => "a comparison",
            '^' => "`^` (a power is a product: `x * x`)",
            '%' => "`%`",
            '&' | '|' => "a logical operator",
            '?' => "`?`",
            _ => return None,
        },
        TokenTree::Group(group) => match group.delimiter() {
            Delimiter::Bracket => "an array index",
            Delimiter::Brace => "a block",
            Delimiter::Parenthesis => "a call",
            Delimiter::None => return None,
        },
        TokenTree::Ident(ident) if ident == "as" => "a cast",
        _ => return None,
    })
}

/// Whether a word in front of this stands alone.
pub(super) fn ends_word(cursor: &Cursor) -> bool {
    let continues = ['+', '-', '*', '/'].into_iter().any(|c| cursor.at(c));
    let is_path = cursor.at_path_separator();
    cursor.at_fragment() || !(continues || is_path || other_operator(cursor).is_some())
}
