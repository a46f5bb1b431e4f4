//! Words for the report, by the keys of its template.

use crate::texts::{Word, texts};
use crate::{capitalised, check_title, terminal, terms};
use chrono::NaiveDate;
use quantities::Language;
use sizing::CheckId;
use std::collections::BTreeMap;

/// Returns every word of the template by its key.
#[must_use]
pub fn words(language: Language) -> BTreeMap<&'static str, String> {
    let own = TEXTS.iter().map(|text| (text.name, text.plain(language).to_owned()));
    let heads = HEADS.iter().map(|(key, word)| (*key, capitalised(word(language))));
    let amid = AMID.iter().map(|(key, word)| (*key, word(language).to_owned()));
    let checks = CHECKS.iter().map(|(key, id)| (*key, capitalised(&check_title(*id, language))));
    own.chain(heads).chain(amid).chain(checks).collect()
}

/// Formats a date as in a letter.
#[must_use]
pub fn date(date: NaiveDate, language: Language) -> String {
    let form = match language {
        Language::De => "%d.%m.%Y",
        Language::En => "%Y-%m-%d",
    };
    date.format(form).to_string()
}

/// Words that are defined elsewhere, here at the beginning of a line.
const HEADS: &[(&str, Word)] = &[
    ("acting_external_torque", terms::acting_external_torque),
    ("acting_process_force", terms::acting_process_force),
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
    ("not_required", terms::not_required),
    ("on_request", terms::on_request_only),
    ("payload", terms::payload),
    ("payload_inertia", terms::payload_inertia),
    ("rank", terms::rank),
    ("reason", terms::reason),
    ("remark", terms::remark),
    ("revision", terms::revision),
    ("s_assumptions", terms::assumptions),
    ("s_not_evaluated", terminal::not_evaluated_listed),
    ("s_open", terms::not_checked),
    ("s_remarks", terms::remarks),
    ("segment", terms::number),
    ("source", terms::source),
    ("tightest", terms::tightest_check),
    ("torque_rms", terms::rms_torque),
    ("unit", terms::unit),
    ("utilisation", terms::utilisation),
    ("v_does_not_fit", terms::does_not_fit),
    ("v_fits", terms::fits),
    ("value", terms::value),
];

/// Words that are defined elsewhere, here within a line.
const AMID: &[(&str, Word)] = &[
    ("advice", terms::advice),
    ("fail", terms::fail),
    ("mass_of_all", terms::mass),
    ("not_checked", terms::not_checked),
    ("pass", terms::pass),
    ("rejected", terms::rejected),
];

/// Returns the words for a limit of zero, where it means that there is none: no brake, no torque, no absolute position.
#[must_use]
pub fn limit_of_zero(id: CheckId, language: Language) -> Option<&'static str> {
    match id {
        CheckId::TorqueSpeedTrace => Some(terminal::no_torque_at_this_speed(language)),
        CheckId::BrakeHolding => Some(terminal::no_holding_torque(language)),
        CheckId::FeedbackRange => Some(terminal::no_absolute_position(language)),
        _ => None,
    }
}

/// Keys whose word is the title of a check.
const CHECKS: &[(&str, CheckId)] =
    &[("speed_mean", CheckId::MeanSpeed), ("speed_peak", CheckId::PeakSpeed), ("torque_peak", CheckId::PeakTorque)];

texts! {
    report = "Sizing report" | "Auslegungsbericht";
    project = "Project" | "Projekt";
    number = "Document" | "Dokument";
    author = "Author" | "Bearbeitet von";
    company = "Company" | "Firma";
    document_number = "Document number" | "Dokumentnummer";
    customer = "Customer" | "Kunde";
    order = "Order" | "Auftrag";
    contents = "Contents" | "Inhalt";
    changes = "Changes" | "Änderungen";
    change = "Change" | "Änderung";
    c_data = "Data of the selected actuator" | "Daten des gewählten Antriebs";
    c_data_and_plane =
        "Selected actuator: torque-speed plane and data" | "Gewählter Antrieb: Drehmoment-Drehzahl-Ebene und Daten";
    data_text =
        "Values of the manual, corrected where an erratum applies; the number in the last column is the table of the manual."
        | "Angaben des Herstellers, mit Druckfehlern berichtigt; die letzte Spalte nennt die Tabelle der Anleitung.";
    marked_errata = "† see “Errata taken into account”, chapter" | "† siehe „Berücksichtigte Druckfehler“, Kapitel";
    marked_masses = "† Errata of the manual for the mass:" | "† Druckfehler der Anleitung zur Masse:";
    s_operation = "Load by segment" | "Belastung je Abschnitt";
    operation_text =
        "At the output shaft; current and power at the motor terminals, E_mot energy drawn, E_reg energy regenerated. cold: gear at ambient temperature; warm: gear at its steady-state temperature, which also applies to I_rms, P_max, E_mot and E_reg. Deviation between the computed instants below 0.1 % of the maximum."
        | "An der Abtriebswelle; Strom und Leistung an den Motorklemmen, E_mot aufgenommene, E_reg zurückgespeiste Energie. kalt: Getriebe auf Umgebungstemperatur; warm: Getriebe auf Beharrungstemperatur, für die auch I_rms, P_max, E_mot und E_reg gelten. Abweichung zwischen den berechneten Zeitpunkten unter 0,1 % des Höchstwerts.";
    cold = "cold" | "kalt";
    warm = "warm";
    whole_cycle = "Cycle" | "Zyklus";
    s_motor = "Motor side and duty type" | "Motorseite und Betriebsart";
    current_rms = "Rms motor current, gear warm" | "Effektiver Motorstrom, Getriebe warm";
    current_peak_cold = "Peak motor current, gear cold" | "Spitzenstrom des Motors, Getriebe kalt";
    current_peak = "Peak motor current, gear warm" | "Spitzenstrom des Motors, Getriebe warm";
    motor_speed_peak = "Peak motor speed" | "Spitzendrehzahl des Motors";
    motor_speed_mean = "Mean motor speed" | "Mittlere Drehzahl des Motors";
    motor_torque_peak_cold = "Peak motor torque, gear cold" | "Spitzendrehmoment des Motors, Getriebe kalt";
    motor_torque_peak = "Peak motor torque, gear warm" | "Spitzendrehmoment des Motors, Getriebe warm";
    motor_torque_rms = "Rms motor torque, gear warm" | "Effektives Motordrehmoment, Getriebe warm";
    inertia_ratio = "Inertia ratio" | "Trägheitsverhältnis";
    motor_text =
        "Motor speed: output speed times ratio. Motor torque: motor torque constant times current, friction included. The check of the peak current uses the larger of the two peak currents."
        | "Motordrehzahl: Abtriebsdrehzahl mal Untersetzung. Motordrehmoment: Drehmomentkonstante des Motors mal Strom, Reibung enthalten. Der Nachweis des Spitzenstroms verwendet den größeren der beiden Spitzenströme.";
    duty_type = "Duty type" | "Betriebsart";
    duty_text =
        "derived from the cycle according to IEC 60034-1; the checks use the cycle itself"
        | "aus dem Zyklus nach IEC 60034-1 abgeleitet; die Nachweise verwenden den Zyklus selbst";
    altered =
        "Computed with values that differ from the project file:" | "Gerechnet mit Werten, die von der Projektdatei abweichen:";
    unnamed = "Axis without name" | "Achse ohne Namen";
    own_actuator = "Actuator from the project, not from the catalogue" | "Antrieb aus dem Projekt, nicht aus dem Katalog";
    exceeded = "Limits exceeded" | "Überschrittene Grenzen";
    unmet = "Requirements not met" | "Nicht erfüllte Anforderungen";
    without_limit = "no limit stated" | "keine Grenze angegeben";
    governing_check = "Governing check" | "Maßgebender Nachweis";
    median_utilisation = "Utilisation, median" | "Auslastung, Median";
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
        "Not stated in the project; the result is valid under these assumptions only."
        | "Im Projekt nicht angegeben; das Ergebnis gilt nur unter diesen Annahmen.";
    sketch_caption =
        "Schematic, not to scale. Symbols as in the adjacent data."
        | "Prinzipskizze, nicht maßstäblich. Formelzeichen wie in den nebenstehenden Daten.";
    sketch_alternative = "Schematic" | "Prinzipskizze";
    mechanism_data = "Data of the mechanism" | "Daten der Mechanik";
    no_data =
        "All further data are contained in the recorded motion."
        | "Alle weiteren Angaben sind in der aufgezeichneten Bewegung enthalten.";
    start = "Start" | "Beginn";
    speed = "Max. speed" | "max. Drehzahl";
    speed_on_the_line = "Max. speed" | "max. Geschwindigkeit";
    acceleration = "Max. acceleration" | "max. Beschleunigung";
    segments_text =
        "Segments of one cycle."
        | "Abschnitte eines Zyklus.";
    loads_text =
        "Process forces and external torques include the constant ones of the mechanism; payloads are added to its mass. Forces and torques are positive if they act against the positive direction of motion."
        | "Prozesskräfte und äußere Momente enthalten die konstanten der Mechanik; Nutzlasten kommen zur Masse der Mechanik hinzu. Kräfte und Momente sind positiv, wenn sie gegen die positive Bewegungsrichtung wirken.";
    s_recordings = "Recorded motion" | "Aufgezeichnete Bewegung";
    file = "File" | "Datei";
    samples = "Samples" | "Abtastwerte";
    demand_text =
        "Demands on the output shaft over one cycle."
        | "Belastung der Abtriebswelle über einen Zyklus.";
    demand_manual =
        "Equations 69.1 to 69.4 of the manual, and the exact integrals over the same motion. Where both exist, the checks use the integrals."
        | "Gleichungen 69.1 bis 69.4 der Anleitung und die exakten Integrale über dieselbe Bewegung. Liegen beide vor, verwenden die Nachweise die Integrale.";
    demand_integral =
        "Exact integrals over the motion; the equations of the manual do not apply to this axis."
        | "Exakte Integrale über die Bewegung; die Gleichungen der Anleitung gelten für diese Achse nicht.";
    quantity = "Quantity" | "Größe";
    definition = "Definition";
    torque_1 = "Torque, acceleration" | "Drehmoment, Beschleunigen";
    torque_2 = "Torque, constant speed" | "Drehmoment, Konstantfahrt";
    torque_3 = "Torque, braking" | "Drehmoment, Bremsen";
    moves = "Torques of each move" | "Drehmomente der einzelnen Bewegungen";
    one_move = "Move" | "Bewegung";
    governing = "governing" | "maßgebend";
    r_ambient = "Permissible ambient temperature" | "Zulässige Umgebungstemperatur";
    r_load_factor = "All masses and inertias, factor" | "Alle Massen und Trägheitsmomente, Faktor";
    r_payload_factor = "Payloads, factor" | "Nutzlasten, Faktor";
    r_cycle_time = "Cycle time of the whole motion" | "Zykluszeit der ganzen Bewegung";
    r_limits = "Limits of the project, all changed together" | "Grenzen des Projekts, gemeinsam geändert";
    r_law = "Another law of motion in place of the assumed one, with the actuator that then fits" | "Anderes Bewegungsgesetz anstelle des angenommenen, mit dem dann geeigneten Antrieb";
    r_gearing = "Another value, with the actuator that then fits" | "Anderer Wert, mit dem dann geeigneten Antrieb";
    with = "with" | "mit";
    missing = "Missing" | "Fehlende Angabe";
    legend =
        "The mark in the bar is the limit, 100 %. Bars beyond it are hatched. An outlined bar belongs to a recommendation or a class that is not met; it does not count towards the highest utilisation."
        | "Der Strich im Balken ist die Grenze, 100 %. Balken darüber sind schraffiert. Ein Balken im Umriss gehört zu einer Empfehlung oder Klasse, die nicht eingehalten ist; er zählt nicht zur höchsten Auslastung.";
    s_fitting = "Suitable actuators" | "Geeignete Antriebe";
    s_nearest = "Rejected actuators with the smallest excess" | "Verworfene Antriebe mit der geringsten Überschreitung";
    judged = "evaluated" | "bewertet";
    fitting = "fit" | "geeignet";
    open_short = "Open" | "Offen";
    chosen = "selected" | "gewählt";
    further = "also:" | "ferner:";
    count = "Count" | "Anzahl";
    s_screws = "Screws" | "Schrauben";
    s_environment = "Place of installation" | "Aufstellort";
    item = "Item" | "Pos.";
    pieces = "Quantity" | "Menge";
    description = "Description" | "Beschreibung";
    joint = "Bolted joint" | "Schraubenverbindung";
    screw_count = "Screws" | "Schrauben";
    circle = "Bolt circle" | "Lochkreis";
    torque = "Tightening torque" | "Anzugsdrehmoment";
    erratum = "Erratum" | "Druckfehler";
    used_for = "Used for" | "Verwendet für";
    s_grades = "Grades" | "Güte der Werte";
    grades_text =
        "The grade of a check is the lowest grade of its input values."
        | "Die Güte eines Nachweises ist die niedrigste Güte seiner Eingangswerte.";
    figure = "Figure" | "Bild";
    page = "page" | "Seite";
    axes = "Axes" | "Achsen";
    program = "Program" | "Programm";
    hash_project = "Fingerprint of the project" | "Prüfsumme des Projekts";
    hash_catalogue = "Fingerprint of the catalogue" | "Prüfsumme des Katalogs";
    disclaimer =
        "Independent calculation, neither affiliated with nor endorsed by the manufacturer of the actuators. The signatories are responsible for the inputs and for the use of the results."
        | "Unabhängige Berechnung ohne Verbindung zum Hersteller der Antriebe und nicht von ihm geprüft. Die Verantwortung für Eingaben und Verwendung der Ergebnisse liegt bei den Unterzeichnenden.";
    v_open = "Fits; data missing" | "Geeignet; es fehlen Angaben";
    v_not_evaluated = "Not evaluated: data missing" | "Nicht bewertet: Es fehlen Angaben";
    v_not_evaluated_text =
        "No check could be made, because the data of the actuator or the axis that it needs are missing."
        | "Kein Nachweis war möglich, weil Angaben zum Antrieb oder zur Achse fehlen.";
    v_fits_text =
        "All checks were made; all are passed."
        | "Alle Nachweise sind geführt und erfüllt.";
    v_fits_by_limits = "All checks with a limit are passed" | "Alle Nachweise mit Grenze sind erfüllt";
    v_open_text =
        "All checks made are passed. The result is valid only after the open points have been settled."
        | "Alle geführten Nachweise sind erfüllt. Das Ergebnis gilt erst nach Klärung der offenen Punkte.";
    v_if_estimate = "Fits if the estimate holds" | "Geeignet, sofern die Schätzung zutrifft";
    v_if_estimate_text =
        "All checks made are passed, the following only if the estimate holds: have them confirmed by the manufacturer, or state a curve:"
        | "Alle geführten Nachweise sind erfüllt, die folgenden nur, wenn die Schätzung zutrifft; vom Hersteller bestätigen lassen oder eine Kennlinie angeben:";
    v_if_rating =
        "Fits unless the gear rating of another manufacturer applies"
        | "Geeignet, sofern die Getriebegrenze eines anderen Herstellers nicht gilt";
    v_if_rating_only =
        "All checked limits of this actuator are kept." | "Alle geprüften Grenzen dieses Antriebs sind eingehalten.";
    v_if_rating_text =
        "The following values exceed a rating that another manufacturer publishes for its gear of this kind; have them confirmed by the manufacturer of the actuator:"
        | "Die folgenden Werte überschreiten eine Grenze, die ein anderer Hersteller für sein Getriebe dieser Art veröffentlicht; vom Hersteller des Antriebs bestätigen lassen:";
    another_gear = "gear rating of another manufacturer" | "Getriebegrenze eines anderen Herstellers";
    another_gear_bars =
        "Dashed bar: the limit is a gear rating of another manufacturer, not of this actuator; it rejects no actuator."
        | "Gestrichelter Balken: Die Grenze ist die eines Getriebes eines anderen Herstellers, nicht dieses Antriebs; sie schließt keinen Antrieb aus.";
    v_open_points = "The result is valid only after the open points have been settled." | "Das Ergebnis gilt erst nach Klärung der offenen Punkte.";
    fitting_if_estimate =
        "more if an estimate holds or the gear rating of another manufacturer does not apply"
        | "weitere, sofern eine Schätzung zutrifft oder die Getriebegrenze eines anderen Herstellers nicht gilt";
    nothing_to_order =
        "Nothing is ordered: the actuator does not fit."
        | "Nichts zu bestellen: der Antrieb ist nicht geeignet.";
    segments_of_a_single_move =
        "Segments of a single move that does not return to its start. Rms values and heating assume that such moves follow each other directly."
        | "Abschnitte einer einmaligen Bewegung, die nicht zum Anfang zurückkehrt. Effektivwerte und Erwärmung nehmen an, dass solche Bewegungen unmittelbar aufeinander folgen.";
    v_does_not_fit_text =
        "At least one limit is exceeded or one requirement not met."
        | "Mindestens ein Grenzwert ist überschritten oder eine Anforderung nicht erfüllt.";
    all_fit =
        "All checks that could be made are passed by these actuators."
        | "Alle geführten Nachweise sind für diese Antriebe erfüllt.";
    not_all_fit = "Not all axes have an actuator that fits." | "Nicht für alle Achsen ist ein Antrieb geeignet.";
    more = "more" | "weitere";
    requirement_not_checked = "requirement not checked" | "Anforderung nicht geprüft";
    requirements_not_checked = "requirements not checked" | "Anforderungen nicht geprüft";
    open_requirements =
        "Requirements not checked; each may rule out the actuator"
        | "Nicht geprüfte Anforderungen; jede kann den Antrieb ausschließen";
    open_one = "check could not be made." | "Nachweis konnte nicht geführt werden.";
    open_many = "checks could not be made." | "Nachweise konnten nicht geführt werden.";
    open_none_rejects = "None of them can rule out the actuator." | "Keiner davon kann den Antrieb ausschließen.";
    open_may_reject = "They may rule out the actuator." | "Sie können den Antrieb ausschließen.";
    open_may_reject_these = "The following may rule out the actuator:" | "Den Antrieb ausschließen können:";
    open_may_reject_by_own_limit =
        "Only if the manufacturer states a limit may the following rule it out:"
        | "Nur bei Angabe des Herstellers können ihn ausschließen:";
    s_tightest = "Checks with the highest utilisation" | "Nachweise mit der höchsten Auslastung";
    reserve_partial = "by the checks that could be made" | "nach den geführten Nachweisen";
    reserve_alone = "Reserves and limits (single changes)" | "Reserven und Grenzen (jeweils nur eine Größe geändert)";
    s_answers = "Results" | "Ergebnisse";
    not_sought = "Not searched" | "Nicht gesucht";
    reserve_needed = "Single changes that would make it fit" | "Einzeländerungen, mit denen er geeignet wäre";
    c_tolerances = "Tolerances" | "Toleranzen";
    c_build = "Parts list and screws" | "Stückliste und Schrauben";
    c_errata = "Errata taken into account" | "Berücksichtigte Druckfehler";
    c_sources = "Sources" | "Quellen";
    a_derivations = "Appendix: derivations" | "Anhang: Herleitungen";
    a_sources = "Appendix: sources of all values" | "Anhang: Quellen aller Werte";
    a_codes = "Appendix: all rejected ordering codes" | "Anhang: alle verworfenen Bestellbezeichnungen";
    inputs_text =
        "From the project file; data of the mechanism follow in the next chapter. Values not listed were not stated."
        | "Aus der Projektdatei; die Daten der Mechanik folgen im nächsten Kapitel. Nicht aufgeführte Werte wurden nicht angegeben.";
    not_listed = "Not listed here" | "Hier nicht aufgeführt";
    not_listed_inputs =
        "The project file contains all of them; its fingerprint is on the first page."
        | "Die Projektdatei enthält alle; ihre Prüfsumme steht auf der ersten Seite.";
    not_listed_results =
        "The output of “antrieb check --json” contains all of them."
        | "Die Ausgabe von „antrieb check --json“ enthält alle.";
    s_bodies = "Bodies" | "Körper";
    bodies_below = "Bodies, see below" | "Körper, siehe unten";
    bodies_sum = "All bodies" | "Alle Körper";
    centre_distance = "Distance" | "Abstand";
    mass_each = "Mass, each" | "Masse je Körper";
    own_inertia = "J own, each" | "J eigen je Körper";
    steiner = "J Steiner, each" | "J Steiner je Körper";
    together = "J total" | "J gesamt";
    travel = "travel per revolution of the actuator" | "Weg je Umdrehung des Antriebs";
    on_the_line = "Linear";
    on_the_line_text =
        "Linear: the same value converted with the travel per revolution, without losses."
        | "Linear: derselbe Wert, mit dem Weg je Umdrehung umgerechnet, ohne Verluste.";
    open_text =
        "Data are missing. These checks count neither as passed nor as failed; they must be settled by other means before signing."
        | "Angaben fehlen. Diese Nachweise gelten weder als erfüllt noch als nicht erfüllt; sie sind vor der Unterschrift anderweitig zu klären.";
    consequence = "If not met" | "Falls nicht erfüllt";
    can_reject = "rules out the actuator" | "schließt den Antrieb aus";
    can_reject_by_own_limit =
        "rules out only if the manufacturer states it" | "schließt nur bei Herstellerangabe aus";
    can_advise = "note only" | "nur Hinweis";
    each_text =
        "Value required by the axis, then limit of the actuator. For the full derivation see the command “antrieb explain”."
        | "Geforderter Wert der Achse, dann Grenze des Antriebs. Vollständige Herleitung mit dem Befehl „antrieb explain“.";
    share_passing = "Share of the samples that fit" | "Anteil geeigneter Stichproben";
    interval = "95 % interval" | "95-%-Intervall";
    quantile_low = "5 %:";
    quantile_high = "95 %:";
    largest = "maximum:" | "Maximum:";
    worst_corner = "Worst corner" | "Ungünstigste Ecke";
    worst_sample = "Worst sample" | "Ungünstigste Stichprobe";
    samples_text =
        "samples, each quantity uniformly distributed within its band, seed"
        | "Stichproben, jede Größe gleichverteilt in ihrem Band, Startwert";
    impossible = "samples for which the axis is not feasible" | "Stichproben, bei denen die Achse nicht ausführbar ist";
    not_exhaustive =
        "The worst corner was searched; not all corners were evaluated."
        | "Die ungünstigste Ecke wurde gesucht; nicht alle Ecken wurden bewertet.";
    at_the_worst = "Worst case" | "Im ungünstigsten Fall";
    influence = "Influence on the utilisation" | "Einfluss auf die Auslastung";
    s_reasons = "Reasons for rejection" | "Ausschlussgründe";
    r_check = "not met" | "nicht erfüllt";
    reasons_text =
        "Each actuator is listed once, under its governing check; if no check fails, under the requirement that is not met."
        | "Jeder Antrieb ist einmal aufgeführt, unter seinem maßgebenden Nachweis; sind alle Nachweise erfüllt, unter der nicht erfüllten Anforderung.";
    errata_text =
        "Values of the manual that are used corrected or with a reservation."
        | "Werte der Anleitung, die berichtigt oder mit Vorbehalt verwendet werden.";
    cited_as = "Cited as" | "Zitiert als";
    title_of = "Title" | "Titel";
    edition = "Edition, date" | "Ausgabe, Datum";
    publisher = "Publisher" | "Herausgeber";
    repeat_text =
        "Identical program, project and catalogue give an identical report, byte for byte."
        | "Gleiches Programm, gleiches Projekt und gleicher Katalog ergeben Byte für Byte denselben Bericht.";
    advice_many = "notes" | "Hinweise";
}
