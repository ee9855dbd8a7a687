//! Mistakes in the file of a part, and where it is bound.
assur::mechanism! {
    /// Two linkages on one shaft.
    Machine from "made up";
    driver theta in 0 deg .. 360 deg;
    part left: FourBar from "four_bar.eqn" {
        phi = theta;
        crank = 20 s;
    }
    part right: FourBar from "fourbar.eqn" { phi = 2*theta; }
    output left.swing, right.swing;
}
