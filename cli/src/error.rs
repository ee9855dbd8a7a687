//! Why the command did not do what was asked: what, where, and what to do about it.

use std::fmt;

use crate::show::style::Style;

/// The order in which facts are printed, however they were added.
const ORDER: [&str; 3] = ["where", "why", "help"];

/// Most characters of a line that is printed.
const LONGEST: usize = 1000;

/// Why something is so, and what to do about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// Where it is, as positions of drivers; empty if that is not known.
    pub place: String,
    /// Why.
    pub reason: String,
    /// What to do about it.
    pub remedy: &'static str,
}

impl Told {
    /// Of something without a place of its own.
    pub fn new(reason: impl Into<String>, remedy: &'static str) -> Self {
        Self { place: String::new(), reason: reason.into(), remedy }
    }

    /// The message of a command that wanted to do something.
    pub fn failure(self, what: impl Into<String>) -> Failure {
        Failure::numerical(what).reason(self.reason).remedy(self.remedy)
    }
}

/// A request that could not be carried out.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    kind: Kind,
    what: String,
    facts: Vec<(&'static str, String)>,
    /// The motion comes to a place where its equations do not say how it goes on.
    is_lost: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Request,
    Numerical,
    Interrupted,
    /// Everything has been said already; only the exit code is left.
    Said,
}

impl Failure {
    /// The request itself is wrong: exit code 2.
    pub fn request(what: impl Into<String>) -> Self {
        Self { kind: Kind::Request, what: what.into(), facts: Vec::new(), is_lost: false }
    }

    /// The request is right but the numbers did not come out: exit code 1.
    pub fn numerical(what: impl Into<String>) -> Self {
        Self { kind: Kind::Numerical, ..Self::request(what) }
    }

    /// Only a part was done, as it was stopped: exit code 130.
    pub fn interrupted(what: impl Into<String>) -> Self {
        Self { kind: Kind::Interrupted, ..Self::request(what) }
    }

    /// The request is wrong and every message about it is already printed: exit code 2.
    pub fn said() -> Self {
        Self { kind: Kind::Said, ..Self::request("") }
    }

    /// Adds where it went wrong.
    #[must_use]
    pub fn place(self, place: impl Into<String>) -> Self {
        self.fact("where", place)
    }

    /// Adds why.
    #[must_use]
    pub fn reason(self, reason: impl Into<String>) -> Self {
        self.fact("why", reason)
    }

    /// Adds what to do about it.
    #[must_use]
    pub fn remedy(self, remedy: impl Into<String>) -> Self {
        self.fact("help", remedy)
    }

    /// A place that is part of a larger one, which who read that adds, is not said besides.
    fn fact(mut self, label: &'static str, text: impl Into<String>) -> Self {
        let text = text.into();
        self.facts.retain(|(other, known)| *other != label || !text.starts_with(known.as_str()));
        self.facts.push((label, text));
        self
    }

    /// Adds whether the motion comes to a place where its equations do not say how it goes on.
    #[must_use]
    pub fn lost(self, is_lost: bool) -> Self {
        Self { is_lost, ..self }
    }

    /// Whether it does.
    pub fn is_lost(&self) -> bool {
        self.is_lost
    }

    /// Why, if that is known.
    pub fn why(&self) -> Option<&str> {
        let mut facts = self.facts.iter();
        facts.find(|(label, _)| *label == ORDER[1]).map(|(_, text)| text.as_str())
    }

    /// What was not done, without the facts about it.
    pub fn what(&self) -> &str {
        &self.what
    }

    /// The exit code of the command.
    pub fn code(&self) -> u8 {
        match self.kind {
            Kind::Numerical => 1,
            Kind::Interrupted => 130,
            Kind::Request | Kind::Said => 2,
        }
    }

    /// The whole message, with its last line ended; empty when everything is said.
    pub fn render(&self, style: Style) -> String {
        if self.kind == Kind::Said {
            return String::new();
        }
        let what: Vec<String> = self.what.lines().map(printable).collect();
        let mut text = format!("{} {}\n", style.error("error:"), what.join("\n"));
        let ordered = ORDER.into_iter().flat_map(|label| {
            let mut facts = self.facts.iter();
            std::iter::from_fn(move || facts.find(|(other, _)| *other == label))
        });
        for (label, fact) in ordered {
            let label = style.accent(&format!("{label:>5}:"));
            for (index, line) in fact.lines().map(printable).enumerate() {
                if index == 0 {
                    text += &format!(" {label} {line}\n");
                } else {
                    text += &format!("        {line}\n");
                }
            }
        }
        text
    }
}

/// Without facts, as a reason of something else. Options that are read as the command starts are refused so.
impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.what)
    }
}

impl std::error::Error for Failure {}

/// A line with what a terminal would obey, and would not show, written out.
fn printable(line: &str) -> String {
    let written = |one: char| match one.is_control() {
        true => one.escape_default().to_string(),
        false => one.to_string(),
    };
    shortened(&line.chars().map(written).collect::<String>())
}

/// A line as it is printed: of a longer one, which what was typed has made long, the begin and the end.
pub fn shortened(line: &str) -> String {
    let length = line.chars().count();
    if length <= LONGEST {
        return line.to_owned();
    }
    let begin: String = line.chars().take(LONGEST / 2).collect();
    let end: String = line.chars().skip(length - LONGEST / 10).collect();
    let left = length - LONGEST / 2 - LONGEST / 10;
    format!("{begin} … {left} characters … {end}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_said_twice_is_printed_once() {
        for part in ["--at a=1,", "--at "] {
            let failure = Failure::request("wrong").place(part).place("--at a=1,");
            let text = failure.render(Style::PLAIN);
            assert_eq!(text, "error: wrong\n where: --at a=1,\n");
        }
    }

    #[test]
    fn long_lines_are_cut() {
        let long = "é".repeat(300_000);
        let failure = Failure::request(format!("no `{long}`")).place(&long);
        let text = failure.render(Style::PLAIN);
        assert!(text.chars().count() < 2000, "{}", text.len());
        assert!(text.contains("299400 characters"), "{text}");
        assert_eq!(shortened("short"), "short");
        assert_eq!(printable("ba\u{1b}[31mtten"), "ba\\u{1b}[31mtten");
    }

    #[test]
    fn says_what_where_and_remedy() {
        let failure = Failure::request("there is no mechanism `baten`")
            .remedy("did you mean `batten`?\nall: `assur list`")
            .place("run NAME");
        assert_eq!(
            failure.render(Style::PLAIN),
            "error: there is no mechanism `baten`\n where: run NAME\n  help: did you mean `batten`?\n        all: `assur list`\n"
        );
        assert_eq!(failure.code(), 2);
    }

    #[test]
    fn numbers_that_do_not_come_out_are_another_code() {
        assert_eq!(Failure::numerical("resonance").code(), 1);
        assert_eq!(Failure::said().render(Style::PLAIN), "");
    }
}
