//! `docs/benchmarks.md`: every workload with its peers, each part by a process of its own, on one machine in one run.

use std::collections::HashSet;
use std::process::{Command, ExitCode};

/// Workloads of the page: their title, what is compared, and the commands that measure it.
const PARTS: [(&str, &str, &[&[&str]]); 15] = [
    (
        "W1: positions of a six-bar",
        "A four-bar with a dyad on its coupler, 360 positions in a revolution, with the influence of twelve dimensions and \
         the driver on its output (`benches/src/linkage.rs`). The code by hand closes both dyads on paper; it is given \
         Assur's sine, or that of the standard library. Fixed modes are what it does; \"modes kept\" looks at every position \
         whether a mode can have been left, and continues angles over whole turns.",
        &[&["linkage"], &["peers", "linkage"]],
    ),
    (
        "W2: ten revolutions of an elastic batten",
        "Six states under a periodic drive (`equations/src/batten.eqn`, scene `elastic`). The best loop by hand evaluates \
         what depends on the time alone for all stages of a step at once, on fused and packed numbers, chosen at run time.",
        &[&["revolutions"], &["peers", "revolutions"]],
    ),
    (
        "W3a, W3b: van der Pol and Robertson",
        "Stiff, from `benches/src/stiff.rs`. By hand it is Radau IIA of order 5 written out for two and three states, with \
         their Jacobians on paper. \"As a program asks\" is `auto`, recorded, with an estimate of its global error.",
        &[&["stiff"], &["peers", "stiff"]],
    ),
    (
        "W3c: Andrews' squeezing mechanism",
        "Seven bodies, three loops (`equations/src/andrews.eqn`), which the compiler reduces to one coordinate. By hand it \
         is reduced on paper, with its loops in closed form.",
        &[&["squeezer"], &["peers", "squeezer"]],
    ),
    (
        "W4: from text to Rust",
        "What the macro does inside rustc: the goal of W4 is for fifteen loops, thirty unknowns.",
        &[&["chain"]],
    ),
    (
        "W5: six-bars made at random",
        "The six-bar of W1 with twelve dimensions within their tolerances: moments, extremes and quantiles of the output's \
         error at 36 positions of ten thousand linkages.",
        &[&["monte-carlo"], &["peers", "monte-carlo"]],
    ),
    (
        "A turn of the presser foot",
        "Contact that opens and closes (`equations/src/presser_foot.eqn`): five events in each turn.",
        &[&["foot"], &["peers", "foot"]],
    ),
    (
        "Run-ups",
        "A thousand run-ups of a table drive with as many inertias and stiffnesses, measures included \
         (`equations/src/table_drive.eqn`).",
        &[&["run-ups"]],
    ),
    (
        "Linkages with masses",
        "A slider-crank that a torque turns and a four-bar under gravity, from `benches/src/bars.rs`; by hand their mass and half its \
         derivative are one formula of the crank's angle.",
        &[&["bars"]],
    ),
    (
        "Windows in a row",
        "Forty four-bars through ten positions in which all links lie flat (`equations/src/four_bar_row.eqn`).",
        &[&["row"]],
    ),
    (
        "Heald linkages made at random",
        "A million linkages within the tolerances of their dimensions (`equations/src/heald_linkage.eqn`).",
        &[&["tolerance"]],
    ),
    (
        "A search for dimensions",
        "The six-bar with a dwell (`examples/synthesis/dwell_six_bar.eqn`, scene `best`), by the same differential evolution. By \
         hand a design is looked at in 72 positions, eight designs side by side; Assur finds what is furthest out between them \
         and whether the linkage gets there, of the designs that are not worse already at 72.",
        &[&["search"], &["peers", "search"]],
    ),
    (
        "Sheets",
        "What does not move: a map, a gear flank with its curvatures, and curves through a thousand points.",
        &[&["sheets"]],
    ),
    (
        "One evaluation",
        "The rates of the elastic batten, and their slopes, at one time: what latencies cost.",
        &[&["evaluate"]],
    ),
    (
        "Without compiling",
        "Equation files that the command reads and interprets, beside the same compiled.",
        &[&["interpreter"]],
    ),
];

/// Prints the page.
pub fn print() -> ExitCode {
    let mut sections = String::new();
    for (title, what, commands) in PARTS {
        sections += &format!("\n## {title}\n\n{what}\n");
        for words in commands {
            eprintln!("{title}: {}", words.join(" "));
            match measured(words) {
                Ok(text) => sections += &text,
                Err(why) => {
                    eprintln!("{why}");
                    return ExitCode::FAILURE;
                }
            }
        }
    }
    println!("{}\n{}{}", head().trim_end(), goals(&sections), sections.trim_end());
    ExitCode::SUCCESS
}

/// What a command of this program prints, titles of its tables one level lower.
fn measured(words: &[&str]) -> Result<String, String> {
    let program = std::env::current_exe().map_err(|error| error.to_string())?;
    let output = Command::new(program).args(words).output().map_err(|error| error.to_string())?;
    let errors = String::from_utf8_lossy(&output.stderr);
    if !output.status.success() {
        return Err(format!("`{}` fails: {errors}", words.join(" ")));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

/// What is asked of a program, its first line.
fn said(program: &str, words: &[&str]) -> Option<String> {
    let output = Command::new(program).args(words).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    text.lines().next().filter(|line| !line.is_empty()).map(str::to_owned)
}

/// What was measured, on what, and how.
fn head() -> String {
    let unknown = || "unknown".to_owned();
    let processors = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model =
        processors.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": "));
    let processor = model.map_or_else(unknown, |(_, name)| name.to_owned());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let rustc = said("rustc", &["--version"]).unwrap_or_else(unknown);
    let commit = said("git", &["rev-parse", "--short", "HEAD"]).unwrap_or_else(unknown);
    let versions = "import scipy, casadi, numpy; print(f'SciPy {scipy.__version__}, CasADi {casadi.__version__}, \
                    NumPy {numpy.__version__}')";
    let python =
        said("python3", &["-c", versions]).unwrap_or_else(|| "no SciPy, no CasADi".to_owned());
    format!(
        "\
# Benchmarks

Assur beside code that is written by hand for one problem alone with every trick that we know, and beside other libraries on the
same mechanisms. Measured at {commit} on {threads} threads of {processor}; {rustc}, the plain x86-64 build; {python}. Written by

```text
cd benches && cargo run --release --features peers -- page > ../docs/benchmarks.md
```

- **Times** are the shortest of many rounds in which all codes take turns. **Ratios** of times are the median of the ratios in each
  round, in parentheses between what half of them lie; those without are of shortest times, where a code was measured by a process of
  its own (SciPy, CasADi).
- **Instructions** are counted by callgrind and repeat exactly.
- **Equal error**: each method runs at rtol 1e-5 … 1e-13, and the time for an achieved error is read between its runs, or is that of
  a more accurate run where that is faster. A dash: no run is as accurate.
- What is fair and what is not is said in `benches/README.md`: what libraries are given, and what each code keeps.
"
    )
}

/// The goals and what is reached, gathered from the sections. Of what two commands measure the first counts.
fn goals(sections: &str) -> String {
    let mut text = "\n## What is reached\n\n| workload | table | what is compared | found | goal | |\n|---|---|---|---:|---:|---|\n".to_owned();
    let (mut workload, mut table) = ("", "");
    let mut seen = HashSet::new();
    for line in sections.lines() {
        if let Some(title) = line.strip_prefix("## ") {
            workload = title.split(": ").next().unwrap_or(title);
        } else if let Some(title) = line.strip_prefix("### ") {
            table = title;
        } else if let Some([what, found, goal, word]) = verdict(line)
            && seen.insert((table, what))
        {
            text += &format!("| {workload} | {table} | {what} | {found} | {goal} | {word} |\n");
        }
    }
    text
}

/// The parts of a line like `- emitted / hand, time: 1.080 (goal 1.05) FAIL`.
fn verdict(line: &str) -> Option<[&str; 4]> {
    let (text, word) = line.strip_prefix("- ")?.rsplit_once(") ")?;
    let (before, goal) = text.rsplit_once(" (goal ")?;
    let (what, found) = before.rsplit_once(": ")?;
    Some([what, found, goal, if word == "pass" { "kept" } else { "**missed**" }])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn goals_are_gathered() {
        let text = goals(
            "## W1: all\n### One\n- a / b, time: 1.080 (goal 1.05) FAIL\nnone\n- c: 2 s (goal 3 s) pass\n- c: 1 s (goal 3 s) pass\n",
        );
        let expected = "| W1 | One | a / b, time | 1.080 | 1.05 | **missed** |\n| W1 | One | c | 2 s | 3 s | kept |\n";
        assert!(text.ends_with(expected), "{text}");
    }
}
