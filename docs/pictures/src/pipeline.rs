//! From a table to code.

use measuring::drawing::{At, Drawing, Letters};

use crate::Picture;

const WIDTH: f64 = 880.0;
const HEIGHT: f64 = 526.0;
/// The left end of each of five columns, and the size of a box.
const COLUMNS: [f64; 5] = [24.0, 199.0, 374.0, 549.0, 724.0];
const BOX: [f64; 2] = [132.0, 62.0];
/// The upper ends of the rows of boxes: those of the macro, the engine, its proof, the results.
const ROWS: [f64; 4] = [46.0, 202.0, 306.0, 432.0];

pub(crate) fn picture() -> Picture {
    let title = "From a table or a URDF file to proven code";
    let mut drawing = Drawing::new(title, [WIDTH, HEIGHT]);
    bands(&mut drawing);
    boxes(&mut drawing);
    arrows(&mut drawing);
    Picture {
        name: "pipeline",
        drawing,
        alternative: ALTERNATIVE.replace('\n', " "),
        documents: &["docs/ARCHITECTURE.md", "docs/README.md"],
    }
}

const ALTERNATIVE: &str = "\
Three stages, from top to bottom. In dynamics-codegen a table in a call is parsed, or a file in TOML, JSON or URDF is
read; both become a tree, the tree a description with places in the source, and validation makes a robot of it or reports
mistakes. In dynamics-symbolic the robot is read as a mechanism of joints on links; derivation makes expressions of it,
simplification a network, and building a program of operations in their order. The proof takes the Lagrangian's textbook
definition from the robot alone, and compares it with the program at a random point modulo a prime. Then the program is
emitted: as Rust, which runs on dynamics-runtime; as C, Python, MATLAB, JavaScript and CasADi, in dynamics-export; or as
a tape for robots known at run time, in dynamics-evaluation.";

fn bands(drawing: &mut Drawing) {
    let bands = [
        (10.0, 120.0, "dynamics-codegen"),
        (148.0, 238.0, "dynamics-symbolic"),
    ];
    for (y, height, name) in bands {
        drawing.rectangle("band", [10.0, y], [WIDTH - 20.0, height], 8.0);
        let letters = Letters::PLAIN.bold().left().ink("faint");
        drawing.text([WIDTH - 22.0, y + 22.0], letters, name);
    }
}

/// A box: its column and row, its name, and one or two lines that explain it.
fn stage(drawing: &mut Drawing, [x, y]: At, [width, height]: [f64; 2], name: &str, more: &[&str]) {
    drawing.rectangle("box", [x, y], [width, height], 6.0);
    let middle = x + 0.5 * width;
    let lines = more.len() as f64;
    let mut at = y + 0.5 * height - 8.0 * lines + 5.0;
    let name_letters = Letters::PLAIN.bold().centred().size(14.0);
    drawing.text([middle, at], name_letters, name);
    for line in more {
        at += 16.0;
        let letters = Letters::PLAIN.centred().size(11.5).ink("faint");
        drawing.text([middle, at], letters, line);
    }
}

fn boxes(drawing: &mut Drawing) {
    let [first, second, third, fourth, fifth] = COLUMNS;
    let [macro_row, engine, proof, results] = ROWS;
    let mut put = |at: At, size, name: &str, more: &[&str]| stage(drawing, at, size, name, more);
    put([first, 22.0], [BOX[0], 44.0], "table", &["in a call"]);
    put([first, 78.0], [BOX[0], 44.0], "file", &["TOML, JSON, URDF"]);
    put([second, macro_row], BOX, "tree", &["words and values"]);
    let words = ["what was written,", "with its places"];
    put([third, macro_row], BOX, "description", &words);
    put([first, engine], BOX, "robot", &["what it means"]);
    put([second, engine], BOX, "mechanism", &["joints on links"]);
    let words = ["a node for each", "rational function"];
    put([third, engine], BOX, "expressions", &words);
    put([fourth, engine], BOX, "network", &["fewer operations"]);
    let words = ["operations", "in their order"];
    put([fifth, engine], BOX, "program", &words);
    let words = ["the textbook definition,", "from the robot alone"];
    let wide = third + BOX[0] - second;
    put([second, proof], [wide, BOX[1]], "Lagrangian", &words);
    let wide = [230.0, 66.0];
    let words = ["methods of a struct,", "run on dynamics-runtime"];
    put([24.0, results], wide, "Rust", &words);
    let words = [
        "C, Python, MATLAB, JavaScript,",
        "CasADi, in dynamics-export",
    ];
    put([325.0, results], wide, "other languages", &words);
    let words = ["robots known at run time,", "in dynamics-evaluation"];
    put([626.0, results], wide, "tape", &words);
}

fn arrows(drawing: &mut Drawing) {
    let verb = Letters::PLAIN.centred().size(11.0);
    let [first, second, third, fourth, fifth] = COLUMNS;
    let middle = |row: f64| row + 0.5 * BOX[1];
    let [macro_row, engine, proof, results] = ROWS;
    let y = middle(macro_row);
    // To the tree.
    let x = first + BOX[0];
    drawing.arrow(
        "ink",
        1.5,
        &[[x, 44.0], [x + 14.0, 44.0], [second, y - 8.0]],
    );
    drawing.arrow(
        "ink",
        1.5,
        &[[x, 100.0], [x + 14.0, 100.0], [second, y + 8.0]],
    );
    // Along the rows.
    let along = [
        (second, third, y, "read"),
        (first, second, middle(engine), "read"),
        (second, third, middle(engine), "derive"),
        (third, fourth, middle(engine), "simplify"),
        (fourth, fifth, middle(engine), "build"),
    ];
    for (from, to, y, word) in along {
        drawing.arrow("ink", 1.5, &[[from + BOX[0], y], [to, y]]);
        drawing.text([0.5 * (from + BOX[0] + to), y - 9.0], verb, word);
    }
    // To the mistakes and to the robot.
    let x = third + 0.5 * BOX[0];
    let turn = 178.0;
    let robot = first + 0.5 * BOX[0];
    let below = macro_row + BOX[1];
    drawing.arrow(
        "ink",
        1.5,
        &[[x, below], [x, turn], [robot, turn], [robot, engine]],
    );
    drawing.text([0.5 * (x + robot), turn - 7.0], verb, "validate");
    drawing.dashed_arrow("red", 1.5, &[[third + BOX[0], y], [fourth, y]]);
    drawing.text(
        [fourth + 8.0, y - 4.0],
        Letters::PLAIN.ink("red").bold(),
        "or mistakes,",
    );
    drawing.text(
        [fourth + 8.0, y + 14.0],
        Letters::PLAIN.ink("red"),
        "each at its place",
    );
    // The proof.
    let y = middle(proof);
    let engine_end = engine + BOX[1];
    drawing.arrow(
        "green",
        2.0,
        &[[robot, engine_end], [robot, y], [second, y]],
    );
    let compared = fifth + 0.3 * BOX[0];
    let right = third + BOX[0];
    drawing.arrow(
        "green",
        2.0,
        &[[right, y], [compared, y], [compared, engine_end]],
    );
    let proof_letters = Letters::PLAIN.ink("green");
    drawing.text(
        [right + 14.0, y - 9.0],
        proof_letters.bold(),
        "prove: equal to the program",
    );
    drawing.text(
        [right + 14.0, y + 18.0],
        proof_letters.size(11.5),
        "at a random point modulo a prime",
    );
    // The results.
    let x = fifth + 0.75 * BOX[0];
    let turn = 408.0;
    drawing.stroke("ink", 1.5, &[[x, engine_end], [x, turn], [741.0, turn]]);
    for [begin, end] in [[440.0, 139.0], [741.0, 440.0], [741.0, 741.0]] {
        let places = [[begin, turn], [end, turn], [end, results]];
        drawing.arrow("ink", 1.5, &places[usize::from(begin == end)..]);
    }
    drawing.text([290.0, turn - 7.0], verb, "emit");
}
