//! The panels of a figure: which there are, which matter most, and the colours of their curves.

use assur::registry::At;

use super::cluster::{self, Track};
use super::kind::Kind;
use super::name::{self, Name};
use super::selection::Selection;
use crate::report::Report;

/// Panels of a figure unless others are asked for.
const USUAL: usize = 6;

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
    /// Published values.
    pub facts: Vec<Fact>,
    /// How much it matters, the smallest the most.
    rank: u8,
}

/// A curve, or several that coincide.
#[derive(Clone, Debug)]
pub struct Line {
    /// Names of the variables.
    pub names: Vec<Name>,
    /// Values in the unit of the panel.
    pub values: Vec<f64>,
    /// Colour by number; none is black.
    pub colour: Option<usize>,
    /// What has a colour of its own: a coordinate keeps it in its derivatives. None where several curves coincide.
    key: Option<(Kind, String)>,
}

/// A published value.
#[derive(Clone, Copy, Debug)]
pub struct Fact {
    /// Horizontal position.
    pub at: f64,
    /// The value in the unit of the panel.
    pub value: f64,
    /// Index of the curve that it belongs to.
    pub curve: usize,
}

/// The panels of a report, sorted by kind and size.
pub fn choose(report: &Report, selection: &Selection, abscissa: &dyn Fn(f64) -> f64) -> Vec<Panel> {
    let mut tracks = cluster::tracks(report, selection);
    if *selection == Selection::Usual {
        // What is zero as far as anybody knows is not worth a curve.
        let shows = |track: &Track<'_>| track.amplitude > 20.0 * report.errors[track.index];
        if tracks.iter().any(shows) {
            tracks.retain(shows);
        }
    }
    let mut panels: Vec<Panel> = Vec::new();
    for cluster in cluster::clusters(&tracks) {
        let main = panel(report, &cluster, abscissa);
        let fine = differences(report, &cluster);
        panels.extend(main.into_iter().chain(fine));
    }
    if *selection == Selection::Usual {
        panels.sort_by_key(|panel| panel.rank);
        panels.truncate(USUAL);
    }
    panels.sort_by_key(|panel| panel.kind.rank().1);
    colour(&mut panels);
    panels
}

/// Gives each coordinate a colour of its own among the panels of its family.
fn colour(panels: &mut [Panel]) {
    let mut seen: Vec<(Kind, String)> = Vec::new();
    for line in panels.iter_mut().flat_map(|panel| &mut panel.curves) {
        let Some(key) = line.key.take() else { continue };
        let mut among = seen.iter().filter(|(family, _)| *family == key.0);
        let count = among.clone().count();
        let known = among.position(|other| *other == key);
        line.colour = Some(known.unwrap_or(count));
        if known.is_none() {
            seen.push(key);
        }
    }
}

fn key(track: &Track<'_>) -> (Kind, String) {
    let (base, _) = name::base(&track.variable.name);
    (track.kind.family(), base.to_owned())
}

/// A line for tracks that coincide.
fn line(group: &[&Track<'_>], values: impl Iterator<Item = f64>) -> Line {
    Line {
        names: group
            .iter()
            .map(|track| name::set(&track.variable.name))
            .collect(),
        values: values.collect(),
        colour: None,
        key: match group {
            [only] => Some(key(only)),
            _ => None,
        },
    }
}

/// The panel of a cluster.
fn panel(report: &Report, cluster: &[&Track<'_>], abscissa: &dyn Fn(f64) -> f64) -> Option<Panel> {
    let first = cluster.first()?;
    let (unit, factor) = cluster::unit(cluster);
    let groups = cluster::coincident(cluster);
    let curves = groups.iter().map(|group| {
        let values = group[0].values.iter().map(|value| value / factor);
        line(group, values)
    });
    let mut curves: Vec<_> = curves.collect();
    // Black is for the first curve of several; another one has the colour of the first variable in it.
    let several = groups
        .iter()
        .zip(&mut curves)
        .filter(|(group, _)| group.len() > 1);
    for (group, line) in several.skip(1) {
        line.key = Some(key(group[0]));
    }
    let of_cluster = |variable: usize| {
        let holds = |group: &Vec<&Track<'_>>| group.iter().any(|track| track.index == variable);
        groups.iter().position(holds)
    };
    let known = report
        .published
        .iter()
        .filter(|comparison| comparison.comparable);
    let facts = known.clone().filter_map(|comparison| {
        Some(Fact {
            curve: of_cluster(comparison.variable)?,
            at: abscissa(comparison.time?),
            value: comparison.fact.value / factor,
        })
    });
    let facts: Vec<_> = facts.collect();
    let peak = known
        .filter(|comparison| of_cluster(comparison.variable).is_some())
        .any(|comparison| {
            matches!(
                comparison.fact.at,
                At::Maximum | At::Minimum | At::Amplitude
            )
        });
    let names = curves.iter().flat_map(|line| &line.names);
    let names: Vec<_> = names.map(|name| name.text.as_str()).collect();
    let title = match first.kind.title() {
        "" => names.join(", "),
        title => title.to_owned(),
    };
    Some(Panel {
        kind: first.kind,
        title,
        unit: name::unit(unit),
        rank: rank(first.kind, !facts.is_empty(), peak),
        curves,
        facts,
    })
}

/// What matters: a curve whose height was published, positions, what they differ by, forces, then the rest.
fn rank(kind: Kind, has_facts: bool, has_peak: bool) -> u8 {
    match kind {
        _ if has_peak => 0,
        _ if kind.is_position() && has_facts => 1,
        _ if kind.is_position() => 2,
        Kind::Force | Kind::Torque => 3,
        _ if has_facts => 4,
        Kind::Energy | Kind::Power | Kind::Other(_) => 5,
        Kind::Translation(_) | Kind::Rotation(_) => 6,
    }
}

/// A panel of how curves that coincide at the scale of their own panel differ from their mean, unless they are the
/// same.
fn differences(report: &Report, cluster: &[&Track<'_>]) -> Option<Panel> {
    let groups = cluster::coincident(cluster);
    let group = groups.iter().find(|group| group.len() > 1)?;
    let first = group.first().filter(|track| track.kind.is_position())?;
    let mean: Vec<f64> = (0..first.values.len())
        .map(|row| group.iter().map(|track| track.values[row]).sum::<f64>() / group.len() as f64)
        .collect();
    let apart = |track: &&Track<'_>| -> Vec<f64> {
        let pairs = track.values.iter().zip(&mean);
        pairs.map(|(value, mean)| value - mean).collect()
    };
    let most = group
        .iter()
        .flat_map(apart)
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    let noise = group
        .iter()
        .map(|track| report.errors[track.index])
        .fold(0.0, f64::max);
    if !(most > 20.0 * noise && most > 1e-9 * first.amplitude) {
        return None;
    }
    let (unit, factor) = cluster::finer_unit(first, most);
    let curve = |track: &&Track<'_>| {
        let values = apart(track);
        line(&[track], values.iter().map(|value| value / factor))
    };
    Some(Panel {
        kind: first.kind,
        title: format!("{}, each less the mean", first.kind.title()),
        unit: name::unit(unit),
        curves: group.iter().map(curve).collect(),
        facts: Vec::new(),
        rank: 4,
    })
}
