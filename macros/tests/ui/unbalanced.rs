//! Two coordinates and one equation.
assur::mechanism! {
    /// Two masses, one of them forgotten.
    Masses from "made up";
    parameter m = 2 kg, k = 8 [N/m];
    coordinate x: m = 1 m, y: m = 0 m;
    motion first: m*ddot(x) = -k*(x - y);
}
