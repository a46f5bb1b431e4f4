//! Rules about the values of one product: ratios of powers that lie within a window for every real actuator.

quantities::identified! {
    /// A rule about the values of a catalogue file.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum PlausibilityRuleId {
        /// k_TM against k_EM.
        VoltageConstant = "voltage_constant",
        /// k_Tout against i·k_TM.
        GearEfficiency = "gear_efficiency",
        /// k_Tout against i·√3·k_EM, where k_TM is not stated.
        VoltageConstantOfOutput = "voltage_constant_of_output",
        /// T_0 against k_Tout·I_0.
        StallTorqueOfCurrent = "stall_torque_of_current",
        /// T_max against k_Tout·I_max.
        LargestTorqueOfCurrent = "largest_torque_of_current",
        /// T_0 against T_max.
        StallTorqueBelowLargest = "stall_torque_below_largest",
        /// I_0 against I_max.
        StallCurrentBelowLargest = "stall_current_below_largest",
        /// n_max·i against n_mot,max.
        SpeedOfMotor = "speed_of_motor",
        /// n_N against n_mot,max.
        RatedSpeedBelowLargest = "rated_speed_below_largest",
        /// k_EM·n_mot,max against U_DCmax.
        BackEmf = "back_emf",
        /// k_EM·n_max·i against U_DCmax, where the motor speed is not stated.
        BackEmfAtOutputSpeed = "back_emf_at_output_speed",
        /// Copper loss of I_0 against the heat that a body of the stated mass gives off.
        CopperLoss = "copper_loss",
        /// Friction at the largest speed, as current, against I_0.
        NoLoadCurrent = "no_load_current",
        /// K_INL at 80 °C against K_INL at 30 °C.
        NoLoadWarmBelowCold = "no_load_warm_below_cold",
        /// L_LL/R_LL.
        ElectricalTimeConstant = "electrical_time_constant",
        /// T_max against T_M of the gear.
        LargestTorqueOfGear = "largest_torque_of_gear",
        /// T_A against T_M of the gear.
        MeanTorqueOfGear = "mean_torque_of_gear",
        /// T_N against T_M of the gear.
        RatedTorqueOfGear = "rated_torque_of_gear",
        /// T_1/K_1.
        TwistAtFirstTorque = "twist_at_first_torque",
        /// K_1 against K_2.
        FirstStiffness = "first_stiffness",
        /// K_2 against K_3.
        SecondStiffness = "second_stiffness",
        /// C against C_0 of the output bearing.
        BearingRatings = "bearing_ratings",
        /// Permitted tilting moment against C·d_p.
        TiltingMoment = "tilting_moment",
        /// Brake torque against T_max.
        BrakeTorque = "brake_torque",
        /// Bore of the hollow shaft against the pitch diameter of the output bearing.
        HollowShaft = "hollow_shaft",
        /// Mass against the cube of the length.
        Density = "density",
        /// J_out/i² against other products with the same motor.
        SameMotor = "same_motor",
        /// A value against the other products of the series, by size and ratio.
        Neighbours = "neighbours",
        /// Names that differ in case and separators only.
        SameName = "same_name",
    }
}

/// A rule about the values of one product: a factor times powers of values in SI that lies within a window.
#[derive(Clone, Copy, Debug)]
pub struct PlausibilityRule {
    /// Identifier.
    pub id: PlausibilityRuleId,
    /// Compared ratio in symbols.
    pub formula: &'static str,
    /// Symbol, key and power of each value; without one of the values there is no finding.
    pub terms: &'static [(&'static str, &'static str, f64)],
    /// Factor of the ratio.
    pub factor: f64,
    /// Smallest plausible ratio.
    pub low: f64,
    /// Largest plausible ratio.
    pub high: f64,
    /// Unit of the ratio; empty for a pure number.
    pub unit: &'static str,
    /// Key in whose presence another rule decides.
    pub unless: Option<&'static str>,
}

impl PlausibilityRule {
    /// Returns the ratio of the values; `None` if one is not stated or zero, or if another rule decides.
    pub(super) fn ratio(&self, value: &dyn Fn(&str) -> Option<f64>) -> Option<f64> {
        if self.unless.is_some_and(|key| value(key).is_some()) {
            return None;
        }
        let product = |found: f64, (_, key, power): &(&str, &str, f64)| {
            let value = value(key).filter(|value| *value > 0.0)?;
            Some(found * value.powf(*power))
        };
        self.terms.iter().try_fold(self.factor, product)
    }

    /// Returns `true` if a ratio lies within the window.
    pub(super) fn holds(&self, ratio: f64) -> bool {
        const ROUNDING: f64 = 1e-9;
        (self.low * (1.0 - ROUNDING)..=self.high * (1.0 + ROUNDING)).contains(&ratio)
    }
}

const fn rule(
    id: PlausibilityRuleId,
    formula: &'static str,
    terms: &'static [(&'static str, &'static str, f64)],
    [low, high]: [f64; 2],
) -> PlausibilityRule {
    PlausibilityRule { id, formula, terms, factor: 1.0, low, high, unit: "", unless: None }
}

const SQRT_3: f64 = 1.732_050_807_568_877_2;

/// Rules about the values of one product, in the order of the identifiers.
///
/// # Source
/// Windows are choices: wider than the products of the built-in series by the figures in the guide, and narrower than the
/// confusion that each is for (√3, √2, a power of ten).
pub const PLAUSIBILITY_RULES: &[PlausibilityRule] = {
    use PlausibilityRuleId as Id;
    &[
        PlausibilityRule {
            factor: 1.0 / SQRT_3,
            ..rule(
                Id::VoltageConstant,
                "k_TM / (√3 · k_EM)",
                &[("k_TM", "torque_constant_motor", 1.0), ("k_EM", "voltage_constant_motor", -1.0)],
                [0.75, 1.1],
            )
        },
        rule(
            Id::GearEfficiency,
            "k_Tout / (i · k_TM)",
            &[("k_Tout", "torque_constant_out", 1.0), ("i", "ratio", -1.0), ("k_TM", "torque_constant_motor", -1.0)],
            [0.5, 1.05],
        ),
        PlausibilityRule {
            factor: 1.0 / SQRT_3,
            unless: Some("torque_constant_motor"),
            ..rule(
                Id::VoltageConstantOfOutput,
                "k_Tout / (i · √3 · k_EM)",
                &[
                    ("k_Tout", "torque_constant_out", 1.0),
                    ("i", "ratio", -1.0),
                    ("k_EM", "voltage_constant_motor", -1.0),
                ],
                [0.4, 1.15],
            )
        },
        rule(
            Id::StallTorqueOfCurrent,
            "T_0 / (k_Tout · I_0)",
            &[("T_0", "stall_torque", 1.0), ("k_Tout", "torque_constant_out", -1.0), ("I_0", "stall_current", -1.0)],
            [0.6, 1.1],
        ),
        rule(
            Id::LargestTorqueOfCurrent,
            "T_max / (k_Tout · I_max)",
            &[("T_max", "torque_max", 1.0), ("k_Tout", "torque_constant_out", -1.0), ("I_max", "current_max", -1.0)],
            [0.5, 1.25],
        ),
        rule(
            Id::StallTorqueBelowLargest,
            "T_0 / T_max",
            &[("T_0", "stall_torque", 1.0), ("T_max", "torque_max", -1.0)],
            [0.1, 1.0],
        ),
        rule(
            Id::StallCurrentBelowLargest,
            "I_0 / I_max",
            &[("I_0", "stall_current", 1.0), ("I_max", "current_max", -1.0)],
            [0.1, 1.0],
        ),
        rule(
            Id::SpeedOfMotor,
            "n_max · i / n_mot,max",
            &[("n_max", "speed_max", 1.0), ("i", "ratio", 1.0), ("n_mot,max", "speed_motor_max", -1.0)],
            [0.2, 1.05],
        ),
        rule(
            Id::RatedSpeedBelowLargest,
            "n_N / n_mot,max",
            &[("n_N", "speed_motor_rated", 1.0), ("n_mot,max", "speed_motor_max", -1.0)],
            [0.1, 1.0],
        ),
        PlausibilityRule {
            factor: std::f64::consts::SQRT_2,
            ..rule(
                Id::BackEmf,
                "√2 · k_EM · n_mot,max / U_DCmax",
                &[
                    ("k_EM", "voltage_constant_motor", 1.0),
                    ("n_mot,max", "speed_motor_max", 1.0),
                    ("U_DCmax", "dc_link_max", -1.0),
                ],
                [0.1, 1.3],
            )
        },
        PlausibilityRule {
            factor: std::f64::consts::SQRT_2,
            unless: Some("speed_motor_max"),
            ..rule(
                Id::BackEmfAtOutputSpeed,
                "√2 · k_EM · n_max · i / U_DCmax",
                &[
                    ("k_EM", "voltage_constant_motor", 1.0),
                    ("n_max", "speed_max", 1.0),
                    ("i", "ratio", 1.0),
                    ("U_DCmax", "dc_link_max", -1.0),
                ],
                [0.05, 1.3],
            )
        },
        PlausibilityRule {
            factor: 1.5,
            unit: "W/kg^(2/3)",
            ..rule(
                Id::CopperLoss,
                "1.5 · R_LL · I_0² / m^(2/3)",
                &[("R_LL", "resistance_ll", 1.0), ("I_0", "stall_current", 2.0), ("m", "mass", -2.0 / 3.0)],
                [0.3, 100.0],
            )
        },
        rule(
            Id::NoLoadCurrent,
            "K_INL,30 · n_max / I_0",
            &[
                ("K_INL,30", "no_load_current_constant_30", 1.0),
                ("n_max", "speed_max", 1.0),
                ("I_0", "stall_current", -1.0),
            ],
            [0.01, 2.0],
        ),
        rule(
            Id::NoLoadWarmBelowCold,
            "K_INL,80 / K_INL,30",
            &[("K_INL,80", "no_load_current_constant_80", 1.0), ("K_INL,30", "no_load_current_constant_30", -1.0)],
            [0.1, 1.0],
        ),
        PlausibilityRule {
            factor: 1e3,
            unit: "ms",
            ..rule(
                Id::ElectricalTimeConstant,
                "L_LL / R_LL",
                &[("L_LL", "inductance_ll", 1.0), ("R_LL", "resistance_ll", -1.0)],
                [0.1, 40.0],
            )
        },
        rule(
            Id::LargestTorqueOfGear,
            "T_max / T_M",
            &[("T_max", "torque_max", 1.0), ("T_M", "gear_torque_momentary_max", -1.0)],
            [0.1, 1.0],
        ),
        rule(
            Id::MeanTorqueOfGear,
            "T_A / T_M",
            &[("T_A", "gear_torque_mean_max", 1.0), ("T_M", "gear_torque_momentary_max", -1.0)],
            [0.05, 1.0],
        ),
        rule(
            Id::RatedTorqueOfGear,
            "T_N / T_M",
            &[("T_N", "gear_torque_rated", 1.0), ("T_M", "gear_torque_momentary_max", -1.0)],
            [0.05, 1.0],
        ),
        PlausibilityRule {
            factor: 1e3,
            unit: "mrad",
            ..rule(
                Id::TwistAtFirstTorque,
                "T_1 / K_1",
                &[("T_1", "torque_1", 1.0), ("K_1", "stiffness_1", -1.0)],
                [0.05, 20.0],
            )
        },
        rule(Id::FirstStiffness, "K_1 / K_2", &[("K_1", "stiffness_1", 1.0), ("K_2", "stiffness_2", -1.0)], [0.2, 1.0]),
        rule(
            Id::SecondStiffness,
            "K_2 / K_3",
            &[("K_2", "stiffness_2", 1.0), ("K_3", "stiffness_3", -1.0)],
            [0.2, 1.0],
        ),
        rule(
            Id::BearingRatings,
            "C / C_0",
            &[("C", "bearing_dynamic", 1.0), ("C_0", "bearing_static", -1.0)],
            [0.2, 2.0],
        ),
        rule(
            Id::TiltingMoment,
            "M_c / (C · d_p)",
            &[
                ("M_c", "tilting_moment_max", 1.0),
                ("C", "bearing_dynamic", -1.0),
                ("d_p", "bearing_pitch_diameter", -1.0),
            ],
            [0.02, 1.0],
        ),
        rule(
            Id::BrakeTorque,
            "T_Br / T_max",
            &[("T_Br", "brake_torque", 1.0), ("T_max", "torque_max", -1.0)],
            [0.05, 5.0],
        ),
        rule(
            Id::HollowShaft,
            "d_H / d_p",
            &[("d_H", "hollow_shaft", 1.0), ("d_p", "bearing_pitch_diameter", -1.0)],
            [0.02, 1.0],
        ),
        PlausibilityRule {
            unit: "kg/m^3",
            ..rule(Id::Density, "m / L³", &[("m", "mass", 1.0), ("L", "length", -3.0)], [10.0, 100_000.0])
        },
    ]
};

/// A key that follows a power law in size within a series, and in the ratio.
#[derive(Clone, Copy, Debug)]
pub struct SeriesKey {
    /// Name of the key.
    pub key: &'static str,
    /// Power of the ratio.
    pub ratio: f64,
    /// `true` if the value depends on the voltage of the winding, so that only products of one stated voltage are compared.
    pub winding: bool,
}

const fn of_size(key: &'static str) -> SeriesKey {
    SeriesKey { key, ratio: 0.0, winding: false }
}

const fn of_ratio(key: &'static str, ratio: f64) -> SeriesKey {
    SeriesKey { ratio, ..of_size(key) }
}

const fn of_winding(key: &'static str, ratio: f64) -> SeriesKey {
    SeriesKey { winding: true, ..of_ratio(key, ratio) }
}

/// Keys that are compared with the other products of a series.
pub const SERIES_KEYS: &[SeriesKey] = &[
    of_size("torque_max"),
    of_ratio("speed_max", -1.0),
    of_size("speed_motor_max"),
    of_size("speed_motor_rated"),
    of_ratio("inertia_out", 2.0),
    of_size("stall_torque"),
    of_winding("stall_current", 0.0),
    of_winding("current_max", 0.0),
    of_winding("current_demagnetisation", 0.0),
    of_winding("no_load_starting_current", 0.0),
    of_winding("no_load_current_constant_30", 1.0),
    of_winding("no_load_current_constant_80", 1.0),
    of_winding("torque_constant_out", 1.0),
    of_winding("torque_constant_motor", 0.0),
    of_winding("voltage_constant_motor", 0.0),
    of_winding("resistance_ll", 0.0),
    of_winding("inductance_ll", 0.0),
    of_size("mass"),
    of_size("length"),
    of_size("hollow_shaft"),
    of_size("gear_torque_rated"),
    of_size("gear_torque_mean_max"),
    of_size("gear_torque_momentary_max"),
    of_size("gear_speed_max"),
    of_size("gear_speed_mean_max"),
    of_size("gear_life_rated"),
    of_size("gear_life_speed"),
    of_size("stiffness_1"),
    of_size("stiffness_2"),
    of_size("stiffness_3"),
    of_size("torque_1"),
    of_size("torque_2"),
    of_size("transmission_accuracy"),
    of_size("repeatability"),
    of_size("hysteresis_loss"),
    of_size("lost_motion"),
    of_size("bearing_pitch_diameter"),
    of_size("bearing_offset"),
    of_size("bearing_dynamic"),
    of_size("bearing_static"),
    of_size("tilting_moment_max"),
    of_size("static_moment_max"),
    of_size("axial_force_max"),
    of_size("radial_force_max"),
    of_size("tilting_stiffness"),
    of_size("brake_torque"),
    of_size("brake_closing_time"),
    of_size("brake_opening_time"),
    of_size("winding_time_constant"),
];

/// Keys from which the size of a product within its series is estimated, each with the power that makes it proportional to a
/// mass for geometrically similar products.
pub const SIZE_KEYS: &[(&str, f64)] = &[
    ("mass", 1.0),
    ("torque_max", 1.0),
    ("stall_torque", 1.0),
    ("gear_torque_momentary_max", 1.0),
    ("tilting_moment_max", 1.0),
    ("length", 3.0),
    ("bearing_pitch_diameter", 3.0),
    ("hollow_shaft", 3.0),
];
