//! The six-bar by SciPy, CasADi and numpy, beside its emitted code.

use super::scripts;
use crate::equal::Point;
use crate::table::{Table, number, power, ratio};
use crate::{linkage, monte_carlo};

/// What a script says of methods without a tolerance to choose, by the shortest time.
pub(super) fn told(words: &[&str], methods: &[&'static str]) -> Vec<(&'static str, Point)> {
    let found = scripts::points(words, methods);
    if found.is_empty() {
        println!("\nNot compared: `python3 {}` does not run.", words.join(" "));
    }
    let one = |(method, points): (_, Vec<Option<Point>>)| {
        points.into_iter().flatten().next().map(|point| (method, point))
    };
    found.into_iter().filter_map(one).collect()
}

/// Positions over a revolution, with influence coefficients.
pub fn positions() {
    let title = "A position of the six-bar with its influence coefficients, by other libraries";
    let mut table = Table::new(title, &["code", "error, rad", "time, ns", "/ Assur"]);
    let [hand, ours] = linkage::seconds();
    for (name, seconds) in [("hand, dispatched", hand), ("Assur, emitted, dispatched", ours)] {
        let time = number(Some(seconds * 1e9));
        table.row([name.to_owned(), String::new(), time, ratio(Some(seconds), Some(ours))]);
    }
    for (method, point) in told(&["peers.py", "six-bar"], &["CasADi C", "CasADi", "fsolve"]) {
        let time = number(Some(point.seconds * 1e9));
        let over = ratio(Some(point.seconds), Some(ours));
        table.row([method.to_owned(), power(point.error), time, over]);
    }
    table.print();
}

/// Six-bars made at random.
pub fn random() {
    let title = "Ten thousand six-bars at 36 positions on one thread, by other libraries";
    let columns = ["code", "deviation at 0 deg, mrad", "time, ms", "/ Assur"];
    let mut table = Table::new(title, &columns);
    let (ours, deviation) = monte_carlo::asked();
    let digits = |deviation: f64| format!("{:.5}", 1e3 * deviation);
    let first = ["Assur, solvers".to_owned(), digits(deviation), number(Some(ours * 1e3))];
    table.row(first.into_iter().chain(["1.00".to_owned()]));
    for (method, point) in told(&["peers.py", "six-bar-random"], &["numpy", "CasADi C"]) {
        let time = number(Some(point.seconds * 1e3));
        let over = ratio(Some(point.seconds), Some(ours));
        table.row([method.to_owned(), digits(point.error), time, over]);
    }
    table.print();
}
