//! Parameters of one actuator. Each value may be absent; a check that needs it reports the absence.

use crate::accuracy::Accuracy;
use crate::brake::Brake;
use crate::curve::Curve;
use crate::environment::Environment;
use crate::feedback::{Feedback, FeedbackSide};
use crate::gear::Gear;
use crate::heat::Heat;
use crate::output_bearing::OutputBearing;
use crate::screw_joint::ScrewJoint;
use provenance::Datum;
use quantities::{
    AngularVelocity, ElectricCurrent, ElectricPotential, ElectricalResistance, Inductance, Length, Mass,
    MomentOfInertia, NoLoadCurrentConstant, ThermodynamicTemperature, Torque, TorqueConstant, VoltageConstant,
};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// Parameters of one actuator in SI, each value with its source or the reason for its absence.
///
/// Most actuators that differ only in feedback and brake share one drivetrain: callers that evaluate them in sequence
/// compare drivetrains by [`Arc::ptr_eq`] to reuse results. The fields of the drivetrain are readable through
/// [`Deref`]; writing one clones a shared drivetrain first.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// Data independent of the brake and mostly of the feedback.
    pub drivetrain: Arc<Drivetrain>,
    /// J_out: own moment of inertia at the output, including the brake if fitted.
    pub inertia_out: Datum<MomentOfInertia>,
    /// m: mass, including the brake if fitted.
    pub mass: Datum<Mass>,
    /// L: length, including the brake if fitted.
    pub length: Datum<Length>,
    /// Holding brake.
    pub brake: Brake,
    /// Feedback on the motor.
    pub feedback: Feedback,
    /// T_NAT: response temperature of the winding PTC; not applicable if no connector has contacts for it.
    pub ptc_response: Datum<ThermodynamicTemperature>,
    /// The feedback connector has no contacts for the KTY, which is read for warning and shutdown.
    pub without_kty: bool,
    /// Feedback at the output; not applicable without the option.
    pub feedback_out: Feedback,
}

/// Data of motor, gear, output bearing and joints: independent of the brake, and mostly of the feedback.
#[derive(Clone, Debug, PartialEq)]
pub struct Drivetrain {
    /// i: magnitude of the reduction ratio.
    pub ratio: Datum<f64>,
    /// T_max: largest torque for acceleration and braking.
    pub torque_max: Datum<Torque>,
    /// n_max: largest output speed, used only if motor speed or ratio are unknown.
    pub speed_max: Datum<AngularVelocity>,
    /// n_mot,max: largest motor speed.
    pub speed_motor_max: Datum<AngularVelocity>,
    /// n_N: rated motor speed, limit of the mean speed.
    pub speed_motor_rated: Datum<AngularVelocity>,
    /// I_max: largest motor current, rms.
    pub current_max: Datum<ElectricCurrent>,
    /// I_E: current at which demagnetisation begins, rms.
    pub current_demagnetisation: Datum<ElectricCurrent>,
    /// T_0: continuous torque at standstill.
    pub stall_torque: Datum<Torque>,
    /// Largest J_L recommended for highly dynamic duty, as a multiple of J_out \[1\].
    pub inertia_ratio_recommended: Datum<f64>,
    /// I_0: current at T_0, rms.
    pub stall_current: Datum<ElectricCurrent>,
    /// Largest I_0 of the motor over all ratios: its thermal limit where the gear limits T_0.
    pub stall_current_motor: Datum<ElectricCurrent>,
    /// I_0 = T_0/k_Tout + I_NLS (680 V windings) if `true`, I_0 = T_0/k_Tout (48 V windings) if `false`.
    pub stall_current_includes_friction: bool,
    /// I_NLS: no-load starting current, rms.
    pub no_load_starting_current: Datum<ElectricCurrent>,
    /// K_INL at the lower temperature of the tables: no-load running current per output speed.
    pub no_load_current_constant_cold: Datum<NoLoadCurrentConstant>,
    /// K_INL at the higher temperature.
    pub no_load_current_constant_warm: Datum<NoLoadCurrentConstant>,
    /// Temperatures to which K_INL applies, the lower one first.
    pub no_load_temperatures: Datum<[ThermodynamicTemperature; 2]>,
    /// Lowest temperature for which friction is stated; it is extrapolated below.
    pub friction_printed_from: Datum<ThermodynamicTemperature>,
    /// Lower and upper growth of friction per kelvin below that temperature \[1/K\]: the band of the extrapolation.
    pub friction_cold_growth: Datum<(f64, f64)>,
    /// k_Tout: torque constant at the output, including gear losses.
    pub torque_constant_out: Datum<TorqueConstant>,
    /// k_TM: torque constant of the motor.
    pub torque_constant_motor: Datum<TorqueConstant>,
    /// k_EM: voltage constant of the motor, line to line, rms.
    pub voltage_constant_motor: Datum<VoltageConstant>,
    /// R_LL: resistance line to line at 20 °C.
    pub resistance_ll: Datum<ElectricalResistance>,
    /// L_LL: inductance line to line.
    pub inductance_ll: Datum<Inductance>,
    /// p: number of pole pairs.
    pub pole_pairs: Datum<f64>,
    /// d_H: bore of the hollow shaft.
    pub hollow_shaft: Datum<Length>,
    /// U_DCmax: largest steady DC link voltage.
    pub dc_link_max: Datum<ElectricPotential>,
    /// U_M: motor terminal voltage (fundamental, line to line, rms) required for the stated performance.
    pub terminal_voltage_min: Datum<ElectricPotential>,
    /// Permitted ambient temperature in operation, lowest and highest.
    pub ambient_range: Datum<(ThermodynamicTemperature, ThermodynamicTemperature)>,
    /// Permissible conditions at the place of installation.
    pub environment: Environment,
    /// Continuous-duty curve of the torque-speed plane, if published or measured.
    pub continuous_curve: Datum<Curve>,
    /// Curves of intermittent duty S3 with 50 % and 25 % of operation, if published.
    pub s3_curves: [Datum<Curve>; 2],
    /// Short-time curve (acceleration and braking), if published; applies from the U_M of the tables on.
    pub short_time_curve: Datum<Curve>,
    /// Calibration of the heat model.
    pub heat: Heat,
    /// Data of the gear.
    pub gear: Gear,
    /// Data of the output bearing.
    pub output_bearing: OutputBearing,
    /// Accuracy of the gear.
    pub accuracy: Accuracy,
    /// Bolted joint of the load on the output flange.
    pub screw_joint_load: ScrewJoint,
    /// Bolted joint of the housing.
    pub screw_joint_housing: ScrewJoint,
}

impl Parameters {
    /// Returns an actuator without any data.
    #[must_use]
    pub fn unknown() -> Self {
        Self {
            drivetrain: Arc::new(Drivetrain::unknown()),
            inertia_out: Datum::NotPrinted,
            mass: Datum::NotPrinted,
            length: Datum::NotPrinted,
            brake: Brake::default(),
            feedback: Feedback::default(),
            ptc_response: Datum::NotPrinted,
            without_kty: false,
            feedback_out: Feedback::absent(FeedbackSide::Output),
        }
    }
}

impl From<Drivetrain> for Parameters {
    /// Creates parameters with a drivetrain and without data of feedback, brake, inertia, mass and length.
    fn from(drivetrain: Drivetrain) -> Self {
        Self { drivetrain: Arc::new(drivetrain), ..Self::unknown() }
    }
}

impl Deref for Parameters {
    type Target = Drivetrain;

    fn deref(&self) -> &Drivetrain {
        &self.drivetrain
    }
}

impl DerefMut for Parameters {
    fn deref_mut(&mut self) -> &mut Drivetrain {
        Arc::make_mut(&mut self.drivetrain)
    }
}

impl Drivetrain {
    /// Returns a drivetrain without any data.
    #[must_use]
    pub fn unknown() -> Self {
        Self {
            ratio: Datum::NotPrinted,
            torque_max: Datum::NotPrinted,
            speed_max: Datum::NotPrinted,
            speed_motor_max: Datum::NotPrinted,
            speed_motor_rated: Datum::NotPrinted,
            current_max: Datum::NotPrinted,
            current_demagnetisation: Datum::NotPrinted,
            stall_torque: Datum::NotPrinted,
            inertia_ratio_recommended: Datum::NotPrinted,
            stall_current: Datum::NotPrinted,
            stall_current_motor: Datum::NotPrinted,
            stall_current_includes_friction: true,
            no_load_starting_current: Datum::NotPrinted,
            no_load_current_constant_cold: Datum::NotPrinted,
            no_load_current_constant_warm: Datum::NotPrinted,
            no_load_temperatures: Datum::NotPrinted,
            friction_printed_from: Datum::NotPrinted,
            friction_cold_growth: Datum::NotPrinted,
            torque_constant_out: Datum::NotPrinted,
            torque_constant_motor: Datum::NotPrinted,
            voltage_constant_motor: Datum::NotPrinted,
            resistance_ll: Datum::NotPrinted,
            inductance_ll: Datum::NotPrinted,
            pole_pairs: Datum::NotPrinted,
            hollow_shaft: Datum::NotPrinted,
            dc_link_max: Datum::NotPrinted,
            terminal_voltage_min: Datum::NotPrinted,
            ambient_range: Datum::NotPrinted,
            environment: Environment::default(),
            continuous_curve: Datum::NotPrinted,
            s3_curves: [Datum::NotPrinted, Datum::NotPrinted],
            short_time_curve: Datum::NotPrinted,
            heat: Heat::default(),
            gear: Gear::default(),
            output_bearing: OutputBearing::default(),
            accuracy: Accuracy::default(),
            screw_joint_load: ScrewJoint::default(),
            screw_joint_housing: ScrewJoint::default(),
        }
    }
}
