//! Every mistake in a file or on the command line has a message.

#[cfg(target_os = "linux")]
use std::process::Command;

use super::calls::{PENDULUM, assert_has, errors, file, folder, output, refused, run};

#[test]
fn mistakes_are_told_with_their_places() {
    let wrong = file(
        "wrong.toml",
        PENDULUM
            .replace("mass = 2", "mas = 2")
            .replace("a = 1", "a = true"),
    );
    refused(
        format!("show {wrong}"),
        1,
        ["wrong.toml:8:1: ", "wrong.toml:14:5: "],
    );
    // Cells that cannot be read and cells that make no robot are reported together.
    let both = PENDULUM
        .replace("mass = 2", "mass = \"2 kg\"")
        .replace("a = 1", "alpha = 90");
    let message = errors(&["show", &file("both.toml", both)], 1);
    assert_has(
        &message,
        ["a number has no unit, found `kg`", "`--allow odd_angle`"],
    );
    assert!(errors("show nowhere.toml", 1).contains("nowhere.toml:1:1: cannot be read"));
    assert!(errors("show robot.step", 1).contains("robot.step:1:1: "));
    let pendulum = file("right.toml", PENDULUM);
    for subcommand in ["show", "simulate", "page"] {
        refused(
            format!("{subcommand} {pendulum} --functions mass_matrx"),
            2,
            ["mass_matrix"],
        );
    }
    assert!(errors(format!("simulate {pendulum} --from 1"), 2).contains("expected 2"));
    assert!(errors(format!("show {pendulum} --lock knee"), 2).contains("expected JOINT=POSITION"));
    for option in ["--chain base,tip", "--ignore finger", "--round-angles 1e-4"] {
        refused(
            format!("show {pendulum} {option}"),
            2,
            ["is about a URDF file"],
        );
    }
    let empty = errors(&["show", &file("nothing.toml", "")], 1);
    assert!(
        empty.contains("expected \"standard\" or \"modified\"") && !empty.contains("write `"),
        "{empty}"
    );
    errors(&["dance", &pendulum], 2);
    errors(format!("generate {pendulum} --lang cobol"), 2);
}

/// Whatever a file holds, there is a message with its name and no panic.
#[test]
fn files_that_are_no_robots_are_refused() {
    let folder = folder("no_robots.toml");
    let huge = PENDULUM.replace("mass = 2", "mass = 1e400");
    let too_large = PENDULUM
        .replace("mass = 2", "mass = 1e300")
        .replace("com = [0.5", "com = [1e200");
    let many: String = (0..200)
        .map(|k| {
            format!("[[joint]]\nname = \"j{k}\"\ntype = \"revolute\"\nmass = 1\ncom = [1, 0, 0]\n")
        })
        .collect();
    let many = format!("convention = \"modified\"\ngravity = [0, 0, -9.81]\n{many}");
    let deep = format!("gravity = {}{}", "[".repeat(5_000), "]".repeat(5_000));
    let long = "a = ".repeat(2_000_000);
    let utf_16 = PENDULUM.encode_utf16().map(u16::to_le_bytes);
    let files = [
        file("empty.toml", ""),
        file("empty.json", ""),
        file("empty.urdf", ""),
        file("list.json", "[1, 2"),
        file("utf_16.toml", utf_16.flatten().collect::<Vec<_>>()),
        file("latin_1.toml", b"name = \"Armgelenk \xe4\"\n"),
        file("binary.toml", [0xff, 0xfe, 0, 1, 2]),
        file("binary.urdf", [0x89, b'P', b'N', b'G', 0]),
        file("no_robot.urdf", "<sdf/>"),
        file("huge.toml", huge),
        file("too_large.toml", too_large),
        file("many.toml", many),
        file("deep.toml", &deep),
        file("deep.json", &deep),
        file("long.toml", long),
        folder.to_string_lossy().into_owned(),
    ];
    // A file that never ends is not read to its end.
    #[cfg(unix)]
    {
        let endless = std::env::temp_dir().join(format!("endless_{}.toml", std::process::id()));
        std::os::unix::fs::symlink("/dev/zero", &endless).expect("a link");
        let message = errors(&["show", &endless.to_string_lossy()], 1);
        std::fs::remove_file(&endless).expect("the link");
        assert!(message.contains("longer than 4000000 bytes"), "{message}");
    }
    for file in &files {
        for subcommand in ["show", "check", "convert"] {
            let mut arguments = vec![subcommand, file];
            if file.ends_with(".urdf") {
                arguments.extend("--chain base,tip --gravity 0,0,-9.81".split(' '));
            }
            // A table of large numbers can be written as another one.
            if subcommand == "convert" && file.ends_with("too_large.toml") {
                continue;
            }
            let message = errors(&arguments, 1);
            let no_text = match file {
                file if file.ends_with("utf_16.toml") => ":1:1: UTF-16 text, expected UTF-8",
                file if file.ends_with("latin_1.toml") => ":1:19: not UTF-8 text: the byte 0xe4",
                _ => "",
            };
            assert!(message.contains(no_text), "{message}");
            assert_has(&message, [&format!("{file}:"), ": "]);
        }
    }
}

#[test]
fn files_that_cannot_be_written_are_told() {
    let pendulum = file("unwritten.toml", PENDULUM);
    let folder = folder("a_folder");
    let folder = folder.to_string_lossy();
    for arguments in [
        format!("convert {pendulum} --out {folder}"),
        format!("show {pendulum} --out {folder}"),
        format!("simulate {pendulum} --out {folder}"),
    ] {
        refused(&arguments, 1, ["cannot be written"]);
    }
    let inside = format!("{pendulum}/inside");
    refused(
        format!("generate {pendulum} --lang c --out {inside}"),
        1,
        ["cannot be written"],
    );
}

/// A disk that is full is told, where it is standard output too.
#[cfg(target_os = "linux")]
#[test]
fn output_that_is_lost_is_told() {
    let pendulum = file("lost.toml", PENDULUM);
    let mut command = Command::new(env!("CARGO_BIN_EXE_robot-dynamics"));
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
    command.args(["show", &pendulum]);
    command.stdout(full.expect("a disk that is full"));
    let output = command.output().expect("the command");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert_has(&message, ["standard output: cannot be written"]);
}

/// A device has no end, and to open a pipe waits for whoever writes into it.
#[cfg(unix)]
#[test]
fn only_files_are_read() {
    let pendulum = file("only_files.toml", PENDULUM);
    let folder = folder("no_files");
    let path = |name: &str| folder.join(name).to_string_lossy().into_owned();
    let _ = std::fs::remove_file(path("pipe.toml"));
    let pipe = std::process::Command::new("mkfifo")
        .arg(path("pipe.toml"))
        .status();
    assert!(pipe.expect("a program").success());
    std::fs::create_dir_all(path("folder.toml")).expect("a folder");
    for (no_file, reason) in [
        (
            path("pipe.toml"),
            "cannot be read: it is a pipe or a device",
        ),
        (
            path("folder.toml"),
            "cannot be read: it is a folder, expected a file",
        ),
    ] {
        for call in [
            format!("show {no_file}"),
            format!("check {pendulum} --against {no_file}"),
        ] {
            refused(call, 1, [reason]);
        }
    }
    for (no_file, reason) in [
        ("/dev/zero", "it is longer than 100000000 bytes"),
        (&*path("folder.toml"), "Is a directory"),
    ] {
        let message = errors(format!("inverse {pendulum} --waypoints {no_file}"), 1);
        assert_has(
            &message,
            [&format!("{no_file}:1:1: cannot be read: {reason}")],
        );
    }
}

/// Waypoints that another program writes come through a pipe.
#[test]
fn waypoints_are_read_from_a_pipe() {
    let pendulum = file("piped.toml", PENDULUM);
    let waypoints = "0,0,0\n1,1,1\n";
    let of_file = output(&[
        "inverse",
        &pendulum,
        "--waypoints",
        &file("piped.csv", waypoints),
    ]);
    let command = format!(
        "printf '{}' | {} inverse {pendulum} --waypoints /dev/stdin",
        waypoints.replace('\n', "\\n"),
        env!("CARGO_BIN_EXE_robot-dynamics")
    );
    let piped = std::process::Command::new("sh")
        .args(["-c", &command])
        .output();
    let piped = piped.expect("a shell");
    assert_eq!(String::from_utf8_lossy(&piped.stdout), of_file);
}

/// `--out robot.toml` behind `robot.toml` would put what is made of the file in its place.
#[test]
fn files_that_are_read_are_not_written_over() {
    let pendulum = file("read.toml", PENDULUM);
    let path = file("path.csv", "0,0,0\n1,1,1\n");
    let same = pendulum.replace("read.toml", "../files/read.toml");
    let linked = pendulum.replace("read.toml", "hard_link.toml");
    let _ = std::fs::remove_file(&linked);
    std::fs::hard_link(&pendulum, &linked).expect("a hard link");
    for (arguments, out) in [
        (format!("convert {pendulum} --to toml"), &linked),
        (format!("convert {pendulum} --to toml"), &pendulum),
        (format!("page {pendulum}"), &same),
        (format!("inverse {pendulum} --waypoints {path}"), &path),
    ] {
        refused(format!("{arguments} --out {out}"), 2, ["would be lost"]);
    }
    let text = |path| std::fs::read_to_string(path).expect("a file");
    assert_eq!(text(&pendulum), PENDULUM);
    assert_eq!(text(&path), "0,0,0\n1,1,1\n");
}

/// Where the disk is full in the middle of several files, those of before stay as they were. A limit of the size of
/// files stands for the disk: the header is shorter, the source is longer.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_the_files_of_before() {
    let pendulum = file("full.toml", PENDULUM);
    let folder = folder("full");
    let to = folder.to_string_lossy();
    let arguments = format!("generate {pendulum} --lang c --out");
    output(format!("{arguments} {to} --functions mass_matrix"));
    let texts = || ["full.h", "full.c"].map(|name| std::fs::read(folder.join(name)).expect("text"));
    let before = texts();
    let whole = super::calls::folder("whole");
    output(format!("{arguments} {}", whole.to_string_lossy()));
    let [header, source] =
        ["full.h", "full.c"].map(|name| std::fs::metadata(whole.join(name)).expect("a file").len());
    let blocks = header.div_ceil(512);
    assert!(source > 512 * blocks, "{header} {source}");
    let script = format!("trap '' XFSZ; ulimit -f {blocks}; exec \"$@\"");
    let mut command = Command::new("sh");
    command.args(["-c", &script, "sh", env!("CARGO_BIN_EXE_robot-dynamics")]);
    let output = command
        .args(arguments.split(' '))
        .arg(&*to)
        .output()
        .expect("the command");
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("full.c: cannot be written"), "{message}");
    assert!(texts() == before, "a file was written");
    assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 2);
}

/// `--out /dev/stdout` writes behind what the file that standard output goes to has already.
#[cfg(target_os = "linux")]
#[test]
fn standard_output_is_not_replaced() {
    let pendulum = file("appended.toml", PENDULUM);
    let log = folder("files").join("appended.log");
    std::fs::write(&log, "first\n").expect("a file");
    let mut command = Command::new(env!("CARGO_BIN_EXE_robot-dynamics"));
    command.args(["convert", &pendulum, "--to", "json"]);
    command.args(["--out", "/dev/stdout"]);
    let opened = std::fs::OpenOptions::new().append(true).open(&log);
    command.stdout(opened.expect("the file"));
    assert!(command.status().expect("the command").success());
    let text = std::fs::read_to_string(&log).expect("text");
    assert!(
        text.starts_with("first\n{") && text.ends_with("}\n"),
        "{text}"
    );
}

/// Torques, energies and errors that are too large for a number are told, and not written as `NaN`.
#[test]
fn numbers_that_are_too_large_are_told() {
    let pendulum = file("overflow.toml", PENDULUM);
    for (arguments, expected) in [
        (
            format!("inverse {pendulum} --to 1e160,-1e160 --samples 3"),
            "`tau.pivot` at t = 0.5 s is beyond the largest number",
        ),
        (
            format!("simulate {pendulum} --velocity 1e155,0 --samples 3"),
            "the acceleration of joint 1 (pivot) is not finite",
        ),
    ] {
        let message = errors(&arguments, 1);
        assert!(message.contains(expected), "{message}");
        assert!(!message.contains("NaN"), "{message}");
    }
    let heavy = PENDULUM.replace("mass = 2", "mass = 3.5e307\nallow = [\"odd_mass\"]");
    let heavy = file("heavy.toml", heavy);
    refused(
        format!("measure {heavy} --functions inverse_dynamics"),
        1,
        ["`inverse_dynamics` is not finite"],
    );
}

/// The table of a comparison that finds a difference goes where it was to go.
#[test]
fn reports_of_differences_go_to_files_too() {
    let pendulum = file("report.toml", PENDULUM);
    let heavier = file("heavier.toml", PENDULUM.replace("mass = 2", "mass = 2.5"));
    let path = folder("files").join("report.txt");
    let out = path.to_string_lossy();
    let difference = format!("check {pendulum} --against {heavier}");
    let printed = run(&difference).stdout;
    let written = run(format!("{difference} --out {out}"));
    assert_eq!((written.status.code(), written.stdout), (Some(1), vec![]));
    assert_eq!(std::fs::read(&path).expect("a file"), printed);
}

/// Every subcommand with `--out` writes there what it prints without.
#[test]
fn output_goes_to_files() {
    let pendulum = file("out.toml", PENDULUM);
    let path = folder("files").join("out.txt");
    let out = path.to_string_lossy();
    for arguments in [
        format!("show {pendulum}"),
        format!("check {pendulum}"),
        format!("convert {pendulum} --to json"),
        format!("inverse {pendulum} --to 1,1"),
        "completions fish".to_owned(),
    ] {
        let printed = output(&arguments);
        assert!(output(format!("{arguments} --out {out}")).is_empty());
        assert_eq!(std::fs::read_to_string(&path).expect("a file"), printed);
    }
}

/// A mistake on the command line is reported as such, even if it concerns a file.
#[test]
fn mistakes_of_the_command_line_are_none_of_the_file() {
    let pendulum = file("command_line.toml", PENDULUM);
    for (call, expected) in [
        ("show --lock ankle=0", "unknown joint `ankle`"),
        ("show --lock knee=high", "`high`"),
        (
            "show --lock knee=0 --lock knee=1",
            "`knee` has a value already",
        ),
        ("show --field l=0 --field l=1", "`l` has a value already"),
        ("show --gravity 0,0", "`--gravity 0,0`: expected X,Y,Z"),
        ("show --functions mass_matrix,", "expected names"),
        ("show --gravity 0,0,down", "`down`"),
        ("simulate --duration nan", "above zero"),
        ("simulate --duration -1", "above zero"),
        ("simulate --tolerance 0", "from 1e-15 to 1"),
        ("simulate --tolerance 1e-300", "from 1e-15 to 1"),
        ("simulate --samples -1", "from 2 to"),
        ("simulate --samples 1e300", "from 2 to"),
        ("check --samples nan", "from 1 to"),
        ("inverse --duration 1e-300", " in 1e-300 s"),
        ("page --duration 1e300", "from 1e-3 to 1000"),
        ("show --gravity 0,0,1e300", "`--allow odd_gravity`"),
        ("show --lock knee=1e300", "`deg(1e300)`"),
        ("show --field mass=3", "has the name `mass`"),
        ("simulate --from 0,inf", "expected a number"),
        ("simulate --samples 1", "from 2 to"),
        ("inverse --to 1", "expected 2"),
    ] {
        let (subcommand, options) = call.split_once(' ').expect("options");
        let is_led = subcommand == "inverse" && !options.starts_with("--to");
        let more = if is_led { "--to 1,1" } else { "" };
        let message = errors(format!("{subcommand} {pendulum} {options} {more}"), 2);
        assert!(message.contains(expected), "{call:?}: {message}");
        assert!(
            !message.contains("command_line.toml:"),
            "{call:?}: {message}"
        );
    }
    let spaced = ["show", &pendulum, "--gravity", "0 0 -9.81"];
    refused(&spaced, 2, ["expected X,Y,Z"]);
}

/// A time that is too long for the motion is told as that, with the steps that it would take.
#[test]
fn times_that_are_too_long_are_told() {
    let pendulum = file("long.toml", PENDULUM);
    let asked = format!("simulate {pendulum} --from 0.3,1 --duration 1e300");
    let lost = errors(&asked, 1);
    assert!(
        lost.starts_with("`--duration 1e300`: ") && lost.contains("steps below 4e285 s are lost"),
        "{lost}"
    );
}

/// Turning so fast, the arm asks for steps of some 1e-8 s.
#[test]
fn times_of_too_many_steps_are_told() {
    let pendulum = file("fast.toml", PENDULUM);
    let speed = "--velocity 1e7,0 --tolerance 1e-3";
    let asked = format!("simulate {pendulum} --samples 2 {speed}");
    let many = errors(&asked, 1);
    for expected in ["`--duration 1`: ", "more than 100000 steps", "`--samples`"] {
        assert!(many.contains(expected), "{many}");
    }
}

/// The contents of a file, or its name, do not act on a terminal that shows a log, and make no line of their own.
#[test]
fn messages_hold_no_control_characters() {
    let escape = r#"\u001b[31m\u009b2J\nother.toml:1:1: forged\u202e"#;
    let unknown = PENDULUM.replace(
        "convention",
        &format!("functions = [\"{escape}\"]\nconvention"),
    );
    let tree = "<robot><link name='a'/><link name='b'/><joint name='j\u{9b}2J' type='planar'><parent link='a'/>\
                <child link='b'/></joint></robot>";
    for (name, text) in [
        ("un\u{1b}[31mknown.toml", &unknown[..]),
        ("controls.urdf", tree),
    ] {
        let path = file(name, text);
        let urdf = "--chain a,b --gravity 0,0,-9.81";
        let options = if name.ends_with(".urdf") { urdf } else { "" };
        let message = errors(format!("show {path} {options}"), 1);
        let acts = |c: char| c != '\n' && (c.is_control() || c == '\u{202e}');
        assert!(!message.contains(acts), "{message:?}");
        assert!(
            message
                .lines()
                .all(|line| line.contains(&name[name.len() - 4..])),
            "{message:?}"
        );
    }
}

/// Options that take a number say which word of which option is none, and what was expected.
#[test]
fn options_say_which_number_is_wrong() {
    let pendulum = file("numbers.toml", PENDULUM);
    for (call, expected) in [
        (
            "simulate --from 0,PI/",
            "invalid value 'PI/' for '--from <X,Y,...>': expected a number, or a value such as PI/2 or deg(90)",
        ),
        ("simulate --from 0,90°", "write `deg(90)`"),
        ("simulate --velocity 0,fast", "`PI` is the only name"),
        ("simulate --duration 1/0", "division by zero"),
        (
            "simulate --duration 1 - 2",
            "invalid value '1 - 2' for '--duration <NUMBER>': expected a number above zero",
        ),
        (
            "page --field load=quick",
            "`--field load=quick`: expected NAME=NUMBER, for example load=2.5: `PI` is the only name",
        ),
        (
            "show --lock knee=deg()",
            "`--lock knee=deg()`: expected a value between the parentheses",
        ),
        (
            "show --gravity 0,down,0",
            "`--gravity 0,down,0`: unknown name `down`",
        ),
    ] {
        let mut words: Vec<&str> = call.splitn(3, ' ').collect();
        words.insert(1, &pendulum);
        let message = errors(&words, 2);
        assert!(message.contains(expected), "{call:?}: {message}");
    }
}
