//! What a scene does when it is run without being told more, and when in that a time or a position is reached.

/// Parts of a task in which a position is sought. One that is passed twice within a part is overlooked there.
const PARTS: usize = 2048;
/// Halvings that bring a part down to neighbouring numbers.
const HALVINGS: usize = 80;

/// What a scene does when it is run without being told more; values in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Span {
    /// The steady state that repeats after this period, in seconds.
    Periodic(f64),
    /// The steady state of what nothing drives, whose period is a result.
    Autonomous,
    /// A motion from the first time to the second, in seconds.
    Run(f64, f64),
    /// A position of rest, with the vibrations about it.
    Rest,
    /// Nothing is stated: positions are evaluated where they are asked for.
    Open,
}

impl Span {
    /// First and last time, the same at rest. Where nothing is stated, or not known yet, the first second, because a search needs an interval to search.
    pub fn limits(self) -> (f64, f64) {
        match self {
            Self::Periodic(period) => (0.0, period),
            Self::Run(from, to) => (from, to),
            Self::Rest => (0.0, 0.0),
            Self::Autonomous | Self::Open => (0.0, 1.0),
        }
    }

    /// The time of the task that a given time means: in a steady state every cycle is like the first. None where a run
    /// does not get there.
    pub fn reduce(self, time: f64) -> Option<f64> {
        match self {
            Self::Periodic(period) if period > 0.0 => Some(time.rem_euclid(period)),
            Self::Run(from, to) => (from..=to).contains(&time).then_some(time),
            Self::Rest => Some(0.0),
            _ => Some(time),
        }
    }

    /// The first time of the task at which something that moves has a position. In a steady state it advances by the
    /// same amount in every cycle, and the position may lie any number of cycles away.
    ///
    /// ```
    /// use assur_solvers::problem::Span;
    /// let angle = |time: f64| 3.0 * time;
    /// assert_eq!(Span::Periodic(2.0).time_of(angle, 601.5), Ok(0.5));
    /// assert_eq!(Span::Run(0.0, 2.0).time_of(angle, 601.5), Err((0.0, 6.0)));
    /// ```
    ///
    /// # Errors
    /// The lowest and the highest position that it has.
    pub fn time_of(self, at: impl Fn(f64) -> f64, position: f64) -> Result<f64, (f64, f64)> {
        let (from, to) = self.limits();
        let (first, last) = (at(from), at(to));
        let advance = last - first;
        let position = match self {
            Self::Periodic(_) if advance != 0.0 => {
                position - ((position - first) / advance).floor() * advance
            }
            _ => position,
        };
        let near = 1e-12 * (first.abs() + last.abs() + position.abs()).max(f64::MIN_POSITIVE);
        let time = |part: usize| from + (to - from) * part as f64 / PARTS as f64;
        let (mut low, mut high) = (first, first);
        let mut before = 0.0;
        for part in 0..=PARTS {
            let here = at(time(part));
            if before * (here - position) < 0.0 {
                return Ok(root(|time| at(time) - position, time(part - 1), time(part)));
            }
            if (here - position).abs() <= near {
                return Ok(time(part));
            }
            before = here - position;
            low = low.min(here);
            high = high.max(here);
        }
        Err((low, high))
    }
}

/// Where a function that changes its sign between two numbers does so, by bisection.
fn root(function: impl Fn(f64) -> f64, mut from: f64, mut to: f64) -> f64 {
    let rising = function(from) < 0.0;
    for _ in 0..HALVINGS {
        let middle = from + (to - from) / 2.0;
        if (function(middle) < 0.0) == rising {
            from = middle;
        } else {
            to = middle;
        }
    }
    to
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks when this motion first has a position.
    #[track_caller]
    fn check_time(span: Span, at: impl Fn(f64) -> f64, position: f64, expected: f64) {
        let found = span.time_of(at, position).expect("it is reached");
        assert!((found - expected).abs() < 1e-13, "{found}");
    }

    #[test]
    fn a_time_of_a_steady_state_is_one_of_its_first_cycle() {
        assert_eq!(Span::Periodic(2.0).reduce(5.5), Some(1.5));
        assert_eq!(Span::Periodic(2.0).reduce(-0.5), Some(1.5));
        assert_eq!(Span::Periodic(0.0).reduce(5.5), Some(5.5));
        assert_eq!(Span::Open.reduce(5.5), Some(5.5));
    }

    #[test]
    fn a_run_does_not_get_beyond_its_ends() {
        let run = Span::Run(1.0, 3.0);
        assert_eq!(run.limits(), (1.0, 3.0));
        assert_eq!(run.reduce(3.0), Some(3.0));
        assert_eq!(run.reduce(0.5), None);
        assert_eq!(run.time_of(|time| -2.0 * time, -7.0), Err((-6.0, -2.0)));
    }

    #[test]
    fn positions_at_the_ends_and_between_are_found() {
        let run = Span::Run(1.0, 3.0);
        check_time(run, |time| -2.0 * time, -2.0, 1.0);
        check_time(run, |time| -2.0 * time, -6.0, 3.0);
        check_time(run, |time| -2.0 * time, -4.2, 2.1);
        check_time(Span::Open, |time| 2.0 * time, 0.5, 0.25);
    }

    #[test]
    fn of_several_times_the_first_is_found() {
        check_time(Span::Run(0.0, 20.0), f64::sin, 0.5, 0.5f64.asin());
    }

    #[test]
    fn a_position_may_lie_in_any_cycle() {
        let steady = Span::Periodic(2.0);
        check_time(steady, |time| 3.0 * time + 1.0, 1.0 + 3.0 * 100.7, 0.7);
        check_time(steady, |time| 3.0 * time + 1.0, 1.0 - 3.0 * 100.7, 1.3);
        check_time(steady, |time| 1.0 - 3.0 * time, 1.0 + 3.0 * 100.7, 1.3);
    }

    #[test]
    fn what_rests_or_has_no_position_is_reached_where_it_is() {
        let steady = Span::Periodic(2.0);
        check_time(steady, |_| 0.3, 0.3, 0.0);
        assert_eq!(steady.time_of(|_| 0.3, 0.4), Err((0.3, 0.3)));
        assert!(steady.time_of(|_| f64::NAN, 0.4).is_err());
    }
}
