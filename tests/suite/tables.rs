//! Sampled curves in motions: against SciPy's splines and integration, all methods beside each other, and their hard cases.

use assur::answer::{Method, Settings};
use assur::hybrid::{self, HybridError};
use assur::ode::OdeError;
use assur::scalar::fault;

mod spring {
    assur::mechanism! {
        /// A mass that falls on a measured spring, and one that a measured cam drives by a spring.
        MeasuredSpring from "made up";

        parameter m = 2 kg, c = 500 [N/m], n = 2 [1/s];
        let F(s) = table("tables/spring.csv", s, F);
        let lift(p) = table(p; 0 deg: 0 mm, 60 deg: 3 mm, 120 deg: 10 mm, 180 deg: 12 mm, 250 deg: 7 mm, 300 deg: 2 mm, 360 deg: 0 mm; periodic);

        effect spring "the mass swings on the spring" {
            parameter g = 9.81 [m/s^2];
            coordinate y: mm = 0.5 mm;
            kinetic m*dot(y)^2/2;
            potential integral(F(s), s, 0 mm .. y) - m*g*y;
            output y [mm], F_y = F(y) [N];
        }
        effect cam "the cam drives it" {
            coordinate x: mm = 0 mm;
            kinetic m*dot(x)^2/2;
            potential c*(x - lift(2*pi*n*time))^2/2;
            output x [mm], drive = lift(2*pi*n*time) [mm];
        }
        scene swing = spring { run time 0 .. 0.4 s; }
        scene driven = cam { run time 0 .. 1.3 s; }
        expect scene swing at time = 0.4 s: y = 0.50657930 mm +- 1e-6 mm "scipy.integrate.DOP853 on scipy.interpolate.CubicSpline";
        expect scene driven at time = 1.3 s: x = 14.542036887 mm +- 1e-6 mm "the same";
    }
}

/// By SciPy: DOP853 at rtol 1e-13 with steps of at most 1e-4 s, on its own splines.
const SWING: [f64; 2] = [0.0005065793036227392, -0.009770755850227415];
const DRIVEN: [f64; 2] = [0.014542036887157403, -0.3125730592298509];

#[test]
fn motions_on_tables_are_those_of_other_programs() {
    let swing = spring::Swing::default();
    let driven = spring::Driven::default();
    // At the points the third derivative jumps: a method of high order loses digits there, and says so in its estimate.
    for (method, rtol, within) in
        [(Method::Dop853, 1e-12, 3e-8), (Method::Radau, 1e-10, 1e-9), (Method::Dop853, 1e-6, 1e-3)]
    {
        let settings = Settings::new(method).rtol(rtol);
        let ends = [
            hybrid::march(&swing, (0.0, 0.4), &[0.5e-3, 0.0], &settings).expect("it swings").end,
            hybrid::march(&driven, (0.0, 1.3), &[0.0, 0.0], &settings).expect("it is driven").end,
        ];
        for (end, exact) in ends.iter().zip([SWING, DRIVEN]) {
            for (found, exact) in end.iter().zip(exact) {
                let error = (found - exact).abs() / exact.abs();
                assert!(error < within, "{method:?} {rtol:e}: {found}, not {exact}: {error:e}");
            }
        }
    }
}

/// A spline is no analytic function: a series would go on with one piece beyond its end.
#[test]
fn there_is_no_series_of_a_table() {
    let settings = Settings::new(Method::Taylor).rtol(1e-10);
    let refused = hybrid::march(&spring::Swing::default(), (0.0, 0.4), &[0.5e-3, 0.0], &settings);
    let Err(HybridError::Ode { error: OdeError::BadOption { reason, .. }, .. }) = refused else {
        panic!("{refused:?}")
    };
    assert!(reason.contains("series"), "{reason}");
}

/// Beyond its points the spring is not known: the motion ends there, and says why.
#[test]
fn a_motion_that_leaves_a_table_says_so() {
    let heavy = spring::Swing { m: 20.0, ..spring::Swing::default() };
    fault::take();
    let settings = Settings::new(Method::Dop853).rtol(1e-8);
    let ended = hybrid::march(&heavy, (0.0, 0.4), &[0.5e-3, 0.0], &settings);
    assert!(ended.is_err(), "{ended:?}");
    let told = fault::take().expect("a reason").to_string();
    assert!(
        told.starts_with("`table(\"tables/spring.csv\"") && told.contains("is looked up at"),
        "{told}"
    );
}
