//! The calls of the command in the READMEs and in the guide, each made in a folder with the files that the guide
//! shows.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::LazyLock;

/// The project's folder.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The guide's chapters and the READMEs.
fn documents() -> Vec<String> {
    let chapters = std::fs::read_dir(root().join("docs/guide/src")).expect("the guide's chapters");
    let mut paths: Vec<PathBuf> = chapters
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect();
    paths.sort();
    paths.extend(["README.md", "dynamics-cli/README.md"].map(|path| root().join(path)));
    let texts = paths.iter().map(std::fs::read_to_string);
    texts.map(|text| text.expect("a document")).collect()
}

/// The blocks of code of a document: what stands behind the opening fence, and the lines.
fn blocks(document: &str) -> Vec<(&str, Vec<&str>)> {
    let mut blocks = Vec::new();
    let mut lines = document.lines();
    while let Some(line) = lines.next() {
        if let Some(language) = line.strip_prefix("```") {
            let block = lines.by_ref().take_while(|line| !line.starts_with("```"));
            blocks.push((language, block.collect()));
        }
    }
    blocks
}

/// A folder with the files that the guide shows: blocks of TOML that have a name, and the robot of the examples. It is
/// filled once, because tests that run side by side read the files.
static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("documents");
    std::fs::create_dir_all(&folder).expect("a folder");
    for document in documents() {
        for (language, lines) in blocks(&document) {
            if let Some(name) = language.strip_prefix("toml,") {
                std::fs::write(folder.join(name), lines.join("\n")).expect("a file");
            }
        }
    }
    let robot = root().join("examples/robots/picker.urdf");
    std::fs::copy(robot, folder.join("picker.urdf")).expect("the robot of the examples");
    // A document's `arm.toml` is any arm.
    std::fs::copy(folder.join("two_link.toml"), folder.join("arm.toml")).expect("the guide's arm");
    folder
});

/// Makes the calls of the command in a document. Returns how many there are.
#[track_caller]
fn call(document: &str, folder: &Path) -> usize {
    let blocks = blocks(document);
    let shell = blocks.iter().filter(|(language, _)| *language == "sh");
    let lines = shell.flat_map(|(_, lines)| lines);
    let calls = lines.filter(|line| line.starts_with("robot-dynamics "));
    let made = calls.map(|line| {
        // The rest of the line is a remark.
        let call = line.split_once('#').map_or(*line, |(call, _)| call);
        let mut command = Command::new(env!("CARGO_BIN_EXE_robot-dynamics"));
        let arguments = call.split_whitespace().skip(1);
        succeed(command.args(arguments).current_dir(folder));
    });
    made.count()
}

#[track_caller]
fn succeed(command: &mut Command) {
    let output = command.output().expect("a program that runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{command:?}\n{errors}");
}

#[test]
fn calls_in_documents_succeed() {
    let documents = documents();
    let calls: usize = documents
        .iter()
        .map(|document| call(document, &FOLDER))
        .sum();
    assert!(calls >= 10, "{calls} calls were found");
}

/// Lines of generated code that a document shows, in blocks that name their file, are lines of it.
#[test]
fn generated_lines_in_documents_are_generated() {
    let folder = &*FOLDER;
    let mut shown = 0;
    for document in &documents() {
        for (language, lines) in blocks(document) {
            let Some(file) = language.strip_prefix("text,") else {
                continue;
            };
            let (name, extension) = file.split_once('.').expect("a file of a language");
            let language = if extension == "rs" { "rust" } else { extension };
            let out = folder.join("shown");
            let mut generate = Command::new(env!("CARGO_BIN_EXE_robot-dynamics"));
            generate.args(["generate", &format!("{name}.toml"), "--lang", language]);
            succeed(generate.arg("--out").arg(&out).current_dir(folder));
            let text = std::fs::read_to_string(out.join(file)).expect("a file that was generated");
            // Documentation has its formulas behind slashes.
            let bare = |line: &str| line.trim().trim_start_matches("/// ").to_owned();
            let generated: Vec<String> = text.lines().map(bare).collect();
            let wanted: Vec<String> = lines.iter().map(|line| bare(line)).collect();
            let mut windows = generated.windows(wanted.len());
            assert!(
                windows.any(|window| window == wanted),
                "{file} has no such lines:\n{}",
                lines.join("\n")
            );
            shown += 1;
        }
    }
    assert!(shown >= 3, "{shown} pieces of generated code were found");
}

/// The programs in C and C++ compile and run.
#[test]
#[ignore = "needs a C compiler: .ci/run runs it"]
fn the_programs_in_c_run() {
    let folder = FOLDER.join("c_program");
    std::fs::create_dir_all(&folder).expect("a folder");
    let arm = "two_link.toml";
    std::fs::copy(folder.join("..").join(arm), folder.join(arm)).expect("the arm");
    let chapter = root().join("docs/guide/src/languages.md");
    let chapter = std::fs::read_to_string(chapter).expect("the chapter");
    let blocks = blocks(&chapter);
    for (language, file) in [("c", "main.c"), ("cpp", "main.cpp")] {
        let program = blocks.iter().find(|(found, _)| *found == language);
        let (_, program) = program.expect("a program");
        std::fs::write(folder.join(file), program.join("\n")).expect("a file");
    }
    assert!(call(&chapter, &folder) >= 6);
    compile(&chapter, &folder);
    succeed(&mut Command::new(folder.join("main")));
    let mut compiler = Command::new("c++");
    compiler.args([
        "-O2",
        "-I",
        "c",
        "main.cpp",
        "c/two_link.c",
        "-o",
        "main_cpp",
    ]);
    succeed(compiler.current_dir(&folder));
    succeed(&mut Command::new(folder.join("main_cpp")));
}

/// The programs of the chapters in Python and MATLAB, which have assertions of their own, with the text that the calls
/// and the C compiler make for them. The tests of the Python package run the programs that use it.
#[test]
#[ignore = "needs numpy, Octave and a C compiler: .ci/run runs it"]
fn programs_in_other_languages_run() {
    let documents = documents();
    let folder = FOLDER.join("programs");
    std::fs::create_dir_all(&folder).expect("a folder");
    for table in ["two_link.toml", "any_rod.toml"] {
        std::fs::copy(folder.join("..").join(table), folder.join(table)).expect("the arm");
    }
    let programs = documents.iter().map(|document| {
        let programs: Vec<_> = programs(document).collect();
        if !programs.is_empty() {
            assert!(call(document, &folder) >= 1);
            compile(document, &folder);
        }
        programs
            .iter()
            .filter(|program| run(program, &folder))
            .count()
    });
    println!("{} programs", programs.sum::<usize>());
}

/// The file of a program, its interpreter, and the call that shows whether the interpreter is installed.
struct Language {
    file: &'static str,
    interpreter: &'static str,
    probe: [&'static str; 2],
}

const PYTHON: Language = Language {
    file: "program.py",
    interpreter: "/usr/bin/python3",
    probe: ["-c", "import numpy"],
};

const OCTAVE: Language = Language {
    file: "program.m",
    interpreter: "octave-cli",
    probe: ["--eval", "1;"],
};

fn programs(document: &str) -> impl Iterator<Item = (Language, Vec<&str>)> {
    let blocks = blocks(document).into_iter();
    // The first program of a chapter imports the package for those behind it.
    let uses_package = document.contains("\nimport robot_dynamics");
    blocks.filter_map(move |(language, lines)| match language {
        "python" if !uses_package => Some((PYTHON, lines)),
        "matlab" => Some((OCTAVE, lines)),
        _ => None,
    })
}

/// Runs the C compiler as a document says.
fn compile(document: &str, folder: &Path) {
    for (language, lines) in blocks(document) {
        let calls = lines.iter().filter(|line| line.starts_with("cc "));
        for call in calls.filter(|_| language == "sh") {
            let arguments = call.split_whitespace().skip(1);
            succeed(Command::new("cc").args(arguments).current_dir(folder));
        }
    }
}

/// Whether a program could be run: it succeeds, or says what is not there.
fn run((language, lines): &(Language, Vec<&str>), folder: &Path) -> bool {
    let Language {
        file,
        interpreter,
        probe,
    } = language;
    let probed = Command::new(interpreter).args(probe).output();
    if !probed.is_ok_and(|output| output.status.success()) {
        return arms::is_left_out(&format!("{interpreter} {probe:?} does not run"));
    }
    // There is no screen.
    let lines = lines.iter().filter(|line| !line.starts_with("plot("));
    let text: Vec<&str> = lines.copied().collect();
    std::fs::write(folder.join(file), text.join("\n")).expect("a file");
    succeed(Command::new(interpreter).arg(file).current_dir(folder));
    true
}
