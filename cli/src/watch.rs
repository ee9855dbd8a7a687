//! `--watch`: a command again at each change of an equation file, or of the files of its parts and tables.

use std::collections::BTreeMap;
use std::fs;
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::ask::file;
use crate::error::Failure;
use crate::show::output::{complain, print};
use crate::show::style;
use crate::source::STANDARD_INPUT;

/// How often files are looked at.
const INTERVAL: Duration = Duration::from_millis(100);

/// Clears a terminal and goes to its first line.
const CLEAR: &str = "\x1b[2J\x1b[3J\x1b[H";

/// The files with the times at which they were changed last; none of a file that is not there.
type Seen = BTreeMap<PathBuf, Option<(SystemTime, u64)>>;

/// Does a command, and again whenever a file has changed, until it is interrupted. What goes wrong is said, and stays on the
/// screen until it is mended.
///
/// # Errors
/// What is to be watched is no file; or standard output is closed.
pub fn execute(
    name: Option<&str>,
    command: impl Fn() -> Result<(), Failure>,
) -> Result<(), Failure> {
    let Some(name) = name.filter(|name| file::is_file(name) && *name != STANDARD_INPUT) else {
        return Err(Failure::request("only a file can be watched")
            .place("--watch")
            .remedy("name an equation file: assur run my.eqn --watch"));
    };
    let path = Path::new(name);
    loop {
        let seen = seen(path);
        if std::io::stdout().is_terminal() {
            print(CLEAR)?;
        }
        if let Err(failure) = command() {
            complain(&failure.render(style::stderr()));
        }
        print(&style::stdout().faint(&format!("\nwatching {name}; Ctrl-C ends\n")))?;
        while self::seen(path) == seen {
            thread::sleep(INTERVAL);
        }
        // Editors write in several steps.
        thread::sleep(INTERVAL);
    }
}

/// A file and those that it names, and so on.
fn seen(path: &Path) -> Seen {
    let mut seen = Seen::new();
    let mut open = vec![path.to_owned()];
    while let Some(path) = open.pop() {
        if seen.contains_key(&path) {
            continue;
        }
        let data = fs::metadata(&path).ok().filter(|data| data.is_file());
        let time = data.and_then(|data| Some((data.modified().ok()?, data.len())));
        if time.is_some() && path.extension().is_some_and(|end| end == "eqn") {
            let folder = path.parent().unwrap_or(Path::new(""));
            let text = fs::read_to_string(&path).unwrap_or_default();
            open.extend(named(&text).map(|name| folder.join(name)));
        }
        seen.insert(path, time);
    }
    seen
}

/// The files that a text names in quotes.
fn named(text: &str) -> impl Iterator<Item = &str> {
    text.split('"')
        .skip(1)
        .step_by(2)
        .filter(|name| name.ends_with(".eqn") || name.ends_with(".csv"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_of_parts_and_tables_are_watched() {
        let text = "part lift: Lift from \"parts/lift.eqn\" {}\nlet F = table(\"spring.csv\", x); // \"no\"\n";
        assert_eq!(named(text).collect::<Vec<_>>(), ["parts/lift.eqn", "spring.csv"]);
        let folder = std::env::temp_dir().join(format!("assur-watch-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let [main, part] = ["main.eqn", "part.eqn"].map(|name| folder.join(name));
        fs::write(&main, "part p: Part from \"part.eqn\"").unwrap();
        let missing = seen(&main);
        assert_eq!(missing.get(&part), Some(&None));
        fs::write(&part, "Part;").unwrap();
        assert_ne!(seen(&main), missing);
        fs::remove_dir_all(&folder).unwrap();
    }
}
