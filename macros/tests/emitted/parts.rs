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
    let hung = Damped { m: 1.0, pair_second_k: 9.0, pair_second_c: 1.0, ..Damped::default() };
    let names = Damped::shape().constants.iter().map(|one| one.quantity.name);
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

/// Each part closes its own loop, driven from the whole.
mod linkage {
    assur::mechanism! {
        /// Two rockers on one shaft, one a quarter of a turn behind the other.
        Shaker from "made up";
        dimension r = 20 mm;
        driver theta ~ 90 deg in 0 deg .. 360 deg;
        part left: CrankRocker from "parts/crank_rocker.eqn" { phi = theta; }
        part right: CrankRocker from "parts/crank_rocker.eqn" {
            phi = theta - 90 deg;
            l3 = 3*r;
            psi ~ 78 deg;
            gamma ~ 50 deg;
        }
        link left.B - right.B;
        output left.angle, right.angle, diff(left.psi, left.l1) [rad/mm], apart = left.B.x - right.B.x;
        expect at theta = 90 deg: left.angle = 105.64517 deg +- 5e-6 deg;
        expect at theta = 180 deg: right.angle = 105.64517 deg +- 5e-6 deg;
        expect at theta = 90 deg: diff(left.psi, left.l1) = -6.10 [rad/m] +- 0.01 [rad/m];
    }

    #[test]
    fn points_and_links_of_parts_are_drawn() {
        let linkage = MECHANISM.scenes[0].linkage.expect("it closes loops");
        let shape = Shaker::shape();
        assert_eq!(shape.points.len(), 8);
        assert_eq!(shape.links.len(), 7);
        assert_eq!(shape.links[6].points, [2, 6]);
        assert_eq!(linkage.loops[0].name, "left.loop.x");
        let constants = Shaker::shape().constants.iter().map(|one| one.quantity.name);
        let all =
            ["r", "left.l1", "left.l2", "left.l3", "left.a", "right.l1", "right.l2", "right.a"];
        assert_eq!(constants.collect::<Vec<_>>(), all);
    }
}
