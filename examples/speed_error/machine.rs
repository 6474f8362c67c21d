//! Where and when the report was made.

use std::process::Command;
use std::time::{SystemTime, UNIX_EPOCH};

use crate::number::BUILT_FUSED;

/// What the numbers depend on, as lines of name and value.
pub(crate) fn conditions(effort: &str) -> Vec<(&'static str, String)> {
    vec![
        ("machine", processor()),
        ("build", build()),
        ("fused multiply-add", fused().to_owned()),
        ("commit", commit()),
        ("date", date()),
        ("effort", effort.to_owned()),
    ]
}

fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = text.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        (key.trim() == "model name").then(|| value.trim().to_owned())
    });
    let cores = std::thread::available_parallelism().map_or(0, usize::from);
    let (os, arch) = (std::env::consts::OS, std::env::consts::ARCH);
    let model = model.unwrap_or_else(|| "unknown processor".to_owned());
    format!("{model}, {cores} cores, {arch} {os}{}", vectors())
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

/// Today in UTC, ISO 8601, from the days since 1970 (H. Hinnant, *chrono-compatible low-level date
/// algorithms*: civil_from_days).
fn date() -> String {
    let seconds = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |t| t.as_secs());
    let days = seconds as i64 / 86_400 + 719_468;
    let era = days.div_euclid(146_097);
    let day_of_era = days.rem_euclid(146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1_460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    let year = era * 400 + year_of_era + i64::from(month <= 2);
    let (hour, minute) = (seconds / 3_600 % 24, seconds / 60 % 60);
    format!("{year}-{month:02}-{day:02} {hour:02}:{minute:02} UTC")
}
