//! A parameter that only another scene has.
assur::mechanism! {
    /// A mass on a spring, with or without friction.
    Oscillator from "any textbook";
    parameter m = 2 kg, k = 8 [N/m];
    coordinate x: m = 1 m;
    kinetic m*dot(x)^2/2;
    potential k*x^2/2;
    effect friction "oil" {
        parameter c = 0.1 [N s/m];
        dissipation c*dot(x)^2/2;
    }
    scene free {}
    scene damped = friction {}
}

/// Sets it all the same.
pub fn set() -> [f64; 2] {
    let damped = Damped { c: 0.2, ..Damped::default() };
    let free = Free { c: 0.2, ..Free::default() };
    [damped.m, free.m]
}
