//! Results of the motion, and the demand on the actuator.

use super::ends::Ends;
use super::shown::Formatter;
use answers::{DemandFigures, DemandMode, Dossier, Motion, MoveTorques, Number, Segment, TextEncoding, UnitBy};
use quantities::Language;
use serde::Serialize;
use std::f64::consts::TAU;
use words::terminal;

#[derive(Serialize)]
pub(super) struct MotionTable {
    units: [String; 4],
    segments: Ends<MotionRow>,
    /// Keys and units of the loads that at least one segment states.
    loads: Vec<[String; 2]>,
    recordings: Ends<Recorded>,
}

#[derive(Serialize)]
struct MotionRow {
    number: usize,
    law: &'static str,
    start: String,
    duration: String,
    distance: String,
    speed: String,
    acceleration: String,
    /// Loads as they act.
    loads: Vec<String>,
}

#[derive(Serialize)]
struct Recorded {
    file: String,
    samples: String,
    columns: String,
    /// Assumption about the text, and rows that are not used.
    remarks: Vec<String>,
}

/// Returns the assumed encoding of a recording, and the numbers of its lines that are no samples.
fn remarks(read: &answers::Recording, language: Language) -> Vec<String> {
    let encoding = match read.encoding {
        Some(TextEncoding::Utf16Guessed) => Some("UTF-16"),
        Some(TextEncoding::Windows1252Guessed) => Some("Windows-1252"),
        Some(TextEncoding::Utf8 | TextEncoding::Utf16) | None => None,
    };
    let left = read.left_out_before + read.left_out_after;
    let of_window = (left > 0).then(|| terminal::outside_the_window(&left, language));
    let comments = (read.comments > 0).then(|| terminal::comments_passed_over(&read.comments, language));
    let encoding = encoding.map(|name| terminal::text_read_as(&name, language));
    of_window.into_iter().chain(comments).chain(encoding).collect()
}

impl MotionTable {
    pub(super) fn build(motion: &Motion, shown: &Formatter) -> Self {
        let number = |value: Option<Number>| value.map(|value| shown.number(value)).unwrap_or_default();
        type Load = fn(&Segment) -> Option<Number>;
        let all: [(&str, Load); 4] = [
            ("payload", |it| it.payload),
            ("payload_inertia", |it| it.payload_inertia),
            ("process_force", |it| it.process_force),
            ("external_torque", |it| it.external_torque),
        ];
        let stated = |(_, pick): &(&str, Load)| motion.segments.iter().any(|segment| pick(segment).is_some());
        let loads: Vec<(&str, Load)> = all.into_iter().filter(stated).collect();
        let rows = motion.segments.iter().enumerate().map(|(index, segment)| MotionRow {
            number: index + 1,
            law: segment.name,
            start: shown.number(segment.start),
            duration: shown.number(segment.duration),
            distance: number(segment.distance),
            speed: number(segment.speed),
            acceleration: number(segment.acceleration),
            loads: loads.iter().map(|(_, pick)| number(pick(segment))).collect(),
        });
        let recordings = motion.segments.iter().filter_map(|segment| segment.recording.as_ref()).map(|each| {
            let columns = each.columns.iter().map(|column| match column.unit_by {
                // The heading of the column then contains the unit.
                UnitBy::Header => column.name.clone(),
                _ => format!("{} ({})", column.name, shown.unit(column.unit)),
            });
            Recorded {
                file: each.file.clone(),
                samples: each.samples.to_string(),
                columns: columns.collect::<Vec<_>>().join(", "),
                remarks: remarks(each, shown.0),
            }
        });
        let unit = |of| motion.units.unit(of).map(|unit| shown.unit(unit)).unwrap_or_default();
        Self {
            units: ["time", "distance", "speed", "acceleration"].map(unit),
            segments: Ends::of(rows, None),
            loads: loads.iter().map(|(key, _)| [(*key).to_owned(), unit(key)]).collect(),
            recordings: Ends::of(recordings.collect::<Vec<_>>().into_iter(), None),
        }
    }
}

#[derive(Serialize)]
pub(super) struct DemandTable {
    by_manual: bool,
    rows: Vec<DemandRow>,
    /// `true` if the integrals are shown beside the figures of the manual.
    both: bool,
    /// `true` if there is a line of motion to which the figures are converted.
    line: bool,
    moves: Ends<Move>,
}

/// A move of the manual's cycle with its torques.
#[derive(Serialize)]
struct Move {
    number: usize,
    torques: [String; 3],
    governing: bool,
}

/// A figure of the demand.
#[derive(Serialize)]
struct DemandRow {
    symbol: &'static str,
    unit: &'static str,
    value: String,
    integral: String,
    /// The value along the line of the mechanism, without its losses.
    line: String,
}

impl DemandTable {
    pub(super) fn build(dossier: &Dossier, shown: &Formatter) -> Self {
        let travel = dossier.mechanism.travel_mm_per_rev.map(|travel| travel.0);
        let Some(demand) = &dossier.judgement.candidate.demand else {
            return Self { by_manual: false, rows: Vec::new(), both: false, line: false, moves: Ends::default() };
        };
        let by_manual = match demand.mode {
            DemandMode::Manual => true,
            DemandMode::Integral => false,
        };
        let exact = demand.integral.as_ref().map(|it| it.figures);
        let of = |pick: fn(&DemandFigures) -> Number| (pick(&demand.figures), exact.as_ref().map(pick));
        let figures = [
            ("T_rms", "Nm", of(|it| it.torque_rms)),
            ("T_peak", "Nm", of(|it| it.torque_peak)),
            ("n_av", "min⁻¹", of(|it| it.speed_mean)),
            ("n_peak", "min⁻¹", of(|it| it.speed_peak)),
            ("ED", "%", of(|it| it.duty_factor)),
        ];
        let torques = demand.torques.iter().flat_map(|torques| {
            let [first, second, third] = values(torques);
            [("T_1", "Nm", (first, None)), ("T_2", "Nm", (second, None)), ("T_3", "Nm", (third, None))]
        });
        let row =
            |(symbol, unit, (value, integral)): (&'static str, &'static str, (Number, Option<Number>))| DemandRow {
                symbol,
                unit,
                value: shown.number(value),
                integral: integral.map(|value| shown.number(value)).unwrap_or_default(),
                line: travel.map(|travel| along(value, unit, travel, shown)).unwrap_or_default(),
            };
        let moves = demand.moves.iter().enumerate().map(|(place, each)| Move {
            number: place + 1,
            torques: values(each).map(|value| shown.number(value)),
            governing: demand.governing_move == Some(place + 1),
        });
        Self {
            by_manual,
            rows: figures.into_iter().chain(torques).map(row).collect(),
            both: exact.is_some(),
            line: travel.is_some(),
            moves: Ends::of(moves, demand.governing_move.and_then(|number| number.checked_sub(1))),
        }
    }
}

const fn values(torques: &MoveTorques) -> [Number; 3] {
    [torques.accelerate, torques.run, torques.brake]
}

/// Converts a torque to a force and a speed to the speed along a line with this travel per turn; empty for other units.
fn along(value: Number, unit: &str, travel_mm_per_rev: f64, shown: &Formatter) -> String {
    match unit {
        "Nm" => shown.figure(Number(value.0 * TAU / (travel_mm_per_rev * 1e-3)), "N"),
        "min⁻¹" => shown.figure(Number(value.0 * travel_mm_per_rev / 60.0), "mm/s"),
        _ => String::new(),
    }
}
