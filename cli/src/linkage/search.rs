//! Extremes over a task: the best of the samples, refined by going to whichever neighbour is better and halving the step.

use super::case::{Axis, Case};
use super::line::Line;
use assur::closure::Sample;

/// Most positions that are tried to refine one extreme.
const TRIALS: usize = 400;
/// Part of an axis below which a place is known.
const FINEST: f64 = 1e-9;

/// An extreme: its station, the independent variables there, and its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Extreme {
    /// Station of the task.
    pub station: Vec<f64>,
    /// Positions of the drivers.
    pub independents: Vec<f64>,
    /// The value.
    pub value: f64,
}

/// Where something is largest; none where it is nowhere a number.
pub fn largest(case: &Case, lines: &[Line], of: impl Fn(&Sample) -> f64) -> Option<Extreme> {
    let reached = lines.iter().flat_map(Line::reached);
    let values = reached.map(|(station, sample)| (station, of(sample)));
    // Of equal values the first one counts.
    let better = |best: (_, f64), other: (_, f64)| if other.1 > best.1 { other } else { best };
    let (station, value) = values.filter(|(_, value)| value.is_finite()).reduce(better)?;
    let mut best = (station.to_vec(), value);
    let axes = case.axes();
    let mut steps: Vec<f64> = axes.iter().map(|axis| first_step(axis, lines)).collect();
    let mut trials = 0;
    while trials < TRIALS && is_coarse(&axes, &steps) {
        let before = best.1;
        for (index, axis) in axes.iter().enumerate() {
            for direction in [1.0, -1.0] {
                let mut station = best.0.clone();
                let (low, high) = (axis.from.min(axis.to), axis.from.max(axis.to));
                station[index] = (station[index] + direction * steps[index]).clamp(low, high);
                trials += 1;
                let value = case.at(case.place(&station)).map_or(f64::NAN, |sample| of(&sample));
                if value > best.1 {
                    best = (station, value);
                    break;
                }
            }
        }
        if best.1 <= before {
            steps.iter_mut().for_each(|step| *step /= 2.0);
        }
    }
    let place = case.place(&best.0);
    Some(Extreme {
        independents: place[..case.drivers.len()].to_vec(),
        station: best.0,
        value: best.1,
    })
}

/// Where something is smallest; none where it is nowhere a number.
pub fn smallest(case: &Case, lines: &[Line], of: impl Fn(&Sample) -> f64) -> Option<Extreme> {
    let found = largest(case, lines, |sample| -of(sample))?;
    Some(Extreme { value: -found.value, ..found })
}

/// Half the distance of samples along an axis.
fn first_step(axis: &Axis, lines: &[Line]) -> f64 {
    let most = lines.iter().map(|line| line.stations.len()).max().unwrap_or(0);
    let along = if lines.len() > 1 { 24 } else { most };
    (axis.to - axis.from).abs() / along.max(2) as f64
}

fn is_coarse(axes: &[Axis], steps: &[f64]) -> bool {
    let mut pairs = axes.iter().zip(steps);
    pairs.any(|(axis, step)| *step > FINEST * (axis.to - axis.from).abs())
}
