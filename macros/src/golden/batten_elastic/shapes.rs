mod shapes_ {
    use ::assur::shape::tables::*;
    const unit_0_: Unit = Unit::new("mm", 0.001, [1, 0, 0, 0, 0, 0, 0]);
    const unit_1_: Unit = Unit::new("rpm", 0.10471975511965977, [0, 0, -1, 0, 0, 0, 0]);
    const unit_2_: Unit = Unit::new("kg", 1.0, [0, 1, 0, 0, 0, 0, 0]);
    const unit_3_: Unit = Unit::new("", 1.0, [0, 0, 0, 0, 0, 0, 0]);
    const unit_4_: Unit = Unit::new("N m/rad", 1.0, [2, 1, -2, 0, 0, 0, 0]);
    const unit_5_: Unit = Unit::new("kg m^2", 1.0, [2, 1, 0, 0, 0, 0, 0]);
    const unit_6_: Unit = Unit::new("m/N", 1.0, [0, -1, 2, 0, 0, 0, 0]);
    const unit_7_: Unit = Unit::new("rad", 1.0, [0, 0, 0, 0, 0, 0, 0]);
    const unit_8_: Unit = Unit::new("m", 1.0, [1, 0, 0, 0, 0, 0, 0]);
    const unit_9_: Unit = Unit::new("m/s", 1.0, [1, 0, -1, 0, 0, 0, 0]);
    const unit_10_: Unit = Unit::new("m/s^2", 1.0, [1, 0, -2, 0, 0, 0, 0]);
    const unit_11_: Unit = Unit::new("rad/s", 1.0, [0, 0, -1, 0, 0, 0, 0]);
    const unit_12_: Unit = Unit::new("rad/s^2", 1.0, [0, 0, -2, 0, 0, 0, 0]);
    const unit_13_: Unit = Unit::new("N", 1.0, [1, 1, -2, 0, 0, 0, 0]);
    const unit_14_: Unit = Unit::new("N m", 1.0, [2, 1, -2, 0, 0, 0, 0]);
    const unit_15_: Unit = Unit::new("W", 1.0, [2, 1, -3, 0, 0, 0, 0]);
    const unit_16_: Unit = Unit::new("mrad", 0.001, [0, 0, 0, 0, 0, 0, 0]);
    const constants_: [Constant; 13] = [
        Constant::dimension(Quantity::new("R", "Crank.", unit_0_), 0.001, 1.0),
        Constant::dimension(Quantity::new("l", "Connecting rod.", unit_0_), 0.001, 10.0),
        Constant::parameter(
            Quantity::new("n", "Speed of the crankshaft.", unit_1_),
            0.10471975511965977,
            209.43951023931953,
        ),
        Constant::parameter(
            Quantity::new("m1", "Sword pin with rod and frame, drive side.", unit_2_),
            1e-6,
            100000.0,
        ),
        Constant::parameter(
            Quantity::new("m2", "Sword pin with rod and frame, brake side.", unit_2_),
            1e-6,
            100000.0,
        ),
        Constant::parameter(
            Quantity::new("m3", "End of the bar, drive side.", unit_2_),
            1e-6,
            100000.0,
        ),
        Constant::parameter(
            Quantity::new("m4", "End of the bar, brake side.", unit_2_),
            1e-6,
            100000.0,
        ),
        Constant::parameter(
            Quantity::new(
                "lambda",
                "Cantilever of the bar over its span, L1/L.",
                unit_3_,
            ),
            0.0,
            10.0,
        ),
        Constant::parameter(
            Quantity::new(
                "c",
                "Torsional stiffness of the shaft between its cranks.",
                unit_4_,
            ),
            1.0,
            1000000000000.0,
        ),
        Constant::parameter(
            Quantity::new("J2", "Disc at the brake end.", unit_5_),
            1e-9,
            1000000.0,
        ),
        Constant::parameter(
            Quantity::new(
                "d33",
                "Displacement of the drive-side end of the bar by unit force there.",
                unit_6_,
            ),
            1e-15,
            1.0,
        ),
        Constant::parameter(
            Quantity::new(
                "d44",
                "Displacement of the brake-side end of the bar by unit force there.",
                unit_6_,
            ),
            1e-15,
            1.0,
        ),
        Constant::parameter(
            Quantity::new(
                "d34",
                "Displacement of one end of the bar by unit force at the other.",
                unit_6_,
            ),
            -1.0,
            1.0,
        ),
    ];
    static list_0_: &[Quantity] = &[
        Quantity::new(
            "theta",
            "Angle of the drive-end crank from the rear dead centre.",
            unit_7_,
        ),
    ];
    static list_1_: &[Quantity] = &[
        Quantity::new("x1", "", unit_8_),
        Quantity::new("x2", "", unit_8_),
        Quantity::new("x3", "", unit_8_),
        Quantity::new("x4", "", unit_8_),
        Quantity::new("dot(x1)", "", unit_9_),
        Quantity::new("dot(x2)", "", unit_9_),
        Quantity::new("dot(x3)", "", unit_9_),
        Quantity::new("dot(x4)", "", unit_9_),
        Quantity::new("ddot(x1)", "", unit_10_),
        Quantity::new("ddot(x2)", "", unit_10_),
        Quantity::new("ddot(x3)", "", unit_10_),
        Quantity::new("ddot(x4)", "", unit_10_),
        Quantity::new("phi2", "", unit_7_),
        Quantity::new("dot(phi2)", "", unit_11_),
        Quantity::new("ddot(phi2)", "", unit_12_),
        Quantity::new("F1", "", unit_13_),
        Quantity::new("F2", "", unit_13_),
        Quantity::new("rod1", "", unit_13_),
        Quantity::new("rod2", "", unit_13_),
        Quantity::new(
            "drive_torque",
            "Torque at the drive end that keeps the speed.",
            unit_14_,
        ),
        Quantity::new(
            "shaft_torque",
            "Torque in the shaft between its cranks.",
            unit_14_,
        ),
        Quantity::new(
            "x_difference",
            "Ends of the bar, drive side ahead of brake side.",
            unit_8_,
        ),
        Quantity::new("v_difference", "", unit_9_),
        Quantity::new("F_difference", "", unit_13_),
    ];
    static list_2_: &[Quantity] = &[
        Quantity::new(
            "phi2",
            "Lag of the brake-end crank behind the drive-end one.",
            unit_7_,
        ),
        Quantity::new(
            "w3",
            "Displacement of the drive-side end of the bar from the rigid motion.",
            unit_8_,
        ),
        Quantity::new(
            "w4",
            "Displacement of the brake-side end of the bar from the rigid motion.",
            unit_8_,
        ),
        Quantity::new("dot(phi2)", "", unit_11_),
        Quantity::new("dot(w3)", "", unit_9_),
        Quantity::new("dot(w4)", "", unit_9_),
    ];
    static list_3_: &[Quantity] = &[
        Quantity::new("peak_rod1", "largest force along the drive-side rod", unit_13_),
        Quantity::new("peak_rod2", "largest force along the brake-side rod", unit_13_),
        Quantity::new(
            "inequality",
            "largest difference of both sides; it shows resonances",
            unit_13_,
        ),
        Quantity::new("peak_drive", "largest torque at the drive end", unit_14_),
        Quantity::new("mean_power", "what the drive gives on average", unit_15_),
        Quantity::new(
            "nearest_resonance",
            "distance of a Floquet multiplier from 1, at which there is a resonance",
            unit_3_,
        ),
        Quantity::new("largest_multiplier", "above 1 the motion is unstable", unit_3_),
        Quantity::new("largest_lag", "of the brake-end crank", unit_16_),
        Quantity::new("peak_shaft", "largest torque in the shaft", unit_14_),
    ];
    pub static Elastic: Shape = Shape::named("elastic")
        .summary("The paper's model: shaft and bar are elastic, nothing is lost.")
        .effects(&["bending", "coupling", "torsion"])
        .choices(&[("crank", "two_term"), ("linearisation", "K1")])
        .constants(
            &Constant::some(
                &constants_,
                [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
                [
                    0.075,
                    0.271,
                    26.17993877991494,
                    28.5,
                    28.5,
                    2.02,
                    2.02,
                    0.385,
                    20980.0,
                    0.1004,
                    3.8e-6,
                    3.8e-6,
                    1.22e-6,
                ],
            ),
        )
        .drivers(list_0_)
        .states(list_2_, &[0.001, 0.001, 0.001, 0.001, 0.001, 0.001])
        .coordinates(3)
        .linear()
        .outputs(list_1_)
        .measures(
            list_3_,
            &[&[0], &[1], &[2], &[3], &[4], &[5], &[6], &[7], &[8]],
            &[
                Primitive::of(Kind::Peak, 0),
                Primitive::of(Kind::Peak, 1),
                Primitive::of(Kind::Peak, 2),
                Primitive::of(Kind::Peak, 3),
                Primitive::of(Kind::Mean, 4),
                Primitive::of(Kind::Detuning(1), 0),
                Primitive::of(Kind::Multiplier(1), 0),
                Primitive::of(Kind::Peak, 5),
                Primitive::of(Kind::Peak, 6),
            ],
            7,
        )
        .equations(
            &[
                EquationText::new(
                    66,
                    "kinetic m1*dot(x1)^2/2 + m2*dot(x2)^2/2 + m3*dot(x3)^2/2 + m4*dot(x4)^2/2",
                    "N m",
                ),
                EquationText::new(75, "kinetic J2*(n - dot(phi2))^2/2", "N m"),
                EquationText::new(76, "potential c*phi2^2/2", "N m"),
                EquationText::new(111, "potential stiffness(u3, u4)/2", "N m"),
            ],
        )
        .operations(Operations::of([73, 31, 27, 28, 112, 0, 58, 13, 4]))
        .marks(
            &[
                Mark::new("rear dead centre", At::Driver(0, 0.0)),
                Mark::new("locks", At::Driver(0, 1.9198)),
                Mark::new("front dead centre", At::Driver(0, 3.141592653589793)),
            ],
        )
        .expectations(
            &[
                Expectation::new(
                        239,
                        Subject::Output(13),
                        At::Driver(0, 0.0),
                        0.078796,
                        0.0016,
                    )
                    .remark("eq (8), printed 0.076796"),
                Expectation::new(
                        240,
                        Subject::Output(2),
                        At::Driver(0, 0.0),
                        -0.00037819,
                        5e-6,
                    )
                    .remark("eq (8)"),
                Expectation::new(
                        241,
                        Subject::Output(3),
                        At::Driver(0, 0.0),
                        -0.00037682,
                        5e-6,
                    )
                    .remark("eq (8)"),
                Expectation::new(
                        242,
                        Subject::Output(12),
                        At::Driver(0, 1.9198),
                        -0.000758,
                        1e-5,
                    )
                    .remark("start of the blow into the locks"),
                Expectation::new(
                        243,
                        Subject::Output(13),
                        At::Driver(0, 1.9198),
                        -0.210545,
                        0.004,
                    )
                    .remark("start of the blow into the locks"),
                Expectation::new(
                        244,
                        Subject::Output(2),
                        At::Driver(0, 1.9198),
                        0.09156517,
                        0.0001,
                    )
                    .remark("start of the blow into the locks"),
                Expectation::new(
                        245,
                        Subject::Output(6),
                        At::Driver(0, 1.9198),
                        2.0326885,
                        0.003,
                    )
                    .remark("printed 2.0826885, which X'ω = 2.02 excludes"),
                Expectation::new(
                        246,
                        Subject::Output(3),
                        At::Driver(0, 1.9198),
                        0.09166565,
                        0.0001,
                    )
                    .remark("start of the blow into the locks"),
                Expectation::new(
                        247,
                        Subject::Output(7),
                        At::Driver(0, 1.9198),
                        2.0608894,
                        0.003,
                    )
                    .remark("start of the blow into the locks"),
                Expectation::new(248, Subject::Output(12), At::Amplitude, 0.0037, 0.0001)
                    .remark("figure 2"),
                Expectation::new(249, Subject::Output(13), At::Amplitude, 0.24, 0.005)
                    .remark("figure 2"),
                Expectation::new(250, Subject::Output(14), At::Amplitude, 15.4, 0.3)
                    .remark("text; the scan shows 154"),
                Expectation::new(253, Subject::Measure(0), At::Run, 2007.36804, 0.0001)
                    .remark("with the rigid batten 2003.04"),
                Expectation::new(254, Subject::Measure(1), At::Run, 1964.04675, 0.0001),
                Expectation::new(255, Subject::Measure(2), At::Run, 48.824093, 1e-5),
                Expectation::new(
                    256,
                    Subject::Measure(7),
                    At::Run,
                    0.00377442942,
                    9.999999999999999e-11,
                ),
                Expectation::new(257, Subject::Measure(4), At::Run, 0.0, 1e-9)
                    .remark("nothing is lost"),
                Expectation::new(258, Subject::Measure(2), At::Run, 377.806, 0.01)
                    .preset("resonant"),
                Expectation::new(269, Subject::Measure(5), At::Run, 0.631639, 2e-6),
            ],
        );
}
