//! Hyphenation of long German words at the end of a line.

use std::borrow::Cow;

/// Longest word that is never divided, in letters.
const WHOLE: usize = 14;

/// First parts of compounds in the names of keys.
const PARTS: &[&str] = &[
    "abschalt",
    "abtast",
    "abtriebs",
    "anlauf",
    "ansprech",
    "antriebs",
    "anwendungs",
    "ausschalt",
    "außen",
    "bemessungs",
    "beschleunigungs",
    "betriebs",
    "bewegungs",
    "brems",
    "daten",
    "dauer",
    "drehmoment",
    "drehzahl",
    "effektiv",
    "eingriffs",
    "einschalt",
    "entmagneti",
    "feedback",
    "gerad",
    "geschwindigkeits",
    "getriebe",
    "gewichts",
    "gewinde",
    "hersteller",
    "hohlwellen",
    "hysterese",
    "innen",
    "kipp",
    "klemmen",
    "kondensator",
    "kurzzeit",
    "leerlauf",
    "leistungs",
    "losbrech",
    "massen",
    "motor",
    "scheren",
    "schrägungs",
    "spannungs",
    "spitzen",
    "steifigkeits",
    "stillstands",
    "strom",
    "temperatur",
    "torsions",
    "trommel",
    "trägheits",
    "umgebungs",
    "unausge",
    "wickel",
    "winkel",
    "wort",
    "zwischenkreis",
    "übertragungs",
];

/// Returns the text with soft hyphens (U+00AD) in its long compounds, where browsers without a German dictionary divide
/// them.
#[must_use]
pub fn hyphenated(text: &str) -> Cow<'_, str> {
    if text.split(|sign: char| !sign.is_alphabetic()).all(|word| word.chars().count() <= WHOLE) {
        return Cow::Borrowed(text);
    }
    let words = text.split_inclusive(|sign: char| !sign.is_alphabetic());
    Cow::Owned(words.map(|word| divided(word).unwrap_or_else(|| word.to_owned())).collect())
}

fn divided(word: &str) -> Option<String> {
    let letters = word.trim_end_matches(|sign: char| !sign.is_alphabetic()).chars().count();
    // Byte offsets are valid for both spellings only if lower case has the same length.
    let lower = Some(word.to_lowercase()).filter(|lower| letters > WHOLE && lower.len() == word.len())?;
    let ends = |part: &'static &'static str| {
        lower.match_indices(*part).map(|(at, found)| at + found.len()).collect::<Vec<_>>()
    };
    let mut places: Vec<usize> = PARTS.iter().flat_map(ends).collect();
    places.sort_unstable();
    places.dedup();
    // At least three letters stand on the next line.
    places.retain(|at| {
        word.get(*at..).is_some_and(|rest| rest.chars().take_while(|sign| sign.is_alphabetic()).count() >= 3)
    });
    let mut out = String::with_capacity(word.len() + 2 * places.len());
    let mut from = 0;
    for at in places {
        out.push_str(word.get(from..at)?);
        out.push('\u{ad}');
        from = at;
    }
    out.push_str(word.get(from..)?);
    Some(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_compounds_are_divided_where_their_parts_meet() {
        for (word, wanted) in [
            ("Massenträgheitsmoment", "Massen|trägheits|moment"),
            ("Leerlaufstromkonstante bei 20 °C", "Leerlauf|strom|konstante bei 20 °C"),
            ("(Zwischenkreisspannung)", "(Zwischenkreis|spannung)"),
            ("Drehzahl, Motor", "Drehzahl, Motor"),
            ("moment of inertia", "moment of inertia"),
            ("Abtriebsflansch", "Abtriebs|flansch"),
            ("Spitzendrehmoment", "Spitzen|drehmoment"),
            ("Entmagnetisierung", "Entmagneti|sierung"),
            ("Übertragungsgenauigkeit", "Übertragungs|genauigkeit"),
        ] {
            assert_eq!(hyphenated(word).replace('\u{ad}', "|"), wanted);
            assert_eq!(hyphenated(word).replace('\u{ad}', ""), word);
        }
    }
}
