//! Mechanisms of the project file: a module for each that builds it from its section.

mod parts;

use crate::assumption::{Assumption, unstated};
use crate::driven::{Driven, TURNED};
use crate::fault::AxisReport;
use crate::source::AxisSource;
use mechanism::{Mechanism, MechanismKind, Rotor};
use parts::friction;
use project::sections::{DirectLoad, Fields, Guide, Losses, Mechanisms, Parts, Stated, StatedField, group};
use project::{Fault, Hint, KeyDefault};
use quantities::{Angle, Dimension, Force, Measure};

/// Defines the modules of the mechanisms and the list of those that a file states.
macro_rules! mechanisms {
    ($($name:ident)+) => {
        $(mod $name;)+

        /// Returns the stated mechanisms.
        fn given(all: &Mechanisms) -> impl Iterator<Item = &dyn Driven> {
            [$(all.$name.get().map(|section| section as &dyn Driven)),+].into_iter().flatten()
        }

        /// Names of the tables of the mechanisms.
        #[cfg(test)]
        const LISTED: &[&str] = &[$(stringify!($name)),+];
    };
}

mechanisms! { turntable arm screw belt conveyor slider_crank joint table hoist winder scissor_lift four_bar }

/// Returns every stated load: `[load]` and the tables of `[mechanism]`, in the order of the file.
fn loads(parts: &Parts) -> Vec<&dyn Driven> {
    let direct = parts.load.get().map(|load| load as &dyn Driven);
    let mut through: Vec<&dyn Driven> = parts.mechanism.get().into_iter().flat_map(given).collect();
    through.sort_by_key(|each| each.head().span.start);
    direct.into_iter().chain(through).collect()
}

/// Returns the load: `[load]`, or the table of the mechanism.
pub(crate) fn driven(parts: &Parts) -> Option<&dyn Driven> {
    loads(parts).into_iter().next()
}

impl Driven for DirectLoad {
    fn kind(&self, _: &mut AxisReport<'_>) -> Option<MechanismKind> {
        Some(MechanismKind::Rotor(Rotor::balanced(self.inertia.value()?)))
    }

    fn shared(&self) -> &'static [Dimension] {
        TURNED
    }
}

/// The load, and its position at the start of the motion.
pub(crate) struct BuiltLoad {
    pub(crate) mechanism: Mechanism,
    pub(crate) start: Option<Angle>,
    /// Process force that acts in every segment.
    pub(crate) force: Force,
}

/// Example of a load that moves along a line.
pub(crate) const OF_A_LINE: &str = "[mechanism.screw] lead = \"20 mm\", mass = \"25 kg\"";

/// Builds the one load of the axis.
pub(crate) fn load(axis: &AxisSource, report: &mut AxisReport<'_>) -> Option<BuiltLoad> {
    let parts = &axis.parts;
    match loads(parts).as_slice() {
        [driven] => build(*driven, report),
        [] => {
            // A faulty load has been reported already, and a load that could not be read may be present.
            let misread = |all: &Mechanisms| all.head().has_strays || all.fields().iter().any(|each| each.is_written());
            let there = parts.load.is_written() || parts.mechanism.get().is_some_and(misread);
            if !there && !report.is_damaged() {
                // A moment of inertia turns no millimetres into an angle.
                let example = if axis.moves_along_a_line() { OF_A_LINE } else { "[load] inertia = \"1.3 kg m^2\"" };
                let hint = Hint::Example(example.to_owned());
                report.fault(parts.mechanism.span(), Fault::NoMechanism, Some(hint));
            }
            None
        }
        [_, second, ..] => {
            report.fault(second.head().span.clone(), Fault::TooManyMechanisms, None);
            None
        }
    }
}

fn build(driven: &dyn Driven, report: &mut AxisReport<'_>) -> Option<BuiltLoad> {
    let kind = driven.kind(report)?;
    let mechanism = Mechanism {
        kind,
        friction: driven.friction().map_or_else(mechanism::Friction::none, friction),
        efficiency_driving: driven.losses().map_or(1.0, Losses::efficiency),
        efficiency_driven: driven.losses().map_or(1.0, Losses::efficiency_back),
        stage: None,
    };
    let start = driven.start_angle().and_then(Stated::value);
    let force = driven.process_force().map_or_else(|| Force::from_si(0.0), Stated::or_zero);
    Some(BuiltLoad { mechanism, start, force })
}

/// Adds the defaults about the load that the file leaves open.
pub(crate) fn assumptions(driven: &dyn Driven, found: &mut Vec<Assumption>) {
    if let Some(friction) = driven.friction() {
        let mut fields: Vec<&dyn StatedField> = vec![&friction.friction_torque, &friction.viscous_friction];
        fields.extend(group(driven).into_iter().flat_map(|guide: &Guide| guide.fields()));
        if !fields.iter().any(|field| field.is_given()) {
            found.extend(unstated(&friction.friction_torque));
        }
    }
    if let Some(losses) = driven.losses() {
        found.extend(unstated(&losses.efficiency).or_else(|| unstated(&losses.efficiency_back)));
    }
    // Those of friction and losses depend on each other and are listed above.
    let apart = [KeyDefault::NoFriction, KeyDefault::NoLosses, KeyDefault::LossesDoNotHelp];
    for default in driven.fields().into_iter().filter_map(StatedField::note) {
        let listed = Assumption::Default(default);
        if !apart.contains(&default) && !found.contains(&listed) && !driven.is_without_effect(default) {
            found.push(listed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::LISTED;

    #[test]
    fn every_mechanism_of_the_file_is_built() {
        let table = project::KEYS.iter().find(|key| key.name == "mechanism").unwrap();
        let names: Vec<&str> = table.kind.keys(false).iter().map(|key| key.name).collect();
        assert_eq!(names, LISTED);
    }
}
