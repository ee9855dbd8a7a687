//! The answer as tables to read.

use std::path::Path;

use assur::answer::Settings;
use assur::study::cost::{Times, Work};

use super::{Cost, Limited};
use crate::ask::wanted::Wanted;
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Most quantities that have columns of their own.
const OWN: usize = 4;

/// Adds the tables to a page.
pub fn render(page: &mut Page, cost: &Cost, figure: Option<&Path>) {
    page.about(
        &cost.case.constants,
        &format!("what accuracy costs: {}", cost.case.task_in_words()),
    );
    if !cost.is_whole {
        page.warn(&format!(
            "incomplete: it was stopped when {} of {} ways had been tried",
            number::count(cost.costs.trials.len()),
            number::count(cost.asked)
        ));
        page.line("");
    }
    trials(page, cost);
    let costs = &cost.costs;
    page.line(&format!(
        "Errors are differences from {}, the largest of {} over its size; it is known to {}, by {} or what of other methods agrees better. Times are medians of {} rounds in turns, with the middle half of them.",
        costs.reference,
        match cost.shown.len() {
            1 => cost.shown[0].quantity.name.to_owned(),
            count => format!("{count} quantities"),
        },
        number::error(cost.doubts()),
        costs.second,
        costs.rounds
    ));
    let rounding: Vec<&str> =
        { cost.shown.iter() }.filter(|of| !cost.is_known(of)).map(|of| of.quantity.name).collect();
    if !rounding.is_empty() {
        page.line(&format!("Nothing but rounding, so not counted: {}.", rounding.join(", ")));
    }
    for (settings, reason) in cost.lost() {
        page.line(&format!("{settings}: {reason}"));
    }
    if let Some(wanted) = &cost.wanted {
        answer(page, cost, wanted);
    }
    page.figure(figure);
    page.line(&format!("It took {}.", number::duration(cost.seconds)));
}

fn trials(page: &mut Page, cost: &Cost) {
    let mut heads = vec![
        ("method".to_owned(), Align::Left),
        ("rtol".to_owned(), Align::Left),
        ("steps".to_owned(), Align::Right),
        ("evaluations".to_owned(), Align::Right),
        ("time".to_owned(), Align::Right),
        ("middle half".to_owned(), Align::Right),
        ("largest error".to_owned(), Align::Left),
        ("of".to_owned(), Align::Left),
    ];
    let own = if cost.shown.len() <= OWN { &cost.shown[..] } else { &[] };
    for of in own {
        heads.push((format!("{}, {}", of.quantity.name, of.quantity.unit), Align::Left));
    }
    heads.push((String::new(), Align::Left));
    let heads: Vec<(&str, Align)> =
        heads.iter().map(|(head, align)| (head.trim_end_matches(", "), *align)).collect();
    let mut table = Columns::new(heads);
    let front = cost.costs.front(|work| cost.worst(work).0);
    for (index, trial) in cost.costs.trials.iter().enumerate() {
        let Ok(work) = &trial.outcome else { continue };
        let (error, of) = cost.worst(work);
        let mut row = vec![
            trial.settings.method.to_string(),
            format!("{:e}", trial.settings.rtol),
            number::count(work.steps),
            number::count(work.evaluations),
            number::duration(work.times.median),
            spread(&work.times),
            number::error(error),
            of.to_owned(),
        ];
        row.extend(own.iter().map(|of| number::error(cost.error(work, of) / of.quantity.factor)));
        row.push(if front.contains(&index) { "*" } else { "" }.to_owned());
        table.row(row);
    }
    page.section("Cost and accuracy", &table);
}

/// The quartiles of a time.
pub(super) fn spread(times: &Times) -> String {
    let (low, high) = times.quartiles;
    format!("{} to {}", number::duration(low), number::duration(high))
}

/// What is cheapest for the accuracy that is asked for.
fn answer(page: &mut Page, cost: &Cost, wanted: &Wanted) {
    let words = wanted.words(&{ cost.shown.iter() }.map(|of| of.quantity).collect::<Vec<_>>());
    let told = |(settings, work, share): &(Settings, Work, f64)| {
        format!(
            "{settings}, with an error of {} of what is permitted, in {} ({})",
            number::significant(*share, 2),
            number::duration(work.times.median),
            spread(&work.times)
        )
    };
    match cost.cheapest(wanted, 1.0) {
        Some(found) => {
            page.line(&format!("For {words}: {}.", told(&found)));
            page.line(&match cost.cheapest(wanted, 0.1) {
                Some(finer) if finer.0 == found.0 => {
                    "Ten times more accuracy takes the same.".to_owned()
                }
                Some(finer) => format!(
                    "Ten times more accuracy takes {:.2} times as long: {} in {}.",
                    finer.1.times.median / found.1.times.median,
                    finer.0,
                    number::duration(finer.1.times.median)
                ),
                None => "Nothing that was tried is ten times more accurate.".to_owned(),
            });
        }
        None => match cost.nearest(wanted) {
            Some(nearest) => page.warn(&format!(
                "nothing reaches {words}; nearest comes {}, to {} times what is permitted",
                nearest.0,
                number::significant(nearest.2, 3)
            )),
            None => page.warn(&format!("of {words} nothing is known")),
        },
    }
    limits(page, cost, wanted);
}

/// What limits the accuracy in the end.
fn limits(page: &mut Page, cost: &Cost, wanted: &Wanted) {
    if let Some(nearest) = cost.nearest(wanted) {
        let limit = match cost.limited(wanted, &nearest) {
            Limited::Reference => "rounding limits it, of which the reference has as much",
            Limited::Tolerances => "no smaller tolerance was tried",
            Limited::Rounding => "rounding limits it, smaller tolerances gained nothing",
        };
        page.line(&format!(
            "At best {} comes to {} of what is permitted: {limit}.",
            nearest.0,
            number::significant(nearest.2, 2)
        ));
    }
    let (Some(made), Some((worst, share))) = (&cost.made, cost.spread(wanted)) else { return };
    let (names, times) = (made.names.join(", "), number::significant(share, 2));
    let said = format!(
        "The tolerances of {names} make {worst} differ by {times} times what is permitted (standard deviation)"
    );
    page.line(&match share >= 1.0 {
        true => format!("{said}: such an accuracy is of no use."),
        false => format!("{said}: more accuracy than that is of no use."),
    });
}
