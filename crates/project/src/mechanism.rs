//! Mechanisms of the project file: a module for each, with its section and the mechanism that is built from it.

mod parts;

use crate::about::About;
use crate::bodies::BodySection;
use crate::flange::Bearing;
use crate::read::Reader;
use crate::root::Parts;
use crate::section::{Fields, group, section};
use crate::stated::{Stated, StatedField};
use crate::{Assumption, Fault, Hint};
use mechanism::{Geometry, Mechanism, MechanismKind, Rotor};
use parts::{Friction, Guide, Losses, ProcessForce, StartAngle};
use quantities::{Angle, Force, Measure, MomentOfInertia};

/// Defines the table of the mechanisms and the names of their keys from a list.
macro_rules! mechanisms {
    ($($name:ident: $Section:ident, $Name:ident;)+) => {
        $(
            mod $name;
            use $name::$Section;
        )+

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

        impl Mechanisms {
            /// Returns the stated mechanisms.
            fn given(&self) -> impl Iterator<Item = &dyn Driven> {
                [$(self.$name.get().map(|section| section as &dyn Driven)),+].into_iter().flatten()
            }
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

/// Part that loads the flange.
pub(crate) enum OnFlange<'s> {
    /// Bodies that turn with the flange; the tilt of its axis.
    Bodies(&'s Stated<Angle>),
    /// A pulley, pinion or crank.
    Wheel,
    /// The shaft of a mechanism with bearings of its own, whose share of the forces must be stated.
    Shaft,
}

/// A load, or a mechanism with its load, as the file states it.
pub(crate) trait Driven: Fields {
    /// Builds the mechanism; `None` after a fault or if a value is missing.
    fn kind(&self, reader: &mut Reader<'_>) -> Option<MechanismKind>;

    /// Returns the keys from which its inertia follows.
    fn inertia(&self) -> Vec<&dyn StatedField> {
        self.field("inertia").into_iter().collect()
    }

    /// Returns the friction at the output.
    fn friction(&self) -> Option<&Friction> {
        group(self)
    }

    /// Returns the efficiencies.
    fn losses(&self) -> Option<&Losses> {
        group(self)
    }

    /// Returns `true` if a default has no effect on the result and is not listed.
    fn is_without_effect(&self, _default: Assumption) -> bool {
        false
    }

    /// Returns the force of the process along the line of the load, if there is such a line.
    fn process_force(&self) -> Option<&Stated<Force>> {
        group(self).map(|it: &ProcessForce| &it.process_force)
    }

    /// Returns `true` if a payload moves with the load.
    fn carries(&self) -> bool {
        self.process_force().is_some()
    }

    /// Returns the position at which the motion begins.
    fn start_angle(&self) -> Option<&Stated<Angle>> {
        group(self).map(|it: &StartAngle| &it.start_angle)
    }

    /// Returns the key from which the linear travel per turn follows, if that is constant.
    fn travel(&self) -> Option<&dyn StatedField> {
        None
    }

    /// Returns the key from which the travel of the load per turn follows, if it is a single one.
    fn gearing(&self) -> Option<&dyn StatedField> {
        self.travel()
    }

    /// Returns its solid bodies; `None` for other loads.
    fn bodies(&self) -> Option<&[BodySection]> {
        None
    }

    /// Returns `true` if its torque is recorded with the motion, including friction and losses.
    fn torque_is_recorded(&self) -> bool {
        false
    }

    /// Returns the part that loads the flange; `None` if no loads follow.
    fn on_flange(&self) -> Option<OnFlange<'_>> {
        None
    }

    /// Returns the keys of `[bearing]` from which its loads on the flange follow.
    fn flange_keys<'b>(&self, bearing: &'b Bearing) -> Vec<&'b dyn StatedField> {
        match self.on_flange() {
            Some(OnFlange::Bodies(_)) => vec![&bearing.overhang, &bearing.payload_overhang, &bearing.flange_share],
            Some(OnFlange::Wheel | OnFlange::Shaft) => {
                vec![&bearing.overhang, &bearing.flange_share, &bearing.wheel_mass, &bearing.axis_tilt]
            }
            None => Vec::new(),
        }
    }
}

section! {
    /// Load inertia referred to the output.
    DirectLoad, LoadName of About::Load {
        inertia: MomentOfInertia => not_negative, needed;
        ..friction: Friction;
    }
}

impl Driven for DirectLoad {
    fn kind(&self, _: &mut Reader<'_>) -> Option<MechanismKind> {
        Some(MechanismKind::Rotor(Rotor::balanced(self.inertia.value()?)))
    }
}

/// Reports every fault of the lengths and angles of a mechanism.
fn sound(section: &impl Fields, faults: Vec<Geometry>, reader: &mut Reader<'_>) -> Option<()> {
    let is_sound = faults.is_empty();
    for fault in faults {
        let span = section.field(fault.key()).map_or_else(|| section.head().span.clone(), StatedField::span);
        reader.fault(span, Fault::Geometry(fault), None);
    }
    is_sound.then_some(())
}

/// The load, and its position at the start of the motion.
pub(crate) struct Load {
    pub(crate) mechanism: Mechanism,
    pub(crate) start: Option<Angle>,
    /// Process force that acts in every segment.
    pub(crate) force: Force,
}

impl Parts {
    /// Returns every stated load: `[load]` and the tables of `[mechanism]`, in the order of the file.
    fn loads(&self) -> Vec<&dyn Driven> {
        let direct = self.load.get().map(|load| load as &dyn Driven);
        let mut through: Vec<&dyn Driven> = self.mechanism.get().into_iter().flat_map(Mechanisms::given).collect();
        through.sort_by_key(|each| each.head().span.start);
        direct.into_iter().chain(through).collect()
    }

    /// Returns the load: `[load]`, or the table of the mechanism.
    pub(crate) fn driven(&self) -> Option<&dyn Driven> {
        self.loads().into_iter().next()
    }
}

/// Builds the one load of the axis.
pub(crate) fn load(parts: &Parts, reader: &mut Reader<'_>) -> Option<Load> {
    match parts.loads().as_slice() {
        [driven] => build(*driven, reader),
        [] => {
            // A faulty load has been reported already, and a load that could not be read may be present.
            let misread = |all: &Mechanisms| all.head().has_strays || all.fields().iter().any(|each| each.is_written());
            let there = parts.load.is_written() || parts.mechanism.get().is_some_and(misread);
            if !there && !reader.is_damaged() {
                let hint = Hint::Example("[load] inertia = \"1.3 kg m^2\"".to_owned());
                reader.fault(parts.mechanism.span(), Fault::NoMechanism, Some(hint));
            }
            None
        }
        [_, second, ..] => {
            reader.fault(second.head().span.clone(), Fault::TooManyMechanisms, None);
            None
        }
    }
}

fn build(driven: &dyn Driven, reader: &mut Reader<'_>) -> Option<Load> {
    let kind = driven.kind(reader)?;
    let mechanism = Mechanism {
        kind,
        friction: driven.friction().map_or_else(mechanism::Friction::none, Friction::build),
        efficiency_driving: driven.losses().map_or(1.0, Losses::efficiency),
        efficiency_driven: driven.losses().map_or(1.0, Losses::efficiency_back),
        stage: None,
    };
    let start = driven.start_angle().and_then(Stated::value);
    let force = driven.process_force().map_or_else(|| Force::from_si(0.0), Stated::or_zero);
    Some(Load { mechanism, start, force })
}

/// Adds the defaults about the load that the file leaves open.
pub(crate) fn assumptions(driven: &dyn Driven, found: &mut Vec<Assumption>) {
    if let Some(friction) = driven.friction() {
        let mut fields: Vec<&dyn StatedField> = vec![&friction.friction_torque, &friction.viscous_friction];
        fields.extend(group(driven).into_iter().flat_map(|guide: &Guide| guide.fields()));
        if !fields.iter().any(|field| field.is_given()) {
            found.extend(friction.friction_torque.note());
        }
    }
    if let Some(losses) = driven.losses() {
        found.extend(losses.efficiency.note().or_else(|| losses.efficiency_back.note()));
    }
    // Those of friction and losses depend on each other and are listed above.
    let apart = [Assumption::NoFriction, Assumption::NoLosses, Assumption::LossesDoNotHelp];
    for default in driven.fields().into_iter().filter_map(StatedField::note) {
        if !apart.contains(&default) && !found.contains(&default) && !driven.is_without_effect(default) {
            found.push(default);
        }
    }
}
