//! How a motion is integrated: what stands behind `--rtol`, `--atol` and `--method`.

use assur::registry::{Method, SceneEntry, Settings};
use assur_model::nearest::nearest;
use clap::Args;

use crate::error::Failure;
use crate::{lookup, unit, values};

/// Tolerances between which the methods do what they say.
pub const RTOL: (f64, f64) = (1e-14, 1e-2);
/// The options.
#[derive(Args, Debug, Default)]
pub struct Accuracy {
    /// Relative tolerance of the integration, from 1e-14 to 1e-2.
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub rtol: Option<String>,
    /// Absolute tolerance of a state, `x=1nm`, `dot(x)=1[um/s]`; may be repeated. Else rtol times the scale of the state.
    #[arg(long, value_name = "NAME=VALUE")]
    pub atol: Vec<String>,
    /// Integration method: dop853, tsit5 or taylor, for stiff motions radau or rosenbrock, or auto, which finds out.
    #[arg(long, value_name = "METHOD")]
    pub method: Option<String>,
}

impl Accuracy {
    /// The options that are given, with what is given.
    pub fn given(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let rtol = self.rtol.iter().map(|text| ("--rtol", text.as_str()));
        let atol = self.atol.iter().map(|text| ("--atol", text.as_str()));
        let method = self.method.iter().map(|text| ("--method", text.as_str()));
        rtol.chain(atol).chain(method)
    }

    /// Reads them.
    ///
    /// # Errors
    /// The first that is unknown, out of range, or given twice.
    pub fn settings(&self, scene: &SceneEntry) -> Result<Settings, Failure> {
        let method = method(self.method.as_deref())?;
        let rtol = rtol(self.rtol.as_deref())?;
        let mut atol = Vec::new();
        let mut given = Vec::new();
        for text in &self.atol {
            let (state, value) = absolute(scene, text)?;
            let place = format!("--atol {text}");
            let what = format!("the tolerance of `{}`", scene.states[state].name);
            values::once(&mut given, state, &what, &place)?;
            atol.resize(scene.states.len(), None);
            atol[state] = Some(value);
        }
        Ok(Settings { atol, ..Settings::new(method).rtol(rtol) })
    }
}

/// Reads the absolute tolerance of a state: which, and how much in SI units.
fn absolute(scene: &SceneEntry, text: &str) -> Result<(usize, f64), Failure> {
    let states = scene.states;
    let example = states.first().map_or("x=1nm".to_owned(), |state| {
        format!("'{}=1e-12{}'", state.name, bracketed(state.unit))
    });
    let failed = |failure: Failure| failure.place(format!("--atol {text}"));
    let (name, value) = values::split(text, "--atol", &example)?;
    let Some(index) = states.iter().position(|state| state.name == name) else {
        let names: Vec<_> = states.iter().map(|state| state.name).collect();
        let failure = Failure::request(format!("`{name}` is no state of scene `{}`", scene.name));
        return Err(failed(failure.remedy(lookup::suggestion(name, &names))));
    };
    let value = values::quantity(value, &states[index]).map_err(failed)?;
    if value > 0.0 {
        return Ok((index, value));
    }
    let failure = Failure::request(format!("a tolerance of `{name}` is a number above 0"));
    Err(failed(failure.remedy(format!("for example: --atol {example}"))))
}

/// A unit as it stands behind a number; nothing for a pure number.
fn bracketed(unit: &str) -> String {
    match unit {
        "" => String::new(),
        unit => format!("[{unit}]"),
    }
}

/// The absolute tolerances that are given: name, unit, and number of units.
pub fn given_atol(
    settings: &Settings,
    scene: &SceneEntry,
) -> Vec<(&'static str, &'static str, f64)> {
    let pairs = scene.states.iter().zip(&settings.atol);
    let given = pairs.filter_map(|(state, atol)| Some((state, (*atol)?)));
    given.map(|(state, atol)| (state.name, state.unit, unit::stated(atol, state.factor))).collect()
}

/// Reads the relative tolerance.
///
/// # Errors
/// When it is no number or out of range.
pub fn rtol(text: Option<&str>) -> Result<f64, Failure> {
    let Some(text) = text else {
        return Ok(Settings::default().rtol);
    };
    let range = format!("from {:e} to {:e}", RTOL.0, RTOL.1);
    let default = Settings::default().rtol;
    let remedy = format!("give a number {range}; the default is {default:e}");
    let refuse = |reason: String| {
        Failure::request("the relative tolerance is out of range")
            .place(format!("--rtol {text}"))
            .reason(reason)
            .remedy(remedy.clone())
    };
    let value: f64 =
        text.trim().parse().map_err(|_| refuse(format!("`{text}` is not a number")))?;
    if (RTOL.0..=RTOL.1).contains(&value) {
        return Ok(value);
    }
    Err(refuse(if value < RTOL.0 && value > 0.0 {
        "rounding errors of double precision are larger".to_owned()
    } else {
        format!("the methods do what they say {range}")
    }))
}

/// Reads the method.
///
/// # Errors
/// When there is none of this name; the nearest name is offered.
pub fn method(text: Option<&str>) -> Result<Method, Failure> {
    let Some(text) = text else {
        return Ok(Method::default());
    };
    if let Ok(method) = text.parse() {
        return Ok(method);
    }
    let names = Method::ALL.map(Method::name);
    let remedy = match nearest(text, names) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("there are: {}", names.join(", ")),
    };
    Err(Failure::request(format!("there is no method `{text}`"))
        .place(format!("--method {text}"))
        .remedy(remedy))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_have_a_range() {
        assert_eq!(rtol(Some("1e-9")), Ok(1e-9));
        for wrong in ["0", "-1", "nan", "inf", "1e-20", "1", "ten"] {
            assert_eq!(rtol(Some(wrong)).map_err(|failure| failure.code()), Err(2), "{wrong}");
        }
    }

    #[test]
    fn methods_are_found_and_offered() {
        assert_eq!(method(Some("tsit5")), Ok(Method::Tsit5));
        assert_eq!(method(Some("auto")), Ok(Method::Auto));
        let failure = method(Some("tsit")).expect_err("no such method");
        assert!(failure.render(crate::style::Style::PLAIN).contains("did you mean `tsit5`?"));
    }
}
