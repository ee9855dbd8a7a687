//! A motion in time.

use assur::answer::{Motion, Settings};
use assur::problem::{Phase, Span};

use super::geometry::{Frame, Geometry};
use super::{AROUND, FRAMES, POSITIONS, Shown, vibration};
use crate::arguments::DrawArguments;
use crate::ask::constants::Constants;
use crate::ask::place::Place;
use crate::ask::values::TIME;
use crate::error::Failure;
use crate::motion::case::Case;
use crate::plot::name;
use crate::show::number;

/// Seconds of the moving picture: as long as the motion is, within these.
const SECONDS: (f64, f64) = (4.0, 20.0);

/// What is shown of a motion. Where it comes to a dead point it goes on with all positions as coordinates.
///
/// # Errors
/// A wrong request, or a motion that cannot be followed.
pub fn of(options: &DrawArguments, constants: Constants) -> Result<Shown, Failure> {
    constants.going_on(|constants| follow(options, constants))
}

fn follow(options: &DrawArguments, constants: Constants) -> Result<Shown, Failure> {
    let mut case = Case::new(constants)?;
    let motion = case.solve(&Settings::default())?;
    case.repeat(&motion);
    let task = case.moved.task;
    if let Some(rest) = motion.rest() {
        return vibration::of(options.vibration, case, &motion, rest);
    }
    if options.vibration.is_some() {
        return Err(vibration::none(case.scene.name));
    }
    if task == Span::Open {
        return Err(Failure::request(format!("scene `{}` has no task to draw", case.scene.name))
            .remedy("choose one that runs, with --scene"));
    }
    let (from, to) = task.limits();
    let places = options.at.iter().map(|text| {
        let time_of = |index, position| case.run().time_of(index, position);
        Place::read(&case, text, true)?.in_time(&case, task, time_of)
    });
    let asked = places.collect::<Result<Vec<_>, _>>()?;
    let length = to - from;
    let seconds = length.clamp(SECONDS.0, SECONDS.1);
    let count = (FRAMES as f64 * seconds / SECONDS.0).round() as usize;
    let at = |index: usize| frame(&case, &motion, from + length * index as f64 / count as f64);
    let frames: Vec<_> = (0..=count).map(at).collect();
    let shown: Vec<_> = asked.iter().map(|(time, _)| frame(&case, &motion, *time)).collect();
    let geometry =
        Geometry::new(case.scene.points.len(), std::slice::from_ref(&frames), shown.iter());
    let (times, label) = match &asked[..] {
        [] => some(from, length, geometry.is_closed),
        asked => {
            let labels: Vec<_> = asked.iter().map(|(_, label)| label.clone()).collect();
            (asked.iter().map(|(time, _)| *time).collect(), labels.join("; "))
        }
    };
    Ok(Shown {
        positions: times.iter().map(|time| frame(&case, &motion, *time)).collect(),
        pace: pace(length / seconds),
        constants: case.constants,
        note: None,
        stop: None,
        geometry,
        label,
        frames,
        seconds,
    })
}

/// Where everything is at a time.
fn frame(case: &Case, motion: &Motion, time: f64) -> Frame {
    let position = motion.at_exactly(time);
    let mut places = vec![0.0; case.scene.places()];
    let phase = Phase::of(position.mode);
    case.run().reports().points(phase, time, &position.state, &mut places);
    Frame::of(case.scene, &places, &position.outputs)
}

/// Some times over the task, evenly apart; and the same in words.
fn some(from: f64, length: f64, is_closed: bool) -> (Vec<f64>, String) {
    let (count, parts) = match is_closed {
        true => (AROUND, AROUND),
        false => (POSITIONS, POSITIONS - 1),
    };
    let times = (0..count).map(|index| from + length * index as f64 / parts as f64);
    let times: Vec<f64> = times.collect();
    let texts = times.iter().map(|time| number::short(number::rounded(*time, 4)));
    let texts: Vec<_> = texts.collect();
    let time = name::set(TIME.name).text;
    (times, format!("{time} = {} s", texts.join(", ")))
}

/// How fast the picture moves.
fn pace(share: f64) -> String {
    let times = |share: f64| number::short(number::rounded(share, 2));
    match share {
        _ if (share - 1.0).abs() < 1e-9 => " As fast as it is.".to_owned(),
        _ if share < 1.0 => format!(" {} times slower than it is.", times(1.0 / share)),
        _ => format!(" {} times faster than it is.", times(share)),
    }
}
