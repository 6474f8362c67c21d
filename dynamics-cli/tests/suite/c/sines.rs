//! The sines that stand in a source, beside those of Rust: alone and in lanes, at angles of any size and at what is none.

use std::fmt::Write as _;
use std::process::Command;

use super::super::calls::{file, folder, has, output, succeed};
use super::Number;

/// Builds that a user may choose: with fused instructions and without, by a compiler that may fuse as it likes.
const BUILDS: [&[&str]; 4] = [
    &["-std=c99", "-O0"],
    &["-std=c99", "-O2"],
    &["-std=gnu11", "-O3", "-march=native", "-ffp-contract=fast"],
    &["-std=gnu99", "-Os", "-march=native"],
];

/// Rods about axes that are askew: the place of the tip reads the sine and the cosine of every angle.
pub(super) fn chain(joints: usize) -> String {
    let mut table =
        "convention = 'modified'\ngravity = [0, 0, 0]\nfunctions = ['forward_kinematics']\n"
            .to_owned();
    for joint in 0..joints {
        let _ = writeln!(
            table,
            "[[joint]]\nname = 'j{joint}'\ntype = 'revolute'\na = 0.3\nalpha = 0.7"
        );
    }
    table
}

/// A rod whose gravity is a sine, and whose energy is a cosine.
const PENDULUM: &str = "convention = 'modified'\ngravity = [1, 0, 0]\nfunctions = ['gravity_vector', \
                        'potential_energy']\nallow = ['odd_gravity']\n[[joint]]\nname = 'pivot'\ntype = 'revolute'\n\
                        mass = 1\ncom = [1, 0, 0]\n";

/// Numbers by turns: of any bits, or whole multiples of a small one around the angles that are not reduced in integers.
fn angles<F: Number>() -> impl Iterator<Item = F> {
    let mut state = 7_u64;
    (0_u64..).map(move |i| {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = state;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        match i % 2 {
            0 => F::of_bits(z),
            _ => F::of((z.cast_signed() >> 11) as f64 * 2.0_f64.powi(-36)),
        }
    })
}

/// The same in C, and a sum of the bits of what is found.
fn program<F: Number>(name: &str, count: usize, values: &str) -> String {
    let (word, bits) = (F::WORD, F::BITS);
    format!(
        "#include \"{name}.c\"\n#include <stdio.h>\n#include <string.h>\n\
         static uint64_t state = 7u, sum = 0u;\n\
         static {word} next(uint64_t i)\n{{\n    uint64_t z = state += 0x9e3779b97f4a7c15u;\n    \
         z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;\n    z = (z ^ z >> 27) * 0x94d049bb133111ebu;\n    z ^= z >> 31;\n    \
         {bits} bits = ({bits})z;\n    {word} x;\n    memcpy(&x, &bits, sizeof x);\n    \
         return i % 2 ? ({word})((double)((int64_t)z >> 11) * 1.4551915228366852e-11) : x;\n}}\n\
         static void add({word} x)\n{{\n    {bits} bits;\n    memcpy(&bits, &x, sizeof bits);\n    \
         sum = (sum ^ (x == x ? bits : 0u)) * 0x100000001b3u;\n}}\n\
         int main(void)\n{{\n    for (uint64_t i = 0; i < {count}u;) {{\n{values}    }}\n    \
         printf(\"%llx\\n\", (unsigned long long)sum);\n    return 0;\n}}\n"
    )
}

/// That sum of Rust's sines and cosines, by turns.
fn expected<F: Number>(count: usize) -> String {
    let sines = angles::<F>()
        .take(count)
        .flat_map(|x| <[F; 2]>::from(x.sin_cos()));
    let bits = sines.map(|x| {
        if x.ratio_to_f64(F::of(1.0)).is_nan() {
            0
        } else {
            x.bits()
        }
    });
    let sum = bits.fold(0_u64, |sum, bits| {
        (sum ^ bits).wrapping_mul(0x100_0000_01b3)
    });
    format!("{sum:x}\n")
}

/// The statements that add sines and cosines of so many angles: the first four are in the lanes of one vector, the others
/// in those of a second one.
fn values_of_lanes(word: &str, lanes: usize, source: &str) -> String {
    let has_two = source.contains("typedef double robot_dynamics_2 ");
    let halves = [
        ("s", "c", lanes.min(4)),
        ("t", "d", lanes.saturating_sub(4)),
    ];
    let halves: Vec<_> = halves
        .into_iter()
        .filter(|(.., count)| *count > 0)
        .collect();
    let mut vectors = String::new();
    let mut arguments: Vec<_> = (0..lanes).map(|k| format!("x[{k}]")).collect();
    for (sines, cosines, count) in &halves {
        let width = if *count <= 2 && has_two { 2 } else { 4 };
        let _ = writeln!(
            vectors,
            "        robot_dynamics_{width} {sines}, {cosines};"
        );
        arguments.extend([sines, cosines].map(|vector| format!("&{vector}")));
    }
    let of_half = |(sines, cosines, count): &(&str, &str, usize)| {
        format!("        for (int k = 0; k < {count}; ++k) add({sines}[k]), add({cosines}[k]);\n")
    };
    let adds: String = halves.iter().map(of_half).collect();
    format!(
        "        {word} x[{lanes}];\n{vectors}        for (int k = 0; k < {lanes}; ++k) x[k] = next(i++);\n        \
         robot_dynamics_sin_cos_{lanes}({});\n{adds}",
        arguments.join(", ")
    )
}

/// Compares the sum of so many angles, in as many lanes as `lanes` says; apart where it says none.
fn assert_sines<F: Number>(lanes: Option<usize>, count: usize, expected: &str) {
    let word = F::WORD;
    let name = lanes.map_or(format!("parts_{word}"), |lanes| {
        format!("lanes_{lanes}_{word}")
    });
    let path = file(
        &format!("{name}.toml"),
        lanes.map_or(PENDULUM.to_owned(), chain),
    );
    let out = folder(&name);
    let to = out.to_string_lossy();
    output(format!(
        "generate {path} --lang c --scalar {word} --out {to}"
    ));
    let values = match lanes {
        None => format!(
            "        const {word} x = next(i++);\n        add(robot_dynamics_sin(x));\n        add(robot_dynamics_cos(x));\n"
        ),
        Some(1) => format!(
            "        {word} s, c;\n        robot_dynamics_sin_cos_1(next(i++), &s, &c);\n        add(s);\n        add(c);\n"
        ),
        Some(lanes) => {
            let source = std::fs::read_to_string(out.join(format!("{name}.c"))).expect("a source");
            values_of_lanes(word, lanes, &source)
        }
    };
    std::fs::write(out.join("main.c"), program::<F>(&name, count, &values)).expect("a file");
    for build in BUILDS {
        let mut command = Command::new("gcc");
        command
            .current_dir(&out)
            .args(build)
            .args(["-Wall", "-Wextra", "-Werror", "main.c", "-o", "sines"]);
        succeed(&mut command);
        let found = succeed(&mut Command::new(out.join("sines")));
        assert_eq!(found, expected, "{name}: {build:?}");
    }
}

/// Angles that one to eight lanes evaluate without a remainder.
const BY_ALL_LANES: usize = 840;

/// Every number of lanes, and the sine and the cosine apart.
fn assert_all<F: Number>(count: usize) {
    if !has("gcc") {
        return;
    }
    let expected = expected::<F>(count);
    for lanes in core::iter::once(None).chain((1..=8).map(Some)) {
        assert_sines::<F>(lanes, count, &expected);
    }
}

#[test]
fn sines_of_double_precision_are_those_of_rust() {
    assert_all::<f64>(20 * BY_ALL_LANES);
}

#[test]
fn sines_of_single_precision_are_those_of_rust() {
    assert_all::<f32>(20 * BY_ALL_LANES);
}

mod release {
    use super::{BY_ALL_LANES, assert_all};

    /// `cargo test --release -p dynamics-cli --test suite c::sines::release -- --ignored`
    #[test]
    #[ignore = "a minute: run before a release"]
    fn sines_at_many_angles_are_those_of_rust() {
        assert_all::<f64>(14_000 * BY_ALL_LANES);
        assert_all::<f32>(14_000 * BY_ALL_LANES);
    }
}
