//! A needle plate that yields: in series with the fabric while the rack is low.

use super::*;

/// The second computation switches between rack and plate by events of its own.
#[test]
fn a_plate_that_yields() {
    for omega in [200, 300, 500] {
        check::<Yielding>(&format!("yielding_{omega}"));
        check::<YieldingStraight>(&format!("yielding_straight_{omega}"));
    }
}

/// While the rack is low, spring and weight rest on fabric and plate in series.
#[test]
fn at_rest_both_springs_bear() {
    for c_p in [5e4, 1e5, 1e6, 1e9] {
        // So slow that the rack is below the plate for seconds.
        let foot = Yielding::with(&[("omega", 1.0), ("c_p", c_p)]);
        let motion = hybrid::march(&foot, (0.0, 1.0), &foot.start(), &FINE).unwrap();
        assert!(motion.events.is_empty(), "the rack stays below");
        let load = foot.F10 + foot.m * foot.g;
        let series = foot.c2 * c_p / (foot.c2 + c_p);
        let expected = -load / (foot.c1 + series);
        assert!((motion.end[0] / expected - 1.0).abs() < 1e-11);
        let pressed = force(&foot, &motion, motion.time);
        assert!((pressed / (load + foot.c1 * expected) - 1.0).abs() < 1e-11);
    }
}

/// An ever stiffer plate is none: what is left goes with its compliance, in contact, with flights, on both paths.
#[test]
fn a_stiff_plate_is_none() {
    fn check<Soft: Foot, Rigid: Foot>(omega: f64) {
        let measured = |found: Cycle| found.motion.pieces[0].trajectory.at(0.0);
        let rigid = measured(Rigid::with(&[("omega", omega)]).cycle().unwrap());
        let off = [1e8, 1e9, 1e15].map(|c_p| {
            let foot = Soft::with(&[("omega", omega), ("c_p", c_p)]);
            let found = measured(foot.cycle().unwrap());
            ((found[0] - rigid[0]) * omega).hypot(found[1] - rigid[1])
        });
        let order = (off[0] / off[1]).log10();
        assert!((order - 1.0).abs() < 0.02, "{omega} 1/s: {off:?}");
        assert!(off[2] < 1e-10 && off[1] > 1e-8, "{omega} 1/s: {off:?}");
    }
    for omega in [180.0, 300.0, 500.0] {
        check::<Yielding, Elliptic>(omega);
    }
    for omega in [300.0, 400.0] {
        check::<YieldingStraight, Straight>(omega);
    }
}

/// Rack and plate take the fabric from each other where they are level: twice a turn, with the height of the support
/// unbroken and the rate of its compression not, so that the force jumps by the damping times the difference of the rates.
#[test]
fn the_rack_takes_the_fabric_from_the_plate_where_they_are_level() {
    for omega in [150.0, 200.0, 220.0] {
        let foot = Yielding::with(&[("omega", omega)]);
        let cycle = foot.cycle().unwrap();
        let sink = foot.c2 / (foot.c2 + foot.c_p);
        let switches: Vec<_> = cycle.motion.events.iter().collect();
        assert_eq!(switches.len(), 2, "{omega} 1/s");
        for (event, to_rack) in switches.into_iter().zip([true, false]) {
            let (phi, edge) = (omega * event.time - PI, (foot.phi_p / 2.0).cos());
            let height = foot.rise / (1.0 - edge);
            let rack = height * (phi.cos() - edge);
            let (w, v) = (event.before[0], event.before[1]);
            assert!(rack < 0.0 && (rack - sink * w).abs() < 1e-15, "{rack:e}");
            let difference = -height * omega * phi.sin() - sink * v;
            assert_eq!(difference > 0.0, to_rack);
            let blur = 1e-12;
            let [before, after] = [-blur, blur]
                .map(|part| force(&foot, &cycle.motion, event.time + part * foot.period()));
            let expected = foot.mu2 * difference.abs();
            assert!((after - before - expected).abs() < 1e-7, "{before} {after} {expected}");
        }
    }
}
