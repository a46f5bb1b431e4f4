//! Tables of the results: demand, candidates, checks.

use crate::cell::Cell;
use crate::format::Format;
use crate::subject::{Subject, column, titled};
use crate::table::{Column, ColumnContent, Derived, Table};
use quantities::unit::{KILOGRAM, MILLIMETRE, NEWTON_METRE, ONE, PERCENT, REVOLUTION_PER_MINUTE, SECOND};
use quantities::{Language, Measure, Unit};
use questions::texts::{by_importance, margin_share, verdict_of, verdict_text};
use questions::{Candidate, Check, CheckId, Demand, Direction, Verdict};
use words::{
    Word, capitalised, check_missing, check_title, describe_field, erratum_place_of, figure_term, grade_word,
    note_text, source_text, tables, terms, title_of_check, without_keys,
};

/// Returns identifier and word of the verdict on a whole candidate.
pub(crate) fn fits(candidate: &Candidate<'_>, language: Language) -> Cell {
    Cell::Word(candidate.fit().id(), verdict_of(candidate, language).to_owned())
}

fn code(language: Language) -> Column {
    let about = tables::ordering_code_about;
    column("code", terms::ordering_code, ColumnContent::Text, None, about, language)
}

/// Creates a column of a quantity that has a symbol.
fn figure(name: &str, symbol: &str, unit: &'static Unit, about: Word, language: Language) -> Column {
    titled(name, figure_term(symbol, language), ColumnContent::Number, Some(unit), about, language)
}

pub(crate) fn demand(subject: &Subject<'_>) -> Table {
    let l = subject.language;
    let cycle = tables::whole_cycle_about;
    let governing = tables::governing_torque_about;
    let torque =
        |name: &str, title: Word| column(name, title, ColumnContent::Number, Some(&NEWTON_METRE), governing, l);
    let columns = vec![
        code(l),
        column("mode", tables::mode, ColumnContent::Text, None, tables::mode_about, l),
        figure("T_rms", "T_rms", &NEWTON_METRE, cycle, l),
        figure("T_peak", "T_peak", &NEWTON_METRE, cycle, l),
        column("T_peak_at", tables::at, ColumnContent::Number, Some(&SECOND), tables::peak_torque_at_about, l),
        figure("n_av", "n_av", &REVOLUTION_PER_MINUTE, tables::mean_speed_about, l),
        figure("n_peak", "n_peak", &REVOLUTION_PER_MINUTE, tables::peak_speed_about, l),
        figure("ED", "ED", &PERCENT, tables::duty_factor_about, l),
        torque("T_1", tables::t_1_accelerating),
        torque("T_2", tables::t_2_running),
        torque("T_3", tables::t_3_braking),
        column("move", tables::governing_move, ColumnContent::Count, None, tables::governing_move_about, l),
    ];
    let mut rows = Vec::new();
    for (_, candidate) in subject.shown() {
        let judgement = &candidate.judgement;
        let mut row = |(id, mode): (&'static str, Word), demand: &Demand, moves: [Cell; 4]| {
            let mut cells = vec![
                Cell::text(candidate.id.to_string()),
                Cell::Word(id, mode(l).to_owned()),
                Cell::in_unit(Some(demand.torque_rms.si()), &NEWTON_METRE),
                Cell::in_unit(Some(demand.torque_peak.si()), &NEWTON_METRE),
                Cell::in_unit(Some(demand.torque_peak_at.si()), &SECOND),
                Cell::in_unit(Some(demand.speed_mean.si()), &REVOLUTION_PER_MINUTE),
                Cell::in_unit(Some(demand.speed_peak.si()), &REVOLUTION_PER_MINUTE),
                Cell::in_unit(Some(demand.duty_factor), &PERCENT),
            ];
            cells.extend(moves);
            rows.push(cells);
        };
        let none = [Cell::Empty, Cell::Empty, Cell::Empty, Cell::Empty];
        if let Some(manual) = judgement.by_the_manual() {
            let governing = manual.moves.get(manual.governing).map_or(none.clone(), |each| {
                #[allow(clippy::cast_precision_loss, reason = "at most ten thousand moves")]
                let number = Cell::number((manual.governing + 1) as f64);
                let torque = |torque: f64| Cell::in_unit(Some(torque), &NEWTON_METRE);
                [torque(each.accelerate.si()), torque(each.run.si()), torque(each.brake.si()), number]
            });
            row(("manual", tables::mode_manual), &manual.demand, governing);
        }
        if let Some(demand) = &judgement.demand {
            row(("integral", tables::mode_integral), demand, none);
        }
    }
    subject.made("demand", terms::demand, tables::demand_about, columns, rows.into_iter().collect())
}

pub(crate) fn candidates(subject: &Subject<'_>) -> Table {
    let l = subject.language;
    let shown = subject.shown();
    let ids: Vec<CheckId> = CheckId::ALL
        .iter()
        .copied()
        .filter(|id| shown.iter().any(|(_, each)| each.judgement.checks.iter().any(|check| check.id == *id)))
        .collect();
    let data = tables::data_sheet_about;
    let mut columns = vec![
        column("rank", terms::rank, ColumnContent::Count, None, tables::rank_about, l),
        code(l),
        column("verdict", terms::verdict, ColumnContent::Verdict, None, tables::candidate_verdict_about, l),
        column(
            "utilisation",
            terms::utilisation,
            ColumnContent::Share,
            Some(&ONE),
            tables::highest_utilisation_about,
            l,
        ),
        column("tightest", terms::tightest_check, ColumnContent::Text, None, tables::tightest_check_about, l),
        column("margin", terms::margin, ColumnContent::Share, Some(&ONE), tables::margin_about, l),
        figure("mass", "m", &KILOGRAM, data, l),
        figure("length", "L", &MILLIMETRE, data, l),
        figure("hollow_shaft", "d_H", &MILLIMETRE, data, l),
        figure("ratio", "i", &ONE, data, l),
        figure("T_max", "T_max", &NEWTON_METRE, data, l),
        column("errata", tables::errata_of_data, ColumnContent::Text, None, tables::errata_of_data_about, l),
        column("open_questions", tables::open_questions, ColumnContent::Count, None, tables::open_questions_about, l),
        column("on_request", terms::on_request, ColumnContent::Text, None, tables::on_request_about, l),
        column("objections", tables::objections, ColumnContent::Text, None, tables::objections_about, l),
    ];
    let of_check = tables::utilisation_of_check_about;
    let share = |id: &CheckId| {
        let kind = if id.has_margin() { ColumnContent::Share } else { ColumnContent::Ratio };
        titled(id.id(), check_title(*id, l), kind, Some(&ONE), of_check, l)
    };
    columns.extend(ids.iter().map(share));
    #[allow(clippy::cast_precision_loss, reason = "counts of a few hundred")]
    let count = |count: usize| Cell::number(count as f64);
    let row = |(rank, candidate): &(Option<usize>, Candidate<'_>)| {
        let data = candidate.parameters;
        let utilisation = candidate.utilisation().map_or(Cell::Empty, Cell::number);
        let margin = utilisation.as_number().map_or(Cell::Empty, |share| Cell::number(1.0 - share));
        let request: Vec<&str> = candidate.on_request.iter().map(|field| describe_field(*field, l)).collect();
        let mut row = vec![
            rank.map_or(Cell::Empty, count),
            Cell::text(candidate.id.to_string()),
            fits(candidate, l),
            utilisation,
            candidate.governing().map_or(Cell::Empty, |check| Cell::Word(check.id.id(), title_of_check(check, l))),
            margin,
            Cell::in_unit(data.mass.known().map(|known| known.value.si()), &KILOGRAM),
            Cell::in_unit(data.length.known().map(|known| known.value.si()), &MILLIMETRE),
            Cell::in_unit(data.hollow_shaft.known().map(|known| known.value.si()), &MILLIMETRE),
            Cell::in_unit(data.ratio.known().map(|known| known.value), &ONE),
            Cell::in_unit(data.torque_max.known().map(|known| known.value.si()), &NEWTON_METRE),
            errata_cell(&errata_of(candidate), l),
            count(candidate.open_questions()),
            Cell::text(request.join(", ")),
            Cell::text(questions::answer::objections(candidate, l).join("; ")),
        ];
        row.extend(ids.iter().map(|id| {
            let check = candidate.judgement.checks.iter().find(|check| check.id == *id);
            check.and_then(margin_share).map_or(Cell::Empty, Cell::number)
        }));
        row
    };
    let rows = shown.iter().map(row).collect();
    let mut table = subject.made("candidates", terms::candidates, tables::candidates_about, columns, rows);
    if let (Some(column), Some(utilisation)) = (table.column("margin"), table.column("utilisation")) {
        table.derived.push(Derived::Margin { column, utilisation });
    }
    table
}

/// The errata of the data that a row of candidates shows.
fn errata_of(candidate: &Candidate<'_>) -> Vec<&'static str> {
    fn of<T>(datum: &provenance::Datum<T>) -> &'static [&'static str] {
        datum.known().map_or(&[], |known| known.errata)
    }
    let data = candidate.parameters;
    let shown = [of(&data.mass), of(&data.length), of(&data.hollow_shaft), of(&data.ratio), of(&data.torque_max)];
    shown.concat()
}

/// Returns the cell of errata: their ids, and their places for readers.
fn errata_cell(ids: &[&'static str], language: Language) -> Cell {
    let mut places: Vec<String> = Vec::new();
    for place in ids.iter().map(|id| erratum_place_of(id, language)) {
        if !places.contains(&place) {
            places.push(place);
        }
    }
    if ids.is_empty() { Cell::Empty } else { Cell::Ids(ids.join(", "), capitalised(&places.join("; "))) }
}

pub(crate) fn checks(subject: &Subject<'_>, format: Format) -> Table {
    let l = subject.language;
    let mut columns = vec![
        code(l),
        column("check", tables::check_id, ColumnContent::Id, None, tables::check_id_about, l),
        column("title", terms::check, ColumnContent::Text, None, tables::check_title_about, l),
        column("verdict", terms::verdict, ColumnContent::Verdict, None, tables::check_verdict_about, l),
        column("value", terms::value, ColumnContent::Number, None, tables::value_of_check_about, l),
        column("limit", terms::limit, ColumnContent::Number, None, tables::limit_about, l),
        column("unit", terms::unit, ColumnContent::Text, None, tables::unit_of_check_about, l),
        column("direction", tables::direction, ColumnContent::Text, None, tables::direction_about, l),
        column("utilisation", terms::utilisation, ColumnContent::Share, Some(&ONE), tables::utilisation_about, l),
        column("margin", terms::margin, ColumnContent::Share, Some(&ONE), tables::margin_about, l),
        column("at", tables::at, ColumnContent::Number, Some(&SECOND), tables::worst_at_about, l),
        column("grade", terms::grade, ColumnContent::Text, None, tables::grade_about, l),
        column("source", terms::source, ColumnContent::Text, None, tables::source_about, l),
        column("missing", tables::missing_data, ColumnContent::Text, None, tables::missing_about, l),
        column("notes", terms::remarks, ColumnContent::Text, None, tables::remarks_about, l),
    ];
    let chosen = &subject.chosen.id;
    let mut shown = subject.shown();
    // The chosen candidate comes first: its checks matter most to readers.
    shown.sort_by_key(|(_, candidate)| candidate.id != *chosen);
    let of_each = |(_, candidate): &(Option<usize>, Candidate<'_>)| {
        let name = candidate.id.to_string();
        by_importance(&candidate.judgement.checks)
            .into_iter()
            .map(|check| check_row(&name, check, l))
            .collect::<Vec<_>>()
    };
    let mut rows: Vec<Vec<Cell>> = shown.iter().flat_map(of_each).collect();
    // Identifiers are for programs.
    if let Some(id) = columns.iter().position(|column| column.kind == ColumnContent::Id && format == Format::Workbook) {
        columns.remove(id);
        for row in &mut rows {
            row.remove(id);
        }
    }
    let rows = rows.into_iter().collect();
    let mut table = subject.made("checks", terms::checks, tables::checks_about, columns, rows);
    let of = |name: &str| table.column(name);
    if let (Some(column), Some(value), Some(limit), Some(direction), Some(margin)) =
        (of("utilisation"), of("value"), of("limit"), of("direction"), of("margin"))
    {
        table.derived.push(Derived::Utilisation { column, value, limit, direction });
        table.derived.push(Derived::Margin { column: margin, utilisation: column });
    }
    table
}

fn direction(direction: Direction, l: Language) -> Cell {
    let text = match direction {
        Direction::AtMost => tables::at_most,
        Direction::AtLeast => tables::at_least,
    };
    Cell::Word(direction.id(), text(l).to_owned())
}

fn check_row(code: &str, check: &Check, l: Language) -> Vec<Cell> {
    let figure = |figure: Option<questions::Amount>| figure.map_or(Cell::Empty, |figure| Cell::number(figure.value()));
    let unit = check.value.or(check.limit).map_or(Cell::Empty, |figure| Cell::unit(figure.unit, l));
    let said = |text: String| without_keys(&text, l).into_owned();
    let mut sources: Vec<String> = [&check.limit_source, &check.value_source]
        .into_iter()
        .flatten()
        .map(|source| said(source_text(source, l)))
        .collect();
    sources.dedup();
    let notes: Vec<String> = check.notes.iter().map(|note| said(note_text(note, l))).collect();
    let utilisation = margin_share(check).map_or(Cell::Empty, Cell::number);
    // A recommendation that is not met has a utilisation and no margin.
    let margin = utilisation
        .as_number()
        .filter(|_| check.verdict == Verdict::Fail || check.id.has_margin())
        .map_or(Cell::Empty, |share| Cell::number(1.0 - share));
    vec![
        Cell::text(code),
        Cell::text(check.id.id()),
        Cell::text(title_of_check(check, l)),
        Cell::Word(check.verdict.id(), verdict_text(check, l)),
        figure(check.value),
        figure(check.limit),
        unit,
        direction(check.direction(), l),
        utilisation,
        margin,
        Cell::in_unit(check.at.map(|at| at.si()), &SECOND),
        check.grade.map_or(Cell::Empty, |grade| Cell::Word(grade.id(), grade_word(grade, l).to_owned())),
        Cell::text(sources.join("; ")),
        check.missing.map_or(Cell::Empty, |missing| Cell::Word(missing, said(check_missing(missing, l)))),
        Cell::text(notes.join("; ")),
    ]
}
