//! Words used in more than one place: one word for one thing.

use crate::texts::texts;

texts! {
    acceleration = "acceleration" | "Beschleunigung";
    acting_external_torque = "acting external torque" | "wirkendes äußeres Moment";
    acting_process_force = "acting process force" | "wirkende Prozesskraft";
    actuator_with_hollow_shaft = "servo actuator with hollow shaft" | "Servoantrieb mit Hohlwelle";
    advice = "note" | "Hinweis";
    assumed = "assumed" | "angenommen";
    assumptions = "assumptions" | "Annahmen";
    axis = "axis" | "Achse";
    body = "body" | "Körper";
    candidates = "candidates" | "Kandidaten";
    check = "check" | "Nachweis";
    checks = "checks" | "Nachweise";
    columns = "columns" | "Spalten";
    cycle = "cycle" | "Zyklus";
    date = "date" | "Datum";
    demand = "demand" | "Belastung";
    distance = "distance" | "Weg";
    does_not_fit = "does not fit" | "nicht geeignet";
    duration = "duration" | "Dauer";
    fail = "fail" | "nicht erfüllt";
    file = "file" | "Datei";
    fits = "fits" | "geeignet";
    not_evaluated = "not evaluated" | "nicht bewertet";
    fits_if_estimate = "fits if the estimate holds" | "geeignet, sofern die Schätzung zutrifft";
    fits_unless_rating =
        "fits unless the gear rating of another manufacturer applies"
        | "geeignet, sofern die Getriebegrenze eines anderen Herstellers nicht gilt";
    grade = "grade" | "Güte";
    housing = "housing" | "Gehäuse";
    inputs = "inputs" | "Eingaben";
    integral = "integral" | "Integral";
    law = "motion law" | "Bewegungsgesetz";
    limit = "limit" | "Grenze";
    linear_speed = "speed" | "Geschwindigkeit";
    manual = "manual" | "Anleitung";
    margin = "margin" | "Reserve";
    mass = "mass" | "Masse";
    missing = "missing" | "fehlt";
    motion = "motion" | "Bewegung";
    no_flange_loads =
        "the project states no flange loads: [bearing] is missing"
        | "das Projekt nennt keine Lasten am Flansch: [bearing] fehlt";
    flange_loads_open(why) =
        "the loads on the flange are not complete: {why}" | "die Lasten am Flansch sind nicht vollständig: {why}";
    not_checked = "not checked" | "nicht geprüft";
    not_required = "not required" | "nicht gefordert";
    number = "no." | "Nr.";
    on_request = "on request" | "auf Anfrage";
    on_request_only = "on request only" | "nur auf Anfrage";
    ordering_code = "ordering code" | "Bestellbezeichnung";
    product = "product" | "Antrieb";
    own_actuator = "own actuator" | "eigener Antrieb";
    pass = "pass" | "erfüllt";
    payload = "payload" | "Nutzlast";
    payload_inertia = "inertia of the payload" | "Massenträgheitsmoment der Nutzlast";
    rank = "rank" | "Rang";
    reason = "reason" | "Grund";
    recording = "recording" | "Aufzeichnung";
    rejected = "rejected" | "verworfen";
    remark = "remark" | "Bemerkung";
    remarks = "remarks" | "Bemerkungen";
    requirement = "requirement" | "Anforderung";
    requirement_not_met = "requirement not met" | "Anforderung nicht erfüllt";
    revision = "revision" | "Revision";
    rms_torque = "rms torque" | "effektives Drehmoment";
    position = "position" | "Position";
    rotary_speed = "speed" | "Drehzahl";
    segment = "segment" | "Abschnitt";
    source = "source" | "Quelle";
    tightest_check = "governing check" | "maßgebender Nachweis";
    time = "time" | "Zeit";
    torque_speed_plane = "torque-speed plane" | "Drehmoment-Drehzahl-Ebene";
    unit = "unit" | "Einheit";
    utilisation = "utilisation" | "Auslastung";
    utilisation_short = "util. %" | "Ausl. %";
    value = "value" | "Wert";
    verdict = "verdict" | "Ergebnis";
    winding = "winding" | "Wicklung";
}
