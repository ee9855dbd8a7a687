//! What `foot.py` measures of SciPy.

use std::process::Command;

use super::{Point, RTOLS};

/// The methods of SciPy with what each took at each tolerance; none where Python or SciPy is missing.
pub fn points() -> Vec<(&'static str, Vec<Option<Point>>)> {
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/foot.py");
    let output = Command::new("python3").arg(script).output();
    let Some(output) = output.ok().filter(|output| output.status.success()) else {
        return Vec::new();
    };
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let methods = ["DOP853", "RK45", "LSODA", "Radau"];
    let of = |method: &'static str| {
        let all = RTOLS.map(|rtol| {
            let mut lines = text.lines().filter_map(|line| read(line, method));
            lines.find(|point| (point.rtol / rtol - 1.0).abs() < 1e-9)
        });
        (method, all.into())
    };
    methods.map(of).into_iter().filter(has_any).collect()
}

/// Whether a method got through at all.
fn has_any((_, points): &(&str, Vec<Option<Point>>)) -> bool {
    points.iter().any(Option::is_some)
}

/// A run in a line like `["DOP853", 1e-05, 1234, 2.5e-07, 0.012]`.
fn read(line: &str, method: &str) -> Option<Point> {
    let line = line.trim().strip_prefix('[')?.strip_suffix(']')?;
    let (name, numbers) = line.split_once(", ")?;
    if name.trim_matches('"') != method {
        return None;
    }
    let numbers: Result<Vec<f64>, _> = numbers.split(", ").map(str::parse).collect();
    let [rtol, evaluations, error, seconds] = numbers.ok()?[..] else {
        return None;
    };
    Some(Point { rtol, error, evaluations: evaluations as usize, seconds })
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
    }
}
