//! The panels of a figure: which there are, which matter most, and the colours of their curves.

use super::cluster::{self, Track};
use super::kind::Kind;
use super::name::{self, Name};
use super::selection::Selection;
use crate::ask::variables::Variable;

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

impl Panel {
    /// A panel of one variable with a curve for each member of a family, their values in its unit.
    pub fn family(variable: &Variable, members: Vec<(Name, Vec<f64>)>) -> Self {
        let members = members.into_iter().enumerate();
        let curves = members.map(|(index, (name, values))| Line {
            names: vec![name],
            values,
            colour: Some(index),
            key: None,
        });
        let kind = Kind::of(variable);
        let name = name::set(&variable.name).text;
        let title = match kind.title() {
            "" => name,
            title => format!("{title} {name}"),
        };
        Self {
            kind,
            title,
            unit: name::unit(&variable.unit),
            curves: curves.collect(),
            facts: Vec::new(),
            rank: 0,
        }
    }

    /// A panel of curves that are no variables, each with a name and values in its unit.
    pub fn of(
        title: String,
        unit: String,
        curves: Vec<(Name, Vec<f64>)>,
        facts: Vec<Fact>,
    ) -> Self {
        let curves = curves.into_iter().enumerate();
        let curves = curves.map(|(index, (name, values))| Line {
            names: vec![name],
            values,
            colour: Some(index),
            key: None,
        });
        Self {
            kind: Kind::Other([(0, 1); 7]),
            title,
            unit,
            curves: curves.collect(),
            facts,
            rank: 0,
        }
    }
}

/// What panels are made of.
pub struct Data<'a> {
    /// The variables.
    pub variables: &'a [Variable],
    /// Their values at each sample, SI units.
    pub values: &'a [Vec<f64>],
    /// Their estimated errors.
    pub errors: &'a [f64],
    /// Published values that may be compared.
    pub published: Vec<Published>,
}

/// A published value of a variable.
#[derive(Clone, Copy, Debug)]
pub struct Published {
    /// Index of the variable.
    pub variable: usize,
    /// Horizontal position, if it has one.
    pub at: Option<f64>,
    /// The value, SI units.
    pub value: f64,
    /// Whether it is the largest or smallest one.
    pub is_extreme: bool,
}

/// The panels of a figure, sorted by kind and size.
pub fn choose(data: &Data<'_>, selection: &Selection) -> Vec<Panel> {
    let mut tracks = cluster::tracks(data, selection);
    if *selection == Selection::Usual {
        // What is zero as far as anybody knows is not worth a curve.
        let shows = |track: &Track<'_>| track.amplitude > 20.0 * data.errors[track.index];
        if tracks.iter().any(shows) {
            tracks.retain(shows);
        }
    }
    let mut panels: Vec<Panel> = Vec::new();
    for cluster in cluster::clusters(&tracks) {
        let main = panel(data, &cluster);
        let fine = differences(data, &cluster);
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
        names: group.iter().map(|track| name::set(&track.variable.name)).collect(),
        values: values.collect(),
        colour: None,
        key: match group {
            [only] => Some(key(only)),
            _ => None,
        },
    }
}

/// The panel of a cluster.
fn panel(data: &Data<'_>, cluster: &[&Track<'_>]) -> Option<Panel> {
    let first = cluster.first()?;
    let (unit, factor) = cluster::unit(cluster);
    let groups = cluster::coincident(cluster);
    let curves = groups.iter().map(|group| {
        let values = group[0].values.iter().map(|value| value / factor);
        line(group, values)
    });
    let mut curves: Vec<_> = curves.collect();
    // Black is for the first curve of several; another one has the colour of the first variable in it.
    let several = groups.iter().zip(&mut curves).filter(|(group, _)| group.len() > 1);
    for (group, line) in several.skip(1) {
        line.key = Some(key(group[0]));
    }
    let of_cluster = |variable: usize| {
        let holds = |group: &Vec<&Track<'_>>| group.iter().any(|track| track.index == variable);
        groups.iter().position(holds)
    };
    let known = data.published.iter();
    let facts = known.clone().filter_map(|known| {
        Some(Fact {
            curve: of_cluster(known.variable)?,
            at: known.at?,
            value: known.value / factor,
        })
    });
    let facts: Vec<_> = facts.collect();
    let mut of_panel = known.filter(|known| of_cluster(known.variable).is_some());
    let peak = of_panel.any(|known| known.is_extreme);
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
fn differences(data: &Data<'_>, cluster: &[&Track<'_>]) -> Option<Panel> {
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
    let most = group.iter().flat_map(apart).fold(0.0, |most: f64, value| most.max(value.abs()));
    let noise = group.iter().map(|track| data.errors[track.index]).fold(0.0, f64::max);
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
