//! Published numbers beside the computed ones.
//!
//! A computed number has one digit more than its band touches: what is the same on every machine, and says how far from
//! the middle of the band it is.

use assur::registry::{Mechanism, SceneEntry};

use super::markdown::{Table, code, inline};
use crate::ask::constants::Constants;
use crate::error::Failure;
use crate::published::Stated;
use crate::show::number;
use crate::{linkage, motion};

/// Columns of the table.
const COLUMNS: [&str; 9] =
    ["scene", "quantity", "where", "published", "computed", "unit", "deviation", "band", "remark"];
/// The columns before the computed number, which tell a row from others.
const KEY: usize = 4;
/// Most decimals of a number without an exponent.
const DECIMALS: i32 = 15;

/// Where computed numbers come from.
pub trait Computed {
    /// The number computed for a fact; none where there is none.
    fn text(&self, scene: &SceneEntry, stated: &Stated) -> Option<String>;
}

/// A row of the table.
pub struct Row {
    scene: &'static str,
    stated: Stated,
    computed: Option<String>,
}

/// The published numbers of a mechanism, scene by scene.
///
/// # Errors
/// When the mechanism refuses its own values.
pub fn rows(mechanism: &'static Mechanism, computed: &dyn Computed) -> Result<Vec<Row>, Failure> {
    let mut rows = Vec::new();
    for scene in mechanism.scenes {
        rows.extend(stated(mechanism, scene)?.into_iter().map(|stated| Row {
            scene: scene.name,
            computed: computed.text(scene, &stated),
            stated,
        }));
    }
    Ok(rows)
}

/// The facts of a scene in words.
fn stated(
    mechanism: &'static Mechanism,
    scene: &'static SceneEntry,
) -> Result<Vec<Stated>, Failure> {
    let constants = Constants::declared(mechanism, scene);
    let facts = scene.expectations.iter();
    let stated: Vec<_> = match scene.linkage {
        _ if scene.expectations.is_empty() => Vec::new(),
        Some(_) => {
            let case = linkage::case::Case::new(constants.clone())?;
            facts.filter_map(|fact| case.stated(fact)).collect()
        }
        None => {
            let case = motion::case::Case::new(constants.clone())?;
            facts.filter_map(|fact| case.stated(fact)).collect()
        }
    };
    Ok(stated.into_iter().map(|one| one.with_preset(&constants)).collect())
}

/// The table, empty without rows.
pub fn table(rows: &[Row]) -> String {
    let mut table = Table::new(&COLUMNS, &["published", "computed", "deviation"]);
    for row in rows {
        table.row(row.cells().to_vec());
    }
    table.render()
}

impl Row {
    /// Whether the computed number, as it is shown, lies in the band.
    pub fn is_within(&self) -> bool {
        let slack = 0.5 * 10f64.powi(last(self.tolerance()));
        self.deviation().is_some_and(|deviation| deviation.abs() <= self.tolerance() + slack)
    }

    fn tolerance(&self) -> f64 {
        self.stated.in_unit(self.stated.fact.tolerance)
    }

    fn published(&self) -> f64 {
        self.stated.in_unit(self.stated.fact.value)
    }

    /// The number that is shown less the published one.
    fn deviation(&self) -> Option<f64> {
        Some(self.computed.as_ref()?.parse::<f64>().ok()? - self.published())
    }

    fn cells(&self) -> [String; COLUMNS.len()] {
        let [scene, quantity, place, published] = key(self.scene, &self.stated);
        let deviation = self
            .deviation()
            .map_or("-".to_owned(), |deviation| signed(&rounded(deviation, &self.stated)));
        let band = format!("± {}", number::short(self.tolerance()));
        let band = if self.is_within() { band } else { format!("{band}, **outside**") };
        [
            scene,
            quantity,
            place,
            published,
            self.computed.clone().unwrap_or_else(|| "none".to_owned()),
            inline(&self.stated.unit),
            deviation,
            band,
            inline(self.stated.fact.remark),
        ]
    }
}

/// The cells that tell a row from others.
fn key(scene: &str, stated: &Stated) -> [String; KEY] {
    [
        code(scene),
        code(&stated.name),
        inline(&stated.place),
        written(stated.in_unit(stated.fact.value)),
    ]
}

/// The computed number of a fact among rows of a page, each of which is its cells.
pub fn recalled(rows: &[Vec<String>], scene: &SceneEntry, stated: &Stated) -> Option<String> {
    let key = key(scene.name, stated);
    let row = rows.iter().find(|row| row.len() > KEY && row[..KEY] == key)?;
    Some(row[KEY].clone())
}

/// The power of ten of the last digit that a tolerance warrants.
fn last(tolerance: f64) -> i32 {
    let first = format!("{tolerance:.0e}");
    let power = first.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok());
    power.unwrap_or(0) - 1
}

/// A value in the unit of a fact, with the digits that its tolerance warrants.
pub fn rounded(value: f64, stated: &Stated) -> String {
    to_digit(value, last(stated.in_unit(stated.fact.tolerance)))
}

fn to_digit(value: f64, last: i32) -> String {
    let text = if last >= -DECIMALS {
        format!("{value:.*}", -last.min(0) as usize)
    } else {
        let units = (value * 10f64.powi(-last)).round();
        let digits = 1 + if units == 0.0 { 0 } else { number::exponent(units) };
        number::significant(units * 10f64.powi(last), digits as usize)
    };
    if text.parse() == Ok(0.0) { text.trim_start_matches('-').to_owned() } else { text }
}

/// A value as a file has it, without an exponent unless that is much shorter.
fn written(value: f64) -> String {
    let tidy: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    let plain = format!("{tidy}");
    if plain.len() > 2 + DECIMALS as usize + 2 { number::declared(value) } else { plain }
}

/// A number with its sign; `0` where no digit is another.
fn signed(text: &str) -> String {
    match text.parse::<f64>() {
        Ok(0.0) => "0".to_owned(),
        Ok(value) if value > 0.0 => format!("+{text}"),
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_end_one_behind_the_first_of_the_band() {
        for (value, tolerance, expected) in [
            (0.078_839_2, 0.0016, "0.0788"),
            (-58.605_091_23, 5e-6, "-58.6050912"),
            (720.000_000_01, 1e-6, "720.0000000"),
            (-1e-9, 1e-6, "0.0000000"),
            (20_981.3, 100.0, "20981"),
            (3.806e-15, 1e-16, "3.81e-15"),
            (2e-18, 1e-16, "0"),
        ] {
            assert_eq!(to_digit(value, last(tolerance)), expected);
        }
    }

    #[test]
    fn published_values_are_as_written() {
        assert_eq!(written(-0.496_989_460_230_332), "-0.496989460230332");
        assert_eq!(written(30.179_800_860_191_2), "30.1798008601912");
        assert_eq!(written(1.5e-30), "1.50e-30");
    }

    #[test]
    fn deviations_have_signs() {
        assert_eq!(["0.003", "-0.003", "0.000"].map(signed), ["+0.003", "-0.003", "0"]);
    }
}
