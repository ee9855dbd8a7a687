//! The functions of linkages and of sheets. A position is assembled on doubles; what is taken there holds of any position.

use std::sync::Arc;

use assur::closure::{
    Answers as _, AnyLinkage, Apart, Closure, Linkage, Loops as _, Square, Trials as _,
};
use assur::registry::SceneEntry;
use assur::scalar::Scalar;
use assur::shape::{GroupKind, Shape, Variable};
use assur_interpreter::scene::{Loops, Moved};
use assur_model::checked::SceneModel;

use super::{Error, Functions, disturbed, judged, share, turns};
use crate::octuple::Octuple;

/// Places at which each function is taken.
const PLACES: usize = 3;

/// A place of a linkage.
struct Here<S> {
    /// The independent variables, and how they move.
    at: Vec<S>,
    motion: Vec<S>,
    /// The dependent coordinates, and room for what is kept beside them.
    position: Vec<S>,
}

impl<S: Scalar> Here<S> {
    /// The functions of a linkage with their values.
    fn functions<C: Closure<S>>(&self, loops: Apart<C>) -> Functions<S> {
        let shape = loops.shape();
        let entry = shape.loops();
        let instant = loops.instant_row(&self.at, &self.motion);
        let mut found: Functions<S> = Vec::new();
        // Slopes of the loops, and what is kept beside the coordinates.
        let mut position = self.position.clone();
        let mut square = Square::of(shape);
        for (group, own) in entry.groups.iter().enumerate() {
            square.look(&loops, group, &instant, &mut position);
            found.push(("slope", square.jacobian[..own.unknowns.len().pow(2)].to_vec()));
        }
        for (group, own) in entry.groups.iter().enumerate() {
            if own.kind.has_modes() {
                found.push(("margin", vec![loops.margin(group, &instant, &position)]));
            }
            for mode in [S::ONE, -S::ONE] {
                if own.kind != GroupKind::General {
                    let mut closed = position.clone();
                    found.push(("sine", vec![loops.close(group, &instant, mode, &mut closed)]));
                    found.push(("unknown", own.unknowns.iter().map(|one| closed[*one]).collect()));
                }
            }
        }
        let (outputs, variables) = (shape.outputs.len(), entry.variables.len());
        let second = if entry.second { outputs * variables * (variables + 1) / 2 } else { 0 };
        let mut take = |name, count, write: &dyn Fn(&mut [S])| {
            let mut values = vec![S::ZERO; count];
            write(&mut values);
            found.push((name, values));
        };
        let drivers = shape.drivers.len();
        take("coefficient", entry.dependents.len() * drivers, &|values| {
            loops.coefficients(&instant, &position, values);
        });
        take("output", outputs, &|values| loops.outputs(&instant, &position, values));
        take("influence", outputs * variables, &|values| {
            loops.influence(&instant, &position, values);
        });
        take("second influence", second, &|values| {
            loops.second_influence(&instant, &position, values);
        });
        take("point", shape.places(), &|values| loops.points(&instant, &position, values));
        found
    }
}

/// A number from the ranges of the drivers, and the positions that the linkage has there, if it comes there.
fn place(linkage: &dyn AnyLinkage, place: usize) -> Option<Here<f64>> {
    let ranges = linkage.ranges();
    let mut at: Vec<f64> = ranges
        .iter()
        .enumerate()
        .map(|(index, range)| match range.from.is_finite() && range.to.is_finite() {
            true => range.from + share(place, index) * (range.to - range.from),
            false => range.start,
        })
        .collect();
    let (from, to) = linkage.span().limits();
    let driven = linkage.drive(from + share(place, 55) * (to - from));
    let motion = driven.map_or(Vec::new(), |all| {
        let (place, motion) = all.split_at(at.len());
        at.copy_from_slice(place);
        motion.to_vec()
    });
    let mut assembly = linkage.assemble();
    assembly.guide().start().ok()?;
    assembly.travel(&at).ok()?;
    let position = assembly.guide().position.to_vec();
    Some(Here { at, motion, position })
}

/// A number by its function, with what it is the derivative of, and by which variables.
fn named(shape: &Shape, what: &str, index: usize) -> String {
    let variables = shape.loops().variables;
    let by = |index: usize| match variables[index] {
        Variable::Constant(index) => shape.constants[index].quantity.name,
        Variable::Driver(index) => shape.drivers[index].name,
    };
    let output = |index: usize| shape.outputs[index].name;
    let count = variables.len();
    match what {
        "output" => format!("output {}", output(index)),
        "influence" => format!("influence of {} on {}", by(index % count), output(index / count)),
        "second influence" => {
            let pairs = count * (count + 1) / 2;
            let mut place = (0, index % pairs);
            while place.1 > place.0 {
                place = (place.0 + 1, place.1 - place.0 - 1);
            }
            let (a, b) = (by(place.0), by(place.1));
            format!("second influence of {a} and {b} on {}", output(index / pairs))
        }
        _ => format!("{what} {index}"),
    }
}

/// The errors of all functions of a scene.
pub fn of_scene(mechanism: &'static str, entry: &SceneEntry, scene: &SceneModel) -> Vec<Error> {
    let Some(info) = &scene.linkage else {
        return Vec::new();
    };
    let loops = Arc::new(Loops::new(scene, info, entry.shape));
    let turns: Vec<Vec<f64>> = turns(entry).collect();
    let moved = Moved::new(&loops, &turns[0]);
    let linkage = entry.bind.linkage(&turns[0]).expect("declared values");
    let dependents = entry.shape.loops().dependents.len();
    let places = (0..PLACES).filter_map(|index| place(&*linkage, index));
    let errors = places.flat_map(|here| {
        let exact = turns.iter().enumerate().map(|(turn, values)| {
            let all = |list: &[f64], first: usize| -> Vec<Octuple> {
                let list = list.iter().enumerate();
                list.map(|(index, one)| Octuple::from_f64(disturbed(*one, turn, first + index)))
                    .collect()
            };
            let values: Vec<_> = values.iter().map(|value| Octuple::from_f64(*value)).collect();
            let mut position = all(&here.position, 100);
            // What is kept beside the coordinates follows from them.
            position[dependents..].fill(Octuple::ZERO);
            Here { at: all(&here.at, 0), motion: all(&here.motion, 50), position }
                .functions(Apart(Linkage::prepare(&moved, &values)))
        });
        let found = here.functions(Apart(Linkage::prepare::<f64>(&moved, &turns[0])));
        let named = |what: &str, index: usize| named(entry.shape, what, index);
        judged((mechanism, entry.name), &named, found, exact.collect())
    });
    errors.collect()
}
