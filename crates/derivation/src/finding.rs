//! Results of a search, an integral or a curve.

macro_rules! findings {
    ($($name:ident $($formula:literal)? [$($symbol:literal)*];)*) => {
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

            /// Returns the formula of the result, to be parsed as [`Formula`](crate::Formula), if it has one. The text
            /// in `words` then only states where or under which condition it holds.
            #[must_use]
            pub const fn formula(self) -> Option<&'static str> {
                match self {
                    $(Self::$name => findings!(@formula $($formula)?),)*
                }
            }
        }
    };
    (@formula) => { None };
    (@formula $formula:literal) => { Some($formula) };
}

findings! {
    AccelerationAt ["t"];
    TorqueOfLoadAt ["t"];
    PositionAt ["t"];
    RecordedTorqueAt ["t"];
    PositionOfLargestHolding [];
    PositionOfLargestInertia [];
    PositionOfLeastInertia [];
    InertiaOfBodies "sum(J_i + m_i*d_i^2)" [];
    MassOfBodies "sum(m_i)" [];
    CentreOfBodies "abs(sum(m_i*r_i))/m" ["m"];
    AngleOfBodies "arctan2(sum(m_i*y_i), sum(m_i*x_i))" [];
    SpeedAt ["t"];
    AngularVelocityAt ["t"];
    DirectionAt ["t"];
    PeakSpeed "max(abs(n))" ["n"];
    AngleTravelled "int(abs(omega))" [];
    Travel "max(q) - min(q)" [];
    AccelerationRms "sqrt(int(alpha^2)/t_0)" ["t_0"];
    LoadRms "sqrt(int(T_L^2)/t_0)" ["t_0"];
    Correlation "int(alpha*T_L)/(t_0*alpha_rms*T_L_rms)" ["T_L" "t_0" "alpha_rms" "T_L_rms"];
    SpeedNearResonance ["t"];
    ContinuousCurve ["n_av"];
    ShortTimeCurve ["n" "T_max"];
    SpeedBeyondCurve ["n" "n_end"];
    EdgeOfBand ["n"];
    LowerEdgeOfBand ["n_av"];
    MeanSpeedUpToRated "min(abs(n_av), n_N_out)" ["n_av" "n_N_out"];
    GearAsHousing [];
    FrictionOfColdGear "I_s + K*abs(n)" ["I_s" "K" "n"];
    CurrentWithinVoltage ["n" "U_M"];
    GearCold [];
    GearSettled [];
    StateCold [];
    StateSettled [];
    StateWarmest [];
    LawOfFriction ["theta_g"];
    EffectiveCurrent "sqrt(int(I^2)/t_0)" ["t_0"];
    TimeAboveContinuous ["I_D"];
    CurrentOfCurve ["n" "I_max"];
    CopperLoss "int(1.5*R_hot*I^2)/t_0" ["R_hot" "I" "K"];
    FrictionLoss "int((I_NLS + K*abs(n))*k_TM*omega_mot)/t_0 + P_coil" ["I_NLS" "K" "n" "k_TM"];
    WindingRise [];
    CurvesOverModel [];
    OverloadLag ["I" "I_0" "tau_w"];
    OverloadPermitted ["I" "I_0" "n_av"];
    EnergyReturned "-int(min(1.5*R_LL*I^2 + k_TM*I*omega_mot, 0))" ["R_LL" "I" "k_TM" "q_d"];
    CubicMeanTorque "(int(abs(T_L)^3*abs(n))/int(abs(n)))^(1/3)" ["T_L" "n"];
    AxialForceMax "max(F_a)" ["F_a"];
    RadialForceMax "max(F_r)" ["F_r"];
    LargestOverSegments [];
    LargestTogether "F_r + 2*M/d_p + 0.44*F_a" ["F_r" "M" "d_p" "F_a"];
    LargestOfMechanism [];
    LargestInMotion [];
    LargestAtRest [];
    LeastTension "m*(g + a) + F" [];
    TensionOfWeight [];
    SegmentOfLargestMoment ["M"];
    EverySegmentInMotion [];
    RadialMeanOverCycle "(int(abs(omega)*F_r^B)/int(abs(omega)))^(1/B)" ["F_r" "B"];
    AxialMeanOverCycle "(int(abs(omega)*F_a^B)/int(abs(omega)))^(1/B)" ["F_a" "B"];
    MomentMeanOverCycle "(int(abs(omega)*M^B)/int(abs(omega)))^(1/B)" ["M" "B"];
    RadialMean "(sum(abs(n_k)*t_k*F_rk^B)/sum(abs(n_k)*t_k))^(1/B)" ["t_k" "B"];
    AxialMean "(sum(abs(n_k)*t_k*F_ak^B)/sum(abs(n_k)*t_k))^(1/B)" ["t_k" "B"];
    MomentMean "(sum(abs(n_k)*t_k*(F_rk*(L_rk + R) + F_ak*L_ak)^B)/sum(abs(n_k)*t_k))^(1/B)" ["t_k" "R" "B"];
    TiltBehindStage [];
    NotKnown [];
    Brakings [];
    BatteryLife ["t_op" "t_store"];
}
