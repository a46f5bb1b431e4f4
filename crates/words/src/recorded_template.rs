//! Words of a project file that begins with a recording.

use crate::texts::texts;

texts! {
    not_recognised(unused) =
        "not recognised; other columns: {unused}" | "nicht erkannt; übrige Spalten: {unused}";
    none_left =
        "the recording has no such column" | "die Aufzeichnung hat keine solche Spalte";
    no_unit(heading) =
        "unit of \"{heading}\", which the file does not state" | "Einheit von „{heading}“, die die Datei nicht nennt";
    not_of_kind(kind) =
        "a project of the kind \"{kind}\" has no recorded motion" | "ein Projekt der Art „{kind}“ hat keine aufgezeichnete Bewegung";
}
