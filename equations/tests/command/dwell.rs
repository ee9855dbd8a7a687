//! The hard cases of the dwell six-bar (`sewing_feed.md`, section 4), as whoever seeks one by hand meets them.
//!
//! | case | test |
//! |---|---|
//! | the dyad does not close on a short arc | `a_short_arc_that_a_grid_misses` |
//! | Grashof's border | `assembly_modes_meet_at_the_border_of_grashof` |
//! | dead centre of the dyad | `at_its_dead_centre_both_modes_of_the_dyad_meet` |
//! | angles that wrap | `a_turn_more_is_no_deviation` |
//! | rack out of reach, no dwell, no rise, no stitch | `paths_that_make_no_sense_or_just_some` |
//! | both assembly modes | `solving_for_the_dyad_finds_as_good_ones` |
//! | roots at infinity, double ones, `L6^2 < 0`, singular inner problem | `solvers/src/synthesis/fit/tests.rs` |

use serde_json::Value;

use super::{answer, folder, run};

fn file() -> String {
    format!("{}/../examples/synthesis/dwell_six_bar.eqn", env!("CARGO_MANIFEST_DIR"))
}

/// Exit code and both outputs.
fn said(scene: &str, set: &[&str]) -> (Option<i32>, String) {
    let file = file();
    let mut all = vec!["run", file.as_str(), "--scene", scene];
    all.extend(set.iter().flat_map(|one| ["--set", *one]));
    let output =
        run(&all, &folder(&format!("dwell_{scene}_{}", set.join("_").replace(['=', '.'], "_"))));
    let texts =
        [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (output.status.code(), texts.concat())
}

/// The distance of the joints C and O3 for the dimensions of the file, mm.
fn apart(degrees: f64) -> f64 {
    let (l1, l2, l3, l4, eta, phi) = (9.0, 76.0, 81.0, 81.0, 0.9_f64, 0.6 + degrees.to_radians());
    let [ax, ay] = [l1 * phi.cos(), l1 * phi.sin()];
    let [dx, dy] = [l4 * eta.cos() - ax, l4 * eta.sin() - ay];
    let d = dx.hypot(dy);
    let (s, c) = (dy.atan2(dx) - ((l2 * l2 + d * d - l3 * l3) / (2.0 * l2 * d)).acos()).sin_cos();
    (ax + 40.0 * c - 30.0 * s - 36.0).hypot(ay + 40.0 * s + 30.0 * c - 96.0)
}

#[test]
fn a_short_arc_that_a_grid_misses() {
    // At none of 72 places is the dyad too short, and yet it is for two degrees.
    let reach = 60.0 + 17.7508;
    assert!((0..72).all(|place| apart(5.0 * f64::from(place) - 180.0) < reach));
    assert!(apart(-141.323) > reach);
    let (code, text) = said("best", &["L7=17.7508mm"]);
    assert_eq!(code, Some(1), "{text}");
    assert!(
        text.contains("dead point at phi = -140.402 deg") && text.contains("bar.dyad"),
        "{text}"
    );
}

#[test]
fn assembly_modes_meet_at_the_border_of_grashof() {
    let (code, text) = said("turn", &["L1=10mm", "L2=50mm", "L3=60mm", "L4=100mm"]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("change point of bar.four_bar"), "{text}");
}

#[test]
fn at_its_dead_centre_both_modes_of_the_dyad_meet() {
    // It just reaches, to the last digit: the loop is closed on either mode there, and that is told.
    let (code, text) = said("best", &["L7=17.75128833953924mm"]);
    assert_eq!(code, Some(0), "{text}");
    assert!(text.contains("change point of bar.dyad"), "{text}");
}

#[test]
fn a_turn_more_is_no_deviation() {
    let off = |set: &[&str]| {
        let file = file();
        let mut all = vec!["run", file.as_str(), "--scene", "turn", "--format", "json"];
        all.extend(set.iter().flat_map(|one| ["--set", *one]));
        let json: Value =
            serde_json::from_str(&answer(&all, &folder("dwell_wrap"))).expect("one object");
        json["measures"][0]["value"].as_f64().expect("a number")
    };
    let (once, again) = (off(&["psi0=2.9rad"]), off(&["psi0=9.183185307179586rad"]));
    assert!((once - again).abs() < 1e-9 && once < 180.0, "{once} {again}");
}

#[test]
fn paths_that_make_no_sense_or_just_some() {
    let (code, text) = said("turn", &["wanted.p_x=6mm", "wanted.T=10mm", "wanted.b_x=60mm"]);
    assert_eq!(code, Some(1), "{text}");
    assert!(
        text.contains("dead point at phi = -29.8541 deg") && text.contains("wanted.lift"),
        "{text}"
    );
    let (code, text) = said("turn", &["wanted.phi_v=120deg"]);
    assert_eq!(code, Some(2), "{text}");
    assert!(text.contains("expected wanted.phi_v < wanted.phi_p"), "{text}");
    for set in ["wanted.p_pl=0mm", "wanted.T=0mm"] {
        let (code, text) = said("turn", &[set]);
        assert_eq!(code, Some(0), "{set}: {text}");
    }
}

/// Joint C, rod and rocker follow from where the rocker has to be: few designs lead to a good one.
#[test]
fn solving_for_the_dyad_finds_as_good_ones() {
    let file = file();
    let effort =
        ["--scene", "fitted", "--evaluations", "96", "--searches", "1", "--format", "json"];
    let all = [&["synth", file.as_str()], &effort[..]].concat();
    let found: Value =
        serde_json::from_str(&answer(&all, &folder("dwell_fitted"))).expect("one object");
    assert_eq!(found["solved"]["values"], 4);
    let best = &found["designs"][0];
    assert!(
        best["keeps"] == true && best["worth"].as_f64().is_some_and(|worth| worth < 0.2),
        "{best}"
    );
}
