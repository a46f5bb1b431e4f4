//! The loads on the output flange: those that the file states, and those that follow from the mechanism.

use crate::read::{Reader, joined};
use crate::section::Section;
use crate::{Assumption, Fault, Hint};
use actuator::FlangeLoad;
use mechanism::{Contact, Kind, LinearKind, Mechanism, Mounting, StageKind};
use quantities::unit::DEGREE;
use quantities::{Angle, Force, Length, Mass, Measure};
use sizing::{BearingDuty, DerivedLoads, OperatingCondition};

/// Keys of the geometry from which loads follow.
const GEOMETRY: [&str; 8] = [
    "overhang",
    "payload_overhang",
    "flange_share",
    "belt_tension",
    "pressure_angle",
    "helix_angle",
    "wheel_mass",
    "axis_tilt",
];

/// Teeth with a larger pressure or helix angle are none.
const TOOTH_ANGLE_MAX_DEG: f64 = 60.0;

/// What the loads of the mechanism do beside those that are stated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Derived {
    /// They act besides.
    Add,
    /// Those of a segment replace them there.
    Replace,
}

fn derived(root: &Section) -> Option<Derived> {
    match root.table("bearing")?.text("mechanism")? {
        "add" => Some(Derived::Add),
        "replace" => Some(Derived::Replace),
        _ => None,
    }
}

/// The loads on the flange and what is asked of the bearing.
pub(crate) fn duty(root: &Section, mechanism: &Mechanism, reader: &mut Reader<'_>) -> Option<BearingDuty> {
    let section = root.table("bearing");
    let segments = root.tables("motion");
    let own: Vec<Option<&Section>> = segments.iter().map(|section| section.table("bearing")).collect();
    if section.is_none() && own.iter().all(Option::is_none) {
        return None;
    }
    let how = derived(root);
    let derived = how.and_then(|how| {
        let mounting = mounting(root, mechanism, how, reader)?;
        let acts = own.iter().map(|own| how == Derived::Add || own.is_none()).collect();
        Some(DerivedLoads { mounting, acts })
    });
    if how.is_none() {
        for key in GEOMETRY {
            if let Some(section) = section.filter(|section| section.get(key).is_some()) {
                let hint = Hint::Example("mechanism = \"add\"".to_owned());
                reader.fault(section.span_of(key), Fault::WithoutEffect { key }, Some(hint));
            }
        }
    }
    let states = |section: &Section| ["radial_force", "axial_force"].iter().any(|key| section.get(key).is_some());
    // A table that only asks something of the bearing states no load.
    if how.is_none() && own.iter().all(Option::is_none) && !section.is_some_and(states) && ignores(root) {
        return None;
    }
    let load = |section: Option<&Section>| FlangeLoad {
        radial_force: section.and_then(|section| section.quantity("radial_force")).unwrap_or_else(zero),
        radial_distance: section.and_then(|section| section.quantity("radial_distance")).unwrap_or_else(zero),
        axial_force: section.and_then(|section| section.quantity("axial_force")).unwrap_or_else(zero),
        axial_distance: section.and_then(|section| section.quantity("axial_distance")).unwrap_or_else(zero),
    };
    let requirements = root.table("requirements");
    let condition = section.and_then(|section| section.text("operating_condition"));
    Some(BearingDuty {
        loads: own.into_iter().map(|own| load(own.or(section))).collect(),
        derived,
        load_factor: section.and_then(|section| section.number("load_factor")),
        operating_condition: condition.and_then(|word| match word {
            "normal" => Some(OperatingCondition::Normal),
            "shock" => Some(OperatingCondition::Shock),
            "high_accuracy" => Some(OperatingCondition::HighAccuracy),
            _ => None,
        }),
        life_min: requirements.and_then(|section| section.quantity("bearing_life_min")),
        tilt_max: requirements.and_then(|section| section.quantity("tilt_angle_max")),
    })
}

/// Whether the file says that the mechanism loads no flange.
fn ignores(root: &Section) -> bool {
    root.table("bearing").and_then(|section| section.text("mechanism")) == Some("ignore")
}

fn zero<Q: Measure>() -> Q {
    Q::from_si(0.0)
}

/// Faults of the stated loads, which need no mechanism: a force needs the distance at which it acts.
pub(crate) fn stated(root: &Section, reader: &mut Reader<'_>) {
    let own = root.tables("motion").iter().filter_map(|section| section.table("bearing"));
    for section in root.table("bearing").into_iter().chain(own) {
        for (force, distance) in [("radial_force", "radial_distance"), ("axial_force", "axial_distance")] {
            for (given, needed) in [(force, distance), (distance, force)] {
                if section.get(given).is_some() && !section.has(needed) {
                    let fault = Fault::MissingKey { path: joined(&section.path, needed), list: false };
                    reader.fault(section.span_of(given), fault, None);
                }
            }
        }
    }
}

/// The keys that have an effect on the loads of a mechanism.
fn effective(mechanism: &Mechanism) -> &'static [&'static str] {
    if let Some(stage) = &mechanism.stage {
        return match stage.kind {
            StageKind::Belt => &["overhang", "flange_share", "belt_tension", "wheel_mass", "axis_tilt"],
            StageKind::Gear => {
                &["overhang", "flange_share", "pressure_angle", "helix_angle", "wheel_mass", "axis_tilt"]
            }
            StageKind::Coupling => &["overhang", "flange_share", "wheel_mass", "axis_tilt"],
        };
    }
    match &mechanism.kind {
        Kind::Rotor(_) => &["overhang", "payload_overhang", "flange_share"],
        Kind::Linear(linear) => match linear.kind {
            LinearKind::Screw => &["overhang", "flange_share", "wheel_mass", "axis_tilt"],
            LinearKind::Belt => &[
                "overhang",
                "flange_share",
                "belt_tension",
                "pressure_angle",
                "helix_angle",
                "wheel_mass",
                "axis_tilt",
            ],
            LinearKind::Conveyor => &["overhang", "flange_share", "belt_tension", "wheel_mass", "axis_tilt"],
        },
        Kind::SliderCrank(_) => &["overhang", "flange_share", "wheel_mass", "axis_tilt"],
        _ => &[],
    }
}

/// How the load sits on the flange; what is not stated stays open, and the checks that need it say so.
fn mounting(root: &Section, mechanism: &Mechanism, how: Derived, reader: &mut Reader<'_>) -> Option<Mounting> {
    let section = root.table("bearing")?;
    if !mechanism.knows_flange_forces(root.table("load").is_none()) {
        reader.fault(section.span_of("mechanism"), Fault::NoFlangeLoads, Some(Hint::MechanismsWithLoads));
        return None;
    }
    let valid = effective(mechanism);
    for key in GEOMETRY.into_iter().filter(|key| section.get(key).is_some() && !valid.contains(key)) {
        reader.fault(section.span_of(key), Fault::WithoutEffect { key }, Some(Hint::valid(valid)));
    }
    if how == Derived::Replace {
        for key in ["radial_force", "axial_force"].into_iter().filter(|key| section.get(key).is_some()) {
            reader.fault(section.span_of(key), Fault::ReplacesEverything { key }, None);
        }
    }
    let tension: Option<Force> = section.quantity("belt_tension");
    let pressure: Option<Angle> = section.quantity("pressure_angle");
    let helix: Option<Angle> = section.quantity("helix_angle");
    for (key, angle) in [("pressure_angle", pressure), ("helix_angle", helix)] {
        if angle.is_some_and(|angle| angle.in_unit(&DEGREE) > TOOTH_ANGLE_MAX_DEG) {
            reader.fault(section.span_of(key), Fault::ToothAngle { key, most_deg: TOOTH_ANGLE_MAX_DEG }, None);
        }
    }
    if tension.is_some() && pressure.is_some() {
        reader.fault(section.span_of("pressure_angle"), Fault::BeltOrTeeth, None);
    }
    for (key, needed) in [("helix_angle", "pressure_angle"), ("wheel_mass", "axis_tilt"), ("axis_tilt", "wheel_mass")] {
        if section.get(key).is_some() && valid.contains(&key) && !section.has(needed) {
            let fault = Fault::MissingKey { path: joined(&section.path, needed), list: false };
            reader.fault(section.span_of(key), fault, None);
        }
    }
    let contact = match (tension, pressure) {
        (Some(tension), _) => Some(Contact::Belt { tension }),
        (None, Some(pressure_angle)) => {
            Some(Contact::Mesh { pressure_angle, helix_angle: helix.unwrap_or_else(zero::<Angle>) })
        }
        (None, None) => None,
    };
    Some(Mounting {
        overhang: section.quantity::<Length>("overhang"),
        payload_overhang: section.quantity("payload_overhang"),
        share: section.number("flange_share"),
        contact,
        wheel_mass: section.quantity::<Mass>("wheel_mass"),
        axis_tilt: section.quantity("axis_tilt"),
    })
}

/// Defaults about the loads on the flange that the file leaves open.
pub(crate) fn assumptions(root: &Section, found: &mut Vec<Assumption>) {
    let section = root.table("bearing");
    let own = root.tables("motion").iter().any(|section| section.get("bearing").is_some());
    let derives = derived(root).is_some();
    let states = |section: &Section| section.get("radial_force").is_some() || section.get("axial_force").is_some();
    if section.is_none() && !own || ignores(root) && !own && !section.is_some_and(states) {
        found.push(Assumption::NoFlangeLoads);
        return;
    }
    if !derives {
        found.push(if own { Assumption::FlangeMomentsAligned } else { Assumption::FlangeLoadsConstant });
        return;
    }
    let kind = root.table("mechanism").and_then(|mechanism| mechanism.subtables().next());
    let has = |key: &str| section.is_some_and(|section| section.get(key).is_some());
    found.push(Assumption::FlangeLoadsOfMechanism);
    if own || section.is_some_and(states) {
        found.push(Assumption::FlangeLoadsAddUp);
    }
    if has("pressure_angle") && !has("helix_angle") {
        found.push(Assumption::SpurTeeth);
    }
    if root.table("stage").is_some() {
        found.push(Assumption::MechanismOnOwnBearings);
        if !has("wheel_mass") {
            found.push(Assumption::WheelWeightless);
        }
        return;
    }
    let Some((name, mechanism)) = kind else { return };
    if !has("flange_share") && name != "screw" {
        found.push(Assumption::FlangeBearsAll);
    }
    if matches!(name, "turntable" | "arm") {
        found.push(Assumption::FlangeBodiesFlat);
        if mechanism.get("axis_tilt").is_none() {
            found.push(Assumption::FlangeUpwards);
        }
        if root.tables("motion").iter().any(|section| section.get("payload_inertia").is_some()) {
            found.push(Assumption::PayloadInertiaWeightless);
        }
    } else if !has("wheel_mass") {
        found.push(Assumption::WheelWeightless);
    }
}
