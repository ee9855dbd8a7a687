//! A force and a torque in one equation.
assur::mechanism! {
    /// A mass on a spring.
    Oscillator from "any textbook";
    parameter m = 2 kg, k = 8 [N m];
    coordinate x: m = 1 m;
    motion mass: m*ddot(x) = -k*x;
}
