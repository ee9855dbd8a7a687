//! Sections 4.1 to 4.5 of the specification.

use super::*;

/// A case with a closed form. Angles, speeds and accelerations to nine digits, the start of the table to 1e-12 s.
#[track_caller]
fn check<C: Drive>(name: &str) -> Moved<C> {
    let case = case("closed", name);
    let moved = Moved::<C>::of(drive(case), 0.1);
    check_events(&moved, case, 1e-12);
    check_samples(&moved, case, 1e-9);
    moved
}

#[test]
fn winding_under_the_transient_torque() {
    check::<Blocked>("blocked");
    check::<Blocked>("blocked_soft");
}

/// 4.2, at a distance from resonance, beside it where two large terms cancel, and at it.
#[test]
fn winding_without_damping_and_decay() {
    check::<Blocked>("blocked_undamped");
    check::<Blocked>("blocked_nearly_resonant");
    check::<Blocked>("blocked_resonant");
}

/// `delta = k`: the closed form divides by zero, the motion is as smooth as any.
#[test]
fn winding_with_critical_damping() {
    check::<Blocked>("blocked_critical");
}

#[test]
fn run_up_of_both_tables() {
    check::<Table1>("table_1");
    check::<Table2>("table_2");
}

/// A pair of complex roots: weak damping. And so much of it that winding does not swing.
#[test]
fn run_up_with_other_damping() {
    check::<Printed>("printed");
    check::<Table1>("undamped");
    check::<Table1>("overdamped");
}

/// Two roots of (19) coincide: the closed form has no coefficients, the exponential of the matrix has.
#[test]
fn run_up_with_a_double_root() {
    check::<Table1>("double_root");
}

#[test]
fn run_up_that_begins_with_the_full_torque() {
    check::<Full>("full");
    check::<Full>("full_table_2");
}

#[test]
fn run_up_under_constant_torque() {
    let moved = check::<Constant>("constant");
    let Constant { J1, J2, Mc, Ms, .. } = moved.drive;
    let late = moved.output("ddot(phi2)", 0.1);
    assert!((late / ((Ms - Mc) / (J1 + J2)) - 1.0).abs() < 1e-9, "{late}");
}

/// When the table starts under the transient torque, `t ~ Mc^(1/4)`: over twelve powers of ten of the resistance.
#[test]
fn start_under_the_transient_torque() {
    for exponent in [0, -2, -4, -6, -8, -10, -12] {
        let case = case("closed", &format!("starts_at_1e{exponent}"));
        let moved = Moved::<Switched>::of(drive(case), 0.01);
        let found = moved.event("run");
        let (time, speed) = (number(&case["events"][0]["time"]), number(&case["speed"]));
        let off = (found.time - time).abs();
        assert!(off < 1e-12, "1e{exponent}: off by {off:e} s");
        let off = (found.before[2] / speed - 1.0).abs();
        assert!(off < 1e-7, "1e{exponent}: {off:e} of the speed");
        let leading = number(&case["leading"]) / time - 1.0;
        assert!(leading.abs() < 2.0 * 1e-4_f64.max(1e3 * time), "1e{exponent}: {leading}");
    }
}

#[test]
fn contact_through_the_clearance() {
    let case = case("closed", "contact");
    let moved = Moved::<Loose>::of(drive(case), 0.01);
    let found = moved.event("wind");
    assert!((found.time - number(&case["events"][0]["time"])).abs() < 1e-12);
    assert!((found.before[2] / number(&case["speed"]) - 1.0).abs() < 1e-12);
}

/// A table of a millionth of the motor's inertia: the motion of one mass.
#[test]
fn light_table_follows_the_motor() {
    let moved = check::<Table1>("light_table");
    let Table1 { J1, Mc, Ms, omega, .. } = moved.drive;
    let (alpha, tau) = (omega * (1.0 - Mc / Ms), omega * J1 / Ms);
    for time in [0.01, 0.02, 0.05] {
        let found = moved.output("dot(phi2)", time) / (alpha * (1.0 - (-time / tau).exp())) - 1.0;
        assert!(found.abs() < 0.03, "{found}");
    }
}

/// A link of ten thousand times the stiffness: the rigid limit 4.5.
#[test]
fn stiff_link_is_the_rigid_limit() {
    let moved = check::<Table1>("stiff");
    let Table1 { J1, J2, Mc, Ms, omega, .. } = moved.drive;
    let (alpha, tau) = (omega * (1.0 - Mc / Ms), omega * (J1 + J2) / Ms);
    for time in [0.005, 0.02, 0.05] {
        let found = moved.output("dot(phi2)", time) / (alpha * (1.0 - (-time / tau).exp())) - 1.0;
        assert!(found.abs() < 2e-4, "{found}");
    }
}
