//! Files that appear whole or not at all, and printing that survives a closed pipe.
//!
//! A file is written beside its destination under a temporary name and then renamed. Temporary files are known to the
//! handler of interrupts, which removes them; creating and renaming happen under the same lock, so that no moment
//! exists at which an interrupt leaves one behind.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::error::Failure;

/// Exit code after an interrupt, as shells have it: 128 + 2.
const INTERRUPTED: i32 = 130;

/// Most links that are followed to a file.
const LINKS: usize = 40;

static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
/// Number of temporary files so far.
static CREATED: AtomicUsize = AtomicUsize::new(0);

/// Whether an interrupt is to be heard rather than to end the command, and whether there was one.
static LISTENS: AtomicBool = AtomicBool::new(false);
static STOPPED: AtomicBool = AtomicBool::new(false);

/// Work of which a part is worth something: until this is dropped the first interrupt ends the work alone.
pub struct Stoppable;

impl Stoppable {
    /// From now on.
    pub fn begin() -> Self {
        LISTENS.store(true, Ordering::SeqCst);
        Self
    }

    /// Whether the work is to end.
    pub fn is_stopped(&self) -> bool {
        STOPPED.load(Ordering::SeqCst)
    }
}

impl Drop for Stoppable {
    fn drop(&mut self) {
        LISTENS.store(false, Ordering::SeqCst);
    }
}

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on an interrupt removes whatever is half written and ends the command.
pub fn clean_up_on_interrupt() {
    // Without a handler an interrupt ends the command as well; only a temporary file could then stay behind.
    let _ = ctrlc::set_handler(|| {
        if LISTENS.load(Ordering::SeqCst) && !STOPPED.swap(true, Ordering::SeqCst) {
            let _ = io::stderr().write_all(b"\nstops with what there is; once more ends at once\n");
            return;
        }
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
            Failure::request(format!("cannot write `{}`", path.display())).reason(why).remedy(
                "name a file in a directory that you may write to: --plot FILE.svg or --out DIR",
            )
        };
        if path.file_name().is_none() {
            return Err(refuse("it does not name a file"));
        }
        let path = target(path).map_err(|error| refuse(&error.to_string()))?;
        match fs::metadata(&path) {
            Ok(data) if data.is_dir() => return Err(refuse("it is a directory")),
            Ok(data) if !data.is_file() => return Err(refuse("it is not a regular file")),
            _ => {}
        }
        // Directories that are missing will be made, of names that have to be possible as that of the file.
        let mut directory = directory_of(&path);
        let mut missing = vec![path.file_name().unwrap_or_default()];
        while !directory.exists() && !directory.is_symlink() {
            missing.extend(directory.file_name());
            directory = directory_of(directory);
        }
        if !directory.is_dir() {
            return Err(refuse(&format!("`{}` is not a directory", directory.display())));
        }
        for name in missing {
            match fs::symlink_metadata(directory.join(name)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => {
                    return Err(refuse(&error.to_string()));
                }
                _ => {}
            }
        }
        let probe = Temporary::create(directory).map_err(|error| refuse(&error.to_string()))?;
        drop(probe);
        Ok(Self { path })
    }

    /// Looks whether a figure can be written there; its name must not promise another format.
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
        let mut temporary = Temporary::create(directory)?;
        temporary.file.write_all(contents)?;
        temporary.file.sync_data()?;
        temporary.rename(&self.path)
    }
}

/// The file that a path means: a link is followed, also to a file that is not there yet, so that the link stays.
fn target(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_path_buf();
    for _ in 0..LINKS {
        match fs::read_link(&path) {
            Ok(next) => path = directory_of(&path).join(next),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("it is a link that leads back to itself"))
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
    /// Its name is short, however long that of the file will be.
    fn create(directory: &Path) -> io::Result<Self> {
        let mut list = pending();
        let number = CREATED.fetch_add(1, Ordering::Relaxed);
        let path = directory.join(format!(".assur-{}-{number}.part", std::process::id()));
        let file = OpenOptions::new().write(true).create(true).truncate(true).open(&path)?;
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

/// Prints the answer.
///
/// # Errors
/// As [`printed`].
pub fn print(text: &str) -> Result<(), Failure> {
    printed(io::stdout().write_all(text.as_bytes()))
}

/// What became of an answer that was printed. A reader who has closed the pipe has read enough.
///
/// # Errors
/// When standard output refuses for another reason, a full disk for one.
pub fn printed(written: io::Result<()>) -> Result<(), Failure> {
    match written.and_then(|()| io::stdout().flush()) {
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
        assert_eq!(fs::read_dir(folder.join("sub")).expect("a directory").count(), 1);
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
            assert!(failure.render(crate::show::style::Style::PLAIN).contains(why), "{failure:?}");
        }
        let _ = fs::remove_dir_all(folder);
    }

    #[test]
    fn names_may_be_as_long_as_the_system_permits_and_longer_ones_are_refused_at_once() {
        let folder = folder("long");
        let longest = folder.join("f".repeat(255));
        let file = Destination::check(&longest).expect("255 bytes are permitted");
        file.write(b"whole").expect("writable");
        assert_eq!(fs::read(&longest).expect("written"), b"whole");
        for path in
            ["f".repeat(256), format!("new/{}", "d".repeat(256)), format!("{}/f", "d".repeat(256))]
        {
            let failure = Destination::check(&folder.join(path)).expect_err("too long");
            let text = failure.render(crate::show::style::Style::PLAIN);
            assert!(text.contains("too long"), "{text}");
        }
        assert!(!folder.join("new").exists());
        let _ = fs::remove_dir_all(folder);
    }

    #[cfg(unix)]
    #[test]
    fn links_stay() {
        use std::os::unix::fs::symlink;
        let folder = folder("links");
        for (link, to) in [("link", "target"), ("circle", "circle"), ("nowhere", "gone/there")] {
            symlink(to, folder.join(link)).expect("links can be made");
        }
        let file = Destination::check(&folder.join("link")).expect("it leads to a file to be");
        file.write(b"new").expect("writable");
        assert_eq!(fs::read(folder.join("target")).expect("written"), b"new");
        assert!(folder.join("link").is_symlink());
        assert!(Destination::check(&folder.join("nowhere")).is_ok());
        assert!(Destination::check(&folder.join("circle")).is_err());
        assert!(Destination::check(&folder.join("circle/file")).is_err());
        let _ = fs::remove_dir_all(folder);
    }

    #[test]
    fn a_figure_is_not_named_as_another_format() {
        let folder = folder("format");
        for name in ["a.svg", "a.SVG", "a"] {
            assert!(Destination::figure(&folder.join(name)).is_ok(), "{name}");
        }
        let failure = Destination::figure(&folder.join("a.png")).expect_err("no picture in pixels");
        let text = failure.render(crate::show::style::Style::PLAIN);
        assert!(text.contains(".svg only") && text.contains("a.svg"), "{text}");
        let _ = fs::remove_dir_all(folder);
    }
}
