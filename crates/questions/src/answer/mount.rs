//! Mounting as a record.

use crate::answer::{cited_erratum, facts};
use answers::{CitedErratum, Fit, Id, Joint, JointCase, MountValue, Number, Pilot, TableCell, Units};
use catalogue::Cell;
use installation::fit::{Bore, FitKind};
use installation::joint::{CaseAnswer, LoadCase};
use installation::mount::{Mount, MountInputs};
use provenance::{Datum, Grade, Source, Sourced};
use quantities::unit::{KILOGRAM, MICROMETRE, MILLIMETRE, NEWTON, NEWTON_METRE, ONE};
use quantities::{Language, Measure, Unit};
use sizing::{Direction, Verdict};
use words::mounting::{self, fit_word, load_case_title, side_title};
use words::{cell_text, describe_uncovered, erratum_place_of, source_text, symbol_term};

/// Erratum about the name of the recommended fit.
const FIT_NAME: &str = "T77.1-fit-name";

/// Errata of doubtful statements of the manual on which every answer depends.
const ERRATA: [&str; 2] = [FIT_NAME, "T79.1-securing"];

/// Figure that defines the tolerances of the flange.
const TOLERANCES_DRAWN_IN: &str = "55.2";

/// Returns the mounting data of an actuator; with the name of an axis, its loads replace the limits of the manual.
#[must_use]
pub fn mount(mount: &Mount, asked: &MountInputs, axis: Option<&str>, language: Language) -> answers::Mount {
    let joints: Vec<Joint> = mount.joints.iter().map(|each| joint(each, language)).collect();
    let slips = joints.iter().flat_map(|joint| &joint.cases).any(|case| *case.verdict == Verdict::Fail);
    let millimetres = |symbol, datum: &Datum<_>| value(symbol, datum, &MILLIMETRE, language);
    let dimensions = [
        Some(millimetres("L", &mount.length)),
        Some(millimetres("d_H", &mount.hollow_shaft)),
        Some(value("m", &mount.mass, &KILOGRAM, language)),
        mount.plate.map(|cell| text(cell, language)),
        mount.protection.map(|cell| text(cell, language)),
    ];
    let dimensions: Vec<MountValue> = dimensions.into_iter().flatten().collect();
    let tolerances: Vec<MountValue> = mount.runouts.iter().map(|(symbol, datum)| millimetres(symbol, datum)).collect();
    answers::Mount {
        code: mount.code.to_string(),
        verdict: Fit::of(!slips),
        units: Units::of(&[
            ("nominal", &MILLIMETRE),
            ("upper", &MICROMETRE),
            ("lower", &MICROMETRE),
            ("bore_upper", &MICROMETRE),
            ("bore_lower", &MICROMETRE),
            ("clearance_min", &MICROMETRE),
            ("clearance_max", &MICROMETRE),
            ("off_centre_max", &MICROMETRE),
            ("bolt_circle", &MILLIMETRE),
            ("tightening_torque", &NEWTON_METRE),
            ("transmissible_torque", &NEWTON_METRE),
            ("clamp_force", &NEWTON),
            ("torque", &NEWTON_METRE),
            ("moment", &NEWTON_METRE),
            ("utilisation", &ONE),
            ("relieved", &ONE),
            ("utilisation_together", &ONE),
        ]),
        notes: notes(mount, asked, axis, language),
        assumptions: Vec::new(),
        pilots: mount.fits.iter().map(|fit| pilot(fit, language)).collect(),
        errata: errata(&[tolerances.clone(), dimensions.clone()].concat(), &joints, language),
        tolerances,
        dimensions,
        lifting_gear: mount.hoist,
        joints,
        facts: facts(&mount.facts, language),
    }
}

fn notes(mount: &Mount, asked: &MountInputs, axis: Option<&str>, language: Language) -> Vec<String> {
    let mut notes: Vec<String> = mount.uncovered.iter().map(|what| describe_uncovered(*what, language)).collect();
    let named_otherwise = mount.fits.iter().find_map(|fit| match fit.bore {
        Bore::Zone(zone) if zone == fit.recommended.value && fit.kind != FitKind::Transition => {
            Some((zone, fit.pilot_zone, fit.kind))
        }
        _ => None,
    });
    if let Some((zone, pilot, kind)) = named_otherwise {
        notes.push(mounting::fit_is_named_otherwise(
            &zone,
            &pilot,
            &fit_word(kind, language),
            &erratum_place_of(FIT_NAME, language),
            language,
        ));
    }
    notes.push(mounting::tolerances_are_drawn(&TOLERANCES_DRAWN_IN, language));
    match axis {
        None => notes.push(mounting::joint_loads_are_limits(language).to_owned()),
        Some(name) => {
            notes.push(mounting::joint_loads_of(&name, language));
            if asked.axis.flange.is_none() {
                notes.push(mounting::no_flange_loads_known(language).to_owned());
            }
        }
    }
    notes.push(mounting::joint_model(language).to_owned());
    notes
}

/// Returns doubtful data and errata of the values shown.
fn errata(values: &[MountValue], joints: &[Joint], language: Language) -> Vec<CitedErratum> {
    let mut ids: Vec<&'static str> = ERRATA.to_vec();
    let of_joints = joints.iter().flat_map(|joint| {
        let of_cases = joint.cases.iter().flat_map(|case| case.torque_errata.iter().chain(&case.moment_errata));
        joint.tightening_errata.iter().chain(&joint.transmissible_errata).chain(of_cases)
    });
    for id in values.iter().flat_map(|value| &value.errata).chain(of_joints) {
        if !ids.contains(id) {
            ids.push(id);
        }
    }
    ids.into_iter().map(|id| cited_erratum(id, language)).collect()
}

fn pilot(fit: &installation::fit::PilotFit, language: Language) -> Pilot {
    let micrometres = |si: f64| Number::in_unit(si, &MICROMETRE);
    let bore_source = fit.bore_source.as_ref();
    let grade = fit.pilot.grade.worst(fit.nominal.grade);
    let mut sources = vec![source_text(&fit.nominal.source, language), source_text(&fit.pilot.source, language)];
    sources.extend(bore_source.map(|source| source_text(source, language)));
    Pilot {
        side: Id(fit.side),
        title: side_title(fit.side, language),
        nominal: Number::in_unit(fit.nominal.value.si(), &MILLIMETRE),
        zone: fit.pilot_zone,
        upper: micrometres(fit.pilot.value.upper.si()),
        lower: micrometres(fit.pilot.value.lower.si()),
        recommended: fit.recommended.value,
        bore: match fit.bore {
            Bore::Zone(zone) => Some(zone),
            Bore::Limits(_) => None,
        },
        bore_upper: micrometres(fit.bore_deviations.upper.si()),
        bore_lower: micrometres(fit.bore_deviations.lower.si()),
        clearance_min: micrometres(fit.clearance_min.si()),
        clearance_max: micrometres(fit.clearance_max.si()),
        off_centre_max: micrometres(fit.clearance_max.si().max(0.0) / 2.0),
        fit: Id(fit.kind),
        fit_text: fit_word(fit.kind, language),
        grade: Id(grade),
        sources,
    }
}

fn value<Q: Measure>(symbol: &'static str, datum: &Datum<Q>, unit: &Unit, language: Language) -> MountValue {
    let known = datum.known();
    MountValue {
        symbol,
        name: words::figure_term(symbol, language),
        value: known.map_or(TableCell::Empty, |known| TableCell::Number(Number::in_unit(known.value.si(), unit))),
        unit: unit.json,
        grade: known.map(|known| Id(known.grade)),
        source: known.map(|known| source_text(&known.source, language)),
        errata: errata_of(datum),
    }
}

/// Returns the errata of a datum.
fn errata_of<T>(datum: &Datum<T>) -> Vec<&'static str> {
    datum.known().map_or_else(Vec::new, |known| known.errata.to_vec())
}

fn text(cell: &'static Cell, language: Language) -> MountValue {
    MountValue {
        symbol: cell.place.symbol,
        name: symbol_term(cell.place.symbol, language),
        value: TableCell::Text(cell_text(cell, language).to_owned()),
        unit: cell.unit,
        grade: Some(Id(Grade::Printed)),
        source: Some(source_text(&Source::Cell(&cell.place), language)),
        errata: cell.errata.to_vec(),
    }
}

fn number<Q: Measure>(datum: &Datum<Q>, unit: &Unit) -> Option<Number> {
    datum.known().map(|known| Number::in_unit(known.value.si(), unit))
}

fn source<T>(datum: &Datum<T>, language: Language) -> Option<String> {
    datum.known().map(|known| source_text(&known.source, language))
}

fn joint(joint: &installation::joint::BoltedJoint, language: Language) -> Joint {
    let screws = &joint.screws;
    let printed =
        |datum: &Datum<_>| datum.known().map(|known: &Sourced<std::borrow::Cow<'_, str>>| known.value.to_string());
    Joint {
        side: Id(joint.side),
        title: side_title(joint.side, language),
        count: screws.count.known().map(|count| Number(count.value)),
        size: printed(&screws.size),
        class: printed(&screws.grade),
        bolt_circle: number(&screws.bolt_circle, &MILLIMETRE),
        tightening_torque: number(&screws.tightening_torque, &NEWTON_METRE),
        transmissible_torque: number(&screws.transmissible_torque, &NEWTON_METRE),
        friction: number(&joint.friction, &ONE),
        clamp_force: number(&joint.clamp_force, &NEWTON),
        source: source(&screws.transmissible_torque, language),
        tightening_errata: errata_of(&screws.tightening_torque),
        transmissible_errata: errata_of(&screws.transmissible_torque),
        cases: joint.cases.iter().map(|each| case(each, language)).collect(),
    }
}

/// Returns a joint under a load: the verdict refers to the torque alone, the estimate with all loads combined gives an
/// advice.
fn case(found: &CaseAnswer, language: Language) -> JointCase {
    let alone = found.alone.known();
    let together = found.together.known().map(|known| &known.value);
    // The collision torque of another gear is no reason for rejection.
    let is_of_another_gear = found.torque.known().is_some_and(|torque| matches!(torque.source, Source::Published(_)));
    let verdict = alone.map_or(Verdict::NotChecked, |share| match Direction::AtMost.keeps(share.value.si(), 1.0) {
        true => Verdict::Pass,
        false if is_of_another_gear => Verdict::Advice,
        false => Verdict::Fail,
    });
    let holds = |slip: Option<quantities::Ratio>| slip.is_some_and(|slip| Direction::AtMost.keeps(slip.si(), 1.0));
    let verdict_together =
        together.map_or(Verdict::NotChecked, |joint| if holds(joint.slip) { Verdict::Pass } else { Verdict::Advice });
    let is_of_a_limit = found.moment.known().is_some_and(|moment| matches!(moment.source, Source::Cell(_)));
    let missing = match (found.case, &found.torque) {
        (LoadCase::Collision, Datum::NotPrinted) => Some("T_M"),
        (LoadCase::Brake, Datum::NotPrinted) => Some("T_Br"),
        (LoadCase::Peak, Datum::NotPrinted) => Some("T_max"),
        _ => None,
    };
    JointCase {
        case: Id(found.case),
        title: load_case_title(found.case, is_of_a_limit, language),
        torque: number(&found.torque, &NEWTON_METRE),
        torque_source: source(&found.torque, language),
        torque_errata: errata_of(&found.torque),
        utilisation: number(&found.alone, &ONE),
        verdict: Id(verdict),
        grade: alone.map(|share| Id(share.grade)),
        moment: number(&found.moment, &NEWTON_METRE),
        moment_source: source(&found.moment, language),
        moment_errata: errata_of(&found.moment),
        relieved: together.map(|joint| Number(joint.relieved.si())),
        utilisation_together: together.and_then(|joint| joint.slip).map(|slip| Number(slip.si())),
        verdict_together: Id(verdict_together),
        missing: missing.map(|symbol| mounting::nothing_known_of(&symbol_term(symbol, language), language)),
    }
}
