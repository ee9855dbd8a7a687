//! Why a linkage does not get to a position, in the names and units of the equation file.

use assur::closure::{AnyLinkage, ClosureError, Contradiction, Event, GroupKind};
use assur::shape::{LinkageEntry, Quantity};

use super::case::shown;
use super::group;
use crate::ask::case::{amount as quantity_text, label};
use crate::ask::constants::Constants;
use crate::error::Told;
use crate::show::number;

/// A linkage as its messages need it.
#[derive(Clone, Copy)]
pub struct Terms<'a> {
    /// The loops.
    pub entry: &'a LinkageEntry,
    /// The drivers as they are shown.
    pub drivers: &'a [Quantity],
}

/// Words an error.
pub fn tell(names: Terms<'_>, error: &ClosureError) -> Told {
    let place = |at: &[f64]| label(names.drivers, at);
    let group = |index: usize| group::both(names.entry, index);
    match error {
        ClosureError::NotAssembled { group: index, at, gap } => Told {
            place: place(at),
            reason: format!(
                "at {} the links do not meet: a gap of {} is left in {}",
                place(at),
                amount(names.entry, *index, *gap),
                group(*index)
            ),
            remedy: "check the dimensions, those given with --set first; or choose another position",
        },
        ClosureError::NotConverged { group: index, at, residual, iterations, sine } => Told {
            place: place(at),
            reason: format!(
                "at {} the iteration for {} did not settle: {} is left after {iterations} steps (transmission angle \
                 {})",
                place(at),
                group(*index),
                amount(names.entry, *index, *residual),
                degrees(*sine)
            ),
            remedy: "give start values nearer to the position in the equation file, `dependent phi5 ~ 10 deg`",
        },
        ClosureError::DeadPoint { group: index, at, wanted, gap } => {
            let beyond = match gap.is_finite() {
                true => format!(
                    "; at {} a gap of {} would be left",
                    place(wanted),
                    amount(names.entry, *index, *gap)
                ),
                false => String::new(),
            };
            Told {
                place: place(at),
                reason: format!(
                    "dead point at {}: {} there for {}, and it goes no further{beyond}",
                    place(at),
                    dead(names.entry, *index),
                    group(*index),
                ),
                remedy: "stay on this side of the dead point, or change the dimensions with --set",
            }
        }
        ClosureError::Ambiguous { group: index, at, apart } => Told {
            place: place(at),
            reason: format!(
                "at {} the two assembly modes of {} cannot be told apart{}",
                place(at),
                group(*index),
                match *apart > 0.0 {
                    true => format!(
                        ": they lie {} apart (radians or link lengths)",
                        number::error(*apart)
                    ),
                    false => String::new(),
                }
            ),
            remedy: "start at another position in the equation file, or give start values nearer to one of the modes",
        },
        ClosureError::NotFinite { group: index, at } => Told {
            place: place(at),
            reason: format!("at {} {} has no finite value", place(at), group(*index)),
            remedy: "a root, a division or a logarithm leaves its range there: check the values given with --set",
        },
        ClosureError::ModeLost { group: index, at, wanted, sine } => Told {
            place: place(at),
            reason: format!(
                "beyond {} on the way to {} the assembly mode of {} cannot be followed with certainty (transmission \
                 angle {})",
                place(at),
                place(wanted),
                group(*index),
                degrees(*sine)
            ),
            remedy: "two modes come very near to each other there: go to the position another way, or change a \
                     dimension a little",
        },
        other => Told {
            place: String::new(),
            reason: other.to_string(),
            remedy: "check the positions given with --at and the ranges in the equation file",
        },
    }
}

/// That a linkage is put together far from its start values, in words; none if it is not.
pub fn contradiction(constants: &Constants, run: &dyn AnyLinkage) -> Option<String> {
    let entry = constants.scene.linkage.as_ref()?;
    // Why it does not go together at all is told where that matters.
    let start = run.follow(&[]).ok()?.start;
    let one = |found: &Contradiction| {
        let quantity = entry.dependents.get(found.dependent).map(shown)?;
        let [declared, assembled] =
            [found.declared, found.assembled].map(|value| quantity_text(&quantity, value));
        Some(format!("{} ~ {declared} is assembled at {assembled}", quantity.name))
    };
    let list: Vec<_> = start.contradicted.iter().filter_map(one).collect();
    (!list.is_empty()).then(|| {
        format!(
            "far from the start values of the file: {}; `assur modes {} --scene {}` lists all assemblies",
            list.join(", "),
            constants.mechanism.name,
            constants.scene.name
        )
    })
}

/// The independent variables that an error is about.
pub fn place(error: &ClosureError) -> Option<&[f64]> {
    match error {
        ClosureError::NotAssembled { at, .. }
        | ClosureError::NotConverged { at, .. }
        | ClosureError::DeadPoint { at, .. }
        | ClosureError::Ambiguous { at, .. }
        | ClosureError::NotFinite { at, .. }
        | ClosureError::ModeLost { at, .. } => Some(at),
        _ => None,
    }
}

/// The independent variables at an event.
pub fn place_of(event: &Event) -> Option<&[f64]> {
    match event {
        Event::ChangePoint { at, .. } | Event::DeadPoint { at, .. } => Some(at),
        _ => None,
    }
}

/// A dead point of a group in words.
pub fn dead_point(entry: &LinkageEntry, index: usize) -> String {
    format!("dead point of {}: {}", group::both(entry, index), dead(entry, index))
}

/// What is singular at the dead point of a group.
fn dead(entry: &LinkageEntry, index: usize) -> &'static str {
    match entry.groups.get(index).map(|group| group.kind) {
        Some(GroupKind::Rrr) => "the two links are in line",
        Some(GroupKind::Rrp) => "the link stands square to the slide",
        Some(GroupKind::Rpr) => "the slide has come to its pivot",
        _ => "two assembly modes meet",
    }
}

/// What happened on the way: its place, and what it was.
pub fn event(names: Terms<'_>, event: &Event) -> (String, String) {
    let group = |index: usize| group::both(names.entry, index);
    match event {
        Event::ChangePoint { group: index, at, .. } => (
            label(names.drivers, at),
            format!(
                "change point of {}: both assembly modes meet; the motion goes on smoothly",
                group(*index)
            ),
        ),
        Event::DeadPoint { group: index, at, .. } => (
            label(names.drivers, at),
            format!(
                "dead point of {}: the motion goes back in the other assembly mode",
                group(*index)
            ),
        ),
        _ => (String::new(), "something of an unknown kind".to_owned()),
    }
}

/// A residual of a group with its unit: lengths in millimetres, angles in degrees.
fn amount(entry: &LinkageEntry, group: usize, residual: f64) -> String {
    let loops = entry.groups.get(group).map_or(&[][..], |group| group.equations);
    let mut units = loops.iter().map(|&index| (entry.loops[index].unit, entry.loops[index].factor));
    let first = units.next();
    match first.filter(|first| units.all(|other| other == *first)) {
        Some((unit, factor)) => gap(residual, unit, factor),
        None => gap(residual, "(SI units)", 1.0),
    }
}

/// What is missing in a loop equation whose sides have this unit: lengths in millimetres.
pub fn gap(value: f64, unit: &str, factor: f64) -> String {
    let (unit, factor) = match unit {
        "m" => ("mm", 1e-3),
        _ => (unit, factor),
    };
    let shown = number::short(number::rounded(value / factor, 4));
    format!("{shown} {unit}").trim_end().to_owned()
}

fn degrees(sine: f64) -> String {
    match sine.is_finite() {
        true => format!("{} deg", number::short(number::rounded(group::transmission(sine), 2))),
        false => "unknown".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ask::values::TIME;
    use assur::closure::Group;
    use assur::shape::Loop;

    const fn length(name: &'static str) -> Loop {
        Loop { name, unit: "m", factor: 1.0, line: 1 }
    }

    const ENTRY: LinkageEntry = LinkageEntry {
        dependents: &[Quantity { name: "phi5", ..TIME }, Quantity { name: "phi6", ..TIME }],
        loops: &[length("loop.x"), length("loop.y")],
        angles: &[true, true],
        cosines: &[],
        groups: &[Group { kind: GroupKind::Rrr, unknowns: &[0, 1], equations: &[0, 1] }],
        variables: &[],
        motion: 0,
        second: false,
        tolerances: &[],
    };

    #[track_caller]
    fn check(error: &ClosureError, expected: &str) {
        let driver = Quantity { name: "phi4", unit: "deg", factor: 1f64.to_radians(), ..TIME };
        let names = Terms { entry: &ENTRY, drivers: &[driver] };
        assert_eq!(tell(names, error).reason, expected);
    }

    #[test]
    fn a_gap_is_told_in_millimetres() {
        let error =
            ClosureError::NotAssembled { group: 0, at: vec![90f64.to_radians()], gap: 0.012_345_6 };
        check(
            &error,
            "at phi4 = 90 deg the links do not meet: a gap of 12.35 mm is left in loop.x, loop.y (for phi5, phi6)",
        );
    }

    #[test]
    fn a_dead_point_is_told_with_what_lies_beyond() {
        let place = |degrees: f64| vec![degrees.to_radians()];
        let dead = |gap: f64| ClosureError::DeadPoint {
            group: 0,
            at: place(164.957),
            wanted: place(170.0),
            gap,
        };
        let before = "dead point at phi4 = 164.957 deg: the two links are in line there for loop.x, loop.y (for phi5, \
                      phi6), and it goes no further";
        check(&dead(f64::NAN), before);
        let beyond = format!("{before}; at phi4 = 170 deg a gap of 1.2 mm would be left");
        check(&dead(0.0012), &beyond);
    }

    #[test]
    fn what_has_no_group_of_ours_is_told_all_the_same() {
        let error = ClosureError::NotFinite { group: 7, at: vec![0.0] };
        check(&error, "at phi4 = 0 deg group 8 has no finite value");
    }
}
