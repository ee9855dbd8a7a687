//! First-order states beside coordinates.

use super::{check, names, rate};

assur::mechanism! {
    /// A motor whose current needs time to rise.
    Motor from "any textbook";
    parameter J = 0.01 [kg m^2], k = 0.5 [N m/A], r = 2 [V/A], L = 0.1 [V s/A], u = 24 V;
    coordinate angle: rad = 0;
    state current: A = 0;
    motion shaft: J*ddot(angle) = k*current;
    motion circuit: L*dot(current) = u - r*current - k*dot(angle);
    scene starting { run time 0 s .. 1 s; }
}

#[test]
fn current_and_speed_drive_each_other() {
    assert_eq!(names::<Starting>(), ["angle", "dot(angle)", "current"]);
    let rate = rate::<Starting>(0.0, &[0.3, 8.0, 2.0]);
    check(&rate, &[8.0, 100.0, (24.0 - 4.0 - 4.0) / 0.1]);
}
