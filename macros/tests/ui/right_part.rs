//! A mechanism inside Rust with a part in another folder, which has parts itself.
assur::mechanism! {
    /// A mass between springs.
    Hung from "made up";
    parameter m = 2 kg;
    coordinate y: m = 0.1 m;
    part pair: Pair from "../emitted/parts/pair.eqn" { x = y; }
    motion fall: m*ddot(y) = -pair.force;
    output y;
}
