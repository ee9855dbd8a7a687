//! All assembly modes at a position of the independent variables.
//!
//! Groups in closed form have the modes ±1 each; groups that are iterated are searched completely, see
//! [`branch`]. The list says itself whether it is complete.

pub(super) mod branch;
pub(super) mod listing;

use super::error::ClosureError;
use super::linkage::any::AnyLinkage;
use super::linkage::loops::{Loops, Trials};
use super::linkage::problem::Linkage;
use super::passage::continuation::ROUNDING;
use super::position::newton::Newton;
use crate::scalar::Interval;
use crate::shape::{GroupKind, LinkageEntry};
use branch::Branches;
use std::f64::consts::{PI, TAU};

/// Solutions nearer to each other than this are one, in radians or parts of the bound.
const SAME: f64 = 1e-8;

/// How far to search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Search {
    /// Largest displacement, in metres, of groups that are iterated.
    pub bound: f64,
    /// Largest number of boxes to look at in one group.
    pub boxes: usize,
}

impl Default for Search {
    fn default() -> Self {
        Self { bound: 10.0, boxes: 1_000_000 }
    }
}

/// A way in which a linkage can be assembled.
#[derive(Clone, Debug, PartialEq)]
pub struct AssemblyMode {
    /// The dependent coordinates, angles within `±π`.
    pub coordinates: Vec<f64>,
    /// Sines of the transmission angles of the groups. Their signs are the assembly modes.
    pub sines: Vec<f64>,
}

/// All the ways in which a linkage can be assembled at one position.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AssemblyModes {
    /// The modes.
    pub modes: Vec<AssemblyMode>,
    /// Whether there are certainly no others (but for displacements beyond the bound).
    pub complete: bool,
    /// Boxes of unknowns that could not be decided: two modes may meet there, or nearly.
    pub undecided: usize,
    /// Boxes that were looked at.
    pub boxes: usize,
}

/// Lists all assembly modes at a position of the independent variables.
///
/// # Errors
/// [`ClosureError::BadRange`] if the position makes no sense.
pub fn modes<L: Linkage>(
    linkage: &L,
    at: &[f64],
    search: &Search,
) -> Result<AssemblyModes, ClosureError> {
    modes_of(linkage, at, search)
}

/// [`modes()`] of a linkage behind a pointer.
pub(crate) fn modes_of(
    linkage: &dyn AnyLinkage,
    at: &[f64],
    search: &Search,
) -> Result<AssemblyModes, ClosureError> {
    let shape = linkage.shape();
    let drivers = shape.drivers.len();
    if at.len() != drivers || at.iter().any(|value| !value.is_finite()) {
        let reason = format!("a position at {at:?}: expected {drivers} finite values");
        return Err(ClosureError::BadRange { reason });
    }
    let mut list = AssemblyModes { complete: true, ..AssemblyModes::default() };
    if shape.loops().groups.is_empty() {
        list.modes.push(AssemblyMode { coordinates: Vec::new(), sines: Vec::new() });
        return Ok(list);
    }
    let values = linkage.values();
    let enclosed: Vec<Interval> = values.iter().map(|value| Interval::point(*value)).collect();
    let loops = linkage.prepare(&values);
    let mut listing = Listing {
        entry: shape.loops(),
        instant: loops.instant_row(at, &[]),
        intervals: linkage.enclose(&enclosed),
        at,
        search,
        newton: Newton::new(shape),
        sines: Vec::new(),
        list,
        loops,
    };
    let position = vec![0.0; listing.loops.lengths().0];
    listing.close(0, &position);
    Ok(listing.list)
}

/// A list in the making.
struct Listing<'a> {
    entry: &'static LinkageEntry,
    loops: Box<dyn Loops<f64>>,
    instant: Vec<f64>,
    intervals: Box<dyn Trials<Interval>>,
    at: &'a [f64],
    search: &'a Search,
    newton: Newton<f64>,
    /// Sines of the groups that are closed.
    sines: Vec<f64>,
    list: AssemblyModes,
}

impl Listing<'_> {
    /// Closes the groups from this one on in all ways.
    fn close(&mut self, group: usize, position: &[f64]) {
        let Some(described) = self.entry.groups.get(group) else {
            let coordinates = position[..self.entry.dependents.len()].to_vec();
            self.list.modes.push(AssemblyMode { coordinates, sines: self.sines.clone() });
            return;
        };
        match described.kind {
            GroupKind::General => self.close_all(group, position),
            GroupKind::Linear => self.close_in(group, position, &[1.0]),
            _ => self.close_in(group, position, &[1.0, -1.0]),
        }
    }

    /// Closes a group in closed form. Two modes that coincide are one.
    fn close_in(&mut self, group: usize, position: &[f64], modes: &[f64]) {
        for &mode in modes {
            let mut next = position.to_vec();
            let sine = self.loops.close(group, &self.instant, mode, &mut next);
            if !sine.is_nan() {
                self.go_on(group, sine, &next);
                if sine.abs() < SAME {
                    return;
                }
                continue;
            }
            let margin = self.loops.margin(group, &self.instant, &next);
            next.copy_from_slice(position);
            self.newton.sine(&*self.loops, group, &self.instant, &mut next);
            let reach =
                self.newton.columns().iter().fold(0.0, |most: f64, length| most.max(*length));
            if margin.is_nan() || margin.abs() <= ROUNDING * reach {
                // A link turns freely, or two modes meet within rounding.
                self.list.complete = false;
                self.list.undecided += 1;
                return;
            }
        }
    }

    /// Closes a group in all ways that a search finds.
    fn close_all(&mut self, group: usize, position: &[f64]) {
        let mut branches = Branches::new(&*self.intervals, group, self.at, position);
        let found = branches.search(self.search.bound, self.search.boxes);
        self.list.boxes += found.boxes;
        self.list.undecided += found.undecided.len();
        self.list.complete &= found.undecided.is_empty();
        let mut known: Vec<Vec<f64>> = Vec::new();
        for solution in found.solutions.into_iter().chain(found.undecided) {
            let mut next = position.to_vec();
            for (value, &j) in solution.into_iter().zip(self.entry.groups[group].unknowns) {
                next[j] = value;
            }
            let Ok(closed) = self.newton.close(&*self.loops, group, &self.instant, &mut next)
            else {
                continue;
            };
            let unknowns = self.unknowns(group, &mut next);
            if known.iter().all(|other| self.distance(group, other, &unknowns) > SAME) {
                known.push(unknowns);
                self.go_on(group, closed.sine, &next);
            }
        }
    }

    /// The unknowns of a group, angles brought within half a turn.
    fn unknowns(&self, group: usize, position: &mut [f64]) -> Vec<f64> {
        let within = |j: usize, value: f64| {
            if self.entry.angles[j] { value - TAU * (value / TAU).round() } else { value }
        };
        let unknowns = self.entry.groups[group].unknowns.iter();
        unknowns
            .map(|&j| {
                position[j] = within(j, position[j]);
                position[j]
            })
            .collect()
    }

    /// Distance of two solutions of a group.
    fn distance(&self, group: usize, a: &[f64], b: &[f64]) -> f64 {
        let parts = self.entry.groups[group].unknowns.iter().zip(a.iter().zip(b));
        let apart = parts.map(|(&j, (a, b))| match self.entry.angles[j] {
            true => ((a - b + PI).rem_euclid(TAU) - PI).abs(),
            false => (a - b).abs() / self.search.bound,
        });
        apart.fold(0.0, f64::max)
    }

    fn go_on(&mut self, group: usize, sine: f64, position: &[f64]) {
        self.sines.push(sine);
        self.close(group + 1, position);
        self.sines.pop();
    }
}
