//! Times of several works, measured in turns.

use std::time::Instant;

/// Fewest and most rounds.
const ROUNDS: (usize, usize) = (3, 40);

/// Seconds below which a work is done once more before it is timed.
const SHORT: f64 = 2e-3;

/// How long a work takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// Median, in seconds.
    pub median: f64,
    /// The quartiles around it.
    pub quartiles: (f64, f64),
}

/// Does works again and again, all of them in turns, until that has taken some seconds: whatever else the machine does falls
/// on all of them alike. `first` is what each has taken once. `work` does one, `progress` says before each
/// round whether to go on. Gives the times, and the number of rounds.
pub fn in_turns(
    first: &[f64],
    seconds: f64,
    work: &dyn Fn(usize),
    progress: &dyn Fn() -> bool,
) -> (Vec<Times>, usize) {
    let mut taken: Vec<Vec<f64>> = first.iter().map(|one| vec![*one]).collect();
    let pass: f64 = first.iter().sum();
    let rounds = ((seconds / pass) as usize).clamp(ROUNDS.0, ROUNDS.1);
    let mut done = 1;
    while done < rounds && progress() {
        for (index, taken) in taken.iter_mut().enumerate() {
            // Those before it have left nothing of it in the caches.
            if taken[0] < SHORT {
                work(index);
            }
            let clock = Instant::now();
            work(index);
            taken.push(clock.elapsed().as_secs_f64());
        }
        done += 1;
    }
    let times = taken.into_iter().map(|mut taken| {
        taken.sort_by(f64::total_cmp);
        let at = |part: f64| taken[((taken.len() - 1) as f64 * part).round() as usize];
        Times { median: at(0.5), quartiles: (at(0.25), at(0.75)) }
    });
    (times.collect(), done)
}

/// Those of some points, each a time and an error, that nothing cheaper is better than; the cheapest first. Points with an error
/// that is no number are none.
pub fn front(points: impl Iterator<Item = (f64, f64)>) -> Vec<usize> {
    let mut points: Vec<_> = points.enumerate().filter(|(_, one)| one.1.is_finite()).collect();
    points.sort_by(|(_, a), (_, b)| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut best = f64::INFINITY;
    points.retain(|(_, (_, error))| {
        let is_better = *error < best;
        best = best.min(*error);
        is_better
    });
    points.into_iter().map(|one| one.0).collect()
}
