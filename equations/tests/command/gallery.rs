//! The page of all mechanisms that is in the repository: it is what the command would write.
//!
//! What needs no run is compared here by the command itself: equations, scenes, sources, published values, and that the
//! deviations are those of the computed numbers on the page. The computed numbers are compared where every scene is run
//! anyway, in `shipped`; none is computed for this alone, as the row of windows takes as long as all other scenes.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::{answer, run};

/// The command that renews the page, in the folder of the repository.
const RENEW: &str = "assur gallery docs --files ../equations/src";

/// The folder of the repository.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The page as it is.
pub fn page() -> String {
    std::fs::read_to_string(root().join("docs/mechanisms.md")).expect("a page")
}

#[test]
fn the_page_says_what_the_equation_files_say() {
    let words = RENEW.split(' ').skip(1).chain(["--check", "stated"]);
    answer(&words.collect::<Vec<_>>(), &root());
}

#[test]
fn a_page_that_is_out_of_date_is_told_with_the_mechanism_and_the_command() {
    let folder = super::folder("gallery");
    std::fs::create_dir(folder.join("gallery")).expect("an empty folder");
    for picture in std::fs::read_dir(root().join("docs/gallery")).expect("pictures").flatten() {
        std::fs::write(folder.join("gallery").join(picture.file_name()), "").expect("a file");
    }
    let changed = page().replacen("closure loop: r4*dir(phi4)", "closure loop: r5*dir(phi4)", 1);
    std::fs::write(folder.join("mechanisms.md"), changed).expect("a file");
    let output =
        run(&["gallery", ".", "--files", "../equations/src", "--check", "stated"], &folder);
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{complaint}");
    for words in ["out of date", "HealdLinkage", "renew it: assur gallery ."] {
        assert!(complaint.contains(words), "no {words:?} in\n{complaint}");
    }
}

/// Checks that the computed numbers of a scene on the page are those of its run, to one unit of the last digit.
#[track_caller]
pub fn check_numbers(page: &str, mechanism: &str, scene: &str, published: &[Value]) {
    let section =
        page.split("\n## ").find(|section| section.starts_with(&format!("{mechanism}\n")));
    let table = section.and_then(|section| section.split("**Published numbers**").nth(1));
    let rows = table.unwrap_or_default().lines().map(cells);
    let rows: Vec<_> = rows.filter(|row| row[0] == format!("`{scene}`")).collect();
    assert_eq!(rows.len(), published.len(), "{mechanism}, scene {scene}; renew: {RENEW}");
    for (row, fact) in rows.iter().zip(published) {
        assert_eq!(row[1], format!("`{}`", fact["name"].as_str().expect("a name")));
        let shown = &row[4];
        let difference = number(shown) - fact["computed"].as_f64().expect("a number");
        assert!(
            difference.abs() <= unit(shown),
            "{mechanism}, scene {scene}: the page has {shown}, computed is {fact}; renew: {RENEW}"
        );
    }
}

/// The cells of a line of a table; of other lines one that is empty.
fn cells(line: &str) -> Vec<String> {
    let inner = line.trim().trim_start_matches('|').trim_end_matches('|');
    inner.split('|').map(|cell| cell.trim().to_owned()).collect()
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// One unit of the last digit of a number.
fn unit(text: &str) -> f64 {
    let (digits, power) = text.split_once('e').unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    10f64.powi(power.parse::<i32>().expect("a power") - decimals)
}

#[test]
fn the_last_digit_of_a_number_is_known() {
    assert_eq!(["-0.25", "300", "1.5e-3"].map(unit), [0.01, 1.0, 1e-4]);
}
