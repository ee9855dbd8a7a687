//! The horizontal axis that all panels share.

use assur::shape::Quantity;

use super::axis::Axis;
use super::name;
use crate::motion::report::Report;

/// The horizontal axis: the first driver where it advances steadily through a steady state, else the time.
pub struct Across {
    driver: bool,
    degrees: bool,
    /// SI value of a unit of the axis.
    pub factor: f64,
    /// What it shows, with its unit.
    pub title: String,
}

impl Across {
    /// Chooses the axis of a report.
    pub fn new(report: &Report) -> Self {
        let driver = report.case.scene.drivers.first();
        let steady =
            report.curves.drivers.windows(2).all(|pair| match (pair[0].first(), pair[1].first()) {
                (Some(before), Some(after)) => before <= after,
                _ => false,
            });
        let ends = (report.curves.drivers.first(), report.curves.drivers.last());
        let advances = matches!(ends, (Some(first), Some(last)) if first < last);
        match driver.filter(|_| steady && advances && report.is_cycle()) {
            Some(driver) => Self { driver: true, ..Self::along(driver) },
            None => {
                Self { driver: false, degrees: false, factor: 1.0, title: "time, s".to_owned() }
            }
        }
    }

    /// The axis of a quantity, angles in degrees.
    pub fn along(quantity: &Quantity) -> Self {
        let degrees = matches!(quantity.unit, "rad" | "deg");
        let (unit, factor) = if degrees {
            ("°".to_owned(), 1f64.to_radians())
        } else {
            (name::unit(quantity.unit), quantity.factor)
        };
        let what = quantity.summary.lines().next().unwrap_or("").trim_end_matches('.');
        let letter = name::set(quantity.name).text;
        let parts = [what, &letter, &unit].into_iter();
        let parts: Vec<_> = parts.filter(|part| !part.is_empty()).collect();
        Self { driver: false, degrees, factor, title: parts.join(", ") }
    }

    /// The position on the axis at a time.
    pub fn at(&self, report: &Report, time: f64) -> f64 {
        let driven = if self.driver { report.case.drivers_at(time).first().copied() } else { None };
        driven.unwrap_or(time) / self.factor
    }

    /// Both ends of the axis.
    pub fn ends(positions: &[f64]) -> (f64, f64) {
        match (positions.first(), positions.last()) {
            (Some(first), Some(last)) if first < last => (*first, *last),
            (Some(first), _) => (*first, first + 1.0),
            _ => (0.0, 1.0),
        }
    }

    /// The ticks.
    pub fn axis(&self, low: f64, high: f64, width: f64) -> Axis {
        let intervals = (width / 62.0) as usize;
        if self.degrees {
            Axis::degrees(low, high, intervals)
        } else {
            Axis::between(low, high, intervals)
        }
    }
}
