//! Words for results: checks, requirements, sources.

use crate::derivation::symbol_shown;
use crate::texts::said;
use crate::{document_short, pick, terminal, terms, typeset};
use actuator::CurveKind;
use provenance::{CellRef, Grade, MANUAL, Source};
use quantities::unit::MINUTE;
use quantities::{Language, Measure, Time, Unit, format_number, format_significant, with_symbol};
use sizing::{Check, CheckId, Fit, Part, Verdict};

/// Returns the title of a part of the actuator above its checks.
#[must_use]
pub const fn part_title(part: Part, language: Language) -> &'static str {
    let (en, de) = match part {
        Part::Drive => ("Drive", "Antrieb"),
        Part::Thermal => ("Temperature rise", "Erwärmung"),
        Part::Energy => ("Energy", "Energie"),
        Part::Gear => ("Gear", "Getriebe"),
        Part::OutputBearing => ("Output bearing", "Abtriebslager"),
        Part::Brake => ("Brake", "Bremse"),
        Part::Feedback => ("Encoder", "Geber"),
        Part::Screws => ("Bolted joints", "Schraubenverbindungen"),
        Part::Environment => ("Place of installation", "Aufstellort"),
    };
    pick(language, en, de)
}

/// Returns the title of a check that was made.
#[must_use]
pub fn title_of_check(check: &Check, language: Language) -> String {
    check_title(check.id, language)
}

/// Returns the title of a check.
#[must_use]
pub fn check_title(id: CheckId, language: Language) -> String {
    let (en, de) = match id {
        CheckId::PeakTorque => ("peak torque", "Spitzendrehmoment"),
        CheckId::PeakSpeed => ("peak speed", "Spitzendrehzahl"),
        CheckId::MeanSpeed => ("mean speed", "mittlere Drehzahl"),
        CheckId::ContinuousTorque => ("continuous torque", "Dauerdrehmoment"),
        CheckId::PeakCurrent => ("peak current", "Spitzenstrom"),
        CheckId::Demagnetisation => ("demagnetisation", "Entmagnetisierung"),
        CheckId::DriveCurrent => ("drive, continuous current", "Servoregler, Dauerstrom"),
        CheckId::DriveCurrentPeak => ("drive, peak current", "Servoregler, Spitzenstrom"),
        CheckId::DrivePeakTime => {
            ("drive, time above the continuous current", "Servoregler, Dauer über dem Dauerstrom")
        }
        CheckId::Voltage => ("terminal voltage", "Klemmenspannung"),
        CheckId::InertiaRatio => ("inertia ratio", "Trägheitsverhältnis"),
        CheckId::RopeTension => ("rope, unloading", "Seil, Entlastung"),
        CheckId::GearMeanTorque => ("mean gear torque", "mittleres Getriebemoment"),
        CheckId::GearLife => ("gear life", "Getriebelebensdauer"),
        CheckId::Torsion => ("torsion", "Torsionswinkel"),
        CheckId::NaturalFrequency => ("natural frequency", "Eigenfrequenz"),
        CheckId::BearingAxial => ("bearing, axial load", "Lager, Axiallast"),
        CheckId::BearingRadial => ("bearing, radial load", "Lager, Radiallast"),
        CheckId::BearingTiltingMoment => ("bearing, tilting moment", "Lager, Kippmoment"),
        CheckId::BearingStaticMoment => {
            ("bearing, static equivalent tilting moment", "Lager, statisch äquivalentes Kippmoment")
        }
        CheckId::BearingLife => ("bearing life", "Lagerlebensdauer"),
        CheckId::BearingStatic => ("bearing, static safety", "Lager, statische Sicherheit"),
        CheckId::TiltAngle => ("tilt angle", "Kippwinkel"),
        CheckId::Ambient => ("ambient temperature", "Umgebungstemperatur"),
        CheckId::Altitude => ("installation altitude", "Aufstellhöhe"),
        CheckId::Protection => ("degree of protection", "Schutzart"),
        CheckId::Humidity => ("highest relative humidity", "höchste relative Luftfeuchte"),
        CheckId::HumidityMin => ("lowest relative humidity", "niedrigste relative Luftfeuchte"),
        CheckId::Vibration => ("vibration", "Vibration"),
        CheckId::Shock => ("shock", "Schock"),
        CheckId::Mounting => ("mounting position", "Einbaulage"),
        CheckId::TorqueSpeedTrace => ("torque-speed trace", "Drehmoment-Drehzahl-Verlauf"),
        CheckId::Thermal => ("winding temperature", "Wicklungstemperatur"),
        CheckId::OverloadI2t => ("overload I²t", "Überlast I²t"),
        CheckId::GearMeanInputSpeed => ("mean input speed", "mittlere Eingangsdrehzahl"),
        CheckId::CollisionTorque => ("collision torque", "Kollisionsdrehmoment"),
        CheckId::CollisionNumber => ("number of collisions", "Anzahl der Kollisionen"),
        CheckId::ResonanceSpeed => ("resonance speed", "Resonanzdrehzahl"),
        CheckId::ErrorBudget => ("error budget", "Fehlersumme"),
        CheckId::Deviation => ("deviation from errors", "Abweichung durch Fehler"),
        CheckId::BrakeHolding => ("brake, holding torque", "Haltemoment der Bremse"),
        CheckId::BrakeApplications => ("brake, number of applications", "Anzahl der Bremsungen"),
        CheckId::BrakeEmergency => ("brake, emergency stop", "Not-Halt durch die Bremse"),
        CheckId::BrakeStops => ("brake, number of emergency stops", "Anzahl der Not-Halte durch die Bremse"),
        CheckId::DcLink => ("DC link", "Zwischenkreis"),
        CheckId::Regeneration => ("regeneration", "Rückspeisung"),
        CheckId::FeedbackRange => ("absolute range", "Absolutbereich des Gebers"),
        CheckId::FeedbackResolution => ("encoder resolution", "Auflösung des Gebers"),
        CheckId::Battery => ("encoder battery", "Geberbatterie"),
        CheckId::ScrewJointLoad => ("bolted joint, load", "Schraubenverbindung, Last"),
        CheckId::ScrewJointHousing => ("bolted joint, housing", "Schraubenverbindung, Gehäuse"),
        CheckId::Application => ("field of application", "Anwendungsbereich"),
    };
    pick(language, en, de).to_owned()
}

/// Formats the cycle of the curves of intermittent duty in minutes.
#[must_use]
pub fn minutes(cycle: Time, language: Language) -> String {
    let minutes = cycle.in_unit(&MINUTE);
    format_number(minutes, usize::from(minutes.fract() != 0.0), language)
}

/// Returns the title of a curve of the torque-speed plane.
#[must_use]
pub fn curve_title(kind: &CurveKind, language: Language) -> String {
    match kind {
        CurveKind::Continuous => said!(language => "continuous duty" | "Dauerbetrieb"),
        CurveKind::S3 { duty, cycle } => {
            let share = format_number(duty.si() * 100.0, 0, language);
            let cycle = minutes(*cycle, language);
            said!(language =>
                "intermittent duty S3, {share} %, cycle {cycle} min"
                | "Aussetzbetrieb S3, {share} %, Spieldauer {cycle} min"
            )
        }
        CurveKind::ShortTime => {
            said!(language => "short-time duty: acceleration and braking" | "Kurzzeitbetrieb: Beschleunigen und Bremsen")
        }
    }
}

/// Returns a verdict in one word, which accompanies every colour.
#[must_use]
pub fn verdict_word(verdict: Verdict, language: Language) -> String {
    let (en, de) = match verdict {
        Verdict::Pass => ("pass", "erfüllt"),
        Verdict::Fail => ("fail", "nicht erfüllt"),
        Verdict::Advice => ("note", "Hinweis"),
        Verdict::NotChecked => ("not checked", "nicht geprüft"),
    };
    pick(language, en, de).to_owned()
}

/// Returns the number of checks with a verdict, as text.
#[must_use]
pub fn verdict_count(verdict: Verdict, count: usize, language: Language) -> String {
    match (verdict, language) {
        (Verdict::Advice, _) if count != 1 => format!("{count} {}", pick(language, "notes", "Hinweise")),
        _ => format!("{count} {}", verdict_word(verdict, language)),
    }
}

/// Numbers of the checks of a candidate by result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Checks passed.
    pub passed: usize,
    /// Checks passed with an advice.
    pub advised: usize,
    /// Checks failed.
    pub failed: usize,
    /// Checks not made: a datum is missing.
    pub not_checked: usize,
    /// Checks only shown: the project states no limit.
    pub without_limit: usize,
    /// Checks made that can reject the actuator: all of those made but the recommendations.
    pub deciding: usize,
    /// Requirements of the project for which a datum is missing.
    pub requirements_open: usize,
    /// Requirements of the project that are not met, and violated rules of the series.
    pub requirements_not_met: usize,
}

impl Counts {
    /// Returns the number of all checks.
    #[must_use]
    pub const fn checks(&self) -> usize {
        self.passed + self.advised + self.failed + self.not_checked + self.without_limit
    }

    /// Returns `true` if no check that can reject the actuator could be made: each lacks a datum.
    #[must_use]
    pub const fn are_all_open(&self) -> bool {
        self.deciding == 0
    }
}

/// Checks beyond their limits that do not reject an actuator, each list as text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Provisos {
    /// Checks within the band of an estimate.
    pub estimates: String,
    /// Checks beyond a rating of another manufacturer's gear.
    pub ratings: String,
}

/// Returns the conditions under which a value fits: that an estimate holds, that a gear rating of another manufacturer does
/// not apply, or both; `None` without conditions.
#[must_use]
pub fn proviso_text(estimate: bool, rating: bool, language: Language) -> Option<&'static str> {
    match (estimate, rating) {
        (false, false) => None,
        (true, false) => Some(terminal::if_the_estimate_holds(language)),
        (false, true) => Some(terminal::unless_the_rating_applies(language)),
        (true, true) => Some(terminal::if_the_estimate_holds_and_no_rating_applies(language)),
    }
}

/// Returns the conditions under which several candidates fit, each under one or both: that an estimate holds, that a
/// gear rating of another manufacturer does not apply. Of candidates whose conditions are not known both are named.
#[must_use]
pub fn conditions_text(estimate: bool, rating: bool, language: Language) -> &'static str {
    match (estimate, rating) {
        (true, false) => terminal::if_an_estimate_holds(language),
        (false, true) => terminal::unless_the_rating_applies(language),
        (true, true) | (false, false) => terminal::if_an_estimate_holds_or_no_rating_applies(language),
    }
}

/// Returns the word for the advice of checks, with the basis of those beyond an estimate or a gear rating of another
/// manufacturer.
#[must_use]
pub fn advice_word(estimate: bool, rating: bool, language: Language) -> String {
    let word = verdict_word(Verdict::Advice, language);
    match (estimate, rating) {
        (false, false) => word,
        (true, false) => said!(language => "{word} (estimate)" | "{word} (Schätzung)"),
        (false, true) => said!(language =>
            "{word} (gear rating of another manufacturer)" | "{word} (Getriebegrenze eines anderen Herstellers)"
        ),
        (true, true) => said!(language =>
            "{word} (estimate, gear rating of another manufacturer)"
            | "{word} (Schätzung, Getriebegrenze eines anderen Herstellers)"
        ),
    }
}

/// Returns the result of a candidate: fit or not, the missing data, and a load that is not held without power. Only
/// this function words it.
#[must_use]
pub fn standing_text(fit: Fit, provisos: &Provisos, unheld: bool, counts: &Counts, language: Language) -> String {
    let (all, missing) = (counts.checks(), counts.not_checked);
    let mut text = match (fit, counts.failed) {
        (Fit::Fits, _) if counts.are_all_open() => terms::not_evaluated(language).to_owned(),
        (Fit::Fits, _) => terms::fits(language).to_owned(),
        (Fit::FitsIfEstimate, _) => {
            let Provisos { estimates, ratings } = provisos;
            let (estimate, rating) = (terms::fits_if_estimate(language), terms::fits_unless_rating(language));
            match (estimates.is_empty(), ratings.is_empty()) {
                (true, false) => format!("{rating}: {ratings}"),
                (_, true) => format!("{estimate}: {estimates}"),
                (false, false) => {
                    let unless = terminal::unless_the_rating_applies(language);
                    format!("{estimate}: {estimates}; {unless}: {ratings}")
                }
            }
        }
        (Fit::DoesNotFit, 0) => match counts.requirements_not_met {
            0 => said!(language => "does not fit" | "nicht geeignet"),
            1 => {
                said!(language => "does not fit: 1 requirement not met" | "nicht geeignet: 1 Anforderung nicht erfüllt")
            }
            more => said!(language =>
                "does not fit: {more} requirements not met"
                | "nicht geeignet: {more} Anforderungen nicht erfüllt"
            ),
        },
        (Fit::DoesNotFit, 1) => said!(language =>
            "does not fit: 1 of {all} checks fails"
            | "nicht geeignet: 1 von {all} Nachweisen nicht erfüllt"
        ),
        (Fit::DoesNotFit, failed) => said!(language =>
            "does not fit: {failed} of {all} checks fail"
            | "nicht geeignet: {failed} von {all} Nachweisen nicht erfüllt"
        ),
    };
    if !fit.fits() {
        return text;
    }
    if unheld {
        text += &said!(language =>
            ", but the load is not held when the power is off"
            | ", aber die Last wird im stromlosen Zustand nicht gehalten"
        );
    }
    text + &missing_data_text([missing, all], counts.requirements_open, language)
}

/// Returns the number of checks that lack data, of all checks, and the number of requirements that do; empty if nothing is
/// missing.
#[must_use]
pub fn missing_data_text([missing, all]: [usize; 2], requirements: usize, language: Language) -> String {
    let checks = match missing {
        0 => String::new(),
        1 => said!(language => "; data missing for 1 of {all} checks" | "; bei 1 von {all} Nachweisen fehlen Angaben"),
        _ => said!(language =>
            "; data missing for {missing} of {all} checks"
            | "; bei {missing} von {all} Nachweisen fehlen Angaben"
        ),
    };
    let open = requirements;
    checks
        + &match open {
            0 => String::new(),
            1 => said!(language => "; data missing for 1 requirement" | "; bei 1 Anforderung fehlen Angaben"),
            _ => {
                said!(language => "; data missing for {open} requirements" | "; bei {open} Anforderungen fehlen Angaben")
            }
        }
}

/// Returns the numbers of checks by verdict, in one line.
#[must_use]
pub fn counts_text(counts: &Counts, language: Language) -> String {
    let mut parts = Vec::new();
    let mut add = |count: usize, verdict| {
        if count > 0 {
            parts.push(verdict_count(verdict, count, language));
        }
    };
    add(counts.failed, Verdict::Fail);
    add(counts.passed, Verdict::Pass);
    add(counts.advised, Verdict::Advice);
    add(counts.not_checked, Verdict::NotChecked);
    if counts.without_limit > 0 {
        parts.push(format!("{} {}", counts.without_limit, without_limit(language)));
    }
    parts.join(", ")
}

/// Returns the verdict of a check with a value but without a limit of the project: it is only shown.
#[must_use]
pub fn without_limit(language: Language) -> String {
    said!(language => "no limit stated" | "keine Grenze angegeben")
}

/// Returns the term for a symbol, from the glossary; the symbol itself if the glossary has none.
#[must_use]
pub fn symbol_term(symbol: &str, language: Language) -> String {
    catalogue::term(symbol).map_or_else(|| symbol.to_owned(), |term| pick(language, term.en, term.de).to_owned())
}

/// Words of table conditions in German, longer phrases before their parts.
const CONDITIONS: [(&str, &str); 24] = [
    ("limit", "Grenze"),
    ("no condensation", "ohne Kondensation"),
    ("above sea level", "über NN"),
    ("aluminium, ambient", "Aluminium, Umgebung"),
    ("typ. at 5 V DC, no load", "typ. bei 5 V DC, ohne Last"),
    ("no load", "ohne Last"),
    ("incremental", "inkrementell"),
    ("commutation", "Kommutierung"),
    ("salt spray", "Salzsprühnebelprüfung"),
    ("joint faces completely degreased, friction coefficient", "Fügeflächen vollständig entfettet, Reibungszahl"),
    ("part 2", "Teil 2"),
    ("warning", "Warnung"),
    ("shutdown", "Abschaltung"),
    ("sensor=", "Sensor "),
    ("mating coupling", "Kabelkupplung"),
    ("series=", "Baureihe "),
    ("ratio=", "i = "),
    ("winding=", "Wicklung "),
    ("without brake", "ohne Bremse"),
    ("with brake", "mit Bremse"),
    ("open end", "offenes Ende"),
    ("pin ", "Stift "),
    ("grease", "Fettschmierung"),
    ("maximum", "Kurzzeit"),
];

/// Returns the condition of a table row as text.
#[must_use]
pub fn condition_text(condition: &str, language: Language) -> String {
    // The rows of the published curves have identifiers.
    let curve = match condition {
        "continuous" => Some(("continuous duty", "Dauerbetrieb")),
        "s3_50" => Some(("S3 50 %", "S3 50 %")),
        "s3_25" => Some(("S3 25 %", "S3 25 %")),
        "maximum" => Some(("short-time duty", "Kurzzeitbetrieb")),
        _ => None,
    };
    if let Some((en, de)) = curve {
        return pick(language, en, de).to_owned();
    }
    let (crossed, four) =
        pick(language, ("crossed roller", "four-point contact"), ("Kreuzrollenlager", "Vierpunktlager"));
    let mut text = condition.replace("degC", "°C");
    text = text.replace("bearing_type=C", crossed).replace("bearing_type=F", four);
    text = text.replace("option_1=", pick(language, "option 1 ", "Option 1 "));
    if language == Language::De {
        for (en, de) in CONDITIONS {
            text = text.replace(en, de);
        }
    } else {
        let named = text.replace("sensor=", "sensor ").replace("series=", "series ");
        let named = named.replace("ratio=", "i = ").replace("winding=", "winding ");
        text = with_points(&named);
    }
    typeset(&text).into_owned()
}

/// Replaces the decimal commas of the manual by points.
fn with_points(text: &str) -> String {
    let signs: Vec<char> = text.chars().collect();
    let digit = |index: Option<usize>| index.and_then(|at| signs.get(at)).is_some_and(char::is_ascii_digit);
    let point = |(index, sign): (usize, &char)| {
        if *sign == ',' && digit(index.checked_sub(1)) && digit(Some(index + 1)) { '.' } else { *sign }
    };
    signs.iter().enumerate().map(point).collect()
}

/// Returns the datum that a check lacks.
#[must_use]
pub fn check_missing(symbol: &str, language: Language) -> String {
    if symbol == "recorded_speed" {
        return said!(language =>
            "not known: constant speeds contained in the recording"
            | "nicht bekannt: konstante Drehzahlen der Aufzeichnung"
        );
    }
    if symbol == "gear_load" {
        return said!(language =>
            "no load: the gear transmits no torque in motion, its life is not limited"
            | "keine Last: das Getriebe überträgt in Bewegung kein Moment, die Lebensdauer ist nicht begrenzt"
        );
    }
    if CheckId::is_limit(symbol) {
        return said!(language => "no limit stated: {symbol}" | "keine Grenze angegeben: {symbol}");
    }
    if symbol.contains('.') {
        return said!(language => "not stated: {symbol}" | "nicht angegeben: {symbol}");
    }
    let term = symbol_term(symbol, language);
    // A datum of the place of installation: the project states its own.
    match symbol {
        "ambient_temperature_operation" => {
            return said!(language =>
                "not stated for the actuator: permissible ambient temperature in operation (ambient_min, ambient_max)"
                | "für den Antrieb nicht angegeben: zulässige Umgebungstemperatur im Betrieb (ambient_min, ambient_max)"
            );
        }
        "altitude" | "mounting_position" | "protection_class" | "relative_humidity" => {
            return said!(language => "not stated for the actuator: {term}" | "für den Antrieb nicht angegeben: {term}");
        }
        _ => {}
    }
    // A row that the tables name in words has no sign.
    let shown = match row_sign(symbol) {
        _ if term == symbol => term,
        Some(sign) => format!("{sign}, {term}"),
        None => term,
    };
    said!(language => "not known: {shown}" | "nicht bekannt: {shown}")
}

pub(super) fn with_unit(si: f64, unit: &Unit, digits: usize, language: Language) -> String {
    let number = format_significant(unit.from_si(si), digits, language);
    with_symbol(&number, unit.symbol_in(language))
}

/// Returns the evidence for an erratum.
#[must_use]
pub fn evidence_text(id: &str, language: Language) -> &'static str {
    catalogue::erratum(id).map_or("", |erratum| pick(language, erratum.evidence, erratum.evidence_de))
}

/// Returns a grade in one word.
#[must_use]
pub fn grade_word(grade: Grade, language: Language) -> &'static str {
    match (language, grade) {
        (Language::En, Grade::Printed) => "manufacturer data",
        (Language::En, grade) => grade.id(),
        (Language::De, Grade::Printed) => "Herstellerangabe",
        (Language::De, Grade::Computed) => "berechnet",
        (Language::De, Grade::Published) => "veröffentlicht",
        (Language::De, Grade::Estimated) => "geschätzt",
        (Language::De, Grade::Assumed) => "angenommen",
    }
}

/// Returns the source of a number.
#[must_use]
pub fn source_text(source: &Source, language: Language) -> String {
    match source {
        Source::Cell(cell) => cell_text(cell, language),
        Source::Published(cell) => {
            let mut text = document_short(cell.document, language).to_owned();
            text.push_str(": ");
            row_text(cell, &mut text, language);
            text
        }
        Source::Equation { number } => equation_text(number, language),
        Source::Model { name } => {
            let name = crate::models::model_name(name, language);
            said!(language => "model {name}" | "Modell {name}")
        }
        Source::Project { key } => said!(language => "project: {key}" | "Projekt: {key}"),
        Source::CatalogueFile { place } => place.to_string(),
        Source::NotStated { key } => said!(language => "{key} not stated" | "{key} nicht angegeben"),
    }
}

/// Returns an equation of the manual, or several: `75.2`, `73.1 – 73.4`.
#[must_use]
pub fn equation_text(number: &str, language: Language) -> String {
    let manual = document_short(MANUAL, language);
    said!(language => "{manual} eq. {number}" | "{manual} Gl. {number}")
}

fn cell_text(cell: &CellRef, language: Language) -> String {
    let mut text = said!(language => "table " | "Tabelle ");
    text.push_str(cell.table);
    text.push_str(", ");
    row_text(cell, &mut text, language);
    text
}

fn row_text(cell: &CellRef, text: &mut String, language: Language) {
    text.push_str(&row_name(cell.symbol, language));
    if !cell.condition.is_empty() {
        text.push_str(&format!(" ({})", condition_text(cell.condition, language)));
    }
    if !cell.ratio.is_empty() {
        // A row may hold for a range of ratios: `> 50`.
        let relation = if cell.ratio.starts_with(['<', '>', '≤', '≥']) { "" } else { "= " };
        text.push_str(&format!(", i {relation}{}", cell.ratio));
    }
}

/// Returns the symbol of a row with Greek letters, `τ_e` for `tau_e`; `None` for a row that the tables name in words,
/// such as `bearing_type`.
#[must_use]
pub fn row_sign(symbol: &str) -> Option<String> {
    let shown = symbol_shown(symbol);
    let base = shown.split(['_', '(']).next().unwrap_or_default();
    let letters = base.chars().filter(|sign| sign.is_alphabetic()).count();
    let is_sign = letters <= 2 || letters == 3 && base.chars().all(char::is_uppercase);
    is_sign.then_some(shown)
}

/// Returns the name of a table row: its symbol, else its term.
#[must_use]
pub fn row_name(symbol: &str, language: Language) -> String {
    // The tables have two values of the same symbol, without brake and with.
    if let Some(sign) = symbol.strip_suffix("_brake").and_then(row_sign) {
        return said!(language => "{sign} with brake" | "{sign} mit Bremse");
    }
    row_sign(symbol).unwrap_or_else(|| symbol_term(symbol, language))
}

/// Returns the code of a degree of protection from its numerals, or from the second alone where only that is compared.
#[must_use]
pub fn degree_of_protection(numerals: f64) -> String {
    if numerals < 10.0 { format!("IPX{numerals}") } else { format!("IP{numerals}") }
}

/// Returns the rule of the ranking; `by_mass` where products without frame sizes compete.
#[must_use]
pub fn ranking_rule(by_mass: bool, language: Language) -> String {
    if by_mass {
        return said!(language =>
            "ranking: fitting actuators first; of these, those that hold the load without power, then those that fit without relying on an estimate, then those that state torque, speed and continuous curve, then lower mass, lower utilisation; frame sizes of different manufacturers are not comparable"
            | "Rangfolge: geeignete Antriebe zuerst; davon zuerst solche, die die Last stromlos halten, dann ohne Schätzung geeignete, dann solche mit Angabe von Drehmoment, Drehzahl und Dauerkennlinie, dann geringere Masse, niedrigere Auslastung; Baugrößen verschiedener Hersteller sind nicht vergleichbar"
        );
    }
    said!(language =>
        "ranking: fitting actuators first; of these, those that hold the load without power, then those that fit without relying on an estimate, then smaller frame size, lower utilisation, lower mass"
        | "Rangfolge: geeignete Antriebe zuerst; davon zuerst solche, die die Last stromlos halten, dann ohne Schätzung geeignete, dann kleinere Baugröße, niedrigere Auslastung, geringere Masse"
    )
}

/// Returns the term for a figure of an actuator, or of the demand on it, as used in a comparison with the built-in
/// actuator.
#[must_use]
pub fn figure_term(symbol: &str, language: Language) -> String {
    let (en, de) = match symbol {
        "J_out" => ("own moment of inertia at the output", "eigenes Massenträgheitsmoment am Abtrieb"),
        "L" => ("length", "Länge"),
        "m" => ("mass", "Masse"),
        "n_peak" => ("peak output speed", "Spitzendrehzahl am Abtrieb"),
        "T_peak" => ("peak torque", "Spitzendrehmoment"),
        _ => return symbol_term(symbol, language),
    };
    pick(language, en, de).to_owned()
}

/// Returns the meaning of a grade, in a sentence.
#[must_use]
pub fn grade_about(grade: Grade, language: Language) -> &'static str {
    match (language, grade) {
        (Language::En, Grade::Printed) => "a value stated in the manufacturer's manual",
        (Language::De, Grade::Printed) => "in der Anleitung des Herstellers angegebener Wert",
        (Language::En, Grade::Computed) => "computed from manufacturer data with an equation of the manual",
        (Language::De, Grade::Computed) => "aus Herstellerangaben mit einer Gleichung der Anleitung berechnet",
        (Language::En, Grade::Published) => "a value from another document, or from your own data sheet",
        (Language::De, Grade::Published) => "Wert aus einem anderen Dokument oder dem eigenen Datenblatt",
        (Language::En, Grade::Estimated) => "a model of antrieb with a stated band",
        (Language::De, Grade::Estimated) => "Modellwert von antrieb mit angegebenem Band",
        (Language::En, Grade::Assumed) => "a default value that was not confirmed",
        (Language::De, Grade::Assumed) => "nicht bestätigter Standardwert",
    }
}
