//! Files that are replaced as a whole, or not at all: a text is written into a new file beside the old one, which is
//! renamed when it is complete. A full disk leaves the old file as it was.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Writes texts into files: all of them, or none if one cannot be written. The texts of all files are complete on the
/// disk before the first file is renamed. A link is followed, and a replaced file leaves its permissions to the new one.
/// A path that leads to no regular file, such as a pipe or `/dev/stdout`, is written straight.
///
/// # Errors
///
/// The path that cannot be written, and the system's reason.
pub fn replace_files(files: &[(PathBuf, String)]) -> Result<(), (PathBuf, io::Error)> {
    let mut complete = Vec::new();
    let mut straight = Vec::new();
    for (path, text) in files {
        match written_beside(path, text).map_err(|error| (path.clone(), error))? {
            Some(beside) => complete.push((path, beside)),
            None => straight.push((path, text)),
        }
    }
    for (path, text) in straight {
        written_straight(path, text).map_err(|error| (path.clone(), error))?;
    }
    for (path, beside) in complete {
        beside.rename().map_err(|error| (path.clone(), error))?;
    }
    Ok(())
}

/// A complete file that waits to take the place of another one; removed if it never does.
struct Beside {
    temporary: PathBuf,
    target: PathBuf,
}

impl Beside {
    fn rename(&self) -> io::Result<()> {
        match fs::rename(&self.temporary, &self.target) {
            // A file that is mounted by itself can be written, and cannot be renamed.
            Err(error) if error.kind() == ErrorKind::ResourceBusy => {
                fs::copy(&self.temporary, &self.target).map(drop)
            }
            renamed => renamed,
        }
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        // After the renaming there is no such file.
        let _ = fs::remove_file(&self.temporary);
    }
}

/// The text in a file beside the one that it will replace; none if it has to be written straight.
fn written_beside(path: &Path, text: &str) -> io::Result<Option<Beside>> {
    let Some(target) = regular_file(path)? else {
        return Ok(None);
    };
    // A file that may not be written may not be replaced either.
    let replaced = match OpenOptions::new().write(true).open(&target) {
        Ok(file) => Some(file.metadata()?),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error),
    };
    let (mut file, temporary) = match new_file_beside(&target) {
        // The folder is closed for new files, and the file is open.
        Err(error) if error.kind() == ErrorKind::PermissionDenied && replaced.is_some() => {
            return Ok(None);
        }
        made => made?,
    };
    let beside = Beside { temporary, target };
    file.write_all(text.as_bytes())?;
    if let Some(replaced) = replaced {
        // Only the system's administrator can give a file to another user.
        #[cfg(unix)]
        let _ = {
            use std::os::unix::fs::{MetadataExt as _, fchown};
            fchown(&file, Some(replaced.uid()), Some(replaced.gid()))
        };
        file.set_permissions(replaced.permissions())?;
    }
    file.sync_all()?;
    Ok(Some(beside))
}

/// A new file in the folder of another one, and its path.
fn new_file_beside(target: &Path) -> io::Result<(File, PathBuf)> {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    loop {
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let name = format!(".robot-dynamics-{}-{count}", std::process::id());
        let path = target.with_file_name(name);
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            made => return made.map(|file| (file, path)),
        }
    }
}

/// Writes into what is there. Nothing is cut off what standard output has been joined to.
fn written_straight(path: &Path, text: &str) -> io::Result<()> {
    let is_file = regular_file(path)?.is_some();
    let mut options = OpenOptions::new();
    options.append(!is_file).write(true).truncate(is_file);
    options.open(path)?.write_all(text.as_bytes())
}

/// Links that are followed, as many as Linux follows.
const MOST_LINKS: usize = 40;

/// The file that a path leads to behind all links, whether it is there or not; none if it is no regular file.
fn regular_file(path: &Path) -> io::Result<Option<PathBuf>> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Some(name) = path.file_name() else {
            return Ok(None);
        };
        let parent = path.parent().filter(|folder| *folder != Path::new(""));
        let folder = parent.unwrap_or(Path::new(".")).canonicalize()?;
        // Links in these folders stand for files that are open: `/dev/stdout` leads there.
        if folder.starts_with("/proc") || folder.starts_with("/dev/fd") {
            return Ok(None);
        }
        let found = folder.join(name);
        path = match found.symlink_metadata() {
            Ok(link) if link.is_symlink() => folder.join(found.read_link()?),
            Ok(other) => return Ok(other.is_file().then_some(found)),
            Err(error) if error.kind() == ErrorKind::NotFound => return Ok(Some(found)),
            Err(error) => return Err(error),
        };
    }
    Err(io::Error::other("too many links"))
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use std::os::unix::fs::{PermissionsExt as _, symlink};

    use super::*;

    /// An empty folder of the test's own.
    fn folder(name: &str) -> PathBuf {
        let folder = format!("robot-dynamics-{name}-{}", std::process::id());
        let folder = std::env::temp_dir().join(folder);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        folder
    }

    fn write(path: &Path, text: &str) {
        replace_files(&[(path.to_owned(), text.to_owned())]).expect("a file");
    }

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("a folder");
        let name = |entry: io::Result<fs::DirEntry>| entry.expect("an entry").file_name();
        let mut names: Vec<_> = entries
            .map(|entry| name(entry).to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_new_file_takes_the_place_of_the_old_one() {
        let folder = folder("replaced");
        let path = folder.join("arm.csv");
        fs::write(&path, "old").expect("a file");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("permissions");
        let other_name = folder.join("other.csv");
        fs::hard_link(&path, &other_name).expect("a hard link");
        write(&path, "new");
        assert_eq!(fs::read_to_string(&path).expect("text"), "new");
        assert_eq!(fs::read_to_string(&other_name).expect("text"), "old");
        let mode = fs::metadata(&path).expect("metadata").permissions().mode();
        assert_eq!(mode & 0o777, 0o640);
        assert_eq!(names(&folder), ["arm.csv", "other.csv"]);
        fs::remove_dir_all(folder).expect("removed");
    }

    #[test]
    fn the_file_behind_links_is_replaced() {
        let folder = folder("links");
        let [target, link, second] = ["target", "link", "second"].map(|name| folder.join(name));
        symlink("target", &link).expect("a link");
        symlink(&link, &second).expect("a link");
        for text in ["made", "replaced"] {
            write(&second, text);
            assert_eq!(fs::read_to_string(&target).expect("text"), text);
        }
        assert!(second.is_symlink() && link.is_symlink() && !target.is_symlink());
        let circle = folder.join("circle");
        symlink("circle", &circle).expect("a link");
        assert!(replace_files(&[(circle, String::new())]).is_err());
        fs::remove_dir_all(folder).expect("removed");
    }

    /// The second of two files cannot be written: the first one stays what it was, and nothing is left beside it.
    #[test]
    fn all_files_are_replaced_or_none() {
        let folder = folder("all");
        let [header, closed] = ["arm.h", "arm.c"].map(|name| folder.join(name));
        fs::write(&header, "old").expect("a file");
        fs::create_dir(&closed).expect("a folder in the place of the file");
        let texts = [
            (header.clone(), "new".to_owned()),
            (closed.clone(), "new".to_owned()),
        ];
        let (path, _) = replace_files(&texts).expect_err("a folder is no file");
        assert_eq!(path, closed);
        assert_eq!(fs::read_to_string(&header).expect("text"), "old");
        assert_eq!(names(&folder), ["arm.c", "arm.h"]);
        fs::remove_dir_all(folder).expect("removed");
    }

    #[test]
    fn a_pipe_is_written_straight() {
        let folder = folder("pipe");
        let pipe = folder.join("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.expect("mkfifo").success());
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read_to_string(pipe).expect("text")
        });
        write(&pipe, "through");
        assert_eq!(reader.join().expect("the reader"), "through");
        assert_eq!(names(&folder), ["pipe"]);
        fs::remove_dir_all(folder).expect("removed");
    }
}
