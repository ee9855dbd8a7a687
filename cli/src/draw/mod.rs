//! `assur draw`: a mechanism at some positions, and moving.
//!
//! | file | what it does |
//! |---|---|
//! | `travel`, `course` | positions of a linkage on its way, of a motion in time |
//! | `vibration` | a vibration about a position of rest |
//! | `geometry` | which points stand, which move, which move straight |
//! | `sheet` | the paper: scale, title, legend, scale bar |
//! | `joints`, `names`, `forces` | pivots and slides at one position, names of points, arrows |
//! | `still`, `moving` | the two pictures |
//! | `surface` | surfaces, which are drawn otherwise |

mod course;
mod forces;
mod geometry;
mod joints;
mod moving;
mod names;
mod sheet;
mod still;
pub mod surface;
mod travel;
mod vibration;

use std::path::PathBuf;

use assur::registry::SceneEntry;

use crate::arguments::DrawArguments;
use crate::ask::constants::Constants;
use crate::ask::lookup::Registry;
use crate::ask::{For, file};
use crate::error::Failure;
use crate::show::output::{self, Destination};
use geometry::{Frame, Geometry};

/// Positions that are drawn unless others are asked for.
const POSITIONS: usize = 5;
/// Positions that are drawn of a motion that comes back to its beginning.
const AROUND: usize = 6;
/// Positions of the moving picture.
const FRAMES: usize = 96;

/// Draws a mechanism.
///
/// # Errors
/// A wrong request, nothing being written then; or a linkage that does not get everywhere, after the rest of its way has
/// been drawn.
pub fn execute(options: &DrawArguments, registry: Registry) -> Result<(), Failure> {
    let mut scenes = options.asked.find_all(registry, "draw", For::Drawn)?;
    let constants = match scenes.pop() {
        Some(only) if scenes.is_empty() && !surface::is_meant(options, only.scene)? => only,
        last => return surface::execute(options, scenes.into_iter().chain(last).collect()),
    };
    let (mechanism, scene) = (constants.mechanism, constants.scene);
    let directory = options.out.clone().unwrap_or_else(|| PathBuf::from("."));
    let file = |what: &str| {
        let name = format!("{}-{}-{what}.svg", file::stem(mechanism), scene.name);
        Destination::check(&directory.join(name))
    };
    let (still, moving) = (file("positions")?, file("moving")?);
    if options.forces && scene.arrows.is_empty() {
        return Err(Failure::request(format!("scene `{}` has no forces to draw", scene.name))
            .place("--forces")
            .reason("an arrow is an output that is the `reaction` of a closure in the plane, between places")
            .remedy("report one in the equation file: output pin = reaction(pin) [N];"));
    }
    let changes = constants.changes.join(" ");
    let shown = Shown::of(options, constants)?;
    let picture = shown.picture();
    still.write(shown.still().as_bytes())?;
    let mut text = format!(
        "{}, scene {}: {}\nPositions: {}\n",
        mechanism.title,
        scene.name,
        picture.label,
        still.path().display()
    );
    if !changes.is_empty() {
        text += &format!("Changed:   {changes}\n");
    }
    if let Some(note) = &shown.note {
        text += &format!("Note:      {note}\n");
    }
    if shown.frames.len() > 1 {
        moving.write(moving::draw(&picture, &shown.frames, shown.seconds).as_bytes())?;
        text += &format!("Moving:    {}\n", moving.path().display());
    }
    output::print(&text)?;
    shown.stop.map_or(Ok(()), Err)
}

/// A scene at some positions, as a picture.
///
/// # Errors
/// A scene that cannot be drawn, or does not get anywhere.
pub fn still(constants: Constants) -> Result<String, Failure> {
    Ok(Shown::of(&DrawArguments::default(), constants)?.still())
}

/// What is shown of a mechanism.
struct Shown {
    /// The scene with its values.
    constants: Constants,
    /// Its points along the way.
    geometry: Geometry,
    /// The positions in words.
    label: String,
    /// The positions.
    positions: Vec<Frame>,
    /// Those of the moving picture, evenly apart in time.
    frames: Vec<Frame>,
    /// How long these take.
    seconds: f64,
    /// How fast that is, in words; empty where it means nothing.
    pace: String,
    /// What else there is to say.
    note: Option<String>,
    /// Why it does not get everywhere.
    stop: Option<Failure>,
}

impl Shown {
    /// What is asked for, forces only if they are.
    ///
    /// # Errors
    /// A wrong request, or a scene that cannot be put together or followed.
    fn of(options: &DrawArguments, constants: Constants) -> Result<Self, Failure> {
        let scene = constants.scene;
        let mut shown = match scene.linkage {
            Some(_) if options.vibration.is_some() => return Err(vibration::none(scene.name)),
            Some(_) => travel::of(options, constants)?,
            None => course::of(options, constants)?,
        };
        if !options.forces {
            let frames = shown.positions.iter_mut().chain(&mut shown.frames);
            frames.for_each(|frame| frame.forces.clear());
        }
        Ok(shown)
    }

    /// What its pictures show.
    fn picture(&self) -> Picture<'_> {
        Picture {
            constants: &self.constants,
            geometry: &self.geometry,
            label: self.label.clone(),
            pace: self.pace.clone(),
            force: forces::largest(self.positions.iter().chain(&self.frames)),
        }
    }

    /// Its positions as a picture.
    fn still(&self) -> String {
        let positions: Vec<_> = self.positions.iter().collect();
        still::draw(&self.picture(), &positions)
    }
}

/// What a picture shows.
pub struct Picture<'a> {
    /// The scene with its values.
    pub constants: &'a Constants,
    /// Its points along the way.
    pub geometry: &'a Geometry,
    /// The positions in words.
    pub label: String,
    /// How fast it moves, in words.
    pub pace: String,
    /// The largest force, newtons; zero where none are drawn.
    pub force: f64,
}

impl Picture<'_> {
    /// The scene.
    pub fn scene(&self) -> &'static SceneEntry {
        self.constants.scene
    }
}
