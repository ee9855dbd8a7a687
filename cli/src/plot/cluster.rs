//! The variables of a figure, and which of them may share a panel: those of one kind and of comparable size.

use super::kind::Kind;
use super::panels::Data;
use super::selection::Selection;
use crate::ask::variables::Variable;

/// A curve this many times smaller than another would be a flat line beside it and gets a panel of its own.
const COMPARABLE: f64 = 15.0;
/// Curves closer than this share of the height of a panel are drawn as one.
const COINCIDENT: f64 = 0.006;

/// One variable with its samples in SI units.
pub struct Track<'a> {
    /// Index of the variable.
    pub index: usize,
    /// The variable.
    pub variable: &'a Variable,
    /// Its kind.
    pub kind: Kind,
    /// Its samples.
    pub values: Vec<f64>,
    /// Its largest absolute value.
    pub amplitude: f64,
}

/// The variables that are wanted.
pub fn tracks<'a>(data: &Data<'a>, selection: &Selection) -> Vec<Track<'a>> {
    let variables = data.variables.iter().enumerate();
    let wanted = variables.filter(|(_, variable)| selection.admits(&variable.name));
    let track = |(index, variable): (usize, &'a Variable)| {
        let values: Vec<f64> = data.values.iter().map(|row| row[index]).collect();
        let amplitude = values
            .iter()
            .filter(|value| value.is_finite())
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        Track { index, variable, kind: Kind::of(variable), values, amplitude }
    };
    wanted.map(track).collect()
}

/// Tracks that may share a panel, each list in the order of the scene, the list of the largest first.
pub fn clusters<'a, 't>(tracks: &'t [Track<'a>]) -> Vec<Vec<&'t Track<'a>>> {
    let mut clusters: Vec<Vec<&Track<'_>>> = Vec::new();
    let mut by_size: Vec<_> = tracks.iter().collect();
    by_size.sort_by(|a, b| b.amplitude.total_cmp(&a.amplitude));
    for track in by_size {
        let fits = |cluster: &&mut Vec<&Track<'_>>| {
            let largest = cluster[0];
            // What is zero but for rounding stays with the others.
            let size = largest.amplitude / track.amplitude;
            largest.kind == track.kind && (!(COMPARABLE..=1e8).contains(&size) || size.is_nan())
        };
        match clusters.iter_mut().find(fits) {
            Some(cluster) => cluster.push(track),
            None => clusters.push(vec![track]),
        }
    }
    for cluster in &mut clusters {
        cluster.sort_by_key(|track| track.index);
    }
    clusters
}

/// The unit in which most of the cluster is given, of two the one with the handier numbers; a finer one where these
/// would be small.
pub fn unit<'t>(cluster: &[&'t Track<'_>]) -> (&'t str, f64) {
    let most = cluster.iter().map(|track| track.amplitude).fold(0.0, f64::max);
    let rank = |track: &Track<'_>| {
        let same =
            cluster.iter().filter(|other| other.variable.unit == track.variable.unit).count();
        let handy = (0.5..5000.0).contains(&(most / track.variable.factor));
        (handy, same)
    };
    let mut best: Option<&Track<'_>> = None;
    for track in cluster {
        if best.is_none_or(|best| rank(track) > rank(best)) {
            best = Some(track);
        }
    }
    best.map_or(("", 1.0), |track| finer_unit(track, most))
}

/// Tracks that cannot be told apart at the scale of their panel, together.
pub fn coincident<'a, 't>(cluster: &[&'t Track<'a>]) -> Vec<Vec<&'t Track<'a>>> {
    let all = || {
        cluster
            .iter()
            .flat_map(|track| track.values.iter().copied())
            .filter(|value| value.is_finite())
    };
    let height = all().fold(f64::NEG_INFINITY, f64::max) - all().fold(f64::INFINITY, f64::min);
    let mut groups: Vec<Vec<&Track<'_>>> = Vec::new();
    for track in cluster {
        let near = |group: &&mut Vec<&Track<'_>>| {
            let pairs = group[0].values.iter().zip(&track.values);
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) <= COINCIDENT * height
        };
        match groups.iter_mut().find(near) {
            Some(group) => group.push(track),
            None => groups.push(vec![track]),
        }
    }
    groups
}

/// A unit in which a small difference has handy numbers.
pub fn finer_unit<'t>(track: &'t Track<'_>, most: f64) -> (&'t str, f64) {
    let own = (track.variable.unit.as_str(), track.variable.factor);
    let finer: &[(&str, f64)] = match track.kind {
        Kind::Translation(0) => &[("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9)],
        Kind::Translation(1) if own.0 == "m/s" => &[("mm/s", 1e-3), ("um/s", 1e-6)],
        Kind::Rotation(_) if own.0 == "rad" => &[("mrad", 1e-3), ("urad", 1e-6)],
        _ => &[],
    };
    let handy =
        finer.iter().copied().find(|(_, factor)| *factor < own.1 * 1.1 && most / factor >= 0.1);
    handy.filter(|_| most / own.1 < 0.1).unwrap_or(own)
}
