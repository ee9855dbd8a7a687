//! Section 5 of the specification, the naive way beside ours where there is one.

use super::*;
use assur::problem::{Equations, Phase};

/// How far the fabric is compressed at an event.
fn compressed(foot: &Elliptic, time: f64, state: &[f64]) -> f64 {
    let (phi, edge) = (foot.omega * time - PI, (foot.phi_p / 2.0).cos());
    (foot.rise * (phi.cos() - edge) / (1.0 - edge)).max(0.0) - state[0]
}

/// The force is zero where the foot leaves, and the fabric is still compressed. The rule that asks for the compression
/// alone lets the fabric pull the foot down until it is gone.
#[test]
fn the_foot_leaves_where_the_force_is_zero() {
    let foot = Elliptic::default();
    let cycle = foot.cycle().unwrap();
    let mut left = 0;
    for event in cycle.motion.events.iter().filter(|one| one.to == FLIGHT) {
        left += 1;
        let force = output(&foot, "F2", CONTACT, event.time, &event.before);
        assert!(force.abs() < 1e-9, "{force:e}");
        assert!(compressed(&foot, event.time, &event.before) > 1e-6);
        // A moment later it would pull.
        let step = 1e-5;
        let on = [event.before[0] + step * event.before[1], event.before[1]];
        assert!(compressed(&foot, event.time + step, &on) > 0.0);
        assert!(output(&foot, "F2", CONTACT, event.time + step, &on) < 0.0, "it pulls");
    }
    assert_eq!(left, 2);
    assert!(Measured::of(&foot, &cycle.motion).smallest > -1e-9);
    let (_, state) = cycle.motion.at(0.0);
    let (_, smallest) = naive::turn(&foot, &state, 20_000, |gap, _| gap > 0.0);
    assert!(smallest < -5.0, "the naive rule pulls with {smallest} N");
}

/// With a damper beside the spring the force comes back before the gap closes, at the compression that is left.
#[test]
fn the_force_comes_back_before_the_gap_closes() {
    let case = &REFERENCE["cases"]["progressive_250"];
    let by: Vec<&str> =
        case["events"].as_array().unwrap().iter().map(|one| one["by"].as_str().unwrap()).collect();
    assert_eq!(by, ["force"; 4]);
    check::<Progressive>("progressive_250");
}

/// Contact that is lost just before the rack passes the plate is regained exactly there, where the force jumps.
#[test]
fn contact_regained_at_a_kink_is_regained_exactly_there() {
    for omega in [170.0, 180.0, 190.0, 200.0, 203.0, 350.0] {
        let foot = Straight::with(&[("omega", omega)]);
        let cycle = foot.cycle().unwrap();
        let [lost, regained] = changes(&cycle.motion)[..] else {
            panic!("{:?}", changes(&cycle.motion));
        };
        assert_eq!((lost.1, regained.1), (FLIGHT, CONTACT));
        let kink = (PI + foot.phi_p / 2.0) / omega;
        assert!((regained.0 - kink).abs() < 1e-15, "{:e}", regained.0 - kink);
        // The instant is given: the motion forgets as if contact had never been lost, but for the flight itself.
        let product: f64 = cycle.multipliers.iter().map(|one| one.modulus()).product();
        let flown = regained.0 - lost.0;
        let touching = (foot.mu1 + foot.mu2) * (foot.period() - flown) + foot.mu1 * flown;
        let expected = (-touching / foot.m).exp();
        assert!((product / expected - 1.0).abs() < 1e-6, "{product:e} {expected:e}");
    }
}

/// A damper beside the spring gives the force a step where contact is regained; damping that grows with the force, or none
/// at all, lets it start from zero.
#[test]
fn how_the_force_begins_where_contact_is_regained() {
    fn begins<C: Scene>(foot: &C, motion: &Motion) -> Vec<(f64, f64)> {
        let landings = motion.events.iter().filter(|one| one.to == CONTACT);
        let both = landings.filter(|one| one.from == FLIGHT).map(|one| {
            let force = output(foot, "F2", CONTACT, one.time, &one.after);
            let phi = 300.0 * one.time - PI;
            // Half a turn later the rack is below the plate.
            let rate = if phi.cos() > 0.5 { -0.6 * phi.sin() } else { 0.0 };
            (force, rate - one.after[1])
        });
        both.collect()
    }
    let damped = Elliptic::default();
    let all = begins(&damped, &damped.cycle().unwrap().motion);
    assert_eq!(all.len(), 2);
    for (force, rate) in all {
        assert!(force > 1.0 && (force - damped.mu2 * rate).abs() < 1e-9, "{force} {rate}");
    }
    let growing = HuntCrossley::default();
    for (force, rate) in begins(&growing, &growing.cycle().unwrap().motion) {
        assert!(force.abs() < 1e-9 && rate > 0.01, "{force} {rate}");
    }
    let elastic = Undamped::default();
    let motion = hybrid::march(&elastic, (0.0, 0.2), &elastic.start(), &FINE).unwrap();
    let all = begins(&elastic, &motion);
    assert!(all.len() > 5 && all.iter().all(|one| one.0.abs() < 1e-9), "{all:?}");
}

/// A heavy foot flies over turns of the rack that its motion does not feel, in steps longer than these. The naive way, to
/// ask for signs at the ends of steps, passes over the contacts between; however exact the steps are, they are all found.
#[test]
fn no_contact_is_stepped_over_in_flight() {
    let changes = [("m", 10.0), ("omega", 1000.0), ("rise", 5e-3)];
    let foot = Undamped { m: 10.0, omega: 1000.0, rise: 5e-3, ..Undamped::default() };
    let rack = Elliptic::with(&changes);
    let mut largest_step: f64 = 0.0;
    for rtol in [1e-7, 1e-9, 1e-10, 1e-12, 1e-13] {
        let settings = Settings { rtol, ..FINE };
        let motion = hybrid::march(&foot, (0.0, 0.2), &foot.start(), &settings).unwrap();
        let lost = motion.events.iter().filter(|one| one.to == FLIGHT);
        let flights = lost.filter(|one| one.from == CONTACT).count();
        assert_eq!(flights, 20, "rtol {rtol}");
        for piece in motion.pieces.iter().filter(|one| one.mode == FLIGHT) {
            let times = piece.trajectory.times();
            let (begin, end) = (times[0], times[times.len() - 1]);
            for part in 1..200 {
                let time = begin + (end - begin) * f64::from(part) / 200.0;
                let deep = compressed(&rack, time, &piece.trajectory.at(time));
                assert!(deep < 1e-9, "rtol {rtol}: {deep} m at {time} s");
            }
        }
        largest_step = largest_step.max(motion.statistics.largest_step);
    }
    // A third of a turn, for as long as the rack is above the plate.
    assert!(largest_step > 2.0 * PI / 3.0 / 1000.0, "{largest_step}");
}

/// Of the law whose damping grows with the force the bracket changes its sign under fast unloading: then the compressed
/// fabric would pull, and does not.
#[test]
fn damping_that_outweighs_the_force_does_not_pull() {
    let foot = HuntCrossley::with(&[("eta", 20.0), ("omega", 400.0)]);
    let motion = hybrid::march(&foot, (0.0, 40.0 * foot.period()), &foot.start(), &FINE).unwrap();
    let early = motion.events.iter().filter(|one| one.to == FLIGHT);
    let as_elliptic = Elliptic::with(&[("omega", 400.0)]);
    let compressed: Vec<f64> =
        early.map(|one| compressed(&as_elliptic, one.time, &one.before)).collect();
    assert!(compressed.iter().any(|one| *one > 1e-5), "{compressed:?}");
    for piece in motion.pieces.iter().filter(|one| one.mode == CONTACT) {
        for time in piece.trajectory.times() {
            let force = output(&foot, "F2", CONTACT, *time, &piece.trajectory.at(*time));
            assert!(force > -1e-8, "{force:e} at {time} s");
        }
    }
}

/// Without damping at all the energy of the motion in the air and on the fabric is kept while the rack is low.
#[test]
fn without_damping_nothing_is_lost() {
    let foot = Elliptic::with(&[("mu1", 0.0), ("mu2", 0.0), ("rise", 0.0), ("F10", 5.0)]);
    let energy = |mode: usize, state: &[f64]| {
        let (w, v) = (state[0], state[1]);
        let fabric = if mode == CONTACT { foot.c2 * w * w / 2.0 } else { 0.0 };
        foot.m * v * v / 2.0 + foot.c1 * w * w / 2.0 + (foot.F10 + foot.m * foot.g) * w + fabric
    };
    let start = [-1e-4, 0.5];
    let before = energy(CONTACT, &start);
    let motion = hybrid::march(&foot, (0.0, 2.0), &start, &FINE).unwrap();
    assert!(changes(&motion).len() > 60, "{}", changes(&motion).len());
    let after = energy(motion.mode, &motion.end);
    assert!((after / before - 1.0).abs() < 1e-10, "{before} {after}");
}

/// The foot is let fall on the resting fabric: the flight is that of a spring without fabric, the instant of contact of
/// its closed form, whatever the stiffness.
#[test]
fn fabrics_from_soft_to_hard() {
    for c2 in [1e3, 1e5, 4e5, 5e6, 1e9] {
        let mut foot = Elliptic::with(&[("c2", c2), ("rise", 0.0), ("mu1", 0.0)]);
        // A tenth of the critical damping.
        foot.mu2 = 0.2 * (c2 * foot.m).sqrt();
        let height = 1e-3;
        let motion = hybrid::march_in(&foot, FLIGHT, (0.0, 0.5), &[height, 0.0], &FINE).unwrap();
        let k = (foot.c1 / foot.m).sqrt();
        let rest = -(foot.F10 + foot.m * foot.g) / foot.c1;
        let expected = (-rest / (height - rest)).acos() / k;
        let first = motion.events[0].time;
        assert!((first / expected - 1.0).abs() < 1e-11, "c2 = {c2:e}: {first} {expected}");
        // In the end it lies still.
        let lying = -(foot.F10 + foot.m * foot.g) / (foot.c1 + c2);
        if c2 > 1e4 {
            assert_eq!(motion.mode, CONTACT);
            assert!((motion.end[0] / lying - 1.0).abs() < 1e-6, "{:e} {lying:e}", motion.end[0]);
        }
        let contacts = changes(&motion).len();
        assert!(contacts < 60, "c2 = {c2:e}: {contacts} changes of contact");
    }
}

/// A stiff fabric with hardly any damping: contact after contact, a series that ends.
#[test]
fn short_contacts_follow_each_other() {
    let mut foot = Elliptic::with(&[("c2", 5e6), ("rise", 0.0), ("mu1", 0.0)]);
    foot.mu2 = 5.0;
    let motion = hybrid::march_in(&foot, FLIGHT, (0.0, 1.0), &[1e-3, 0.0], &FINE).unwrap();
    let landings: Vec<f64> =
        changes(&motion).iter().filter(|one| one.1 == CONTACT).map(|one| one.0).collect();
    assert!(landings.len() > 50, "{}", landings.len());
    let gaps: Vec<f64> = landings.windows(2).map(|pair| pair[1] - pair[0]).collect();
    assert!(gaps.windows(2).all(|pair| pair[1] < pair[0]));
    assert_eq!(motion.mode, CONTACT);
}

/// So light a preload that the foot flies for whole turns: it falls as the closed form says, with the spring alone.
#[test]
fn flights_of_several_turns() {
    let foot = Elliptic::with(&[("F10", 0.1), ("c1", 0.0), ("mu1", 0.0), ("omega", 900.0)]);
    let turns = 400.0;
    let motion = hybrid::march(&foot, (0.0, turns * foot.period()), &foot.start(), &FINE).unwrap();
    let pull = foot.F10 / foot.m + foot.g;
    let flights = motion.pieces.iter().filter(|one| one.mode == FLIGHT);
    let mut longest = 0.0f64;
    for piece in flights {
        let (from, to) = Motion::ends(piece);
        let (begin, end) = (piece.trajectory.at(from), piece.trajectory.at(to));
        let time = to - from;
        let fallen = begin[0] + begin[1] * time - pull * time * time / 2.0;
        assert!((end[0] - fallen).abs() < 1e-11, "{:e}", end[0] - fallen);
        longest = longest.max(time / foot.period());
    }
    assert!(longest > 3.0, "{longest} turns");
    assert!(motion.end[0] > -1e-3 && motion.end[0] < 1.0);
}

/// Where nothing that repeats attracts, it is said so, with the growth of disturbances and the unstable motion.
#[test]
fn no_stable_motion_is_reported() {
    let error = Elliptic::with(&[("omega", 800.0)]).cycle().unwrap_err();
    let CycleError::NoneStable { growth, unstable, .. } = &error else {
        panic!("{error}");
    };
    assert!(*growth > 1.1, "{error}");
    assert!(unstable.as_ref().is_some_and(|one| !one.is_stable()), "{error}");
}

/// Just beyond a doubling of the period the motion of half the length is near, and not stable: what attracts is the other.
/// After wide flights the two look the nearer. A motion that has come to repeat is never reported as one that does not.
#[test]
fn the_longer_of_two_motions_near_each_other_is_found() {
    let case = &REFERENCE["cases"]["progressive_515"];
    let (foot, start) = (foot::<Progressive>(case), numbers(&case["start"]));
    let found = hybrid::cycle_from(&foot, (CONTACT, &start), foot.period(), &FINE).unwrap();
    compare("progressive_515", &foot, &found);
    let mut found = 0;
    for begin in 1..=10 {
        let start = [-1e-4 * f64::from(begin), 0.0];
        match hybrid::cycle_from(&foot, (CONTACT, &start), foot.period(), &FINE) {
            Ok(cycle) => {
                compare("progressive_515", &foot, &cycle);
                found += 1;
            }
            Err(CycleError::NoneStable { nearest, .. }) => {
                assert!(nearest.is_none_or(|one| one.1 > 1e-6), "{nearest:?}");
            }
            Err(error) => panic!("{error}"),
        }
    }
    assert!(found > 0, "from none of these starts");
}

/// Disturbances that die out by a fortieth in two turns: far too slowly to wait for.
#[test]
fn a_multiplier_near_one() {
    let case = &REFERENCE["cases"]["elliptic_375"];
    assert!(numbers(&case["multipliers"][0])[0] > 0.975);
    check::<Elliptic>("elliptic_375");
}

/// Irregular motion, for hundreds of turns from some starts, and then one that repeats.
#[test]
fn irregular_motion_that_dies_out() {
    let case = &REFERENCE["cases"]["stiff_335"];
    let (foot, start) = (foot::<Elliptic>(case), numbers(&case["start"]));
    let found = hybrid::cycle_from(&foot, (CONTACT, &start), foot.period(), &FINE).unwrap();
    compare("stiff_335", &foot, &found);
    let places = [0.0, 1.0].map(|turn| found.motion.at(turn * foot.period()).1);
    let mut longest = 0;
    for begin in 1..=8 {
        let (mut mode, mut state) = (CONTACT, vec![-1e-4 * f64::from(begin), 0.0]);
        let mut turns = 0;
        while places.iter().all(|one| (one[0] - state[0]).abs() > 1e-7) {
            let times = (0.0, foot.period());
            let motion = hybrid::march_in(&foot, mode, times, &state, &FINE).unwrap();
            (mode, state) = (motion.mode, motion.end);
            turns += 1;
            assert!(turns < 5000, "it goes on from {begin}");
        }
        longest = longest.max(turns);
    }
    assert!(longest > 100, "{longest}");
}

/// A foot on its weight alone, and a preload or a spring that goes to nothing, come to the limit.
#[test]
fn without_spring_and_preload() {
    let at = |preload: f64, c1: f64| {
        let foot = Elliptic::with(&[("F10", preload), ("c1", c1), ("omega", 60.0)]);
        let cycle = foot.cycle().unwrap();
        (cycle.motion.pieces[0].trajectory.at(0.0), Measured::of(&foot, &cycle.motion).mean)
    };
    let (state, mean) = at(0.0, 0.0);
    let (near, near_mean) = at(1e-9, 1e-6);
    assert!(
        (state[0] - near[0]).abs() < 1e-12 && (mean - near_mean).abs() < 1e-6,
        "{state:?} {near:?}"
    );
    check::<Elliptic>("held_by_weight");
}

/// A light foot follows the fabric. An explicit method takes the small steps that its stability asks for; that it gets
/// to the end at all shows that it does not need a stiff one; what changes on the way comes to the same with a
/// fifteenth of the evaluations.
#[test]
fn a_foot_of_no_mass_follows_the_fabric() {
    let mut foot = Elliptic::with(&[("m", 1e-4), ("omega", 100.0)]);
    foot.g = 0.0;
    let settings = Settings::new(Method::Tsit5).rtol(1e-8);
    let motion = hybrid::march(&foot, (0.0, foot.period()), &foot.start(), &settings).unwrap();
    assert!(motion.statistics.steps > 1000, "{}", motion.statistics.steps);
    let stiff = Settings { method: Method::Auto, ..settings };
    let other = hybrid::march(&foot, (0.0, foot.period()), &foot.start(), &stiff).unwrap();
    assert!(
        15 * other.statistics.evaluations < motion.statistics.evaluations,
        "{:?} {:?}",
        other.statistics,
        motion.statistics
    );
    assert!((other.end[0] / motion.end[0] - 1.0).abs() < 1e-6);
    // Where the rack is below the plate the fabric bears the spring.
    let lying = -foot.F10 / (foot.c1 + foot.c2);
    assert!((motion.end[0] / lying - 1.0).abs() < 1e-5, "{:e} {lying:e}", motion.end[0]);
}

/// Turn after turn the foot leaves and comes back at the same angles: nothing drifts.
#[track_caller]
fn check_drift(turns: u32) {
    let case = &REFERENCE["cases"]["elliptic_300"];
    let foot = foot::<Elliptic>(case);
    let expected: Vec<f64> =
        case["events"].as_array().unwrap().iter().map(|one| number(&one["time"])).collect();
    let (mut mode, mut state) = (FLIGHT, numbers(&case["start"]));
    let batch = 100;
    let mut worst = 0.0f64;
    for number in 0..turns / batch {
        // The time goes on: it is the phase of the shaft that could drift.
        let from = f64::from(number * batch) * foot.period();
        let to = f64::from((number + 1) * batch) * foot.period();
        let motion = hybrid::march_in(&foot, mode, (from, to), &state, &FINE).unwrap();
        let all = changes(&motion);
        assert_eq!(all.len(), 4 * batch as usize, "{number}");
        for (place, (time, _)) in all.iter().enumerate() {
            let turn = f64::from(number * batch) + (place / 4) as f64;
            let phase = time - turn * foot.period();
            worst = worst.max((phase - expected[place % 4]).abs() / foot.period());
        }
        (mode, state) = (motion.mode, motion.end);
    }
    // The time itself is known to its roundings.
    let allowed = 1e-10 + 8.0 * f64::EPSILON * f64::from(turns);
    assert!(worst < allowed, "{worst:e} of a turn");
}

#[test]
fn a_thousand_turns_do_not_drift() {
    check_drift(1000);
}

#[test]
#[ignore = "a minute; cargo test --release --test suite -- --ignored hundred_thousand_turns"]
fn a_hundred_thousand_turns_do_not_drift() {
    check_drift(100_000);
}

/// Below the fabric, in a mode that says that the foot is off, it would hang on its spring for ever: a motion that
/// repeats and is stable, to which Newton's method comes from irregular motion, and that no foot comes to.
#[test]
fn a_motion_below_the_fabric_is_not_found() {
    for omega in [850.0, 860.0, 880.0, 900.0] {
        let foot = Progressive::with(&[("omega", omega)]);
        let cycle =
            |start: [f64; 2]| hybrid::cycle_from(&foot, (FLIGHT, &start), foot.period(), &FINE);
        // It is a motion of these equations, if one does not ask whether they hold there.
        let hanging = [-(foot.F10 + foot.m * foot.g) / foot.c1, 0.0];
        let (equations, phase) = (foot.prepare::<f64>(), Phase::of(FLIGHT));
        let (mut row, mut rates) = (vec![0.0; equations.instant()], [1.0; 2]);
        equations.instants(phase, &[0.0], &mut row);
        equations.rates(phase, &row, &hanging, &mut rates);
        assert!(rates.iter().all(|rate| rate.abs() < 1e-10), "{rates:?}");
        let refused = cycle(hanging).expect_err("no foot is there").to_string();
        assert!(refused.contains("`flight`, where `when Delta rises"), "{refused}");
        for start in [[0.0, 0.1], [1e-3, 0.0]] {
            let ended = cycle(start);
            let Err(CycleError::NoneStable { unstable: Some(unstable), growth, .. }) = ended else {
                panic!("{omega} 1/s from {start:?}: {:?}", ended.map(|found| found.motion.end));
            };
            // What there is, is irregular about a motion that leaves the fabric and comes back to it.
            assert!(growth > 1.5, "{omega} 1/s: {growth}");
            assert!(unstable.motion.events.len() >= 2, "{omega} 1/s: {:?}", unstable.motion.events);
        }
    }
}

/// Motions that repeat after one turn exist, and are not stable: Newton's method alone would give one. The motion itself is
/// irregular, another one from each start, and comes near to one of them now and then.
#[test]
fn an_unstable_motion_is_given_as_such() {
    let case = &REFERENCE["cases"]["stiff_300"];
    let foot = foot::<Elliptic>(case);
    let expected = case["multipliers"].as_array().unwrap();
    let mut as_expected = 0;
    for number in 0..8 {
        let start = [1e-4 * f64::from(number), 0.01];
        let ended = hybrid::cycle_from(&foot, (FLIGHT, &start), foot.period(), &FINE);
        let Err(CycleError::NoneStable { unstable: Some(unstable), growth, .. }) = ended else {
            panic!("start {number}: {:?}", ended.err().map(|one| one.to_string()));
        };
        assert!(unstable.multiple == 1 && growth > 1.2, "{growth}");
        assert!(unstable.residual < 1e-9 && unstable.multipliers[0].modulus() > 1.2);
        let pairs = unstable.multipliers.iter().zip(expected);
        let mut off = pairs.map(|(found, expected)| (found.re - numbers(expected)[0]).abs());
        as_expected += u32::from(off.all(|off| off < 1e-8));
    }
    assert!(as_expected >= 1, "{as_expected}");
}
