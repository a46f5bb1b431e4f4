//! Wiring as records.

use super::facts::facts;
use answers::{
    AmbiguousColour, ConnectorExit, ConnectorPin, Id, NotAvailable, NoteBy, Number, VoltageDrops, WiringCheck,
    WiringFinding, WiringNote,
};
use catalogue::{Cell, Footnote, Topic};
use installation::facts::{Order, facts_about};
use installation::wiring::{
    Cable, CableLength, Circuit, CodeWiring, Connector, DropVerdict, Exit, Pin, PinComparison, PinFinding,
    SignalMeaning, VoltageDrop,
};
use provenance::{Grade, Source};
use quantities::unit::{AMPERE, METRE, SQUARE_MILLIMETRE, VOLT};
use quantities::{Area, ElectricPotential, Language, Length, Measure};
use sizing::Verdict;
use words::{cell_text, source_text, table_note, wiring};

/// Returns the wiring of a code, with the voltage drops on a cable if a length is given.
#[must_use]
pub fn wiring(wiring: &CodeWiring, cable: Option<(Length, Option<Area>)>, language: Language) -> answers::Wiring {
    let drops = cable.map(|(length, section)| drops(wiring, length, section, language));
    answers::Wiring {
        code: wiring.code.to_string(),
        connectors: wiring.connectors.iter().map(|each| connector(each, language)).collect(),
        cables: wiring.cables.iter().map(|each| record_of_cable(each, language)).collect(),
        not_available: wiring
            .absences
            .iter()
            .map(|absence| NotAvailable {
                id: absence.what.id(),
                text: wiring::absent_text(absence.what, language),
                table: absence.table,
            })
            .collect(),
        notes: notes(wiring, language),
        rules: facts(&facts_about(Topic::Wiring, &wiring.code, Order::Gravest), language),
        voltage_drop: drops,
        errata: errata(wiring),
    }
}

fn cell_source(cell: &'static Cell, language: Language) -> String {
    source_text(&Source::Cell(&cell.place), language)
}

fn connector(connector: &Connector, language: Language) -> answers::Connector {
    let printed = |cell: Option<&'static Cell>| cell.map(|cell| cell.corrected);
    answers::Connector {
        role: Id(connector.role),
        kind: connector.kind.corrected,
        poles: connector.poles,
        thread: connector.thread,
        exit: connector.exit.map(|exit| match exit {
            Exit::Cable => ConnectorExit::Cable,
            Exit::Housing => ConnectorExit::Housing,
        }),
        material_number: printed(connector.mating),
        outer_diameter: printed(connector.outer_diameter),
        length: printed(connector.length),
        unit: "mm",
        pins: connector.pins.iter().map(|each| pin(connector, each, language)).collect(),
        ambiguous: connector
            .ambiguous
            .iter()
            .map(|each| AmbiguousColour { colour: cell_text(each.colour, language), pins: each.pins.clone() })
            .collect(),
        tables: [connector.kind.place.table, connector.table.id],
    }
}

fn pin(connector: &Connector, pin: &Pin, language: Language) -> ConnectorPin {
    let meaning = match pin.carries {
        Some(signal) => wiring::signal_meaning(signal, language),
        None => wiring::unconnected(pin.colour.is_some(), language).to_owned(),
    };
    let source = match pin.signal.or(pin.colour) {
        Some(cell) => cell_source(cell, language),
        None => wiring::empty_field(&connector.table.id, &pin.name, language),
    };
    let errata = [pin.signal, pin.colour].into_iter().flatten().flat_map(|cell| cell.errata).copied().collect();
    ConnectorPin {
        pin: pin.name.clone(),
        joined_with: pin.joined.clone(),
        signal: pin.printed(),
        connected: pin.carries.is_some(),
        group: pin.carries.map(|signal| Id(signal.group())),
        colour: pin.colour.map(|cell| cell_text(cell, language)),
        meaning,
        source,
        grade: Id(Grade::Printed),
        errata,
    }
}

fn record_of_cable(cable: &Cable, language: Language) -> answers::Cable {
    let (length_m, length_code) = match cable.length {
        CableLength::Metres(metres) => (Some(Number(metres)), None),
        CableLength::InNumber(letters) => (None, Some(letters)),
    };
    answers::Cable {
        role: Id(cable.role),
        material_number: cable.number.corrected,
        length_m,
        length_code,
        goal: wiring::cable_goal(cable.goal, language).to_owned(),
        drive: Id(cable.goal),
        table: cable.number.place.table,
        source: cell_source(cable.number, language),
        errata: cable.number.errata.to_vec(),
    }
}

/// Returns the tables of the answer, without repetitions.
fn tables(wiring: &CodeWiring) -> Vec<&'static str> {
    let of_connectors = wiring.connectors.iter().flat_map(|each| [each.kind.place.table, each.table.id]);
    let mut found: Vec<&'static str> = Vec::new();
    for id in of_connectors.chain(wiring.cables.iter().map(|cable| cable.number.place.table)) {
        if !found.contains(&id) {
            found.push(id);
        }
    }
    found
}

/// Returns the notes of the tables, and remarks on the answer.
fn notes(wiring: &CodeWiring, language: Language) -> Vec<WiringNote> {
    let mut found = Vec::new();
    let shown = cells(wiring);
    for table in tables(wiring).into_iter().filter_map(catalogue::table) {
        // A note on rows is one on those shown: other rows are of other encoders.
        let of_the_table = || shown.iter().filter(|cell| cell.place.table == table.id);
        let of_rows: Vec<_> = of_the_table().flat_map(|cell| table.notes_on(cell)).collect();
        let notices: Vec<_> = table.notices().collect();
        let is_of = |list: &[&'static Footnote], note| list.iter().any(|each| std::ptr::eq(*each, note));
        for note in table.footnotes.iter().filter(|note| is_of(&notices, *note) || is_of(&of_rows, *note)) {
            let by = if note.ours { NoteBy::Antrieb } else { NoteBy::Manual };
            found.push(WiringNote { text: table_note(note, language).to_owned(), by, table: Some(table.id) });
        }
    }
    let ours = |text: String, table| WiringNote { text, by: NoteBy::Antrieb, table };
    for connector in &wiring.connectors {
        let with = |meaning| connector.pins.iter().find(|pin| pin.carries.is_some_and(|s| s.meaning == meaning));
        if let (Some(supply), Some(ground)) = (with(SignalMeaning::SupplySense), with(SignalMeaning::GroundSense)) {
            found.push(ours(wiring::sense_lines(&supply.name, &ground.name, language), Some(connector.table.id)));
        }
    }
    let letters = wiring.cables.iter().find_map(|cable| match cable.length {
        CableLength::InNumber(letters) => Some(letters),
        CableLength::Metres(_) => None,
    });
    found.extend(letters.map(|letters| ours(wiring::length_in_number(&letters, language), None)));
    found
}

/// Returns the cells that are shown.
fn cells(wiring: &CodeWiring) -> Vec<&'static Cell> {
    let pins = wiring.connectors.iter().flat_map(|connector| &connector.pins);
    let of_connectors = wiring.connectors.iter().map(|connector| connector.kind);
    let of_cables = wiring.cables.iter().map(|cable| cable.number);
    pins.flat_map(|pin| [pin.signal, pin.colour]).flatten().chain(of_connectors).chain(of_cables).collect()
}

/// Returns the errata of the cells that are shown and of their tables; slips of the recovered text are left out.
fn errata(wiring: &CodeWiring) -> Vec<&'static str> {
    let cells = cells(wiring);
    let tables = tables(wiring);
    let shown = |erratum: &&catalogue::Erratum| match erratum.cell() {
        Some(_) => cells.iter().any(|cell| cell.errata.contains(&erratum.id)),
        None => tables.contains(&erratum.table) && erratum.concerns(&wiring.code),
    };
    let of_the_print = |erratum: &&catalogue::Erratum| erratum.kind != catalogue::ErratumKind::Recovery;
    catalogue::errata().iter().filter(of_the_print).filter(shown).map(|erratum| erratum.id).collect()
}

fn drops(wiring: &CodeWiring, length: Length, section: Option<Area>, language: Language) -> VoltageDrops {
    let found = installation::wiring::voltage_drops(&wiring.code, length, section);
    let source = found.first().map(|drop| source_text(&drop.resistivity.source, language));
    VoltageDrops {
        length_m: Number::in_unit(length.si(), &METRE),
        cross_section_mm2: section.map(|section| Number::in_unit(section.si(), &SQUARE_MILLIMETRE)),
        circuits: found.iter().map(|each| drop_of(each, language)).collect(),
        assumptions: wiring::copper(language),
        resistivity_source: source.unwrap_or_default(),
    }
}

fn drop_of(drop: &VoltageDrop, language: Language) -> answers::VoltageDrop {
    let volts = |value: ElectricPotential| Number::in_unit(value.si(), &VOLT);
    let verdict = match drop.verdict {
        DropVerdict::Pass => Verdict::Pass,
        DropVerdict::Fail => Verdict::Fail,
        DropVerdict::NoCrossSection
        | DropVerdict::NoTolerance
        | DropVerdict::NoOpeningCurrent
        | DropVerdict::NoNominal => Verdict::NotChecked,
    };
    let needed = drop.least.zip(drop.loss).map(|(least, [_, warm])| least + warm);
    answers::VoltageDrop {
        circuit: Id(drop.circuit),
        name: circuit_name(drop, language),
        current_a: Number::in_unit(drop.current.value.si(), &AMPERE),
        current_source: source_text(&drop.current.source, language),
        nominal_v: drop.nominal.map(volts),
        least_v: drop.least.map(volts),
        voltage_source: cell_source(drop.supply, language),
        loss_20_degc_v: drop.loss.map(|[cold, _]| volts(cold)),
        loss_70_degc_v: drop.loss.map(|[_, warm]| volts(warm)),
        needed_v: needed.map(volts),
        cross_section_min_mm2: drop.cross_section_min.map(|section| Number::in_unit(section.si(), &SQUARE_MILLIMETRE)),
        verdict: Id(verdict),
        reason: wiring::drop_reason(drop.verdict, language),
        sense_lines: drop.sense,
        grade: Id(Grade::Published.worst(drop.current.grade)),
    }
}

fn circuit_name(drop: &VoltageDrop, language: Language) -> &'static str {
    match (drop.circuit, drop.verdict) {
        (Circuit::Brake, DropVerdict::NoOpeningCurrent) => wiring::held_brake(language),
        (circuit, _) => wiring::circuit_name(circuit, language),
    }
}

/// Returns a list compared with the wiring.
#[must_use]
pub fn wiring_check(wiring: &CodeWiring, comparison: &PinComparison, language: Language) -> WiringCheck {
    let record = |finding: &PinFinding| WiringFinding {
        id: finding.difference.id(),
        severity: Id(finding.severity()),
        connector: Id(finding.role),
        line: finding.line,
        pin: Some(finding.pin.clone()).filter(|pin| !pin.is_empty()),
        expected: Some(finding.expected).filter(|expected| !expected.is_empty()),
        message: wiring::difference_text(finding, language),
        action: wiring::difference_action(finding, language),
    };
    WiringCheck {
        code: wiring.code.to_string(),
        agrees: comparison.agrees(),
        rows: comparison.rows,
        agreeing: comparison.agreeing,
        findings: comparison.findings.iter().map(record).collect(),
    }
}
