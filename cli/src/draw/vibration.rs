//! A vibration about a position of rest, larger than it is.

use std::f64::consts::TAU;

use assur::answer::Motion;
use assur::problem::Phase;
use assur::rest::{Rest, Vibration};

use super::geometry::{Frame, Geometry};
use super::{FRAMES, Shown};
use crate::error::Failure;
use crate::motion::case::Case;
use crate::show::number;

/// How far the point that goes farthest goes to each side, over the size of the drawing.
const FAR: f64 = 0.06;
/// Size of a drawing of which all points lie on each other, metres.
const SMALL: f64 = 1e-3;
/// The part of its scale by which the state is moved to see how far points go.
const LITTLE: f64 = 1e-4;
/// Seconds of one cycle in the picture.
const SECONDS: f64 = 2.0;

/// What is shown of a position of rest: the position, and the vibration of this number about it if one is asked for or it
/// has any.
///
/// # Errors
/// A vibration that it does not have, or that moves no point.
pub fn of(
    asked: Option<usize>,
    case: Case,
    motion: &Motion,
    rest: &Rest,
) -> Result<Shown, Failure> {
    let number = asked.unwrap_or(1);
    let swing = rest.vibration(number).and_then(|one| Swing::of(&case, motion, rest, one));
    if let (Some(_), None) = (asked, &swing) {
        let count = rest.vibrations.iter().filter(|one| one.vibrates()).count();
        let why = match number <= count && number > 0 {
            true => format!("vibration {number} moves no point of the drawing"),
            false => format!("vibrations about the position of rest: {count}"),
        };
        return Err(Failure::request(format!("there is no vibration {number} to draw"))
            .place("--vibration")
            .reason(why)
            .remedy("`assur run` shows them with their shapes"));
    }
    let at = |share: f64| match &swing {
        Some(swing) => swing.frame(&case, motion, rest, TAU * share),
        None => frame(&case, motion, &rest.state),
    };
    let cycle: Vec<_> = (0..=FRAMES).map(|index| at(index as f64 / FRAMES as f64)).collect();
    let middle = frame(&case, motion, &rest.state);
    let (positions, frames) = match &swing {
        Some(_) => (vec![middle, at(0.0), at(0.5)], cycle),
        None => (vec![middle.clone()], vec![middle]),
    };
    let geometry =
        Geometry::new(case.scene.points.len(), std::slice::from_ref(&frames), positions.iter());
    let short = |value: f64| number::short(number::rounded(value, 4));
    let label = match &swing {
        Some(swing) => {
            let frequency = short(swing.vibration.frequency());
            format!("at rest, and in vibration {number} of {frequency} Hz")
        }
        None => "at rest".to_owned(),
    };
    let pace = match &swing {
        Some(_) => " Larger than it is, as if nothing died out or grew.".to_owned(),
        None => String::new(),
    };
    Ok(Shown {
        constants: case.constants,
        seconds: SECONDS,
        note: None,
        stop: None,
        geometry,
        label,
        positions,
        frames,
        pace,
    })
}

/// Why a scene that does not rest has none.
pub fn none(scene: &str) -> Failure {
    Failure::request(format!("scene `{scene}` has no position of rest"))
        .place("--vibration")
        .reason("vibrations are those about a position of rest")
        .remedy("choose a scene that rests, with --scene")
}

/// A vibration with the amplitude in which it is drawn.
struct Swing<'a> {
    vibration: &'a Vibration,
    amplitude: f64,
}

impl<'a> Swing<'a> {
    /// None where it moves no point.
    fn of(case: &Case, motion: &Motion, rest: &Rest, vibration: &'a Vibration) -> Option<Self> {
        let little = Self { vibration, amplitude: LITTLE };
        let middle = frame(case, motion, &rest.state).points;
        let quarters =
            (0..8).map(|part| little.frame(case, motion, rest, TAU * f64::from(part) / 8.0));
        let apart = |(a, b): (&(f64, f64), &(f64, f64))| (a.0 - b.0).hypot(a.1 - b.1);
        let far = |frame: Frame| frame.points.iter().zip(&middle).map(apart).fold(0.0, f64::max);
        let far = quarters.map(far).fold(0.0, f64::max);
        let size = middle.iter().flat_map(|a| middle.iter().map(move |b| apart((a, b))));
        let size = size.fold(SMALL, f64::max);
        let moves = far > 1e-9 * LITTLE * size;
        moves.then(|| Self { vibration, amplitude: FAR * size / far * LITTLE })
    }

    /// Where everything is at an angle of the cycle.
    fn frame(&self, case: &Case, motion: &Motion, rest: &Rest, angle: f64) -> Frame {
        let (sine, cosine) = angle.sin_cos();
        let moved =
            rest.state.iter().zip(&self.vibration.shape).map(|(middle, (real, imaginary))| {
                middle + self.amplitude * (real * cosine - imaginary * sine)
            });
        frame(case, motion, &moved.collect::<Vec<_>>())
    }
}

/// Where everything is in a state.
fn frame(case: &Case, motion: &Motion, state: &[f64]) -> Frame {
    let reports = case.run().reports();
    let phase = Phase::of(motion.first_mode());
    let mut places = vec![0.0; case.scene.places()];
    let mut outputs = vec![0.0; motion.shape().outputs.len()];
    reports.points(phase, 0.0, state, &mut places);
    reports.outputs(phase, 0.0, state, &mut outputs);
    Frame::of(case.scene, &places, &outputs)
}
