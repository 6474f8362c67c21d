//! A word about an expansion that takes long.

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread::{Builder, scope};
use std::time::Duration;

/// A way for an expansion to say what it is at.
type Say = Box<dyn Fn(&str)>;

/// Longer expansions are told.
const LONG: Duration = Duration::from_secs(5);

/// Runs an expansion, which says what it derives, and writes that to standard error where it takes long.
pub(crate) fn patiently<T>(run: impl FnOnce(Say) -> T) -> T {
    watched(LONG, |derived| eprintln!("{}", told(derived)), run)
}

fn told(derived: &str) -> String {
    format!(
        "robot_dynamics! takes longer than {} s, at the moment for {derived}. An expansion that is not optimised takes ten times as \
         long: see that Cargo.toml of the workspace has these lines.\n\n[profile.dev.build-override]\nopt-level = 3\n\n\
         [profile.release.build-override]\nopt-level = 3\n",
        LONG.as_secs()
    )
}

/// Runs something, and hands on what it says last if it has not ended within that time. The thread that waits ends with it.
fn watched<T>(within: Duration, tell: impl FnOnce(&str) + Send, run: impl FnOnce(Say) -> T) -> T {
    let said = Arc::new(Mutex::new("the table".to_owned()));
    scope(|scope| {
        let (running, end) = channel::<()>();
        let last = Arc::clone(&said);
        let wait = move || {
            if end.recv_timeout(within) == Err(RecvTimeoutError::Timeout)
                && let Ok(said) = last.lock()
            {
                tell(&said);
            }
        };
        // Without a thread nothing is told.
        let _ = Builder::new().spawn_scoped(scope, wait);
        let value = run(Box::new(move |says| {
            if let Ok(mut said) = said.lock() {
                says.clone_into(&mut said);
            }
        }));
        drop(running);
        value
    })
}

#[cfg(test)]
mod tests {
    use std::thread::sleep;
    use std::time::Instant;

    use super::*;

    /// The last word of a long run is told, once. A short one is not told, and not waited for.
    #[test]
    fn what_takes_long_is_told() {
        let told = Mutex::new(Vec::new());
        let tell = |says: &str| told.lock().unwrap().push(says.to_owned());
        let value = watched(Duration::from_millis(20), tell, |say| {
            say("`mass_matrix`");
            say("`forward_dynamics`");
            sleep(Duration::from_millis(200));
            3
        });
        assert_eq!(value, 3);
        let start = Instant::now();
        watched(LONG, tell, |say| say("`jacobian`"));
        assert!(start.elapsed() < LONG / 2);
        assert_eq!(*told.lock().unwrap(), ["`forward_dynamics`"]);
    }

    #[test]
    fn the_lines_of_a_profile_are_those_of_the_documents() {
        let readme = include_str!("../../README.md");
        for line in told("`jacobian`")
            .lines()
            .filter(|line| line.starts_with('['))
        {
            assert!(readme.contains(line), "{line}");
        }
    }
}
