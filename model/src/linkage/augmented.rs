//! Closures that are not solved for: all positions are coordinates of the motion, and the forces of the closures hold them
//! together. So goes what closed forms do not reduce: spatial loops, closures that depend on each other, freedoms that
//! appear for an instant.
//!
//! Where the motion begins, how many closures are independent in general, and whose forces are determined is found here with
//! the declared values of all constants.

use super::independent::{Column, choose, order};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expression, Form, Graph, Symbol, solve};
use crate::motion::Equation;

/// Most steps of Newton's method.
const STEPS: usize = 60;
/// A closure is open by more than this part of its size.
const OPEN: f64 = 1e-9;
/// How far the places lie from the start where the closures are looked at beside it, over the size of a position.
const ASIDE: f64 = 0.03;
/// How far they lie where it is looked how large slopes are.
const FAR: f64 = 0.5;

/// Closures that hold coordinates.
#[derive(Clone, Debug)]
pub struct Augmented {
    /// Number of closures.
    pub closures: usize,
    /// How many of them are independent in general.
    pub rank: usize,
    /// How many of them are independent where the motion begins.
    pub rank_at_start: usize,
    /// The coordinates whose start values are kept; the closures determine the others.
    pub kept: Vec<usize>,
    /// How large the slopes of each closure are.
    pub sizes: Vec<f64>,
    /// Where the coordinates start.
    pub start: Vec<f64>,
    /// Their speeds there.
    pub speeds: Vec<f64>,
    /// Closures that follow from the others, and all whose forces are not determined for that.
    pub redundant: Vec<usize>,
    /// See [`Augmented::redundant`].
    pub undetermined: Vec<usize>,
}

/// Closures with their slopes at given values of everything but the coordinates.
struct Closed<'a> {
    graph: &'a Graph,
    residuals: &'a [Expression],
    slopes: Vec<(usize, usize, Expression)>,
    given: &'a dyn Fn(Symbol) -> f64,
    order: Vec<Symbol>,
    /// How many of these come first.
    first: usize,
    /// How large the slopes of each closure are.
    sizes: Vec<f64>,
}

/// A row and a column of a matrix.
type Pivot = (usize, usize);

impl Augmented {
    /// Closes closures, of which the time derivatives are given too, near some places of all coordinates with their speeds, of
    /// which the first are declared as such, the others as dependent. None where they do not close.
    pub fn of(
        graph: &mut Graph,
        (residuals, rates): (&[Expression], &[Expression]),
        given: &dyn Fn(Symbol) -> f64,
        (places, speeds): (&[f64], &[f64]),
        declared: usize,
    ) -> Option<Self> {
        let all: Vec<usize> = (0..places.len()).collect();
        let symbols: Vec<_> = all.iter().map(|index| Symbol::Coordinate(*index as u32)).collect();
        // Those of which the file says that closures determine them come first.
        let (own, dependent) = all.split_at(declared);
        let mut order = order(graph, residuals, dependent);
        order.extend(super::independent::order(graph, residuals, own));
        let slopes = graph.jacobian(residuals, &symbols);
        let first = dependent.len();
        let sizes = vec![1.0; residuals.len()];
        let mut closed = Closed { graph, residuals, slopes, given, order, first, sizes };
        closed.measure(places);
        let start = closed.near(places)?;
        let pivots = closed.pivots(&start);
        let kept = all.iter().copied().filter(|index| pivots.iter().all(|one| one.1 != *index));
        let speeds = closed.speeds(rates, (&start, speeds), &pivots);
        // On places beside the start nothing falls together by chance.
        let beside = (1..=4_u32).filter_map(|place| closed.near(&aside(&start, ASIDE, place)));
        let found = beside.map(|place| (closed.pivots(&place), place));
        let general = found.max_by_key(|(pivots, _)| pivots.len());
        let (general, place) = match general {
            Some(general) if general.0.len() > pivots.len() => general,
            _ => (pivots.clone(), start.clone()),
        };
        let (redundant, undetermined) = closed.dependent(&general, &place);
        Some(Self {
            closures: residuals.len(),
            rank: general.len(),
            rank_at_start: pivots.len(),
            kept: kept.collect(),
            sizes: closed.sizes,
            start,
            speeds,
            redundant,
            undetermined,
        })
    }

    /// Says what follows from other closures.
    pub fn redundancy(&self, equations: &[Equation]) -> Option<Diagnostic> {
        let first = equations.get(*self.redundant.first()?)?;
        let message = format!(
            "{} of the {} scalar closures are independent: {} is not needed",
            self.rank,
            self.closures,
            named(equations, &self.redundant),
        );
        let hint = "closures that share a force are held together; ask for the `reaction` of others, or leave one out";
        Some(Diagnostic::note(first.span, message).hint(hint))
    }
}

/// Places that no formula singles out, by a part of their size away from some.
fn aside(places: &[f64], part: f64, number: u32) -> Vec<f64> {
    let size = places.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
    let size = if size > 0.0 { size } else { 1.0 };
    let moved = (0..).map(Symbol::Coordinate).zip(places);
    moved
        .map(|(symbol, place)| place + part * size * (Graph::somewhere(symbol, number) - 1.1))
        .collect()
}

/// The names of some equations.
pub fn named(equations: &[Equation], indices: &[usize]) -> String {
    let names = indices.iter().map(|index| format!("`{}`", equations[*index].name));
    names.collect::<Vec<_>>().join(", ")
}

impl Closed<'_> {
    fn at<'a>(&'a self, places: &'a [f64]) -> impl Fn(Symbol) -> f64 + 'a {
        move |symbol| match symbol {
            Symbol::Coordinate(index) => places[index as usize],
            _ => (self.given)(symbol),
        }
    }

    /// Finds how large the slopes of each closure are, near some places and not only there.
    fn measure(&mut self, places: &[f64]) {
        let mut sizes = vec![0.0_f64; self.residuals.len()];
        for number in 1..=4 {
            let rows = self.rows(&aside(places, FAR, number));
            for (size, row) in sizes.iter_mut().zip(rows) {
                *size = row.iter().fold(*size, |most, one| most.max(one.abs()));
            }
        }
        let is_size = |size: &f64| *size > 0.0 && size.is_finite();
        self.sizes =
            sizes.into_iter().map(|size| if is_size(&size) { size } else { 1.0 }).collect();
    }

    /// The slopes of the closures, row by row.
    fn rows(&self, places: &[f64]) -> Vec<Vec<f64>> {
        let mut rows = vec![vec![0.0; places.len()]; self.residuals.len()];
        let values: Vec<_> = self.slopes.iter().map(|one| one.2).collect();
        let numbers = self.graph.evaluate(&values, &self.at(places));
        for ((row, column, _), number) in self.slopes.iter().zip(numbers) {
            rows[*row][*column] = number;
        }
        rows
    }

    /// Independent rows, each with the coordinate that it determines.
    fn pivots(&self, places: &[f64]) -> Vec<Pivot> {
        let rows = self.rows(places);
        let column = |symbol: &Symbol| {
            let index = match symbol {
                Symbol::Coordinate(index) => *index as usize,
                _ => 0,
            };
            let entries = rows.iter().zip(&self.sizes).map(|(row, size)| row[index] / size);
            let entries = entries.collect();
            Column { symbol: *symbol, entries, size: 0.0 }
        };
        let mut columns: Vec<Column> = self.order.iter().map(column).collect();
        columns.iter_mut().for_each(Column::measure);
        let chosen = choose(columns, rows.len(), self.first).into_iter();
        chosen
            .map(|(symbol, row)| match symbol {
                Symbol::Coordinate(index) => (row, index as usize),
                _ => (row, 0),
            })
            .collect()
    }

    /// Places near some where the closures close, by Newton's method with shortened steps.
    fn near(&self, places: &[f64]) -> Option<Vec<f64>> {
        let mut places = places.to_vec();
        let size = |places: &[f64]| {
            let residuals = self.graph.evaluate(self.residuals, &self.at(places));
            let sum: f64 = residuals.iter().map(|one| one * one).sum();
            (residuals, sum)
        };
        let (mut residuals, mut sum) = size(&places);
        for _ in 0..STEPS {
            let (rows, pivots) = (self.rows(&places), self.pivots(&places));
            let step = restricted(&rows, &pivots, |row| -residuals[row], false);
            let longest = step.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
            let scale = places.iter().fold(1.0_f64, |most, one| most.max(one.abs()));
            if !longest.is_finite() {
                return None;
            }
            let mut part = 1.0;
            loop {
                let mut tried = places.clone();
                for ((_, column), step) in pivots.iter().zip(&step) {
                    tried[*column] += part * step;
                }
                let next = size(&tried);
                if next.1 <= sum || part < 1e-3 {
                    (places, (residuals, sum)) = (tried, next);
                    break;
                }
                part *= 0.5;
            }
            if longest <= 4.0 * f64::EPSILON * scale {
                break;
            }
        }
        let rows = self.rows(&places);
        let is_closed = residuals.iter().zip(&rows).all(|(residual, row)| {
            let size = row.iter().zip(&places).map(|(a, b)| (a * b).abs().max(a.abs()));
            residual.abs() <= OPEN * size.fold(0.0, f64::max)
        });
        is_closed.then_some(places)
    }

    /// Speeds with which the closures stay closed: those of the coordinates that they determine are found.
    fn speeds(
        &self,
        rates: &[Expression],
        (places, speeds): (&[f64], &[f64]),
        pivots: &[Pivot],
    ) -> Vec<f64> {
        let mut speeds = speeds.to_vec();
        pivots.iter().for_each(|pivot| speeds[pivot.1] = 0.0);
        let open = self.graph.evaluate(rates, &|symbol| match symbol {
            Symbol::Speed(index) => speeds[index as usize],
            _ => self.at(places)(symbol),
        });
        let found = restricted(&self.rows(places), pivots, |row| -open[row], false);
        pivots.iter().zip(found).for_each(|(pivot, speed)| speeds[pivot.1] = speed);
        speeds
    }

    /// The rows that follow from those of the pivots, and all that have a share in that.
    fn dependent(&self, pivots: &[Pivot], places: &[f64]) -> (Vec<usize>, Vec<usize>) {
        let rows = self.rows(places);
        let is_left = |row: &usize| pivots.iter().all(|one| one.0 != *row);
        let redundant: Vec<usize> = (0..rows.len()).filter(is_left).collect();
        let mut undetermined = redundant.clone();
        for row in &redundant {
            let column_of = |index: usize| rows[*row][pivots[index].1];
            let shares = restricted(&rows, pivots, column_of, true);
            let most = shares.iter().fold(0.0_f64, |most, one| most.max(one.abs()));
            let part = pivots.iter().zip(&shares).filter(|(_, share)| share.abs() > 1e-7 * most);
            undetermined.extend(part.map(|(pivot, _)| pivot.0));
        }
        undetermined.sort_unstable();
        undetermined.dedup();
        (redundant, undetermined)
    }
}

/// Solves the rows and columns of the pivots, or the transpose, for a right-hand side: by the row, of the transpose by the
/// number of the pivot.
fn restricted(
    rows: &[Vec<f64>],
    pivots: &[Pivot],
    right: impl Fn(usize) -> f64,
    is_transposed: bool,
) -> Vec<f64> {
    let entry = |a: &Pivot, b: &Pivot| match is_transposed {
        false => rows[a.0][b.1],
        true => rows[b.0][a.1],
    };
    let entries = pivots.iter().flat_map(|a| pivots.iter().map(move |b| entry(a, b)));
    let entries: Vec<f64> = entries.collect();
    let right = pivots.iter().enumerate().map(|(index, pivot)| match is_transposed {
        false => right(pivot.0),
        true => right(index),
    });
    solve(Form::General, &entries, &right.collect::<Vec<_>>())
}
