//! Just above the speed at which contact is lost first, where the force touches zero in a smooth minimum.

use super::*;

/// A flight grows with the square root of what the speed is above the border, and what it changes of the state where the
/// next turn begins with the power 3/2: the transition is continuous, and so are its first derivatives. A fabric without
/// damping does the same; a term with a square root, as an impact has it, there is none.
#[test]
fn lost_contact_grows_from_nothing() {
    for case in REFERENCE["grazing"].as_array().unwrap() {
        let mut found = Vec::new();
        for row in case["rows"].as_array().unwrap() {
            let glued = numbers(&row["glued"]);
            let foot =
                Elliptic::with(&[("mu2", number(&case["mu2"])), ("omega", number(&row["omega"]))]);
            let cycle = hybrid::cycle_from(&foot, (CONTACT, &glued), foot.period(), &FINE).unwrap();
            assert_eq!((cycle.multiple, changes(&cycle.motion).len()), (1, 2));
            let start = cycle.motion.pieces[0].trajectory.at(0.0);
            for (value, (expected, size)) in
                start.iter().zip(numbers(&row["start"]).iter().zip([1e-3, 1e-1]))
            {
                assert!((value - expected).abs() < 1e-10 * size, "{value:e} {expected:e}");
            }
            let flight = Measured::of(&foot, &cycle.motion).free * foot.period();
            let expected = number(&row["flight"]);
            assert!((flight / expected - 1.0).abs() < 1e-5, "{flight:e} s, {expected:e} s");
            let away = ((start[0] - glued[0]) * foot.omega).hypot(start[1] - glued[1]);
            found.push((number(&row["above"]), flight, away));
        }
        for pair in found.windows(2) {
            let power = |a: f64, b: f64| (a / b).ln() / (pair[0].0 / pair[1].0).ln();
            let (flight, away) = (power(pair[0].1, pair[1].1), power(pair[0].2, pair[1].2));
            assert!((flight - 0.5).abs() < 0.02, "{flight}");
            assert!((away - 1.5).abs() < 0.03, "{away}");
        }
    }
}

/// The way down to a tenth of a microradian: two roots in one step, of a guard that touches zero. The flight is half as
/// long with every quarter of what the speed is above the border.
#[test]
fn two_roots_in_one_step() {
    let case = &REFERENCE["grazing"][0];
    let border = number(&case["border"]);
    let flight = |above: f64| {
        let foot = Elliptic::with(&[("omega", border + above)]);
        let cycle = foot.cycle().unwrap();
        let events = changes(&cycle.motion);
        assert_eq!(events.len(), 2, "{above:e} 1/s above");
        assert!(cycle.motion.statistics.largest_step > 3.0 * (events[1].0 - events[0].0));
        events[1].0 - events[0].0
    };
    let first = flight(1e-3);
    for quarters in 1..=6 {
        let expected = first / 2f64.powi(quarters);
        let found = flight(1e-3 / 4f64.powi(quarters));
        assert!((found / expected - 1.0).abs() < 0.02, "{found:e} {expected:e}");
    }
}
