//! The functions that are requested.

use dynamics_symbolic::Function;
use dynamics_symbolic::function::INVERSE_KINEMATICS;

use super::reader::{Read, Reader};
use super::unknown::unknown;
use crate::description::{Asked, Wanted};
use crate::keys::DEFAULT;
use crate::mistake::{self, expected};
use crate::tree::{Key, Kind, Node};

impl Reader<'_> {
    pub(super) fn functions(&mut self, node: &Node) -> Read<Vec<Asked>> {
        let what = self.either(expected::functions(), "an array of names of functions");
        let Kind::List(items) = &node.kind else {
            return Err(self.instead_of(&what, node));
        };
        if items.is_empty() {
            return Err(self.error(node.place, mistake::entry::no_function()));
        }
        let mut asked = Vec::new();
        for item in self.until_full(items) {
            let read = self.visit(item, |reader, item| match &item.kind {
                Kind::Pair(key, parts) => Ok(vec![reader.fused(key, parts)?]),
                Kind::Table(tuples) if !reader.is_call() => {
                    let tuples = tuples.iter();
                    let tuple = |(key, parts): &(Key, Node)| reader.fused(key, parts);
                    let asked = tuples
                        .map(tuple)
                        .map(|tuple| tuple.unwrap_or(Asked::Unreadable));
                    Ok(asked.collect())
                }
                _ => Ok(vec![reader.function(item)?]),
            });
            asked.extend(read.unwrap_or_else(|_| vec![Asked::Unreadable]));
        }
        Ok(asked)
    }

    /// A function, or the default set.
    fn function(&self, node: &Node) -> Read<Asked> {
        if node.word() == Some(DEFAULT) {
            return Ok(Asked::Default(node.place));
        }
        let others = [DEFAULT, INVERSE_KINEMATICS].into_iter();
        let known: Vec<_> = others.chain(function_names()).collect();
        self.wanted(node, &known).map(Asked::One)
    }

    /// `jacobian`, or `jacobian(left_hand)`; in a file as a string.
    fn wanted(&self, node: &Node, known: &[&'static str]) -> Read<Wanted> {
        let mut place = node.place;
        let frame = |what| self.instead_of(&expected::frame_of_function(), what);
        let (word, frame) = match &node.kind {
            Kind::Applied(function, arguments, _) => {
                place = place.to(arguments.place);
                let names: &[Node] = match &arguments.kind {
                    Kind::List(names) => names,
                    _ => &[],
                };
                let of = match names {
                    [name] => self.name_of(name, &expected::frame_of_function()),
                    [_, other, ..] => Err(frame(other)),
                    [] => Err(frame(arguments)),
                };
                (function.plain(), Some(of))
            }
            Kind::Text(text) if !self.is_call() => match applied(text) {
                Some((function, "")) => (function, Some(Err(frame(node)))),
                Some((function, of)) => (function, Some(self.name(of, node.place))),
                None => (text.as_str(), None),
            },
            _ => (self.word(node, &expected::function())?, None),
        };
        let is_inverse = word == INVERSE_KINEMATICS;
        let function = match is_inverse {
            true => Function::ForwardKinematics,
            false => self.function_of_name(word, node, known)?,
        };
        Ok(Wanted {
            function,
            is_inverse,
            frame: frame.transpose()?,
            place,
        })
    }

    fn function_of_name(&self, word: &str, node: &Node, known: &[&'static str]) -> Read<Function> {
        Function::from_name(word).ok_or_else(|| {
            let mistake = if word == DEFAULT {
                mistake::entry::default_for_one()
            } else {
                let unknown = unknown("function", word, known);
                let of_frame = method_of_frame(word).filter(|_| unknown.meant.is_none());
                of_frame.map_or(unknown.mistake, |[function, frame]| {
                    mistake::entry::method_of_frame(function, frame)
                })
            };
            self.error(node.place, mistake)
        })
    }

    /// `control_terms = (mass_matrix, gravity_vector)`
    fn fused(&mut self, key: &Key, parts: &Node) -> Read<Asked> {
        let name = self.rust_name("the name of a tuple", key)?;
        let what = self.either(expected::parts_of(&name), "an array of names of functions");
        let known: Vec<_> = function_names().collect();
        let parts = self.visit(parts, |reader, parts| {
            reader.list(parts, &what, |reader, node| reader.wanted(node, &known))
        });
        Ok(Asked::Fused(name, parts?))
    }
}

/// The function and the frame in `jacobian(left_hand)`, where the frame may stand in quotes.
fn applied(text: &str) -> Option<(&str, &str)> {
    let (function, frame) = text.trim().strip_suffix(')')?.split_once('(')?;
    let frame = frame.trim();
    let unquoted = ['"', '\'']
        .iter()
        .find_map(|&quote| frame.strip_prefix(quote)?.strip_suffix(quote));
    Some((function.trim(), unquoted.unwrap_or(frame)))
}

/// The function and the frame of a method's name, `jacobian_left_hand`.
fn method_of_frame(word: &str) -> Option<[&str; 2]> {
    let of_tip = Function::ALL.into_iter().filter(|f| f.row().of_tip);
    let of_frame = of_tip.filter_map(|function| {
        let (name, rest) = word.split_at_checked(function.name().len())?;
        let frame = rest.strip_prefix('_').filter(|frame| !frame.is_empty())?;
        (name.to_lowercase() == function.name()).then_some([function.name(), frame])
    });
    of_frame.max_by_key(|[function, _]| function.len())
}

/// The names of all functions.
fn function_names() -> impl Iterator<Item = &'static str> {
    Function::ALL.into_iter().map(Function::name)
}
