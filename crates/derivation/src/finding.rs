//! Results of a search, an integral or a curve.

macro_rules! findings {
    ($($name:ident [$($symbol:literal)*];)*) => {
        /// Result of a search, an integral or a curve. The texts are in `words`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[allow(missing_docs, reason = "its text in words says what each is")]
        pub enum Finding {
            $($name,)*
        }

        impl Finding {
            /// The findings.
            pub const ALL: &[Self] = &[$(Self::$name),*];

            /// Returns the symbols of earlier steps that the result is based on, in the order of its text.
            #[must_use]
            pub const fn symbols(self) -> &'static [&'static str] {
                match self {
                    $(Self::$name => &[$($symbol),*],)*
                }
            }
        }
    };
}

findings! {
    AccelerationAt ["t"];
    TorqueOfLoadAt ["t"];
    SpeedAt ["t"];
    DirectionAt ["t"];
    PeakSpeed ["n"];
    PeakLoad ["T_L"];
    PeakHoldingTorque [];
    DrivingTorque [];
    AngleTravelled [];
    Travel [];
    AccelerationRms ["t_0"];
    LoadRms ["t_0"];
    Correlation ["T_L" "t_0" "alpha_rms" "T_L_rms"];
    LargestInertia [];
    LargestInertiaHeld ["t"];
    LeastInertiaHeld ["t"];
    SpeedNearResonance ["t"];
    NoSpeedHeld [];
    ContinuousCurve ["n_av"];
    ShortTimeCurve ["n" "T_max"];
    SpeedBeyondCurve ["n" "n_end"];
    EdgeOfBand ["n"];
    LowerEdgeOfBand ["n_av"];
    MeanSpeedUpToRated ["n_av" "n_N_out"];
    GearAsHousing [];
    FrictionOfColdGear ["I_s" "K" "n"];
    CurrentWithinVoltage ["n" "U_M"];
    GearCold [];
    GearSettled [];
    LawOfFriction ["theta_g"];
    EffectiveCurrent ["t_0"];
    TimeAboveContinuous ["I_D"];
    CurrentOfCurve ["n" "I_max"];
    CopperLoss ["R_hot" "I" "K"];
    FrictionLoss ["I_NLS" "K" "n" "k_TM"];
    WindingRise [];
    CurvesOverModel [];
    OverloadLag ["I" "I_0" "tau_w"];
    OverloadPermitted ["I" "I_0" "n_av"];
    EnergyReturned ["R_LL" "I" "k_TM"];
    CubicMeanTorque ["T_L" "n"];
    AxialForceMax ["F_a"];
    RadialForceMax ["F_r"];
    LargestOverSegments [];
    LargestOfMechanism [];
    LargestInMotion [];
    LargestAtRest [];
    LeastTension [];
    TensionOfWeight [];
    SegmentOfLargestMoment ["M"];
    EverySegmentInMotion [];
    RadialMeanOverCycle ["F_r" "B"];
    AxialMeanOverCycle ["F_a" "B"];
    MomentMeanOverCycle ["M_L" "B"];
    RadialMean ["t_k" "B"];
    AxialMean ["t_k" "B"];
    RadialMomentMean ["t_k" "R" "B"];
    AxialMomentMean ["t_k" "B"];
    TiltBehindStage [];
    NotKnown [];
    Brakings [];
    BatteryLife ["t_op" "t_store"];
}
