//! The same linkage stated in other units: outputs and influence coefficients at closed positions.

use super::{Dimension, SYSTEMS, TIME, Units};
use crate::check::Failed;
use crate::check::linkage::{PLACES, place};
use crate::registry::{Mechanism, SceneEntry};
use assur_solvers::closure::{Answers, AnyLinkage, Apart, Linkage, Variable};
use assur_solvers::scalar::{Bounded, Scalar};
use assur_solvers::shape::Quantity;

/// Checks at several positions that a linkage has the same outputs and influence coefficients when its dimensions,
/// drivers and dependent coordinates are stated in other units.
///
/// # Errors
/// The first value that deviates, with both values and their unit; or that there was none to compare.
pub fn closure_scaling<L: Linkage>(
    mechanism: &Mechanism,
    scene: &str,
    linkage: &L,
) -> Result<(), Failed> {
    let prepare = |values: &[Bounded]| -> Box<dyn Answers<Bounded>> {
        Box::new(Apart(Linkage::prepare(linkage, values)))
    };
    restated(mechanism, scene, linkage, &prepare)
}

/// Loops with the bounds of their errors, from constants.
type Prepare<'a> = &'a dyn Fn(&[Bounded]) -> Box<dyn Answers<Bounded>>;

fn restated(
    mechanism: &Mechanism,
    scene: &str,
    linkage: &dyn AnyLinkage,
    prepare: Prepare<'_>,
) -> Result<(), Failed> {
    let entry = mechanism.scenes.iter().find(|entry| entry.name == scene);
    let entry = entry.ok_or_else(|| Failed("there is no such scene".into()))?;
    let quantities = Quantities::of(entry)?;
    let fail = |error: assur_solvers::closure::ClosureError| Failed(error.to_string());
    let mut assembly = linkage.assemble();
    assembly.guide().start().map_err(fail)?;
    let mut compared = 0;
    for index in 0..PLACES {
        let place = place(linkage, index)?;
        assembly.move_to(&place[..entry.drivers.len()]).map_err(fail)?;
        let here =
            Here { values: linkage.values(), place, position: assembly.guide().position.to_vec() };
        let expected = here.evaluate(prepare);
        for units in &SYSTEMS {
            let there = here.restated(&quantities, units);
            let found = there.evaluate(prepare);
            let pairs = expected.iter().zip(found);
            for (component, (expected, found)) in quantities.results.iter().zip(pairs) {
                if expected.bound.is_finite() {
                    let at = (f64::NAN, there.place.clone());
                    units.compare(component, *expected, found, &at)?;
                    compared += 1;
                }
            }
        }
    }
    match compared {
        0 => Err(Failed("there is no value to compare".into())),
        _ => Ok(()),
    }
}

/// The dimensions of what goes in and comes out.
struct Quantities {
    constants: Vec<Dimension>,
    /// Of the drivers, and behind them of their speeds, their accelerations and the time.
    place: Vec<Dimension>,
    dependents: Vec<Dimension>,
    results: Vec<(String, Dimension)>,
}

impl Quantities {
    fn of(entry: &SceneEntry) -> Result<Self, Failed> {
        let linkage = entry.linkage.as_ref();
        let linkage = linkage.ok_or_else(|| Failed("the scene is no linkage".into()))?;
        let dimensions = |list: &[Quantity]| -> Vec<Dimension> {
            list.iter().map(|one| one.dimension).collect()
        };
        let constants: Vec<Dimension> =
            entry.constants.iter().map(|constant| constant.quantity.dimension).collect();
        let drivers = dimensions(entry.drivers);
        let mut place = drivers.clone();
        if linkage.motion > 0 {
            for order in 1..=2 {
                place.extend(drivers.iter().map(|one| over(*one, TIME, order)));
            }
            place.push(TIME);
        }
        let mut results: Vec<(String, Dimension)> = entry
            .outputs
            .iter()
            .map(|output| (format!("output {}", output.name), output.dimension))
            .collect();
        for output in entry.outputs {
            for variable in linkage.variables {
                let (name, dimension) = match *variable {
                    Variable::Constant(index) => {
                        (entry.constants[index].quantity.name, constants[index])
                    }
                    Variable::Driver(index) => (entry.drivers[index].name, drivers[index]),
                };
                let name = format!("influence of {name} on {}", output.name);
                results.push((name, over(output.dimension, dimension, 1)));
            }
        }
        Ok(Self { constants, place, dependents: dimensions(linkage.dependents), results })
    }
}

/// The dimension of a quantity per a power of another.
fn over(above: Dimension, below: Dimension, power: i8) -> Dimension {
    std::array::from_fn(|k| {
        let ((a, b), (c, d)) = (above[k], below[k]);
        (a * d - power * c * b, b * d)
    })
}

/// A closed position.
struct Here {
    values: Vec<f64>,
    place: Vec<f64>,
    /// The dependent coordinates, and behind them what is kept of their angles.
    position: Vec<f64>,
}

impl Here {
    fn restated(&self, quantities: &Quantities, units: &Units) -> Self {
        let restate = |list: &[f64], dimensions: &[Dimension]| -> Vec<f64> {
            let known = list.iter().zip(dimensions);
            let known = known.map(|(value, dimension)| value * units.factor(dimension));
            let rest = list.iter().skip(dimensions.len()).copied();
            known.chain(rest).collect()
        };
        Self {
            values: restate(&self.values, &quantities.constants),
            place: restate(&self.place, &quantities.place),
            position: restate(&self.position, &quantities.dependents),
        }
    }

    /// Outputs and influence coefficients with the bounds of their errors.
    fn evaluate(&self, prepare: Prepare<'_>) -> Vec<Bounded> {
        let bounded = |list: &[f64]| -> Vec<Bounded> {
            list.iter().map(|one| Bounded::from_f64(*one)).collect()
        };
        let loops = prepare(&bounded(&self.values));
        let (shape, place) = (loops.shape(), bounded(&self.place));
        let (drivers, motion) = place.split_at(shape.drivers.len());
        let instant = loops.instant_row(drivers, motion);
        let position = bounded(&self.position);
        let mut outputs = vec![Bounded::ZERO; shape.outputs.len()];
        loops.outputs(&instant, &position, &mut outputs);
        let mut influence = vec![Bounded::ZERO; outputs.len() * shape.loops().variables.len()];
        loops.influence(&instant, &position, &mut influence);
        outputs.extend(influence);
        outputs
    }
}
