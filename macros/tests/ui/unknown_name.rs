//! A slip of the pen in a name.
assur::mechanism! {
    /// A mass on a spring.
    Oscillator from "any textbook";
    parameter mass = 2 kg, stiffness = 8 [N/m];
    coordinate x: m = 1 m;
    motion free: mass*ddot(x) = -stifness*x;
}

/// What uses the broken mechanism says nothing more.
pub fn use_it() -> Oscillator {
    Oscillator::default()
}
