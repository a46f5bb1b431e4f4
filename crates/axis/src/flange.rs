//! Loads on the output flange: stated ones, and those that follow from the mechanism.

use crate::assumption::{Assumption, unstated};
use crate::choices;
use crate::driven::OnFlange;
use crate::fault::AxisReport;
use crate::mechanism::driven;
use crate::needs::needs;
use actuator::FlangeLoad;
use mechanism::{Contact, Mechanism, Mounting, StageKind};
use project::sections::{AxisSection, Bearing, Derived, FlangeLoads, Section, StageSection, StatedField};
use project::{Fault, Hint, KeyDefault};
use quantities::Measure;
use quantities::unit::DEGREE;
use sizing::{BearingDuty, DerivedLoads};

/// Largest pressure or helix angle of teeth.
const TOOTH_ANGLE_MAX_DEG: f64 = 60.0;

/// Returns the first stated load.
fn first(loads: &FlangeLoads) -> Option<&dyn StatedField> {
    let forces: [&dyn StatedField; 2] = [&loads.radial_force, &loads.axial_force];
    forces.into_iter().find(|field| field.is_given())
}

/// Returns `true` if a load is stated.
fn states_load(loads: &FlangeLoads) -> bool {
    first(loads).is_some()
}

fn build(loads: &FlangeLoads) -> FlangeLoad {
    FlangeLoad {
        radial_force: loads.radial_force.or_zero(),
        radial_distance: loads.radial_distance.or_zero(),
        axial_force: loads.axial_force.or_zero(),
        axial_distance: loads.axial_distance.or_zero(),
    }
}

/// Reports a force without its distance, and the reverse.
fn pairs(loads: &FlangeLoads, report: &mut AxisReport<'_>) {
    let pairs: [[&dyn StatedField; 2]; 2] =
        [[&loads.radial_force, &loads.radial_distance], [&loads.axial_force, &loads.axial_distance]];
    for [force, distance] in pairs {
        needs(force, distance, report);
        needs(distance, force, report);
    }
}

/// Returns the keys of the geometry from which loads follow.
fn geometry(bearing: &Bearing) -> [&dyn StatedField; 8] {
    [
        &bearing.overhang,
        &bearing.payload_overhang,
        &bearing.flange_share,
        &bearing.belt_tension,
        &bearing.pressure_angle,
        &bearing.helix_angle,
        &bearing.wheel_mass,
        &bearing.axis_tilt,
    ]
}

/// Returns the keys that have an effect on the loads of a stage.
fn of_stage(bearing: &Bearing, kind: StageKind) -> Vec<&dyn StatedField> {
    let mut fields: Vec<&dyn StatedField> = vec![&bearing.overhang, &bearing.flange_share];
    match kind {
        StageKind::Belt => fields.push(&bearing.belt_tension),
        StageKind::Gear => fields.extend([&bearing.pressure_angle as &dyn StatedField, &bearing.helix_angle]),
        StageKind::Coupling => {}
    }
    fields.extend([&bearing.wheel_mass as &dyn StatedField, &bearing.axis_tilt]);
    fields
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
    axis.parts.stage.is_given() || driven(&axis.parts).is_some_and(|driven| driven.on_flange().is_some())
}

/// Returns `true` if the mechanism or its stage can load the flange in addition to stated loads: a coupling alone does not,
/// without the mass of its half.
fn adds_to_stated(axis: &AxisSection) -> bool {
    let is_coupling = |stage: &StageSection| stage.kind.value().map(choices::stage_kind) == Some(StageKind::Coupling);
    let states_mass = || axis.parts.bearing.get().is_some_and(|bearing| bearing.wheel_mass.is_given());
    loads_flange(axis) && (!axis.parts.stage.get().is_some_and(is_coupling) || states_mass())
}

/// Returns the first stated load on the flange.
fn states_loads(axis: &AxisSection) -> Option<&dyn StatedField> {
    let common = axis.parts.bearing.get().map(|section| &section.loads);
    let of_segments = axis.segments().iter().filter_map(|segment| segment.bearing.get());
    common.into_iter().chain(of_segments).find_map(first)
}

/// Reports loads that are stated next to a mechanism with loads of its own, without a statement of their use: both
/// adding and ignoring them would be a guess. Returns `true` if it did.
fn undecided(axis: &AxisSection, report: &mut AxisReport<'_>) -> bool {
    let decided = axis.parts.bearing.get().is_some_and(|section| section.mechanism.is_written());
    let Some(field) = states_loads(axis).filter(|_| !decided && adds_to_stated(axis)) else { return false };
    let fault = Fault::FlangeLoadsUndecided { key: field.name(), section: axis.path("bearing") };
    report.fault(field.span(), fault, None);
    true
}

/// Returns `true` if the statement of the use, or the stage, is faulty: which keys have an effect is open then.
fn is_refused(axis: &AxisSection, mechanism: &Mechanism) -> bool {
    let section = axis.parts.bearing.get().map(|section| &section.mechanism);
    let of_stage = axis.parts.stage.is_written() && mechanism.stage.is_none();
    of_stage || section.is_some_and(|field| field.is_written() && !field.is_given())
}

/// Returns the loads on the flange and the requirements on the bearing.
pub(crate) fn duty(axis: &AxisSection, mechanism: &Mechanism, report: &mut AxisReport<'_>) -> BearingDuty {
    let absent = Bearing::absent(axis.head());
    let section = axis.parts.bearing.get().unwrap_or(&absent);
    let own: Vec<Option<&FlangeLoads>> = axis.segments().iter().map(|segment| segment.bearing.get()).collect();
    let undecided = undecided(axis, report) || is_refused(axis, mechanism);
    let how = how(axis).filter(|_| !is_refused(axis, mechanism));
    let derived = how.and_then(|how| {
        let mounting = mounting(axis, section, (mechanism, how), report)?;
        let acts = own.iter().map(|own| how == Derived::Add || own.is_none()).collect();
        Some(DerivedLoads { mounting, acts })
    });
    if how.is_none() && !undecided {
        for field in geometry(section).into_iter().filter(|field| field.is_given()) {
            // A load without a description of its masses cannot load the flange.
            let hint = match loads_flange(axis) {
                true => Hint::Example("mechanism = \"add\"".to_owned()),
                false => Hint::MechanismsWithLoads,
            };
            report.fault(field.span(), Fault::WithoutEffect { key: field.name() }, Some(hint));
        }
    }
    let requirements = axis.parts.requirements.get();
    BearingDuty {
        has_loads: derived.is_some() || states_load(&section.loads) || own.iter().any(Option::is_some),
        loads: own.into_iter().map(|own| build(own.unwrap_or(&section.loads))).collect(),
        derived,
        load_factor: section.load_factor.value(),
        operating_condition: section.operating_condition.value().map(choices::operating_condition),
        life_min: requirements.and_then(|section| section.bearing_life_min.value()),
        tilt_max: requirements.and_then(|section| section.tilt_angle_max.value()),
    }
}

/// Reports faults of the stated loads that need no mechanism: a force needs its distance.
pub(crate) fn stated(axis: &AxisSection, report: &mut AxisReport<'_>) {
    if let Some(section) = axis.parts.bearing.get() {
        pairs(&section.loads, report);
    }
    for loads in axis.segments().iter().filter_map(|segment| segment.bearing.get()) {
        pairs(loads, report);
    }
}

/// Returns the position of the load on the flange; values that are not stated stay open, and the checks that need them
/// report so.
fn mounting(
    axis: &AxisSection,
    section: &Bearing,
    (mechanism, how): (&Mechanism, Derived),
    report: &mut AxisReport<'_>,
) -> Option<Mounting> {
    if !mechanism.knows_flange_forces() {
        report.fault(section.mechanism.span(), Fault::NoFlangeLoads, Some(Hint::MechanismsWithLoads));
        return None;
    }
    let valid: Vec<&dyn StatedField> = match &mechanism.stage {
        Some(stage) => of_stage(section, stage.kind),
        None => driven(&axis.parts).map(|driven| driven.flange_keys(section)).unwrap_or_default(),
    };
    let names: Vec<&str> = valid.iter().map(|field| field.name()).collect();
    let has_effect = |field: &dyn StatedField| names.contains(&field.name());
    for field in geometry(section).into_iter().filter(|field| field.is_given() && !has_effect(*field)) {
        report.fault(field.span(), Fault::WithoutEffect { key: field.name() }, Some(Hint::valid(&names)));
    }
    if how == Derived::Replace {
        let forces: [&dyn StatedField; 2] = [&section.loads.radial_force, &section.loads.axial_force];
        for field in forces.into_iter().filter(|field| field.is_given()) {
            report.fault(field.span(), Fault::ReplacesEverything { key: field.name() }, None);
        }
    }
    for field in [&section.pressure_angle, &section.helix_angle] {
        if field.value().is_some_and(|angle| angle.in_unit(&DEGREE) > TOOTH_ANGLE_MAX_DEG) {
            let fault = Fault::ToothAngle { key: field.name(), most_deg: TOOTH_ANGLE_MAX_DEG };
            report.fault(field.span(), fault, None);
        }
    }
    let (tension, pressure) = (section.belt_tension.value(), section.pressure_angle.value());
    if tension.is_some() && pressure.is_some() {
        report.fault(section.pressure_angle.span(), Fault::BeltOrTeeth, None);
    }
    let pairs: [[&dyn StatedField; 2]; 3] = [
        [&section.helix_angle, &section.pressure_angle],
        [&section.wheel_mass, &section.axis_tilt],
        [&section.axis_tilt, &section.wheel_mass],
    ];
    // The tilt turns the weight of the roll, without a wheel too.
    let is_of_roll = |given: &dyn StatedField| {
        given.name() == section.axis_tilt.name()
            && mechanism.stage.is_none()
            && matches!(driven(&axis.parts).and_then(|driven| driven.on_flange()), Some(OnFlange::Roll))
    };
    for [given, needed] in pairs.into_iter().filter(|[given, _]| has_effect(*given) && !is_of_roll(*given)) {
        needs(given, needed, report);
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
    let states = states_load(&section.loads);
    let how = how(axis);
    let Some(how) = how else {
        found.push(match (has_own, states) {
            (true, _) => Assumption::FlangeMomentsAligned,
            (false, true) => Assumption::FlangeLoadsConstant,
            (false, false) => Assumption::NoFlangeLoads,
        });
        found.extend(adds_to_stated(axis).then_some(Assumption::FlangeLoadsIgnored));
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
    found.extend(unstated(&section.helix_angle).filter(|_| section.pressure_angle.is_given()));
    if axis.parts.stage.is_given() {
        found.push(Assumption::MechanismOnOwnBearings);
        found.extend(unstated(&section.wheel_mass));
        return;
    }
    let Some(on_flange) = driven(&axis.parts).and_then(|driven| driven.on_flange()) else { return };
    found.extend(unstated(&section.flange_share).filter(|_| !matches!(on_flange, OnFlange::Shaft)));
    match on_flange {
        OnFlange::Bodies(tilt) => {
            found.push(Assumption::FlangeBodiesFlat);
            if tilt.note() == Some(KeyDefault::AxisVertical) {
                found.push(Assumption::FlangeUpwards);
            }
            if axis.segments().iter().any(|segment| segment.payload_inertia.is_given()) {
                found.push(Assumption::PayloadInertiaWeightless);
            }
        }
        OnFlange::Roll => {
            found.extend(unstated(&section.wheel_mass));
            found.extend(unstated(&section.axis_tilt));
        }
        OnFlange::Wheel | OnFlange::Shaft => found.extend(unstated(&section.wheel_mass)),
    }
}
