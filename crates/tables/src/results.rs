//! The tables of the results: demand, candidates, checks.

use crate::define::Subject;
use crate::table::{Cell, Column, Derived, Kind, Table};
use crate::words::{Both, column, t};
use workbench::quantities::unit::{KILOGRAM, MILLIMETRE, NEWTON_METRE, ONE, PERCENT, REVOLUTION_PER_MINUTE, SECOND};
use workbench::quantities::{Measure, Unit};
use workbench::text::{
    check_missing, check_title, describe_field, figure_term, grade_word, note_text, source_text, verdict_word,
};
use workbench::{Candidate, Check, CheckId, Demand, Language};

/// Identifier and word of the verdict on a whole candidate.
pub(crate) fn fits(candidate: &Candidate<'_>, language: Language) -> Cell {
    let (id, words): (&'static str, Both) =
        if candidate.fits() { ("fits", FITS) } else { ("does_not_fit", DOES_NOT_FIT) };
    Cell::Word(id, t(language, words).to_owned())
}

/// Nothing speaks against it.
pub(crate) const FITS: Both = ["fits", "geeignet"];
/// Something speaks against it.
pub(crate) const DOES_NOT_FIT: Both = ["DOES NOT FIT", "PASST NICHT"];

fn code(language: Language) -> Column {
    let about =
        ["ordering code, or name of the project's own actuator", "Bestellbezeichnung oder Name des eigenen Antriebs"];
    column("code", ["ordering code", "Bestellbezeichnung"], Kind::Text, None, about, language)
}

pub(crate) fn demand(subject: &Subject<'_>) -> Table {
    let l = subject.language;
    let figure = |name: &str, symbol: &str, unit: &'static Unit, about: Both| Column {
        title: figure_term(symbol, l),
        ..column(name, ["", ""], Kind::Number, Some(unit), about, l)
    };
    let cycle = ["over the whole cycle, own inertia included", "über den ganzen Zyklus, mit der eigenen Trägheit"];
    let governing = ["of the governing move, eq. 69.1 and 69.2", "der maßgebenden Bewegung, Gl. 69.1 und 69.2"];
    let torque = |name: &str| column(name, ["", ""], Kind::Number, Some(&NEWTON_METRE), governing, l);
    let named = |name: &'static str, title: Both| Column { title: t(l, title).to_owned(), ..torque(name) };
    let columns = vec![
        code(l),
        column(
            "mode",
            ["mode", "Verfahren"],
            Kind::Text,
            None,
            [
                "manual: equations 69.1 to 69.4; integral: exact integral over the motion, which the checks use",
                "manual: Gleichungen 69.1 bis 69.4; integral: exaktes Integral über die Bewegung, mit dem geprüft wird",
            ],
            l,
        ),
        figure("T_rms", "T_rms", &NEWTON_METRE, cycle),
        figure("T_peak", "T_peak", &NEWTON_METRE, cycle),
        column(
            "T_peak_at",
            ["at", "bei"],
            Kind::Number,
            Some(&SECOND),
            ["instant of the peak torque", "Zeitpunkt des Spitzendrehmoments"],
            l,
        ),
        figure(
            "n_av",
            "n_av",
            &REVOLUTION_PER_MINUTE,
            ["mean of |n|, pauses included", "Mittel von |n|, mit den Pausen"],
        ),
        figure("n_peak", "n_peak", &REVOLUTION_PER_MINUTE, ["largest |n|", "größtes |n|"]),
        figure("ED", "ED", &PERCENT, ["share of the cycle in motion", "Anteil der Bewegung am Zyklus"]),
        named("T_1", ["T_1 accelerating", "T_1 Beschleunigen"]),
        named("T_2", ["T_2 running", "T_2 Fahren"]),
        named("T_3", ["T_3 braking", "T_3 Bremsen"]),
        column(
            "move",
            ["governing move", "maßgebende Bewegung"],
            Kind::Count,
            None,
            ["number of the move that T_1 to T_3 belong to", "Nummer der Bewegung, zu der T_1 bis T_3 gehören"],
            l,
        ),
    ];
    let about = [
        "what the axis asks of each candidate, by the manual's equations and by exact integrals",
        "was die Achse von jedem Kandidaten verlangt, nach den Gleichungen der Anleitung und nach exakten Integralen",
    ];
    let mut table = subject.empty("demand", ["Demand", "Bedarf"], about, columns);
    for (_, candidate) in subject.shown() {
        let judgement = &candidate.judgement;
        let mut row = |mode: &str, demand: &Demand, moves: [Cell; 4]| {
            let mut cells = vec![
                Cell::text(candidate.id.to_string()),
                Cell::text(mode),
                Cell::in_unit(Some(demand.torque_rms.si()), &NEWTON_METRE),
                Cell::in_unit(Some(demand.torque_peak.si()), &NEWTON_METRE),
                Cell::in_unit(Some(demand.torque_peak_at.si()), &SECOND),
                Cell::in_unit(Some(demand.speed_mean.si()), &REVOLUTION_PER_MINUTE),
                Cell::in_unit(Some(demand.speed_peak.si()), &REVOLUTION_PER_MINUTE),
                Cell::in_unit(Some(demand.duty_factor), &PERCENT),
            ];
            cells.extend(moves);
            table.rows.push(cells);
        };
        let none = [Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty];
        if let Some(manual) = &judgement.manual {
            let governing = manual.moves.get(manual.governing).map_or(none.clone(), |each| {
                #[allow(clippy::cast_precision_loss, reason = "at most ten thousand moves")]
                let number = Cell::number((manual.governing + 1) as f64);
                let torque = |torque: f64| Cell::in_unit(Some(torque), &NEWTON_METRE);
                [torque(each.accelerate.si()), torque(each.run.si()), torque(each.brake.si()), number]
            });
            row("manual", &manual.demand, governing);
        }
        if let Some(demand) = &judgement.demand {
            row("integral", demand, none);
        }
    }
    table
}

pub(crate) fn candidates(subject: &Subject<'_>) -> Table {
    let l = subject.language;
    let shown = subject.shown();
    let ids: Vec<CheckId> = CheckId::ALL
        .iter()
        .copied()
        .filter(|id| shown.iter().any(|(_, each)| each.judgement.checks.iter().any(|check| check.id == *id)))
        .collect();
    let data = ["from its data sheet", "aus seinem Datenblatt"];
    let figure = |name: &str, symbol: &str, unit: &'static Unit, about: Both| Column {
        title: figure_term(symbol, l),
        ..column(name, ["", ""], Kind::Number, Some(unit), about, l)
    };
    let mut columns = vec![
        column(
            "rank",
            ["rank", "Rang"],
            Kind::Count,
            None,
            [
                "place in the ranking; none where it does not fit",
                "Platz in der Reihenfolge; keiner, wo er nicht geeignet ist",
            ],
            l,
        ),
        code(l),
        column(
            "verdict",
            ["verdict", "Urteil"],
            Kind::Verdict,
            None,
            ["fits: nothing speaks against it", "fits: nichts spricht dagegen"],
            l,
        ),
        column(
            "utilisation",
            ["utilisation", "Auslastung"],
            Kind::Share,
            Some(&ONE),
            ["highest of all limits, 1 is the limit", "höchste aller Grenzen, 1 ist die Grenze"],
            l,
        ),
        column(
            "tightest",
            ["tightest check", "engster Nachweis"],
            Kind::Text,
            None,
            ["id of the check that it belongs to", "Kennung des Nachweises, zu dem sie gehört"],
            l,
        ),
        column(
            "margin",
            ["margin", "Reserve"],
            Kind::Share,
            Some(&ONE),
            ["1 less the utilisation", "1 weniger der Auslastung"],
            l,
        ),
        figure("mass", "m", &KILOGRAM, data),
        figure("length", "L", &MILLIMETRE, data),
        figure("hollow_shaft", "d_H", &MILLIMETRE, data),
        figure("ratio", "i", &ONE, data),
        figure("T_max", "T_max", &NEWTON_METRE, data),
        column(
            "open_questions",
            ["open questions", "offene Fragen"],
            Kind::Count,
            None,
            ["how many could not be answered for want of a datum", "wie viele mangels Angabe nicht beantwortet sind"],
            l,
        ),
        column(
            "on_request",
            ["on request", "auf Anfrage"],
            Kind::Text,
            None,
            ["fields of the code that are on request only", "Felder des Codes, die es nur auf Anfrage gibt"],
            l,
        ),
        column(
            "objections",
            ["requirements not met", "nicht erfüllt"],
            Kind::Text,
            None,
            ["requirements not met and rules broken", "Anforderungen nicht erfüllt, Regeln verletzt"],
            l,
        ),
    ];
    columns.extend(ids.iter().map(|id| {
        Column {
            name: id.id().to_owned(),
            title: check_title(*id, l),
            unit: Some(&ONE),
            about: t(
                l,
                ["utilisation of this check, 1 is the limit", "Auslastung dieses Nachweises, 1 ist die Grenze"],
            )
            .to_owned(),
            kind: Kind::Share,
        }
    }));
    let about = [
        "the candidates in their order, with the utilisation of every check",
        "die Kandidaten in ihrer Reihenfolge, mit der Auslastung jedes Nachweises",
    ];
    let mut table = subject.empty("candidates", ["Candidates", "Kandidaten"], about, columns);
    #[allow(clippy::cast_precision_loss, reason = "counts of a few hundred")]
    let count = |count: usize| Cell::number(count as f64);
    for (rank, candidate) in &shown {
        let data = candidate.parameters;
        let utilisation = Cell::number(candidate.standing.utilisation);
        let margin = utilisation.as_number().map_or(Cell::Empty, |share| Cell::number(1.0 - share));
        let request: Vec<&str> = candidate.on_request.iter().map(|field| describe_field(*field, l)).collect();
        let mut row = vec![
            rank.map_or(Cell::Empty, count),
            Cell::text(candidate.id.to_string()),
            fits(candidate, l),
            utilisation,
            candidate
                .judgement
                .tightest()
                .map_or(Cell::Empty, |check| Cell::Word(check.id.id(), check_title(check.id, l))),
            margin,
            Cell::in_unit(data.mass.known().map(|known| known.value.si()), &KILOGRAM),
            Cell::in_unit(data.length.known().map(|known| known.value.si()), &MILLIMETRE),
            Cell::in_unit(data.hollow_shaft.known().map(|known| known.value.si()), &MILLIMETRE),
            Cell::in_unit(data.ratio.known().map(|known| known.value), &ONE),
            Cell::in_unit(data.torque_max.known().map(|known| known.value.si()), &NEWTON_METRE),
            count(candidate.open_questions()),
            Cell::text(request.join(", ")),
            Cell::text(workbench::answer::objections(candidate, l).join("; ")),
        ];
        row.extend(ids.iter().map(|id| {
            let check = candidate.judgement.checks.iter().find(|check| check.id == *id);
            check.and_then(|check| check.utilisation).map_or(Cell::Empty, Cell::number)
        }));
        table.rows.push(row);
    }
    if let (Some(column), Some(utilisation)) = (table.column("margin"), table.column("utilisation")) {
        table.derived.push(Derived::Margin { column, utilisation });
    }
    table
}

pub(crate) fn checks(subject: &Subject<'_>) -> Table {
    let l = subject.language;
    let columns = vec![
        code(l),
        column("check", ["id", "Kennung"], Kind::Text, None, ["id of the check", "Kennung des Nachweises"], l),
        column("title", ["check", "Nachweis"], Kind::Text, None, ["its title", "ihr Titel"], l),
        column(
            "verdict",
            ["verdict", "Urteil"],
            Kind::Verdict,
            None,
            ["pass, fail, advice or not_checked", "pass, fail, advice oder not_checked"],
            l,
        ),
        column("value", ["value", "Wert"], Kind::Number, None, ["what the axis asks", "was die Achse verlangt"], l),
        column(
            "limit",
            ["limit", "Grenze"],
            Kind::Number,
            None,
            ["what the actuator gives, or what is asked for", "was der Antrieb hergibt oder was verlangt ist"],
            l,
        ),
        column(
            "unit",
            ["unit", "Einheit"],
            Kind::Text,
            None,
            ["unit of value and limit", "Einheit von Wert und Grenze"],
            l,
        ),
        column(
            "direction",
            ["direction", "Richtung"],
            Kind::Text,
            None,
            [
                "at_most or at_least: how the value must lie to the limit",
                "at_most oder at_least: wie der Wert zur Grenze liegen muss",
            ],
            l,
        ),
        column(
            "utilisation",
            ["utilisation", "Auslastung"],
            Kind::Share,
            Some(&ONE),
            ["1 is the limit", "1 ist die Grenze"],
            l,
        ),
        column(
            "margin",
            ["margin", "Reserve"],
            Kind::Share,
            Some(&ONE),
            ["1 less the utilisation", "1 weniger der Auslastung"],
            l,
        ),
        column(
            "at",
            ["at", "bei"],
            Kind::Number,
            Some(&SECOND),
            ["instant of the worst case within the cycle", "Zeitpunkt des ungünstigsten Falls im Zyklus"],
            l,
        ),
        column(
            "grade",
            ["grade", "Güte"],
            Kind::Text,
            None,
            ["the worst grade among the inputs", "die schlechteste Güte unter den Eingaben"],
            l,
        ),
        column(
            "source",
            ["source", "Quelle"],
            Kind::Text,
            None,
            ["source of the limit; of the value", "Quelle der Grenze; des Werts"],
            l,
        ),
        column(
            "missing",
            ["missing", "fehlt"],
            Kind::Text,
            None,
            ["what a check that is not answered lacks", "was einem nicht geführten Nachweis fehlt"],
            l,
        ),
        column(
            "notes",
            ["remarks", "Bemerkungen"],
            Kind::Text,
            None,
            ["what a reader must know", "was ein Leser wissen muss"],
            l,
        ),
    ];
    let about = ["every check of the candidates shown", "jeder Nachweis der gezeigten Kandidaten"];
    let mut table = subject.empty("checks", ["Checks", "Nachweise"], about, columns);
    let chosen = &subject.chosen.id;
    let mut shown = subject.shown();
    // The chosen one stands first: its checks are what most readers look for.
    shown.sort_by_key(|(_, candidate)| candidate.id != *chosen);
    for (_, candidate) in &shown {
        let name = candidate.id.to_string();
        table.rows.extend(candidate.judgement.checks.iter().map(|check| check_row(&name, check, l)));
    }
    let of = |name: &str| table.column(name);
    if let (Some(column), Some(value), Some(limit), Some(direction), Some(margin)) =
        (of("utilisation"), of("value"), of("limit"), of("direction"), of("margin"))
    {
        table.derived.push(Derived::Utilisation { column, value, limit, direction });
        table.derived.push(Derived::Margin { column: margin, utilisation: column });
    }
    table
}

fn check_row(code: &str, check: &Check, l: Language) -> Vec<Cell> {
    let figure = |figure: Option<workbench::Figure>| figure.map_or(Cell::Empty, |figure| Cell::number(figure.value()));
    let unit = check.value.or(check.limit).map_or(Cell::Empty, |figure| Cell::unit(figure.unit));
    let sources: Vec<String> =
        [&check.limit_source, &check.value_source].into_iter().flatten().map(|source| source_text(source, l)).collect();
    let notes: Vec<String> =
        check.notes.iter().map(|note| note_text(note, l)).filter(|note| !note.is_empty()).collect();
    let utilisation = check.utilisation.map_or(Cell::Empty, Cell::number);
    let margin = utilisation.as_number().map_or(Cell::Empty, |share| Cell::number(1.0 - share));
    vec![
        Cell::text(code),
        Cell::text(check.id.id()),
        Cell::text(check_title(check.id, l)),
        Cell::Word(check.verdict.id(), verdict_word(check.verdict, l)),
        figure(check.value),
        figure(check.limit),
        unit,
        Cell::text(check.direction().id()),
        utilisation,
        margin,
        Cell::in_unit(check.at.map(|at| at.si()), &SECOND),
        check.grade.map_or(Cell::Empty, |grade| Cell::Word(grade.id(), grade_word(grade, l).to_owned())),
        Cell::text(sources.join("; ")),
        check.missing.map_or(Cell::Empty, |missing| Cell::Word(missing, check_missing(missing, l))),
        Cell::text(notes.join("; ")),
    ]
}
