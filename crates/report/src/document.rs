//! The document as the template reads it: every number already in the words of its language, every list in its order.

mod alternatives;
mod checks;
mod inputs;
mod origins;
mod shown;

use crate::data::{Connection, Data, Demand, Erratum, Item, Judged, Motion, Recording, Screws};
use crate::{Content, Fault, Settings};
use alternatives::Alternatives;
use checks::Checks;
use inputs::{Group, Mechanism};
use origins::{Derived, Source};
use quantities::Language;
use serde::Serialize;
use shown::Shown;

/// Everything the template places.
#[derive(Serialize)]
pub(crate) struct Document {
    lang: &'static str,
    cover: Cover,
    inputs: Vec<Group>,
    assumptions: Vec<String>,
    mechanism: Mechanism,
    motion: MotionTable,
    demand: DemandTable,
    checks: Checks,
    derivations: Vec<Derived>,
    alternatives: Alternatives,
    bill_of_material: Vec<Item>,
    wiring: Vec<Connection>,
    screws: Vec<Screws>,
    sources: Vec<Source>,
    errata: Vec<Erratum>,
    figures: Vec<Placed>,
}

#[derive(Serialize)]
struct Cover {
    axis: String,
    code: String,
    own: bool,
    /// `fits`, `open` (fits, but questions are open), `does_not_fit`, `none` (nothing in the catalogue fits).
    verdict: &'static str,
    fails: usize,
    advised: usize,
    open: usize,
    shown: usize,
    passed: usize,
    utilisation: String,
    tightest: String,
    mass: String,
    cycle: String,
    on_request: Vec<String>,
    objections: Vec<String>,
    date: Option<Date>,
    date_text: String,
    revision: String,
    project: String,
    number: String,
    author: String,
    company: String,
    hash_project: String,
    hash_catalogue: String,
    reserve: Vec<Reserved>,
}

#[derive(Serialize)]
struct Date {
    year: u16,
    month: u8,
    day: u8,
}

/// How far one thing may be changed; `id` is that of the JSON.
#[derive(Serialize)]
struct Reserved {
    id: &'static str,
    /// The key of a limit of the project; empty elsewhere.
    key: String,
    value: String,
}

#[derive(Serialize)]
struct MotionTable {
    units: [String; 4],
    rows: Vec<MotionRow>,
    recordings: Vec<Recorded>,
}

#[derive(Serialize)]
struct MotionRow {
    number: usize,
    law: String,
    start: String,
    duration: String,
    distance: String,
    speed: String,
    acceleration: String,
}

#[derive(Serialize)]
struct Recorded {
    file: String,
    samples: String,
    columns: String,
    note: String,
}

/// Symbol, value of the governing figures, value of the integrals.
#[derive(Serialize)]
struct DemandRow {
    symbol: &'static str,
    unit: &'static str,
    value: String,
    integral: String,
}

#[derive(Serialize)]
struct DemandTable {
    mode: String,
    rows: Vec<DemandRow>,
    both: bool,
    moves: Vec<[String; 3]>,
    governing: Option<usize>,
}

#[derive(Serialize)]
struct Placed {
    place: String,
    file: String,
    caption: String,
    alternative: String,
}

/// The name under which the template finds a figure.
pub(crate) fn figure_file(index: usize) -> String {
    format!("figure-{index}.svg")
}

impl Document {
    pub(crate) fn build(content: &Content, settings: &Settings) -> Result<Self, Fault> {
        let data = Data::read(&content.data)?;
        let shown = Shown(content.language);
        let judged = data.check.unwrap_or_default();
        let sizing = data.sizing.unwrap_or_default();
        let checks = Checks::build(&judged, &shown);
        let titles = checks::Titles::collect(&judged, &sizing);
        let motion = if judged.motion.segments.is_empty() { &sizing.motion } else { &judged.motion };
        let motion = motion_table(motion, &data.inputs, &data.recordings, &shown);
        let derivations = origins::derived(&data.derivations, &shown);
        let sources = origins::sources(&judged, &data.derivations, &data.sources, &titles);
        let assumptions = [data.assumptions, judged.assumptions.clone(), sizing.assumptions.clone()]
            .into_iter()
            .find(|texts| !texts.is_empty())
            .unwrap_or_default();
        let axis = if judged.axis.is_empty() { &sizing.axis } else { &judged.axis };
        let cover = cover(&judged, axis, &checks, &titles, settings, &shown)?;
        let cover = Cover { hash_project: data.hash.project, hash_catalogue: data.hash.catalogue, ..cover };
        Ok(Self {
            lang: if content.language == Language::De { "de" } else { "en" },
            cover,
            mechanism: inputs::mechanism(&data.inputs, &shown),
            inputs: inputs::groups(&data.inputs, &shown),
            assumptions,
            motion,
            demand: demand_table(judged.demand.as_ref(), &shown),
            checks,
            derivations,
            alternatives: Alternatives::build(&sizing, &judged, &titles, &shown),
            bill_of_material: data.bill_of_material,
            wiring: data.wiring,
            screws: data.screws,
            sources,
            errata: origins::errata(&judged, &data.derivations, data.errata, &titles),
            figures: placed(content),
        })
    }
}

/// The chapter of a figure; the ids of `figures` are known.
fn place(name: &str) -> String {
    let place = name.split([':', '/']).next().unwrap_or_default().trim().replace('-', "_");
    match place.as_str() {
        "cycle" => "motion".to_owned(),
        "utilisation" => "checks".to_owned(),
        "torsion" => "gear".to_owned(),
        "bearing_load" => "output_bearing".to_owned(),
        "candidate_map" => "alternatives".to_owned(),
        _ => place,
    }
}

fn placed(content: &Content) -> Vec<Placed> {
    content
        .figures
        .iter()
        .enumerate()
        .map(|(index, figure)| Placed {
            place: place(&figure.name),
            file: figure_file(index),
            caption: figure.caption.clone(),
            // A file to be kept must have one.
            alternative: [&figure.alternative_text, &figure.caption, &figure.name]
                .into_iter()
                .find(|text| !text.trim().is_empty())
                .map_or_else(|| "–".to_owned(), Clone::clone),
        })
        .collect()
}

fn cover(
    judged: &Judged,
    axis: &str,
    checks: &Checks,
    titles: &checks::Titles,
    settings: &Settings,
    shown: &Shown,
) -> Result<Cover, Fault> {
    let own = judged.code.is_empty() && !judged.name.is_empty();
    let counts = checks.counts();
    let verdict = match judged.verdict.as_str() {
        "fits" if counts.open > 0 => "open",
        "fits" => "fits",
        "" => "none",
        _ => "does_not_fit",
    };
    let reserve = judged.reserve.as_ref();
    let reserve = [
        ("load_factor", reserve.and_then(|it| it.load_factor), "1"),
        ("payload_factor", reserve.and_then(|it| it.payload_factor), "1"),
        ("cycle_time", reserve.and_then(|it| it.cycle_time), "s"),
        ("ambient", reserve.and_then(|it| it.ambient), "degC"),
    ]
    .into_iter()
    .filter_map(|(id, value, unit)| Some(Reserved { id, key: String::new(), value: shown.figure(value?, unit) }));
    let limits = judged.reserve.iter().filter_map(|it| it.limits.as_ref()).flatten().map(|limit| Reserved {
        id: "limits",
        key: limit.key.clone(),
        value: shown.figure(limit.value, &limit.unit),
    });
    let reserve = reserve.chain(limits).collect();
    let cycle: f64 = judged.motion.segments.iter().filter_map(|segment| segment.duration).sum();
    let date = settings.date.as_deref().map(read_date).transpose()?;
    Ok(Cover {
        axis: axis.to_owned(),
        code: if own { judged.name.clone() } else { judged.code.clone() },
        own,
        verdict,
        fails: counts.failed,
        advised: counts.advised,
        open: counts.open,
        shown: counts.shown,
        passed: counts.passed,
        utilisation: judged.utilisation.map(|share| shown.percent(share)).unwrap_or_default(),
        tightest: checks::capital(&titles.of(&judged.tightest)),
        mass: judged.mass_kg.map(|mass| shown.figure(mass, "kg")).unwrap_or_default(),
        cycle: if cycle > 0.0 { shown.figure(cycle, "s") } else { String::new() },
        on_request: judged.on_request.clone(),
        objections: judged.objections.clone(),
        date_text: date.as_ref().map(|date| shown.date(date.year, date.month, date.day)).unwrap_or_default(),
        date,
        revision: settings.revision.clone(),
        project: settings.project.clone(),
        number: settings.number.clone(),
        author: settings.author.clone(),
        company: settings.company.clone(),
        hash_project: String::new(),
        hash_catalogue: String::new(),
        reserve,
    })
}

/// A date of the calendar, year, month, day.
fn read_date(text: &str) -> Result<Date, Fault> {
    let fault = || Fault::Date { text: text.to_owned() };
    let mut parts = text.trim().splitn(3, '-');
    let mut next = |digits: usize| {
        parts.next().filter(|part| part.len() == digits && part.bytes().all(|byte| byte.is_ascii_digit()))
    };
    let (Some(year), Some(month), Some(day)) = (next(4), next(2), next(2)) else { return Err(fault()) };
    let year: u16 = year.parse().map_err(|_| fault())?;
    let month: u8 = month.parse().map_err(|_| fault())?;
    let day: u8 = day.parse().map_err(|_| fault())?;
    let leap = year.is_multiple_of(4) && (!year.is_multiple_of(100) || year.is_multiple_of(400));
    let last = match month {
        2 => 28 + u8::from(leap),
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return Err(fault()),
    };
    if day == 0 || day > last {
        return Err(fault());
    }
    Ok(Date { year, month, day })
}

fn motion_table(
    motion: &Motion,
    inputs: &[crate::project::Input],
    recordings: &[Recording],
    shown: &Shown,
) -> MotionTable {
    let number = |value: Option<f64>| value.map(|value| shown.number(value)).unwrap_or_default();
    let law = |index: usize| {
        let key = format!("motion[{}].law", index + 1);
        inputs.iter().find(|input| input.key == key).map(|input| input.text.clone()).unwrap_or_default()
    };
    let rows = motion
        .segments
        .iter()
        .enumerate()
        .map(|(index, segment)| MotionRow {
            number: index + 1,
            law: if segment.name.is_empty() { law(index) } else { segment.name.clone() },
            start: number(segment.start),
            duration: number(segment.duration),
            distance: number(segment.distance),
            speed: number(segment.speed),
            acceleration: number(segment.acceleration),
        })
        .collect();
    let units = [&motion.units.time, &motion.units.distance, &motion.units.speed, &motion.units.acceleration];
    let recordings = recordings
        .iter()
        .chain(
            motion.segments.iter().filter_map(|segment| segment.recording.as_ref()).filter(|_| recordings.is_empty()),
        )
        .map(|each| Recorded {
            file: each.file.clone(),
            samples: each.samples.map(|count| count.to_string()).unwrap_or_default(),
            columns: each.columns.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", "),
            note: each.note.clone(),
        })
        .collect();
    MotionTable { units: units.map(|unit| shown.unit(unit)), rows, recordings }
}

fn demand_table(demand: Option<&Demand>, shown: &Shown) -> DemandTable {
    let Some(demand) = demand else {
        return DemandTable { mode: String::new(), rows: Vec::new(), both: false, moves: Vec::new(), governing: None };
    };
    let exact = demand.integral.as_deref();
    let number = |value: Option<f64>| value.map(|value| shown.number(value)).unwrap_or_default();
    let row = |symbol, unit, value: Option<f64>, integral: Option<f64>| DemandRow {
        symbol,
        unit,
        value: number(value),
        integral: number(integral),
    };
    let of = |pick: fn(&Demand) -> Option<f64>| (pick(demand), exact.and_then(pick));
    let rows = [
        ("T_rms", "Nm", of(|it| it.T_rms)),
        ("T_peak", "Nm", of(|it| it.T_peak)),
        ("n_av", "min⁻¹", of(|it| it.n_av)),
        ("n_peak", "min⁻¹", of(|it| it.n_peak)),
        ("ED", "%", of(|it| it.ED)),
        ("T_1", "Nm", of(|it| it.T_1)),
        ("T_2", "Nm", of(|it| it.T_2)),
        ("T_3", "Nm", of(|it| it.T_3)),
    ]
    .into_iter()
    .filter(|(_, _, (value, integral))| value.is_some() || integral.is_some())
    .map(|(symbol, unit, (value, integral))| row(symbol, unit, value, integral))
    .collect();
    DemandTable {
        mode: demand.mode.clone(),
        rows,
        both: exact.is_some(),
        moves: demand.moves.iter().map(|each| [each.T_1, each.T_2, each.T_3].map(number)).collect(),
        governing: demand.governing_move,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_date_is_one_of_the_calendar() {
        for text in ["2026-11-21", "2024-02-29", "2000-02-29"] {
            assert!(read_date(text).is_ok(), "{text}");
        }
        for text in ["", "21.11.2026", "2026-13-01", "2026-02-29", "1900-02-29", "2026-04-31", "2026-1-1", "2026-11-+1"]
        {
            assert!(read_date(text).is_err(), "{text}");
        }
    }
}
