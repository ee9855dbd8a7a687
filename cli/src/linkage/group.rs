//! Groups of loop equations in the words of mechanism theory.

use assur::closure::{Group, GroupKind};
use assur::shape::LinkageEntry;

/// Terms of the loop equations of a group, `loop.x, loop.y`.
pub fn equations(entry: &LinkageEntry, group: &Group) -> String {
    let names = group.equations.iter().map(|&index| entry.loops[index].name);
    names.collect::<Vec<_>>().join(", ")
}

/// Terms of the dependent coordinates of a group, `phi5, phi6`.
pub fn unknowns(entry: &LinkageEntry, group: &Group) -> String {
    let names = group.unknowns.iter().map(|&index| entry.dependents[index].name);
    names.collect::<Vec<_>>().join(", ")
}

/// The group in a sentence: its equations and its unknowns.
pub fn both(entry: &LinkageEntry, index: usize) -> String {
    match entry.groups.get(index) {
        Some(group) => format!("{} (for {})", equations(entry, group), unknowns(entry, group)),
        None => format!("group {}", index + 1),
    }
}

/// Name of a kind.
pub fn kind(kind: GroupKind) -> &'static str {
    match kind {
        GroupKind::Linear => "linear",
        GroupKind::Angle => "one angle",
        GroupKind::Distance => "one distance",
        GroupKind::Rrr => "RRR dyad",
        GroupKind::Rrp => "RRP dyad",
        GroupKind::Rpr => "RPR dyad",
        GroupKind::General => "coupled",
    }
}

/// What the links of a group of this kind are.
pub fn links(kind: GroupKind) -> &'static str {
    match kind {
        GroupKind::Linear => "displacements that enter linearly",
        GroupKind::Angle => "a single equation A cos φ + B sin φ = C",
        GroupKind::Distance => "a single equation with the square of a displacement",
        GroupKind::Rrr => "two links joined by a pivot",
        GroupKind::Rrp => "a link and a slide joined by a pivot",
        GroupKind::Rpr => "a slide that turns about a pivot",
        GroupKind::General => "equations that are closed together",
    }
}

/// How a group of this kind is solved.
pub fn solved(kind: GroupKind) -> &'static str {
    match kind {
        GroupKind::Linear => "closed form, one solution",
        GroupKind::General => "iteration (Newton), followed from position to position",
        _ => "closed form, two assembly modes",
    }
}

/// Whether the sine of a group says how well it transmits forces. A single equation, unless it is solved as that of an
/// angle, has a Jacobian of one entry, which is square to nothing.
pub fn transmits(group: &Group) -> bool {
    matches!(group.kind, GroupKind::Angle | GroupKind::Distance) || group.equations.len() > 1
}

/// The transmission angle of a sine, in degrees from 0 to 90.
pub fn transmission(sine: f64) -> f64 {
    sine.abs().min(1.0).asin().to_degrees()
}
