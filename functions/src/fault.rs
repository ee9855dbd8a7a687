//! Why what is looked for was not found, and how well it is known otherwise. It is kept beside the value, for whoever wants
//! to tell.

use std::cell::{Cell, RefCell};
use std::fmt;

use crate::mean::MeanFault;
use crate::root::Root;

/// Why there is no value.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// What was looked for, in the words of the file.
    pub what: String,
    /// Why it was not found.
    pub why: Why,
}

/// Why something was not found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Why {
    /// A mean, and so an integral.
    Mean(MeanFault),
    /// A root. The number is how often the function is seen to change its sign.
    Root(Root, usize),
    /// A table is looked up where it has no points.
    Outside {
        /// Where.
        at: f64,
        /// Where its points begin and end.
        range: (f64, f64),
    },
}

impl Fault {
    /// Whether there is a value, but not to rounding.
    pub fn is_rough(&self) -> bool {
        matches!(self.why, Why::Mean(MeanFault::Rough { .. }))
    }
}

thread_local! {
    static LAST: RefCell<Option<Fault>> = const { RefCell::new(None) };
    static DOUBT: Cell<f64> = const { Cell::new(0.0) };
}

/// Keeps a fault in place of the last one of this thread; that something is no number has a cause that is kept already.
#[cold]
pub fn keep(what: &str, why: Why) {
    let is_cause =
        !matches!(why, Why::Mean(MeanFault::NotFinite(_)) | Why::Root(Root::NotFinite(_), _));
    LAST.with(|last| {
        let mut last = last.borrow_mut();
        if is_cause || last.is_none() {
            *last = Some(Fault { what: what.to_owned(), why });
        }
    });
}

/// Keeps how wrong a mean may be, as a share of the mean absolute value, if that is the largest share of this thread.
#[inline]
pub fn doubt(share: f64) {
    DOUBT.with(|worst| {
        if share > worst.get() {
            worst.set(share);
        }
    });
}

/// The largest share of this thread by which a mean may be wrong; zero where there was none. It is forgotten.
pub fn take_doubt() -> f64 {
    DOUBT.with(|worst| worst.replace(0.0))
}

/// The last fault of this thread, which is forgotten.
pub fn take() -> Option<Fault> {
    LAST.with(|last| last.borrow_mut().take())
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let what =
            if self.what.is_empty() { "the derivative of what is found" } else { &self.what };
        let percent = |share: f64| 100.0 * share;
        write!(f, "`{what}` ")?;
        match self.why {
            Why::Mean(MeanFault::NotFinite(at)) => {
                write!(
                    f,
                    "is no finite number inside its range, {:.3} % behind its begin",
                    percent(at)
                )
            }
            Why::Mean(MeanFault::Rough { mean, error }) => {
                write!(f, "is known to {:.1e} of it only", (error / mean).abs())
            }
            Why::Mean(MeanFault::Diverges { at, mean, error }) => write!(
                f,
                "does not settle: {:.3} % behind the begin of its range it grows too fast or swings without end; its mean so \
                 far is {mean:.3e} within {error:.1e}",
                percent(at)
            ),
            Why::Root(Root::OneSign { ends }, changes) => {
                write!(
                    f,
                    "has one sign at both ends of its range, {:.6e} and {:.6e} in SI units; ",
                    ends.0, ends.1
                )?;
                match changes {
                    0 => write!(f, "there is no root, or it is only touched"),
                    _ => write!(
                        f,
                        "inside it changes its sign {changes} times: there are several roots, and the range has to be narrowed to one"
                    ),
                }
            }
            Why::Root(Root::Jumps { at, sides }, _) => write!(
                f,
                "jumps over zero {:.3} % behind the begin of its range, from {:.3e} to {:.3e}: that is no root",
                percent(at),
                sides.0,
                sides.1
            ),
            Why::Root(Root::NotFinite(at), _) => {
                write!(f, "is no number {:.3} % behind the begin of its range", percent(at))
            }
            Why::Root(Root::At(_), _) => write!(f, "is found"),
            Why::Outside { at, range } => write!(
                f,
                "is looked up at {at:.6e}, its points reach from {:.6e} to {:.6e} in SI units",
                range.0, range.1
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_fault_is_told_once() {
        assert_eq!(take(), None);
        keep("root(x^2, x, -1 .. 1)", Why::Root(Root::OneSign { ends: (1.0, 1.0) }, 0));
        let text = take().map(|fault| fault.to_string()).unwrap_or_default();
        assert!(text.starts_with("`root(x^2, x, -1 .. 1)` has one sign at both ends"), "{text}");
        assert_eq!(take(), None);
    }
}
