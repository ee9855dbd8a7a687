//! The search for a dwell six-bar by SciPy and numba.

use super::linkage::told;
use crate::search;
use crate::table::{Table, number, ratio};

/// Differential evolution of SciPy, designs judged by what numba compiles.
pub fn report() {
    let columns = ["code", "deviation, deg", "time, us a design", "/ Assur"];
    let mut table =
        Table::new("A search of 100 000 designs on one thread, by other libraries", &columns);
    let ours = search::compiled();
    table.row(["Assur, compiled".to_owned(), String::new(), number(Some(ours)), "1.00".to_owned()]);
    for (method, point) in told(&["search.py"], &["SciPy, numba"]) {
        let time = 1e6 * point.seconds;
        table.row([
            method.to_owned(),
            number(Some(point.error)),
            number(Some(time)),
            ratio(Some(time), Some(ours)),
        ]);
    }
    table.print();
}
