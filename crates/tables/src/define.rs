//! The tables: what each shows, and where it takes it from.

use crate::results;
use crate::table::{Cell, Column, Kind, Table};
use crate::words::{Both, column, t};
use workbench::quantities::Measure;
use workbench::quantities::Unit;
use workbench::quantities::unit::{
    AMPERE, DEGREE, DEGREE_CELSIUS, NEWTON_METRE, ONE, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE, SECOND, WATT,
};
use workbench::text::{assumption_text, law_text};
use workbench::{Candidate, Language, Project, Sample, Sizing, course, inputs, moves};

/// The names of the tables, in the order of a workbook.
pub const NAMES: [&str; 7] = ["inputs", "assumptions", "demand", "motion", "candidates", "checks", "course"];

/// What the tables are made from: one axis of a project with its results.
#[derive(Clone, Copy, Debug)]
pub struct Subject<'a> {
    /// Text of the project file.
    pub text: &'a str,
    /// Place of the axis among several of the file.
    pub axis: usize,
    /// The axis.
    pub project: &'a Project,
    /// The catalogue ranked for it.
    pub sizing: &'a Sizing<'a>,
    /// The actuator that the tables are about.
    pub chosen: &'a Candidate<'a>,
    /// How many of the ranking are shown, from the best on; the chosen one and the project's own always are.
    pub top: usize,
    /// Language of the words.
    pub language: Language,
}

impl Subject<'_> {
    /// A table by its name; `None` for a name that is none of [`NAMES`].
    #[must_use]
    pub fn table(&self, name: &str) -> Option<Table> {
        Some(match name {
            "inputs" => self.inputs(),
            "assumptions" => self.assumptions(),
            "demand" => results::demand(self),
            "motion" => self.motion(),
            "candidates" => results::candidates(self),
            "checks" => results::checks(self),
            "course" => self.course(),
            _ => return None,
        })
    }

    /// Every table, in the order of [`NAMES`].
    #[must_use]
    pub fn tables(&self) -> Vec<Table> {
        NAMES.iter().filter_map(|name| self.table(name)).collect()
    }

    /// The candidates that are shown, best first, each judged in full, with its place in the ranking if it fits.
    pub(crate) fn shown(&self) -> Vec<(Option<usize>, Candidate<'_>)> {
        let ranked = self.sizing.candidates.iter().enumerate();
        let mut shown: Vec<(Option<usize>, Candidate<'_>)> = ranked
            .filter(|(index, candidate)| *index < self.top || candidate.id == self.chosen.id)
            .map(|(index, candidate)| {
                let full = match &candidate.id {
                    workbench::CandidateId::Code(code) => workbench::check(self.project, code).ok(),
                    workbench::CandidateId::Own(_) => None,
                };
                (candidate.fits().then_some(index + 1), full.unwrap_or_else(|| candidate.clone()))
            })
            .collect();
        let others = self.sizing.own.iter().chain(std::iter::once(self.chosen));
        for other in others {
            if shown.iter().all(|(_, each)| each.id != other.id) {
                shown.push((None, other.clone()));
            }
        }
        shown
    }

    pub(crate) fn empty(&self, name: &'static str, title: Both, about: Both, columns: Vec<Column>) -> Table {
        let (title, about) = (t(self.language, title).to_owned(), t(self.language, about).to_owned());
        Table { name, title, about, columns, rows: Vec::new(), derived: Vec::new() }
    }

    fn inputs(&self) -> Table {
        let l = self.language;
        let columns = vec![
            column(
                "path",
                ["key", "Schlüssel"],
                Kind::Text,
                None,
                ["key of the project file", "Schlüssel der Projektdatei"],
                l,
            ),
            column(
                "written",
                ["written", "geschrieben"],
                Kind::Text,
                None,
                ["as it stands there", "wie es dort steht"],
                l,
            ),
            column(
                "value",
                ["value", "Wert"],
                Kind::Number,
                None,
                ["the number, in its unit", "die Zahl in ihrer Einheit"],
                l,
            ),
            column(
                "tolerance",
                ["± tolerance", "± Toleranz"],
                Kind::Number,
                None,
                ["half-width of its tolerance, in the same unit", "halbe Breite der Toleranz, in derselben Einheit"],
                l,
            ),
            column(
                "unit",
                ["unit", "Einheit"],
                Kind::Text,
                None,
                ["unit of value and tolerance", "Einheit von Wert und Toleranz"],
                l,
            ),
        ];
        let about = ["every value of the project file", "jeder Wert der Projektdatei"];
        let mut table = self.empty("inputs", ["Inputs", "Eingaben"], about, columns);
        let own = format!("axis[{}].", self.axis + 1);
        table.rows = inputs(self.text)
            .into_iter()
            .filter(|input| !input.path.starts_with("axis[") || input.path.starts_with(&own))
            .map(|input| {
                let (value, unit) = input
                    .amount
                    .map_or((Cell::Empty, Cell::Empty), |(value, unit)| (Cell::number(value), Cell::unit(unit)));
                vec![
                    Cell::text(input.path),
                    Cell::text(input.written),
                    value,
                    input.half_width.map_or(Cell::Empty, Cell::number),
                    unit,
                ]
            })
            .collect();
        table
    }

    fn assumptions(&self) -> Table {
        let l = self.language;
        let columns = vec![
            column("number", ["no.", "Nr."], Kind::Count, None, ["running number", "laufende Nummer"], l),
            column(
                "assumption",
                ["assumption", "Annahme"],
                Kind::Text,
                None,
                ["what nobody stated", "was niemand angegeben hat"],
                l,
            ),
        ];
        let about = ["what was assumed since nobody stated it", "was angenommen ist, weil es niemand angegeben hat"];
        let mut table = self.empty("assumptions", ["Assumptions", "Annahmen"], about, columns);
        table.rows = (1_u16..)
            .zip(&self.project.assumptions)
            .map(|(number, each)| vec![Cell::number(f64::from(number)), Cell::text(assumption_text(*each, l))])
            .collect();
        table
    }

    fn motion(&self) -> Table {
        let l = self.language;
        let moves = moves(self.project);
        let [distance, speed, acceleration] = moves.units;
        let speed_title = if moves.turns { ["speed", "Drehzahl"] } else { ["speed", "Geschwindigkeit"] };
        let where_at =
            if moves.turns { ["at the output", "am Abtrieb"] } else { ["along the line", "entlang der Linie"] };
        let number =
            |name: &str, title: Both, unit: &'static Unit| column(name, title, Kind::Number, Some(unit), where_at, l);
        let columns = vec![
            column(
                "segment",
                ["segment", "Abschnitt"],
                Kind::Count,
                None,
                ["number of the segment", "Nummer des Abschnitts"],
                l,
            ),
            column(
                "law",
                ["law", "Gesetz"],
                Kind::Text,
                None,
                ["law of motion, or rest", "Bewegungsgesetz, oder Rast"],
                l,
            ),
            column(
                "start",
                ["from", "ab"],
                Kind::Number,
                Some(&SECOND),
                ["instant of its beginning", "Zeitpunkt des Beginns"],
                l,
            ),
            column("duration", ["time", "Zeit"], Kind::Number, Some(&SECOND), ["duration", "Dauer"], l),
            number("distance", ["distance", "Weg"], distance),
            number("speed", speed_title, speed),
            number("acceleration", ["acceleration", "Beschleunigung"], acceleration),
            column(
                "recording",
                ["recording", "Aufzeichnung"],
                Kind::Text,
                None,
                ["file of the recording", "Datei der Aufzeichnung"],
                l,
            ),
        ];
        let about = [
            "the segments of the motion, what was given and what followed: distance, largest speed and acceleration",
            "die Abschnitte der Bewegung, was gegeben ist und was folgt: Weg, größte Drehzahl und Beschleunigung",
        ];
        let mut table = self.empty("motion", ["Motion", "Bewegung"], about, columns);
        table.rows = (1_u32..)
            .zip(&moves.moves)
            .map(|(number, each)| {
                let course = each.course.map_or([None; 3], |course| course.map(Some));
                let [s, v, a] = course;
                vec![
                    Cell::number(f64::from(number)),
                    Cell::text(law_text(each.law, l)),
                    Cell::in_unit(Some(each.start.si()), &SECOND),
                    Cell::in_unit(Some(each.duration.si()), &SECOND),
                    Cell::in_unit(s, distance),
                    Cell::in_unit(v, speed),
                    Cell::in_unit(a, acceleration),
                    each.recording.map_or(Cell::Empty, |read| Cell::text(read.file.as_str())),
                ]
            })
            .collect();
        table
    }

    fn course(&self) -> Table {
        let l = self.language;
        type Of = fn(&Sample) -> Option<f64>;
        let series: [(&str, Both, &'static Unit, Both, Of); 10] = [
            (
                "time",
                ["time", "Zeit"],
                &SECOND,
                ["instant; twice where something jumps", "Zeitpunkt; doppelt, wo etwas springt"],
                |s| Some(s.time_s),
            ),
            ("position", ["angle", "Winkel"], &DEGREE, ["of the output", "des Abtriebs"], |s| Some(s.position_rad)),
            ("speed", ["speed", "Drehzahl"], &REVOLUTION_PER_MINUTE, ["of the output", "des Abtriebs"], |s| {
                Some(s.speed_rad_s)
            }),
            (
                "acceleration",
                ["acceleration", "Beschleunigung"],
                &RADIAN_PER_SECOND_SQUARED,
                ["of the output", "des Abtriebs"],
                |s| Some(s.acceleration_rad_s2),
            ),
            (
                "torque",
                ["torque", "Drehmoment"],
                &NEWTON_METRE,
                [
                    "of the actuator at the output, its own inertia included",
                    "des Antriebs am Abtrieb, mit der eigenen Trägheit",
                ],
                |s| Some(s.torque_nm),
            ),
            (
                "current",
                ["motor current", "Motorstrom"],
                &AMPERE,
                ["rms, signed like the torque", "effektiv, mit dem Vorzeichen des Drehmoments"],
                |s| s.current_a,
            ),
            (
                "power",
                ["power", "Leistung"],
                &WATT,
                ["electrical, at the motor terminals", "elektrisch, an den Motorklemmen"],
                |s| s.power_w,
            ),
            (
                "winding",
                ["winding", "Wicklung"],
                &DEGREE_CELSIUS,
                [
                    "temperature in the steady cycle; estimated, model thermal",
                    "Temperatur im eingeschwungenen Zyklus; geschätzt, Modell Erwärmung",
                ],
                |s| s.winding_k,
            ),
            (
                "housing",
                ["housing", "Gehäuse"],
                &DEGREE_CELSIUS,
                [
                    "temperature in the steady cycle; estimated, model thermal",
                    "Temperatur im eingeschwungenen Zyklus; geschätzt, Modell Erwärmung",
                ],
                |s| s.housing_k,
            ),
            (
                "overload",
                ["I²t", "I²t"],
                &ONE,
                [
                    "filtered square of the current over that of I_0, 1 is the limit; model overload",
                    "gefiltertes Quadrat des Stroms über dem von I_0, 1 ist die Grenze; Modell Überlast",
                ],
                |s| s.overload,
            ),
        ];
        let columns = series
            .iter()
            .map(|(name, title, unit, about, _)| column(name, *title, Kind::Number, Some(unit), *about, l))
            .collect();
        let about =
            ["the cycle of the chosen actuator as time series", "der Zyklus des gewählten Antriebs als Zeitreihe"];
        let mut table = self.empty("course", ["Course", "Verlauf"], about, columns);
        table.rows = course(self.project, self.chosen)
            .samples
            .iter()
            .map(|sample| series.iter().map(|(_, _, unit, _, of)| Cell::in_unit(of(sample), unit)).collect())
            .collect();
        // Neighbours that say the same say it once.
        table.rows.dedup();
        table
    }
}
