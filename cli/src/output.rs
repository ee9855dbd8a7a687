//! Files that appear whole or not at all, and printing that survives a closed pipe.
//!
//! A file is written beside its destination under a temporary name and then renamed. Temporary files are known to the
//! handler of interrupts, which removes them; creating and renaming happen under the same lock, so that no moment
//! exists at which an interrupt leaves one behind.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::Failure;

/// Exit code after an interrupt, as shells have it: 128 + 2.
const INTERRUPTED: i32 = 130;

static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on an interrupt removes whatever is half written and ends the command.
pub fn clean_up_on_interrupt() {
    // Without a handler an interrupt ends the command as well; only a temporary file could then stay behind.
    let _ = ctrlc::set_handler(|| {
        let list = pending();
        for path in list.iter() {
            let _ = fs::remove_file(path);
        }
        let _ = io::stderr().write_all(b"\ninterrupted; no file is left half written\n");
        std::process::exit(INTERRUPTED);
    });
}

/// A destination that has been found writable.
#[derive(Debug)]
pub struct Destination {
    path: PathBuf,
}

impl Destination {
    /// Looks whether a file can be written there, before any work is done for it.
    ///
    /// # Errors
    /// When it names a directory or a device, or when its directory cannot be written to.
    pub fn check(path: &Path) -> Result<Self, Failure> {
        let refuse = |why: &str| {
            Failure::request(format!("cannot write `{}`", path.display()))
                .reason(why)
                .remedy("name a file in a directory that you may write to: --plot FILE.svg or --out DIR")
        };
        if path.file_name().is_none() {
            return Err(refuse("it does not name a file"));
        }
        // A link is followed, so that its target is replaced and the link stays.
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
        match fs::metadata(&path) {
            Ok(data) if data.is_dir() => return Err(refuse("it is a directory")),
            Ok(data) if !data.is_file() => return Err(refuse("it is not a regular file")),
            _ => {}
        }
        let mut directory = directory_of(&path);
        while !directory.exists() {
            directory = directory_of(directory);
        }
        if !directory.is_dir() {
            return Err(refuse(&format!(
                "`{}` is not a directory",
                directory.display()
            )));
        }
        let probe =
            Temporary::create(directory, "probe").map_err(|error| refuse(&error.to_string()))?;
        drop(probe);
        Ok(Self { path })
    }

    /// The same for a figure, whose name must not promise another format.
    ///
    /// # Errors
    /// As [`Destination::check`]; or when the name ends as that of another format.
    pub fn figure(path: &Path) -> Result<Self, Failure> {
        let destination = Self::check(path)?;
        match path.extension() {
            Some(other) if !other.eq_ignore_ascii_case("svg") => {
                Err(Failure::request("figures are drawn as .svg only")
                    .place(path.display().to_string())
                    .remedy(format!("name it {}", path.with_extension("svg").display())))
            }
            _ => Ok(destination),
        }
    }

    /// The path as it will be.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Writes the file: afterwards it is there with all its contents, or it is as it was before.
    ///
    /// # Errors
    /// When the system refuses; nothing is left behind then.
    pub fn write(&self, contents: &[u8]) -> Result<(), Failure> {
        self.replace(contents).map_err(|error| {
            Failure::request(format!("cannot write `{}`", self.path.display()))
                .reason(error.to_string())
                .remedy("name another file with --plot or another directory with --out")
        })
    }

    fn replace(&self, contents: &[u8]) -> io::Result<()> {
        let directory = directory_of(&self.path);
        fs::create_dir_all(directory)?;
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        let mut temporary = Temporary::create(directory, &name)?;
        temporary.file.write_all(contents)?;
        temporary.file.sync_data()?;
        temporary.rename(&self.path)
    }
}

fn directory_of(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        Some(_) => Path::new("."),
        None => Path::new("/"),
    }
}

/// A file under a temporary name; it is removed unless it is renamed.
struct Temporary {
    path: PathBuf,
    file: File,
}

impl Temporary {
    fn create(directory: &Path, name: &str) -> io::Result<Self> {
        let path = directory.join(format!(".{name}.{}.part", std::process::id()));
        let mut list = pending();
        let file = OpenOptions::new()
            .write(true)
            .create(true)
            .truncate(true)
            .open(&path)?;
        list.push(path.clone());
        Ok(Self { path, file })
    }

    fn rename(self, destination: &Path) -> io::Result<()> {
        let mut list = pending();
        fs::rename(&self.path, destination)?;
        list.retain(|path| *path != self.path);
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let mut list = pending();
        // After a rename there is nothing under this name.
        let _ = fs::remove_file(&self.path);
        list.retain(|path| *path != self.path);
    }
}

/// Prints the answer. A reader who has closed the pipe has read enough.
///
/// # Errors
/// When standard output refuses for another reason, a full disk for one.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    let written = stdout
        .write_all(text.as_bytes())
        .and_then(|()| stdout.flush());
    match written {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::request("cannot write to standard output")
                .reason(error.to_string())
                .remedy("send it elsewhere, or make room"))
        }
        _ => Ok(()),
    }
}

/// Prints a message to standard error; there is nobody left to tell when even that fails.
pub fn complain(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("assur-output-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).expect("a temporary directory");
        path
    }

    #[test]
    fn a_file_is_replaced_whole_and_nothing_else_stays() {
        let folder = folder("whole");
        let path = folder.join("sub/figure.svg");
        for text in ["first", "second"] {
            Destination::check(&path)
                .and_then(|file| file.write(text.as_bytes()))
                .expect("writable");
            assert_eq!(fs::read_to_string(&path).expect("written"), text);
        }
        assert_eq!(
            fs::read_dir(folder.join("sub"))
                .expect("a directory")
                .count(),
            1
        );
        let _ = fs::remove_dir_all(folder);
    }

    #[test]
    fn directories_devices_and_files_as_directories_are_refused() {
        let folder = folder("refused");
        fs::write(folder.join("file"), "").expect("writable");
        for (path, why) in [
            (folder.clone(), "directory"),
            (folder.join("file/figure.svg"), "not a directory"),
            (PathBuf::from("/dev/null"), "regular"),
        ] {
            let failure = Destination::check(&path).expect_err("must be refused");
            assert!(
                failure.render(crate::style::Style::PLAIN).contains(why),
                "{failure:?}"
            );
        }
        let _ = fs::remove_dir_all(folder);
    }

    #[test]
    fn a_figure_is_not_named_as_another_format() {
        let folder = folder("format");
        for name in ["a.svg", "a.SVG", "a"] {
            assert!(Destination::figure(&folder.join(name)).is_ok(), "{name}");
        }
        let failure = Destination::figure(&folder.join("a.png")).expect_err("no picture in pixels");
        let text = failure.render(crate::style::Style::PLAIN);
        assert!(
            text.contains(".svg only") && text.contains("a.svg"),
            "{text}"
        );
        let _ = fs::remove_dir_all(folder);
    }
}
