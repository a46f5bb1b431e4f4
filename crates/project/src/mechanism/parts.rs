//! Keys that several mechanisms have.

use crate::KeyDefault;
use crate::about::About;
use crate::section::section;
use quantities::{Angle, Force, Mass, MomentOfInertia, Torque, ViscousFriction};

section! {
    /// Friction and constant torque at the output.
    Friction, FrictionName of About::Friction {
        friction_torque: Torque => not_negative, noted(KeyDefault::NoFriction);
        viscous_friction: ViscousFriction => not_negative;
        external_torque: Torque;
    }
}

section! {
    /// Efficiencies between output and load.
    Losses, LossesName of About::Losses {
        efficiency: f64 = 1.0 => within(0.01, 1.0), example("0.9"), noted(KeyDefault::NoLosses);
        efficiency_back: f64 = 1.0 => within(0.0, 1.0), example("0.8"), noted(KeyDefault::LossesDoNotHelp);
    }
}

section! {
    /// A mass on a line, and the inertia that turns with the output.
    Slide, SlideName of About::Slide {
        mass: Mass => not_negative, needed;
        inertia: MomentOfInertia => not_negative, noted(KeyDefault::PartsWithoutInertia);
        inclination: Angle => noted(KeyDefault::TravelHorizontal);
    }
}

section! {
    /// A counterweight.
    Counterweight, CounterweightName of About::Counterweight {
        counterweight: Mass => not_negative;
    }
}

section! {
    /// Friction along a line.
    Guide, GuideName of About::Guide {
        friction_force: Force => not_negative;
        friction_coefficient: f64 = 0.0 => within(0.0, 10.0), example("0.05");
    }
}

section! {
    /// A force along a line.
    ProcessForce, ProcessForceName of About::ProcessForce {
        process_force: Force;
    }
}

section! {
    /// Position at the beginning of the motion.
    StartAngle, StartAngleName of About::StartAngle {
        start_angle: Angle => noted(KeyDefault::StartsAtZero);
    }
}
