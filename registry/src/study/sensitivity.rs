//! How fast numbers change with a value.

/// Part of a value by which it is changed at first.
const FIRST: f64 = 0.02;
/// By what each change is smaller than the one before.
const SHRINK: f64 = 1.6;
/// Number of changes.
const CHANGES: usize = 7;
/// How often a smaller first change is tried where a number does not exist beside the value.
const TRIES: usize = 4;

/// A derivative.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Its value, SI units.
    pub value: f64,
    /// Its estimated error, SI units.
    pub error: f64,
}

/// The derivatives of numbers by a value, from differences to both sides extrapolated to nothing, each by as many as agree best
/// (C. J. F. Ridders, Advances in Engineering Software 4, 1982, 75); none where a number does not exist beside the value.
///
/// `at` gives the numbers at a value, not a number where there is none. A value of zero has no size of its own: its changes
/// begin at `unit`.
pub fn slopes(
    at: &dyn Fn(f64) -> Option<Vec<f64>>,
    (value, unit): (f64, f64),
    count: usize,
) -> Vec<Option<Slope>> {
    let size = if value == 0.0 { unit } else { value.abs() };
    let mut found = vec![None; count];
    let Some(here) = at(value) else { return found };
    let mut first = FIRST * size;
    for _ in 0..TRIES {
        let steps = (0..CHANGES).map(|change| first / SHRINK.powi(change as i32));
        let sides = steps.map_while(|step| Some((step, at(value + step)?, at(value - step)?)));
        let sides: Vec<(f64, Vec<f64>, Vec<f64>)> = sides.collect();
        for (number, slope) in found.iter_mut().enumerate() {
            let points = sides.iter().map(|(step, above, below)| {
                let [here, above, below] = [&here, above, below].map(|all| all[number]);
                let (ahead, behind) = ((above - here) / step, (here - below) / step);
                Difference { step: *step, slope: (ahead + behind) / 2.0, kink: ahead - behind }
            });
            *slope = slope.or_else(|| extrapolated(&points.collect::<Vec<_>>()));
        }
        if found.iter().all(Option::is_some) {
            break;
        }
        first /= 10.0;
    }
    found
}

/// What a number does beside a value.
struct Difference {
    step: f64,
    /// The mean of the slopes to both sides.
    slope: f64,
    /// Their difference, which vanishes with the step unless there is a kink.
    kink: f64,
}

/// The limit of differences whose errors are powers of the squares of their steps; half of what the slopes to both sides differ
/// by in the end counts as an error.
fn extrapolated(differences: &[Difference]) -> Option<Slope> {
    let is_finite = |one: &Difference| one.slope.is_finite() && one.kink.is_finite();
    if differences.len() < CHANGES || !differences.iter().all(is_finite) {
        return None;
    }
    let [.., wider, last] = differences else { return None };
    let kink = last.kink - (wider.kink - last.kink) * last.step / (wider.step - last.step);
    let mut best = Slope { value: last.slope, error: f64::INFINITY };
    let mut row: Vec<f64> = Vec::new();
    for difference in differences {
        let mut next = vec![difference.slope];
        let mut factor = SHRINK * SHRINK;
        for (column, above) in row.iter().enumerate() {
            let own = next[column];
            let value = (own * factor - above) / (factor - 1.0);
            let error = f64::max((value - own).abs(), (value - above).abs());
            if error <= best.error {
                best = Slope { value, error };
            }
            next.push(value);
            factor *= SHRINK * SHRINK;
        }
        row = next;
    }
    Some(Slope { error: best.error + kink.abs() / 2.0, ..best })
}
