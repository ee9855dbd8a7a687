//! Formula sheets: scenes without any motion, against an independent computation with thirty digits, and their hard cases, each
//! with the naive failure beside it.

use assur::closure::{AtDeadPoint, Axis, Linkage, sweep};
use assur_equations::burnishing::{
    Balance, Influence, Map, Profile, Profile2, Recommended, Roughness, Soft,
};
use assur_equations::gear_flank::Straight;

const MM: f64 = 1e-3;
const UM: f64 = 1e-6;

/// An output of a sheet at a place.
#[track_caller]
fn value<L: Linkage>(sheet: &L, place: &[f64], name: &str) -> f64 {
    let axes: Vec<_> = place.iter().map(|at| Axis { from: *at, to: *at, count: 1 }).collect();
    let values = sweep(sheet, &axes, AtDeadPoint::Stop).expect("values");
    let index = sheet.shape().outputs.iter().position(|one| one.name == name).expect("an output");
    values.outputs(0)[index]
}

#[track_caller]
fn is(found: f64, expected: f64, rtol: f64) {
    let error = (found - expected).abs();
    assert!(error <= rtol * expected.abs(), "{found}, not {expected}: {error:e}");
}

/// Where the feed vanishes the printed area is a product of nothing and infinity.
#[test]
fn burnishing_with_hardly_any_feed() {
    let sheet = Roughness::default();
    let exact = 0.0703826234628539 * MM * MM;
    for (feed, theta) in [(1e-3, 0.03594653174795628), (1e-9, 3.592743366300391e-05)] {
        let at = [feed * MM];
        is(value(&sheet, &at, "A"), exact, 1e-13);
        is(1.0 - value(&sheet, &at, "theta"), theta, 1e-7);
    }
    // The depth that the printed form multiplies with nothing is beyond all bounds.
    let depth = value(&sheet, &[0.0], "h_v").abs();
    assert!(depth.is_nan() || depth > 1e3, "{depth}");
    is(value(&sheet, &[0.0], "A"), exact, 1e-13);
}

/// The slope of the arc cosine is infinite where tracks begin to overlap; beyond, they do not.
#[test]
fn tracks_that_do_not_overlap() {
    let sheet = Roughness::default();
    let limit = 0.31398424307002615 * MM;
    for (feed, theta) in [(limit * (1.0 + 1e-12), 0.0), (0.4 * MM, 0.0)] {
        assert_eq!(value(&sheet, &[feed], "theta"), theta);
        assert!(value(&sheet, &[feed], "overlap") < 0.0);
    }
    assert!(value(&sheet, &[limit * (1.0 - 1e-12)], "theta") > 0.0);
}

#[test]
fn roughness_below_zero_is_no_roughness() {
    // Over the feed the condition is one on the values, which are refused.
    let rougher = Roughness { R_p: 5.2 * UM, ..Roughness::default() };
    assert!(Linkage::check(&rougher).is_err());
    let smooth = Roughness { R_p: 3.0 * UM, ..Roughness::default() };
    assert!(Linkage::check(&smooth).is_ok() && value(&smooth, &[0.1 * MM], "Ra") > 0.0);
    // Over force and radius it is one on what is swept: nothing has a value where it does not hold.
    for (peaks, holds) in [(3.0, true), (8.0, false)] {
        let sheet = Influence { R_p: peaks * UM, ..Influence::default() };
        let [ra, margin] =
            ["Ra", "margin of C > 0 um"].map(|name| value(&sheet, &[100.0, 1.0 * MM], name));
        assert_eq!((margin > 0.0, ra.is_finite()), (holds, holds), "{peaks}: {ra}, {margin}");
    }
}

/// `J` of eq (9) in its singular form against the smooth one, at the cusp and just beside it.
#[test]
fn temperature_at_the_cusp_and_beside_it() {
    let sheet = Profile::default();
    for psi in [1e-6, 0.3, 1.0 - 1e-9, 1.0, 1.0 + 1e-12, 1.0 + 1e-6, 1.3, 3.0] {
        let [singular, smooth] = ["J_psi", "J_psi_smooth"].map(|name| value(&sheet, &[psi], name));
        assert!((singular - smooth).abs() < 2e-14, "{psi}: {singular}, {smooth}");
    }
    let eta = 0.19541340420857245;
    is(value(&sheet, &[1.0], "J_psi"), 1.3705317173341314 - 2.0 * eta, 1e-13);
    // The naive way, the rule of the middle with a thousand parts: half of the first digit's error is left by the singularity.
    let f = |u: f64| ((-3.0 * (1.0 - u) * (1.0 - u)).exp() - eta) / (1.0 - u).sqrt();
    let naive: f64 = (0..1000).map(|index| f((f64::from(index) + 0.5) / 1000.0) / 1000.0).sum();
    assert!((naive - value(&sheet, &[1.0], "J_psi")).abs() > 1e-2, "{naive}");
}

/// With hardly any heat in zone 1 the hottest place lies behind the cusp, where looking at the cusp alone misses it.
#[test]
fn the_hottest_place_may_leave_the_cusp() {
    let sheet = Soft::default();
    is(value(&sheet, &[3.0], "hottest"), 1.14190303735754, 1e-9);
    is(value(&sheet, &[3.0], "J_V"), 2.025735196758485, 1e-12);
    let cusp = Profile2 { k_T: sheet.k_T, ..Profile2::default() };
    assert!(value(&cusp, &[1.0], "J_psi") < 0.9 * 2.025735196758485);
}

#[test]
fn the_inverse_problem() {
    let sheet = Recommended::default();
    for (ra, s) in [(0.5, 0.03445674570867027), (1.0, 0.13110021862999302)] {
        let at = [ra * UM, 300.0];
        is(value(&sheet, &at, "S_adm"), s * MM, 1e-12);
        is(value(&sheet, &at, "S_root"), s * MM, 1e-12);
    }
    for (theta, v) in [(200.0, 0.9241207978795152), (800.0, 8.064251531931331)] {
        is(value(&sheet, &[1.0 * UM, theta], "V_adm"), v, 1e-12);
    }
    // The part is rougher than that without any feed.
    assert!(value(&sheet, &[0.46 * UM, 300.0], "S_adm").is_nan());
    // The feed and the speed give what is permitted.
    let map = Map::default();
    let (s, v) = (0.13110021862999302 * MM, 8.064251531931331);
    is(value(&map, &[s, v], "Ra"), 1.0 * UM, 1e-12);
    is(value(&map, &[s, v], "Theta"), 800.0, 1e-12);
}

#[test]
fn the_other_reading_has_no_influence_of_the_force() {
    let sheet = Balance::default();
    let [a, b] = [50.0, 300.0].map(|force| value(&sheet, &[force], "Ra"));
    is(a, b, 1e-14);
}

/// A head of a kilometre cuts a straight tooth: the error falls as one over its radius, and no digit is lost in large differences.
#[test]
fn a_very_large_head_cuts_a_straight_tooth() {
    let sheet = Straight::default();
    let at = [27f64.to_radians()];
    let near = value(&Straight { R0: 1e3, ..Straight::default() }, &at, "roll");
    let far = value(&Straight { R0: 1e6, ..Straight::default() }, &at, "roll");
    assert!((near - far).abs() < 1e-6 && (value(&sheet, &at, "roll") - far).abs() < 1e-6);
}
