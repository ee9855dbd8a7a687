//! A scene with an event for what would not see it.
assur::mechanism! {
    /// A ball that falls onto a floor and comes back.
    Ball from "made up";
    parameter g = 9.81 [m/s^2], e = 0.8;
    coordinate h: m = 1 m;
    motion ddot(h) = -g;
    when h falls { set dot(h) = -e*dot(h); }
    scene fall { run time 0 s .. 1 s; }
}

fn main() {
    let settings = assur::answer::Settings::default();
    let _ = assur::ode::march(&Fall::default(), (0.0, 1.0), &[1.0, 0.0], &settings);
}
