//! Connectors, pins and cables.

use super::{NOTHING, hazards};
use answers::{Block, Chapter, Column, Connector, ConnectorExit, NoteBy, Number, Picture, VoltageDrops, Wiring};
use quantities::{Language, format_number, format_significant};
use std::fmt::Write as _;
use words::{capitalised, evidence_text, terminal, terms, verdict_word, wiring};

/// The wiring of a code, with the drawings of its mating faces if the face can show them.
#[must_use]
pub fn wiring(record: &Wiring, drawings: Vec<Picture>, language: Language) -> Chapter {
    let mut chapter = Chapter::new(wiring::title(&record.code, language));
    for connector in &record.connectors {
        connected(&mut chapter, connector, language);
    }
    chapter.blocks.extend(drawings.into_iter().map(Block::Picture));
    cables(&mut chapter, record, language);
    if let Some(drops) = &record.voltage_drop {
        dropped(&mut chapter, drops, language);
    }
    chapter.section(capitalised(wiring::not_available(language)));
    let absent = |table: &str, text: &str| format!("{text} ({} {table})", terminal::table(language));
    chapter.points(record.not_available.iter().map(|each| absent(each.table, each.text)).collect());
    chapter.section(capitalised(terms::remarks(language)));
    let remark = |note: &answers::WiringNote| {
        let by = if note.by == NoteBy::Antrieb { "antrieb: " } else { "" };
        let table = note.table.map(|table| format!(" ({} {table})", terminal::table(language)));
        format!("{by}{}{}", note.text, table.unwrap_or_default())
    };
    let mut remarks: Vec<String> = record.notes.iter().map(remark).collect();
    remarks.extend(record.errata.iter().map(|id| format!("{id}: {}", evidence_text(id, language))));
    chapter.points(remarks);
    chapter.section(capitalised(wiring::rules(language)));
    chapter.hazards(hazards(&record.rules, language));
    chapter
}

fn connected(chapter: &mut Chapter, connector: &Connector, language: Language) {
    let exit = connector.exit.map(|exit| match exit {
        ConnectorExit::Cable => wiring::at_the_end_of_a_cable(language),
        ConnectorExit::Housing => wiring::in_the_housing(language),
    });
    let exit = exit.map(|exit| format!(", {exit}")).unwrap_or_default();
    let [kind, pins] = connector.tables;
    let table = terminal::table(language);
    let name = capitalised(wiring::role_name(*connector.role, language));
    chapter.section(format!("{name}: {}{exit} ({table} {kind}, {table} {pins})", connector.kind));
    let mating = [
        connector.material_number.map(|number| wiring::mating_coupling(&number, language)),
        connector.outer_diameter.map(|value| wiring::outer_diameter(&value, language)),
        connector.length.map(|value| wiring::length_of_coupling(&value, language)),
    ];
    chapter.text(mating.into_iter().flatten().collect::<Vec<_>>().join(", "));
    let coloured = connector.pins.iter().any(|pin| pin.colour.is_some());
    let mut columns = vec![Column::text(wiring::pin(language)), Column::text(wiring::signal(language))];
    if coloured {
        columns.push(Column::text(wiring::colour(language)));
    }
    columns.push(Column::wide(terminal::meaning(language)));
    let row = |pin: &answers::ConnectorPin| {
        let name = pin.joined_with.as_ref().map_or_else(|| pin.pin.clone(), |other| format!("{} ({other})", pin.pin));
        let mut row = vec![name, pin.signal.to_owned()];
        if coloured {
            row.push(pin.colour.unwrap_or(NOTHING).to_owned());
        }
        row.push(pin.meaning.clone());
        row
    };
    chapter.grid(columns, connector.pins.iter().map(row).collect());
    let same =
        |colour: &answers::AmbiguousColour| wiring::same_colour(&colour.colour, &colour.pins.join(", "), language);
    chapter.points(connector.ambiguous.iter().map(same).collect());
}

fn cables(chapter: &mut Chapter, record: &Wiring, language: Language) {
    chapter.section(capitalised(wiring::cables(language)));
    if record.cables.is_empty() {
        chapter.text(wiring::no_cables(language));
    }
    let row = |cable: &answers::Cable| {
        let length = cable.length_m.map(|length| format!("{} m", format_number(length.0, 0, language)));
        vec![
            cable.material_number.to_owned(),
            length.or(cable.length_code.map(str::to_owned)).unwrap_or_else(|| NOTHING.into()),
            wiring::cable_role(*cable.role, language).to_owned(),
            cable.goal.clone(),
            cable.table.to_owned(),
        ]
    };
    let columns = vec![
        Column::text(wiring::material_number(language)),
        Column::numbers(wiring::length(language)),
        Column::text(wiring::connects(language)),
        Column::wide(wiring::goes_to(language)),
        Column::text(terminal::table(language)),
    ];
    chapter.grid(columns, record.cables.iter().map(row).collect());
}

fn dropped(chapter: &mut Chapter, drops: &VoltageDrops, language: Language) {
    let number = |value: Number| format_significant(value.0, 3, language);
    let shown = |value: Option<Number>| value.map_or_else(|| NOTHING.into(), number);
    chapter.section(capitalised(&wiring::voltage_drop(&number(drops.length_m), language)));
    let row = |circuit: &answers::VoltageDrop| {
        let mut verdict = verdict_word(*circuit.verdict, language);
        if !circuit.reason.is_empty() {
            let _ = write!(verdict, ": {}", circuit.reason);
        }
        if circuit.sense_lines {
            let _ = write!(verdict, "; {}", wiring::sense_makes_up(language));
        }
        vec![
            circuit.name.to_owned(),
            number(circuit.current_a),
            shown(circuit.nominal_v),
            shown(circuit.least_v),
            shown(circuit.loss_20_degc_v),
            shown(circuit.loss_70_degc_v),
            shown(circuit.cross_section_min_mm2),
            verdict,
        ]
    };
    let columns = vec![
        Column::text(wiring::circuit(language)),
        Column::numbers("A"),
        Column::numbers(wiring::nominal_v(language)),
        Column::numbers(wiring::least_v(language)),
        Column::numbers(wiring::at_20_degc(language)),
        Column::numbers(wiring::at_70_degc(language)),
        Column::numbers(wiring::least_mm2(language)),
        Column::wide(terms::verdict(language)),
    ];
    chapter.grid(columns, drops.circuits.iter().map(row).collect());
    let line = |label: &str, text: &str| format!("{}: {text}", capitalised(label));
    chapter.text(line(terms::assumptions(language), drops.assumptions));
    chapter.text(line(terms::source(language), &drops.resistivity_source));
}
