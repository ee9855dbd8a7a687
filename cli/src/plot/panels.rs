//! Which curves share a panel: those of one kind and of comparable size.

use super::kind::Kind;
use super::name::{self, Name};
use crate::report::Report;
use crate::variables::Variable;

/// A curve this many times smaller than another would be a flat line beside it and gets a panel of its own.
const COMPARABLE: f64 = 15.0;
/// Curves closer than this share of the height of a panel are drawn as one.
const COINCIDENT: f64 = 0.006;

/// Curves with a common scale.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The kind of its quantities.
    pub kind: Kind,
    /// Heading.
    pub title: String,
    /// Unit, as a book sets it; empty for pure numbers.
    pub unit: String,
    /// The curves.
    pub curves: Vec<Line>,
    /// Published values: horizontal position, value, colour.
    pub facts: Vec<(f64, f64, Option<usize>)>,
}

/// A curve, or several that coincide.
#[derive(Clone, Debug)]
pub struct Line {
    /// Names of the variables.
    pub names: Vec<Name>,
    /// Values in the unit of the panel.
    pub values: Vec<f64>,
    /// Colour by number; none where several curves coincide.
    pub colour: Option<usize>,
}

/// One variable with its samples in SI units.
struct Track<'a> {
    index: usize,
    variable: &'a Variable,
    kind: Kind,
    values: Vec<f64>,
    amplitude: f64,
}

/// All panels of a report, sorted by kind.
pub fn choose(report: &Report, abscissa: &dyn Fn(f64) -> f64) -> Vec<Panel> {
    let tracks = tracks(report);
    let colours = colours(&tracks);
    let mut panels = Vec::new();
    for cluster in clusters(&tracks) {
        panels.extend(panel(report, &cluster, &colours, abscissa));
    }
    panels.sort_by_key(|panel| panel.kind.rank().1);
    panels
}

fn tracks(report: &Report) -> Vec<Track<'_>> {
    let variables = report.case.variables.iter().enumerate();
    let track = |(index, variable)| {
        let values: Vec<f64> = report.curves.values.iter().map(|row| row[index]).collect();
        let amplitude = values
            .iter()
            .filter(|value| value.is_finite())
            .fold(0.0, |most: f64, value| most.max(value.abs()));
        Track {
            index,
            variable,
            kind: Kind::of(variable),
            values,
            amplitude,
        }
    };
    variables.map(track).collect()
}

/// A colour for each track: the same for a coordinate and its derivatives.
fn colours(tracks: &[Track<'_>]) -> Vec<usize> {
    let mut seen: Vec<(Kind, &str)> = Vec::new();
    let mut colours = Vec::new();
    for track in tracks {
        let key = (track.kind.family(), name::base(&track.variable.name).0);
        let among = seen.iter().filter(|(family, _)| *family == key.0);
        let position = among.clone().position(|other| *other == key);
        colours.push(position.unwrap_or(among.count()));
        if position.is_none() {
            seen.push(key);
        }
    }
    colours
}

/// Tracks that may share a panel, each list in the order of the scene.
fn clusters<'a, 't>(tracks: &'t [Track<'a>]) -> Vec<Vec<&'t Track<'a>>> {
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
    clusters.sort_by_key(|cluster| cluster.first().map_or(0, |track| track.index));
    clusters
}

/// The panel of a cluster; a second one shows how curves that coincide in the first differ.
fn panel(
    report: &Report,
    cluster: &[&Track<'_>],
    colours: &[usize],
    abscissa: &dyn Fn(f64) -> f64,
) -> Vec<Panel> {
    let Some(first) = cluster.first() else {
        return Vec::new();
    };
    let (unit, factor) = unit(cluster);
    let groups = coincident(cluster);
    let line = |group: &Vec<&Track<'_>>| Line {
        names: group
            .iter()
            .map(|track| name::set(&track.variable.name))
            .collect(),
        values: group[0].values.iter().map(|value| value / factor).collect(),
        colour: (group.len() == 1).then(|| colours[group[0].index]),
    };
    let curves: Vec<_> = groups.iter().map(line).collect();
    let fact = |comparison: &crate::published::Comparison| {
        let group = groups
            .iter()
            .find(|group| group.iter().any(|track| track.index == comparison.variable))?;
        let time = comparison.time?;
        comparison.comparable.then_some(())?;
        let colour = (group.len() == 1).then(|| colours[comparison.variable]);
        Some((abscissa(time), comparison.fact.value / factor, colour))
    };
    let title = match first.kind.title() {
        "" => curves
            .iter()
            .flat_map(|line| &line.names)
            .map(|name| name.text.clone())
            .collect::<Vec<_>>()
            .join(", "),
        title => title.to_owned(),
    };
    let main = Panel {
        kind: first.kind,
        title,
        unit: name::unit(unit),
        curves,
        facts: report.published.iter().filter_map(fact).collect(),
    };
    let mut panels = vec![main];
    if first.kind.is_position() {
        let wide = groups.iter().filter(|group| group.len() > 1);
        panels.extend(wide.filter_map(|group| differences(report, group, colours)));
    }
    panels
}

/// The unit in which most of the cluster is given; of two, the one with the handier numbers.
fn unit<'t>(cluster: &[&'t Track<'_>]) -> (&'t str, f64) {
    let most = cluster
        .iter()
        .map(|track| track.amplitude)
        .fold(0.0, f64::max);
    let rank = |track: &Track<'_>| {
        let same = cluster
            .iter()
            .filter(|other| other.variable.unit == track.variable.unit)
            .count();
        let handy = (0.5..5000.0).contains(&(most / track.variable.factor));
        (handy, same)
    };
    let mut best: Option<&Track<'_>> = None;
    for track in cluster {
        if best.is_none_or(|best| rank(track) > rank(best)) {
            best = Some(track);
        }
    }
    best.map_or(("", 1.0), |track| {
        (track.variable.unit.as_str(), track.variable.factor)
    })
}

/// Tracks that cannot be told apart at the scale of their panel, together.
fn coincident<'a, 't>(cluster: &[&'t Track<'a>]) -> Vec<Vec<&'t Track<'a>>> {
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

/// How tracks that coincide at the scale of their panel differ from their mean, unless they are the same.
fn differences(report: &Report, group: &[&Track<'_>], colours: &[usize]) -> Option<Panel> {
    let first = group.first()?;
    let mean: Vec<f64> = (0..first.values.len())
        .map(|row| group.iter().map(|track| track.values[row]).sum::<f64>() / group.len() as f64)
        .collect();
    let apart = |track: &Track<'_>| -> Vec<f64> {
        track
            .values
            .iter()
            .zip(&mean)
            .map(|(value, mean)| value - mean)
            .collect()
    };
    let most = group
        .iter()
        .flat_map(|track| apart(track))
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    let noise = group
        .iter()
        .map(|track| report.errors[track.index])
        .fold(0.0, f64::max);
    if !(most > 20.0 * noise && most > 1e-9 * first.amplitude) {
        return None;
    }
    let (unit, factor) = finer_unit(first, most);
    let line = |track: &&Track<'_>| Line {
        names: vec![name::set(&track.variable.name)],
        values: apart(track).iter().map(|value| value / factor).collect(),
        colour: Some(colours[track.index]),
    };
    Some(Panel {
        kind: first.kind,
        title: format!("{}, each less the mean", first.kind.title()),
        unit: name::unit(unit),
        curves: group.iter().map(line).collect(),
        facts: Vec::new(),
    })
}

/// A unit in which a small difference has handy numbers.
fn finer_unit<'t>(track: &'t Track<'_>, most: f64) -> (&'t str, f64) {
    let own = (track.variable.unit.as_str(), track.variable.factor);
    let finer: &[(&str, f64)] = match track.kind {
        Kind::Translation(_) => &[("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9)],
        Kind::Rotation(_) if own.0 == "rad" => &[("mrad", 1e-3), ("µrad", 1e-6)],
        _ => &[],
    };
    let handy = finer
        .iter()
        .copied()
        .find(|(_, factor)| *factor < own.1 * 1.1 && most / factor >= 0.1);
    handy.filter(|_| most / own.1 < 0.1).unwrap_or(own)
}
