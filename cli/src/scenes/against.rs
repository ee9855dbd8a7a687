//! What leaving effects out saves, and by how much it errs: each scene against one that has more.

use assur::answer::{Estimate, Settings};
use assur::registry::SceneEntry;
use assur::shape::Subject;
use assur::study::cost::references;

use super::REPEATS;
use super::effects::{Cycle, NOISE};
use crate::motion::case::Case;
use crate::plot::{Decades, Line, decades};
use crate::show::number;
use crate::show::text::{Align, Columns};

/// Powers of ten of the tolerances whose errors are shown beside those of leaving effects out.
const TOLERANCES: [i32; 7] = [-3, -4, -5, -6, -7, -8, -9];
/// Samples of the task, of which [`Estimate::largest`] looks at each third.
const SAMPLES: usize = 720;

/// A scene beside the one that it is compared with.
pub struct Beside {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// Seconds that its motion takes; none where nothing is integrated.
    seconds: Option<f64>,
    /// The output that differs most: its name, the difference, the larger amplitude, both in SI units, and its unit.
    worst: Option<(String, f64, f64)>,
    /// Outputs that both have.
    common: usize,
}

/// All scenes with the task of the fullest, beside it.
pub fn compare(
    measured: &[(&Cycle<'_>, Option<f64>)],
    fullest: &(&Cycle<'_>, Option<f64>),
) -> Vec<Beside> {
    let others = measured
        .iter()
        .filter(|one| one.0.task == fullest.0.task && !std::ptr::eq(one.0.scene, fullest.0.scene));
    let beside = |(cycle, seconds): &(&Cycle<'_>, Option<f64>)| {
        let outputs = cycle.scene.outputs.iter().map(|output| output.name);
        let changes = outputs.filter_map(|name| Some((name, cycle.change(fullest.0, name)?)));
        let changes: Vec<_> = changes.collect();
        let share = |(change, amplitude): (f64, f64)| change / amplitude;
        let known = changes.iter().filter(|one| share(one.1).is_finite());
        let worst = known.max_by(|a, b| share(a.1).total_cmp(&share(b.1)));
        Beside {
            scene: cycle.scene,
            seconds: *seconds,
            worst: worst
                .map(|(name, (change, amplitude))| ((*name).to_owned(), *change, *amplitude)),
            common: changes.len(),
        }
    };
    let mut all: Vec<Beside> = others.map(beside).collect();
    all.sort_by(|a, b| a.error().total_cmp(&b.error()));
    all
}

impl Beside {
    /// The largest difference of an output over its amplitude; zero where it is nothing but rounding and tolerance.
    fn error(&self) -> f64 {
        let share =
            self.worst.as_ref().map_or(f64::NAN, |(_, change, amplitude)| change / amplitude);
        if share <= NOISE { 0.0 } else { share }
    }
}

/// The table.
pub fn table(all: &[Beside], fullest: &(&Cycle<'_>, Option<f64>)) -> Columns {
    let mut table = Columns::new([
        ("", Align::Left),
        ("time", Align::Right),
        ("times as fast", Align::Point),
        ("largest difference, %", Align::Point),
        ("of", Align::Left),
        ("of outputs", Align::Right),
    ]);
    for one in all {
        let faster = fullest.1.zip(one.seconds).map(|(full, own)| full / own);
        table.row([
            one.scene.name.to_owned(),
            one.seconds.map_or("-".to_owned(), number::duration),
            faster.map_or(String::new(), |faster| number::significant(faster, 3)),
            match one.error() {
                0.0 => "-".to_owned(),
                error => number::significant(100.0 * error, 3),
            },
            one.worst.as_ref().map_or(String::new(), |worst| worst.0.clone()),
            one.common.to_string(),
        ]);
    }
    table
}

/// What following the same motion costs at other tolerances, and by how much its outputs err then: errors of the solver, beside
/// which those of leaving effects out can be seen. Nothing where there is no reference, or no motion.
pub fn by_tolerance(case: &Case, of: &Cycle<'_>) -> Option<Line> {
    let (exact, _) = references(&case.model()).ok()?;
    let against = Estimate::against(&exact);
    let subjects: Vec<_> = (0..case.scene.outputs.len()).map(Subject::Output).collect();
    let sizes = case.scene.outputs.iter().map(|output| Some(of.change(of, output.name)?.1));
    let sizes: Vec<f64> = sizes.collect::<Option<_>>()?;
    let (from, to) = exact.task().limits();
    let times: Vec<f64> =
        (0..=SAMPLES).map(|sample| from + (to - from) * sample as f64 / SAMPLES as f64).collect();
    let point = |power: i32| {
        let motion = case.solve(&Settings::default().rtol(10f64.powi(power))).ok()?;
        let taken = (0..REPEATS).filter_map(|_| case.time_cycle(&motion).ok());
        let errors = against.largest(&motion, &subjects, &times);
        let shares = errors.iter().zip(&sizes).map(|(error, size)| error / size);
        let worst = shares.filter(|share| share.is_finite()).fold(0.0, f64::max);
        Some((taken.fold(f64::NAN, f64::min), worst))
    };
    let ends = [TOLERANCES[0], TOLERANCES[TOLERANCES.len() - 1]];
    let name = format!("{}, rtol 1e{} to 1e{}", case.scene.name, ends[0], ends[1]);
    Some(Line { name, points: TOLERANCES.into_iter().filter_map(point).collect() })
}

/// The figure: differences over times.
pub fn figure(
    title: String,
    all: &[Beside],
    fullest: &(&Cycle<'_>, Option<f64>),
    solver: Option<Line>,
) -> String {
    let points = all.iter().filter_map(|one| {
        let seconds = one.seconds?;
        Some((one.scene.name.to_owned(), (seconds, one.error())))
    });
    decades(&Decades {
        title,
        along: "time of a motion, s".to_owned(),
        up: format!(
            "largest difference of an output from {}, over its amplitude",
            fullest.0.scene.name
        ),
        lines: solver.into_iter().collect(),
        front: Vec::new(),
        labels: points.collect(),
        mark: fullest.1.map(|seconds| (fullest.0.scene.name.to_owned(), seconds)),
    })
}
