//! The machine, the compiler and the date.

use std::process::Command;

/// Instruction sets that matter for the times.
const FEATURES: [&str; 6] = ["sse2", "avx", "fma", "avx2", "avx512f", "avx512dq"];

/// In one line.
pub(crate) fn conditions() -> String {
    let cpu = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let field = |name: &str| -> String {
        let line = cpu.lines().find(|line| line.starts_with(name));
        let value = line.and_then(|line| line.split_once(':'));
        value.map_or_else(|| "unknown".into(), |(_, value)| value.trim().into())
    };
    let flags = field("flags");
    let features: Vec<&str> = FEATURES
        .into_iter()
        .filter(|feature| flags.split(' ').any(|flag| flag == *feature))
        .collect();
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    format!(
        "{}, family {}, model {}, {cores} cores; {}; {}; {}.",
        field("model name"),
        field("cpu family"),
        field("model\t"),
        features.join(", "),
        output("rustc", &["--version"]),
        output("date", &["-u", "+%Y-%m-%d"]),
    )
}

fn output(program: &str, arguments: &[&str]) -> String {
    let output = Command::new(program).args(arguments).output().unwrap();
    String::from_utf8(output.stdout).unwrap().trim().into()
}
