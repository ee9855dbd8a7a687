//! Numbers of the whole task.

use assur::answer::{Estimate, Motion};
use assur::measure::Missing;
use assur::shape::Quantity;

use super::case::Case;
use super::report::Report;
use crate::show::number;
use crate::show::page::{Page, first_line};
use crate::show::text::{Align, Columns};
use crate::show::unit;

/// A number of the whole task.
#[derive(Clone, Copy, Debug)]
pub struct Measured {
    /// Name and unit.
    pub quantity: &'static Quantity,
    /// Its value, SI units, or why there is none.
    pub value: Result<f64, Missing>,
    /// Its estimated error, SI units; NaN where there is none.
    pub error: f64,
}

/// The measures of a motion with their errors.
pub fn of(case: &Case, motion: &Motion, estimate: &Estimate) -> Vec<Measured> {
    let found = motion.measures();
    let errors = estimate.measures(&found);
    let measures = case.scene.measures.iter().zip(found).zip(errors);
    let measures = measures.map(|((quantity, value), error)| Measured { quantity, value, error });
    measures.collect()
}

/// The table of all measures.
pub fn section(page: &mut Page, report: &Report) {
    if report.measures.is_empty() {
        return;
    }
    let mut table = Columns::new([
        ("measure", Align::Left),
        ("value", Align::Point),
        ("unit", Align::Left),
        ("estimated error", Align::Point),
        ("", Align::Left),
    ]);
    let modes: Vec<_> = report.case.scene.modes.iter().map(|mode| mode.name).collect();
    for measure in &report.measures {
        let quantity = measure.quantity;
        let (value, error, text) = match measure.value {
            Ok(value) => (
                number::with_error(
                    unit::stated(value, quantity.factor),
                    unit::stated(measure.error.max(1e-10 * value.abs()), quantity.factor),
                ),
                number::error(unit::stated(measure.error, quantity.factor)),
                first_line(quantity.summary).to_owned(),
            ),
            Err(missing) => {
                ("none".to_owned(), String::new(), format!("since {}", missing.text(&modes)))
            }
        };
        table.row([quantity.name.to_owned(), value, quantity.unit.to_owned(), error, text]);
    }
    page.section("Measures of the whole task", &table);
}
