//! Loads on the output flange: stated ones, and those that follow from the mechanism.

use crate::about::About;
use crate::mechanism::OnFlange;
use crate::read::Reader;
use crate::root::AxisSection;
use crate::section::{Section, section};
use crate::stated::StatedField;
use crate::value::choices;
use crate::{Assumption, Fault, Hint};
use actuator::FlangeLoad;
use mechanism::{Contact, Mechanism, Mounting, StageKind};
use quantities::unit::DEGREE;
use quantities::{Angle, Force, Length, Mass, Measure};
use sizing::{BearingDuty, DerivedLoads, OperatingCondition};

section! {
    /// Loads on the output flange.
    FlangeLoads, FlangeLoadsName of About::FlangeLoads {
        radial_force: Force => not_negative;
        radial_distance: Length => not_negative;
        axial_force: Force => not_negative;
        axial_distance: Length => not_negative;
    }
}

section! {
    /// Loads on the output flange, and the way in which the mechanism loads it.
    Bearing, BearingName of About::Bearing {
        ..loads: FlangeLoads;
        load_factor: f64 => within(1.0, 3.0), example("1.2");
        operating_condition: OperatingCondition;
        mechanism: Derived;
        overhang: Length;
        payload_overhang: Length;
        flange_share: f64 => within(0.0, 1.0), example("0.5"), noted(Assumption::FlangeBearsAll);
        belt_tension: Force => not_negative;
        pressure_angle: Angle => positive, example("20 deg");
        helix_angle: Angle => not_negative, example("15 deg"), noted(Assumption::SpurTeeth);
        wheel_mass: Mass => not_negative, example("1.2 kg"), noted(Assumption::WheelWeightless);
        axis_tilt: Angle;
    }
}

/// Largest pressure or helix angle of teeth.
const TOOTH_ANGLE_MAX_DEG: f64 = 60.0;

/// Use of the loads of the mechanism in addition to the stated ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Derived {
    /// They are added.
    Add,
    /// The loads of a segment replace them there.
    Replace,
    /// They are ignored.
    Ignore,
}

choices! {
    Derived { Add = "add", Replace = "replace", Ignore = "ignore" }
    OperatingCondition { Normal = "normal", Shock = "shock", HighAccuracy = "high_accuracy" }
}

impl FlangeLoads {
    /// Returns the first stated load.
    fn first(&self) -> Option<&dyn StatedField> {
        let forces: [&dyn StatedField; 2] = [&self.radial_force, &self.axial_force];
        forces.into_iter().find(|field| field.is_given())
    }

    /// Returns `true` if a load is stated.
    fn states_load(&self) -> bool {
        self.first().is_some()
    }

    fn build(&self) -> FlangeLoad {
        FlangeLoad {
            radial_force: self.radial_force.or_zero(),
            radial_distance: self.radial_distance.or_zero(),
            axial_force: self.axial_force.or_zero(),
            axial_distance: self.axial_distance.or_zero(),
        }
    }

    /// Reports a force without its distance, and the reverse.
    fn pairs(&self, reader: &mut Reader<'_>) {
        let pairs: [[&dyn StatedField; 2]; 2] =
            [[&self.radial_force, &self.radial_distance], [&self.axial_force, &self.axial_distance]];
        for [force, distance] in pairs {
            needs(force, distance, reader);
            needs(distance, force, reader);
        }
    }
}

/// Reports a key that is stated without another one that it needs.
pub(crate) fn needs(given: &dyn StatedField, needed: &dyn StatedField, reader: &mut Reader<'_>) {
    if given.is_given() && !needed.is_written() {
        reader.fault(given.span(), Fault::MissingKey { path: needed.path(), list: false }, None);
    }
}

impl Bearing {
    /// Returns the keys of the geometry from which loads follow.
    fn geometry(&self) -> [&dyn StatedField; 8] {
        [
            &self.overhang,
            &self.payload_overhang,
            &self.flange_share,
            &self.belt_tension,
            &self.pressure_angle,
            &self.helix_angle,
            &self.wheel_mass,
            &self.axis_tilt,
        ]
    }

    /// Returns the keys that have an effect on the loads of a stage.
    fn of_stage(&self, kind: StageKind) -> Vec<&dyn StatedField> {
        let mut fields: Vec<&dyn StatedField> = vec![&self.overhang, &self.flange_share];
        match kind {
            StageKind::Belt => fields.push(&self.belt_tension),
            StageKind::Gear => fields.extend([&self.pressure_angle as &dyn StatedField, &self.helix_angle]),
            StageKind::Coupling => {}
        }
        fields.extend([&self.wheel_mass as &dyn StatedField, &self.axis_tilt]);
        fields
    }
}

/// Returns the use of the loads of the mechanism, as stated or by default: if the file states no load, those of the
/// mechanism act, provided that it describes the masses and forces from which they follow. With stated loads the file
/// must state their use, see [`undecided`]. `None` if those of the mechanism are ignored.
fn how(axis: &AxisSection) -> Option<Derived> {
    let stated = axis.parts.bearing.get().and_then(|section| section.mechanism.value());
    let by_default = || (loads_flange(axis) && states_loads(axis).is_none()).then_some(Derived::Add);
    stated.or_else(by_default).filter(|derived| *derived != Derived::Ignore)
}

/// Returns `true` if the mechanism or its stage describes loads on the flange.
fn loads_flange(axis: &AxisSection) -> bool {
    axis.parts.stage.is_given() || axis.driven().is_some_and(|driven| driven.on_flange().is_some())
}

/// Returns the first stated load on the flange.
fn states_loads(axis: &AxisSection) -> Option<&dyn StatedField> {
    let common = axis.parts.bearing.get().map(|section| &section.loads);
    let of_segments = axis.segments().iter().filter_map(|segment| segment.bearing.get());
    common.into_iter().chain(of_segments).find_map(FlangeLoads::first)
}

/// Reports loads that are stated next to a mechanism with loads of its own, without a statement of their use: both
/// adding and ignoring them would be a guess. Returns `true` if it did.
fn undecided(axis: &AxisSection, reader: &mut Reader<'_>) -> bool {
    let decided = axis.parts.bearing.get().is_some_and(|section| section.mechanism.is_written());
    let Some(field) = states_loads(axis).filter(|_| !decided && loads_flange(axis)) else { return false };
    let fault = Fault::FlangeLoadsUndecided { key: field.name(), section: axis.path("bearing") };
    reader.fault(field.span(), fault, None);
    true
}

/// Returns the loads on the flange and the requirements on the bearing.
pub(crate) fn duty(axis: &AxisSection, mechanism: &Mechanism, reader: &mut Reader<'_>) -> BearingDuty {
    let absent = Bearing::absent(axis.head());
    let section = axis.parts.bearing.get().unwrap_or(&absent);
    let own: Vec<Option<&FlangeLoads>> = axis.segments().iter().map(|segment| segment.bearing.get()).collect();
    let undecided = undecided(axis, reader);
    let how = how(axis);
    let derived = how.and_then(|how| {
        let mounting = mounting(axis, section, (mechanism, how), reader)?;
        let acts = own.iter().map(|own| how == Derived::Add || own.is_none()).collect();
        Some(DerivedLoads { mounting, acts })
    });
    if how.is_none() && !undecided {
        for field in section.geometry().into_iter().filter(|field| field.is_given()) {
            let hint = Hint::Example("mechanism = \"add\"".to_owned());
            reader.fault(field.span(), Fault::WithoutEffect { key: field.name() }, Some(hint));
        }
    }
    let requirements = axis.parts.requirements.get();
    BearingDuty {
        has_loads: derived.is_some() || section.loads.states_load() || own.iter().any(Option::is_some),
        loads: own.into_iter().map(|own| own.unwrap_or(&section.loads).build()).collect(),
        derived,
        load_factor: section.load_factor.value(),
        operating_condition: section.operating_condition.value(),
        life_min: requirements.and_then(|section| section.bearing_life_min.value()),
        tilt_max: requirements.and_then(|section| section.tilt_angle_max.value()),
    }
}

/// Reports faults of the stated loads that need no mechanism: a force needs its distance.
pub(crate) fn stated(axis: &AxisSection, reader: &mut Reader<'_>) {
    if let Some(section) = axis.parts.bearing.get() {
        section.loads.pairs(reader);
    }
    for loads in axis.segments().iter().filter_map(|segment| segment.bearing.get()) {
        loads.pairs(reader);
    }
}

/// Returns the position of the load on the flange; values that are not stated stay open, and the checks that need them
/// report so.
fn mounting(
    axis: &AxisSection,
    section: &Bearing,
    (mechanism, how): (&Mechanism, Derived),
    reader: &mut Reader<'_>,
) -> Option<Mounting> {
    if !mechanism.knows_flange_forces() {
        reader.fault(section.mechanism.span(), Fault::NoFlangeLoads, Some(Hint::MechanismsWithLoads));
        return None;
    }
    let valid: Vec<&dyn StatedField> = match &mechanism.stage {
        Some(stage) => section.of_stage(stage.kind),
        None => axis.driven().map(|driven| driven.flange_keys(section)).unwrap_or_default(),
    };
    let names: Vec<&str> = valid.iter().map(|field| field.name()).collect();
    let has_effect = |field: &dyn StatedField| names.contains(&field.name());
    for field in section.geometry().into_iter().filter(|field| field.is_given() && !has_effect(*field)) {
        reader.fault(field.span(), Fault::WithoutEffect { key: field.name() }, Some(Hint::valid(&names)));
    }
    if how == Derived::Replace {
        let forces: [&dyn StatedField; 2] = [&section.loads.radial_force, &section.loads.axial_force];
        for field in forces.into_iter().filter(|field| field.is_given()) {
            reader.fault(field.span(), Fault::ReplacesEverything { key: field.name() }, None);
        }
    }
    for field in [&section.pressure_angle, &section.helix_angle] {
        if field.value().is_some_and(|angle| angle.in_unit(&DEGREE) > TOOTH_ANGLE_MAX_DEG) {
            let fault = Fault::ToothAngle { key: field.name(), most_deg: TOOTH_ANGLE_MAX_DEG };
            reader.fault(field.span(), fault, None);
        }
    }
    let (tension, pressure) = (section.belt_tension.value(), section.pressure_angle.value());
    if tension.is_some() && pressure.is_some() {
        reader.fault(section.pressure_angle.span(), Fault::BeltOrTeeth, None);
    }
    let pairs: [[&dyn StatedField; 2]; 3] = [
        [&section.helix_angle, &section.pressure_angle],
        [&section.wheel_mass, &section.axis_tilt],
        [&section.axis_tilt, &section.wheel_mass],
    ];
    for [given, needed] in pairs.into_iter().filter(|[given, _]| has_effect(*given)) {
        needs(given, needed, reader);
    }
    let contact = match (tension, pressure) {
        (Some(tension), _) => Some(Contact::Belt { tension }),
        (None, Some(pressure_angle)) => {
            Some(Contact::Mesh { pressure_angle, helix_angle: section.helix_angle.or_zero() })
        }
        (None, None) => None,
    };
    Some(Mounting {
        overhang: section.overhang.value(),
        payload_overhang: section.payload_overhang.value(),
        share: section.flange_share.value(),
        contact,
        wheel_mass: section.wheel_mass.value(),
        axis_tilt: section.axis_tilt.value(),
    })
}

/// Adds the defaults about the loads on the flange that the file leaves open.
pub(crate) fn assumptions(axis: &AxisSection, found: &mut Vec<Assumption>) {
    let absent = Bearing::absent(axis.head());
    let section = axis.parts.bearing.get().unwrap_or(&absent);
    let has_own = axis.has_loads_of_segments();
    let states = section.loads.states_load();
    let how = how(axis);
    let Some(how) = how else {
        found.push(match (has_own, states) {
            (true, _) => Assumption::FlangeMomentsAligned,
            (false, true) => Assumption::FlangeLoadsConstant,
            (false, false) => Assumption::NoFlangeLoads,
        });
        found.extend(loads_flange(axis).then_some(Assumption::FlangeLoadsIgnored));
        return;
    };
    found.push(Assumption::FlangeLoadsOfMechanism);
    match how {
        Derived::Replace if has_own => found.push(Assumption::FlangeLoadsReplaced),
        Derived::Add | Derived::Replace | Derived::Ignore if has_own || states => {
            found.push(Assumption::FlangeLoadsAddUp);
        }
        Derived::Add | Derived::Replace | Derived::Ignore => {}
    }
    found.extend(section.helix_angle.note().filter(|_| section.pressure_angle.is_given()));
    if axis.parts.stage.is_given() {
        found.push(Assumption::MechanismOnOwnBearings);
        found.extend(section.wheel_mass.note());
        return;
    }
    let Some(on_flange) = axis.driven().and_then(|driven| driven.on_flange()) else { return };
    found.extend(section.flange_share.note().filter(|_| !matches!(on_flange, OnFlange::Shaft)));
    match on_flange {
        OnFlange::Bodies(tilt) => {
            found.push(Assumption::FlangeBodiesFlat);
            if !tilt.is_given() {
                found.push(Assumption::FlangeUpwards);
            }
            if axis.segments().iter().any(|segment| segment.payload_inertia.is_given()) {
                found.push(Assumption::PayloadInertiaWeightless);
            }
        }
        OnFlange::Wheel | OnFlange::Shaft => found.extend(section.wheel_mass.note()),
    }
}
