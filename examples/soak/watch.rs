//! What stays in a motion whatever it does: loops stay closed, and where nothing takes energy or gives it, there is as much as
//! in the beginning. Both are known to what the states are known to.

use std::sync::Arc;

use assur::answer::{Estimate, Motion, Question, Settings};
use assur::model::Model;
use assur::problem::Phase;
use assur::shape::Subject;

use crate::answer::Kind;
use crate::case::{Case, Precision};
use crate::judge::Compared;

/// Places in the task that are looked at.
const PLACES: usize = 61;
/// Energy stays where a reference loses less, over what is exchanged.
const STAYS: f64 = 1e-9;
/// Sizes are known to this part of them, by roundings.
const ROUNDED: f64 = 1e-12;

/// A place of a motion.
struct Place {
    time: f64,
    mode: usize,
    state: Vec<f64>,
    /// What is told of the errors of the states.
    errors: Vec<f64>,
}

/// How far loops are open and energy has changed, over what the errors of the states explain; nothing of scenes without either.
pub fn watch(case: &Case) -> Vec<Compared> {
    let Some((model, settings)) = case.model().zip(case.settings(Precision::Tried)) else {
        return Vec::new();
    };
    let shape = model.shape();
    let is_held =
        shape.augmented.is_some() || shape.modes.iter().any(|mode| mode.augmented.is_some());
    let stays = case.settings(Precision::Reference).is_some_and(|finest| stays(&model, &finest));
    if !is_held && !stays {
        return Vec::new();
    }
    let Some(places) = places(&model, &settings) else {
        return Vec::new();
    };
    let open = is_held.then(|| open(model.as_ref(), &places)).flatten();
    let lost = stays.then(|| lost(model.as_ref(), &places)).flatten();
    open.into_iter().chain(lost).collect()
}

fn times(motion: &Motion) -> impl Iterator<Item = f64> {
    let (from, to) = motion.task().limits();
    (0..PLACES).map(move |index| from + (to - from) * index as f64 / (PLACES - 1) as f64)
}

fn places(model: &Arc<dyn Model>, settings: &Settings) -> Option<Vec<Place>> {
    let motion = Question::of(model.clone()).solve(settings).ok()?;
    let estimate: Estimate = motion.estimate().ok()?;
    let states: Vec<Subject> = (0..model.shape().states.len()).map(Subject::State).collect();
    let places = times(&motion).map(|time| {
        let (mode, state) = motion.place(time);
        Place { time, mode, state, errors: estimate.at(&motion, &states, time) }
    });
    Some(places.collect())
}

fn energies(model: &dyn Model, place: &Place, state: &[f64]) -> Option<(f64, f64)> {
    model.reports().energy(Phase::of(place.mode), place.time, state)
}

/// The energy that is exchanged up to each place between motion and position, the most of it.
fn exchanged(model: &dyn Model, places: &[Place]) -> Option<f64> {
    let (_, level) = energies(model, &places[0], &places[0].state)?;
    let mut amounts = places.iter().map(|place| {
        let (kinetic, potential) = energies(model, place, &place.state)?;
        Some(kinetic.abs() + (potential - level).abs())
    });
    amounts.try_fold(0.0, |most, amount| Some(f64::max(most, amount?)))
}

/// Changes of the energy up to each place.
fn changes(model: &dyn Model, places: &[Place]) -> Option<Vec<f64>> {
    let (kinetic, potential) = energies(model, &places[0], &places[0].state)?;
    let changes = places.iter().map(|place| {
        let (now, level) = energies(model, place, &place.state)?;
        Some(now - kinetic + (level - potential))
    });
    changes.collect()
}

/// Whether nothing takes energy or gives it, as a far more accurate motion has it.
fn stays(model: &Arc<dyn Model>, settings: &Settings) -> bool {
    if model.reports().energy(Phase::of(model.shape().first), 0.0, &model.start()).is_none() {
        return false;
    }
    let Ok(motion) = Question::of(model.clone()).solve(settings) else {
        return false;
    };
    let places: Vec<Place> = times(&motion)
        .map(|time| {
            let (mode, state) = motion.place(time);
            Place { time, mode, state, errors: Vec::new() }
        })
        .collect();
    let found = exchanged(model.as_ref(), &places).zip(changes(model.as_ref(), &places));
    found.is_some_and(|(exchanged, changes)| {
        exchanged > 0.0 && changes.iter().all(|change| change.abs() <= STAYS * exchanged)
    })
}

/// The change of the energy over what errors of the states change it by, where it is largest.
fn lost(model: &dyn Model, places: &[Place]) -> Option<Compared> {
    let exchanged = exchanged(model, places)?;
    let changes = changes(model, places)?;
    let ratios = places.iter().zip(changes).map(|(place, change)| {
        let (kinetic, potential) = energies(model, place, &place.state)?;
        let mut told = (0..place.state.len()).map(|index| {
            let mut beside = place.state.clone();
            beside[index] += place.errors[index];
            let (now, level) = energies(model, place, &beside)?;
            Some((now - kinetic + (level - potential)).abs())
        });
        let told = told.try_fold(ROUNDED * exchanged, |sum, part| Some(sum + part?))?;
        Some((change.abs() / told, place.time, change, told))
    });
    let ratios: Option<Vec<_>> = ratios.collect();
    let worst = ratios?.into_iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    let (ratio, time, change, told) = worst;
    let what = format!("energy changes by {change:.1e} J up to {time:.3e} s, said {told:.1e} J");
    Some(Compared { kind: Kind::Energy, ratio: Some(ratio), what })
}

/// How far closures are open over what errors of the coordinates open them by, where that is worst.
fn open(model: &dyn Model, places: &[Place]) -> Option<Compared> {
    let mut worst: Option<(f64, String)> = None;
    for place in places {
        let Some(held) = model.shape().held_in(place.mode) else {
            continue;
        };
        let (n, m) = (held.coordinates, held.loops.len());
        let mut values = vec![0.0; m * (2 + n)];
        model.reports().closures(Phase::of(place.mode), place.time, &place.state, &mut values);
        for row in 0..m {
            let slopes = &values[2 * m + row * n..][..n];
            let parts = slopes.iter().zip(&place.state).zip(&place.errors);
            let told: f64 = parts
                .map(|((slope, value), error)| {
                    slope.abs() * (error + ROUNDED * (1.0 + value.abs()))
                })
                .sum();
            let ratio = values[row].abs() / told;
            if worst.as_ref().is_none_or(|(most, _)| ratio > *most) {
                let what = format!(
                    "loop {} is open by {:.1e} at {:.3e} s, said {told:.1e}",
                    row + 1,
                    values[row],
                    place.time
                );
                worst = Some((ratio, what));
            }
        }
    }
    worst.map(|(ratio, what)| Compared { kind: Kind::Closure, ratio: Some(ratio), what })
}
