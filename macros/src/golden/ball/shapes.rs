mod shapes_ {
    use ::assur::shape::tables::*;
    const unit_0_: Unit = Unit::new("kg", 1.0, [0, 1, 0, 0, 0, 0, 0]);
    const unit_1_: Unit = Unit::new("m/s^2", 1.0, [1, 0, -2, 0, 0, 0, 0]);
    const unit_2_: Unit = Unit::new("N/m", 1.0, [0, 1, -2, 0, 0, 0, 0]);
    const unit_3_: Unit = Unit::new("N", 1.0, [1, 1, -2, 0, 0, 0, 0]);
    const unit_4_: Unit = Unit::new("m", 1.0, [1, 0, 0, 0, 0, 0, 0]);
    const unit_5_: Unit = Unit::new("m/s", 1.0, [1, 0, -1, 0, 0, 0, 0]);
    const constants_: [Constant; 3] = [
        Constant::parameter(
            Quantity::new("M", "", unit_0_),
            f64::NEG_INFINITY,
            f64::INFINITY,
        ),
        Constant::parameter(
            Quantity::new("g", "", unit_1_),
            f64::NEG_INFINITY,
            f64::INFINITY,
        ),
        Constant::parameter(
            Quantity::new("k", "Stiffness of the floor.", unit_2_),
            f64::NEG_INFINITY,
            f64::INFINITY,
        ),
    ];
    static list_0_: &[Quantity] = &[Quantity::new("force", "", unit_3_)];
    static list_1_: &[Quantity] = &[
        Quantity::new("h", "", unit_4_),
        Quantity::new("dot(h)", "", unit_5_),
    ];
    pub static Fall: Shape = Shape::named("fall")
        .constants(&Constant::some(&constants_, [0, 1, 2], [1.0, 9.81, 10000.0]))
        .states(list_1_, &[0.001, 0.001])
        .coordinates(1)
        .outputs(list_0_)
        .equations(&[EquationText::new(11, "motion M*ddot(h) = -M*g", "N")])
        .operations(Operations::of([1, 0, 0, 0, 0, 0, 1, 0, 0]))
        .modes(
            &[
                ModeEntry::new(
                    "flight",
                    "above the floor",
                    &[
                        EventEntry::new(
                                12,
                                "when h falls -> contact",
                                Direction::Falls,
                                "m",
                                1.0,
                                1,
                            )
                            .sets(),
                    ],
                ),
                ModeEntry::new(
                    "contact",
                    "on the floor",
                    &[
                        EventEntry::new(
                                16,
                                "when h rises -> flight",
                                Direction::Rises,
                                "m",
                                1.0,
                                0,
                            )
                            .sets(),
                    ],
                ),
            ],
            0,
        );
}
