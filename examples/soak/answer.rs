//! What the command says, as numbers with their errors.

use std::io::{self, Read};
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::case::{Case, Precision};

/// A run that takes longer is a finding; a reference, of many more digits, may take longer by this factor.
const PATIENCE: Duration = Duration::from_secs(240);
const REFERENCE: u32 = 4;

/// What a number is, for the tally.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Value,
    Extreme,
    ExtremeTime,
    EventTime,
    Measure,
    Energy,
    Closure,
}

impl Kind {
    pub const ALL: [Self; 7] = [
        Self::Value,
        Self::Extreme,
        Self::ExtremeTime,
        Self::EventTime,
        Self::Measure,
        Self::Energy,
        Self::Closure,
    ];

    pub fn name(self) -> &'static str {
        match self {
            Self::Value => "values at times",
            Self::Extreme => "extremes",
            Self::ExtremeTime => "times of extremes",
            Self::EventTime => "times of events",
            Self::Measure => "measures",
            Self::Energy => "energies that stay",
            Self::Closure => "closed loops",
        }
    }
}

/// A number that is printed.
#[derive(Clone, Debug)]
pub struct Number {
    pub kind: Kind,
    pub name: String,
    pub value: f64,
    /// The error that stands beside it; not a number where none does.
    pub error: f64,
}

/// What the command says of a run.
#[derive(Clone, Debug)]
pub struct Answer {
    pub status: String,
    /// Periods after which a motion repeats.
    pub periods: u64,
    pub numbers: Vec<Number>,
    /// The events without their times.
    pub events: Vec<String>,
}

/// Why there is no answer: the command's exit code and words.
#[derive(Clone, Debug)]
pub struct Refusal {
    pub code: Option<i32>,
    pub text: String,
}

/// Asks the command.
pub fn ask(command: &Path, case: &Case, precision: Precision) -> Result<Answer, Refusal> {
    let patience = match precision {
        Precision::Tried => PATIENCE,
        Precision::Reference => REFERENCE * PATIENCE,
    };
    let (code, output, complaint) = output(command, case.arguments(precision), patience)
        .map_err(|error| Refusal { code: None, text: error.to_string() })?;
    serde_json::from_slice(&output)
        .map(|json| read(&json))
        .map_err(|_| Refusal { code, text: String::from_utf8_lossy(&complaint).into_owned() })
}

/// Exit code and both outputs of the command, which is ended if it takes too long.
fn output(
    command: &Path,
    arguments: Vec<String>,
    patience: Duration,
) -> io::Result<(Option<i32>, Vec<u8>, Vec<u8>)> {
    let mut child = Command::new(command)
        .args(arguments)
        .args(["--format", "json"])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()?;
    // Both are read while the command runs: a full pipe would stop it.
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    std::thread::scope(|scope| {
        let stdout = scope.spawn(|| contents(stdout));
        let stderr = scope.spawn(|| contents(stderr));
        let end = Instant::now() + patience;
        let status = loop {
            if let Some(status) = child.try_wait()? {
                break status;
            }
            if Instant::now() > end {
                child.kill()?;
            }
            std::thread::sleep(Duration::from_millis(2));
        };
        let read = |thread: std::thread::ScopedJoinHandle<'_, _>| thread.join().unwrap_or_default();
        let (stdout, stderr) = (read(stdout), read(stderr));
        match Instant::now() > end {
            true => Ok((None, Vec::new(), b"it took too long".to_vec())),
            false => Ok((status.code(), stdout, stderr)),
        }
    })
}

fn contents(pipe: Option<impl Read>) -> Vec<u8> {
    let mut bytes = Vec::new();
    // What could be read of a broken pipe is no JSON, and is reported as such.
    let _ = pipe.map(|mut pipe| pipe.read_to_end(&mut bytes));
    bytes
}

fn read(json: &Value) -> Answer {
    let mut numbers = Vec::new();
    for result in list(&json["results"]) {
        for end in ["minimum", "maximum"] {
            let extreme = &result[end];
            let name = format!("{end} of {}", text(&result["name"]));
            numbers.push(number(Kind::Extreme, &name, extreme, "value", "estimated_error"));
            numbers.push(number(
                Kind::ExtremeTime,
                &name,
                extreme,
                "time",
                "estimated_error_of_time",
            ));
        }
    }
    for place in list(&json["at"]) {
        for result in list(&place["results"]) {
            let name = format!("{} at {}", text(&result["name"]), text(&place["place"]));
            numbers.push(number(Kind::Value, &name, result, "value", "estimated_error"));
        }
    }
    for (index, event) in list(&json["events"]).iter().enumerate() {
        let name = format!("event {} {}", index + 1, text(&event["event"]));
        numbers.push(number(Kind::EventTime, &name, event, "time", "estimated_error"));
    }
    for measure in list(&json["measures"]) {
        let name = text(&measure["name"]);
        numbers.push(number(Kind::Measure, &name, measure, "value", "estimated_error"));
    }
    Answer {
        status: text(&json["status"]),
        periods: json["task"]["periods"].as_u64().unwrap_or(1),
        events: list(&json["events"]).iter().map(|event| text(&event["event"])).collect(),
        numbers,
    }
}

fn number(kind: Kind, name: &str, of: &Value, value: &str, error: &str) -> Number {
    Number {
        kind,
        name: name.to_owned(),
        value: of[value].as_f64().unwrap_or(f64::NAN),
        error: of[error].as_f64().unwrap_or(f64::NAN),
    }
}

fn list(json: &Value) -> &[Value] {
    json.as_array().map_or(&[], Vec::as_slice)
}

fn text(json: &Value) -> String {
    json.as_str().unwrap_or_default().to_owned()
}
