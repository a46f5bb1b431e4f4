//! Words that no reader of a page, a report, a workbook or a picture should meet: internal identifiers, and English in a German text.

use std::collections::BTreeSet;

/// Endings of names of files, which have a point within them like a key.
const FILES: [&str; 14] =
    ["toml", "csv", "md", "pdf", "xlsx", "json", "parquet", "svg", "png", "eds", "dcf", "ics", "vcd", "exe"];

/// Identifiers in a text: names with `_` that are no symbol of a quantity, dotted keys, and those of documents and tables of the data.
///
/// Names of files, addresses and what stands in quotation marks as typed into a file are none. Keys of the project file that a reader is
/// asked to type are removed by the caller.
#[must_use]
pub fn identifiers(text: &str) -> BTreeSet<String> {
    let is_part = |sign: char| sign.is_alphanumeric() || matches!(sign, '_' | '.' | '-' | '/' | ':' | '[' | ']' | '"');
    let words = text.split(|sign: char| !is_part(sign));
    let words = words.map(|word| word.trim_matches(|sign: char| matches!(sign, '.' | ':' | '-' | '/' | '[' | ']')));
    let known = known();
    let docs = words.clone().filter(|word| word.starts_with("docs/")).map(str::to_owned);
    let found = words.filter(|word| !word.contains(['"', '/', ':'])).filter_map(|word| {
        // `m_brake` is the row of a table and no symbol that the manual has.
        let is_one = known.contains(word) || is_snake(word) || is_dotted(word) || word.ends_with("_brake");
        is_one.then(|| word.to_owned())
    });
    found.chain(docs).collect()
}

/// Identifiers of documents and of tables that are not numbered.
fn known() -> BTreeSet<&'static str> {
    let documents = catalogue::documents().iter().filter(|found| found.id != found.short).map(|found| found.id);
    let tables = catalogue::tables().iter().map(|table| table.id);
    // What has no hyphen is an ordinary word: a table `family`.
    documents
        .chain(tables)
        .filter(|id| id.contains('-') && !id.starts_with(|sign: char| sign.is_ascii_digit()))
        .collect()
}

/// A name with `_` that is no symbol: `bearing_type`, not `T_rms`, `n_mot_max`, `ED_max`.
fn is_snake(word: &str) -> bool {
    let Some((base, tail)) = word.split_once('_') else { return false };
    // A symbol of code spans and ordering codes has capitals or digits; a key has none.
    let letters = base.chars().filter(|sign| sign.is_alphabetic()).count();
    let is_symbol = letters <= 2 || letters == 3 && base.chars().all(char::is_uppercase);
    !is_symbol && !tail.is_empty() && base.chars().all(|sign| sign.is_ascii_lowercase() || sign.is_ascii_digit())
}

/// A key in its table: `bearing.load_factor`.
fn is_dotted(word: &str) -> bool {
    let parts: Vec<&str> = word.split('.').collect();
    let is_name = |part: &&str| {
        part.len() > 1
            && part.starts_with(|sign: char| sign.is_ascii_lowercase())
            && part
                .chars()
                .all(|sign| sign.is_ascii_lowercase() || sign.is_ascii_digit() || matches!(sign, '_' | '[' | ']'))
    };
    parts.len() > 1 && parts.iter().all(is_name) && parts.last().is_some_and(|last| !FILES.contains(last))
}

/// English words that no German text has: neither German words nor terms or names that German takes over.
const ENGLISH: [&str; 59] = [
    "the",
    "and",
    "with",
    "without",
    "from",
    "into",
    "which",
    "that",
    "this",
    "these",
    "those",
    "than",
    "then",
    "not",
    "are",
    "is",
    "was not",
    "been",
    "has",
    "have",
    "its",
    "their",
    "every",
    "each",
    "between",
    "where",
    "while",
    "because",
    "above",
    "below",
    "through",
    "torque",
    "speed",
    "value",
    "values",
    "load",
    "loads",
    "bearing",
    "gear",
    "mass",
    "model of",
    "models",
    "calibrations",
    "assumed",
    "estimated",
    "computed",
    "published",
    "stated",
    "given",
    "none",
    "table",
    "sheet",
    "check",
    "checks",
    "time",
    "length",
    "width",
    "unit",
    "page",
];

/// English words in a German text, each with the words around it.
#[must_use]
pub fn english(text: &str) -> Vec<String> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let bare = |word: &str| word.trim_matches(|sign: char| !sign.is_alphanumeric()).to_owned();
    let mut found = Vec::new();
    for (at, word) in words.iter().enumerate() {
        // `rev. 06` of a document is an abbreviation in either language.
        let is_unit = *word == "rev";
        let word = bare(word);
        // Nouns have a capital in German and a name has one in any language.
        if is_unit || ENGLISH.contains(&word.as_str()) {
            let around = words.get(at.saturating_sub(4)..(at + 5).min(words.len())).unwrap_or_default();
            found.push(format!("{word}: {}", around.join(" ")));
        }
    }
    found
}

/// The text of a page or a picture, without what its elements `code`, `pre`, `script`, `style` and `textarea` hold.
#[must_use]
pub fn text_of(markup: &str) -> String {
    let mut out = String::new();
    let mut rest = markup;
    while let Some((text, tagged)) = rest.split_once('<') {
        out.push_str(text);
        let Some((tag, behind)) = tagged.split_once('>') else { return unescaped(&out) };
        let name: String = tag.chars().take_while(char::is_ascii_alphanumeric).collect();
        rest = behind;
        if ["code", "pre", "script", "style", "textarea", "kbd", "option", "datalist"].contains(&name.as_str())
            && !tag.ends_with('/')
        {
            rest = behind.split_once(&format!("</{name}>")).map_or("", |(_, behind)| behind);
        }
        // A symbol and its index stay one word.
        if !["tspan", "sub", "/sub", "/tspan", "span", "i", "/i"].contains(&tag.split(' ').next().unwrap_or_default()) {
            out.push(' ');
        }
    }
    out.push_str(rest);
    unescaped(&out)
}

/// Sizes of the letters of a picture at its own width, with the text that follows \[pt\].
///
/// # Panics
/// If the SVG states no width or no coordinates.
#[must_use]
#[allow(clippy::expect_used, reason = "a picture without a size must fail the test that measures it")]
pub fn letters_of(svg: &str) -> Vec<(f64, String)> {
    let attribute = |name: &str| {
        let rest = svg.split(&format!("{name}=")).nth(1).expect("an attribute of the picture");
        rest.get(1..).and_then(|rest| rest.split(['"', '\'']).next()).expect("a value in quotation marks").to_owned()
    };
    let written = attribute(" width");
    let (number, pt) = match written.strip_suffix("mm") {
        Some(millimetres) => (millimetres.to_owned(), 72.0 / 25.4),
        // Pixels of CSS, 96 to an inch.
        None => (written.trim_end_matches("px").to_owned(), 72.0 / 96.0),
    };
    let width: f64 = number.parse().expect("a width");
    let drawn: f64 = attribute("viewBox").split(' ').nth(2).and_then(|width| width.parse().ok()).expect("coordinates");
    let scale = width * pt / drawn;
    let sizes = svg.match_indices("font-size").filter_map(|(at, key)| {
        let rest = svg.get(at + key.len()..)?.trim_start_matches(['=', ':', '"', '\'', ' ']);
        let digits: String = rest.chars().take_while(|sign| sign.is_ascii_digit() || *sign == '.').collect();
        Some((digits.parse::<f64>().ok()? * scale, rest.chars().take(80).collect()))
    });
    sizes.collect()
}

fn unescaped(text: &str) -> String {
    text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_found_and_symbols_and_files_are_none() {
        let found =
            identifiers("table 79.1, transmissible_torque_load (bearing.flange_share), zd-shf-2uh; [motion.bearing]");
        assert_eq!(
            found.into_iter().collect::<Vec<_>>(),
            ["bearing.flange_share", "motion.bearing", "transmissible_torque_load", "zd-shf-2uh"]
        );
        for text in [
            "T_rms, n_mot_max; ED_max, ω_out",
            "robot-joint.csv axis.toml",
            "z.B. u.a.",
            "e.g. i.e.",
            "https://a.b/c_d_e",
            "CHA-25A-50-H-C1024",
            "mechanism = \"load_cell\"",
        ] {
            assert!(identifiers(text).is_empty(), "{text}: {:?}", identifiers(text));
        }
    }

    #[test]
    fn english_is_found_in_a_german_text() {
        assert_eq!(english("Abgleich (Calibrations of the models)").len(), 2);
        assert!(english("Wave Generator, Engineering Data, Lost Motion, in der Last").is_empty());
    }

    #[test]
    fn letters_of_a_picture_have_their_size_on_paper() {
        let svg = "<svg width=\"254mm\" height=\"1mm\" viewBox=\"0 0 720 9\"><text font-size=\"7.5\">a</text>\
            <style>text{font-size:14px}</style></svg>";
        let sizes: Vec<f64> = letters_of(svg).into_iter().map(|(size, _)| size).collect();
        let is_near = |(size, wanted): (&f64, f64)| (size - wanted).abs() < 1e-9;
        assert!(sizes.len() == 2 && sizes.iter().zip([7.5, 14.0]).all(is_near), "{sizes:?}");
    }

    #[test]
    fn markup_gives_its_text() {
        assert_eq!(
            text_of("<p>a <code>x.y</code>T<sub>rms</sub> &lt; 5</p>").split_whitespace().collect::<Vec<_>>(),
            ["a", "Trms", "<", "5"]
        );
    }
}
