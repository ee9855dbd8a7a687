//! What stands behind `--set`, `--at`, `--preset`, `--rtol` and `--method`: names, values, units.

use assur::registry::{Constant, Mechanism, Method, Preset, Quantity, SceneEntry};

use crate::error::Failure;
use crate::lookup::{nearest, suggestion, with_feature};
use crate::number;
use crate::variables::Dimension;

/// Tolerances between which the methods do what they say.
pub const RTOL: (f64, f64) = (1e-14, 1e-2);
/// The tolerance unless one is given.
pub const DEFAULT_RTOL: f64 = 1e-10;
/// The methods by name, the default one first.
const METHODS: [(&str, Method); 2] = [("dop853", Method::Dop853), ("tsit5", Method::Tsit5)];

/// The dimensions and parameters of a scene with their values, SI units.
#[derive(Clone)]
pub struct Constants {
    /// The scene.
    pub scene: &'static SceneEntry,
    /// The preset that the values start from; empty for the declared ones.
    pub preset: &'static str,
    /// The values, in the order of the scene.
    pub values: Vec<f64>,
    /// Whether the value was given by `--set`.
    pub given: Vec<bool>,
}

impl Constants {
    /// The values that the file declares.
    pub fn declared(scene: &'static SceneEntry) -> Self {
        Self {
            scene,
            preset: scene.preset,
            values: scene
                .constants
                .iter()
                .map(|constant| constant.default)
                .collect(),
            given: vec![false; scene.constants.len()],
        }
    }

    /// The values of the file, with a preset and single values put over them.
    ///
    /// # Errors
    /// Unknown names, wrong units, values that cannot be.
    pub fn from_options(
        mechanism: &'static Mechanism,
        scene: &'static SceneEntry,
        preset: Option<&str>,
        sets: &[String],
    ) -> Result<Self, Failure> {
        let mut constants = Self::declared(scene);
        if let Some(name) = preset {
            constants.apply(find_preset(mechanism, name)?);
        }
        for text in sets {
            constants.set(mechanism, text)?;
        }
        Ok(constants)
    }

    /// Puts a named set of values over these; values that the scene does not have are passed over.
    pub fn apply(&mut self, preset: &Preset) {
        self.preset = preset.name;
        for (name, value) in preset.values {
            if let Some(index) = self.position(name) {
                self.values[index] = *value;
            }
        }
    }

    fn position(&self, name: &str) -> Option<usize> {
        self.scene
            .constants
            .iter()
            .position(|constant| constant.quantity.name == name)
    }

    fn set(&mut self, mechanism: &'static Mechanism, text: &str) -> Result<(), Failure> {
        let (name, value) = split(text, "--set", "n=300rpm")?;
        let index = self
            .position(name)
            .ok_or_else(|| unknown_constant(mechanism, self.scene, name))?;
        let constant = &self.scene.constants[index];
        let value = quantity(value, &constant.quantity)
            .map_err(|failure| failure.place(format!("--set {text}")))?;
        permitted(constant, value).map_err(|failure| failure.place(format!("--set {text}")))?;
        self.values[index] = value;
        self.given[index] = true;
        Ok(())
    }

    /// Whether any value differs from the file's.
    pub fn changed(&self) -> bool {
        (0..self.values.len()).any(|index| self.is_changed(index))
    }

    /// Whether a value differs from the file's.
    pub fn is_changed(&self, index: usize) -> bool {
        self.scene.constants[index].default != self.values[index]
    }
}

/// The preset of this name.
///
/// # Errors
/// When there is none; the nearest name is offered.
pub fn find_preset(mechanism: &'static Mechanism, name: &str) -> Result<&'static Preset, Failure> {
    mechanism
        .presets
        .iter()
        .find(|preset| preset.name == name)
        .ok_or_else(|| {
            let names: Vec<_> = mechanism.presets.iter().map(|preset| preset.name).collect();
            Failure::request(format!("`{}` has no preset `{name}`", mechanism.name))
                .remedy(suggestion(name, &names))
        })
}

/// Where everything is to be printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// At a time, in seconds.
    Time(f64),
    /// Where the driver of this index stands so, SI units.
    Driver(usize, f64),
}

/// Reads an `--at`.
///
/// # Errors
/// An unknown name or a wrong unit.
pub fn place(scene: &'static SceneEntry, text: &str) -> Result<Place, Failure> {
    let example = scene
        .drivers
        .first()
        .map_or("time=0.1s".to_owned(), |driver| {
            format!("{}=110deg", driver.name)
        });
    let (name, value) = split(text, "--at", &example)?;
    let failed = |failure: Failure| failure.place(format!("--at {text}"));
    if name == "time" {
        return quantity(value, &TIME).map(Place::Time).map_err(failed);
    }
    if let Some(index) = scene.drivers.iter().position(|driver| driver.name == name) {
        return quantity(value, &scene.drivers[index])
            .map(|value| Place::Driver(index, value))
            .map_err(failed);
    }
    let mut names: Vec<_> = scene.drivers.iter().map(|driver| driver.name).collect();
    names.push("time");
    Err(
        Failure::request(format!("--at takes the driver or the time, not `{name}`"))
            .place(format!("--at {text}"))
            .remedy(format!(
                "{}\nfor example: --at {example}",
                suggestion(name, &names)
            )),
    )
}

/// The time as a quantity.
pub const TIME: Quantity = Quantity {
    name: "time",
    summary: "time",
    unit: "s",
    factor: 1.0,
    dimension: [(0, 1), (0, 1), (1, 1), (0, 1), (0, 1), (0, 1), (0, 1)],
};

fn split<'a>(text: &'a str, option: &str, example: &str) -> Result<(&'a str, &'a str), Failure> {
    let parts = text
        .split_once('=')
        .map(|(name, value)| (name.trim(), value.trim()));
    parts
        .filter(|(name, value)| !name.is_empty() && !value.is_empty())
        .ok_or_else(|| {
            Failure::request(format!("{option} takes NAME=VALUE"))
                .place(format!("{option} {text}"))
                .remedy(format!("for example: {option} {example}"))
        })
}

fn unknown_constant(
    mechanism: &'static Mechanism,
    scene: &'static SceneEntry,
    name: &str,
) -> Failure {
    let failure = Failure::request(format!(
        "scene `{}` of `{}` has no parameter `{name}`",
        scene.name, mechanism.name
    ))
    .place(format!("--set {name}=…"));
    if let Some(words) = with_feature(mechanism, name) {
        return failure.remedy(words);
    }
    if scene.drivers.iter().any(|driver| driver.name == name) {
        return failure.remedy(format!(
            "`{name}` is driven; --at {name}=… prints everything at a position of it"
        ));
    }
    let elsewhere: Vec<_> = mechanism
        .scenes
        .iter()
        .filter(|other| {
            other
                .constants
                .iter()
                .any(|constant| constant.quantity.name == name)
        })
        .map(|other| other.name)
        .collect();
    if !elsewhere.is_empty() {
        return failure.remedy(format!(
            "it belongs to --scene {}",
            elsewhere.join(", --scene ")
        ));
    }
    let names: Vec<_> = scene
        .constants
        .iter()
        .map(|constant| constant.quantity.name)
        .collect();
    failure.remedy(suggestion(name, &names))
}

/// Reads a number with a unit as a value of a quantity, SI units. A pure number is accepted for a pure number, which an
/// angle is.
fn quantity(text: &str, quantity: &Quantity) -> Result<f64, Failure> {
    let example = example(quantity);
    let parsed = crate::unit::parse(text).map_err(|reason| {
        Failure::request(format!("`{text}` is not a value of `{}`", quantity.name))
            .reason(reason)
            .remedy(format!("write it as {example}"))
    })?;
    if !parsed.value.is_finite() {
        return Err(Failure::request(format!(
            "`{}` must be a finite number, not `{text}`",
            quantity.name
        ))
        .remedy(format!("write it as {example}")));
    }
    if !same(parsed.dimension, quantity.dimension) {
        let what = if parsed.bare {
            format!("`{}` needs a unit", quantity.name)
        } else {
            format!("`{text}` has the wrong unit for `{}`", quantity.name)
        };
        let expected = if quantity.unit.is_empty() {
            "a pure number".to_owned()
        } else {
            format!("a unit like {}", quantity.unit)
        };
        return Err(Failure::request(what)
            .reason(format!("expected {expected}"))
            .remedy(format!("write it as {example}")));
    }
    Ok(parsed.value)
}

fn example(quantity: &Quantity) -> String {
    let simple = quantity.unit.chars().all(char::is_alphabetic);
    if quantity.unit.is_empty() {
        format!("{}=1.5", quantity.name)
    } else if simple {
        format!("{}=1.5{}", quantity.name, quantity.unit)
    } else {
        format!("'{}=1.5 [{}]'", quantity.name, quantity.unit)
    }
}

fn same(a: Dimension, b: Dimension) -> bool {
    a.iter()
        .zip(&b)
        .all(|(a, b)| i16::from(a.0) * i16::from(b.1) == i16::from(b.0) * i16::from(a.1))
}

/// Whether a constant may take a value: its declared range, and masses, lengths and speeds stay above zero where the
/// file has them above zero.
fn permitted(constant: &Constant, value: f64) -> Result<(), Failure> {
    let quantity = &constant.quantity;
    let show = |value: f64| {
        format!(
            "{} {}",
            number::short(value / quantity.factor),
            quantity.unit
        )
        .trim_end()
        .to_owned()
    };
    let (low, high) = constant.range;
    if value < low || value > high {
        let range = match (low.is_finite(), high.is_finite()) {
            (true, true) => format!("from {} to {}", show(low), show(high)),
            (true, false) => format!("{} or more", show(low)),
            _ => format!("{} or less", show(high)),
        };
        return Err(
            Failure::request(format!("`{}` cannot be {}", quantity.name, show(value)))
                .reason(format!("the file permits {range}"))
                .remedy(format!("give a value {range}")),
        );
    }
    if value <= 0.0 && constant.default > 0.0 {
        let kind = kind(quantity.dimension, constant.is_dimension);
        if let Some(kind) = kind {
            return Err(
                Failure::request(format!("`{}` cannot be {}", quantity.name, show(value)))
                    .reason(format!("{kind} is positive"))
                    .remedy(format!(
                        "give a value above zero; the default is {}",
                        show(constant.default)
                    )),
            );
        }
    }
    Ok(())
}

/// What a quantity is that cannot be zero or negative.
fn kind(dimension: Dimension, is_dimension: bool) -> Option<&'static str> {
    let exponents: Vec<_> = dimension
        .iter()
        .map(|(up, down)| f64::from(*up) / f64::from((*down).max(1)))
        .collect();
    match exponents[..3] {
        [0.0, 1.0, 0.0] => Some("a mass"),
        [2.0, 1.0, 0.0] => Some("a moment of inertia"),
        [1.0, 0.0, 0.0] if is_dimension => Some("a length"),
        [0.0, 0.0, -1.0] | [1.0, 0.0, -1.0] => Some("a speed"),
        _ => None,
    }
}

/// Reads the relative tolerance.
///
/// # Errors
/// When it is no number or out of range.
pub fn rtol(text: Option<&str>) -> Result<f64, Failure> {
    let Some(text) = text else {
        return Ok(DEFAULT_RTOL);
    };
    let range = format!("from {:e} to {:e}", RTOL.0, RTOL.1);
    let remedy = format!("give a number {range}; the default is {DEFAULT_RTOL:e}");
    let refuse = |reason: String| {
        Failure::request("the relative tolerance is out of range")
            .place(format!("--rtol {text}"))
            .reason(reason)
            .remedy(remedy.clone())
    };
    let value: f64 = text
        .trim()
        .parse()
        .map_err(|_| refuse(format!("`{text}` is not a number")))?;
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
        return Ok(METHODS[0].1);
    };
    if let Some((_, method)) = METHODS.iter().find(|(name, _)| *name == text) {
        return Ok(*method);
    }
    let names = METHODS.map(|(name, _)| name);
    let remedy = match nearest(text, &names) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("there are: {}", names.join(", ")),
    };
    Err(Failure::request(format!("there is no method `{text}`"))
        .place(format!("--method {text}"))
        .remedy(remedy))
}

/// Name of a method.
pub fn method_name(method: Method) -> &'static str {
    METHODS
        .iter()
        .find(|(_, known)| *known == method)
        .map_or("unknown", |(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_have_a_range() {
        assert_eq!(rtol(Some("1e-9")), Ok(1e-9));
        for wrong in ["0", "-1", "nan", "inf", "1e-20", "1", "ten"] {
            assert_eq!(
                rtol(Some(wrong)).map_err(|failure| failure.code()),
                Err(2),
                "{wrong}"
            );
        }
    }

    #[test]
    fn methods_are_found_and_offered() {
        assert_eq!(method(Some("tsit5")), Ok(Method::Tsit5));
        let failure = method(Some("tsit")).expect_err("no such method");
        assert!(
            failure
                .render(crate::style::Style::PLAIN)
                .contains("did you mean `tsit5`?")
        );
    }

    #[test]
    fn a_time_needs_a_unit_of_time() {
        assert_eq!(quantity("100 ms", &TIME), Ok(0.1));
        for wrong in ["3", "3 kg", "NaN s", "inf s", "s", "1e999 s"] {
            assert!(quantity(wrong, &TIME).is_err(), "{wrong}");
        }
    }
}
