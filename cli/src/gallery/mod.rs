//! `assur gallery`: a page of all mechanisms for people who read a repository.
//!
//! | file | what it does |
//! |---|---|
//! | `page` | the whole page, and what of it differs from another one |
//! | `article` | what the page says of one mechanism |
//! | `equations` | the equations as they stand in the file |
//! | `scenes`, `facts` | the tables of scenes and of published numbers |
//! | `picture`, `found` | the picture, and what is found of a scene by running it |
//! | `markdown` | texts and tables as a forge shows them |

mod article;
mod equations;
mod facts;
mod found;
mod markdown;
mod page;
mod picture;
mod scenes;

use std::fs;
use std::path::{Path, PathBuf};

use assur::registry::Mechanism;
use clap::{Args, ValueEnum};

use crate::ask::lookup::Registry;
use crate::error::Failure;
use crate::show::output::{self, Destination};
use crate::show::progress::Progress;
use article::Article;
use found::Found;
use page::Page;
use picture::Picture;

/// Examples, and what is written.
pub const EXAMPLES: &str = "Examples:
  assur gallery docs
  assur gallery docs --files ../equations/src
  assur gallery docs --files ../equations/src --check stated

DIR/mechanisms.md has for each mechanism its picture, its equations, its scenes, and the published numbers beside the
computed ones; DIR/gallery/NAME.svg are the pictures. Scenes with published numbers are run for that, which takes as
long as `assur run` takes for them.

Exit codes: 0 written, or up to date; 1 a scene does not come out; 2 out of date, or the request is wrong.";

/// The page in its directory.
const PAGE: &str = "mechanisms.md";
/// The directory of the pictures beside it.
const PICTURES: &str = "gallery";

/// Options of `assur gallery`.
#[derive(Args, Debug)]
pub struct GalleryArguments {
    /// Directory of the page, created if it is missing.
    #[arg(value_name = "DIR")]
    pub directory: PathBuf,
    /// Directory of the equation files as seen from DIR, to which the page links. No links unless given.
    #[arg(long, value_name = "PATH")]
    pub files: Option<String>,
    /// Writes nothing, but compares the page that is there with what would be written.
    #[arg(long, value_enum, value_name = "WHAT")]
    pub check: Option<Check>,
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Check {
    /// Everything but the computed numbers, which are taken from the page: no scene is run.
    Stated,
    /// Everything on the page: the scenes with published numbers are run.
    All,
}

impl GalleryArguments {
    fn page(&self) -> PathBuf {
        self.directory.join(PAGE)
    }

    fn picture(&self, mechanism: &Mechanism) -> PathBuf {
        self.directory.join(PICTURES).join(format!("{}.svg", mechanism.name))
    }

    /// The command that writes the page.
    fn command(&self) -> String {
        let files = self.files.iter().map(|files| format!(" --files {files}"));
        format!("assur gallery {}{}", self.directory.display(), files.collect::<String>())
    }
}

/// Writes the page with its pictures, or compares it.
///
/// # Errors
/// A directory that cannot be written to, or a scene that does not come out, nothing being written then; or a page that
/// is out of date.
pub fn execute(options: &GalleryArguments, registry: Registry) -> Result<(), Failure> {
    match options.check {
        Some(check) => compare(options, check, registry),
        None => write(options, registry),
    }
}

fn write(options: &GalleryArguments, registry: Registry) -> Result<(), Failure> {
    let page = Destination::check(&options.page())?;
    let progress = progress(registry);
    let (mut articles, mut pictures) = (Vec::new(), Vec::new());
    for mechanism in registry.0 {
        let picture = Picture::of(mechanism)?;
        let found = Found::of(mechanism, picture.as_ref().and_then(Picture::curves))?;
        if let Some(picture) = &picture {
            let destination = Destination::figure(&options.picture(mechanism))?;
            pictures.push((destination, picture.draw(&found)?));
        }
        articles.push(Article { mechanism, picture, rows: facts::rows(mechanism, &found)? });
        progress.advance();
    }
    drop(progress);
    let count = pictures.len();
    for (destination, picture) in pictures {
        destination.write(picture.as_bytes())?;
    }
    page.write(Page::new(&articles, options.files.as_deref())?.text().as_bytes())?;
    output::print(&format!(
        "Page:     {}\nPictures: {count} in {}\n",
        page.path().display(),
        options.directory.join(PICTURES).display()
    ))
}

fn compare(options: &GalleryArguments, check: Check, registry: Registry) -> Result<(), Failure> {
    let path = options.page();
    let written = read(&path, options)?;
    let known = Page::read(&written);
    let progress = progress(registry);
    let mut articles = Vec::new();
    for mechanism in registry.0 {
        let rows = match check {
            Check::All => facts::rows(mechanism, &Found::of(mechanism, None)?)?,
            Check::Stated => facts::rows(mechanism, known.section(mechanism.title))?,
        };
        let picture = Picture::of(mechanism)?;
        if picture.is_some() && !options.picture(mechanism).is_file() {
            let missing = options.picture(mechanism);
            return Err(out_of_date(options, format!("`{}` is missing", missing.display())));
        }
        articles.push(Article { mechanism, picture, rows });
        progress.advance();
    }
    drop(progress);
    let renewed = Page::new(&articles, options.files.as_deref())?;
    match known.differences(&renewed) {
        None => output::print(&format!("`{}` is up to date\n", path.display())),
        Some((titles, first)) => Err(out_of_date(options, first).place(titles.join(", "))),
    }
}

fn read(path: &Path, options: &GalleryArguments) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| {
        Failure::request(format!("cannot read `{}`", path.display()))
            .reason(error.to_string())
            .remedy(format!("write it: {}", options.command()))
    })
}

fn out_of_date(options: &GalleryArguments, why: String) -> Failure {
    Failure::request(format!("`{}` is out of date", options.page().display()))
        .reason(why)
        .remedy(format!("renew it: {}", options.command()))
}

fn progress(registry: Registry) -> Progress {
    Progress::start("all mechanisms".to_owned(), registry.0.len() as u64)
}
