//! Words about files that are damaged, or larger in something than is read.

use crate::either;
use quantities::Language;
use recording::{Damage, Limit};

/// What is wrong with a Parquet file.
pub(super) fn damage(damage: &Damage, language: Language) -> String {
    let t = |en: &str, de: &str| either(language, en, de);
    match damage {
        Damage::NoParquet => t("the marks of the format are missing", "die Kennung des Formats fehlt"),
        Damage::Encrypted => t("it is encrypted", "sie ist verschlüsselt"),
        Damage::Elsewhere => t("its pages lie in another file", "ihre Seiten liegen in einer anderen Datei"),
        Damage::Footer => t("its footer is damaged or cut off", "ihr Fußteil ist beschädigt oder abgeschnitten"),
        Damage::Page => t("a page is damaged", "eine Seite ist beschädigt"),
        Damage::Packed => t(
            "a page does not unpack to the size that it states",
            "eine Seite hat entpackt nicht die Größe, die sie angibt",
        ),
        Damage::Lengths => {
            t("the columns of a row group differ in length", "die Spalten einer Zeilengruppe sind verschieden lang")
        }
        Damage::Compression { name } => either(
            language,
            format!("the compression {name} is not supported"),
            format!("die Kompression {name} wird nicht unterstützt"),
        ),
        Damage::Encoding { name } => either(
            language,
            format!("the encoding {name} of numbers is not supported"),
            format!("die Kodierung {name} von Zahlen wird nicht unterstützt"),
        ),
        Damage::Values { text } => either(
            language,
            format!("the values of a page cannot be decoded ({text})"),
            format!("die Werte einer Seite lassen sich nicht dekodieren ({text})"),
        ),
    }
}

/// Too much of something, and what helps.
pub(super) fn beyond(limit: Limit, found: u64, most: u64, language: Language) -> (String, Option<String>) {
    let mebibytes = |bytes: u64| format!("{} MiB", bytes.div_ceil(1 << 20));
    let t = |en: &str, de: &str| Some(either(language, en, de));
    let e = |en: String, de: String| either(language, en, de);
    match limit {
        Limit::FileBytes => {
            let (found, most) = (mebibytes(found), mebibytes(most));
            (
                e(
                    format!("the file has {found}, at most {most} are read"),
                    format!("die Datei hat {found}, gelesen werden höchstens {most}"),
                ),
                t(
                    "cut a part out of it, or record at a lower rate",
                    "einen Abschnitt herausschneiden oder langsamer abtasten",
                ),
            )
        }
        Limit::Memory => {
            let (found, most) = (mebibytes(found), mebibytes(most));
            (
                e(
                    format!("the recordings of the project need {found} of memory, {most} are allowed"),
                    format!("die Aufzeichnungen des Projekts brauchen {found} Speicher, erlaubt sind {most}"),
                ),
                t(
                    "select a part with from and to, or allow more with --memory",
                    "mit from und to einen Abschnitt wählen oder mit --memory mehr erlauben",
                ),
            )
        }
        Limit::Rows => (
            e(
                format!("the file has {found} rows, at most {most} are looked at"),
                format!("die Datei hat {found} Zeilen, betrachtet werden höchstens {most}"),
            ),
            t(
                "cut a part out of it, or record at a lower rate",
                "einen Abschnitt herausschneiden oder langsamer abtasten",
            ),
        ),
        Limit::Columns => (
            e(
                format!("the file has {found} columns or more, at most {most} are read"),
                format!("die Datei hat {found} Spalten oder mehr, gelesen werden höchstens {most}"),
            ),
            t("export the columns of the axis alone", "nur die Spalten der Achse ausgeben"),
        ),
        Limit::Nesting => (
            e(
                format!("the groups of the Parquet schema are nested {found} deep or deeper, at most {most} are read"),
                format!(
                    "die Gruppen des Parquet-Schemas sind {found}-fach oder tiefer geschachtelt, gelesen werden höchstens {most}"
                ),
            ),
            t("export a flat table", "eine flache Tabelle ausgeben"),
        ),
        Limit::PathBytes => (
            e(
                format!("the path of a column has {found} bytes, at most {most} are read"),
                format!("der Pfad einer Spalte hat {found} Byte, gelesen werden höchstens {most}"),
            ),
            None,
        ),
        Limit::RowGroups => (
            e(
                format!("the file has {found} row groups, at most {most} are read"),
                format!("die Datei hat {found} Zeilengruppen, gelesen werden höchstens {most}"),
            ),
            t("write larger row groups", "größere Zeilengruppen schreiben"),
        ),
        Limit::PageRatio => (
            e(
                format!("a page unpacks to {found} times its size, at most {most} times are read"),
                format!(
                    "eine Seite hat entpackt das {found}-Fache ihrer Größe, gelesen wird höchstens das {most}-Fache"
                ),
            ),
            t(
                "write smaller pages (up to 16 MiB any ratio is read)",
                "kleinere Seiten schreiben (bis 16 MiB wird jedes Verhältnis gelesen)",
            ),
        ),
        Limit::UnpackedBytes => {
            let most = mebibytes(most);
            (
                e(
                    format!("the pages of the file unpack to more than {most}"),
                    format!("die Seiten der Datei haben entpackt mehr als {most}"),
                ),
                t("cut a part out of it", "einen Abschnitt herausschneiden"),
            )
        }
        Limit::DeltaBlock => (
            e(
                format!("a block of delta-coded values holds {found} values, at most {most} are read"),
                format!("ein Block differenzkodierter Werte enthält {found} Werte, gelesen werden höchstens {most}"),
            ),
            t("known writers use 128 to 2048 values", "bekannte Programme schreiben 128 bis 2048 Werte"),
        ),
    }
}
