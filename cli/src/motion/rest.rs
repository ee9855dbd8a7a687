//! A position of rest, and how the mechanism vibrates about it, in words.

use assur::rest::{Rest, Vibration};
use assur::shape::{Quantity, Shape, Subject};

use super::report::Report;
use crate::show::number;
use crate::show::page::{Page, WIDTH};
use crate::show::text::{Align, Columns, wrap};

/// Components of a shape that are shown, the largest first.
const MOST: usize = 4;
/// Components of less than this part of the largest are none.
const NOTHING: f64 = 1e-9;
/// Sine of the angle by which a component may lead or lag and still counts as going with or against.
const ALONG: f64 = 1e-6;

/// The table of vibrations, and what they say.
pub fn section(page: &mut Page, report: &Report, rest: &Rest) {
    let mut table = Columns::new([
        ("", Align::Right),
        ("frequency, Hz", Align::Point),
        ("damping", Align::Point),
        ("a disturbance", Align::Left),
        ("shape", Align::Left),
    ]);
    let mut number = 0;
    for one in &rest.vibrations {
        let vibrates = one.vibrates();
        number += usize::from(vibrates);
        let frequency = number::with_error(one.frequency(), one.error / std::f64::consts::TAU);
        let damping = || match one.grows() || one.dies_out() {
            true => number::significant(one.damping(), 4),
            false => "0".to_owned(),
        };
        table.row([
            if vibrates { number.to_string() } else { String::new() },
            if vibrates { frequency } else { "-".to_owned() },
            if vibrates { damping() } else { "-".to_owned() },
            meaning(one),
            shape(report.motion.shape(), one),
        ]);
    }
    page.table("Small disturbances of the rest", &table);
    for line in conclusions(report.motion.shape(), rest) {
        for (index, part) in wrap(&line, WIDTH - 4).iter().enumerate() {
            page.line(&format!("  {}{part}", if index == 0 { "" } else { "  " }));
        }
    }
    page.line("");
}

/// What becomes of a disturbance, in a few words.
pub fn meaning(one: &Vibration) -> String {
    let time = number::duration(1.0 / one.rate.abs());
    match () {
        () if one.grows() => format!("grows e-fold in {time}"),
        () if one.dies_out() => format!("falls to 1/e in {time}"),
        () if one.vibrates() => "lasts".to_owned(),
        () => "stays, or drifts away slowly".to_owned(),
    }
}

/// What is at rest and may move: coordinates and states, by their places in the state vector.
pub fn movable(shape: &Shape) -> impl Iterator<Item = usize> {
    (0..shape.coordinates).chain(2 * shape.coordinates..shape.states.len())
}

/// Whether a variable says something of a position of rest: speeds and accelerations are zero.
pub fn says(shape: &Shape, subject: Subject) -> bool {
    match subject {
        Subject::State(index) => movable(shape).any(|one| one == index),
        Subject::Rate(_) => false,
        _ => true,
    }
}

/// The amplitudes of a vibration, the largest being one of its units: for each quantity the amount in its unit, and by
/// how much it leads, in degrees.
pub fn amplitudes<'a>(shape: &'a Shape, one: &Vibration) -> Vec<(&'a Quantity, f64, f64)> {
    let amplitude = |index: usize| {
        let (re, im) = one.shape[index];
        (re.hypot(im), im.atan2(re).to_degrees())
    };
    let over = |index: usize| amplitude(index).0 / shape.scales[index];
    let mut places: Vec<usize> = movable(shape).collect();
    places.sort_by(|a, b| over(*b).total_cmp(&over(*a)));
    let Some(first) = places.first().copied().filter(|first| over(*first) > 0.0) else {
        return Vec::new();
    };
    let unit = amplitude(first).0 / shape.states[first].factor;
    let shown = places.into_iter().filter(|index| over(*index) > NOTHING * over(first));
    let shown = shown.map(|index| {
        let quantity = &shape.states[index];
        let (size, lead) = amplitude(index);
        (quantity, size / quantity.factor / unit, lead)
    });
    shown.collect()
}

/// The largest amplitudes in words: `x 1 mm, theta -0.2 deg, y 0.5 mm leading by 90°`.
fn shape(shape: &Shape, one: &Vibration) -> String {
    let all = amplitudes(shape, one);
    let word = |(quantity, size, lead): &(&Quantity, f64, f64)| {
        let is_along = lead.to_radians().sin().abs() <= ALONG;
        let size = if is_along && lead.abs() > 90.0 { -size } else { *size };
        let amount = format!(
            "{} {} {}",
            quantity.name,
            number::short(number::rounded(size, 4)),
            quantity.unit
        );
        match is_along {
            true => amount.trim_end().to_owned(),
            false => {
                let word = if *lead > 0.0 { "leading" } else { "lagging" };
                format!(
                    "{} {word} by {}°",
                    amount.trim_end(),
                    number::short(number::rounded(lead.abs(), 3))
                )
            }
        }
    };
    let mut words: Vec<String> = all.iter().take(MOST).map(word).collect();
    if all.len() > MOST {
        words.push("…".to_owned());
    }
    words.join(", ")
}

/// What all of them together say, a sentence each.
pub fn conclusions(shape: &Shape, rest: &Rest) -> Vec<String> {
    let all = &rest.vibrations;
    let mut lines = Vec::new();
    match rest.growing() {
        Some(fastest) => lines.push(format!(
            "unstable: a disturbance grows e-fold in {}, and it does not stay there",
            number::duration(1.0 / fastest.rate)
        )),
        None if all.is_empty() => lines.push("nothing can move".to_owned()),
        None if all.iter().all(Vibration::dies_out) => {
            lines.push("stable: every small disturbance dies out".to_owned());
        }
        None if rest.free == 0 => lines.push(
            "no small disturbance grows, and not all die out: without losses it vibrates for ever"
                .to_owned(),
        ),
        None => {}
    }
    if rest.free > 0 {
        let plural = if rest.free == 1 { "" } else { "s" };
        lines.push(format!(
            "indifferent in {} direction{plural}: it would rest as well a little aside, and the start values say where",
            rest.free
        ));
    }
    let kink = rest.kink.and_then(|event| {
        let mode = shape.modes.iter().find(|mode| mode.events.len() > event)?;
        Some(mode.events[event].text)
    });
    if let Some(text) = kink {
        lines.push(format!(
            "it rests where a branch of the equations goes over to the other one ({text}): the vibrations are those of one \
             side, and a disturbance comes to both"
        ));
    }
    lines
}
