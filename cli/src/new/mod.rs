//! `assur new`: an equation file to begin with, and a crate around it.

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use assur_emit::names;
use clap::{Args, ValueEnum};

use crate::error::Failure;
use crate::show::output::print;

pub const EXAMPLES: &str = "Examples:
  assur new swing
  assur new press --like linkage
  assur new hammer --like hybrid --crate

The file is NAME.eqn in the current directory; with --crate it is NAME/src/NAME.eqn in a cargo project of its own. Files
that are there already are never written over.";

/// Options of `assur new`.
#[derive(Args, Debug)]
pub struct NewArguments {
    /// What the mechanism is called, `coffee_press`.
    pub name: String,
    /// What it is like.
    #[arg(long, value_enum, default_value_t = Like::Motion)]
    pub like: Like,
    /// A cargo project with the file, a program and the tests of the equations.
    #[arg(long = "crate")]
    pub is_crate: bool,
}

/// What an equation file is like.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Like {
    /// Equations of motion from energies.
    Motion,
    /// Loops that a driver moves.
    Linkage,
    /// A motion with modes, and events between them.
    Hybrid,
    /// A sheet of formulas.
    Formula,
}

impl Like {
    /// The equation file, and the program of a crate. The programs are examples of this package, so that they are compiled.
    fn texts(self) -> (&'static str, &'static str) {
        /// Both files of a kind.
        macro_rules! texts {
            ($folder:literal) => {
                (
                    include_str!(concat!($folder, "/mechanism.eqn")),
                    include_str!(concat!($folder, "/main.rs")),
                )
            };
        }
        match self {
            Self::Motion => texts!("motion"),
            Self::Linkage => texts!("linkage"),
            Self::Hybrid => texts!("hybrid"),
            Self::Formula => texts!("formula"),
        }
    }
}

/// Writes the files.
///
/// # Errors
/// A name that cannot be one, or a file that is there already.
pub fn execute(options: &NewArguments) -> Result<(), Failure> {
    let given = options.name.strip_suffix(".eqn").unwrap_or(&options.name);
    let (folder, given_name) = match Path::new(given).file_name().and_then(|name| name.to_str()) {
        Some(name) => (Path::new(given).parent().unwrap_or(Path::new("")), name),
        None => return Err(no_name(&options.name)),
    };
    let (title, name) = (names::pascal(given_name), names::snake(given_name));
    // A word of Rust would be no name of a module, and so of no crate.
    let is_word = names::identifier(&name) == name.as_str();
    if !given_name.starts_with(|letter: char| letter.is_ascii_alphabetic()) || !is_word {
        return Err(no_name(&options.name));
    }
    let (text, program) = options.like.texts();
    let text = text.replacen("    Name from", &format!("    {title} from"), 1);
    let file = format!("{name}.eqn");
    if !options.is_crate {
        let path = folder.join(&file);
        write(&path, &text)?;
        let path = path.display();
        return print(&format!(
            "{path} is written. Try it:\n\n  assur run {path}\n  assur check {path}\n  assur run {path} --watch\n"
        ));
    }
    let project = folder.join(&name);
    let source = project.join("src");
    if project.join("Cargo.toml").exists() {
        return Err(there(&project.join("Cargo.toml")));
    }
    fs::create_dir_all(&source).map_err(|error| cannot(&source, &error))?;
    write(&source.join(&file), &text)?;
    let program = program.replacen("//! Name:", &format!("//! {title}:"), 1);
    let program = program.replacen("use mechanism::", &format!("use {name}::"), 1);
    write(&source.join("main.rs"), &program.replacen("mechanism.eqn", &file, 1))?;
    write(&project.join("Cargo.toml"), &manifest(&name))?;
    let path = project.display();
    print(&format!(
        "{path} is written. Try it:\n\n  cd {path}\n  cargo run\n  cargo test\n  assur run src/{file}\n"
    ))
}

/// The project's `Cargo.toml`: with the Assur that this command is part of, as long as that is there.
fn manifest(name: &str) -> String {
    let version = env!("CARGO_PKG_VERSION");
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_path_buf);
    let own = own.filter(|folder| folder.join("Cargo.toml").is_file());
    let path = own.map_or_else(String::new, |folder: PathBuf| {
        format!(", path = {:?}", folder.display().to_string())
    });
    format!(
        "[package]\nname = \"{name}\"\nversion = \"0.1.0\"\nedition = \"2024\"\n\n[dependencies]\nassur = {{ version = \"{version}\"{path} }}\n\n# Emitted code is far slower without optimisation.\n[profile.dev]\nopt-level = 1\n\n[workspace]\n"
    )
}

/// Writes a file that is not there yet.
fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let opened = OpenOptions::new().write(true).create_new(true).open(path);
    let written = opened.and_then(|mut file| file.write_all(text.as_bytes()));
    written.map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => there(path),
        _ => cannot(path, &error),
    })
}

fn there(path: &Path) -> Failure {
    Failure::request(format!("`{}` is there already", path.display()))
        .reason("what is there is never written over")
        .remedy("choose another name, or take the file away")
}

fn cannot(path: &Path, error: &std::io::Error) -> Failure {
    Failure::request(format!("cannot write `{}`", path.display())).reason(error.to_string())
}

fn no_name(name: &str) -> Failure {
    Failure::request(format!("`{name}` cannot be the name of a mechanism"))
        .remedy("a name begins with a letter, has letters, digits and underscores, and is no word of Rust: assur new coffee_press")
}
