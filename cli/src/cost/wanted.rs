//! The accuracy that is asked for, behind `--for`.

use assur::shape::Quantity;
use assur::study::cost::Work;

use super::{Cost, Shown};
use crate::ask::lookup::suggestion;
use crate::ask::values;
use crate::error::Failure;
use crate::show::number;

/// An accuracy.
pub struct Wanted {
    /// As it is written.
    pub text: String,
    /// Whose errors count, by place.
    of: Vec<usize>,
    limit: Limit,
}

/// What errors are to stay below.
enum Limit {
    /// SI units.
    Absolute(f64),
    /// Of the size over the task.
    Relative(f64),
}

impl Wanted {
    /// Reads it.
    ///
    /// # Errors
    /// An unknown name, a wrong unit, a number that is no accuracy.
    pub fn read(text: &str, shown: &[Shown]) -> Result<Self, Failure> {
        let place = || format!("--for {text}");
        let (name, value) = match text.split_once('=') {
            Some((name, value)) => (Some(name.trim()), value.trim()),
            None => (None, text.trim()),
        };
        let known: Vec<&str> = shown.iter().map(|one| one.quantity.name).collect();
        let named = name.map(|name| {
            known.iter().position(|one| *one == name).ok_or_else(|| {
                Failure::request(format!("`{name}` is not looked at"))
                    .place(place())
                    .remedy(suggestion(name, &known))
            })
        });
        let named = named.transpose()?;
        let all = || named.map_or_else(|| (0..shown.len()).collect(), |index| vec![index]);
        let (of, limit) = match value.strip_suffix('%') {
            Some(share) => {
                let share = share.trim().parse::<f64>().map_err(|_| {
                    Failure::request(format!("`{value}` is no share"))
                        .place(place())
                        .remedy("for example: --for 0.1%")
                })?;
                (all(), Limit::Relative(share / 100.0))
            }
            None => {
                let reads = |quantity: &Quantity| values::quantity(value, quantity);
                let of: Vec<usize> = match named {
                    Some(index) => vec![index],
                    None => {
                        let suits = |index: &usize| reads(&shown[*index].quantity).is_ok();
                        (0..shown.len()).filter(suits).collect()
                    }
                };
                let Some(first) = of.first() else {
                    return Err(Failure::request(format!(
                        "nothing that is looked at has the unit of `{value}`"
                    ))
                    .place(place())
                    .remedy(format!("looked at: {}", known.join(", "))));
                };
                let value = reads(&shown[*first].quantity);
                (of, Limit::Absolute(value.map_err(|failure| failure.place(place()))?))
            }
        };
        let (Limit::Absolute(value) | Limit::Relative(value)) = limit;
        if value.is_nan() || value <= 0.0 {
            return Err(Failure::request("an accuracy is a number above 0")
                .place(place())
                .remedy("for example: --for 'F=0.1N', --for 1um, --for 0.1%"));
        }
        Ok(Self { text: text.to_owned(), of, limit })
    }

    /// The largest error over what is permitted: at most 1 where the accuracy is reached. Not a number where nothing of it is
    /// known.
    pub fn share(&self, cost: &Cost, work: &Work) -> f64 {
        self.largest(cost, |of| cost.error(work, of))
    }

    /// The same of what the reference is not known by.
    pub fn doubt(&self, cost: &Cost) -> f64 {
        self.largest(cost, |of| cost.doubt(of))
    }

    fn largest(&self, cost: &Cost, error: impl Fn(&Shown) -> f64) -> f64 {
        let shares = self.of.iter().map(|index| {
            let of = &cost.shown[*index];
            match self.limit {
                Limit::Absolute(value) => error(of) / value,
                // What is nothing but rounding has no relative error.
                Limit::Relative(_) if !cost.is_known(of) => f64::NAN,
                Limit::Relative(share) => error(of) / (share * cost.size(of)),
            }
        });
        shares.filter(|share| share.is_finite()).fold(f64::NAN, f64::max)
    }

    /// What is asked for in words, `F2 to 0.1N`.
    pub fn words(&self, cost: &Cost) -> String {
        let names: Vec<&str> =
            self.of.iter().map(|index| cost.shown[*index].quantity.name).collect();
        let value = self.text.split_once('=').map_or(self.text.as_str(), |(_, value)| value);
        match names.len() {
            0..=4 => format!("{} to {}", names.join(", "), value.trim()),
            count => format!("{} quantities to {}", number::count(count), value.trim()),
        }
    }
}
