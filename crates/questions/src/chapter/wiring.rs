//! Connectors, pins and cables as a chapter.

use super::parts::{NOTHING, Shown, grid, hazards};
use answers::{
    Block, Chapter, Column, Connector, ConnectorExit, ConnectorPin, NoteBy, Number, Picture, VoltageDrops, Wiring,
};
use quantities::{Language, format_number, format_significant};
use std::fmt::Write as _;
use words::{ERRATUM_MARK, capitalised, erratum_line, marked, terminal, terms, typeset, verdict_word, wiring};

/// Returns the wiring of a code, with the drawings of its mating faces if the face can show them.
#[must_use]
pub fn wiring(record: &Wiring, drawings: Vec<Picture>, language: Language) -> Chapter {
    let mut chapter = Chapter::new(wiring::title(&record.code, language));
    for connector in &record.connectors {
        connected(&mut chapter, connector, record, language);
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
        let by = match note.by {
            NoteBy::Antrieb => format!("{}: ", terminal::not_of_the_manual(language)),
            _ => String::new(),
        };
        let table = note.table.map(|table| format!(" ({} {table})", terminal::table(language)));
        format!("{by}{}{}", note.text, table.unwrap_or_default())
    };
    let mut remarks: Vec<String> = record.notes.iter().map(remark).collect();
    let pins = record.connectors.iter().flat_map(|connector| &connector.pins).flat_map(|pin| &pin.errata);
    let marks: Vec<&str> = pins.chain(record.cables.iter().flat_map(|cable| &cable.errata)).copied().collect();
    let erratum = |id: &&'static str| {
        let mark = if marks.contains(id) { format!("{ERRATUM_MARK} ") } else { String::new() };
        format!("{mark}{}", erratum_line(id, language))
    };
    remarks.extend(record.errata.iter().map(erratum));
    chapter.points(remarks);
    chapter.section(capitalised(wiring::rules(language)));
    chapter.hazards(hazards(&record.rules, language));
    chapter
}

/// Returns those errata whose evidence the chapter states; slips of the recovered text are none.
fn listed(errata: &[&'static str], record: &Wiring) -> Vec<&'static str> {
    errata.iter().filter(|id| record.errata.contains(id)).copied().collect()
}

fn connected(chapter: &mut Chapter, connector: &Connector, record: &Wiring, language: Language) {
    let exit = connector.exit.map(|exit| match exit {
        ConnectorExit::Cable => wiring::at_the_end_of_a_cable(language),
        ConnectorExit::Housing => wiring::in_the_housing(language),
    });
    let exit = exit.map(|exit| format!(", {exit}")).unwrap_or_default();
    let [kind, pins] = connector.tables;
    let table = terminal::table(language);
    let name = capitalised(wiring::role_name(*connector.role, language));
    chapter.section(format!("{name}: {}{exit} ({table} {kind}, {table} {pins})", typeset(connector.kind)));
    let mating = [
        connector.material_number.map(|number| wiring::mating_coupling(&number, language)),
        connector.outer_diameter.map(|value| wiring::outer_diameter(&value, language)),
        connector.length.map(|value| wiring::length_of_coupling(&value, language)),
    ];
    chapter.text(mating.into_iter().flatten().collect::<Vec<_>>().join(", "));
    let name = |pin: &ConnectorPin| {
        let name = pin.joined_with.as_ref().map_or_else(|| pin.pin.clone(), |other| format!("{} ({other})", pin.pin));
        marked(name, &listed(&pin.errata, record))
    };
    let colour = |pin: &ConnectorPin| pin.colour.unwrap_or(NOTHING).to_owned();
    let mut columns: Vec<Shown<'_, ConnectorPin>> = vec![
        (Column::text(wiring::pin(language)), &name),
        (Column::text(wiring::signal(language)), &|pin| pin.signal.to_owned()),
        (Column::text(wiring::colour(language)), &colour),
        (Column::wide(terminal::meaning(language)), &|pin| pin.meaning.clone()),
    ];
    if !connector.pins.iter().any(|pin| pin.colour.is_some()) {
        let _ = columns.remove(2);
    }
    grid(chapter, &connector.pins, &columns);
    let same =
        |colour: &answers::AmbiguousColour| wiring::same_colour(&colour.colour, &colour.pins.join(", "), language);
    chapter.points(connector.ambiguous.iter().map(same).collect());
}

fn cables(chapter: &mut Chapter, record: &Wiring, language: Language) {
    chapter.section(capitalised(wiring::cables(language)));
    if record.cables.is_empty() {
        chapter.text(wiring::no_cables(language));
    }
    let length = |cable: &answers::Cable| {
        let length = cable.length_m.map(|length| format!("{} m", format_number(length.0, 0, language)));
        length.or(cable.length_code.map(str::to_owned)).unwrap_or_else(|| NOTHING.into())
    };
    grid(
        chapter,
        &record.cables,
        &[
            (Column::text(wiring::material_number(language)), &|cable| {
                marked(cable.material_number.to_owned(), &listed(&cable.errata, record))
            }),
            (Column::numbers(wiring::length(language)), &length),
            (Column::text(wiring::connects(language)), &|cable| wiring::cable_role(*cable.role, language).to_owned()),
            (Column::wide(wiring::goes_to(language)), &|cable| cable.goal.clone()),
            (Column::text(terminal::table(language)), &|cable| cable.table.to_owned()),
        ],
    );
}

fn dropped(chapter: &mut Chapter, drops: &VoltageDrops, language: Language) {
    let number = |value: Number| format_significant(value.0, 3, language);
    let shown = |value: Option<Number>| value.map_or_else(|| NOTHING.into(), number);
    chapter.section(capitalised(&wiring::voltage_drop(&number(drops.length_m), language)));
    let verdict = |circuit: &answers::VoltageDrop| {
        let mut verdict = verdict_word(*circuit.verdict, language);
        if !circuit.reason.is_empty() {
            let _ = write!(verdict, ": {}", circuit.reason);
        }
        if circuit.sense_lines {
            let _ = write!(verdict, "; {}", wiring::sense_makes_up(language));
        }
        verdict
    };
    grid(
        chapter,
        &drops.circuits,
        &[
            (Column::text(wiring::circuit(language)), &|circuit| circuit.name.to_owned()),
            (Column::numbers("A"), &|circuit| number(circuit.current_a)),
            (Column::numbers(wiring::nominal_v(language)), &|circuit| shown(circuit.nominal_v)),
            (Column::numbers(wiring::least_v(language)), &|circuit| shown(circuit.least_v)),
            (Column::numbers(wiring::at_20_degc(language)), &|circuit| shown(circuit.loss_20_degc_v)),
            (Column::numbers(wiring::at_70_degc(language)), &|circuit| shown(circuit.loss_70_degc_v)),
            (Column::numbers(wiring::least_mm2(language)), &|circuit| shown(circuit.cross_section_min_mm2)),
            (Column::wide(terms::verdict(language)), &verdict),
        ],
    );
    let line = |label: &str, text: &str| format!("{}: {text}", capitalised(label));
    chapter.text(line(terms::assumptions(language), drops.assumptions));
    chapter.text(line(terms::source(language), &drops.resistivity_source));
}
