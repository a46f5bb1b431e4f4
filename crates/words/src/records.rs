//! Words of the records: reasons in short, what is to be bought, what was not found.

use crate::texts::texts;

texts! {
    feedback_not_permitted = "feedback not permitted" | "Feedback nicht zugelassen";
    hollow_shaft_too_narrow = "hollow shaft too narrow" | "Hohlwelle zu eng";
    too_long = "too long" | "zu lang";
    too_heavy = "too heavy" | "zu schwer";
    supply_too_low = "supply too low for the winding" | "Versorgung zu niedrig für die Wicklung";
    rule_of_table(table) = "rule of the ordering code, table {table}" | "Regel des Bestellschlüssels, Tabelle {table}";
    screws_at_the_load = "screws between flange and load" | "Schrauben zwischen Flansch und Last";
    screws_at_the_housing = "screws between housing and machine" | "Schrauben zwischen Gehäuse und Maschine";
    length_after_the_joined_part = "length after the part that is joined" | "Länge nach dem verschraubten Teil";
    load = "load" | "Last";
    transmits_degreased(torque) = "transmits {torque}, degreased" | "überträgt {torque}, entfettet";
    no_such_erratum(text) =
        "no erratum, table or ordering code is called `{text}`"
        | "kein Druckfehler, keine Tabelle und keine Bestellbezeichnung heißt `{text}`";
}
