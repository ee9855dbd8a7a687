//! What stands behind `--rtol` and `--method`.

use assur::registry::Method;

use crate::error::Failure;
use assur_model::nearest::nearest;

/// Tolerances between which the methods do what they say.
pub const RTOL: (f64, f64) = (1e-14, 1e-2);
/// The tolerance unless one is given.
pub const DEFAULT_RTOL: f64 = 1e-10;
/// The methods by name, the default one first.
const METHODS: [(&str, Method); 6] = [
    ("dop853", Method::Dop853),
    ("tsit5", Method::Tsit5),
    ("taylor", Method::Taylor),
    ("radau", Method::Radau),
    ("rosenbrock", Method::Rosenbrock),
    ("auto", Method::Auto),
];

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
    let remedy = match nearest(text, names) {
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
        assert_eq!(method(Some("auto")), Ok(Method::Auto));
        assert_eq!(method_name(Method::Rosenbrock), "rosenbrock");
        let failure = method(Some("tsit")).expect_err("no such method");
        assert!(
            failure
                .render(crate::style::Style::PLAIN)
                .contains("did you mean `tsit5`?")
        );
    }
}
