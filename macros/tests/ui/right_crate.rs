//! What a user writes, with names that Rust would spell otherwise, in a file of its own and inside Rust.
assur::mechanism! {
    Oscillator from "any textbook";

    parameter m = 2 kg, C_1 = 800 [N/m], φ_0 = 3 deg, type = 3 in 1 .. 4;
    dimension L = 3 m +- 1 mm;
    preset Heavy { m = 4 kg; }
    /// Distance from rest.
    coordinate x: m = 10 mm, ψ: rad = 0;
    state I_q: A = 0;
    driver Ω = 30 rpm*time;
    choice Rod { Short { let z = 1; } very_long { let z = 2; } }
    effect Friction "The slide rubs." { dissipation (1 [N s/m])*dot(x)^2/2; }

    motion dot(I_q)*(1 s) + I_q = 0;
    motion turn: ddot(ψ) + type*dot(ψ)*(1 Hz) = φ_0*(1 [1/s^2]);
    kinetic m*dot(x)^2/2;
    potential C_1*x^2/2;
    force z*(1 N)*sin(Ω) on x, -abs(x)/L*(1 N)*sign(dot(x)) on x;
    when x + 5 mm falls { set dot(x) = -dot(x); }
    measure top = peak(x), F_mean = mean(C_1*x);
    point P = [x, 0], Q = [0, L];
    link P - Q "rod";

    output x, dot(x), F_x = -C_1*x [N], P, diff(x^2, x), I_q, ψ;
    scene swing { run time 0 s .. 1 s; }
    scene Other = Friction + Rod.very_long { preset Heavy; run time 0 s .. 1 s; }
    expect scene swing at run: top = 10 mm +- 100 m;
}

/// An equation file.
pub mod files {
    assur::equations! { "hung.eqn" }
}
