//! The advice as tables and a figure.

use super::combination::Combination;
use super::contrast::Contrast;
use super::within::Advice;
use crate::list::composition;
use crate::plot::{Decades, decades};
use crate::show::number;
use crate::show::page::Page;
use crate::show::text::{Align, Columns};

/// Most combinations of a table.
const SHOWN: usize = 12;
/// Those that are not accurate enough, of them.
const MISSED: usize = 4;
/// What is faster by less is as fast.
const FASTER: f64 = 1.05;

/// Adds the tables to a page.
pub fn render(page: &mut Page, advice: &Advice) {
    let words = words(advice);
    let heading = format!("{}: what {words} takes", advice.mechanism.title);
    page.line(&page.style.heading(&heading));
    let (count, base) = (advice.all.len() + 1, advice.base);
    page.line(&format!(
        "  all {count} combinations that balance of the effects and choices of {}: {}",
        base.name,
        composition(base)
    ));
    if let Some((quantity, range)) = &advice.over {
        let ends = [range.values.first(), range.values.last()]
            .map(|end| number::short(end.copied().unwrap_or(f64::NAN) / quantity.factor));
        let [from, to] = ends;
        let count = range.values.len();
        page.line(&format!(
            "  at {count} values of {} from {from} to {to} {}",
            quantity.name, quantity.unit
        ));
    }
    page.line("");
    answer(page, advice, &words);
    let (enough, others) = nearest(advice);
    page.table("Combinations", &combinations(advice, &enough, &others));
    let left_out = advice.all.len() - enough.len() - others.len();
    let notes = [
        "a star: accurate enough, and timed; lacks: the scene has no such quantity; elsewhere: it is nothing in the scene compared with",
        &format!("{left_out} others are left out"),
    ];
    for note in &notes[..1 + usize::from(left_out > 0)] {
        page.line(&page.style.faint(&format!("  {note}")));
    }
    page.line("");
    if advice.over.is_some() {
        across(page, advice);
    }
    effects(page, advice);
    let note = format!(
        "times of the whole answer, of all of them through the interpreter; differences from {} at 721 instants, over sizes there",
        base.name
    );
    page.line(&page.style.faint(&format!("  {note}")));
}

/// What is asked for.
fn words(advice: &Advice) -> String {
    let shown = &advice.reference.shown;
    let all: Vec<_> = advice.wanted.iter().map(|wanted| wanted.words(shown)).collect();
    all.join(" and ")
}

/// Which combination to take.
fn answer(page: &mut Page, advice: &Advice, words: &str) {
    let best = advice.all.iter().find(|one| advice.share(one) <= 1.0);
    let whole = advice.reference.combination.seconds();
    let faster = best.map(|one| whole / one.seconds()).filter(|faster| *faster > FASTER);
    let Some((best, faster)) = best.zip(faster) else {
        page.line(&format!("  nothing cheaper than {} keeps {words}", advice.base.name));
        page.line("");
        return;
    };
    let name = advice.named(best.scene).map_or("a combination without a name", |one| one.name);
    let worst = advice.worst(best).filter(|worst| worst.1 > 0.0);
    let worst = worst.map_or("nothing differs".to_owned(), |(index, share)| {
        let of = advice.reference.shown[index];
        let apart = number::significant(advice.apart(best, index) / of.factor, 2);
        let apart = format!("{apart} {}", of.unit);
        format!("{} differs by {}, {} % of its size", of.name, apart.trim_end(), percent(share))
    });
    page.line(&format!(
        "  {name} suffices, {} times as fast: {worst}",
        number::significant(faster, 2)
    ));
    page.line(&format!("  {}", page.style.accent(&advice.command(best.scene))));
    page.line("");
}

fn percent(share: f64) -> String {
    match share {
        0.0 => "-".to_owned(),
        share if share.is_infinite() => "from 0".to_owned(),
        share => number::significant(100.0 * share, 2),
    }
}

/// The combinations that are accurate enough, and those that nearly are.
fn combinations(advice: &Advice, enough: &[&Combination], others: &[&Combination]) -> Columns {
    let mut table = Columns::new([
        ("", Align::Left),
        ("time", Align::Right),
        ("times as fast", Align::Point),
        ("of the permitted", Align::Point),
        ("largest difference, %", Align::Point),
        ("of", Align::Left),
        ("scene", Align::Left),
        ("with", Align::Left),
    ]);
    let whole = advice.reference.combination.seconds();
    let mut row = |one: &Combination, mark: &str| {
        let worst = advice.worst(one);
        let is_timed = mark == "*";
        table.row([
            mark.to_owned(),
            if is_timed { number::duration(one.seconds()) } else { String::new() },
            match is_timed {
                true => number::significant(whole / one.seconds(), 3),
                false => String::new(),
            },
            match (one.failure(), advice.share(one)) {
                (Some(_), _) => "does not come out".to_owned(),
                (None, share) if share.is_infinite() => String::new(),
                (None, share) => number::significant(share, 3),
            },
            worst.map_or(String::new(), |(index, share)| told(advice, one, index, share)),
            { worst.filter(|one| one.1 > 0.0) }
                .map_or(String::new(), |one| advice.reference.shown[one.0].name.to_owned()),
            advice.named(one.scene).map_or(String::new(), |scene| scene.name.to_owned()),
            composition(one.scene),
        ]);
    };
    for one in enough {
        row(one, "*");
    }
    row(&advice.reference.combination, "*");
    for one in others {
        row(one, "");
    }
    table
}

/// A difference in per cent, or why there is none.
fn told(advice: &Advice, of: &Combination, index: usize, share: f64) -> String {
    match share.is_infinite() {
        true if !of.has(advice.reference.shown[index].name) => "lacks".to_owned(),
        true if advice.reference.has_size(index) => "elsewhere".to_owned(),
        _ => percent(share),
    }
}

/// The cheapest of those that are accurate enough, and the nearest of the others.
fn nearest(advice: &Advice) -> (Vec<&Combination>, Vec<&Combination>) {
    let (mut enough, mut others): (Vec<&Combination>, Vec<&Combination>) =
        advice.all.iter().partition(|one| advice.share(one) <= 1.0);
    others.sort_by(|a, b| advice.share(a).total_cmp(&advice.share(b)));
    enough.truncate(SHOWN);
    others.truncate(MISSED.max(SHOWN - enough.len()));
    (enough, others)
}

/// What suffices, and what each effect is worth, at each value of the range.
fn across(page: &mut Page, advice: &Advice) {
    let Some((quantity, range)) = &advice.over else { return };
    let at: Vec<String> =
        range.values.iter().map(|value| number::short(value / quantity.factor)).collect();
    let title = format!("{}, {}", quantity.name, quantity.unit);
    let mut table = Columns::new([(title.as_str(), Align::Point), ("cheapest", Align::Left)]);
    for (value, text) in at.iter().enumerate() {
        let mut enough = advice.all.iter().filter(|one| advice.share_at(one, value) <= 1.0);
        let scene = enough.next().map_or(advice.base, |one| one.scene);
        table.row([text.clone(), composition(scene)]);
    }
    page.section("What suffices at each value", &table);
    let contrasts = advice.contrasts();
    if contrasts.is_empty() {
        return;
    }
    let heads = at.iter().map(|text| (text.as_str(), Align::Point));
    let mut table = Columns::new([(title.as_str(), Align::Left)].into_iter().chain(heads));
    for contrast in contrasts {
        let without = contrast.together[1];
        let shares = (0..advice.values()).map(|value| advice.share_at(without, value));
        let cell = |share: f64| match share {
            0.0 => "-".to_owned(),
            share => number::significant(share, 3),
        };
        table.row([contrast.name.clone()].into_iter().chain(shares.map(cell)));
    }
    let heading = "What leaving an effect out, or choosing otherwise, takes of the permitted";
    page.section(heading, &table);
}

/// What each effect and choice does to each quantity.
fn effects(page: &mut Page, advice: &Advice) {
    let contrasts = advice.contrasts();
    if contrasts.is_empty() {
        return;
    }
    let base = advice.base.name;
    let [mut together, mut alone, mut interaction] = [0; 3].map(|_| {
        let heads = contrasts.iter().map(|one| (one.name.as_str(), Align::Point));
        Columns::new([("", Align::Left)].into_iter().chain(heads))
    });
    for index in advice.looked_at() {
        let row = |table: &mut Columns, share: &dyn Fn(&Contrast<'_>) -> Option<f64>| {
            let cells = contrasts.iter().map(|one| match share(one) {
                Some(share) => percent(share),
                None => String::new(),
            });
            let name = advice.reference.shown[index].name.to_owned();
            table.row([name].into_iter().chain(cells));
        };
        let reference = &advice.reference;
        let itself = &reference.combination;
        row(&mut together, &|one| {
            reference.share([one.together[0], one.together[1], itself, itself], index)
        });
        row(&mut alone, &|one| {
            reference.share([one.alone[0], one.alone[1], itself, itself], index)
        });
        row(&mut interaction, &|one| {
            let [[a, b], [c, d]] = [one.together, one.alone];
            reference.share([a, b, c, d], index)
        });
    }
    page.section(&format!("What each changes in {base}, all the rest being there, %"), &together);
    page.section("What each changes alone, %", &alone);
    page.section(
        "By how much both differ: what it does to others, or others to it, %",
        &interaction,
    );
}

/// The figure: differences over times, with the names of those that nothing cheaper is better than.
pub fn figure(advice: &Advice) -> String {
    let reference = advice.reference.combination.seconds();
    let mut best = f64::INFINITY;
    let (mut labels, mut front) = (Vec::new(), Vec::new());
    // The cheapest first.
    for one in &advice.all {
        let point = (one.seconds(), advice.share(one));
        let is_best = point.1 > 0.0 && point.1 < best && point.0 < reference;
        let name = advice.named(one.scene).map(|scene| scene.name.to_owned());
        let name = name.unwrap_or_else(|| advice.changes(one.scene).join(", "));
        if is_best {
            best = point.1;
            front.push(point);
        }
        if point.1.is_finite() {
            labels.push((if is_best { name } else { String::new() }, point));
        }
    }
    decades(&Decades {
        title: format!("{}: what {} takes", advice.mechanism.title, words(advice)),
        along: "time of an answer, s".to_owned(),
        up: format!("largest difference from {}, over what is permitted", advice.base.name),
        lines: Vec::new(),
        front,
        labels,
        mark: Some((advice.base.name.to_owned(), reference)),
    })
}
