//! Elastic links: how far a load moves an output.
//!
//! With a generalised force `M` on an output and the drivers held, a link that carries two forces has the axial force
//! `N = M K`, `K` being the influence of its length on the output (virtual work), and lengthens by `N l / (E A)`. The
//! output moves by the sum of all `K N l / (E A)`.

/// A link that carries two forces, SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bar {
    /// Influence of its length on the output.
    pub influence: f64,
    /// Length.
    pub length: f64,
    /// Modulus of elasticity times area of the section.
    pub stiffness: f64,
}

/// A link under load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loaded {
    /// Axial force, tension positive.
    pub force: f64,
    /// Elongation.
    pub elongation: f64,
    /// Its part in the change of the output.
    pub change: f64,
}

/// The links under a generalised force on the output, and the change of the output.
pub fn elastic(force: f64, bars: &[Bar]) -> (Vec<Loaded>, f64) {
    let load = |bar: &Bar| {
        let axial = force * bar.influence;
        let elongation = axial * bar.length / bar.stiffness;
        Loaded { force: axial, elongation, change: bar.influence * elongation }
    };
    let loaded: Vec<Loaded> = bars.iter().map(load).collect();
    let change = loaded.iter().map(|one| one.change).sum();
    (loaded, change)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_heald_linkage_twists_by_its_specified_sum() {
        // Links 4 to 7 at 90 deg, E = 210 GPa, A = 150 mm², M = 20 N m.
        let bar = |influence, length| Bar { influence, length, stiffness: 210e9 * 150e-6 };
        let bars = [
            bar(0.750_889, 0.09),
            bar(4.547_53, 0.23),
            bar(-0.840_627, 0.18),
            bar(-2.224_20, 0.12),
        ];
        let (loaded, change) = elastic(20.0, &bars);
        assert!((loaded[1].force - 90.9506).abs() < 1e-10);
        let energy: f64 = loaded.iter().map(|one| 0.5 * one.force * one.elongation).sum();
        assert!((0.5 * 20.0 * change - energy).abs() < 1e-15 * energy.abs() * 10.0);
        assert!(change > 0.0);
    }
}
