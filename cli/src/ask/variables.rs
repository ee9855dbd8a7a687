//! Everything about a motion that has a value at an instant: coordinates, speeds, accelerations, outputs.

use crate::show::unit;
use assur::registry::SceneEntry;
use assur::shape::{Energy, LinkageEntry, Quantity, Subject};

/// Exponents of m, kg, s, A, K, mol, cd as numerator and denominator.
pub type Dimension = [(i8, i8); 7];

/// A quantity that has a value at every instant of a motion.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Name as the equation file writes it.
    pub name: String,
    /// What it is.
    pub summary: String,
    /// Unit in which it is printed.
    pub unit: String,
    /// SI value of one such unit.
    pub factor: f64,
    /// Its dimension.
    pub dimension: Dimension,
    /// Where its value comes from.
    pub origin: Subject,
}

impl Variable {
    fn new(quantity: &Quantity, origin: Subject) -> Self {
        Self {
            name: quantity.name.to_owned(),
            summary: quantity.summary.lines().next().unwrap_or("").to_owned(),
            unit: quantity.unit.to_owned(),
            factor: quantity.factor,
            dimension: quantity.dimension,
            origin,
        }
    }

    /// The acceleration that belongs to a speed `dot(x)` of the state.
    fn acceleration(speed: &Quantity, index: usize) -> Option<Self> {
        let coordinate = speed.name.strip_prefix("dot(")?.strip_suffix(')')?;
        let mut dimension = speed.dimension;
        let (up, down) = dimension[2];
        dimension[2] = (up.checked_sub(down)?, down);
        Some(Self {
            name: format!("ddot({coordinate})"),
            summary: String::new(),
            unit: per_second(speed.unit),
            factor: speed.factor,
            dimension,
            origin: Subject::Rate(index),
        })
    }

    /// A value in SI units in the unit of the variable.
    pub fn in_unit(&self, value: f64) -> f64 {
        unit::stated(value, self.factor)
    }
}

/// The unit of the time derivative: `m/s` becomes `m/s^2`.
fn per_second(unit: &str) -> String {
    if let Some(front) = unit.strip_suffix("/s") {
        return format!("{front}/s^2");
    }
    match unit {
        "" => "1/s".to_owned(),
        "rpm" => "rpm/s".to_owned(),
        _ => format!("{unit}/s"),
    }
}

/// The energies of a motion that states energies, which are asked for by name.
pub fn energies() -> [Variable; 3] {
    let joule = [(2, 1), (1, 1), (-2, 1), (0, 1), (0, 1), (0, 1), (0, 1)];
    let energy = |name: &str, summary: &str, which: Energy| Variable {
        name: name.to_owned(),
        summary: summary.to_owned(),
        unit: "J".to_owned(),
        factor: 1.0,
        dimension: joule,
        origin: Subject::Energy(which),
    };
    [
        energy("energy(kinetic)", "of the masses that move", Energy::Kinetic),
        energy("energy(potential)", "of springs and weights", Energy::Potential),
        energy("energy", "both together: constant but for what is gained and lost", Energy::Both),
    ]
}

/// All variables of a scene: coordinates and speeds, accelerations, outputs. An output that repeats the name of another
/// variable is left out.
pub fn of_scene(scene: &SceneEntry) -> Vec<Variable> {
    let states = scene.states.iter().enumerate();
    let mut list: Vec<_> =
        states.clone().map(|(index, state)| Variable::new(state, Subject::State(index))).collect();
    list.extend(states.filter_map(|(index, state)| Variable::acceleration(state, index)));
    for (index, output) in scene.outputs.iter().enumerate() {
        match list.iter_mut().find(|variable| variable.name == output.name) {
            // Declared by hand: its unit and words are preferred, its value is the same.
            Some(same) => {
                *same = Variable { origin: same.origin, ..Variable::new(output, same.origin) }
            }
            None => list.push(Variable::new(output, Subject::Output(index))),
        }
    }
    list
}

/// All variables of a linkage: outputs, then the dependent coordinates that are none.
pub fn of_linkage(scene: &SceneEntry, entry: &LinkageEntry) -> Vec<Variable> {
    let outputs = scene.outputs.iter().enumerate();
    let mut list: Vec<_> =
        outputs.map(|(index, output)| Variable::new(output, Subject::Output(index))).collect();
    for (index, dependent) in entry.dependents.iter().enumerate() {
        if list.iter().all(|known| known.name != dependent.name) {
            list.push(Variable::new(dependent, Subject::State(index)));
        }
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_derivatives() {
        assert_eq!(per_second("m/s"), "m/s^2");
        assert_eq!(per_second("rad/s"), "rad/s^2");
        assert_eq!(per_second("mm"), "mm/s");
        assert_eq!(per_second(""), "1/s");
    }

    #[test]
    fn a_speed_has_an_acceleration() {
        let mut dimension = [(0, 1); 7];
        dimension[0] = (1, 1);
        dimension[2] = (-1, 1);
        let speed = Quantity { name: "dot(x3)", summary: "", unit: "m/s", factor: 1.0, dimension };
        let variable = Variable::acceleration(&speed, 4).expect("a speed");
        assert_eq!((variable.name.as_str(), variable.unit.as_str()), ("ddot(x3)", "m/s^2"));
        assert_eq!(variable.dimension[2], (-2, 1));
        assert!(Variable::acceleration(&Quantity { name: "i", ..speed }, 0).is_none());
    }
}
