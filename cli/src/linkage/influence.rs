//! Influence coefficients: what each dimension and each driver does to each output.

use assur::closure::Variable;
use assur::shape::Quantity;

use super::case::Case;
use crate::ask::variables::Variable as Result;

/// Influence coefficients at one place.
#[derive(Clone, Debug)]
pub struct Influence {
    /// What they are taken by.
    pub variable: Quantity,
    /// Its place among the variables of the linkage.
    pub index: usize,
    /// For each output the coefficient, SI units.
    pub values: Vec<f64>,
    /// How far each may be off by rounding; empty where that is not known.
    pub errors: Vec<f64>,
}

/// The table of influence coefficients at a place; of drivers first.
pub fn at(case: &Case, place: &[f64]) -> Vec<Influence> {
    let Ok(values) = case.run().influence(place) else {
        return Vec::new();
    };
    let variables = case.moved.entry.variables;
    let of = |wanted: bool| {
        let values = &values;
        let list = variables.iter().enumerate();
        list.filter(move |(_, variable)| matches!(variable, Variable::Driver(_)) == wanted)
            .filter_map(move |(index, variable)| {
                Some(Influence {
                    variable: quantity(case, *variable)?,
                    index,
                    errors: Vec::new(),
                    values: values.iter().skip(index).step_by(variables.len()).copied().collect(),
                })
            })
    };
    of(true).chain(of(false)).collect()
}

/// What an influence coefficient is taken by.
pub fn quantity(case: &Case, variable: Variable) -> Option<Quantity> {
    match variable {
        Variable::Constant(index) => Some(case.scene.constants.get(index)?.quantity),
        Variable::Driver(index) => case.drivers.get(index).copied(),
    }
}

/// The unit of an influence coefficient with its SI value; angles are taken in radians.
pub fn unit(output: (&str, f64), by: (&str, f64)) -> (String, f64) {
    let plain = |(unit, factor): (&str, f64)| match unit {
        "deg" | "rad" => (String::new(), 1.0),
        _ => (unit.to_owned(), factor),
    };
    let above = match output.0 {
        "deg" | "rad" if !matches!(by.0, "deg" | "rad") => ("rad".to_owned(), 1.0),
        _ => plain(output),
    };
    let below = match by.0 {
        "deg" | "rad" if !matches!(output.0, "deg" | "rad") => ("rad".to_owned(), 1.0),
        _ => plain(by),
    };
    let wrapped = match below.0.contains([' ', '/', '*']) {
        true => format!("({})", below.0),
        false => below.0,
    };
    let text = match (above.0.as_str(), wrapped.as_str()) {
        ("", "") => String::new(),
        (above, "") => above.to_owned(),
        ("", below) => format!("1/{below}"),
        (above, below) => format!("{above}/{below}"),
    };
    (text, above.1 / below.1)
}

/// The unit of the influence on a variable.
pub fn unit_of(output: &Result, by: &Quantity) -> (String, f64) {
    unit((&output.unit, output.factor), (by.unit, by.factor))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_are_taken_in_radians() {
        let degree = ("deg", 1f64.to_radians());
        assert_eq!(unit(degree, ("mm", 1e-3)), ("rad/mm".to_owned(), 1e3));
        assert_eq!(unit(degree, degree), (String::new(), 1.0));
        assert_eq!(unit(("mm", 1e-3), degree), ("mm/rad".to_owned(), 1e-3));
        assert_eq!(unit(("mm", 1e-3), ("N/m", 1.0)).0, "mm/(N/m)");
    }
}
