//! Names of equations.

use super::{check, compiled, mistakes};

/// Three rockers on one crank, each closed by a loop of its own.
const LEGS: &str = "Sample; dimension r = 20 mm, l = 90 mm, c = 60 mm, a = 80 mm; driver phi ~ 90 deg in 0 deg .. 360 deg; \
                    for k in 1..3 { dependent gamma[k] ~ 20 deg, psi[k] ~ 100 deg; \
                    closure leg[k]: r*dir(phi + k*(120 deg)) + l*dir(gamma[k]) = [a, 0] + c*dir(psi[k]); } \
                    output psi[1], psi[2], psi[3]; ";

/// The equations of the first scene of a file without mistakes.
#[track_caller]
fn equations(text: &str) -> Vec<String> {
    let (compiled, _) = compiled(text);
    assert!(
        mistakes(&compiled).is_empty(),
        "{:#?}",
        compiled.diagnostics
    );
    let scene = compiled.model.unwrap().scenes.remove(0);
    let linkage = scene.linkage.map(|linkage| linkage.loops);
    let of_linkage = linkage.into_iter().flatten().map(|one| one.name);
    of_linkage
        .chain(scene.equations.into_iter().map(|one| one.text))
        .collect()
}

#[test]
fn each_closure_of_a_repetition_has_a_name_of_its_own() {
    let found = equations(LEGS);
    assert_eq!(
        found[..6],
        [
            "leg[1].x", "leg[1].y", "leg[2].x", "leg[2].y", "leg[3].x", "leg[3].y"
        ]
    );
    assert!(found[6].starts_with("closure leg[1]: "), "{found:?}");
}

#[test]
fn the_index_of_a_name_is_computed() {
    let found = equations(
        "Sample; parameter m = 2 kg; coordinate x[2]: m = 0, x[3]: m = 0; \
         for k in 1..2 { motion mass[k + 1]: m*ddot(x[k + 1]) = 1 N; } \
         output x[2]; scene go { run time 0 s .. 1 s; }",
    );
    assert!(found[0].starts_with("motion mass[2]: "), "{found:?}");
    // A bracket after a name begins a term as well.
    let found = equations(
        "Sample; parameter m = 2 kg; coordinate x[2]: m = 0; \
         motion ddot(x[2])*m = 1 N; output x[2]; scene go { run time 0 s .. 1 s; }",
    );
    assert!(found[0].starts_with("motion ddot(x[2])"), "{found:?}");
}

#[test]
fn the_index_of_a_name_is_a_whole_number() {
    let text = LEGS.replace("leg[k]:", "leg[k/2]:");
    check(
        &text,
        &[(
            "has to be a whole number",
            "k/2",
            "the index of a `for` or `sum`",
        )],
    );
}
