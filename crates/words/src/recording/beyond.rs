//! Words for files that are damaged or exceed a limit.

use crate::texts::said;
use quantities::Language;
use recording::{Damage, Limit};

/// Returns the damage of a Parquet file.
pub(super) fn damage(damage: &Damage, language: Language) -> String {
    match damage {
        Damage::NoParquet => said!(language => "the format identifier is missing" | "die Formatkennung fehlt"),
        Damage::Encrypted => said!(language => "it is encrypted" | "sie ist verschlüsselt"),
        Damage::Elsewhere => {
            said!(language => "its pages are in another file" | "ihre Seiten liegen in einer anderen Datei")
        }
        Damage::Footer => said!(language =>
            "its footer is damaged or truncated"
            | "ihr Fußteil ist beschädigt oder abgeschnitten"
        ),
        Damage::Page => said!(language => "a page is damaged" | "eine Seite ist beschädigt"),
        Damage::Packed => said!(language =>
            "a page does not decompress to its stated size"
            | "eine Seite hat entpackt nicht die angegebene Größe"
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
            "the number encoding {name} is not supported"
            | "die Kodierung {name} von Zahlen wird nicht unterstützt"
        ),
        Damage::Values { text } => said!(language =>
            "the values of a page cannot be decoded ({text})"
            | "die Werte einer Seite lassen sich nicht dekodieren ({text})"
        ),
    }
}

/// Returns the exceeded limit and the remedy.
pub(super) fn beyond(limit: Limit, found: u64, most: u64, language: Language) -> (String, Option<String>) {
    let mebibytes = |bytes: u64| format!("{} MiB", bytes.div_ceil(1 << 20));
    match limit {
        Limit::FileBytes => {
            let (found, most) = (mebibytes(found), mebibytes(most));
            (
                said!(language =>
                    "the file size is {found}; the limit is {most}"
                    | "die Datei ist {found} groß; zulässig sind höchstens {most}"
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
                    "the recordings of the project require {found} of memory; {most} are permitted"
                    | "die Aufzeichnungen des Projekts benötigen {found} Arbeitsspeicher; zulässig sind {most}"
                ),
                Some(said!(language =>
                    "select a part, from = \"…\" and to = \"…\", or raise the limit with --memory"
                    | "einen Abschnitt wählen, from = \"…\" und to = \"…\", oder die Grenze mit --memory erhöhen"
                )),
            )
        }
        Limit::Rows => (
            said!(language =>
                "the file has {found} rows; the limit is {most}"
                | "die Datei hat {found} Zeilen; zulässig sind höchstens {most}"
            ),
            Some(said!(language =>
                "cut a part out of it, or record at a lower rate"
                | "einen Abschnitt herausschneiden oder langsamer abtasten"
            )),
        ),
        Limit::Columns => (
            said!(language =>
                "the file has {found} columns or more; the limit is {most}"
                | "die Datei hat {found} Spalten oder mehr; zulässig sind höchstens {most}"
            ),
            Some(said!(language => "export only the columns of the axis" | "nur die Spalten der Achse exportieren")),
        ),
        Limit::Nesting => (
            said!(language =>
                "the groups of the Parquet schema are nested {found} levels deep or deeper; the limit is {most}"
                | "die Gruppen des Parquet-Schemas sind {found}-fach oder tiefer geschachtelt; zulässig sind höchstens {most}"
            ),
            Some(said!(language => "export a flat table" | "eine flache Tabelle exportieren")),
        ),
        Limit::PathBytes => (
            said!(language =>
                "the path of a column has {found} bytes; the limit is {most}"
                | "der Pfad einer Spalte hat {found} Byte; zulässig sind höchstens {most}"
            ),
            None,
        ),
        Limit::RowGroups => (
            said!(language =>
                "the file has {found} row groups; the limit is {most}"
                | "die Datei hat {found} Zeilengruppen; zulässig sind höchstens {most}"
            ),
            Some(said!(language => "write larger row groups" | "größere Zeilengruppen schreiben")),
        ),
        Limit::PageRatio => (
            said!(language =>
                "a page decompresses to {found} times its size; the limit is {most} times"
                | "eine Seite hat entpackt das {found}-Fache ihrer Größe; zulässig ist höchstens das {most}-Fache"
            ),
            Some(said!(language =>
                "write smaller pages (up to 16 MiB any ratio is permitted)"
                | "kleinere Seiten schreiben (bis 16 MiB ist jedes Verhältnis zulässig)"
            )),
        ),
        Limit::UnpackedBytes => {
            let most = mebibytes(most);
            (
                said!(language =>
                    "the pages of the file decompress to more than {most}"
                    | "die Seiten der Datei sind entpackt größer als {most}"
                ),
                Some(said!(language => "cut a part out of it" | "einen Abschnitt herausschneiden")),
            )
        }
        Limit::DeltaBlock => (
            said!(language =>
                "a block of delta-encoded values contains {found} values; the limit is {most}"
                | "ein Block differenzkodierter Werte enthält {found} Werte; zulässig sind höchstens {most}"
            ),
            Some(said!(language =>
                "known writers use 128 to 2048 values"
                | "bekannte Programme schreiben 128 bis 2048 Werte"
            )),
        ),
        Limit::BlankBytes => {
            let most = mebibytes(most);
            (
                said!(language =>
                    "more than {most} in succession are comments, empty lines or the rest of an overlong line"
                    | "mehr als {most} in Folge sind Kommentare, leere Zeilen oder der Rest einer überlangen Zeile"
                ),
                Some(said!(language =>
                    "is this a CSV file with one sample per line?"
                    | "ist dies eine CSV-Datei mit einem Abtastwert je Zeile?"
                )),
            )
        }
    }
}
