//! Scenes that move by their equations of motion.

use assur::model::Model;
use assur::problem::{Events, Phase};
use assur::shape::Shape;

/// Times and states at which scenes are compared.
const PLACES: usize = 4;

/// Instants of a step; more than there are lanes, and no multiple of these.
const INSTANTS: usize = 11;

/// Numbers that are the same, bit for bit; what is no number is none in either.
#[track_caller]
pub fn same(place: &str, what: &str, expected: &[f64], found: &[f64]) {
    assert_eq!(expected.len(), found.len(), "{place}: {what}");
    for (index, (expected, found)) in expected.iter().zip(found).enumerate() {
        let is_same = expected.to_bits() == found.to_bits()
            || expected.is_nan() && found.is_nan()
            || *expected == 0.0 && *found == 0.0;
        assert!(is_same, "{place}: {what} [{index}] is {found:e}, emitted {expected:e}");
    }
}

/// The start, and states beside it.
fn states(shape: &Shape, start: &[f64]) -> Vec<Vec<f64>> {
    let state = |index: usize| {
        let own = start.iter().zip(shape.scales).enumerate();
        let own = own.map(|(component, (value, scale))| {
            let share = ((index * start.len() + component) as f64 * 0.618_033_988 + 0.3).fract();
            value + [0.0, 1.0, 30.0, 300.0][index] * scale * (2.0 * share - 1.0)
        });
        own.collect()
    };
    (0..PLACES).map(state).collect()
}

pub fn compare(place: &str, emitted: &dyn Model, interpreted: &dyn Model) {
    let (shape, start) = (emitted.shape(), emitted.start());
    same(place, "start", &start, &interpreted.start());
    assert_eq!(emitted.span(), interpreted.span(), "{place}");
    let (from, to) = emitted.span().limits();
    let surfaces = shape.modes.iter().flat_map(|mode| mode.events);
    let surfaces = surfaces.filter(|event| event.surface.is_some()).count();
    for mode in 0..shape.modes.len().max(1) {
        let mut numbers = 0;
        for (index, state) in states(shape, &start).iter().enumerate() {
            let time = from + (to - from) * (index as f64 * 0.618 + 0.137).fract();
            for side in [0.0, 1.0, -1.0].iter().take(if surfaces > 0 { 3 } else { 1 }) {
                let sides = vec![*side; surfaces];
                let phase = Phase { mode, sides: &sides };
                let place = format!("{place}, mode {mode}, place {index}, side {side}");
                let here = Here { place, shape, phase, time, state };
                numbers += here.compare(emitted, interpreted);
            }
        }
        assert!(numbers > 0, "{place}, mode {mode}: nothing that was compared is a number");
    }
}

struct Here<'a> {
    place: String,
    shape: &'a Shape,
    phase: Phase<'a, f64>,
    time: f64,
    state: &'a [f64],
}

impl Here<'_> {
    /// What a function writes, emitted and interpreted.
    fn both(
        &self,
        what: &str,
        count: usize,
        models: [&dyn Model; 2],
        write: &dyn Fn(&dyn Model, &mut [f64]),
    ) -> Vec<f64> {
        let [expected, found] = models.map(|model| {
            let mut values = vec![0.0; count];
            write(model, &mut values);
            values
        });
        same(&self.place, what, &expected, &found);
        expected
    }

    /// Compares all functions; gives how many rates and outputs are numbers.
    fn compare(&self, emitted: &dyn Model, interpreted: &dyn Model) -> usize {
        let (phase, time, state) = (self.phase, self.time, self.state);
        let (models, n) = ([emitted, interpreted], state.len());
        let both = |what: &str, count, write: &dyn Fn(&dyn Model, &mut [f64])| {
            self.both(what, count, models, write)
        };
        let rows = models.map(|model| {
            let mut row = vec![0.0; model.equations().instant()];
            model.equations().instants(phase, &[time], &mut row);
            row
        });
        // Those of a step are computed together, in lanes.
        let times: Vec<f64> = (0..INSTANTS).map(|index| time + 1e-3 * index as f64).collect();
        both("rates at the instants of a step", INSTANTS * n, &|model, values| {
            let (equations, width) = (model.equations(), model.equations().instant());
            let mut rows = vec![0.0; INSTANTS * width];
            equations.instants(phase, &times, &mut rows);
            for (index, rates) in values.chunks_exact_mut(n.max(1)).enumerate() {
                equations.rates(phase, &rows[index * width..][..width], state, rates);
            }
        });
        let row = |model: &dyn Model| match std::ptr::addr_eq(model, emitted) {
            true => &rows[0],
            false => &rows[1],
        };
        let rates = both("rates", n, &|model, values| {
            model.equations().rates(phase, row(model), state, values);
        });
        both("jacobian", n * n, &|model, values| {
            model.equations().jacobian(phase, row(model), state, values);
        });
        let columns: Vec<f64> = (0..2 * n).map(|index| (index as f64 * 0.7).sin()).collect();
        both("variation", 3 * n, &|model, values| {
            let (rates, products) = values.split_at_mut(n);
            model.equations().variation(phase, row(model), state, rates, &columns, products);
        });
        let series = both("series", 21 * n + 1, &|model, values| {
            let (rows, has) = values.split_at_mut(21 * n);
            rows[..n].copy_from_slice(state);
            let done = model.equations().series(phase, time, 1e-3, rows);
            has[0] = f64::from(u8::from(done));
            if !done {
                rows.fill(0.0);
            }
        });
        assert_eq!(series.len(), 21 * n + 1);
        self.reports(&both);
        if let (Some(_), Some(_)) = (emitted.events(), interpreted.events()) {
            self.events(&both);
        } else {
            assert!(emitted.events().is_none() && interpreted.events().is_none());
        }
        let outputs = both("outputs", self.shape.outputs.len(), &|model, values| {
            model.reports().outputs(phase, time, state, values);
        });
        rates.iter().chain(&outputs).filter(|one| one.is_finite()).count()
    }

    fn reports(&self, both: &Both<'_>) {
        let (shape, phase, time, state) = (self.shape, self.phase, self.time, self.state);
        both("drivers", shape.drivers.len(), &|model, values| {
            model.reports().drivers(time, values);
        });
        both("margins", shape.carried.len(), &|model, values| {
            model.reports().margins(phase, time, state, values);
        });
        both("points", shape.places(), &|model, values| {
            model.reports().points(phase, time, state, values);
        });
        let n = shape.coordinates;
        both("mass", n * n + 1, &|model, values| {
            let (rows, has) = values.split_at_mut(n * n);
            has[0] = f64::from(u8::from(model.reports().mass(phase, time, state, rows)));
        });
        both("energy", 2, &|model, values| {
            let energy = model.reports().energy(phase, time, state);
            (values[0], values[1]) = energy.unwrap_or((f64::NAN, f64::NAN));
        });
        if let Some(held) = shape.held_in(phase.mode) {
            both("closures", held.loops.len() * (2 + n), &|model, values| {
                model.reports().closures(phase, time, state, values);
            });
        }
        both("measured", shape.measured, &|model, values| {
            model.reports().measured(phase, time, state, values);
        });
        let found: Vec<f64> = (0..shape.primitives.len()).map(|k| 1.5 + k as f64 * 0.3).collect();
        both("measures", shape.measures.len(), &|model, values| {
            model.reports().measures(&found, values);
        });
    }

    fn events(&self, both: &Both<'_>) {
        let (phase, time, state, n) = (self.phase, self.time, self.state, self.state.len());
        let mode = &self.shape.modes[phase.mode];
        let count = mode.written();
        let events = |model: &dyn Model, work: &mut dyn FnMut(&dyn Events<f64>)| {
            if let Some(events) = model.events() {
                work(events);
            }
        };
        both("guards", 2 * count, &|model, values| {
            let (values, rates) = values.split_at_mut(count);
            events(model, &mut |events| events.guards(phase, time, state, values, rates));
        });
        for (event, entry) in mode.events.iter().enumerate() {
            if entry.conditional {
                both("condition", 1, &|model, values| {
                    events(model, &mut |events| {
                        let permits = events.permits(phase, event, time, state);
                        values[0] = f64::from(u8::from(permits));
                    });
                });
            }
            both("jump", n, &|model, values| {
                events(model, &mut |events| events.jump(phase, event, time, state, values));
            });
            both("slopes of a guard", n, &|model, values| {
                events(model, &mut |events| {
                    events.guard_slopes(phase, event, time, state, values);
                });
            });
            both("slopes of a jump", n * n + n + 1, &|model, values| {
                let (columns, rest) = values.split_at_mut(n * n);
                let (rates, sets) = rest.split_at_mut(n);
                events(model, &mut |events| {
                    let done = events.jump_slopes(phase, event, time, state, columns, rates);
                    sets[0] = f64::from(u8::from(done));
                });
            });
        }
    }
}

/// Compares what a function writes.
type Both<'a> = dyn Fn(&str, usize, &dyn Fn(&dyn Model, &mut [f64])) -> Vec<f64> + 'a;
