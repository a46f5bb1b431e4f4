//! Words for the records: reasons in short form, parts to order, missing results.

use crate::texts::texts;

texts! {
    feedback_not_permitted = "encoder not permitted" | "Geber nicht zugelassen";
    hollow_shaft_too_narrow = "hollow shaft bore too small" | "Hohlwellendurchmesser zu klein";
    too_long = "too long" | "zu lang";
    too_heavy = "too heavy" | "zu schwer";
    too_expensive = "too expensive" | "zu teuer";
    lead_time_too_long = "lead time too long" | "Lieferzeit zu lang";
    supply_too_low = "supply voltage too low for the winding" | "Versorgungsspannung zu niedrig für die Wicklung";
    rule_of_table(table) = "rule of the ordering code, table {table}" | "Regel des Bestellschlüssels, Tabelle {table}";
    servo_actuator = "servo actuator" | "Servoantrieb";
    catalogue_file = "catalogue file" | "Katalogdatei";
    screws_at_the_load = "screws between flange and load" | "Schrauben zwischen Flansch und Last";
    screws_at_the_housing = "screws between housing and machine" | "Schrauben zwischen Gehäuse und Maschine";
    length_after_the_joined_part = "length to suit the clamped part" | "Länge nach dem verschraubten Bauteil";
    load = "load" | "Last";
    mating_coupling_of(connector, kind) =
        "mating coupling for {connector} {kind}" | "Kabelkupplung für {connector} {kind}";
    cable_of(role) = "cable of the {role}" | "Leitung, {role}";
    cable_to_choose(cable, goal, lengths) = "{cable}; for {goal}; length {lengths}" | "{cable}; für {goal}; Länge {lengths}";
    length_code(letters) = "{letters} by the drive manufacturer" | "{letters} nach Angabe des Herstellers des Servoreglers";
    number_in_doubt =
        "number in doubt, ask before ordering"
        | "Nummer zweifelhaft, vor der Bestellung nachfragen";
    number_corrected = "with a printing error corrected" | "mit berichtigtem Druckfehler";
    by_choice = "as required" | "wahlweise";
    transmits(torque) = "transmits {torque}" | "überträgt {torque}";
    no_such_erratum(text) =
        "there is no erratum, table or ordering code `{text}`"
        | "es gibt weder einen Druckfehler noch eine Tabelle oder Bestellbezeichnung `{text}`";
}
