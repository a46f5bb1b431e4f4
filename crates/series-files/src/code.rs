//! `code.toml` of a series: the grammar of its ordering code, and the tables with the rules of combination.

use serde::Deserialize;
use std::collections::BTreeMap;

/// Fields that a code may have, in the order of the file.
const FIELDS: [&str; 9] =
    ["series", "size", "ratio", "winding", "feedback", "brake", "option_1", "option_2", "special"];

/// Kinds of encoder that the engine supports.
const FEEDBACK_KINDS: [&str; 5] =
    ["sine_incremental", "endat_multiturn", "resolver", "square_incremental", "ssi_multiturn"];

/// Returns the variant name for an identifier in the types of `order-code` and `catalogue`: `AtLeast` for `at_least`.
#[must_use]
pub fn variant_of(id: &str) -> String {
    let capitalised = |word: &str| {
        let mut signs = word.chars();
        let first = signs.next().map(|sign| sign.to_ascii_uppercase());
        first.into_iter().chain(signs).collect::<String>()
    };
    id.split('_').map(capitalised).collect()
}

/// One `code.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Code {
    /// First word of every code of the series.
    pub series: String,
    /// Identifier of the manual in `sources.toml`.
    pub manual: String,
    /// Fields in their order.
    #[serde(rename = "field")]
    pub fields: Vec<CodeField>,
    /// Tables by their purpose.
    pub tables: Tables,
    /// Marks of the matrix.
    #[serde(rename = "mark")]
    pub marks: Vec<Mark>,
    /// Windings.
    #[serde(rename = "winding")]
    pub windings: Vec<Winding>,
    /// Feedback systems.
    #[serde(rename = "feedback")]
    pub feedbacks: Vec<Feedback>,
    /// Drives that head tables.
    #[serde(rename = "drive")]
    pub drives: Vec<HeadingDrives>,
    /// Tables of connectors.
    #[serde(default, rename = "wiring")]
    pub wirings: Vec<Wiring>,
}

/// One field.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CodeField {
    /// Identifier of the field.
    pub id: String,
    /// Source of its words.
    pub source: String,
    /// The field may be left out.
    #[serde(default)]
    pub optional: bool,
    /// Words of the field, in the order of the ordering tables.
    pub words: Vec<String>,
    /// Meanings of the words; the first match applies.
    #[serde(default, rename = "meaning")]
    pub meanings: Vec<WordMeaning>,
}

/// Meaning of a word.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WordMeaning {
    /// Word; absent for every word, and for the absence of one.
    pub word: Option<String>,
    /// Words of other fields, one of which must be in the code.
    #[serde(default)]
    pub when: BTreeMap<String, Vec<String>>,
    /// English text; `{}` is the word.
    pub en: String,
    /// German text; `{}` is the word.
    pub de: String,
}

/// Tables by their number, and sections of the manual, by their purpose.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tables {
    /// Table of calibrations of the models.
    pub family: String,
    /// Table of the variants available at each size.
    pub matrix: String,
    /// Pairs of winding and feedback.
    pub pairs: String,
    /// Table of thresholds of the winding temperature; empty if there is none.
    #[serde(default)]
    pub thresholds: String,
    /// Table of conditions of the preselection; empty if there is none.
    #[serde(default)]
    pub preselection: String,
    /// Table of the output encoder; empty if there is none.
    #[serde(default)]
    pub output_encoder: String,
    /// Tables of connector and pins of the output encoder; empty if there is none.
    #[serde(default)]
    pub output_wiring: Vec<String>,
    /// Tables of cables.
    #[serde(default)]
    pub cables: Vec<String>,
    /// Sections whose tables are headed by the size.
    pub by_size: Vec<String>,
    /// Sections whose tables concern a motor encoder.
    pub feedback: Vec<String>,
    /// Sections of ordering and wiring.
    pub ordering: Vec<String>,
    /// Sections whose cells hold for every actuator.
    pub of_all: Vec<String>,
    /// Tables of published curves.
    #[serde(default)]
    pub curves: Vec<String>,
    /// Table of the life of the gear; empty if there is none.
    #[serde(default)]
    pub gear_life: String,
    /// Series of gears whose rows of that table apply.
    #[serde(default)]
    pub gear_series: String,
}

/// Meaning of a cell of the matrix.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mark {
    /// Beginning of the text of the cell.
    pub begins: String,
    /// `available`, `on_request` or `not_available`.
    pub entry: String,
    /// Feedback that must be combined with it, if any.
    pub feedback: Option<String>,
    /// Mark of the footnote stating that the actuator becomes longer; empty if it does not.
    #[serde(default)]
    pub longer: String,
}

/// Table references and properties of a winding.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Winding {
    /// The windings.
    pub words: Vec<String>,
    /// Table of general data.
    pub general: String,
    /// Heading of its columns.
    pub general_head: String,
    /// Condition of the row of I_NLS.
    pub starting_current: String,
    /// I_0 includes the friction: I_0 = T_0/k_Tout + I_NLS.
    pub stall_current_includes_friction: bool,
    /// The winding has an accessible PTC.
    pub ptc: bool,
    /// Feedbacks whose connector does not carry the KTY.
    #[serde(default)]
    pub without_kty: Vec<String>,
}

/// Properties of a feedback.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Feedback {
    /// The feedback.
    pub word: String,
    /// Kind supported by the engine.
    pub kind: String,
    /// Table of its data; empty if there is none.
    #[serde(default)]
    pub table: String,
}

/// Drives that head tables.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HeadingDrives {
    /// Headings, each with its size after the series.
    pub heads: Vec<String>,
    /// Windings that the headings apply to.
    pub windings: Vec<String>,
    /// Feedback systems that the headings apply to.
    pub feedbacks: Vec<String>,
}

/// Tables of connectors.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wiring {
    /// Windings.
    pub windings: Vec<String>,
    /// Feedback systems.
    pub feedbacks: Vec<String>,
    /// Tables of connector and pins of the motor, then of the feedback.
    pub tables: [String; 4],
}

impl Code {
    /// Returns the words of a field.
    #[must_use]
    pub fn words(&self, field: &str) -> &[String] {
        self.fields.iter().find(|known| known.id == field).map_or(&[], |known| &known.words)
    }

    /// Returns the index of a word in its field.
    #[must_use]
    pub fn place(&self, field: &str, word: &str) -> Option<usize> {
        self.words(field).iter().position(|known| known == word)
    }

    /// Returns the size named after the series in a heading: `20A` of `CHA-20A-C1024`.
    #[must_use]
    pub fn size_of<'h>(&self, head: &'h str) -> Option<&'h str> {
        head.strip_prefix(&self.series)?.strip_prefix('-')?.split('-').next()
    }

    /// Reports every rule that the file violates.
    pub(crate) fn check(&self, faults: &mut Vec<String>) {
        let at = format!("code.toml of {}", self.series);
        let mut seen: Vec<&str> = Vec::new();
        for field in &self.fields {
            if !FIELDS.contains(&field.id.as_str()) || seen.contains(&field.id.as_str()) {
                faults.push(format!("{at}: field `{}` is unknown or stands twice", field.id));
            }
            seen.push(&field.id);
            let known = |word: &String| field.words.contains(word);
            if field.words.is_empty() || field.words.len() > 64 || field.source.is_empty() {
                faults.push(format!("{at}: field `{}` needs a source, and 1 to 64 words", field.id));
            }
            let spelt =
                |word: &String| !word.is_empty() && word.bytes().all(|b| b.is_ascii_uppercase() || b.is_ascii_digit());
            for word in field.words.iter().filter(|word| !spelt(word)) {
                faults.push(format!("{at}: `{word}` has other characters than capitals and digits"));
            }
            for meaning in &field.meanings {
                let when =
                    meaning.when.iter().all(|(of, words)| words.iter().all(|word| self.words(of).contains(word)));
                if !meaning.word.as_ref().is_none_or(known) || !when {
                    faults.push(format!("{at}: a meaning of `{}` names an unknown word", field.id));
                }
            }
            let means = |word: Option<&String>| {
                field
                    .meanings
                    .iter()
                    .any(|each| each.when.is_empty() && (each.word.is_none() || each.word.as_ref() == word))
            };
            let absent = field.optional.then_some(None);
            if !field.words.iter().map(Some).chain(absent).all(means) {
                faults.push(format!("{at}: a word of `{}`, or its absence, has no meaning", field.id));
            }
        }
        for needed in FIELDS.iter().take(5) {
            if self.fields.iter().find(|field| field.id == *needed).is_none_or(|field| field.optional) {
                faults.push(format!("{at}: every code needs the field `{needed}`"));
            }
        }
        if self.fields.first().is_none_or(|first| first.words != [self.series.clone()]) {
            faults.push(format!("{at}: the first field is the series, with its one word"));
        }
        let mut all_known = |field: &str, words: &[String]| {
            for word in words.iter().filter(|word| !self.words(field).contains(word)) {
                faults.push(format!("{at}: unknown {field} `{word}`"));
            }
        };
        for drive in &self.drives {
            all_known("winding", &drive.windings);
            all_known("feedback", &drive.feedbacks);
            for head in &drive.heads {
                all_known("size", &[self.size_of(head).unwrap_or_default().to_owned()]);
            }
        }
        for wiring in &self.wirings {
            all_known("winding", &wiring.windings);
            all_known("feedback", &wiring.feedbacks);
        }
        for mark in &self.marks {
            all_known("feedback", mark.feedback.as_slice());
            let known = ["available", "on_request", "not_available"].contains(&mark.entry.as_str());
            if !known || mark.begins.is_empty() {
                all_known("entry of the matrix", std::slice::from_ref(&mark.entry));
            }
        }
        for word in self.words("winding") {
            if self.windings.iter().filter(|winding| winding.words.contains(word)).count() != 1 {
                faults.push(format!("{at}: winding `{word}` needs one entry"));
            }
        }
        for word in self.words("feedback") {
            let of = self.feedbacks.iter().filter(|feedback| feedback.word == *word);
            let kinds = of.map(|feedback| FEEDBACK_KINDS.contains(&feedback.kind.as_str()));
            if kinds.collect::<Vec<_>>() != [true] {
                faults.push(format!("{at}: feedback `{word}` needs one entry of a known kind"));
            }
        }
    }
}
