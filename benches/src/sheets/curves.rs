//! Curves through a thousand points, evenly apart and not.

assur::mechanism! {
    /// Curves through a thousand points, and their slopes.
    Curves from "the benchmark of tables";

    /// Where they are looked up.
    parameter x = 0.5 in 0 .. 0.999;

    let even = table("even.csv", x);
    let uneven = table("uneven.csv", x);
    output even, even_slope = diff(even, x), uneven, uneven_slope = diff(uneven, x);

    scene even { sweep x 0 .. 0.999; output even; }
    scene even_slope { sweep x 0 .. 0.999; output even_slope; }
    scene even_both { sweep x 0 .. 0.999; output even, even_slope; }
    scene uneven { sweep x 0 .. 0.999; output uneven; }
    scene uneven_slope { sweep x 0 .. 0.999; output uneven_slope; }
    scene uneven_both { sweep x 0 .. 0.999; output uneven, uneven_slope; }
}
