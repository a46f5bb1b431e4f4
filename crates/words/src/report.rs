//! Words of the report, by the keys of its template.

use crate::texts::{Word, texts};
use crate::{capitalised, check_title, terms};
use quantities::Language;
use sizing::CheckId;
use std::collections::BTreeMap;

/// Every word of the template by its key.
#[must_use]
pub fn words(language: Language) -> BTreeMap<&'static str, String> {
    let own = TEXTS.iter().map(|text| (text.name, text.plain(language).to_owned()));
    let heads = HEADS.iter().map(|(key, word)| (*key, capitalised(word(language))));
    let amid = AMID.iter().map(|(key, word)| (*key, word(language).to_owned()));
    let checks = CHECKS.iter().map(|(key, id)| (*key, capitalised(&check_title(*id, language))));
    own.chain(heads).chain(amid).chain(checks).collect()
}

/// A date as a letter has it.
#[must_use]
pub fn date(year: u16, month: u8, day: u8, language: Language) -> String {
    match language {
        Language::De => format!("{day:02}.{month:02}.{year:04}"),
        Language::En => format!("{year:04}-{month:02}-{day:02}"),
    }
}

/// Words that stand elsewhere too, here at the head of a line.
const HEADS: &[(&str, Word)] = &[
    ("axis", terms::axis),
    ("body", terms::body),
    ("by_integral", terms::integral),
    ("by_manual", terms::manual),
    ("c_checks", terms::checks),
    ("c_demand", terms::demand),
    ("c_motion", terms::motion),
    ("c_plane", terms::torque_speed_plane),
    ("check", terms::check),
    ("code", terms::ordering_code),
    ("columns", terms::columns),
    ("date", terms::date),
    ("distance", terms::distance),
    ("duration", terms::duration),
    ("grade", terms::grade),
    ("law", terms::law),
    ("limit", terms::limit),
    ("mass", terms::mass),
    ("on_request", terms::on_request_only),
    ("rank", terms::rank),
    ("reason", terms::reason),
    ("remark", terms::remark),
    ("revision", terms::revision),
    ("s_assumptions", terms::assumptions),
    ("s_open", terms::not_checked),
    ("s_remarks", terms::remarks),
    ("segment", terms::number),
    ("source", terms::source),
    ("subject", terms::actuator_with_hollow_shaft),
    ("tightest", terms::tightest_check),
    ("torque_rms", terms::rms_torque),
    ("unit", terms::unit),
    ("utilisation", terms::utilisation),
    ("v_does_not_fit", terms::does_not_fit),
    ("v_fits", terms::fits),
    ("value", terms::value),
];

/// Words that stand elsewhere too, here within a line.
const AMID: &[(&str, Word)] = &[
    ("advice", terms::advice),
    ("fail", terms::fail),
    ("mass_of_all", terms::mass),
    ("not_checked", terms::not_checked),
    ("pass", terms::pass),
    ("rejected", terms::rejected),
];

/// What bears the name of a check.
const CHECKS: &[(&str, CheckId)] = &[
    ("r_ambient", CheckId::Ambient),
    ("speed_mean", CheckId::MeanSpeed),
    ("speed_peak", CheckId::PeakSpeed),
    ("torque_peak", CheckId::PeakTorque),
];

texts! {
    report = "Sizing report" | "Auslegungsbericht";
    project = "Project" | "Projekt";
    number = "Document" | "Dokument";
    author = "Author" | "Bearbeitet von";
    company = "Company" | "Firma";
    unnamed = "Axis without name" | "Achse ohne Namen";
    own_actuator = "Actuator of the project, not of the catalogue" | "Antrieb des Projekts, nicht des Katalogs";
    exceeded = "Limits exceeded" | "Überschrittene Grenzen";
    unmet = "Requirements not met" | "Nicht erfüllte Anforderungen";
    without_limit = "shown without a limit" | "ohne Grenze gezeigt";
    highest_utilisation = "Highest utilisation" | "Höchste Auslastung";
    duty = "Duty factor" | "Einschaltdauer";
    cycle = "Cycle time" | "Zykluszeit";
    prepared = "Prepared" | "Erstellt";
    checked = "Checked" | "Geprüft";
    released = "Released" | "Freigegeben";
    signature = "Name, date, signature" | "Name, Datum, Unterschrift";
    c_inputs = "Inputs and assumptions" | "Eingaben und Annahmen";
    c_mechanism = "Mechanism" | "Mechanik";
    c_alternatives = "Alternatives" | "Alternativen";
    assumptions_text =
        "Not stated in the project; the result is valid only under these assumptions."
        | "Im Projekt nicht angegeben; das Ergebnis gilt nur unter diesen Annahmen.";
    sketch_caption =
        "Principle, not to scale. The symbols are those of the data beside it."
        | "Prinzipskizze, nicht maßstäblich. Die Formelzeichen sind die der nebenstehenden Daten.";
    sketch_alternative = "Principle sketch" | "Prinzipskizze";
    mechanism_data = "Data of the mechanism" | "Daten der Mechanik";
    no_data =
        "Everything else comes with the recorded motion."
        | "Alles Weitere kommt mit der aufgezeichneten Bewegung.";
    start = "Start" | "Beginn";
    speed = "Peak speed" | "Spitzengeschw.";
    acceleration = "Peak acceleration" | "Spitzenbeschl.";
    segments_text =
        "Segments of one cycle, which repeats without end."
        | "Abschnitte eines Zyklus, der sich ohne Ende wiederholt.";
    s_recordings = "Recorded motion" | "Aufgezeichnete Bewegung";
    file = "File" | "Datei";
    samples = "Samples" | "Abtastwerte";
    demand_text =
        "What the axis asks of the output shaft over one cycle."
        | "Was die Achse über einen Zyklus an der Abtriebswelle fordert.";
    demand_manual =
        "Equations 69.1 to 69.4 of the manual, beside them the exact integrals over the same motion. Checks use the integrals where both exist."
        | "Gleichungen 69.1 bis 69.4 der Anleitung, daneben die genauen Integrale über dieselbe Bewegung. Die Nachweise nutzen die Integrale, wo es beide gibt.";
    demand_integral =
        "Exact integrals over the motion; the equations of the manual do not describe this axis."
        | "Genaue Integrale über die Bewegung; die Gleichungen der Anleitung beschreiben diese Achse nicht.";
    quantity = "Quantity" | "Größe";
    definition = "Definition";
    torque_1 = "Torque, accelerating" | "Drehmoment, Beschleunigen";
    torque_2 = "Torque, constant speed" | "Drehmoment, Konstantfahrt";
    torque_3 = "Torque, braking" | "Drehmoment, Bremsen";
    moves = "Torques of each move" | "Drehmomente der einzelnen Bewegungen";
    one_move = "Move" | "Bewegung";
    governing = "governing" | "maßgebend";
    r_load_factor = "All masses and inertias, factor" | "Alle Massen und Trägheitsmomente, Faktor";
    r_payload_factor = "Payloads, factor" | "Nutzlasten, Faktor";
    r_cycle_time = "Cycle time of the whole motion" | "Zykluszeit der ganzen Bewegung";
    r_limits = "Limit of the project, with all of these together" | "Grenze des Projekts, mit allen diesen zusammen";
    r_gearing = "Another gearing, with the code that fits then" | "Andere Übersetzung, mit dem dann geeigneten Code";
    with = "with" | "mit";
    missing = "Missing" | "Es fehlt";
    legend =
        "The mark in the bar is the limit, 100 %. A bar beyond it is hatched. A bar in outline belongs to a recommendation or a class that is met or not; it does not count towards the highest utilisation."
        | "Der Strich im Balken ist die Grenze, 100 %. Ein Balken darüber ist schraffiert. Ein Balken im Umriss gehört zu einer Empfehlung oder einer Klasse, die erfüllt ist oder nicht; er zählt nicht zur höchsten Auslastung.";
    no_limit = "no limit given" | "keine Grenze gegeben";
    s_fitting = "What fits" | "Was geeignet ist";
    s_nearest = "Nearest misses" | "Die knappsten unter den verworfenen";
    judged = "judged" | "beurteilt";
    fitting = "fit" | "geeignet";
    open_short = "Open" | "Offen";
    chosen = "chosen" | "gewählt";
    further = "Further checks failed" | "Weitere nicht erfüllte Nachweise";
    count = "Count" | "Anzahl";
    s_screws = "Screws" | "Schrauben";
    item = "Item" | "Pos.";
    pieces = "Quantity" | "Menge";
    description = "Description" | "Beschreibung";
    joint = "Joint" | "Verbindung";
    screw_count = "Screws" | "Schrauben";
    circle = "Circle" | "Teilkreis";
    torque = "Tightening torque" | "Anzugsmoment";
    erratum = "Erratum" | "Druckfehler";
    used_for = "Used for" | "Genutzt für";
    s_grades = "Grades" | "Güte der Werte";
    grades_text =
        "A check is as good as the weakest value in it."
        | "Ein Nachweis ist so gut wie der schwächste Wert darin.";
    figure = "Figure" | "Bild";
    page = "page" | "Seite";
    axes = "Axes" | "Achsen";
    program = "Program" | "Programm";
    hash_project = "Fingerprint of the project" | "Prüfsumme des Projekts";
    hash_catalogue = "Fingerprint of the catalogue" | "Prüfsumme des Katalogs";
    disclaimer =
        "Independent calculation, neither affiliated with nor endorsed by the maker of the actuators. The signatories are responsible for the inputs and for their use."
        | "Unabhängige Berechnung ohne Verbindung zum Hersteller der Antriebe und nicht von ihm geprüft. Die Verantwortung für Eingaben und Verwendung liegt bei den Unterzeichnenden.";
    v_open = "Fits as far as checked" | "Geeignet, soweit geprüft";
    v_fits_text =
        "Every question is answered, and no check fails."
        | "Alle Fragen sind beantwortet, kein Nachweis ist verletzt.";
    v_open_text =
        "No check that could be made fails. The answer holds only once the open points are settled."
        | "Kein geführter Nachweis ist verletzt. Das Ergebnis gilt erst, wenn die offenen Punkte geklärt sind.";
    v_does_not_fit_text =
        "At least one limit is exceeded or one requirement is not met."
        | "Mindestens ein Grenzwert ist überschritten oder eine Anforderung nicht erfüllt.";
    above_in_band =
        "The highest utilisation is above 100 %, but within the band of an estimate: advice, not failure."
        | "Die höchste Auslastung liegt über 100 %, jedoch im Band einer Schätzung: ein Hinweis, keine Verletzung.";
    all_fit =
        "Nothing that could be checked speaks against any of these actuators."
        | "Soweit geprüft, spricht gegen keinen dieser Antriebe etwas.";
    not_all_fit = "Not every axis has an actuator that fits." | "Nicht jede Achse hat einen geeigneten Antrieb.";
    more = "more" | "weitere";
    open_one = "question could not be checked." | "Frage ließ sich nicht prüfen.";
    open_many = "questions could not be checked." | "Fragen ließen sich nicht prüfen.";
    open_none_rejects = "None of them can rule the actuator out." | "Keine davon kann den Antrieb ausschließen.";
    open_may_reject = "They may rule the actuator out." | "Sie können den Antrieb ausschließen.";
    open_may_reject_these = "These may rule the actuator out:" | "Den Antrieb ausschließen können:";
    s_tightest = "The tightest checks" | "Die engsten Nachweise";
    reserve_alone = "Reserve: how far each may change alone" | "Reserve: so weit darf sich jedes allein ändern";
    s_answers = "Answers" | "Ergebnisse";
    not_sought = "Not sought" | "Nicht gesucht";
    reserve_needed = "What alone would let it fit" | "Was jeweils allein genügte";
    c_tolerances = "Tolerances" | "Toleranzen";
    c_build = "Bill of material and screws" | "Stückliste und Schrauben";
    c_errata = "Errata used" | "Berücksichtigte Druckfehler";
    c_sources = "Sources" | "Quellen";
    a_derivations = "Appendix: derivations" | "Anhang: Herleitungen";
    a_sources = "Appendix: source of every figure" | "Anhang: Quellen aller Werte";
    a_codes = "Appendix: all rejected ordering codes" | "Anhang: alle verworfenen Bestellbezeichnungen";
    inputs_text =
        "From the project file; those of the mechanism follow in the next chapter. What is not listed was not stated."
        | "Aus der Projektdatei; die der Mechanik folgen im nächsten Kapitel. Was hier fehlt, wurde nicht angegeben.";
    not_listed = "Not listed here" | "Hier nicht aufgeführt";
    not_listed_inputs =
        "The project file has all of them; its fingerprint stands on the first page."
        | "Die Projektdatei enthält alle; ihre Prüfsumme steht auf der ersten Seite.";
    not_listed_results =
        "The answer of “antrieb check --json” has all of them."
        | "Die Antwort von „antrieb check --json“ enthält alle.";
    s_bodies = "Bodies" | "Körper";
    bodies_below = "Bodies, see below" | "Körper, siehe unten";
    bodies_sum = "All bodies" | "Alle Körper";
    centre_distance = "Distance" | "Abstand";
    mass_each = "Mass, each" | "Masse je Stück";
    own_inertia = "Own, each" | "Eigen je Stück";
    steiner = "Steiner, each" | "Steiner je Stück";
    together = "J, all" | "J gesamt";
    travel = "travel for one turn of the actuator" | "Weg je Umdrehung des Antriebs";
    on_the_line = "On the line" | "Längs der Führung";
    on_the_line_text =
        "On the line: the same figure carried over by the travel per turn, without losses."
        | "Längs der Führung: dieselbe Größe, umgerechnet über den Weg je Umdrehung, ohne Verluste.";
    open_text =
        "A datum is missing. These checks count neither as passed nor as failed; they must be settled by other means before signing."
        | "Ein Kennwert fehlt. Diese Nachweise gelten weder als erfüllt noch als nicht erfüllt; sie sind vor der Unterschrift auf anderem Weg zu klären.";
    consequence = "If not met" | "Wenn nicht erfüllt";
    can_reject = "rules the actuator out" | "schließt den Antrieb aus";
    can_advise = "advice only" | "nur Hinweis";
    each_text =
        "What the axis asks, then what the actuator gives. The command “antrieb explain” goes deeper."
        | "Was die Achse fordert, dann was der Antrieb gibt. Tiefer geht der Befehl „antrieb explain“.";
    share_passing = "Share of the samples that fit" | "Anteil geeigneter Stichproben";
    interval = "95 % interval" | "95-%-Intervall";
    quantile_low = "5 %:";
    quantile_high = "95 %:";
    largest = "largest:" | "Maximum:";
    worst_corner = "Worst corner" | "Ungünstigste Ecke";
    worst_sample = "Worst sample" | "Ungünstigste Stichprobe";
    samples_text =
        "samples, every quantity uniform within its band, seed"
        | "Stichproben, jede Größe gleichverteilt in ihrem Band, Startwert";
    impossible = "samples make no axis" | "Stichproben ergeben keine Achse";
    not_exhaustive =
        "The worst corner was searched; not every corner was looked at."
        | "Die ungünstigste Ecke wurde gesucht; nicht jede Ecke wurde betrachtet.";
    at_the_worst = "At the worst" | "Im ungünstigsten Fall";
    influence = "Influence on the utilisation" | "Einfluss auf die Auslastung";
    s_reasons = "Why the others are rejected" | "Warum die anderen verworfen sind";
    r_check = "exceeded" | "nicht erfüllt";
    reasons_text =
        "Each actuator stands once, at its first reason; a requirement not met goes before a limit exceeded."
        | "Jeder Antrieb steht einmal, bei seinem ersten Grund; eine nicht erfüllte Anforderung geht einer überschrittenen Grenze vor.";
    errata_text =
        "Figures of the manual that are used corrected or with a remark."
        | "Werte der Anleitung, die berichtigt oder mit Vorbehalt verwendet sind.";
    cited_as = "Cited as" | "Zitiert als";
    title_of = "Title" | "Titel";
    edition = "Edition, date" | "Ausgabe, Datum";
    publisher = "Publisher" | "Herausgeber";
    repeat_text =
        "The same program with the same project and catalogue gives the same report, byte for byte."
        | "Dasselbe Programm mit demselben Projekt und Katalog ergibt denselben Bericht, Byte für Byte.";
    advice_many = "advice" | "Hinweise";
}
