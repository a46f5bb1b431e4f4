//! Mechanisms of the project file: a module for each, with its section.

mod parts;

use crate::about::About;
use crate::section::section;
use parts::Friction;
use quantities::MomentOfInertia;

/// Defines the table of the mechanisms and the names of their keys from a list.
macro_rules! mechanisms {
    ($($name:ident: $Section:ident, $Name:ident;)+) => {
        $(
            mod $name;
            use $name::$Section;
        )+

        /// The mechanisms, and the keys that several of them have.
        pub(crate) mod sections {
            $(pub use super::$name::$Section;)+
            pub use super::parts::{Counterweight, Friction, Guide, Losses, ProcessForce, Slide, StartAngle};
            pub use super::{DirectLoad, Mechanisms};
        }

        /// Names of their keys.
        pub(crate) mod names {
            $(pub use super::$name::$Name;)+
            pub use super::parts::{
                CounterweightName, FrictionName, GuideName, LossesName, ProcessForceName, SlideName, StartAngleName,
            };
            pub use super::{LoadName, MechanismName, MechanismsName};
        }

        section! {
            /// Mechanism between output and load.
            Mechanisms, MechanismsName of About::Mechanisms {
                $($name: $Section;)+
            }
        }

        /// A key of a mechanism.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum MechanismName {
            $(
                #[allow(missing_docs, reason = "each is named as its mechanism")]
                $Section(names::$Name),
            )+
        }
    };
}

mechanisms! {
    turntable: Turntable, TurntableName;
    arm: Arm, ArmName;
    screw: Screw, ScrewName;
    belt: Belt, BeltName;
    conveyor: Conveyor, ConveyorName;
    slider_crank: SliderCrank, SliderCrankName;
    joint: Joint, JointName;
    table: Table, TableName;
    hoist: Hoist, HoistName;
    winder: Winder, WinderName;
    scissor_lift: ScissorLift, ScissorLiftName;
    four_bar: FourBar, FourBarName;
}

section! {
    /// Load inertia referred to the output.
    DirectLoad, LoadName of About::Load {
        inertia: MomentOfInertia => not_negative, needed;
        ..friction: Friction;
    }
}
