//! Formula sheets on the command line: maps, conditions, tables of values, and why there is none.

use std::fs;

use super::{answer, folder};

/// A sheet over two quantities is a map of each output, with the lines beyond which a condition does not hold.
#[test]
fn a_sheet_over_two_quantities_is_a_map() {
    let directory = folder("sheet-map");
    answer(&["run", "burnishing", "--scene", "region", "--plot", "region.svg"], &directory);
    let figure = fs::read_to_string(directory.join("region.svg")).expect("a figure");
    assert_eq!(figure.matches("class=\"frame\"").count(), 2, "a panel for each output");
    for words in ["too rough", "too hot", "P, N", "Ra, µm in colour"] {
        assert!(figure.contains(words), "{words}");
    }
    // Two lines in each panel.
    assert_eq!(figure.matches("class=\"boundary\"").count(), 4);
    let one = ["run", "burnishing", "--scene", "region", "--plot", "one.svg", "--curves", "Theta"];
    answer(&one, &directory);
    let figure = fs::read_to_string(directory.join("one.svg")).expect("a figure");
    assert_eq!(figure.matches("class=\"frame\"").count(), 1);
}

/// The best feed and speed of the map are those that are solved for.
#[test]
fn the_map_and_the_inverse_agree() {
    let directory = folder("sheet-inverse");
    let places = ["Ra_adm=1um,Theta_adm=800K", "S=0.1311mm,V=8.06425[m/s]"];
    let inverse =
        answer(&["run", "burnishing", "--scene", "recommended", "--at", places[0]], &directory);
    let best = number(&inverse, "productivity");
    let map = answer(&["run", "burnishing", "--scene", "window", "--at", places[1]], &directory);
    let rate = number(&map, "rate");
    assert!((rate / best - 1.0).abs() < 1e-3, "{rate}, {best}");
}

/// The number behind a name at the place that was asked for.
fn number(table: &str, name: &str) -> f64 {
    let there = table.split("\nAt ").nth(1).expect("a place");
    let row = there.lines().find(|line| line.split_whitespace().next() == Some(name));
    let number = row.and_then(|row| row.split_whitespace().nth(1)?.parse().ok());
    number.unwrap_or_else(|| panic!("no {name}: {there}"))
}
