//! How a motion is integrated: what stands behind `--rtol`, `--atol` and `--method`.

use assur::answer::{Method, Settings};
use assur::registry::SceneEntry;
use assur::shape::Quantity;
use assur_model::nearest::nearest;
use clap::Args;

use crate::ask::lookup;
use crate::ask::values;
use crate::error::Failure;

/// Tolerances between which the methods do what they say.
pub const RTOL: (f64, f64) = (1e-14, 1e-2);
/// The options.
#[derive(Args, Debug, Default)]
pub struct Accuracy {
    /// Relative tolerance of the integration, from 1e-14 to 1e-2.
    #[arg(long, value_name = "NUMBER", value_parser = rtol, allow_hyphen_values = true)]
    pub rtol: Option<f64>,
    /// Absolute tolerance of a state, `x=1nm`, `dot(x)=1[um/s]`; may be repeated. Else rtol times the scale of the state.
    #[arg(long, value_name = "NAME=VALUE")]
    pub atol: Vec<String>,
    /// Integration method: dop853, tsit5 or taylor, for stiff motions radau or rosenbrock; unless given auto, which finds out.
    #[arg(long, value_name = "METHOD", value_parser = method)]
    pub method: Option<Method>,
}

impl Accuracy {
    /// The options that are given, with what is given.
    pub fn given(&self) -> impl Iterator<Item = (&'static str, String)> {
        let rtol = self.rtol.map(|rtol| ("--rtol", format!("{rtol:e}")));
        let atol = self.atol.iter().map(|text| ("--atol", text.clone()));
        let method = self.method.map(|method| ("--method", method.to_string()));
        rtol.into_iter().chain(atol).chain(method)
    }

    /// Reads them.
    ///
    /// # Errors
    /// The first tolerance that is of no state, out of range, or given twice.
    pub fn settings(&self, scene: &SceneEntry) -> Result<Settings, Failure> {
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
        let settings = Settings::new(self.method.unwrap_or_default());
        Ok(Settings { atol, ..settings.rtol(self.rtol.unwrap_or(Settings::default().rtol)) })
    }
}

impl Accuracy {
    /// The settings of a linkage, of which none can be chosen.
    ///
    /// # Errors
    /// When one is given all the same.
    pub fn none_for_linkages(&self) -> Result<Settings, Failure> {
        match self.given().next() {
            None => Ok(Settings::default()),
            Some((option, text)) => Err(Failure::request(format!("a linkage takes no {option}"))
                .place(format!("{option} {text}"))
                .reason("its loops are closed to rounding; nothing is integrated")
                .remedy("leave it out")),
        }
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

/// The absolute tolerances that are given: the states, and how much in SI units.
pub fn given_atol<'a>(
    settings: &'a Settings,
    scene: &SceneEntry,
) -> impl Iterator<Item = (&'static Quantity, f64)> + use<'a> {
    let pairs = scene.states.iter().zip(&settings.atol);
    pairs.filter_map(|(state, atol)| Some((state, (*atol)?)))
}

/// Reads the relative tolerance.
fn rtol(text: &str) -> Result<f64, Failure> {
    let range = format!("from {:e} to {:e}", RTOL.0, RTOL.1);
    let refuse = |reason: String| {
        let default = Settings::default().rtol;
        Failure::request("the relative tolerance is out of range")
            .reason(reason)
            .remedy(format!("give a number {range}; the default is {default:e}"))
    };
    match text.trim().parse::<f64>() {
        Ok(value) if (RTOL.0..=RTOL.1).contains(&value) => Ok(value),
        Ok(value) if value < RTOL.0 && value > 0.0 => {
            Err(refuse("rounding errors of double precision are larger".to_owned()))
        }
        Ok(_) => Err(refuse(format!("the methods do what they say {range}"))),
        Err(_) => Err(refuse(format!("`{text}` is not a number"))),
    }
}

/// Reads the method; the nearest name is offered.
fn method(text: &str) -> Result<Method, Failure> {
    text.parse().map_err(|_| {
        let names = Method::ALL.map(Method::name);
        Failure::request(format!("there is no method `{text}`")).remedy(
            match nearest(text, names) {
                Some(name) => format!("did you mean `{name}`?"),
                None => format!("there are: {}", names.join(", ")),
            },
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_have_a_range() {
        assert_eq!(rtol("1e-9"), Ok(1e-9));
        for wrong in ["0", "-1", "nan", "inf", "1e-20", "1", "ten"] {
            assert_eq!(rtol(wrong).map_err(|failure| failure.code()), Err(2), "{wrong}");
        }
    }

    #[test]
    fn methods_are_found_and_offered() {
        assert_eq!(method("tsit5"), Ok(Method::Tsit5));
        assert_eq!(method("auto"), Ok(Method::Auto));
        let failure = method("tsit").expect_err("no such method");
        assert!(failure.render(crate::show::style::Style::PLAIN).contains("did you mean `tsit5`?"));
    }
}
