//! By how much quantities may differ at most, behind `--for` and `--within`.

use assur::shape::Quantity;

use crate::ask::lookup::suggestion;
use crate::ask::values;
use crate::error::Failure;
use crate::show::number;

/// An accuracy.
pub struct Wanted {
    /// As it is written.
    pub text: String,
    /// Whose errors count, by place.
    pub of: Vec<usize>,
    limit: Limit,
}

/// What differs, SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// By how much.
    pub error: f64,
    /// How large it is; not a number where it is nothing but rounding, and has no relative error.
    pub size: f64,
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
    pub fn read(option: &str, text: &str, shown: &[Quantity]) -> Result<Self, Failure> {
        let place = || format!("{option} {text}");
        let (name, value) = match text.split_once('=') {
            Some((name, value)) => (Some(name.trim()), value.trim()),
            None => (None, text.trim()),
        };
        let known: Vec<&str> = shown.iter().map(|one| one.name).collect();
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
                        .remedy(format!("for example: {option} 0.1%"))
                })?;
                (all(), Limit::Relative(share / 100.0))
            }
            None => {
                let reads = |quantity: &Quantity| values::quantity(value, quantity);
                let of: Vec<usize> = match named {
                    Some(index) => vec![index],
                    None => {
                        let suits = |index: &usize| reads(&shown[*index]).is_ok();
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
                let value = reads(&shown[*first]);
                (of, Limit::Absolute(value.map_err(|failure| failure.place(place()))?))
            }
        };
        let (Limit::Absolute(value) | Limit::Relative(value)) = limit;
        if value.is_nan() || value <= 0.0 {
            return Err(Failure::request("an accuracy is a number above 0")
                .place(place())
                .remedy(format!("for example: {option} 'F=0.1N', {option} 1um, {option} 0.1%")));
        }
        Ok(Self { text: text.to_owned(), of, limit })
    }

    /// The largest error over what is permitted: at most 1 where the accuracy is reached. Not a number where nothing of it is
    /// known.
    pub fn share(&self, differs: impl Fn(usize) -> Difference) -> f64 {
        self.worst(differs).map_or(f64::NAN, |(_, share)| share)
    }

    /// The same, and of which it is, by place.
    pub fn worst(&self, differs: impl Fn(usize) -> Difference) -> Option<(usize, f64)> {
        let shares = self.of.iter().map(|&index| {
            let Difference { error, size } = differs(index);
            let share = match self.limit {
                Limit::Absolute(value) => error / value,
                Limit::Relative(share) => error / (share * size),
            };
            (index, share)
        });
        shares.filter(|(_, share)| !share.is_nan()).max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// What is asked for in words, `F2 to 0.1N`.
    pub fn words(&self, shown: &[Quantity]) -> String {
        let names: Vec<&str> = self.of.iter().map(|index| shown[*index].name).collect();
        let value = self.text.split_once('=').map_or(self.text.as_str(), |(_, value)| value);
        match names.len() {
            0..=4 => format!("{} to {}", names.join(", "), value.trim()),
            count => format!("{} quantities to {}", number::count(count), value.trim()),
        }
    }
}
