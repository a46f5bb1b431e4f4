//! Assumptions of an axis with the keys that state them, and the values in effect.

use crate::assumption::Assumption;
use crate::axis_project::AxisProject;
use crate::mechanism::driven;
use crate::motion::turns_once;
use crate::web::RAMP_S;
use project::sections::{Bearing, Fields, RequirementsSection, Section, StatedField};
use project::{KeyDefault, SegmentLaw};
use quantities::Measure;

/// An assumption with the keys that state it.
#[derive(Clone, Debug, PartialEq)]
pub struct AssumedKeys {
    /// The assumption.
    pub assumption: Assumption,
    /// Paths of the keys that take its place, as of the axis in its file; empty if no key does.
    pub keys: Vec<String>,
    /// Value in effect, as the keys state it; `None` if no value is.
    pub value: Option<String>,
    /// Usual value where none is in effect, as the keys state it.
    pub usual: Option<String>,
    /// The value can be stated without a further key.
    pub is_alone: bool,
}

/// Usual voltage of the DC link behind a mains of 400 V \[V\].
const SUPPLY_USUAL: &str = "560 V";

/// Highest ambient temperature for which the manual's data hold.
const AMBIENT: &str = "40 degC";

impl AxisProject {
    /// Returns the assumptions with their keys, in the order of [`AxisProject::assumptions`].
    #[must_use]
    pub fn assumed(&self) -> Vec<AssumedKeys> {
        self.assumptions.iter().map(|each| self.assumed_of(*each)).collect()
    }

    fn assumed_of(&self, assumption: Assumption) -> AssumedKeys {
        let root = &self.root;
        let none = |keys: Vec<String>| AssumedKeys { assumption, keys, value: None, usual: None, is_alone: true };
        let with = |keys: Vec<String>, value: &str| AssumedKeys { value: Some(value.to_owned()), ..none(keys) };
        let of_segments = |law: SegmentLaw, fields: fn(&project::sections::Segment) -> Vec<&dyn StatedField>| {
            let segments = root.segments().iter().filter(move |segment| segment.law.value() == Some(law));
            segments.flat_map(fields).map(StatedField::path).collect::<Vec<String>>()
        };
        match assumption {
            Assumption::Default(default) => self.assumed_default(default),
            Assumption::OfTemplate(figure) => {
                AssumedKeys { is_alone: false, ..with(vec![root.path(figure.path)], figure.value) }
            }
            Assumption::LawOpen => {
                let word = SegmentLaw::Law(SegmentLaw::ASSUMED).id();
                with(of_segments(SegmentLaw::Open, |segment| vec![&segment.law]), word)
            }
            Assumption::OneRevolution => {
                let turns = root.segments().iter().filter(|segment| turns_once(segment));
                with(turns.map(|segment| segment.distance.path()).collect(), "360 deg")
            }
            Assumption::WebRamps => {
                let open = of_segments(SegmentLaw::Web, |segment| {
                    let ramps: [&dyn StatedField; 2] = [&segment.accelerate, &segment.brake];
                    ramps.into_iter().filter(|field| !field.is_given()).collect()
                });
                with(open, &format!("{RAMP_S} s"))
            }
            Assumption::ArmIsRod => with(self.of_the_load("shape"), "rod"),
            Assumption::PayloadAtArmEnd => {
                let mechanism::MechanismKind::Rotor(rotor) = &self.axis.mechanism.kind else { return none(Vec::new()) };
                with(self.of_the_load("payload_distance"), &millimetres(rotor.payload_radius.si()))
            }
            Assumption::NoFlangeLoads => none(vec![root.path("bearing.radial_force")]),
            Assumption::ConditionsWithinRange => {
                let absent = RequirementsSection::absent(root.head());
                let section = root.parts.requirements.get().unwrap_or(&absent);
                let fields: [&dyn StatedField; 6] = [
                    &section.altitude,
                    &section.protection,
                    &section.humidity_max,
                    &section.vibration,
                    &section.shock,
                    &section.mounting,
                ];
                let open = fields.into_iter().filter(|field| !field.is_given());
                let keys = open.map(|field| root.path(&format!("requirements.{}", field.name()))).collect();
                none(keys)
            }
            Assumption::RectifierAndDeviation | Assumption::SinglePhaseRectifierAndDeviation => {
                with(vec![root.path("requirements.mains_deviation")], "0.1")
            }
            _ => none(Vec::new()),
        }
    }

    /// Returns the default of a key with its path and its value.
    fn assumed_default(&self, default: KeyDefault) -> AssumedKeys {
        let assumption = Assumption::Default(default);
        let keys = self.keys_of(default);
        let usual = (default == KeyDefault::NoSupply).then(|| SUPPLY_USUAL.to_owned());
        let value = match default {
            KeyDefault::NoSupply | KeyDefault::OrdinaryApplication | KeyDefault::StageRigid => None,
            KeyDefault::AmbientWithinRange => Some(AMBIENT.to_owned()),
            KeyDefault::RollToWind => self.roll_to_wind(),
            KeyDefault::AxisLevel => Some("90 deg".to_owned()),
            KeyDefault::FlangeBearsAll => Some("1".to_owned()),
            // The default of a number or a word is part of its key; that of a quantity is zero in the unit of its example.
            _ => keys.first().and_then(|key| default_of(key)),
        };
        // The weight of a wheel needs the tilt of its axis.
        AssumedKeys { assumption, keys, value, usual, is_alone: default != KeyDefault::WheelWeightless }
    }

    /// Returns the paths of the keys with a default that are not stated.
    fn keys_of(&self, default: KeyDefault) -> Vec<String> {
        let parts = &self.root.parts;
        let is_open = |field: &&dyn StatedField| field.note() == Some(default);
        if default == KeyDefault::MotorHolds {
            let rests = self.root.segments().iter().filter(|each| each.law.value() == Some(SegmentLaw::Dwell));
            return rests.map(|each| &each.hold as &dyn StatedField).filter(is_open).map(StatedField::path).collect();
        }
        if default == KeyDefault::ModulationReserve || is_of_requirements(default) {
            let absent = RequirementsSection::absent(self.root.head());
            let section = parts.requirements.get().unwrap_or(&absent);
            let open = section.fields().into_iter().filter(is_open);
            return open.map(|field| self.root.path(&format!("requirements.{}", field.name()))).collect();
        }
        let of_load = driven(parts).map(|driven| driven.fields()).unwrap_or_default();
        let of_stage = parts.stage.get().map(Fields::fields).unwrap_or_default();
        let mut found: Vec<String> =
            of_load.into_iter().chain(of_stage).filter(is_open).map(StatedField::path).collect();
        if found.is_empty() {
            let absent = Bearing::absent(self.root.head());
            let bearing = parts.bearing.get().unwrap_or(&absent);
            let open = bearing.fields().into_iter().filter(is_open);
            found = open.map(|field| self.root.path(&format!("bearing.{}", field.name()))).collect();
        }
        found
    }

    /// Returns the diameter at which a winder begins, as written in a file.
    fn roll_to_wind(&self) -> Option<String> {
        let mechanism::MechanismKind::Winder(winder) = &self.axis.mechanism.kind else { return None };
        Some(millimetres(winder.start_diameter.si()))
    }

    /// Returns the path of a key of the load.
    fn of_the_load(&self, key: &str) -> Vec<String> {
        driven(&self.root.parts).and_then(|driven| driven.field(key)).map(StatedField::path).into_iter().collect()
    }
}

/// Returns a length as written in a file.
fn millimetres(si: f64) -> String {
    let millimetres = si * 1e3;
    // Rounding of the unit adds no digits.
    let short = format!("{millimetres:.12e}").parse::<f64>().unwrap_or(millimetres);
    format!("{short} mm")
}

const fn is_of_requirements(default: KeyDefault) -> bool {
    matches!(default, KeyDefault::NoSupply | KeyDefault::AmbientWithinRange | KeyDefault::OrdinaryApplication)
}

/// Returns the default of a key as written: that of its description, or zero.
fn default_of(path: &str) -> Option<String> {
    let key = project::key_at(path)?;
    if let Some(default) = key.default {
        return Some(default());
    }
    let project::Kind::Quantity(dimension, _) = key.kind else { return None };
    Some(format!("0 {}", dimension.example().split_once(' ')?.1))
}
