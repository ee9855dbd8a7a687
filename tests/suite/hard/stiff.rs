//! A mass on a spring that is ever stiffer, up to the rigid limit, beside the explicit method.

use assur::prelude::*;

use crate::stability::{Row, told};

assur::mechanism! {
    /// A mass that a spring and a damper tie to a support, which moves to and fro. With a rigid spring it goes where that goes.
    Tied from "made up";
    parameter m = 1 kg, c = 1e3 [N/m] in 0 [N/m] .. 1e15 [N/m], L = 1 m, w = 1 [rad/s];
    coordinate x: m = 0, rate = 1 [m/s];
    let s = L*sin(w*time);
    motion newton: m*ddot(x) + c*(x - s) + c*1e-3 s*(dot(x) - dot(s)) = 0;
    output x;
    scene follow { run time 0 s .. 10 s; }
}

#[test]
fn a_spring_may_be_rigid() {
    let mut rows = Vec::new();
    for c in [1e3, 1e6, 1e9, 1e12] {
        let scene = Follow { c, ..Follow::default() };
        let limit = Some(400_000);
        let evaluations = |method: Method| {
            let settings = Settings { max_steps: limit, ..Settings::new(method).rtol(1e-8) };
            scene.solve(&settings).map(|motion| {
                let off = (motion.value("x", 10.0).expect("x") - 10.0_f64.sin()).abs();
                (motion.statistics().evaluations, off)
            })
        };
        let (ours, off) = evaluations(Method::Auto).expect("a motion");
        // What inertia leaves of the distance to the support.
        assert!(off < 1.5 / c + 1e-7, "{c:e}: {off:e}");
        assert!(ours < 20_000, "{c:e}: {ours}");
        rows.push((c, evaluations(Method::Dop853).ok().map(|one| one.0), ours, off));
    }
    assert!(rows[3].1.is_none() && rows[1].1.expect("it ends") > 10 * rows[1].2, "{rows:?}");
    let explicit = rows.iter().map(|row| match row.1 {
        Some(count) => count.to_string(),
        None => "not within 400 000 steps".to_owned(),
    });
    let off = rows.iter().map(|row| format!("{:.0e}", row.3));
    let ours = rows.iter().map(|row| row.2.to_string());
    told(&Row {
        case: "Stiffness",
        tried: "a mass on a spring of 1e3, 1e6, 1e9 and 1e12 N/m for ten seconds, rtol 1e-8",
        naive: format!("the explicit method: evaluations {}", listed(explicit)),
        ours: format!(
            "the method that changes on the way: off the rigid limit by {} m",
            listed(off)
        ),
        cost: format!("evaluations {}", listed(ours)),
    });
}

fn listed(texts: impl Iterator<Item = String>) -> String {
    texts.collect::<Vec<_>>().join(", ")
}
