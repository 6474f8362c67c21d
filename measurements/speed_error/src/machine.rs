//! Where and when the report was made.

use std::process::Command;

use measuring::machine;

use crate::number::BUILT_FUSED;

/// The conditions of the measurement, as lines of name and value.
pub(crate) fn conditions(effort: &str) -> Vec<(&'static str, String)> {
    let [date, time] = machine::now();
    vec![
        ("machine", format!("{}{}", machine::processor(), vectors())),
        ("build", build()),
        ("fused multiply-add", fused().to_owned()),
        ("commit", commit()),
        ("date", format!("{date} {time} UTC")),
        ("effort", effort.to_owned()),
    ]
}

/// The vector instructions that batches use here.
fn vectors() -> &'static str {
    #[cfg(target_arch = "x86_64")]
    {
        let level = fearless_simd::Level::new();
        if level.as_avx512().is_some() {
            return ", AVX-512";
        }
        if level.as_avx2().is_some() {
            return ", AVX2";
        }
    }
    ""
}

fn build() -> String {
    let profile = if cfg!(debug_assertions) {
        "unoptimised: its times mean nothing"
    } else {
        "release profile"
    };
    let target = if BUILT_FUSED {
        "for a processor with fused multiply-add"
    } else {
        "plain, no target flags"
    };
    format!("{profile}, {target}")
}

fn fused() -> &'static str {
    match (BUILT_FUSED, crate::number::can_fuse()) {
        (true, _) => {
            "in all of this build. For the times of a plain build run it again without RUSTFLAGS"
        }
        (false, true) => {
            "only where this report asks for it, function by function. For a build that has it \
             everywhere run again with RUSTFLAGS=\"-C target-cpu=native\""
        }
        (false, false) => "this machine has none",
    }
}

/// The commit of the working tree, and whether it was changed.
fn commit() -> String {
    let git = |arguments: &[&str]| {
        let folder = env!("CARGO_MANIFEST_DIR");
        let output = Command::new("git")
            .arg("-C")
            .arg(folder)
            .args(arguments)
            .output();
        let output = output.ok().filter(|output| output.status.success())?;
        Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    match (git(&["rev-parse", "HEAD"]), git(&["status", "--porcelain"])) {
        (Some(commit), Some(changes)) if changes.is_empty() => commit,
        (Some(commit), _) => format!("{commit}, with changes"),
        _ => "unknown".to_owned(),
    }
}
