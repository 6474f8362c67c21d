//! rustc on generated text.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

use measuring::children_seconds;

use crate::chain::Outcome;

/// Options of rustc: those of cargo's profiles.
pub(crate) type Profile = [&'static str];

/// The release profile.
pub(crate) const RELEASE: [&str; 2] = ["-C", "opt-level=3"];
/// The dev profile.
pub(crate) const DEV: [&str; 4] = ["-C", "opt-level=0", "-C", "debuginfo=2"];

/// rustc with the runtime and the clock at hand.
pub(crate) struct Compiler {
    /// The compiled runtime.
    runtime: PathBuf,
    /// The compiled clock.
    measuring: PathBuf,
    /// Where texts and what is made of them go.
    folder: PathBuf,
}

impl Compiler {
    /// Has cargo compile the runtime.
    pub(crate) fn new() -> Outcome<Self> {
        let output = cargo()
            .args(["build", "--release", "--quiet"])
            .args(["-p", "dynamics-runtime", "-p", "measuring"])
            .arg("--message-format=json")
            .stderr(Stdio::inherit())
            .output()?;
        let messages = String::from_utf8(output.stdout)?;
        let library = |name| {
            let found = messages
                .lines()
                .find_map(|message| library_of(message, name));
            found.ok_or(format!("no {name}"))
        };
        let (runtime, measuring) = (library("dynamics_runtime")?, library("measuring")?);
        let folder = std::env::temp_dir().join(format!("growth-{}", std::process::id()));
        fs::create_dir_all(&folder)?;
        Ok(Compiler {
            runtime,
            measuring,
            folder,
        })
    }

    /// Compiles a library, `chain`. Seconds on a processor.
    pub(crate) fn library(&self, source: &str, profile: &Profile) -> Outcome<f64> {
        self.compile("chain", "rlib", source, profile, &[])
    }

    /// Compiles a program that uses the library, runs it, and reads a number from each line.
    pub(crate) fn run(&self, source: &str) -> Outcome<Vec<f64>> {
        let library = format!("chain={}", self.folder.join("libchain.rlib").display());
        let clock = format!("measuring={}", self.measuring.display());
        let options = ["--extern", &library, "--extern", &clock];
        self.compile("timing", "bin", source, &RELEASE, &options)?;
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
        // Files that remain are in the folder for temporary files: no reason to fail.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// cargo, in this workspace.
pub(crate) fn cargo() -> Command {
    let mut cargo = Command::new(std::env::var("CARGO").unwrap_or("cargo".to_owned()));
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    cargo
}

/// The flags that the user gave to cargo for rustc.
pub(crate) fn flags() -> Vec<String> {
    let flags = std::env::var("RUSTFLAGS").unwrap_or_default();
    flags.split_whitespace().map(str::to_owned).collect()
}

/// The library of that name, if a message of cargo is about it.
fn library_of(message: &str, name: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(message).ok()?;
    let is_wanted = message["target"]["name"] == name;
    let files = message["filenames"].as_array().filter(|_| is_wanted)?;
    let mut paths = files.iter().filter_map(|file| file.as_str());
    paths
        .find(|path| path.ends_with(".rlib"))
        .map(PathBuf::from)
}
