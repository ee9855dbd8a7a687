//! Positions that are marked across the panels: those of the equation file and those that were asked for.

use assur::registry::At;

use crate::report::Report;

/// Marks nearer than this part of the width are one.
const NEAR: f64 = 0.006;

/// A vertical line with its label.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Horizontal position.
    pub at: f64,
    /// What is there.
    pub label: String,
    /// Whether the user asked for it.
    pub asked: bool,
}

/// All marks, from left to right; one where several would touch.
pub fn find(report: &Report, positions: &[f64], abscissa: &dyn Fn(f64) -> f64) -> Vec<Mark> {
    let (Some(first), Some(last)) = (positions.first(), positions.last()) else {
        return Vec::new();
    };
    let width = (last - first).abs();
    let case = &report.case;
    let stated = case.scene.marks.iter().filter_map(|mark| {
        let time = match mark.at {
            At::Time(time) => case.reduce(time)?,
            At::Driver(driver, position) => case.time_of(driver, position).ok()?,
            _ => return None,
        };
        Some(Mark {
            at: abscissa(time),
            label: mark.text.to_owned(),
            asked: false,
        })
    });
    let asked = report.places.iter().map(|place| Mark {
        at: abscissa(place.time),
        label: place.label.clone(),
        asked: true,
    });
    let mut marks: Vec<Mark> = Vec::new();
    for mark in stated.chain(asked) {
        if marks
            .iter()
            .all(|other| (other.at - mark.at).abs() > NEAR * width)
        {
            marks.push(mark);
        }
    }
    marks.sort_by(|a, b| a.at.total_cmp(&b.at));
    marks
}
