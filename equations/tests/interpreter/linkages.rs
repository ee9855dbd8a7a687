//! Linkages.

use assur::closure::{Answers, AnyLinkage, Loops, Trials};
use assur::scalar::{Dual, Interval, Scalar};

use crate::motions::same;

/// Positions at which linkages are compared.
const PLACES: usize = 5;

pub fn compare(place: &str, emitted: &dyn AnyLinkage, interpreted: &dyn AnyLinkage) {
    same(place, "values", &emitted.values(), &interpreted.values());
    same(place, "start", &emitted.start(), &interpreted.start());
    assert_eq!(emitted.span(), interpreted.span(), "{place}");
    let [expected, found] =
        [emitted, interpreted].map(|one| format!("{:?} {:?}", one.ranges(), one.drive(0.013)));
    assert_eq!(expected, found, "{place}");
    let mut assembly = emitted.assemble();
    assert!(assembly.guide().start().is_ok(), "{place} does not assemble");
    let mut compared = 0;
    let ranges = emitted.ranges();
    for index in 0..PLACES {
        let share = (index as f64 + 0.37) / PLACES as f64;
        let mut at: Vec<f64> = ranges
            .iter()
            .map(|range| match range.from.is_finite() && range.to.is_finite() {
                true => range.from + share * (range.to - range.from),
                false => range.start,
            })
            .collect();
        let driven = emitted.drive(share * 0.01);
        let motion = match driven {
            Some(all) => {
                let (place, motion) = all.split_at(at.len());
                at.copy_from_slice(place);
                motion.to_vec()
            }
            None => Vec::new(),
        };
        if assembly.travel(&at).is_err() {
            continue;
        }
        let position = assembly.guide().position.to_vec();
        let here = Here { place: format!("{place}, place {index}"), at, motion, position };
        compared += 1;
        let values = emitted.values();
        here.compare(&*emitted.prepare(&values), &*interpreted.prepare(&values));
        let duals: Vec<Dual> = values.iter().map(|value| Dual::variable(*value)).collect();
        here.answers(&*emitted.differentiate(&duals), &*interpreted.differentiate(&duals));
        let wide: Vec<Interval> = values.iter().map(|value| Interval::from_f64(*value)).collect();
        here.trials(&*emitted.enclose(&wide), &*interpreted.enclose(&wide));
    }
    assert!(compared > 0, "{place}: no position is reached");
}

/// What writes values, from loops and an instant.
type Write<'a> = dyn Fn(&dyn Loops<f64>, &[f64], &mut [f64]) + 'a;

struct Here {
    place: String,
    at: Vec<f64>,
    motion: Vec<f64>,
    position: Vec<f64>,
}

/// All that there is to see of a number.
fn plain<S: Scalar>(values: &[S]) -> String {
    format!("{values:?}").replace("-0.0", "0.0")
}

impl Here {
    fn numbers<S: Scalar>(list: &[f64]) -> Vec<S> {
        list.iter().map(|one| S::from_f64(*one)).collect()
    }

    fn instant<S: Scalar>(&self, loops: &(impl Trials<S> + ?Sized)) -> Vec<S> {
        let mut instant = vec![S::ZERO; loops.lengths().1];
        loops.instant(&Self::numbers(&self.at), &Self::numbers(&self.motion), &mut instant);
        instant
    }

    fn trials<S: Scalar>(
        &self,
        emitted: &(impl Trials<S> + ?Sized),
        interpreted: &(impl Trials<S> + ?Sized),
    ) {
        let instants = [self.instant(emitted), self.instant(interpreted)];
        for (group, own) in emitted.shape().loops().groups.iter().enumerate() {
            let n = own.unknowns.len();
            let all = [
                self.tried(emitted, (group, n), &instants[0]),
                self.tried(interpreted, (group, n), &instants[1]),
            ];
            assert_eq!(all[0], all[1], "{}: trial of group {group}", self.place);
        }
    }

    /// What a trial writes.
    fn tried<S: Scalar>(
        &self,
        loops: &(impl Trials<S> + ?Sized),
        (group, n): (usize, usize),
        instant: &[S],
    ) -> [String; 3] {
        let largest = loops.shape().loops().largest();
        let mut position: Vec<S> = Self::numbers(&self.position);
        let (mut row, mut square) = (vec![S::ZERO; largest], vec![S::ZERO; largest * largest]);
        loops.trial(group, instant, &mut position, &mut row, &mut square);
        [plain(&position), plain(&row[..n]), plain(&square[..n * n])]
    }

    fn answers<S: Scalar>(
        &self,
        emitted: &(impl Answers<S> + ?Sized),
        interpreted: &(impl Answers<S> + ?Sized),
    ) {
        self.trials(emitted, interpreted);
        let shape = emitted.shape();
        let instants = [self.instant(emitted), self.instant(interpreted)];
        let position: Vec<S> = Self::numbers(&self.position);
        let mut values = [vec![S::ZERO; shape.outputs.len()], vec![S::ZERO; shape.outputs.len()]];
        emitted.outputs(&instants[0], &position, &mut values[0]);
        interpreted.outputs(&instants[1], &position, &mut values[1]);
        assert_eq!(plain(&values[0]), plain(&values[1]), "{}: outputs", self.place);
        let count = shape.outputs.len() * shape.loops().variables.len();
        let mut values = [vec![S::ZERO; count], vec![S::ZERO; count]];
        emitted.influence(&instants[0], &position, &mut values[0]);
        interpreted.influence(&instants[1], &position, &mut values[1]);
        assert_eq!(plain(&values[0]), plain(&values[1]), "{}: influence", self.place);
    }

    fn compare(&self, emitted: &dyn Loops<f64>, interpreted: &dyn Loops<f64>) {
        self.answers(emitted, interpreted);
        let entry = emitted.shape().loops();
        let instants = [self.instant(emitted), self.instant(interpreted)];
        for (group, own) in entry.groups.iter().enumerate() {
            for mode in [1.0, -1.0] {
                let mut positions = [self.position.clone(), self.position.clone()];
                let sines = [
                    emitted.close(group, &instants[0], mode, &mut positions[0]),
                    interpreted.close(group, &instants[1], mode, &mut positions[1]),
                ];
                same(&self.place, "sine", &[sines[0]], &[sines[1]]);
                same(&self.place, "closed position", &positions[0], &positions[1]);
            }
            if own.kind.has_modes() {
                let margins = [
                    emitted.margin(group, &instants[0], &self.position),
                    interpreted.margin(group, &instants[1], &self.position),
                ];
                same(&self.place, "margin", &[margins[0]], &[margins[1]]);
            }
        }
        let shape = emitted.shape();
        let (outputs, variables) = (shape.outputs.len(), entry.variables.len());
        let second = match entry.second {
            true => outputs * variables * (variables + 1) / 2,
            false => 0,
        };
        let compare = |what: &str, count: usize, write: &Write<'_>| {
            let mut values = [vec![0.0; count], vec![0.0; count]];
            write(emitted, &instants[0], &mut values[0]);
            write(interpreted, &instants[1], &mut values[1]);
            same(&self.place, what, &values[0], &values[1]);
        };
        let position = &self.position;
        compare("residuals", entry.loops.len(), &|loops, instant, values| {
            loops.residual(instant, position, values);
        });
        compare(
            "coefficients",
            entry.dependents.len() * shape.drivers.len(),
            &|loops, instant, values| loops.coefficients(instant, position, values),
        );
        compare("second influences", second, &|loops, instant, values| {
            loops.second_influence(instant, position, values);
        });
        compare("measured", shape.measured, &|loops, instant, values| {
            loops.measured(instant, position, values);
        });
        let found: Vec<f64> = (0..shape.primitives.len()).map(|k| 0.3 + 0.7 * k as f64).collect();
        compare("measures", shape.measures.len(), &|loops, _, values| {
            loops.measures(&found, values)
        });
        compare("points", shape.places(), &|loops, instant, values| {
            loops.points(instant, position, values);
        });
    }
}
