//! Ways, passages and straight lines, and what an event does at the ends of pieces.

use super::{found, is, of, run};
use crate::hybrid::{Motion, Numbers, Piece};
use crate::measure::{Kind, Missing, Moment, Primitive};
use std::f64::consts::PI;

/// Two pieces with an event between them.
fn broken(at: f64, to: f64) -> Motion {
    let pieces = [run(0.0, at, 3), run(at, to, 3)].map(|part| Piece {
        mode: 0,
        trajectory: part.pieces[0].trajectory.clone(),
        sides: Numbers::default(),
    });
    Motion { pieces: pieces.into(), ..run(0.0, to, 1) }
}

#[test]
fn a_way_is_gone_forth_and_back() {
    let wave = |time: f64| (2.0 * time).sin();
    // Three steps in two waves, with turns that no end of a step shows.
    for steps in [3, 7, 40] {
        let motion = run(0.0, 2.0 * PI, steps);
        is(found(&motion, of(Kind::Travel), &[&wave]), 8.0, 1e-13);
    }
    let motion = run(0.0, 2.0 * PI, 11);
    let above = |time: f64| (2.0 * time).sin() - 0.5;
    let within = Primitive { window: Some(1), ..of(Kind::Travel) };
    is(found(&motion, within, &[&wave, &above]), 2.0, 1e-13);
    let place = |time: f64| 3.0 * time;
    is(found(&motion, within, &[&place, &above]), 2.0 * PI, 1e-13);
}

#[test]
fn passages_are_found_and_counted() {
    let time = |time: f64| time;
    for steps in [2, 5, 30] {
        let motion = run(0.0, 10.0, steps);
        let wave = |time: f64| (time - 0.3).sin();
        let at = |last| Kind::Value(Moment::Passes { index: 1, last });
        is(found(&motion, of(at(false)), &[&time, &wave]), 0.3, 1e-14);
        is(found(&motion, of(at(true)), &[&time, &wave]), 3.0 * PI + 0.3, 1e-14);
        let count = of(Kind::Count(Moment::Passes { index: 1, last: false }));
        is(found(&motion, count, &[&time, &wave]), 4.0, 0.0);
        // Two passages within one part of a step.
        let dip = |time: f64| (time - 4.567).powi(2) - 1e-10;
        is(found(&motion, count, &[&time, &dip]), 2.0, 0.0);
        is(found(&motion, of(at(false)), &[&time, &dip]), 4.567 - 1e-5, 1e-10);
        let never = |_: f64| 1.0;
        assert_eq!(found(&motion, of(at(false)), &[&time, &never]), Err(Missing::NeverPasses));
        is(found(&motion, count, &[&time, &never]), 0.0, 0.0);
        // A run that begins, or ends, at zero passes it there, whichever way it goes.
        for sign in [1.0, -1.0] {
            let leaves = |time: f64| sign * time;
            is(found(&motion, count, &[&time, &leaves]), 1.0, 0.0);
            is(found(&motion, of(at(false)), &[&time, &leaves]), 0.0, 1e-300);
            let reaches = |time: f64| sign * (time - 10.0);
            is(found(&motion, count, &[&time, &reaches]), 1.0, 0.0);
            is(found(&motion, of(at(true)), &[&time, &reaches]), 10.0, 0.0);
        }
    }
    // What jumps over zero at an event passes it there.
    let count = of(Kind::Count(Moment::Passes { index: 0, last: false }));
    let jump = |time: f64| if time < 1.5 { -1.0 } else { 1.0 };
    is(found(&broken(1.5, 4.0), count, &[&jump]), 1.0, 0.0);
}

/// The best line of degree one through `exp` on an interval is known: its slope is that of the chord, and the largest deviation
/// half of the height between chord and tangent (Chebyshev).
#[test]
fn curves_deviate_from_the_best_line() {
    for steps in [1, 4, 25] {
        let motion = run(0.0, 1.0, steps);
        let (x, y) = (|time: f64| time, |time: f64| time.exp());
        let slope = 1f64.exp() - 1.0;
        let touch = slope.ln();
        let expected = (1.0 + slope * touch - slope) / 2.0;
        is(found(&motion, of(Kind::Straightness(1)), &[&y, &x]), expected, 1e-14);
        // Along a line gone forth and back nothing deviates; a circle deviates by its radius.
        let (forth, twice) =
            (|time: f64| (7.0 * time).sin(), |time: f64| 3.0 + 2.0 * (7.0 * time).sin());
        is(found(&motion, of(Kind::Straightness(1)), &[&twice, &forth]), 0.0, 1e-14);
        let turn = |time: f64| 2.0 * PI * time;
        let (cosine, sine) = (|time: f64| turn(time).cos(), |time: f64| turn(time).sin());
        is(found(&motion, of(Kind::Straightness(1)), &[&sine, &cosine]), 1.0, 1e-14);
    }
}

/// Beside an event quantities may be mixed of both sides; those of a piece are looked at inside of it.
#[test]
fn an_event_is_no_spike() {
    let motion = broken(1.5, 4.0);
    let spike = |time: f64| if time == 1.5 { 1e6 } else { time };
    is(found(&motion, of(Kind::Peak), &[&spike]), 4.0, 0.0);
    let jump = |time: f64| if time > 1.5 - 1e-15 { 0.0 } else { time };
    is(found(&motion, of(Kind::Peak), &[&jump]), 1.5, 1e-13);
}
