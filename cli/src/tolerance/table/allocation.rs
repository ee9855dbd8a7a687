//! Tolerances of least cost.

use assur::tolerance::{Allocation, Limit, Rule};

use super::Sheet;
use crate::show::number;
use crate::show::text::{Align, Columns};
use crate::tolerance::answer::place_text;
use crate::tolerance::question::Wanted;

impl Sheet<'_> {
    /// Tolerances of least cost.
    pub fn allocation(&mut self) {
        let (Some(found), Some(wanted)) = (&self.answer.allocation, &self.question.allocation)
        else {
            return;
        };
        self.chosen(found, wanted);
        let unit = self.unit;
        self.page.line(&format!(
            "Cost {} against {} for those of the file; the error is at most {}, at {}.",
            number::significant(found.cost, 4),
            number::significant(present(wanted), 4),
            unit.text(found.greatest),
            place_text(self.question, &found.greatest_at)
        ));
        let binding = found.active.iter().map(|one| {
            let place = place_text(self.question, &one.at);
            format!("{place} ({:.0} %)", 100.0 * one.share)
        });
        let binding: Vec<_> = binding.collect();
        if !binding.is_empty() {
            self.page.line(&format!("It binds at {}.", binding.join("; ")));
        }
        self.page.line(&format!(
            "A band wider by 1 % saves {}.",
            number::significant(0.01 * found.price, 3)
        ));
        self.page.line("");
    }

    fn chosen(&mut self, found: &Allocation, wanted: &Wanted) {
        let question = self.question;
        let mut table = Columns::new([
            ("", Align::Left),
            ("tolerance", Align::Point),
            ("", Align::Left),
            ("now", Align::Point),
            ("cost", Align::Point),
            ("", Align::Left),
        ]);
        let own = question.labels.iter().zip(&question.study.sources);
        let own = own.filter(|(label, _)| !label.is_play);
        for (index, (label, source)) in own.enumerate() {
            let quantity = label.quantity;
            let tolerance = found.tolerances[index];
            table.row([
                quantity.name.to_owned(),
                number::significant(tolerance / quantity.factor, 4),
                quantity.unit.to_owned(),
                number::significant(source.half_width / quantity.factor, 4),
                number::significant(wanted.candidates[index].cost.of(tolerance), 3),
                match found.limits[index] {
                    Limit::None => String::new(),
                    Limit::Least => "at its lower limit".to_owned(),
                    Limit::Most => "at its upper limit".to_owned(),
                },
            ]);
        }
        let what = match wanted.rule {
            Rule::Worst => "worst case",
            _ => "standard deviation",
        };
        let heading = format!(
            "Tolerances of least cost that keep the {what} within {} over the range",
            self.unit.text(wanted.band)
        );
        self.page.section(&heading, &table);
    }
}

/// What the tolerances of the file cost.
fn present(wanted: &Wanted) -> f64 {
    let weights = wanted.candidates.iter();
    weights.map(|one| one.cost.of(one.cost.factor)).sum::<f64>().max(0.0)
}
