//! Friction by the forces of closures: both are found together.

use assur::answer::Motion;
use assur::prelude::*;

/// A slider-crank whose slide rubs, or is pulled by a share of its side force.
mod slide {
    assur::mechanism! {
        Slide from "made up";
        parameter r = 40 mm, l = 140 mm, J = 2e-3 [kg*m^2], m = 0.5 kg, J_r = 1e-3 [kg*m^2], mu = 0.2 in 0 .. 100, T = 1 [N*m];
        coordinate theta: rad = 0.3 rad, rate = 10 [rad/s];
        dependent psi ~ -10 deg, x ~ 170 mm;
        closure pin: r*dir(theta) + l*dir(psi) = [x, 0];
        kinetic J*dot(theta)^2/2 + m*dot(x)^2/2 + J_r*dot(psi)^2/2;
        force T on theta;
        effect friction { force -mu*abs(reaction(pin).y)*sign(dot(x)) on x; }
        effect share { force mu*reaction(pin).y on x; }
        output pin = reaction(pin) [N], a = ddot(theta), x, v = dot(x), ddot(x), P = T*dot(theta) - mu*abs(reaction(pin).y)*abs(dot(x)) [W], E = energy(kinetic);
        measure work = total(P);
        scene runs = friction { run time 0 s .. 0.2 s; }
        scene pulled = share { run time 0 s .. 0.01 s; }
    }
}

/// The same slide, moved by a drive.
mod drive {
    assur::mechanism! {
        Drive from "made up";
        parameter r = 40 mm, l = 140 mm, m = 0.5 kg, mu = 0.2, w = 10 [rad/s];
        driver theta = w*time in 0 deg .. 360 deg;
        dependent psi ~ -10 deg, x ~ 170 mm;
        closure pin: r*dir(theta) + l*dir(psi) = [x, 0];
        kinetic m*dot(x)^2/2;
        force -100 N - mu*abs(reaction(pin).y)*sign(dot(x)) on x;
        output M = effort(theta) [N m], pin = reaction(pin) [N], v = dot(x);
        scene turn { sweep theta; }
    }
}

/// A pendulum whose pin rubs: reduced, and with all positions as coordinates.
mod pendulum {
    assur::mechanism! {
        Pendulum from "made up";
        parameter l = 0.3 m, m = 2 kg, J = 0.05 [kg*m^2], mu = 0.3, r = 20 mm, g = 9.81 [m/s^2];
        coordinate phi: rad = 0.5 rad, rate = -2 [rad/s];
        dependent x ~ 0.3 m, y ~ 0.1 m;
        closure pin: [x, y] = l*dir(phi);
        kinetic m*(dot(x)^2 + dot(y)^2)/2 + J*dot(phi)^2/2;
        potential m*g*y;
        force -mu*r*norm(reaction(pin))*sign(dot(phi)) on phi;
        output x, pin = reaction(pin) [N], a = ddot(phi);
        scene swings { run time 0 s .. 0.4 s; }
    }
}

mod held {
    assur::mechanism! {
        Held from "made up";
        parameter l = 0.3 m, m = 2 kg, J = 0.05 [kg*m^2], mu = 0.3, r = 20 mm, g = 9.81 [m/s^2];
        coordinate phi: rad = 0.5 rad, rate = -2 [rad/s], x: m = 0.3*cos(0.5)*(1 m), y: m = 0.3*sin(0.5)*(1 m);
        kinetic m*(dot(x)^2 + dot(y)^2)/2 + J*dot(phi)^2/2;
        potential m*g*y;
        // What binds in a mode has no closed form.
        mode hangs {
            closure pin: [x, y] = l*dir(phi);
            force -mu*r*norm(reaction(pin))*sign(dot(phi)) on phi;
            when tears: norm(reaction(pin)) - 1 kN rises -> flies;
        }
        mode flies { }
        output x, a = ddot(phi);
        scene swings { run time 0 s .. 0.4 s; start hangs; start dot(x) = 0.3*sin(0.5)*(2 [m/s]), dot(y) = -0.3*cos(0.5)*(2 [m/s]); }
    }
}

const FINE: Settings = Settings::new(Method::Dop853).rtol(1e-11);

#[track_caller]
fn check(motion: &Motion, time: f64, name: &str, expected: f64, permitted: f64) {
    let found = motion.value(name, time).expect("it is reported");
    assert!((found - expected).abs() <= permitted, "{name}: {found}, expected {expected}");
}

/// By mpmath with 30 digits: accelerations and forces together.
#[test]
fn forces_and_friction_agree() {
    let runs = slide::Runs::default().solve(&FINE).expect("it runs");
    check(&runs, 0.0, "a", 439.694_477_905_194_2, 1e-11);
    check(&runs, 0.0, "pin.x", 5.960_865_825_439_085, 1e-13);
    check(&runs, 0.0, "pin.y", -1.312_333_212_848_918, 1e-13);
    let swings = pendulum::Swings::default().solve(&FINE).expect("it swings");
    check(&swings, 0.0, "a", -22.249_700_752_378_16, 1e-12);
    check(&swings, 0.0, "pin.x", 4.294_046_711_657_849, 1e-13);
    check(&swings, 0.0, "pin.y", 6.753_809_074_810_206, 1e-13);
}

/// Friction by the forces of a motion without it, the naive way, takes too little or too much away.
#[test]
fn what_friction_takes_is_what_is_missing() {
    let runs = slide::Runs::default().solve(&FINE).expect("it runs");
    let gained =
        runs.value("E", 0.2).expect("at the end") - runs.value("E", 0.0).expect("at the start");
    let work = runs.measure("work").expect("of the whole run");
    assert!((gained - work).abs() < 1e-7 * work, "{gained} {work}");
    let free = slide::Runs { mu: 0.0, ..Default::default() };
    let free = free.solve(&FINE).expect("it runs");
    let naive = 0.2 * free.value("pin.y", 0.0).expect("a force").abs();
    let lost = 0.2 * runs.value("pin.y", 0.0).expect("a force").abs();
    assert!((naive / lost - 1.0).abs() > 0.01, "{naive} {lost}");
}

#[test]
fn all_positions_as_coordinates_give_the_same() {
    let reduced = pendulum::Swings::default().solve(&FINE).expect("it swings");
    let held = held::Swings::default().solve(&FINE).expect("it swings");
    for part in 0..=8 {
        let time = 0.05 * f64::from(part);
        for (name, permitted) in [("x", 1e-9), ("a", 1e-7)] {
            check(&held, time, name, reduced.value(name, time).expect("it is reported"), permitted);
        }
    }
}

/// Of a slider-crank with a massless rod the force along the slide is `S = (-100 N - m a)/(1 + μ tan ψ sign(N) sign(v))`, and
/// `N = S tan ψ`.
#[test]
fn a_drive_takes_what_rubs_as_well() {
    let turn = drive::Turn::default().sweep(0.1..=3.0, 30).expect("it turns");
    for (theta, found) in turn.output("pin.y").expect("a force") {
        let (r, l, m, w, mu) = (0.04, 0.14, 0.5, 10.0, 0.2);
        let psi = -(r / l * f64::sin(theta)).asin();
        let rate = -r * theta.cos() * w / (l * psi.cos());
        let turned = (r * theta.sin() * w * w + l * psi.sin() * rate * rate) / (l * psi.cos());
        let a = -r * theta.cos() * w * w - l * psi.sin() * turned - l * psi.cos() * rate * rate;
        let v = -r * theta.sin() * w - l * psi.sin() * rate;
        let free = -100.0 - m * a;
        let side = (free * psi.tan()).signum();
        let expected = free / (1.0 + mu * psi.tan() * side * v.signum()) * psi.tan();
        assert!((found - expected).abs() < 1e-12 * free.abs(), "{theta}: {found} {expected}");
    }
}

/// With too much friction no force, or several, agree with what they make: a motion there is has forces that agree, and
/// where none do there is no number.
#[test]
fn where_nothing_agrees_there_is_no_number() {
    let mut stuck = 0;
    for step in 0..40 {
        let (theta, mu) = (0.4 + 0.14 * f64::from(step), 0.2 * 1.17_f64.powi(step));
        let scene = slide::Runs { mu, ..Default::default() };
        let Ok(motion) = scene.from([theta, 10.0]).until(1e-6).run() else {
            stuck += 1;
            continue;
        };
        let value = |name| motion.value(name, 0.0).expect("it is reported");
        let rubs = mu * value("pin.y").abs() * value("v").signum();
        let left = 0.5 * value("ddot(x)") + value("pin.x") + rubs;
        assert!(left.abs() < 1e-8 * rubs.abs().max(1.0), "{theta} {mu}: {left:e}");
    }
    assert!((1..20).contains(&stuck), "{stuck}");
}
