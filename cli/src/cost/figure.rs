//! The figure: errors over times, both in powers of ten.

use assur::answer::Method;

use super::Cost;
use crate::plot::{Decades, Line, decades};

/// Draws it.
pub fn draw(cost: &Cost) -> String {
    let point = |index: &usize| {
        let work = cost.costs.trials[*index].outcome.as_ref().ok()?;
        Some((work.times.median, cost.worst(work).0))
    };
    let of = |method: &Method| {
        let trials = cost.costs.trials.iter().enumerate();
        let own = trials.filter(|(_, trial)| trial.settings.method == *method);
        let points = own.filter_map(|(index, _)| point(&index)).collect();
        Line { name: method.name().to_owned(), points }
    };
    let front = cost.costs.front(|work| cost.worst(work).0);
    decades(&Decades {
        title: format!(
            "{}, scene {}: what accuracy costs",
            cost.case.constants.mechanism.title, cost.case.scene.name
        ),
        along: "time of a solution, s".to_owned(),
        up: "largest error over size".to_owned(),
        lines: Method::ALL.iter().map(of).filter(|line| !line.points.is_empty()).collect(),
        front: front.iter().filter_map(point).collect(),
        labels: Vec::new(),
        mark: None,
    })
}
