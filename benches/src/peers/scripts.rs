//! What scripts of Python measure of SciPy and of CasADi.

use std::process::Command;

use crate::equal::{Point, RTOLS};

/// Methods of `peers.py` with the libraries that they belong to.
const METHODS: [[&str; 2]; 7] = [
    ["SciPy", "DOP853"],
    ["SciPy", "RK45"],
    ["SciPy", "LSODA"],
    ["SciPy", "Radau"],
    ["SciPy", "BDF"],
    ["CasADi, SUNDIALS", "CVODES"],
    ["CasADi, SUNDIALS", "IDAS"],
];

/// Adds what `peers.py` measures of a workload; says so where it does not run.
pub fn add(workload: &str, names: &mut Vec<[&str; 2]>, all: &mut Vec<Vec<Option<Point>>>) {
    let found = points(&["peers.py", workload], &METHODS.map(|[_, method]| method));
    if found.is_empty() {
        println!(
            "\nSciPy and CasADi are not compared: `python3 peers.py {workload}` does not run."
        );
    }
    for (method, points) in found {
        names.extend(METHODS.into_iter().find(|[_, name]| *name == method));
        all.push(points);
    }
}

/// Methods of a script with what each took at each tolerance; none where Python or a package is missing. `words` say the script
/// and what it is asked for.
pub fn points(words: &[&str], methods: &[&'static str]) -> Vec<(&'static str, Vec<Option<Point>>)> {
    let folder = env!("CARGO_MANIFEST_DIR");
    let output = Command::new("python3").current_dir(folder).args(words).output();
    let Some(output) = output.ok().filter(|output| output.status.success()) else {
        return Vec::new();
    };
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let of = |method: &&'static str| {
        let all = RTOLS.map(|rtol| {
            let mut lines = text.lines().filter_map(|line| read(line, method));
            lines.find(|point| (point.rtol / rtol - 1.0).abs() < 1e-9)
        });
        (*method, all.into())
    };
    methods.iter().map(of).filter(has_any).collect()
}

/// Whether a method got through at all.
fn has_any((_, points): &(&str, Vec<Option<Point>>)) -> bool {
    points.iter().any(Option::is_some)
}

/// A run in a line like `["DOP853", 1e-05, 1234, 2.5e-07, 0.012]`.
fn read(line: &str, method: &str) -> Option<Point> {
    let line = line.trim().strip_prefix("[\"")?.strip_suffix(']')?;
    let (name, numbers) = line.split_once("\", ")?;
    if name != method {
        return None;
    }
    let numbers: Result<Vec<f64>, _> = numbers.split(", ").map(str::parse).collect();
    let [rtol, evaluations, error, seconds] = numbers.ok()?[..] else {
        return None;
    };
    let rounds = Vec::new();
    Some(Point { rtol, error, evaluations: evaluations as usize, seconds, rounds })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_read() {
        let point = read("[\"RK45\", 1e-05, 1234, 2.5e-07, 0.012]", "RK45").unwrap();
        assert_eq!((point.evaluations, point.seconds), (1234, 0.012));
        assert!(read("[\"RK45\", 1e-05, 1234, 2.5e-07, 0.012]", "LSODA").is_none());
        assert!(read("[\"RK45\", null]", "RK45").is_none());
        let named = "[\"SciPy, numba\", 1e-05, 1234, 2.5e-07, 0.012]";
        assert!(read(named, "SciPy, numba").is_some());
    }
}
