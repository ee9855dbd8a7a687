//! Surfaces: vectors of three lengths over two swept values, as a picture and as files of their facets.
//!
//! | file | what it does |
//! |---|---|
//! | `arguments`, `request` | what can be asked, and what is |
//! | `patch` | a scene as a surface: its places over a grid |
//! | `mesh` | patches together: corners, cells, facets that are turned outwards |
//! | `files` | the facets as OBJ and STL |
//! | `view`, `order` | where it is seen from, which cells hide which |
//! | `axes`, `picture` | the box of axes, the picture |
//! | `vector` | vectors in space |

pub mod arguments;
mod axes;
mod files;
mod mesh;
mod order;
mod patch;
mod picture;
mod request;
mod vector;
mod view;

use std::path::Path;

use assur::registry::SceneEntry;

pub use request::{is_meant, nothing};

use crate::arguments::DrawArguments;
use crate::ask::constants::Constants;
use crate::ask::file;
use crate::error::Failure;
use crate::linkage::case::{Axis, Case};
use crate::plot::figure;
use crate::plot::name;
use crate::show::number;
use crate::show::output::{self, Destination};
use crate::show::page::Page;
use crate::show::style;
use crate::show::text::{Align, Columns};
use crate::show::unit;
use mesh::Mesh;
use patch::{Patch, surfaces};
use picture::Picture;
use view::View;

/// Cells of the picture are no finer than this part of its size: their lines would run together.
const FINEST: f64 = 0.008;

/// Whether a scene may be drawn as a surface.
pub fn is_surface(scene: &'static SceneEntry) -> bool {
    !surfaces(scene).is_empty()
}

/// Draws scenes as surfaces in one picture.
///
/// # Errors
/// A wrong request, or a surface that is nowhere, nothing being written then.
pub fn execute(options: &DrawArguments, scenes: Vec<Constants>) -> Result<(), Failure> {
    let asked = &options.surface;
    request::check(options, &scenes)?;
    let outputs = request::outputs(asked.surface.as_deref(), &scenes)?;
    let view = View::read(asked.view.as_deref())?;
    let files = Files::check(options, &scenes)?;
    let title = scenes.first().map_or("", |one| one.mechanism.title);
    let lead = lead(&scenes);
    let cases = scenes.into_iter().map(Case::new).collect::<Result<Vec<_>, _>>()?;
    let pairs = cases.iter().zip(&outputs);
    let patches = pairs.map(|(case, output)| Patch::of(case, *output, asked.places.as_deref()));
    let patches = patches.collect::<Result<Vec<_>, _>>()?;
    let mesh = Mesh::new(&patches, &asked.flip);
    let Some(output) =
        outputs.first().filter(|_| mesh.parts.iter().any(|part| !part.cells.is_empty()))
    else {
        return Err(Failure::numerical(
            "there is nothing to draw: the surface has no value anywhere",
        )
        .remedy("look at its values with `assur run`"));
    };
    let about = format!("{title}, surface {}", output.name);
    let thinned: Vec<_> = patches.iter().map(|patch| patch.thinned(FINEST * mesh.size())).collect();
    let picture = Picture {
        mesh: &Mesh::new(&thinned, &[]),
        title: format!("{title}: surface {}", output.name),
        lead: format!("{lead} Seen {}, without perspective.", view.in_words()).trim().to_owned(),
        legend: patches.iter().map(legend).collect(),
        view,
    };
    files.write(&mesh, &about, picture.draw())?;
    let mut page = Page::new(style::stdout());
    page.table(&about, &table(&mesh));
    page.text += &files.in_words();
    output::print(&page.text)
}

/// The files that are written.
struct Files {
    picture: Destination,
    obj: Option<Destination>,
    stl: Option<Destination>,
}

impl Files {
    /// Looks whether they can be.
    fn check(options: &DrawArguments, scenes: &[Constants]) -> Result<Self, Failure> {
        let mechanism = scenes.first().map_or("", |one| file::stem(one.mechanism));
        let name = match scenes {
            [one] => format!("{mechanism}-{}-surface.svg", one.scene.name),
            _ => format!("{mechanism}-surface.svg"),
        };
        let directory = options.out.as_deref().unwrap_or(Path::new("."));
        let file = |option: &str, path: &Path| {
            Destination::check(path)
                .map_err(|failure| failure.place(format!("{option} {}", path.display())))
        };
        let (obj, stl) = (&options.surface.obj, &options.surface.stl);
        Ok(Self {
            picture: Destination::check(&directory.join(name))?,
            obj: obj.as_deref().map(|path| file("--obj", path)).transpose()?,
            stl: stl.as_deref().map(|path| file("--stl", path)).transpose()?,
        })
    }

    fn write(&self, mesh: &Mesh, about: &str, picture: String) -> Result<(), Failure> {
        self.picture.write(picture.as_bytes())?;
        if let Some(file) = &self.obj {
            file.write(files::obj(mesh, about).as_bytes())?;
        }
        if let Some(file) = &self.stl {
            file.write(&files::stl(mesh, about))?;
        }
        Ok(())
    }

    fn in_words(&self) -> String {
        let mut text = format!("Picture: {}\n", self.picture.path().display());
        for (kind, file) in [("OBJ:    ", &self.obj), ("STL:    ", &self.stl)] {
            if let Some(file) = file {
                text += &format!("{kind} {}, lengths in mm\n", file.path().display());
            }
        }
        text
    }
}

/// What the scenes are, and which values were changed.
fn lead(scenes: &[Constants]) -> String {
    match scenes {
        [one] => figure::lead(one),
        _ => scenes.first().map(figure::changed).unwrap_or_default(),
    }
}

/// A scene with what it sweeps, `ball: a = 0° to 90°, b = 0 mm to 10 mm`.
fn legend(patch: &Patch) -> String {
    let range = |axis: &Axis| {
        let quantity = &axis.quantity;
        let amount = |value: f64| {
            let number = number::short(number::rounded(unit::stated(value, quantity.factor), 5));
            match name::unit(quantity.unit).as_str() {
                "°" => number + "°",
                other => format!("{number} {other}").trim_end().to_owned(),
            }
        };
        format!("{} = {} to {}", name::set(quantity.name).text, amount(axis.from), amount(axis.to))
    };
    format!("{}: {}", patch.scene, patch.axes.each_ref().map(range).join(", "))
}

/// The scenes with the numbers of their facets, and of what is left out.
fn table(mesh: &Mesh) -> Columns {
    let mut table = Columns::new([
        ("", Align::Left),
        ("facets", Align::Right),
        ("left out for want of a value", Align::Right),
        ("without area", Align::Right),
        ("outside by", Align::Left),
    ]);
    for part in &mesh.parts {
        let facets = mesh.facets(part).len();
        let some = |count: usize| if count > 0 { number::count(count) } else { String::new() };
        table.row([
            part.scene.to_owned(),
            number::count(facets),
            some(2 * part.missing),
            some(2 * part.cells.len() - facets),
            part.outside.clone(),
        ]);
    }
    table
}
