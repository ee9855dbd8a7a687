//! Changes of a scene: other effects and choices, another task, other start values.
//!
//! They become statements of the language, which reads and checks them as it does those of a file.

use clap::Args;

use super::values::{split, whole};
use crate::error::Failure;

/// The options that change a scene. It is shown as one without a name.
#[derive(Args, Clone, Debug, Default)]
pub struct Changes {
    /// Switch an effect on, `--with damping,coupling`; may be repeated.
    #[arg(long, value_name = "EFFECTS", value_delimiter = ',', help_heading = "Another scene")]
    pub with: Vec<String>,
    /// Switch an effect off; may be repeated.
    #[arg(long, value_name = "EFFECTS", value_delimiter = ',', help_heading = "Another scene")]
    pub without: Vec<String>,
    /// Make a choice, `--choose crank=exact`; may be repeated.
    #[arg(
        long,
        value_name = "CHOICE=ALTERNATIVE",
        value_delimiter = ',',
        help_heading = "Another scene"
    )]
    pub choose: Vec<String>,
    /// Let a driver stand where its value says, as a parameter: --set gives it another, a study goes --over it.
    #[arg(long, value_name = "DRIVERS", value_delimiter = ',', help_heading = "Another scene")]
    pub hold: Vec<String>,
    /// Begin elsewhere, `--start 'w=-0.3mm'`, `--start 'dot(w)=1[m/s]'`; may be repeated.
    #[arg(long, value_name = "STATE=VALUE", help_heading = "Another scene")]
    pub start: Vec<String>,
    /// Follow the motion from a time to a time, `0s..2s`.
    #[arg(long, value_name = "FROM..TO", help_heading = "Another scene", conflicts_with_all = ["periodic", "sweep"])]
    pub run: Option<String>,
    /// Find the steady state of a period, `20ms`.
    #[arg(long, value_name = "PERIOD", help_heading = "Another scene", conflicts_with = "sweep")]
    pub periodic: Option<String>,
    /// Move drivers over ranges, `phi4=60deg..120deg`, or `phi4` over the range of the file; commas between several.
    #[arg(long, value_name = "DRIVER=FROM..TO", help_heading = "Another scene")]
    pub sweep: Option<String>,
    /// Put the linkage together in another mode, as `assur modes` numbers them where the drivers start.
    #[arg(long, value_name = "NUMBER", value_parser = whole::<1, MODES>, allow_hyphen_values = true)]
    #[arg(help_heading = "Another scene")]
    pub mode: Option<u64>,
}

/// Most assembly modes.
const MODES: u64 = 1_000_000;

impl Changes {
    /// Whether any is asked for.
    pub fn are_given(&self) -> bool {
        let lists = [&self.with, &self.without, &self.choose, &self.hold, &self.start];
        let tasks = [&self.run, &self.periodic, &self.sweep];
        self.mode.is_some()
            || lists.iter().any(|list| !list.is_empty())
            || tasks.iter().any(|task| task.is_some())
    }

    /// The changes as statements, but for the assembly mode.
    ///
    /// # Errors
    /// An option that lacks a part.
    pub fn statements(&self) -> Result<Vec<String>, Failure> {
        let mut lines = Vec::new();
        lines.extend(self.with.iter().map(|effect| format!("with {effect};")));
        lines.extend(self.without.iter().map(|effect| format!("without {effect};")));
        for text in &self.choose {
            let (choice, alternative) = split(text, "--choose", "crank=exact")?;
            lines.push(format!("with {choice}.{alternative};"));
        }
        lines.extend(self.hold.iter().map(|driver| format!("hold {driver};")));
        for text in &self.start {
            let (state, value) = split(text, "--start", "w=-0.3mm")?;
            lines.push(format!("start {state} = {};", spaced(value)));
        }
        if let Some(text) = &self.run {
            lines.push(format!("run time {};", range(text, "--run", "0s..2s")?));
        }
        if let Some(text) = &self.periodic {
            lines.push(format!("periodic over {};", spaced(text)));
        }
        if let Some(text) = &self.sweep {
            let each = text.split(',').map(|one| match one.split_once('=') {
                Some((driver, ends)) => {
                    Ok(format!("{driver} {}", range(ends, "--sweep", "phi4=60deg..120deg")?))
                }
                None => Ok(one.to_owned()),
            });
            let each = each.collect::<Result<Vec<_>, Failure>>()?;
            lines.push(format!("sweep {};", each.join(", ")));
        }
        Ok(lines)
    }
}

/// `0 s .. 2 s`
fn range(text: &str, option: &str, example: &str) -> Result<String, Failure> {
    match text.split_once("..") {
        Some((from, to)) => Ok(format!("{} .. {}", spaced(from.trim()), spaced(to.trim()))),
        None => Err(Failure::request(format!("`{text}` is no range"))
            .place(format!("{option} {text}"))
            .remedy(format!("write {option} {example}"))),
    }
}

/// A value as the language writes it: with a space between a number and its unit.
fn spaced(value: &str) -> String {
    let mut text = String::new();
    let (mut is_number, mut before) = (false, ' ');
    let mut rest = value.chars().peekable();
    while let Some(letter) = rest.next() {
        let next = rest.peek().copied().unwrap_or(' ');
        let is_exponent =
            matches!(letter, 'e' | 'E') && (next.is_ascii_digit() || matches!(next, '-' | '+'));
        if is_number && !is_exponent && (letter.is_alphabetic() || matches!(letter, '%' | '°')) {
            text.push(' ');
        }
        let is_inside = before.is_alphanumeric() || before == '_';
        is_number = match letter {
            '0'..='9' => is_number || !is_inside,
            '.' | 'e' | 'E' => is_number && (letter == '.' || is_exponent),
            '-' | '+' => is_number && matches!(before, 'e' | 'E'),
            _ => false,
        };
        text.push(letter);
        before = letter;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_apart_from_their_numbers() {
        for (given, written) in [
            ("-0.3mm", "-0.3 mm"),
            ("1[m/s]", "1[m/s]"),
            ("1e-3m", "1e-3 m"),
            ("2.5E6Pa", "2.5E6 Pa"),
            ("60 deg", "60 deg"),
            ("l4/2", "l4/2"),
            ("2*l4 + 3mm", "2*l4 + 3 mm"),
            ("3eV", "3 eV"),
        ] {
            assert_eq!(spaced(given), written);
        }
    }

    #[test]
    fn changes_become_statements() {
        let changes = Changes {
            with: vec!["damping".into()],
            choose: vec!["crank=exact".into()],
            start: vec!["dot(w)=1[m/s]".into()],
            sweep: Some("phi4=60deg..120deg,alpha".into()),
            ..Changes::default()
        };
        assert_eq!(
            changes.statements().expect("statements"),
            [
                "with damping;",
                "with crank.exact;",
                "start dot(w) = 1[m/s];",
                "sweep phi4 60 deg .. 120 deg, alpha;"
            ]
        );
        assert!(!Changes::default().are_given());
        let wrong = Changes { run: Some("2s".into()), ..Changes::default() };
        assert!(wrong.statements().is_err());
    }
}
