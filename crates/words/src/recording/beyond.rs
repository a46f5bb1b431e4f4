//! Words about files that are damaged, or larger in something than is read.

use crate::texts::said;
use quantities::Language;
use recording::{Damage, Limit};

/// What is wrong with a Parquet file.
pub(super) fn damage(damage: &Damage, language: Language) -> String {
    match damage {
        Damage::NoParquet => said!(language => "the marks of the format are missing" | "die Kennung des Formats fehlt"),
        Damage::Encrypted => said!(language => "it is encrypted" | "sie ist verschlüsselt"),
        Damage::Elsewhere => {
            said!(language => "its pages lie in another file" | "ihre Seiten liegen in einer anderen Datei")
        }
        Damage::Footer => said!(language =>
            "its footer is damaged or cut off"
            | "ihr Fußteil ist beschädigt oder abgeschnitten"
        ),
        Damage::Page => said!(language => "a page is damaged" | "eine Seite ist beschädigt"),
        Damage::Packed => said!(language =>
            "a page does not unpack to the size that it states"
            | "eine Seite hat entpackt nicht die Größe, die sie angibt"
        ),
        Damage::Lengths => said!(language =>
            "the columns of a row group differ in length"
            | "die Spalten einer Zeilengruppe sind verschieden lang"
        ),
        Damage::Compression { name } => said!(language =>
            "the compression {name} is not supported"
            | "die Kompression {name} wird nicht unterstützt"
        ),
        Damage::Encoding { name } => said!(language =>
            "the encoding {name} of numbers is not supported"
            | "die Kodierung {name} von Zahlen wird nicht unterstützt"
        ),
        Damage::Values { text } => said!(language =>
            "the values of a page cannot be decoded ({text})"
            | "die Werte einer Seite lassen sich nicht dekodieren ({text})"
        ),
    }
}

/// Too much of something, and what helps.
pub(super) fn beyond(limit: Limit, found: u64, most: u64, language: Language) -> (String, Option<String>) {
    let mebibytes = |bytes: u64| format!("{} MiB", bytes.div_ceil(1 << 20));
    match limit {
        Limit::FileBytes => {
            let (found, most) = (mebibytes(found), mebibytes(most));
            (
                said!(language =>
                    "the file has {found}, at most {most} are read"
                    | "die Datei hat {found}, gelesen werden höchstens {most}"
                ),
                Some(said!(language =>
                    "cut a part out of it, or record at a lower rate"
                    | "einen Abschnitt herausschneiden oder langsamer abtasten"
                )),
            )
        }
        Limit::Memory => {
            let (found, most) = (mebibytes(found), mebibytes(most));
            (
                said!(language =>
                    "the recordings of the project need {found} of memory, {most} are allowed"
                    | "die Aufzeichnungen des Projekts brauchen {found} Speicher, erlaubt sind {most}"
                ),
                Some(said!(language =>
                    "select a part with from and to, or allow more with --memory"
                    | "mit from und to einen Abschnitt wählen oder mit --memory mehr erlauben"
                )),
            )
        }
        Limit::Rows => (
            said!(language =>
                "the file has {found} rows, at most {most} are looked at"
                | "die Datei hat {found} Zeilen, betrachtet werden höchstens {most}"
            ),
            Some(said!(language =>
                "cut a part out of it, or record at a lower rate"
                | "einen Abschnitt herausschneiden oder langsamer abtasten"
            )),
        ),
        Limit::Columns => (
            said!(language =>
                "the file has {found} columns or more, at most {most} are read"
                | "die Datei hat {found} Spalten oder mehr, gelesen werden höchstens {most}"
            ),
            Some(said!(language => "export the columns of the axis alone" | "nur die Spalten der Achse ausgeben")),
        ),
        Limit::Nesting => (
            said!(language =>
                "the groups of the Parquet schema are nested {found} deep or deeper, at most {most} are read"
                | "die Gruppen des Parquet-Schemas sind {found}-fach oder tiefer geschachtelt, gelesen werden höchstens {most}"
            ),
            Some(said!(language => "export a flat table" | "eine flache Tabelle ausgeben")),
        ),
        Limit::PathBytes => (
            said!(language =>
                "the path of a column has {found} bytes, at most {most} are read"
                | "der Pfad einer Spalte hat {found} Byte, gelesen werden höchstens {most}"
            ),
            None,
        ),
        Limit::RowGroups => (
            said!(language =>
                "the file has {found} row groups, at most {most} are read"
                | "die Datei hat {found} Zeilengruppen, gelesen werden höchstens {most}"
            ),
            Some(said!(language => "write larger row groups" | "größere Zeilengruppen schreiben")),
        ),
        Limit::PageRatio => (
            said!(language =>
                "a page unpacks to {found} times its size, at most {most} times are read"
                | "eine Seite hat entpackt das {found}-Fache ihrer Größe, gelesen wird höchstens das {most}-Fache"
            ),
            Some(said!(language =>
                "write smaller pages (up to 16 MiB any ratio is read)"
                | "kleinere Seiten schreiben (bis 16 MiB wird jedes Verhältnis gelesen)"
            )),
        ),
        Limit::UnpackedBytes => {
            let most = mebibytes(most);
            (
                said!(language =>
                    "the pages of the file unpack to more than {most}"
                    | "die Seiten der Datei haben entpackt mehr als {most}"
                ),
                Some(said!(language => "cut a part out of it" | "einen Abschnitt herausschneiden")),
            )
        }
        Limit::DeltaBlock => (
            said!(language =>
                "a block of delta-coded values holds {found} values, at most {most} are read"
                | "ein Block differenzkodierter Werte enthält {found} Werte, gelesen werden höchstens {most}"
            ),
            Some(said!(language =>
                "known writers use 128 to 2048 values"
                | "bekannte Programme schreiben 128 bis 2048 Werte"
            )),
        ),
    }
}
