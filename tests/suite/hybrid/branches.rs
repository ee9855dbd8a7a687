//! Branches, `abs`, `sign` and `max` in equations of motion: steps end where they go over to their other side.

use assur::hybrid::{HybridError, march};
use assur::model::Flow;
use assur::ode::{Explicit, Options, Workspace, integrate};
use assur::prelude::*;

const SETTINGS: Settings = Settings::new(Method::Dop853).rtol(1e-9);

mod rub {
    assur::mechanism! {
        /// A block on a table, pushed by a force that swings, slowed by dry friction.
        Rub from "any textbook";
        parameter m = 1 kg, R = 1 N, F = 5 N, omega = 3 [rad/s];
        coordinate x: m = 0, rate = 1 [m/s];
        motion slide: m*ddot(x) = F*cos(omega*time) - R*sign(dot(x));
        output x, friction = -R*sign(dot(x)) [N];
        scene pushed { run time 0 s .. 10 s; }
        scene coasting { run time 0 s .. 10 s; }
    }
}

/// Where friction changes its sign the equations jump. A stepper that does not know it creeps up to each jump in ever
/// smaller steps, 7900 evaluations; to find the jumps and end steps there takes 970 for the same accuracy.
#[test]
fn steps_end_where_a_branch_changes() {
    let scene = rub::Pushed::default();
    let (fine, start) = (Settings { rtol: 1e-13, ..SETTINGS }, [0.0, 1.0]);
    let reference = march(&scene, (0.0, 10.0), &start, &fine).expect("it slides");
    let located = march(&scene, (0.0, 10.0), &start, &SETTINGS).expect("it slides");
    // `ode::march` does not take a scene with events.
    let model = Bound::new(&scene);
    let flow = Flow::new(&model, 0);
    let mut workspace = Workspace::new(Explicit::Dop853, &flow);
    let options = Options::of(&SETTINGS, rub::Pushed::shape().scales);
    let naive = integrate(&flow, (0.0, 10.0), &start, &options, &mut workspace, &mut ());
    let naive = naive.expect("it slides");
    let off = |end: &[f64]| (end[0] - reference.end[0]).abs();
    assert!(located.events.len() > 8);
    assert!(off(&located.end) < 5e-9 && off(workspace.state()) < 5e-9);
    let (ours, theirs) = (located.statistics.evaluations, naive.evaluations);
    assert!(6 * ours < theirs, "{ours} {theirs}");
}

/// On a surface the values do not say on which side of it the motion is: `sign` of a speed of zero is zero. Outputs take the
/// side from the motion, as its rates do.
#[test]
fn outputs_are_on_the_side_of_the_motion() {
    let scene = rub::Pushed::default();
    let motion = scene.from([0.0, 0.0]).run().expect("it slides");
    let times = std::iter::once(0.0).chain(motion.events().iter().map(|event| event.time));
    let (mut there, mut naive) = (Vec::new(), Vec::new());
    for time in times {
        let here = motion.at_exactly(time);
        let expected = here.rates[1] - 5.0 * (3.0 * time).cos();
        assert!((here.outputs[1] - expected).abs() < 1e-12, "{time}: {here:?} {expected}");
        there.push(here.outputs[1]);
        naive.push(motion.model().outputs(time, &here.state)[1]);
    }
    assert!(there.len() > 8 && there.windows(2).all(|pair| pair[0] == -pair[1]), "{there:?}");
    // As the speed is zero to rounding, its sign is that of the rounding, or of what side is guessed.
    assert_ne!(naive, there);
}

/// Without a push the block comes to rest, and friction holds it.
#[test]
fn friction_that_holds_is_reported() {
    let scene = rub::Coasting { F: 0.0, ..rub::Coasting::default() };
    let ended = march(&scene, (0.0, 10.0), &[0.0, 1.0], &SETTINGS);
    let Err(HybridError::Held { time, motion, .. }) = ended else {
        panic!("{ended:?}");
    };
    assert!((time - 1.0).abs() < 1e-12, "{time}");
    assert!((motion.end[0] - 0.5).abs() < 1e-12);
}

mod drain {
    assur::mechanism! {
        /// A tank with a pump at its bottom and a hole: from the level of the hole on the pump works alone.
        Drain from "Torricelli";
        parameter g = 9.81 [m/s^2], pump = 0.01 [m/s], hole = 0.02;
        state h: m = 1 m;
        let out = if h > 0 m { hole*sqrt(2*g*h) } else { 0 [m/s] };
        motion sink: dot(h) = -pump - out;
        output h, out;
        measure fastest = peak(out);
        measure drained = total(out);
        scene run { run time 0 s .. 40 s; }
    }
}

/// The step that ends where the tank is empty tries the root of negative numbers.
#[test]
fn a_branch_that_does_not_exist_beyond_its_surface() {
    let tank = drain::Run::default();
    for method in [
        Method::Tsit5,
        Method::Dop853,
        Method::Taylor,
        Method::Radau,
        Method::Rosenbrock,
        Method::Auto,
    ] {
        let settings = Settings::new(method).rtol(1e-11);
        let motion = march(&tank, (0.0, 40.0), &[1.0], &settings).expect("it drains");
        // With u = sqrt(h): 2 u du/dt = -pump - k u.
        let (pump, k) = (tank.pump, tank.hole * (2.0 * tank.g).sqrt());
        let empty = 2.0 / k - 2.0 * pump / (k * k) * (1.0 + k / pump).ln();
        let [event] = &motion.events[..] else { panic!("{method:?}: {:?}", motion.events) };
        assert!((event.time - empty).abs() < 1e-9, "{method:?}: {} {empty}", event.time);
        assert!((motion.end[0] + pump * (40.0 - empty)).abs() < 1e-10);
        let found = assur::measure::of(&tank, &motion);
        for (found, expected) in found.into_iter().zip([k, 1.0 - pump * empty]) {
            let found = found.expect("it exists");
            assert!((found - expected).abs() < 1e-9, "{found} {expected}");
        }
    }
}

mod shelf {
    assur::mechanism! {
        /// A height with kinks: a follower on a rack that shows above a plate for a part of each turn.
        Shelf from "made up";
        parameter omega = 5 [rad/s];
        coordinate x: m = 0;
        let rack = max(0, cos(omega*time) - 0.5);
        motion follow: ddot(x) = rack*1 [m/s^2];
        output x, rack;
        scene turns { run time 0 s .. 4 s; }
    }
}

/// A kink in the time alone is a surface as well.
#[test]
fn kinks_of_what_drives_are_stepped_on() {
    let motion =
        march(&shelf::Turns::default(), (0.0, 4.0), &[0.0, 0.0], &SETTINGS).expect("it moves");
    let edge = (0.5_f64).acos() / 5.0;
    assert!((motion.events[0].time - edge).abs() < 1e-14);
    // v after whole turns: each gives (2 sin(pi/3) - pi/3)/omega.
    let turns = 3.0;
    let (_, state) = motion.at(std::f64::consts::TAU / 5.0 * turns);
    let expected = turns * (3.0_f64.sqrt() - std::f64::consts::PI / 3.0) / 5.0;
    assert!((state[1] - expected).abs() < 1e-10, "{} {expected}", state[1]);
}

mod drag {
    assur::mechanism! {
        /// A block on a table, dragged by a spring whose other end is pushed just as hard as the block rubs.
        Drag from "made up";
        parameter J = 10 kg, m = 1 kg, c = 1e6 [N/m], d = 1100 [kg/s], F = 17 N;
        coordinate x: m = 0, y: m = 0;
        let T = c*(x - y);
        motion push: J*ddot(x) = F - d*dot(x) - T;
        mode rest {
            hold y;
            when T - F rises -> slip;
        }
        mode slip {
            motion rub: m*ddot(y) = T - F;
            when dot(y) falls -> rest { set dot(y) = 0; }
        }
        output T;
        scene dragged { run time 0 s .. 1 s; }
    }
}

/// Slip after slip the swing comes nearer to the friction, until they differ by the rounding of both. Seen as a number of
/// its own size that difference has a zero between any two others, and a search for the first has no end; nor do the
/// events, if a block whose acceleration is such a difference is taken to turn round.
#[test]
fn a_swing_that_ends_at_a_threshold() {
    let settings = Settings { rtol: 1e-13, ..SETTINGS };
    let drag = drag::Dragged::default();
    let motion = march(&drag, (0.0, 1.0), &[0.0; 4], &settings).expect("it comes to rest");
    assert!((60..200).contains(&motion.events.len()));
    assert!(motion.events.last().unwrap().time < 0.6);
    assert!(motion.statistics.evaluations < 30_000);
}

mod lift {
    assur::mechanism! {
        /// A rack that rises above a plate, and what follows it without a spring: its speed jumps where the rack comes.
        Lift from "made up";
        parameter omega = 5 [rad/s], level = 2 [1/s], turns = 0.25;
        driver phi = omega*time ~ 0 rad;
        let height = max(0, sin(phi) - turns);
        state counted: 1 = 0;
        motion count: dot(counted) = 0 [1/s];
        output counted, height;
        when dot(height) - level rises { set counted = counted + 1; }
        scene go { run time 0 s .. 40 s; }
    }
}

/// The guard jumps over zero where the rack rises above the plate, and again to below it where the rack goes. Between
/// the ends of a step, which is longer than a turn, only its kinks say where: they are found to the last bits.
#[test]
fn a_guard_that_jumps_passes_zero_at_its_kink() {
    let lift = lift::Go::default();
    assert_eq!(lift::Go::shape().modes[0].kinks, 1);
    let motion = march(&lift, (0.0, 40.0), &[0.0], &SETTINGS).expect("it turns");
    let rises = 0.25f64.asin();
    let count = ((40.0 * 5.0 - rises) / std::f64::consts::TAU).ceil() as usize;
    assert_eq!(motion.events.len(), count);
    for (turn, event) in motion.events.iter().enumerate() {
        let expected = (rises + turn as f64 * std::f64::consts::TAU) / 5.0;
        let off = (event.time - expected).abs();
        assert!(off < 4.0 * f64::EPSILON * expected.max(1.0), "{turn}: {off:e}");
        // At the kink the speed is the one above the plate already.
        let speed = 5.0 * (5.0 * event.time).cos() - 2.0;
        assert!((event.guard - speed).abs() < 1e-12, "{} {speed}", event.guard);
    }
}
