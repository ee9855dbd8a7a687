//! Names that mean something to Rust or to the printer.

use super::{check, outputs, rate};

assur::mechanism! {
    /// A mechanism whose author thinks in other words than Rust.
    Names from "made up";
    parameter type = 2 kg, S = 1 m, values = 3 [1/s^2], None = 1, K = 1, state = 5 [1/s^2], f64 = 2;
    parameter rate = 1, instant = 1, columns = 1, MECHANISM = 1, value = 1, core = 1, assur = 1;
    coordinate φ2: rad = 0.1, r#loop: m = 0;
    let ω = dot(φ2);
    let fn = values*φ2*None*K;
    motion first: ddot(φ2) = -fn - state*φ2*f64*instant;
    motion second: type*ddot(loop) = -2 kg*values*(loop - S*sin(φ2)*columns)*rate*MECHANISM*value*core*assur;
    output ω, match = loop + S, where = fn;
    scene default { run time 0 s .. 1 s; }
    scene clone { run time 0 s .. 1 s; }
    scene some { run time 0 s .. 1 s; }
}

#[test]
fn names_keep_their_meaning() {
    let names = Default::default();
    check(&[names.r#type, names.None, names.MECHANISM], &[2.0, 1.0, 1.0]);
    let state = [0.1, 0.2, 0.3, 0.4];
    let second = -3.0 * (0.2 - 0.1_f64.sin());
    check(&rate::<Default>(0.0, &state), &[0.3, 0.4, -1.3, second]);
    check(&outputs::<Clone>(0.0, &state), &[0.3, 1.2, 0.3]);
    assert_eq!(Some::shape().states[0].name, "φ2");
    assert_eq!(Names::from_values(&names.values()), names);
}
