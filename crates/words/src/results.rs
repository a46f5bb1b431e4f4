//! Words about results: checks, notes, requirements, assumptions, sources.

use super::either;
use actuator::CurveKind;
use configurator::Unmet;
use order_code::Brake;
use project::Assumption;
use provenance::{CellRef, Grade, MANUAL, Source};
use quantities::unit::{DEGREE, KILOGRAM, MILLIMETRE, SECOND, VOLT};
use quantities::{Language, Measure, Unit, format_number, format_significant};
use sizing::{CheckId, Note, Verdict};

/// The title of a check.
#[must_use]
pub fn check_title(id: CheckId, language: Language) -> String {
    let (en, de) = match id {
        CheckId::PeakTorque => ("peak torque", "Spitzendrehmoment"),
        CheckId::PeakSpeed => ("peak speed", "Spitzendrehzahl"),
        CheckId::MeanSpeed => ("mean speed", "mittlere Drehzahl"),
        CheckId::ContinuousTorque => ("continuous torque", "Dauerdrehmoment"),
        CheckId::PeakCurrent => ("peak current", "Spitzenstrom"),
        CheckId::Demagnetisation => ("demagnetisation", "Entmagnetisierung"),
        CheckId::Voltage => ("terminal voltage", "Klemmenspannung"),
        CheckId::InertiaRatio => ("inertia ratio", "Trägheitsverhältnis"),
        CheckId::GearMeanTorque => ("mean gear torque", "mittleres Getriebemoment"),
        CheckId::GearLife => ("gear life", "Getriebelebensdauer"),
        CheckId::Torsion => ("torsion", "Torsionswinkel"),
        CheckId::NaturalFrequency => ("natural frequency", "Eigenfrequenz"),
        CheckId::BearingAxial => ("bearing, axial", "Lager axial"),
        CheckId::BearingRadial => ("bearing, radial", "Lager radial"),
        CheckId::BearingTiltingMoment => ("bearing, tilting", "Lager, Kippmoment"),
        CheckId::BearingLife => ("bearing life", "Lagerlebensdauer"),
        CheckId::BearingStatic => ("bearing, static", "Lager statisch"),
        CheckId::TiltAngle => ("tilt angle", "Kippwinkel"),
        CheckId::Ambient => ("ambient temperature", "Umgebungstemperatur"),
        CheckId::TorqueSpeedTrace => ("torque-speed trace", "Drehmomentverlauf"),
        CheckId::Thermal => ("winding temperature", "Wicklungstemperatur"),
        CheckId::OverloadI2t => ("overload I²t", "Überlast I²t"),
        CheckId::GearMeanInputSpeed => ("mean input speed", "mittlere Eingangsdrehzahl"),
        CheckId::CollisionTorque => ("collision torque", "Kollisionsmoment"),
        CheckId::ResonanceSpeed => ("resonance speed", "Resonanzdrehzahl"),
        CheckId::ErrorBudget => ("error budget", "Fehlersumme"),
        CheckId::BrakeHolding => ("brake, holding", "Bremse, Halten"),
        CheckId::BrakeEmergency => ("brake, stop", "Bremse, Nothalt"),
        CheckId::DcLink => ("DC link", "Zwischenkreis"),
        CheckId::Regeneration => ("regeneration", "Rückspeisung"),
        CheckId::FeedbackRange => ("absolute range", "Absolutbereich"),
        CheckId::FeedbackResolution => ("resolution", "Auflösung"),
        CheckId::Battery => ("encoder battery", "Geberbatterie"),
        CheckId::ScrewJointLoad => ("screws, load", "Schrauben, Last"),
        CheckId::ScrewJointHousing => ("screws, housing", "Schrauben, Gehäuse"),
        CheckId::Application => ("application", "Anwendungsbereich"),
    };
    either(language, en, de)
}

/// The title of a curve of the torque-speed plane.
#[must_use]
pub fn curve_title(kind: &CurveKind, language: Language) -> String {
    match kind {
        CurveKind::Continuous => either(language, "continuous duty", "Dauerbetrieb"),
        CurveKind::S3 { duty } => {
            let share = format_number(duty.si() * 100.0, 0, language);
            either(
                language,
                format!("intermittent duty S3, {share} % of 1 min"),
                format!("Aussetzbetrieb S3, {share} % von 1 min"),
            )
        }
        CurveKind::ShortTime => {
            either(language, "short time: acceleration and braking", "Kurzzeitbetrieb: Beschleunigen und Bremsen")
        }
    }
}

/// A verdict in one word; never told by colour alone.
#[must_use]
pub fn verdict_word(verdict: Verdict, language: Language) -> String {
    let (en, de) = match verdict {
        Verdict::Pass => ("pass", "erfüllt"),
        Verdict::Fail => ("FAIL", "nicht erfüllt"),
        Verdict::Advice => ("advice", "Hinweis"),
        Verdict::NotChecked => ("not checked", "nicht geprüft"),
    };
    either(language, en, de)
}

/// How many checks came to a verdict.
#[must_use]
pub fn verdict_count(verdict: Verdict, count: usize, language: Language) -> String {
    match (verdict, language) {
        (Verdict::Advice, Language::De) if count != 1 => format!("{count} Hinweise"),
        (Verdict::Fail, Language::En) => format!("{count} fail"),
        _ => format!("{count} {}", verdict_word(verdict, language)),
    }
}

/// Whether a candidate fits, and how many questions about it could not be answered: nothing else in the house words this.
#[must_use]
pub fn standing_text(fits: bool, open_questions: usize, language: Language) -> String {
    match (fits, open_questions) {
        (false, _) => either(language, "does not fit", "nicht geeignet"),
        (true, 0) => either(language, "fits", "geeignet"),
        (true, 1) => either(
            language,
            "nothing speaks against it; 1 question not answered",
            "nichts spricht dagegen; 1 Frage nicht beantwortet",
        ),
        (true, open) => either(
            language,
            format!("nothing speaks against it; {open} questions not answered"),
            format!("nichts spricht dagegen; {open} Fragen nicht beantwortet"),
        ),
    }
}

/// The field's word for a symbol, from the glossary; the symbol itself where the glossary has none.
#[must_use]
pub fn symbol_term(symbol: &str, language: Language) -> String {
    catalogue::term(symbol).map_or_else(|| symbol.to_owned(), |term| either(language, term.en, term.de))
}

/// Words of table conditions in German, longer phrases before their parts.
const CONDITIONS: [(&str, &str); 23] = [
    ("no condensation", "ohne Kondensation"),
    ("above sea level", "über NN"),
    ("aluminium, ambient", "Aluminium, Umgebung"),
    ("typ. at 5 V DC, no load", "typ. bei 5 V DC, ohne Last"),
    ("no load", "ohne Last"),
    ("incremental", "inkrementell"),
    ("commutation", "Kommutierung"),
    ("salt spray", "Salzsprühtest"),
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

/// The condition of a table row for people.
#[must_use]
pub fn condition_text(condition: &str, language: Language) -> String {
    let mut text = condition.replace("degC", "°C");
    if language == Language::De {
        for (en, de) in CONDITIONS {
            text = text.replace(en, de);
        }
    } else {
        let named = text.replace("sensor=", "sensor ").replace("series=", "series ");
        let named = named.replace("ratio=", "i = ").replace("winding=", "winding ");
        text = with_points(&named);
    }
    text
}

/// The decimal commas of a print as points.
fn with_points(text: &str) -> String {
    let signs: Vec<char> = text.chars().collect();
    let digit = |index: Option<usize>| index.and_then(|at| signs.get(at)).is_some_and(char::is_ascii_digit);
    let point = |(index, sign): (usize, &char)| {
        if *sign == ',' && digit(index.checked_sub(1)) && digit(Some(index + 1)) { '.' } else { *sign }
    };
    signs.iter().enumerate().map(point).collect()
}

/// What a check lacks.
#[must_use]
pub fn check_missing(symbol: &str, language: Language) -> String {
    if symbol == "recorded_speed" {
        return either(
            language,
            "not known: which speeds the recording holds",
            "nicht bekannt: welche Drehzahlen die Aufzeichnung hält",
        );
    }
    let geometry = symbol.starts_with("bearing.") && symbol != "bearing.operating_condition";
    if symbol == "gear_load" {
        return either(
            language,
            "no load: the gear carries no torque in motion, and nothing limits its life",
            "keine Last: das Getriebe überträgt in Bewegung kein Moment, nichts begrenzt seine Lebensdauer",
        );
    }
    if symbol.starts_with("mechanism.") || symbol.starts_with("stage.") || geometry {
        return either(language, format!("not stated: {symbol}"), format!("nicht angegeben: {symbol}"));
    }
    if symbol.contains('.') {
        return either(language, format!("no limit given: {symbol}"), format!("keine Grenze angegeben: {symbol}"));
    }
    let term = symbol_term(symbol, language);
    let shown = if term == symbol { symbol.to_owned() } else { format!("{symbol}, {term}") };
    either(language, format!("not known: {shown}"), format!("nicht bekannt: {shown}"))
}

pub(super) fn with_unit(si: f64, unit: &Unit, digits: usize, language: Language) -> String {
    let number = format_significant(unit.from_si(si), digits, language);
    if unit.symbol == "1" { number } else { format!("{number} {}", unit.symbol) }
}

/// Why an erratum says what it says.
#[must_use]
pub fn evidence_text(id: &str, language: Language) -> &'static str {
    catalogue::erratum(id).map_or("", |erratum| match language {
        Language::En => erratum.evidence,
        Language::De => erratum.evidence_de,
    })
}

/// A grade in one word.
#[must_use]
pub fn grade_word(grade: Grade, language: Language) -> &'static str {
    match (language, grade) {
        (Language::En, grade) => grade.id(),
        (Language::De, Grade::Printed) => "Herstellerangabe",
        (Language::De, Grade::Computed) => "berechnet",
        (Language::De, Grade::Published) => "veröffentlicht",
        (Language::De, Grade::Estimated) => "geschätzt",
        (Language::De, Grade::Assumed) => "angenommen",
    }
}

/// A remark on a check.
#[must_use]
pub fn note_text(note: &Note, language: Language) -> String {
    match note {
        Note::CycleNotShort { cycle } => {
            let cycle = with_unit(cycle.si(), &SECOND, 3, language);
            either(
                language,
                format!(
                    "the cycle of {cycle} is not short against the winding's time constant of about 60 s: the rms torque alone does not show whether the winding stays cool enough"
                ),
                format!(
                    "der Zyklus von {cycle} ist nicht kurz gegen die Wicklungszeitkonstante von etwa 60 s: aus dem effektiven Drehmoment allein folgt nicht, ob die Wicklung kühl genug bleibt"
                ),
            )
        }
        Note::BrakingTorqueAssumed => either(
            language,
            "braking and accelerating times differ: eq. 69.2 would take T_3 from the accelerating time; the exact integral decides",
            "Brems- und Beschleunigungszeit sind verschieden: Gl. 69.2 nähme T_3 aus der Beschleunigungszeit; es entscheidet das exakte Integral",
        ),
        Note::RecommendationForHighDynamics => either(
            language,
            "J_L ≤ 3 J_out is a recommendation for highly dynamic duty, not a limit",
            "J_L ≤ 3 J_out ist eine Empfehlung für hochdynamischen Betrieb, keine Grenze",
        ),
        Note::SwingTooSmall { swing } => {
            let swing = with_unit(swing.si(), &DEGREE, 3, language);
            either(
                language,
                format!("the axis swings by {swing} only; below 5° the bearing may fret, ask the maker"),
                format!("die Achse schwenkt nur um {swing}; unter 5° droht Reibkorrosion, beim Hersteller fragen"),
            )
        }
        Note::SmallSwings { count, largest, share } => super::flange::small_swings(*count, *largest, *share, language),
        Note::RatingOfInterchangeableGear => either(
            language,
            "the gear's rating is that of another maker's interchangeable gear with the same T_R; the manual states none",
            "die Getriebewerte sind die eines austauschbaren Getriebes eines anderen Herstellers mit gleichem T_R; die Anleitung nennt keine",
        ),
        Note::LoadsOneAtATime => either(
            language,
            "the permissible forces hold one at a time; for several together life and static safety decide",
            "die zulässigen Kräfte gelten je für sich; bei mehreren zugleich entscheiden Lebensdauer und statische Sicherheit",
        ),
        note @ (Note::WarmUp(_)
        | Note::Housing(_)
        | Note::EnergyPerCycle { .. }
        | Note::Capacitor { .. }
        | Note::DcLinkRises { .. }) => super::notes::heat(note, language),
        note @ (Note::FrictionTemperatures { .. }
        | Note::FrictionExtrapolated { .. }
        | Note::UntilWarm
        | Note::EstimatedUpTo(_)
        | Note::InsideBand
        | Note::RiseAbove(_)) => super::notes::estimate(note, language),
        note @ (Note::HangingLoad
        | Note::Sag(_)
        | Note::BrakeStop(_)
        | Note::BrakeDoesNotStop
        | Note::NoBrake
        | Note::NothingHolds
        | Note::NothingHoldsWithoutPower
        | Note::DwellTooShortForBrake { .. }
        | Note::BrakeTimesAssumed
        | Note::BrakingsLast { .. }) => super::notes::brake(note, language),
        note @ (Note::ReferenceLost { .. }
        | Note::NeedsReferencing
        | Note::BatteryExchange { .. }
        | Note::ApprovalNeeded
        | Note::ResonanceSpeeds(_)
        | Note::FreeRotor(_)
        | Note::Ratcheting { .. }
        | Note::CollisionsPermitted(_)
        | Note::Budget(_)) => super::notes::rest(note, language),
        Note::Erratum(id) => {
            let evidence = evidence_text(id, language);
            either(language, format!("erratum {id}: {evidence}"), format!("Druckfehler {id}: {evidence}"))
        }
    }
}

/// The requirement that is not met, in a word or two.
#[must_use]
pub fn requirement_title(unmet: &Unmet, language: Language) -> String {
    let (en, de) = match unmet {
        Unmet::Feedback(_) => ("feedback", "Feedback"),
        Unmet::Brake(_) => ("brake", "Bremse"),
        Unmet::HollowShaft { .. } => ("hollow shaft", "Hohlwelle"),
        Unmet::Length { .. } => ("length", "Länge"),
        Unmet::Mass { .. } => ("mass", "Masse"),
        Unmet::SupplyTooLow { .. } => ("supply voltage", "Versorgungsspannung"),
        Unmet::NotKnown { symbol } => {
            let term = symbol_term(symbol, language);
            return either(language, format!("requirement open ({term})"), format!("Anforderung offen ({term})"));
        }
    };
    either(language, format!("requirement {en}"), format!("Anforderung {de}"))
}

/// A requirement that is not met.
#[must_use]
pub fn unmet_text(unmet: &Unmet, language: Language) -> String {
    let mm = |si| with_unit(si, &MILLIMETRE, 4, language);
    let volt = |si| with_unit(si, &VOLT, 3, language);
    let kg = |si: f64| format!("{} {}", format_number(KILOGRAM.from_si(si), 1, language), KILOGRAM.symbol);
    match unmet {
        Unmet::Feedback(feedback) => either(
            language,
            format!("feedback {feedback} is not among those permitted"),
            format!("Feedback {feedback} ist nicht zugelassen"),
        ),
        Unmet::Brake(Brake::Without) => either(language, "has no brake", "hat keine Bremse"),
        Unmet::Brake(Brake::With) => either(language, "has a brake", "hat eine Bremse"),
        Unmet::HollowShaft { has, needs } => either(
            language,
            format!("hollow shaft {} is narrower than {}", mm(has.si()), mm(needs.si())),
            format!("Hohlwelle {} ist enger als {}", mm(has.si()), mm(needs.si())),
        ),
        Unmet::Length { has, permits } => either(
            language,
            format!("length {} is above {}", mm(has.si()), mm(permits.si())),
            format!("Länge {} liegt über {}", mm(has.si()), mm(permits.si())),
        ),
        Unmet::Mass { has, permits } => either(
            language,
            format!("mass {} is above {}", kg(has.si()), kg(permits.si())),
            format!("Masse {} liegt über {}", kg(has.si()), kg(permits.si())),
        ),
        Unmet::SupplyTooLow { needs, gives } => either(
            language,
            format!(
                "the supply gives {} at the motor terminals, the winding needs {}",
                volt(gives.si()),
                volt(needs.si())
            ),
            format!(
                "die Versorgung gibt {} an den Motorklemmen, die Wicklung braucht {}",
                volt(gives.si()),
                volt(needs.si())
            ),
        ),
        Unmet::NotKnown { symbol } => {
            let term = symbol_term(symbol, language);
            either(language, format!("{symbol} ({term}) is not known"), format!("{symbol} ({term}) ist nicht bekannt"))
        }
    }
}

/// A default that the user did not confirm.
#[must_use]
pub fn assumption_text(assumption: Assumption, language: Language) -> String {
    let (en, de) = match assumption {
        Assumption::NoFriction => {
            ("no friction torque given: 0 Nm assumed", "kein Reibmoment angegeben: 0 Nm angenommen")
        }
        Assumption::AmbientWithinRange => (
            "no ambient temperature given: 0 °C to 40 °C assumed, the range that the maker's data hold for",
            "keine Umgebungstemperatur angegeben: 0 °C bis 40 °C angenommen, dafür gelten die Herstellerangaben",
        ),
        Assumption::CoolingPlate => (
            "mounted on the aluminium plate of table 13.3: continuous data hold for it only",
            "auf der Aluminiumplatte nach Tabelle 13.3 montiert: nur dafür gelten die Dauerdaten",
        ),
        Assumption::ModulationReserve => (
            "the drive gives 90 % of U_DC/√2 at the motor terminals (requirements.modulation_reserve)",
            "der Regler stellt 90 % von U_DC/√2 an den Motorklemmen (requirements.modulation_reserve)",
        ),
        Assumption::NoSupply => (
            "no DC link voltage given (requirements.supply): the terminal voltage is not checked",
            "keine Zwischenkreisspannung angegeben (requirements.supply): die Klemmenspannung ist nicht geprüft",
        ),
        Assumption::OwnStallCurrentIncludesFriction => (
            "I_0 of the own actuator taken to include its no-load starting current I_NLS",
            "I_0 des eigenen Antriebs enthält annahmegemäß den lastfreien Anlaufstrom I_NLS",
        ),
        Assumption::NoFlangeLoads => (
            "no loads on the flange given ([bearing]): the output bearing is not checked",
            "keine Lasten am Flansch angegeben ([bearing]): das Abtriebslager ist nicht geprüft",
        ),
        Assumption::FlangeMomentsAligned => (
            "radial and axial moment on the flange taken in the same direction",
            "Momente aus Radial- und Axialkraft am Flansch gleichgerichtet angesetzt",
        ),
        Assumption::NoLosses => (
            "no efficiency of the mechanism given: 1 assumed",
            "kein Wirkungsgrad der Mechanik angegeben: 1 angenommen",
        ),
        Assumption::LossesDoNotHelp => (
            "no efficiency_back given: while the load drives, the losses do not help to brake",
            "kein efficiency_back angegeben: treibt die Last, so helfen die Verluste nicht beim Bremsen",
        ),
        Assumption::TrapezoidThirds => (
            "a trapezoid given by two quantities accelerates, runs and brakes for a third of its time each",
            "ein Trapez aus zwei Angaben beschleunigt, fährt und bremst je ein Drittel seiner Zeit",
        ),
        Assumption::SingleMoveRepeats => (
            "the single move is judged as if it followed itself without a pause: which is on the safe side for the rms torque",
            "die einmalige Bewegung ist beurteilt, als folgte sie sich ohne Pause: für das effektive Drehmoment ist das die sichere Seite",
        ),
        Assumption::OrdinaryApplication => (
            "no field of application that needs the maker's approval (section 2.4)",
            "kein Anwendungsbereich, der die Freigabe des Herstellers braucht (Abschnitt 2.4)",
        ),
        Assumption::UniformTolerances => (
            "each quantity with a tolerance uniform within its band, independent of the others",
            "jede Größe mit Toleranz in ihrem Band gleichverteilt, unabhängig von den anderen",
        ),
        Assumption::MotorHolds => {
            ("in a dwell without hold the motor carries the load", "im Stillstand ohne hold trägt der Motor die Last")
        }
        Assumption::RecordedTorqueAdds => (
            "the recorded torque is a process torque, added to what inertia, gravity and friction of the mechanism ask for",
            "das aufgezeichnete Moment ist ein Prozessmoment und kommt zu dem hinzu, was Trägheit, Gewicht und Reibung des Mechanismus verlangen",
        ),
        Assumption::RecordedPositionDifferentiated => (
            "speed and acceleration are differences of the recorded position, not smoothed: noise in it raises the torque",
            "Drehzahl und Beschleunigung sind Differenzen der aufgezeichneten Lage, ungeglättet: ihr Rauschen erhöht das Moment",
        ),
        Assumption::FlangeLoadsConstant => (
            "loads on the flange taken as constant over the cycle, radial and axial moment in the same direction",
            "Lasten am Flansch über den Zyklus konstant, Momente aus Radial- und Axialkraft gleichgerichtet",
        ),
        Assumption::FlangeLoadsOfMechanism
        | Assumption::FlangeLoadsAddUp
        | Assumption::FlangeBearsAll
        | Assumption::FlangeBodiesFlat
        | Assumption::FlangeUpwards
        | Assumption::PayloadInertiaWeightless
        | Assumption::WheelWeightless
        | Assumption::SpurTeeth => super::flange::assumed(assumption),
        Assumption::StageNoLosses
        | Assumption::StageLossesDoNotHelp
        | Assumption::StageWithoutInertia
        | Assumption::StageRigid
        | Assumption::StageNoBacklash
        | Assumption::StageRatioChosen
        | Assumption::MechanismOnOwnBearings => super::stage::assumed(assumption),
    };
    either(language, en, de)
}

/// Where a number comes from.
#[must_use]
pub fn source_text(source: &Source, language: Language) -> String {
    match source {
        Source::Cell(cell) => cell_text(cell, language),
        Source::Published(cell) => format!("{} ({})", cell.document, cell_text(cell, language)),
        Source::Equation { number } => {
            either(language, format!("{MANUAL} eq. {number}"), format!("{MANUAL} Gl. {number}"))
        }
        Source::Model { name } => {
            let german = MODELS.iter().find(|(model, _)| model == name).map_or(*name, |(_, german)| german);
            either(language, format!("model {name}"), format!("Modell {german}"))
        }
        Source::Project { key } => either(language, format!("project {key}"), format!("Projekt {key}")),
    }
}

/// Models by their names in German; the English ones are those of the pages in docs/theory.
const MODELS: [(&str, &str); 19] = [
    ("battery", "Batterie"),
    ("brake", "Bremse"),
    ("continuous-torque", "Dauerdrehmoment"),
    ("current", "Motorstrom"),
    ("demand", "Bedarf"),
    ("energy", "Energie"),
    ("error-budget", "Fehlersumme"),
    ("feedback", "Feedback"),
    ("flange-loads", "Flanschlasten"),
    ("gear", "Getriebe"),
    ("mechanisms", "Mechanismen"),
    ("moments", "Zeitintegrale"),
    ("output-bearing", "Abtriebslager"),
    ("overload", "Überlast"),
    ("screw-joint", "Schraubverbindung"),
    ("short-time-torque", "Kurzzeitdrehmoment"),
    ("stage", "Stufe"),
    ("thermal", "Erwärmung"),
    ("voltage", "Klemmenspannung"),
];

fn cell_text(cell: &CellRef, language: Language) -> String {
    let mut text = either(language, "table ", "Tabelle ");
    text.push_str(cell.table);
    text.push_str(", ");
    text.push_str(cell.symbol);
    if !cell.condition.is_empty() {
        text.push_str(&format!(" ({})", condition_text(cell.condition, language)));
    }
    if !cell.ratio.is_empty() {
        text.push_str(&format!(", i = {}", cell.ratio));
    }
    text
}

/// The stated rule of the ranking.
#[must_use]
pub fn ranking_rule(language: Language) -> String {
    either(
        language,
        "order: what fits comes first, then by smaller frame size, lower highest utilisation and lower mass",
        "Reihenfolge: Geeignetes zuerst, dann nach kleinerer Baugröße, niedrigerer höchster Auslastung und geringerer Masse",
    )
}

/// The field's word for a figure of an actuator or of the demand on it, as it is compared: with what is built in.
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
    either(language, en, de)
}

/// What stands behind a grade, in a sentence.
#[must_use]
pub fn grade_about(grade: Grade, language: Language) -> &'static str {
    match (language, grade) {
        (Language::En, Grade::Printed) => "a value that the maker's manual states",
        (Language::De, Grade::Printed) => "ein Wert, den die Anleitung des Herstellers nennt",
        (Language::En, Grade::Computed) => "computed from the maker's values with an equation of the manual",
        (Language::De, Grade::Computed) => "aus Herstellerangaben mit einer Gleichung der Anleitung berechnet",
        (Language::En, Grade::Published) => "a value of another document, or of your own data sheet",
        (Language::De, Grade::Published) => "ein Wert eines anderen Dokuments oder des eigenen Datenblatts",
        (Language::En, Grade::Estimated) => "a model of antrieb with a stated band",
        (Language::De, Grade::Estimated) => "ein Modell von antrieb mit angegebenem Band",
        (Language::En, Grade::Assumed) => "a default that nobody confirmed",
        (Language::De, Grade::Assumed) => "ein Standardwert, den niemand bestätigt hat",
    }
}
