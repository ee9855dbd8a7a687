//! Numbers of a whole run, of a ball that falls and stays, against closed forms.

use approx::assert_relative_eq;
use assur::measure::{self, ALWAYS, Missing};
use assur::prelude::*;

assur::mechanism! {
    Ball from "free fall";
    parameter g = 9.81 [m/s^2], h = 1 m;
    driver phi = 2*pi*time/(1 s);
    coordinate y: m = h;
    mode flight {
        // A plain zero has the unit that the force has in the other mode.
        let N = 0;
        motion ddot(y) = -g;
        when y falls -> rest { set dot(y) = 0; }
    }
    mode rest {
        let N = g;
        hold y;
    }
    output y, N;
    measure highest = peak(y);
    measure impact = -value(dot(y), leave(flight)), fall = value(time, enter(rest)) [ms];
    measure kept = impact^2/2/(g*h) "energy at the impact over that at the start";
    measure resting = duration(N > 0);
    measure load = mean(N), late_load = mean(N, time > 1 s), too_late = mean(N, time > 3 s);
    measure hits = count(enter(rest));
    measure drop = total(-dot(y));
    measure first = amplitude(cos(phi), phi, 1), second = amplitude(cos(phi), phi, 2);
    scene fall { run time 0 s .. 2 s; }
    expect at run: hits = 1 +- 0;
    expect at run: drop = 1 m +- 1e-12 m;
}

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-11);

#[test]
fn measures_of_a_run_with_modes_are_those_of_the_closed_form() {
    let scene = Fall::default();
    let motion = assur::hybrid::march(&scene, (0.0, 2.0), &scene.start(), &FINE).unwrap();
    let found = measure::of(&scene, &motion);
    let (g, t) = (9.81, (2.0f64 / 9.81).sqrt());
    let expected =
        [1.0, g * t, t, 1.0, 2.0 - t, g * (2.0 - t) / 2.0, g, f64::NAN, 1.0, 1.0, 1.0, 0.0];
    assert_eq!(found.len(), expected.len());
    for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
        match found {
            Ok(value) => assert_relative_eq!(*value, expected, epsilon = 1e-12),
            Err(missing) => assert_eq!((index, *missing), (7, Missing::NeverHolds)),
        }
    }
}

#[test]
fn the_tables_name_them_with_their_units() {
    let entry = MECHANISM.scenes[0];
    let names: Vec<_> = entry.measures.iter().map(|one| (one.name, one.unit)).collect();
    assert_eq!(names[..4], [("highest", "m"), ("impact", "m/s"), ("fall", "ms"), ("kept", "")]);
    assert_eq!(entry.measures[5].unit, "m/s^2");
    assert_eq!(entry.measures[3].summary, "energy at the impact over that at the start");
}

mod swing {
    assur::mechanism! {
        /// A mass on a spring, with a stop that it does not come to.
        Swing from "any textbook";
        parameter m = 1 kg, c = 100 [N/m], T = 1 s;
        coordinate x: m = 1 mm;
        motion m*ddot(x) = -c*x;
        when x - 1 m rises { set dot(x) = 0; }
        measure highest = peak(x), deepest = lowest(x), late = peak(x, time > T);
        scene swing { run time 0 s .. 2 s; start x = 1 mm; }
    }
}

/// Wherever in a step an extreme lies, beside its end for instance.
#[test]
fn an_extreme_beside_the_end_of_a_step_is_found() {
    for turn in 0..200 {
        let angle = f64::from(turn) * 0.01;
        let scene = swing::Swing { T: 0.9, ..swing::Swing::default() };
        let start = [1e-3 * angle.cos(), 1e-2 * angle.sin()];
        let motion = assur::hybrid::march(&scene, (0.0, 2.0), &start, &FINE).unwrap();
        for (index, expected) in [1e-3, -1e-3, 1e-3].into_iter().enumerate() {
            let found = *measure::of(&scene, &motion)[index].as_ref().unwrap();
            assert_relative_eq!(found, expected, max_relative = 1e-10);
        }
    }
}

/// Half a second of a motor's run-up in ten minutes of its warming up.
mod motor {
    assur::mechanism! {
        /// Direct current motor, gear, flexible coupling, load; the winding heats up.
        Motor from "made up";
        parameter U = 24 V, R20 = 0.5 ohm, L = 1 mH, k = 0.05 [N m/A], J1 = 2e-5 [kg m^2];
        parameter i_g = 10, c = 200 [N m/rad], d = 0.2 [N m s/rad], J2 = 5e-2 [kg m^2], M_L = 3 [N m];
        parameter C_th = 50 [J/K], G_th = 0.5 [W/K], alpha = 0.0039 [1/K], T_a = 293 K;
        state I: A = 0;
        state T: K = 293 K;
        coordinate phi1: rad = 0, phi2: rad = 0;
        let R = R20*(1 + alpha*(T - 293 K));
        motion electric: L*dot(I) + R*I + k*dot(phi1) = U;
        motion thermal: C_th*dot(T) = R*I^2 - G_th*(T - T_a);
        let twist = phi1/i_g - phi2;
        kinetic J1*dot(phi1)^2/2 + J2*dot(phi2)^2/2;
        potential c*twist^2/2;
        dissipation d*dot(twist)^2/2;
        force k*I on phi1, -M_L*tanh(dot(phi2)/(0.01 [rad/s])) on phi2;
        output ddot(phi1);
        measure largest = peak(ddot(phi1)), smallest = lowest(ddot(phi1));
        scene hot { run time 0 s .. 60 s; }
    }
}

/// A step of a stiff method is a second long, and what is sought lasts milliseconds: all methods find it, and it is what the
/// measures find.
#[test]
fn extremes_of_a_long_run_are_found_in_its_short_beginning() {
    let run = assur::registry::bind(motor::Hot::default()).expect("its values are good");
    for method in [
        Method::Dop853,
        Method::Tsit5,
        Method::Taylor,
        Method::Radau,
        Method::Rosenbrock,
        Method::Auto,
    ] {
        let settings = Settings::new(method).rtol(1e-9);
        let motion = run.follow((0.0, 60.0), &run.start(), &settings);
        let motion = motion.expect("a motion");
        let sample = |phase: Phase<'_, f64>, time: f64, state: &[f64], values: &mut [f64]| {
            values.copy_from_slice(&run.outputs_in(phase.mode, time, state));
        };
        let found = measure::extremes(&motion, ALWAYS, 1, &sample)[0].clone();
        let found = found.expect("there are some");
        let (lowest, highest) = (found.lowest, found.highest);
        assert!((highest.value - 56_962.739_1).abs() < 1e-2, "{method:?}: {highest:?}");
        assert!((highest.time - 0.002_101_900_62).abs() < 1e-9, "{method:?}: {highest:?}");
        assert!((lowest.value + 37_360.330).abs() < 1e-1, "{method:?}: {lowest:?}");
        let measures = run.measure(&motion);
        assert_eq!(measures, [Ok(highest.value), Ok(lowest.value)], "{method:?}");
    }
}
