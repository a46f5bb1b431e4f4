//! Words without hyphens between them: all readings in the order of the fields, and one in any order.

use crate::field::Field;
use crate::grammar::{FieldWords, Series};
use std::ops::Range;

/// A word found in the text; the wildcard of a pattern has no token.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FoundWord {
    pub(crate) field: Field,
    pub(crate) token: Option<&'static str>,
    pub(crate) span: Range<usize>,
}

/// A word with its field and its byte offset.
pub(crate) type Step = (Field, &'static str, usize);

/// Returns all readings of `text`, or of a beginning of it, as words of `fields` in their order, each with its end.
///
/// A mandatory field is never skipped. A reading has at most one word per field, which bounds the search for any text.
pub(crate) fn readings(text: &str, fields: &[FieldWords]) -> Vec<(usize, Vec<Step>)> {
    let mut all = Vec::new();
    read_on(text, 0, fields, &mut Vec::new(), &mut all);
    all
}

fn read_on(text: &str, at: usize, fields: &[FieldWords], so_far: &mut Vec<Step>, all: &mut Vec<(usize, Vec<Step>)>) {
    if !so_far.is_empty() {
        all.push((at, so_far.clone()));
    }
    let rest = text.get(at..).unwrap_or_default();
    for (index, field) in fields.iter().enumerate() {
        for token in field.words {
            if rest.starts_with(token) {
                so_far.push((field.field, token, at));
                read_on(text, at + token.len(), fields.get(index + 1..).unwrap_or_default(), so_far, all);
                so_far.pop();
            }
        }
        if !field.is_optional {
            return;
        }
    }
}

/// Returns all readings of the whole of `text` as words of `fields` in their order.
pub(crate) fn complete_readings(text: &str, fields: &[FieldWords]) -> Vec<Vec<Step>> {
    readings(text, fields).into_iter().filter(|(end, _)| *end == text.len()).map(|(_, reading)| reading).collect()
}

/// Returns `text` as words of any fields in any order, in as few words as possible: the probable meaning of a code in
/// the wrong order. Several words of one letter each are more likely a typing error and are no reading.
pub(crate) fn in_any_order(text: &str, series: Series) -> Option<Vec<Step>> {
    // From the end: the least number of words for the rest at each offset, and the first of them.
    let mut fewest: Vec<Option<usize>> = vec![None; text.len()];
    fewest.push(Some(0));
    let mut first: Vec<Option<(Field, &'static str)>> = vec![None; text.len()];
    for (at, _) in text.char_indices().rev() {
        let rest = text.get(at..).unwrap_or_default();
        let fields = series.words_of_fields().iter();
        let words = fields.flat_map(|known| known.words.iter().map(|token| (known.field, *token)));
        let (first_byte, of) = (rest.bytes().next(), |token: &str| token.bytes().next());
        for word in words.filter(|(_, token)| of(token) == first_byte && rest.starts_with(token)) {
            let Some(count) = fewest.get(at + word.1.len()).copied().flatten() else { continue };
            if let (Some(least), Some(chosen)) = (fewest.get_mut(at), first.get_mut(at))
                && least.is_none_or(|least| count + 1 < least)
            {
                *least = Some(count + 1);
                *chosen = Some(word);
            }
        }
    }
    let mut steps = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let (field, token) = first.get(at).copied().flatten()?;
        steps.push((field, token, at));
        at += token.len();
    }
    (steps.len() == 1 || steps.iter().any(|(_, token, _)| token.len() > 1)).then_some(steps)
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn invented(field: Field, is_optional: bool, words: &'static [&'static str]) -> FieldWords {
        FieldWords { field, is_optional, words, kinds: &[], meanings: &[] }
    }

    #[test]
    fn the_search_finds_every_reading() {
        let fields = [
            invented(Field::Size, false, &["A", "AB"]),
            invented(Field::Brake, true, &["B"]),
            invented(Field::Winding, false, &["C", "BC"]),
        ];
        let found = complete_readings("ABC", &fields);
        let words: Vec<Vec<&str>> = found.iter().map(|reading| reading.iter().map(|step| step.1).collect()).collect();
        assert_eq!(words, [vec!["A", "B", "C"], vec!["A", "BC"], vec!["AB", "C"]]);
        assert!(complete_readings("AX", &fields).is_empty());
    }

    /// Words without hyphens have one reading at every start and for every choice of fields.
    #[test]
    fn no_run_of_words_has_two_readings() {
        fn all() -> &'static [FieldWords] {
            Series::default().words_of_fields()
        }
        fn walk(text: &str, from: usize, next: usize, runs: &mut usize) {
            if !text.is_empty() {
                let fields = all().get(from..).unwrap();
                assert_eq!(complete_readings(text, fields).len(), 1, "{text} from field {from}");
                *runs += 1;
            }
            for (index, field) in all().iter().enumerate().skip(next) {
                for token in field.words {
                    walk(&format!("{text}{token}"), from, index + 1, runs);
                }
                if !field.is_optional {
                    return;
                }
            }
        }
        let mut runs = 0;
        for from in 0..all().len() {
            walk("", from, from, &mut runs);
        }
        assert!(runs > 2 * 30_720, "{runs}");
    }

    #[test]
    fn any_order_takes_the_fewest_words() {
        let words = |text: &str| {
            in_any_order(text, Series::default()).map(|steps| steps.iter().map(|step| step.1).collect::<Vec<_>>())
        };
        assert_eq!(words("RES"), Some(vec!["RES"]));
        assert_eq!(words("C1024H"), Some(vec!["C1024", "H"]));
        assert_eq!(words("RE"), None, "a typing error, not option 2 and winding");
        assert_eq!(words("X"), None);
        assert_eq!(words(&"RES".repeat(21)).map(|all| all.len()), Some(21));
        assert_eq!(words("é"), None);
    }
}
