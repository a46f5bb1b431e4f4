//! The dossier: content of a report as one record.

use super::check::{check, explained};
use super::errata::cited_erratum;
use super::inputs::{inputs_of_axis, mechanism, tables};
use super::judged::{judgement, sizing};
use super::operation::{data_sheet, operation};
use crate::fingerprint::{catalogue_fingerprint, project_fingerprint};
use crate::proposals::Proposals;
use crate::sizing_use::{Candidate, Sizing, by_importance};
use crate::texts::{self, Rejections};
use crate::tolerance::Assessment;
use actuator::ScrewJoint;
use answers::{CheckCounts, Document, Dossier, ErratumUsed, Fingerprints, Id, Item, Missing, RejectionGroup};
use axis::AxisProject;
use configurator::ProductSource;
use installation::wiring::{CableLength, CableRole};
use order_code::Field;
use provenance::{Datum, MANUAL, Source};
use quantities::unit::{MILLIMETRE, NEWTON_METRE};
use quantities::{Language, Measure, Unit, format_number, with_symbol};
use sizing::{Checks, Reserve};
use words::{
    Counts, capitalised, check_missing, describe_token, document_note, document_title, records, short, source_text,
    terms, title_of_check, typeset, unpadded, wiring,
};

/// Collects all results for an axis and the chosen actuator.
///
/// `text` is that of the project file, `place` the number of the axis in it from zero, `program` the name and version
/// of the program.
#[must_use]
pub fn dossier(
    project: &AxisProject,
    ranked: &Sizing<'_>,
    chosen: &Candidate<'_>,
    (found, assessment, proposals): (&Reserve, Option<&Assessment>, &Proposals),
    (text, place, program): (&str, usize, &str),
    language: Language,
) -> Dossier {
    let workings = crate::explain(project, &chosen.id);
    // If the rules of the code prevent a new judgement, the judgement of the ranking, without workings, is used.
    let checks: &Checks = workings.as_ref().map_or(&chosen.judgement.checks, |found| &found.judgement.checks);
    let inputs = inputs_of_axis(text, place);
    let mut judgement = judgement(project, chosen, found, assessment, language);
    judgement.candidate.checks =
        by_importance(&chosen.judgement.checks).into_iter().map(|each| check(each, language)).collect();
    let Counts { passed, advised, failed, not_checked, without_limit, deciding, requirements_open, .. } =
        chosen.counts();
    let code = chosen.id.order_code();
    let sheet = code.map(|code| data_sheet(code, chosen.parameters.without_kty, language)).unwrap_or_default();
    let errata_of_k_tm = chosen.parameters.torque_constant_motor.known().map_or(&[][..], |known| known.errata);
    let is_single = |input: &project::Input| input.path.ends_with("single_move") && input.written == "true";
    Dossier {
        judgement,
        counts: CheckCounts { passed, advised, failed, not_checked, without_limit, deciding, requirements_open },
        single_move: inputs.iter().any(is_single),
        sizing: sizing(ranked, project, &[], proposals, usize::MAX, language),
        rejections: rejections(ranked, language),
        mechanism: mechanism(project, &inputs, language),
        inputs: tables(&inputs, language),
        operation: sizing::Operation::of(&project.axis, chosen.parameters)
            .map(|found| operation(&found, (&chosen.judgement.checks, errata_of_k_tm), language)),
        errata: errata(chosen, checks, &sheet, language),
        data_sheet: sheet,
        explained: checks.iter().map(|check| explained(check, language)).collect(),
        missing: missing(chosen, language),
        // An actuator that does not fit is not ordered.
        bill_of_material: if chosen.fits() { bill_of_material(chosen, language) } else { Vec::new() },
        screws: if chosen.fits() { screws(chosen, language) } else { Vec::new() },
        documents: documents(chosen, checks, language),
        fingerprints: Fingerprints {
            program: program.to_owned(),
            project: project_fingerprint(text, &project.recordings),
            catalogue: catalogue_fingerprint(&**project.catalogue()),
        },
    }
}

/// Returns the datum that each incomplete check lacks.
fn missing(chosen: &Candidate<'_>, language: Language) -> Vec<Missing> {
    let lacking = chosen.judgement.checks.iter().filter_map(|check| Some((check.id, check.missing?)));
    lacking.map(|(id, symbol)| Missing { check: Id(id), text: check_missing(symbol, language) }).collect()
}

/// Returns the rejected actuators of the catalogue, grouped by reason.
fn rejections(ranked: &Sizing<'_>, language: Language) -> Vec<RejectionGroup> {
    let group = |group: Rejections<'_, '_>| {
        let mut codes: Vec<String> = group.candidates.iter().map(|candidate| candidate.id.to_string()).collect();
        codes.sort();
        RejectionGroup { reason: group.title, is_check: group.is_check, codes }
    };
    texts::rejections(ranked, language).into_iter().map(group).collect()
}

/// Returns the documents from which the figures of the checks are taken, first the one of the actuator: the manual of a series
/// in the program, or the catalogue file with the document that it names.
fn documents(chosen: &Candidate<'_>, checks: &Checks, language: Language) -> Vec<Document> {
    let mut ids: Vec<&'static str> = Vec::new();
    if chosen.product.source == ProductSource::Manual {
        ids.push(MANUAL);
    }
    let mut file = None;
    let sources = checks.iter().flat_map(|check| {
        let own = [&check.limit_source, &check.value_source].into_iter().flatten();
        own.chain(check.workings.iter().map(|step| &step.source))
    });
    for source in sources {
        let id = match source {
            Source::Cell(cell) | Source::Published(cell) => cell.document,
            Source::Equation { .. } => MANUAL,
            Source::CatalogueFile { place } => {
                file = file.or_else(|| Some(document_of_file(chosen, place, language)));
                continue;
            }
            Source::Model { .. } | Source::Project { .. } | Source::NotStated { .. } => continue,
        };
        if !ids.contains(&id) {
            ids.push(id);
        }
    }
    let published = ids.into_iter().filter_map(catalogue::document).map(|found| document(found, language));
    file.into_iter().chain(published).collect()
}

/// Returns a catalogue file as a reference, from the place of one of its values: file and line of the product, and the document
/// that the file names for it.
fn document_of_file(chosen: &Candidate<'_>, place: &str, language: Language) -> Document {
    let (file, value) = place.split_once(": ").unwrap_or((place, ""));
    let named = value.split_once(" (").and_then(|(_, document)| document.strip_suffix(')'));
    Document {
        id: file.to_owned(),
        short: file.to_owned(),
        title: named.map_or_else(|| records::catalogue_file(language).to_owned(), str::to_owned),
        edition: String::new(),
        publisher: chosen.product.manufacturer.as_deref().unwrap_or_default().to_owned(),
        note: String::new(),
    }
}

/// Returns a document as a reference.
pub(crate) fn document(found: &catalogue::SourceDocument, language: Language) -> Document {
    Document {
        id: found.id.to_owned(),
        short: short(found, language).to_owned(),
        title: document_title(found, language).to_owned(),
        edition: found.edition.to_owned(),
        publisher: found.publisher.to_owned(),
        note: document_note(found, language).to_owned(),
    }
}

/// Every erratum that a figure of the checks, the mass or a line of the data sheet rests on, once, with the first of them that does.
fn errata(
    chosen: &Candidate<'_>,
    checks: &Checks,
    sheet: &[answers::DataLine],
    language: Language,
) -> Vec<ErratumUsed> {
    let of_mass = chosen.parameters.mass.known().into_iter().flat_map(|mass| mass.errata);
    let used = |id: &&'static str| ErratumUsed {
        erratum: cited_erratum(id, language),
        check: capitalised(terms::mass(language)),
    };
    let mut found: Vec<ErratumUsed> = of_mass.map(used).collect();
    for check in checks {
        let noted = check.notes.iter().filter_map(|note| match note {
            sizing::Note::Erratum(id) => Some(*id),
            _ => None,
        });
        for id in check.workings.iter().flat_map(|step| step.errata.iter().copied()).chain(noted) {
            if found.iter().all(|known| known.erratum.id != id) {
                found
                    .push(ErratumUsed { erratum: cited_erratum(id, language), check: title_of_check(check, language) });
            }
        }
    }
    for (line, id) in sheet.iter().flat_map(|line| line.errata.iter().map(move |id| (line, *id))) {
        if found.iter().all(|known| known.erratum.id != id) {
            found.push(ErratumUsed { erratum: cited_erratum(id, language), check: capitalised(&line.name) });
        }
    }
    found
}

/// Returns the kind of an actuator: one with a hollow shaft if its bore is known.
#[must_use]
pub fn actuator_kind(candidate: &Candidate<'_>, language: Language) -> &'static str {
    let is_hollow = candidate.parameters.hollow_shaft.known().is_some_and(|bore| bore.value.si() > 0.0);
    if is_hollow { terms::actuator_with_hollow_shaft(language) } else { records::servo_actuator(language) }
}

/// Returns the actuator and the screws of both joints, as far as the tables name them.
fn bill_of_material(candidate: &Candidate<'_>, language: Language) -> Vec<Item> {
    let mut rows: Vec<Item> = Vec::new();
    let mut add = |quantity: String, code: String, text: String, source: Option<String>| {
        // A line without a quantity is a remark and no item.
        let item = if quantity.is_empty() { String::new() } else { (rows.len() + 1).to_string() };
        rows.push(Item { item, quantity, code, text, source });
    };
    let parts = match candidate.id.order_code() {
        Some(code) => [Field::Size, Field::Ratio, Field::Winding, Field::Feedback]
            .into_iter()
            .chain(
                [Field::Brake, Field::Option1, Field::Option2].into_iter().filter(|field| code.token(*field).is_some()),
            )
            .map(|field| describe_token(code, field, language))
            .collect::<Vec<_>>()
            .join("; "),
        None if candidate.product.is_of_project() => terms::own_actuator(language).to_owned(),
        None => {
            let named = [&candidate.product.manufacturer, &candidate.product.series];
            named.into_iter().flatten().map(AsRef::as_ref).collect::<Vec<_>>().join(", ")
        }
    };
    let series = actuator_kind(candidate, language);
    add(
        "1".into(),
        candidate.id.to_string(),
        if parts.is_empty() { series.to_owned() } else { format!("{series}; {parts}") },
        None,
    );
    let joints = [(records::screws_at_the_load(language), true), (records::screws_at_the_housing(language), false)];
    for (text, load) in joints {
        let parameters = candidate.parameters;
        let joint = if load { &parameters.screw_joint_load } else { &parameters.screw_joint_housing };
        let (Some(count), Some(size)) = (joint.count.known(), joint.size.known()) else { continue };
        let class = joint.grade.known().map_or_else(String::new, |class| format!(", {}", class.value));
        let length = records::length_after_the_joined_part(language);
        let source = source_text(&count.source, language);
        let count = format_number(count.value, 0, language);
        add(count, format!("{}{class}", size.value), format!("{text}; {length}"), Some(source));
    }
    if let Some(code) = candidate.id.order_code()
        && let Some(found) = installation::wiring::wiring(code)
    {
        connected(&found, &mut add, language);
    }
    rows
}

/// Adds the mating connectors, and the cables that the manual lists, by their counterpart.
fn connected(
    found: &installation::wiring::CodeWiring,
    add: &mut impl FnMut(String, String, String, Option<String>),
    language: Language,
) {
    let source = |cell: &'static catalogue::Cell| {
        let place = source_text(&Source::Cell(&cell.place), language);
        let is_doubtful = catalogue::errata()
            .iter()
            .any(|erratum| cell.errata.contains(&erratum.id) && erratum.kind == catalogue::ErratumKind::Contradiction);
        match (cell.errata.is_empty(), is_doubtful) {
            (true, _) => place,
            (false, true) => format!("{place}; {}", records::number_in_doubt(language)),
            (false, false) => format!("{place}; {}", records::number_corrected(language)),
        }
    };
    for connector in &found.connectors {
        let Some(number) = connector.mating else { continue };
        let name = wiring::role_name(connector.role, language);
        let text = capitalised(&records::mating_coupling_of(&name, &typeset(connector.kind.corrected), language));
        add("1".into(), number.corrected.to_owned(), text, Some(source(number)));
    }
    if found.cables.is_empty() {
        add(String::new(), String::new(), capitalised(wiring::no_cables(language)), None);
    }
    let mut seen = Vec::new();
    for cable in &found.cables {
        if seen.contains(&(cable.goal, cable.role)) {
            continue;
        }
        seen.push((cable.goal, cable.role));
        let like = || found.cables.iter().filter(|each| (each.goal, each.role) == (cable.goal, cable.role));
        let numbers: Vec<&str> = like().map(|each| each.number.corrected).collect();
        let lengths = like().map(|each| match each.length {
            CableLength::Metres(metres) => format!("{} m", format_number(metres, 0, language)),
            CableLength::InNumber(letters) => records::length_code(&letters, language),
        });
        let lengths = lengths.collect::<Vec<_>>().join(", ");
        let role = match cable.role {
            CableRole::Set => capitalised(wiring::cable_role(cable.role, language)),
            other => capitalised(&records::cable_of(&wiring::cable_role(other, language), language)),
        };
        let goal = wiring::cable_goal(cable.goal, language);
        let text = records::cable_to_choose(&role, &goal, &lengths, language);
        add(records::by_choice(language).to_owned(), numbers.join(", "), text, Some(source(cable.number)));
    }
}

/// Returns both joints: number and size of the screws, bolt circle, tightening torque and transmissible load. A joint of which
/// nothing is known is left out.
fn screws(candidate: &Candidate<'_>, language: Language) -> Vec<answers::ScrewJoint> {
    let joints = [
        (records::load(language), &candidate.parameters.screw_joint_load),
        (terms::housing(language), &candidate.parameters.screw_joint_housing),
    ];
    let is_known = |joint: &ScrewJoint| {
        joint.size.known().is_some()
            || joint.bolt_circle.known().is_some()
            || joint.transmissible_torque.known().is_some()
    };
    let known = joints.into_iter().filter(|(_, joint)| is_known(joint));
    known.map(|(name, joint)| screw_joint(name, joint, language)).collect()
}

fn screw_joint(name: &str, joint: &ScrewJoint, language: Language) -> answers::ScrewJoint {
    fn shown<Q: Measure>(datum: &Datum<Q>, unit: &Unit, language: Language) -> String {
        // A printed figure is not shown with more digits than it has.
        let number = |value: f64| unpadded(unit.from_si(value), 4, language);
        datum
            .known()
            .map_or_else(|| "–".to_owned(), |known| with_symbol(&number(known.value.si()), unit.symbol_in(language)))
    }
    let count = joint.count.known().map_or_else(String::new, |count| format!("{:.0} × ", count.value));
    let size = joint.size.known().map_or("–", |size| size.value.as_ref());
    let class = joint.grade.known().map_or_else(String::new, |class| format!(", {}", class.value));
    let is_stated = joint.transmissible_torque.known().is_some();
    let transmitted = shown(&joint.transmissible_torque, &NEWTON_METRE, language);
    answers::ScrewJoint {
        joint: name.to_owned(),
        screws: format!("{count}{size}{class}"),
        circle: shown(&joint.bolt_circle, &MILLIMETRE, language),
        torque: shown(&joint.tightening_torque, &NEWTON_METRE, language),
        // The source states the condition: degreased faces.
        text: if is_stated { records::transmits(&transmitted, language) } else { String::new() },
        source: joint.transmissible_torque.known().map(|known| source_text(&known.source, language)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The parts of every ordering code are read by persons: no source names an erratum by its id.
    #[test]
    fn the_parts_list_names_no_ids() {
        let (mut marked, mut lines) = (0, 0);
        for code in crate::embedded_catalogue().products(false).iter().map(|product| &product.id) {
            let Some(found) = code.order_code().and_then(installation::wiring::wiring) else { continue };
            for language in Language::ALL {
                let mut add = |_: String, _: String, _: String, source: Option<String>| {
                    let source = source.unwrap_or_default();
                    let named = catalogue::errata().iter().find(|erratum| source.contains(erratum.id));
                    assert!(named.is_none(), "{code}: {source}");
                    marked += usize::from(source.contains(records::number_in_doubt(language)));
                    lines += 1;
                };
                connected(&found, &mut add, language);
            }
        }
        assert!(marked > 0 && lines > 1000, "{marked} of {lines}");
    }

    /// Holding torque and number of applications of the brake are rows of their own, and the number fails with a long life.
    #[test]
    fn torque_and_applications_of_the_brake_are_rows_of_their_own() {
        use sizing::{CheckId, Verdict};
        for (life, is_number) in [("1 h", false), ("500000 h", true)] {
            let text = format!(
                "format = 1\n[mechanism.screw]\nlead = \"10 mm\"\nmass = \"20 kg\"\ninclination = \"90 deg\"\n[[motion]]\n\
                 law = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
                 hold = \"brake\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n\
                 [requirements]\nbrake = true\nservice_life = \"{life}\"\n"
            );
            let Ok(project) = crate::read(&text) else { panic!("{text}") };
            let sizing = crate::size(&project);
            let of_size_20 = |each: &&Candidate<'_>| each.id.to_string() == "CHA-20A-30-H-C1024-B";
            let checks = || sizing.candidates.iter().filter(of_size_20).flat_map(|each| &each.judgement.checks);
            let verdict = |id| checks().find(|found| found.id == id).map(|found| found.verdict);
            assert_eq!(verdict(CheckId::BrakeHolding), Some(Verdict::Pass), "{life}");
            let of_number = if is_number { Verdict::Fail } else { Verdict::Pass };
            assert_eq!(verdict(CheckId::BrakeApplications), Some(of_number), "{life}");
        }
    }
}
