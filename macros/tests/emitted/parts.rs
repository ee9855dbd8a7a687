//! Parts of parts, in files of their own.

use super::{check, outputs, rate};

assur::mechanism! {
    /// A mass between springs.
    Hung from "made up";
    parameter m = 2 kg, pair_first_k = 7 [N/m];
    coordinate y: m = 0.1 m;
    part pair: Pair from "parts/pair.eqn" { x = y; }
    motion fall: m*ddot(y) = -pair.force - pair_first_k*y;
    output pair.force, pair.first.stiffness(y);
    scene free {}
    scene damped = pair.second.damping {}
}

#[test]
fn parts_of_parts_are_solved_with_the_whole() {
    let state = [0.1, 0.2];
    let second = 8.0 * 0.2 + 5.0 * 0.2_f64.powi(3);
    let force = 3.0 * 0.1 + 2.0 * second;
    check(&rate::<Free>(0.0, &state), &[0.2, -(force + 0.7) / 2.0]);
    check(&outputs::<Free>(0.0, &state), &[force, 3.0]);
    let damped = force + 2.0 * 0.5 * 0.4;
    check(&outputs::<Damped>(0.0, &state), &[damped, 3.0]);
}

#[test]
fn names_of_parts_are_names_in_rust() {
    let hung = Damped {
        m: 1.0,
        pair_second_k: 9.0,
        pair_second_c: 1.0,
        ..Damped::default()
    };
    let names = Damped::CONSTANTS.iter().map(|one| one.quantity.name);
    let expected = [
        "m",
        "pair_first_k",
        "pair.first.k",
        "pair.first.k3",
        "pair.second.k",
        "pair.second.k3",
        "pair.second.c",
    ];
    assert_eq!(names.collect::<Vec<_>>(), expected);
    check(&hung.values(), &[1.0, 7.0, 3.0, 0.0, 9.0, 5.0, 1.0]);
    assert_eq!(MECHANISM.effects[1].name, "pair.second.damping");
}
