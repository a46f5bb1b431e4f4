//! Headings of a run that are not those of its columns: the nearest column, and the factor of its unit.

use quantities::{Dimension, Language, Unit, format_number, seen};
use recording::Records;
use std::io::Read;
use words::identification;

/// Largest number of headings shown.
const SHOWN_MOST: usize = 12;

/// Lines searched for the headings of a run below a preamble.
const SEARCHED: usize = 200;

/// Names of a signal in headings, in English and German, and its dimension.
struct Names {
    heading: &'static str,
    any: &'static [&'static str],
    dimension: Dimension,
}

const TURNING: &[&str] =
    &["speed", "velocity", "vel", "omega", "drehzahl", "geschwindigkeit", "winkelgeschwindigkeit", "rpm", "n"];

const NAMES: [Names; 6] = [
    Names { heading: "time_s", any: &["time", "zeit", "t", "timestamp", "zeitstempel"], dimension: Dimension::Time },
    Names {
        heading: "position_rad",
        any: &["position", "pos", "angle", "winkel", "lage", "q", "phi"],
        dimension: Dimension::Angle,
    },
    Names { heading: "speed_rad_s", any: TURNING, dimension: Dimension::AngularVelocity },
    Names { heading: "motor_speed_rad_s", any: TURNING, dimension: Dimension::AngularVelocity },
    Names { heading: "torque_nm", any: &["torque", "moment", "drehmoment", "m", "trq"], dimension: Dimension::Torque },
    Names { heading: "current_q_a", any: &["current", "strom", "iq", "i", "i_q"], dimension: Dimension::Current },
];

/// Returns the lower-case words of a heading before its unit, and the unit of a dimension.
fn parted(heading: &str, dimension: Dimension) -> (Vec<String>, Option<&'static Unit>) {
    let (bare, unit) = match heading.find(['[', '(', '{']) {
        Some(at) => {
            let (bare, rest) = heading.split_at(at);
            let unit = rest.trim_matches(['[', ']', '(', ')', '{', '}', ' ']);
            (bare, Unit::of_dimension(dimension, unit))
        }
        None => heading
            .match_indices(['_', ' '])
            .find_map(|(at, _)| {
                let (bare, rest) = heading.split_at(at);
                let text = rest.get(1..)?;
                let unit = Unit::of_dimension(dimension, text)
                    .or_else(|| Unit::of_dimension(dimension, &text.replace('_', "/")))?;
                Some((bare, Some(unit)))
            })
            .unwrap_or((heading, None)),
    };
    let words = bare.split(|sign: char| !sign.is_alphanumeric()).filter(|word| !word.is_empty());
    (words.map(str::to_lowercase).collect(), unit)
}

/// Returns `true` if words name the motor: `motor_speed`, `Motordrehzahl`.
fn of_motor(words: &[String]) -> bool {
    words.iter().any(|word| word.starts_with("motor"))
}

impl Names {
    /// Returns `true` if words name the signal, at its side of the gear.
    fn are_in(&self, words: &[String]) -> bool {
        let is_named = words.iter().any(|word| {
            let word = word.strip_prefix("motor").filter(|rest| !rest.is_empty()).unwrap_or(word);
            self.any.contains(&word)
        });
        is_named && of_motor(words) == self.heading.starts_with("motor")
    }
}

/// Returns the only heading that names the signal of a column in words with a unit, and the factor from this unit to that of the
/// column: `Motordrehzahl [1/min]`, `time_ms`. `None` if there is none, or more than one.
pub(super) fn meant(column: &str, headings: &[String]) -> Option<(usize, f64)> {
    let names = NAMES.iter().find(|names| names.heading == column)?;
    let mut found = headings.iter().enumerate().filter_map(|(at, heading)| {
        let (words, unit) = parted(heading, names.dimension);
        Some((at, unit.filter(|_| names.are_in(&words))?.to_si(1.0)))
    });
    let only = found.next()?;
    found.next().is_none().then_some(only)
}

/// Returns the heading that names a signal, with its unit.
fn named<'h>(names: &Names, headings: &'h [String]) -> Option<(&'h str, Option<&'static Unit>)> {
    let of_words = headings.iter().find_map(|heading| {
        let (words, unit) = parted(heading, names.dimension);
        // `i_q`, `t_s` and the like have one letter before their unit.
        names.are_in(&words).then_some((heading.as_str(), unit))
    });
    of_words.or_else(|| {
        let near = |heading: &&String| strsim::damerau_levenshtein(&heading.to_lowercase(), names.heading) <= 2;
        headings.iter().filter(|heading| heading.len() < 64).find(near).map(|heading| (heading.as_str(), None))
    })
}

/// Returns the content of the headings, and what to write for each column that lacks.
pub(super) fn proposed(lacking: &[&'static str], headings: &[String], language: Language) -> String {
    let mut shown: Vec<String> = headings.iter().take(SHOWN_MOST).map(|heading| quoted(heading)).collect();
    if headings.len() > SHOWN_MOST {
        shown.push("…".to_owned());
    }
    let mut text = identification::columns_of_the_file(&shown.join(", "), language);
    let renamed = lacking.iter().filter_map(|heading| {
        let names = NAMES.iter().find(|names| names.heading == *heading)?;
        let (written, unit) = named(names, headings)?;
        Some(match unit.and_then(factor) {
            Some(factor) => identification::heading_with_factor(
                heading,
                &quoted(written),
                &factor_shown(factor, language),
                language,
            ),
            None => identification::heading_instead(heading, &quoted(written), language),
        })
    });
    let renamed: Vec<String> = renamed.collect();
    if !renamed.is_empty() {
        text.push_str(&identification::headings_to_write(&renamed.join(", "), language));
    }
    text
}

/// Returns the factor from a unit to that of the column, if it is not one.
fn factor(unit: &Unit) -> Option<f64> {
    Some(unit.to_si(1.0)).filter(|factor| (factor - 1.0).abs() > 1e-12)
}

/// Returns a factor without trailing zeros: 0.001.
fn factor_shown(factor: f64, language: Language) -> String {
    let rounded: f64 = format!("{factor:.5e}").parse().unwrap_or(factor);
    let decimals = rounded.to_string().split_once('.').map_or(0, |(_, digits)| digits.len());
    format_number(rounded, decimals, language)
}

/// Smallest number of cells that are units of their columns in a row of units.
const UNITS_LEAST: usize = 2;

/// Returns the units of a row that holds no number but units, and are not those of the columns, in words; `None` if it is
/// no row of units.
pub(super) fn of_units<R: Read>(
    records: &mut Records<R>,
    heading_of: impl Fn(usize) -> Option<&'static str>,
    language: Language,
) -> Option<Vec<String>> {
    let (mut known, mut is_plain, mut others) = (0, true, Vec::new());
    records
        .numbers(|index, number, cell| {
            let Some(names) = heading_of(index).and_then(|own| NAMES.iter().find(|names| names.heading == own)) else {
                return;
            };
            is_plain &= number.is_none();
            let unit = cell.trim().trim_matches(['[', ']', '(', ')', '{', '}']).trim();
            let (heading, written) = (names.heading, quoted(unit));
            match Unit::of_dimension(names.dimension, unit) {
                Some(unit) => {
                    known += 1;
                    others.extend(factor(unit).map(|factor| {
                        identification::unit_with_factor(&heading, &written, &factor_shown(factor, language), language)
                    }));
                }
                // Alike in both languages.
                None => others.push(format!("{heading} in {written}")),
            }
        })
        .ok()?;
    (is_plain && known >= UNITS_LEAST).then_some(others)
}

/// Returns the number of a line further down that holds headings of a run.
pub(super) fn below<R: Read>(records: &mut Records<R>, known: impl Fn(&str) -> bool) -> Option<u64> {
    for _ in 0..SEARCHED {
        if !records.advance().ok()? {
            return None;
        }
        let line = records.text();
        let cells = line.split([';', ',', '\t', '|']).map(|cell| cell.trim().trim_matches('"'));
        if cells.filter(|cell| known(cell)).count() >= 2 {
            return Some(records.line());
        }
    }
    None
}

/// Returns `true` if a cell is a date or a time of day: `2026-11-27T08:30:00`, `27.11.2026 08:30`, `08:30:00,5`.
pub(super) fn is_clock(cell: &str) -> bool {
    let cell = cell.trim();
    let begins = cell.starts_with(|sign: char| sign.is_ascii_digit());
    let parts = |sign| cell.split(sign).filter(|part| part.starts_with(|sign: char| sign.is_ascii_digit())).count();
    let is_date = parts('-') == 3 && cell.len() >= 8 || parts('.') >= 3 || parts('/') == 3;
    begins && (cell.contains(':') || is_date)
}

fn quoted(heading: &str) -> String {
    format!("\"{}\"", seen(heading))
}
