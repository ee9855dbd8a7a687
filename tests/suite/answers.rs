//! The front door: what a scene is asked, and its motion.

use assur::answer::{Error, Status};
use assur::prelude::*;
use std::f64::consts::TAU;

mod swinging {
    assur::mechanism! {
        /// A point mass on a massless rod.
        Pendulum from "any textbook";
        dimension l = 1 m in 0.1 m .. 10 m;
        parameter m = 2 kg, g = 9.81 [m/s^2];
        coordinate phi: rad = 0.1;
        kinetic   m*(l*dot(phi))^2/2;
        potential -m*g*l*cos(phi);
        output pull = m*(g*cos(phi) + l*dot(phi)^2) [N];
        measure pull_most = peak(pull);
        scene swing "two swings or so" { run time 0 s .. 4 s; }
    }
}

mod bouncing {
    assur::mechanism! {
        /// A ball that falls onto a floor and comes back.
        Ball from "made up";
        parameter g = 9.81 [m/s^2], e = 0.8;
        coordinate h: m = 1 m;
        motion ddot(h) = -g;
        when h falls { set dot(h) = -e*dot(h); }
        scene fall { run time 0 s .. 1 s; }
    }
}

mod driven {
    assur::mechanism! {
        /// A mass on a spring and a damper, shaken by a force.
        Shaken from "any textbook";
        parameter omega = 2 [rad/s], d = 0.2 [1/s], k = 9 [1/s^2];
        coordinate x: m = 0 m;
        motion ddot(x) = -k*x - d*dot(x) + cos(omega*time)*1 [m/s^2];
        measure largest = multiplier(1), near = 2*detuning(1);
        scene steady { periodic over 2*pi/omega; }
    }
}

mod linked {
    assur::mechanism! {
        /// A crank that moves a slide.
        SliderCrank from "any textbook";
        dimension r = 50 mm +- 0.1 mm, l = 200 mm;
        driver phi ~ 60 deg in 0 deg .. 360 deg;
        dependent theta ~ -10 deg, s: mm ~ 220 mm;
        closure slide: r*dir(phi) + l*dir(theta) = [s, 0 mm];
        output stroke = s - 150 mm [mm];
        scene turn { sweep phi; }
    }
}

use bouncing::Fall;
use driven::Steady;
use linked::Turn;
use swinging::Swing;

#[test]
fn a_scene_runs_over_its_task() {
    let motion = Swing::default().run().unwrap();
    let end = motion.at(4.0);
    assert_eq!(end[Swing::PHI], end.state[0]);
    assert_eq!(motion.value("phi", 4.0).unwrap(), end[Swing::PHI]);
    assert_eq!(motion.output("pull", 4.0).unwrap(), end[Swing::PULL]);
    // The energy of the start is that of every time.
    let energy = |phi: f64, rate: f64| 0.5 * rate * rate - 9.81 * phi.cos();
    let off = energy(end[Swing::PHI], end[Swing::DOT_PHI]) - energy(0.1, 0.0);
    assert!(off.abs() < 1e-9, "{off:e}");
    assert_eq!(motion.status(), Status::Complete);
}

/// The force in the rod is largest at the lowest point: `m g (3 - 2 cos(phi0))`.
#[test]
fn measures_have_names() {
    let motion = Swing::default().run().unwrap();
    let most = motion.measure("pull_most").unwrap();
    let exact = 2.0 * 9.81 * (3.0 - 2.0 * 0.1_f64.cos());
    assert!((most - exact).abs() < 1e-8, "{most} {exact}");
}

#[test]
fn starts_ends_and_methods_are_said() {
    let long = Swing { l: 2.0, ..Swing::default() };
    let settings = Settings::new(Method::Taylor).rtol(1e-12);
    let motion = long.from([0.01, 0.0]).until(10.0).solve(&settings).unwrap();
    // A small swing from rest first passes its middle after a quarter of `2 pi sqrt(l/g) (1 + phi0^2/16)`.
    let first = motion.first_time(Swing::PHI, 0.0).unwrap();
    let quarter = 0.25 * TAU * (2.0_f64 / 9.81).sqrt() * (1.0 + 1e-4 / 16.0);
    assert!((first / quarter - 1.0).abs() < 1e-9, "{first} {quarter}");
    assert_eq!(motion.first_time(Swing::PHI, 1.0), None);
}

/// `h = 1 - g t^2/2` reaches the floor at `sqrt(2/g)`, where the speed turns round.
#[test]
fn a_scene_with_events_is_asked_the_same() {
    let motion = Fall::default().run().unwrap();
    let [bounce] = motion.events() else {
        panic!("{} events", motion.events().len());
    };
    let time = (2.0_f64 / 9.81).sqrt();
    assert!((bounce.time - time).abs() < 1e-14);
    let speed = motion.at(time + 1e-9)[Fall::DOT_H];
    assert!((speed - 0.8 * 9.81 * time).abs() < 1e-7, "{speed}");
}

/// The amplitude of a shaken mass is that of every textbook.
#[test]
fn a_steady_state_is_asked_the_same() {
    let motion = Steady::default().run().unwrap();
    let exact = 1.0 / (9.0_f64 - 4.0).hypot(0.2 * 2.0);
    let found = motion.extremes(&[Steady::X], (0.0, TAU)).pop().unwrap();
    assert!((found.highest.value - exact).abs() < 1e-10, "{found:?}");
    assert!((motion.length().unwrap() - 0.5 * TAU).abs() < 1e-14);
    // It goes on for ever.
    let [now, later] = [0.3, 0.3 + motion.length().unwrap()].map(|time| motion.at(time));
    assert!((now[Steady::X] - later[Steady::X]).abs() < 1e-15);
    assert_eq!(motion.multipliers().len(), 2);
}

/// What the error is said to be covers what it is, and is not far above it.
#[test]
fn errors_are_estimated() {
    let settings = Settings::new(Method::Dop853).rtol(1e-7);
    let motion = Swing::default().solve(&settings).unwrap();
    let said = motion.estimated_error("phi").unwrap();
    let fine = Swing::default().solve(&Settings::new(Method::Dop853).rtol(1e-13)).unwrap();
    let times = (0..=400).map(|index| 0.01 * f64::from(index));
    let off = times.map(|time| {
        let [a, b] = [&motion, &fine].map(|motion| motion.at(time)[Swing::PHI]);
        (a - b).abs()
    });
    let off = off.fold(0.0, f64::max);
    assert!(off > 1e-10 && said > 0.5 * off && said < 20.0 * off, "{said:e} {off:e}");
}

#[test]
fn what_makes_no_sense_is_an_error_that_says_what_does() {
    let refused = Swing { l: 20.0, ..Swing::default() }.run();
    let Err(error @ Error::Refused(_)) = refused else {
        panic!("it is accepted");
    };
    assert_eq!(error.to_string(), "l: found 20 m, expected 0.1 m to 10 m");
    let motion = Swing::default().run().unwrap();
    let unknown = motion.value("push", 1.0).unwrap_err().to_string();
    assert_eq!(unknown, "there is no `push`; there are phi, dot(phi), pull");
    let unknown = motion.measure("push").unwrap_err().to_string();
    assert_eq!(unknown, "there is no `push`; there are pull_most");
    let backwards = Fall::default().ask().until(-1.0).run();
    assert!(matches!(backwards, Err(Error::Stopped(_))));
    let wrong = Swing::default().from([0.1]).run().unwrap_err().to_string();
    assert!(wrong.contains("1 values are given for 2 states"), "{wrong}");
}

/// `s = r cos(phi) + sqrt(l^2 - r^2 sin^2(phi))`, and its derivative by the crank times its error.
#[test]
fn a_linkage_is_swept_and_made() {
    let turn = Turn::default();
    let exact = |r: f64, phi: f64| r * phi.cos() + (0.04 - (r * phi.sin()).powi(2)).sqrt();
    let sweep = turn.sweep(0.0..=TAU, 73).unwrap();
    let stroke = sweep.output("stroke").unwrap();
    assert_eq!(stroke.len(), 73);
    for (phi, found) in stroke {
        assert!((found - exact(0.05, phi) + 0.15).abs() < 1e-15, "{phi}: {found}");
    }
    assert_eq!(sweep.values(Turn::STROKE), sweep.output("stroke").unwrap());
    let unknown = sweep.output("lift").unwrap_err().to_string();
    assert_eq!(unknown, "there is no `lift`; there are stroke, theta, s");
    // The tolerance is three standard deviations.
    let made = turn.tolerance("stroke").at("phi", 1.0).monte_carlo(100_000).unwrap();
    let slope = (exact(0.05 + 1e-7, 1.0) - exact(0.05 - 1e-7, 1.0)) / 2e-7;
    let (found, wanted) = (made.places[0].deviation.value, slope * 1e-4 / 3.0);
    assert!((found / wanted - 1.0).abs() < 0.01, "{found} {wanted}");
    let missing = turn.tolerance("stroke").at("psi", 1.0).monte_carlo(100);
    assert!(missing.unwrap_err().to_string().contains("there is no `psi`; there are phi"));
}

/// That of a disturbance that dies away is far below the rounding of the matrix it is found of, and told no better.
#[test]
fn a_measure_of_a_multiplier_errs_as_the_multiplier_does() {
    let steady = Steady { d: 20.0, ..Steady::default() };
    let motion = steady.solve(&Settings::new(Method::Dop853).rtol(1e-10)).unwrap();
    let [largest, _] = motion.multipliers() else { panic!("{:?}", motion.multipliers()) };
    let measures = motion.measures();
    let errors = motion.estimate().unwrap().measures(&motion, &measures);
    assert_eq!(measures[0], Ok(largest.modulus()));
    assert!(largest.error > 0.0 && errors[0] >= largest.error, "{largest:?} {errors:?}");
    assert!(errors[1] >= 2.0 * largest.error.min(motion.multipliers()[1].error), "{errors:?}");
}
