//! A scene as a surface: which of its outputs is one, and its places over what is swept.

use assur::registry::SceneEntry;
use assur::shape::Quantity;

use super::vector::{Vector, difference, is_finite, norm};
use crate::error::Failure;
use crate::linkage::case::{Axis, Case, Task};
use crate::linkage::line::Grid;

/// Most places along each swept value.
const MOST: usize = 200;
/// Places along each swept value unless others are asked for.
const PLACES: &str = "25";
/// Cells along each swept value that remain in the picture.
const FEWEST: usize = 8;
/// By how much the length of a unit vector may miss one.
const UNIT: f64 = 1e-6;

/// An output that is a vector of three components.
#[derive(Clone, Copy)]
pub struct Output {
    /// Its name without the component.
    pub name: &'static str,
    /// Where that stands among the outputs.
    first: usize,
}

impl Output {
    fn at(&self, outputs: &[f64]) -> Vector {
        [outputs[self.first], outputs[self.first + 1], outputs[self.first + 2]]
    }
}

/// The vectors of three components of a scene that have a dimension, `[1, 0, 0]` of length.
fn vectors(scene: &'static SceneEntry, metres: i8) -> impl Iterator<Item = Output> {
    let is_of = move |quantity: &Quantity| {
        let powers = quantity.dimension.map(|(up, _)| up);
        powers == [metres, 0, 0, 0, 0, 0, 0]
    };
    scene.outputs.windows(3).enumerate().filter_map(move |(first, components)| {
        let name = components[0].name.strip_suffix(".x")?;
        let named = components.iter().zip([".x", ".y", ".z"]);
        let mut all =
            named.map(|(one, end)| one.name.strip_suffix(end) == Some(name) && is_of(one));
        all.all(|one| one).then_some(Output { name, first })
    })
}

/// The outputs of a scene that are surfaces, if it may sweep two values.
pub fn surfaces(scene: &'static SceneEntry) -> Vec<Output> {
    match scene.linkage.is_some() && scene.drivers.len() == 2 {
        true => vectors(scene, 1).collect(),
        false => Vec::new(),
    }
}

/// A surface over a grid of two swept values.
pub struct Patch {
    /// The scene.
    pub scene: &'static str,
    /// What is swept.
    pub axes: [Axis; 2],
    /// Number of places along each.
    pub counts: [usize; 2],
    /// The places, the first swept value the fastest; not finite where there is none. Metres.
    pub places: Vec<Vector>,
    /// What may be normals at the places: vectors of length one, by their names.
    pub normals: Vec<(&'static str, Vec<Vector>)>,
}

impl Patch {
    /// Evaluates a scene over its grid.
    ///
    /// # Errors
    /// Numbers of places that cannot be, a scene that does not sweep two values, or one that does not get anywhere.
    pub fn of(case: &Case, output: Output, places: Option<&str>) -> Result<Self, Failure> {
        let name = case.scene.name;
        let axes = case.axes();
        let (Task::Sweep(_), &[first, second]) = (&case.moved.task, &axes[..]) else {
            return Err(Failure::request(format!("scene `{name}` does not sweep two values"))
                .reason(format!("it has {}", case.task_in_words()))
                .remedy(
                    "state two in the equation file: sweep u 0 deg .. 90 deg, v 0 mm .. 10 mm;",
                ));
        };
        let grid = Grid::even(case, places.unwrap_or(PLACES), MOST)?;
        let lines = case.grid(&grid).map_err(|error| {
            case.tell(&error).failure(format!("scene `{name}` cannot be put together"))
        })?;
        let nothing = vec![f64::NAN; case.scene.outputs.len()];
        let samples = lines.iter().flat_map(|line| &line.samples);
        let samples = samples.map(|one| one.as_ref().map_or(&nothing, |one| &one.outputs));
        let samples: Vec<_> = samples.collect();
        let all = |of: Output| samples.iter().map(|outputs| of.at(outputs)).collect::<Vec<_>>();
        let normals = vectors(case.scene, 0).map(|one| (one.name, all(one)));
        Ok(Self {
            scene: name,
            axes: [first, second],
            counts: [lines.first().map_or(0, |line| line.stations.len()), lines.len()],
            places: all(output),
            normals: normals.filter(|(_, normals)| are_units(normals)).collect(),
        })
    }

    /// The same with fewer places, so that the edges of cells are this long at least on average, as long as enough remain.
    pub fn thinned(&self, least: f64) -> Self {
        let kept = [0, 1].map(|axis| {
            let last = self.counts[axis] - 1;
            let wanted = (least / self.edge(axis)).ceil();
            let step = wanted.min((last / FEWEST) as f64).max(1.0);
            (0..last).step_by(step as usize).chain([last]).collect::<Vec<_>>()
        });
        let thin = |all: &[Vector]| {
            let row = |row: &usize| {
                let start = row * self.counts[0];
                kept[0].iter().map(|column| all[start + column]).collect::<Vec<_>>()
            };
            kept[1].iter().flat_map(row).collect::<Vec<_>>()
        };
        Self {
            counts: [kept[0].len(), kept[1].len()],
            places: thin(&self.places),
            normals: self.normals.iter().map(|(name, all)| (*name, thin(all))).collect(),
            ..*self
        }
    }

    /// Mean length of the edges along a swept value.
    fn edge(&self, axis: usize) -> f64 {
        let lengths = self.cells().map(|[start, along, _, across]| {
            let end = if axis == 0 { along } else { across };
            norm(difference(self.places[end], self.places[start]))
        });
        let lengths: Vec<_> = lengths.filter(|length| length.is_finite()).collect();
        lengths.iter().sum::<f64>() / lengths.len() as f64
    }

    /// The cells of the grid by their corners, in the order of the first swept value and then the second.
    pub fn cells(&self) -> impl Iterator<Item = [usize; 4]> {
        let [columns, rows] = self.counts;
        let first = move |row: usize| (1..columns).map(move |column| row * columns + column - 1);
        let firsts = (1..rows).flat_map(move |row| first(row - 1));
        firsts.map(move |first| [first, first + 1, first + columns + 1, first + columns])
    }
}

/// Whether vectors have the length one, as far as they are anywhere.
fn are_units(normals: &[Vector]) -> bool {
    let mut finite = normals.iter().filter(|normal| is_finite(normal)).peekable();
    finite.peek().is_some() && finite.all(|normal| (norm(*normal) - 1.0).abs() < UNIT)
}

#[cfg(test)]
impl Patch {
    /// A surface over two parameters from 0 to 1, metres; without normals.
    pub fn made(counts: [usize; 2], place: impl Fn(f64, f64) -> Vector) -> Self {
        let axis = Axis { quantity: crate::ask::values::TIME, from: 0.0, to: 1.0 };
        let share = |index: usize, axis: usize| index as f64 / (counts[axis] - 1) as f64;
        let row = |row: usize| (0..counts[0]).map(move |column| (column, row));
        let all = (0..counts[1]).flat_map(row);
        let places = all.map(|(column, row)| place(share(column, 0), share(row, 1))).collect();
        Self { scene: "made", axes: [axis; 2], counts, places, normals: Vec::new() }
    }

    /// A part of a sphere about the origin, from these angles on by those: longitude and latitude.
    pub fn sphere(counts: [usize; 2], from: (f64, f64), by: (f64, f64)) -> Self {
        Self::made(counts, |u, v| {
            let ((sine, cosine), (up, level)) =
                ((from.0 + u * by.0).sin_cos(), (from.1 + v * by.1).sin_cos());
            [level * cosine, level * sine, up]
        })
    }

    /// A torus about the third axis, its radii 3 and 1.
    pub fn torus(counts: [usize; 2]) -> Self {
        Self::made(counts, |u, v| {
            let turn = std::f64::consts::TAU;
            let ((sine, cosine), (up, out)) = ((turn * u).sin_cos(), (turn * v).sin_cos());
            [(3.0 + out) * cosine, (3.0 + out) * sine, up]
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fine_cells_are_put_together_until_few_remain() {
        let patch = Patch::made([101, 11], |u, v| [10.0 * u, v, 0.0]);
        assert_eq!(patch.thinned(0.05).counts, [101, 11]);
        let thinned = patch.thinned(0.25);
        assert_eq!(thinned.counts, [35, 11], "steps of 0.3, and the end");
        assert_eq!((thinned.places[1], thinned.places[34]), ([0.3, 0.0, 0.0], [10.0, 0.0, 0.0]));
        assert_eq!(patch.thinned(100.0).counts, [10, 11]);
    }
}
