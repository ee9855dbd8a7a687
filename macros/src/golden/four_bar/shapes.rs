mod shapes_ {
    use ::assur::shape::tables::*;
    const unit_0_: Unit = Unit::new("mm", 0.001, [1, 0, 0, 0, 0, 0, 0]);
    const unit_1_: Unit = Unit::new("deg", 0.017453292519943295, [0, 0, 0, 0, 0, 0, 0]);
    const constants_: [Constant; 4] = [
        Constant::dimension(
                Quantity::new(
                    "a",
                    "Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0.",
                    unit_0_,
                ),
                f64::NEG_INFINITY,
                f64::INFINITY,
            )
            .made(2e-5, Distribution::Normal),
        Constant::dimension(
            Quantity::new(
                "b",
                "Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0.",
                unit_0_,
            ),
            f64::NEG_INFINITY,
            f64::INFINITY,
        ),
        Constant::dimension(
            Quantity::new(
                "c",
                "Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0.",
                unit_0_,
            ),
            f64::NEG_INFINITY,
            f64::INFINITY,
        ),
        Constant::dimension(
            Quantity::new(
                "d",
                "Crank A0-A, coupler A-B, rocker B0-B, frame A0-B0.",
                unit_0_,
            ),
            f64::NEG_INFINITY,
            f64::INFINITY,
        ),
    ];
    static list_0_: &[Quantity] = &[Quantity::new("phi", "", unit_1_)];
    static list_1_: &[Quantity] = &[Quantity::new("psi", "", unit_1_)];
    static list_2_: &[Quantity] = &[
        Quantity::new("theta", "", unit_1_),
        Quantity::new("psi", "", unit_1_),
    ];
    pub const Turn: Shape = Shape::named("turn")
        .constants(&Constant::some(&constants_, [0, 1, 2, 3], [0.02, 0.07, 0.05, 0.06]))
        .drivers(list_0_)
        .linear()
        .outputs(list_1_)
        .equations(
            &[
                EquationText::new(
                    10,
                    "closure frame: a*dir(phi) + b*dir(theta) = [d, 0 m] + c*dir(psi)",
                    "m",
                ),
            ],
        )
        .operations(Operations::of([22, 35, 13, 22, 0, 2, 1, 0, 0]))
        .linkage(LinkageEntry {
            dependents: list_2_,
            loops: &[
                Loop::new(10, "frame.x", "m", 1.0),
                Loop::new(10, "frame.y", "m", 1.0),
            ],
            angles: &[true, true],
            cosines: &[Some(2), Some(4)],
            groups: &[
                Group {
                    kind: GroupKind::Rrr,
                    unknowns: &[0, 1],
                    equations: &[0, 1],
                },
            ],
            variables: &[
                Variable::Constant(0),
                Variable::Constant(1),
                Variable::Constant(2),
                Variable::Constant(3),
                Variable::Driver(0),
            ],
            motion: 0,
            second: true,
            tolerances: &[(0.0, Distribution::Normal)],
        });
}
