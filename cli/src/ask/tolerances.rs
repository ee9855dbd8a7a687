//! What stands behind `--tolerance`.

use assur::shape::{Distribution, Quantity};

use super::values::{quantity, split};
use crate::error::Failure;

/// Examples of the option.
pub const EXAMPLE: &str = "'l4=0.1mm uniform'";

/// A tolerance as it is asked for.
pub struct Given {
    /// Half-width, SI units.
    pub half_width: f64,
    /// How what is made is distributed; as the file says unless given.
    pub distribution: Option<Distribution>,
}

impl Given {
    /// Reads a half-width, a part of the value in percent or a value with its unit, and behind it perhaps a distribution.
    ///
    /// # Errors
    /// When it is none, or does not go with the value about which it is.
    pub fn read(text: &str, of: &Quantity, mean: f64) -> Result<Self, Failure> {
        let (width, distribution) = match text.rsplit_once(char::is_whitespace) {
            Some((width, word)) => match named(word) {
                Some(distribution) => (width.trim_end(), Some(distribution)),
                None => (text, None),
            },
            None => (text, None),
        };
        let none = || {
            Failure::request(format!("`{width}` is no tolerance of `{}`", of.name))
                .remedy("give a part, `10%`, or a value with its unit, not below zero, and behind it a distribution: normal, uniform, truncated or lognormal")
        };
        let half_width = match width.strip_suffix('%') {
            Some(share) => {
                let share: f64 = share.trim().parse().map_err(|_| none())?;
                share / 100.0 * mean.abs()
            }
            None => quantity(width, of).map_err(|failure| match width.parse::<f64>() {
                // That its unit lacks is not what to say of a number below zero.
                Ok(bare) if bare < 0.0 => none(),
                _ => failure,
            })?,
        };
        if !(half_width >= 0.0 && half_width.is_finite()) {
            return Err(none());
        }
        if matches!(distribution, Some(Distribution::Lognormal { .. })) && mean <= 0.0 {
            return Err(Failure::request(format!(
                "`{}` is not above zero, as what is distributed lognormally has to be",
                of.name
            ))
            .remedy("choose normal, uniform or truncated"));
        }
        Ok(Self { half_width, distribution })
    }
}

/// The name and the tolerance of `NAME=WIDTH DISTRIBUTION`.
///
/// # Errors
/// When one of them is missing.
pub fn named_in(text: &str) -> Result<(&str, &str), Failure> {
    split(text, "--tolerance", EXAMPLE)
}

fn named(word: &str) -> Option<Distribution> {
    let all = [
        Distribution::Normal,
        Distribution::Uniform,
        Distribution::Truncated,
        Distribution::Lognormal { ratio: 0.0 },
    ];
    all.into_iter().find(|one| one.name() == word)
}
