//! The listing of a program by `objdump`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::process::Command;

/// The instructions of each function.
pub(crate) struct Listing(BTreeMap<String, Vec<String>>);

/// Calls of a function beside its arithmetic: panics, and the report of a singular mass matrix, which is in double
/// precision.
const APART: [&str; 4] = [
    "panic",
    "relative_pivot",
    "core::slice::index",
    "core::option",
];

impl Listing {
    /// The listing of a program. If the tool is missing or the processor is another one, it is none, and a line says
    /// so.
    pub(crate) fn of_program(program: &Path) -> Option<Listing> {
        if !cfg!(target_arch = "x86_64") {
            println!("left out: only instructions of x86-64 are known to the test");
            return None;
        }
        let tool = Command::new("objdump")
            .args(["--disassemble", "--no-show-raw-insn"])
            .arg(program)
            .output();
        let Ok(tool) = tool else {
            println!("left out: there is no objdump");
            return None;
        };
        Some(Listing::of(&String::from_utf8_lossy(&tool.stdout)))
    }

    /// The listing in lines such as `0000000000012340 <name>:` and `12344: addsd %xmm0,%xmm1`, a tab behind the colon.
    pub(crate) fn of(text: &str) -> Listing {
        let mut functions = BTreeMap::<String, Vec<String>>::new();
        let mut current = String::new();
        for line in text.lines() {
            let header = line
                .strip_suffix(">:")
                .and_then(|line| line.split_once('<'));
            if let Some((_, name)) = header {
                current = name.to_owned();
            } else if let Some((_, instruction)) = line.split_once(":\t") {
                let function = functions.entry(current.clone()).or_default();
                function.push(instruction.to_owned());
            }
        }
        Listing(functions)
    }

    /// The listing in a compiler's assembly for ARM: labels, and lines such as `bl name`.
    pub(crate) fn of_assembly(text: &str) -> Listing {
        let mut functions = BTreeMap::<String, Vec<String>>::new();
        let mut current = String::new();
        for line in text.lines() {
            match line.strip_suffix(':') {
                // Labels that begin with a dot are places in a function.
                Some(label) if !label.starts_with(['.', '\t']) => label.clone_into(&mut current),
                _ => {
                    let function = functions.entry(current.clone()).or_default();
                    let mut words = line.split_whitespace();
                    function.push(match (words.next(), words.next(), words.next()) {
                        // As `objdump` writes it.
                        (Some(branch), Some(name), None) if branch.starts_with('b') => {
                            format!("call <{name}>")
                        }
                        _ => line.to_owned(),
                    });
                }
            }
        }
        Listing(functions)
    }

    /// The functions in whose names `name` is, and all that these call.
    pub(crate) fn reached_from(&self, name: &str) -> Vec<(&str, &[String])> {
        let is_first = |other: &&String| other.contains(name);
        let mut waiting: Vec<&String> = self.0.keys().filter(is_first).collect();
        let (mut seen, mut reached) = (BTreeSet::new(), Vec::new());
        while let Some(name) = waiting.pop() {
            if !seen.insert(name) || APART.iter().any(|apart| name.contains(apart)) {
                continue;
            }
            let instructions = &self.0[name];
            reached.push((name.as_str(), &instructions[..]));
            let targets = instructions.iter().filter_map(|line| target(line));
            waiting.extend(targets.filter_map(|name| Some(self.0.get_key_value(name)?.0)));
        }
        reached
    }

    /// The functions that the one in whose name `name` is calls, in the order of the calls.
    pub(crate) fn called_by(&self, name: &str) -> Vec<&str> {
        let mut functions = self.0.iter().filter(|(other, _)| other.contains(name));
        let (_, instructions) = functions.next().expect(name);
        let calls = instructions.iter().filter(|line| line.starts_with("call"));
        calls.filter_map(|line| target(line)).collect()
    }

    /// The instructions of a kind in a function and in what it calls.
    #[track_caller]
    pub(crate) fn of_kind(&self, function: &str, is_of_kind: impl Fn(&str) -> bool) -> Vec<&str> {
        let reached = self.reached_from(function);
        assert!(!reached.is_empty(), "{function} is not in the listing");
        let all = reached.iter().flat_map(|(_, instructions)| *instructions);
        all.map(String::as_str)
            .filter(|line| is_of_kind(line))
            .collect()
    }

    /// That no instruction of a kind is in a function, nor in what it calls.
    #[track_caller]
    pub(crate) fn assert_free(&self, function: &str, is_of_kind: impl Fn(&str) -> bool) {
        let found = self.of_kind(function, is_of_kind);
        assert!(found.is_empty(), "{function} reaches {found:?}");
    }
}

/// The function whose beginning a line calls or jumps to.
fn target(line: &str) -> Option<&str> {
    let leaves = line.starts_with("call") || line.starts_with('j');
    let (_, name) = line.split_once('<').filter(|_| leaves)?;
    name.strip_suffix('>')
}

/// Whether an instruction of x86-64 computes with doubles, or converts from or to them. Instructions that move eight or
/// sixteen bytes have names of doubles too, whatever these hold.
pub(crate) fn is_of_doubles(line: &str) -> bool {
    const ARITHMETIC: [&str; 13] = [
        "add", "sub", "mul", "div", "sqrt", "min", "max", "round", "ucomi", "comi", "fma", "fm",
        "fnm",
    ];
    let name = line.split_whitespace().next().unwrap_or_default();
    let name = name.strip_prefix('v').unwrap_or(name);
    let converts = name.starts_with("cvt") && (name.contains("sd") || name.contains("pd"));
    let ends = name.ends_with("sd") || name.ends_with("pd");
    converts
        || ends
            && ARITHMETIC
                .iter()
                .any(|operation| name.starts_with(operation))
}

/// Whether a line of assembly for ARM with floats of single precision asks for doubles: each operation is a
/// call of a function whose name begins so.
pub(crate) fn is_of_doubles_on_arm(line: &str) -> bool {
    line.contains(".f64") || line.contains("__aeabi_d") || line.contains("2d>")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_in_doubles_is_told_from_moves_and_from_singles() {
        for line in [
            "addsd  %xmm0,%xmm1",
            "vfmadd213pd %ymm0,%ymm1,%ymm2",
            "cvtss2sd %xmm0,%xmm0",
        ] {
            assert!(is_of_doubles(line), "{line}");
        }
        for line in [
            "mulps  %xmm0,%xmm1",
            "movsd  (%rax),%xmm0",
            "vunpcklpd %ymm0,%ymm1,%ymm2",
            "call 10 <add>",
        ] {
            assert!(!is_of_doubles(line), "{line}");
        }
    }

    #[test]
    fn calls_are_followed_on_arm() {
        let text = "first:\n\tvmul.f32\ts0, s0, s1\n.LBB0_1:\n\tbl\tsecond\nsecond:\n\tbl\t__aeabi_f2d\n\tbx\tlr\n";
        let listing = Listing::of_assembly(text);
        let reached = listing.reached_from("first");
        let of_doubles = |lines: &&[String]| lines.iter().any(|line| is_of_doubles_on_arm(line));
        let found: Vec<_> = reached
            .iter()
            .map(|(name, lines)| (*name, of_doubles(lines)))
            .collect();
        assert_eq!(found, [("first", false), ("second", true)]);
    }

    #[test]
    fn calls_are_followed() {
        let text = "0010 <first>:\n  10:\tcall   20 <second>\n\n0020 <second>:\n  20:\taddsd  %xmm0,%xmm1\n\n0030 <third>:\n  30:\tret\n";
        let listing = Listing::of(text);
        let names: Vec<_> = listing
            .reached_from("first")
            .into_iter()
            .map(|(name, _)| name)
            .collect();
        assert_eq!(names, ["first", "second"]);
        assert_eq!(listing.called_by("first"), ["second"]);
    }
}
