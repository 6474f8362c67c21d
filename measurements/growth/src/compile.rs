//! rustc on generated text.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
    time::{SystemTime, UNIX_EPOCH},
};

use crate::chain::Outcome;

/// Options of rustc: those of cargo's profiles.
pub(crate) type Profile = [&'static str];

/// The release profile.
pub(crate) const RELEASE: [&str; 2] = ["-C", "opt-level=3"];
/// The dev profile.
pub(crate) const DEV: [&str; 4] = ["-C", "opt-level=0", "-C", "debuginfo=2"];

/// rustc with the runtime at hand.
pub(crate) struct Compiler {
    /// The compiled runtime.
    runtime: PathBuf,
    /// Where texts and what is made of them go.
    folder: PathBuf,
}

impl Compiler {
    /// Has cargo compile the runtime.
    pub(crate) fn new() -> Outcome<Self> {
        let output = cargo()
            .args(["build", "--release", "--quiet", "-p", "dynamics-runtime"])
            .arg("--message-format=json")
            .stderr(Stdio::inherit())
            .output()?;
        let messages = String::from_utf8(output.stdout)?;
        let runtime = messages.lines().find_map(runtime_of).ok_or("no runtime")?;
        let folder = std::env::temp_dir().join(format!("growth-{}", std::process::id()));
        fs::create_dir_all(&folder)?;
        Ok(Compiler { runtime, folder })
    }

    /// Compiles a library, `chain`. Seconds on a processor.
    pub(crate) fn library(&self, source: &str, profile: &Profile) -> Outcome<f64> {
        self.compile("chain", "rlib", source, profile, &[])
    }

    /// Compiles a program that uses the library, runs it, and reads a number from each line.
    pub(crate) fn run(&self, source: &str) -> Outcome<Vec<f64>> {
        let library = format!("chain={}", self.folder.join("libchain.rlib").display());
        self.compile("timing", "bin", source, &RELEASE, &["--extern", &library])?;
        let output = Command::new(self.folder.join("timing")).output()?;
        if !output.status.success() {
            return Err("the timing program failed".into());
        }
        let text = String::from_utf8(output.stdout)?;
        Ok(text.lines().map(str::parse).collect::<Result<_, _>>()?)
    }

    fn compile(
        &self,
        name: &str,
        kind: &str,
        source: &str,
        profile: &Profile,
        options: &[&str],
    ) -> Outcome<f64> {
        let file = self.folder.join(name).with_extension("rs");
        fs::write(&file, source)?;
        let start = children_seconds();
        let status = Command::new(std::env::var("RUSTC").unwrap_or("rustc".to_owned()))
            .args([
                "--edition",
                "2024",
                "--crate-name",
                name,
                "--crate-type",
                kind,
            ])
            .args(profile)
            .args(options)
            .args(flags())
            .arg("--extern")
            .arg(format!("dynamics_runtime={}", self.runtime.display()))
            .arg("-L")
            .arg(format!("dependency={}", self.dependencies().display()))
            .arg("--out-dir")
            .args([&self.folder, &file])
            .status()?;
        let seconds = children_seconds() - start;
        match status.success() {
            true => Ok(seconds),
            false => Err(format!("rustc failed on {}", file.display()).into()),
        }
    }

    fn dependencies(&self) -> PathBuf {
        self.runtime.parent().unwrap_or(Path::new(".")).join("deps")
    }
}

impl Drop for Compiler {
    fn drop(&mut self) {
        // What remains is in the folder for temporary files: no reason to fail.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// cargo, in this workspace.
pub(crate) fn cargo() -> Command {
    let mut cargo = Command::new(std::env::var("CARGO").unwrap_or("cargo".to_owned()));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo
}

/// Seconds on processors of all programs that this one has run, to 1/50 s; where the system does
/// not tell (Linux does), the time of the day.
fn children_seconds() -> f64 {
    let statistics = fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The name, in parentheses, may have spaces in it. User and system time are fields 16 and 17.
    let fields = statistics.rsplit_once(") ").map(|(_, fields)| fields);
    let ticks = fields.map(|fields| fields.split(' ').skip(13).take(2).map(str::parse::<f64>));
    match ticks.and_then(|ticks| ticks.collect::<Result<Vec<_>, _>>().ok()) {
        Some(ticks) => ticks.iter().sum::<f64>() / TICKS_IN_SECOND,
        None => {
            let time = SystemTime::now().duration_since(UNIX_EPOCH);
            time.map_or(0.0, |time| time.as_secs_f64())
        }
    }
}

/// Of the times that Linux tells programs, on every architecture.
const TICKS_IN_SECOND: f64 = 100.0;

/// The flags that the user gave to cargo for rustc.
pub(crate) fn flags() -> Vec<String> {
    let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
    flags.split_whitespace().map(str::to_owned).collect()
}

/// The library of the runtime, where a message of cargo is about it.
fn runtime_of(message: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(message).ok()?;
    let is_runtime = message["target"]["name"] == "dynamics_runtime";
    let files = message["filenames"].as_array().filter(|_| is_runtime)?;
    let mut paths = files.iter().filter_map(|file| file.as_str());
    paths
        .find(|path| path.ends_with(".rlib"))
        .map(PathBuf::from)
}
