//! Proposal of the unit that was probably meant by a text that is none.

use crate::dimension::Dimension;
use crate::expression::{Meaning, meanings};
use crate::spelling::Canonical;
use crate::units::Unit;

/// Minimum length of a text for a proposal that differs in one letter.
const LETTERS_MIN: usize = 4;

/// Returns the unit of a dimension that was probably meant; `None` if a proposal could change a value.
pub(crate) fn of(dimension: Dimension, spelling: &str) -> Option<&'static Unit> {
    let written = Canonical::of(spelling);
    // `40/min` lacks the one before its slash.
    let with_one = written.text.starts_with('/').then(|| Unit::of_dimension(dimension, &format!("1{}", written.text)));
    if let Some(unit) = with_one.flatten() {
        return Some(unit);
    }
    let meant = meanings(&written);
    if !meant.is_empty() {
        return dimension.units().iter().find(|unit| meant.iter().all(|meaning| has_meaning(unit, *meaning)));
    }
    // mN and MN are equal in lower case: then neither is proposed.
    let small = written.text.to_lowercase();
    let alike = only(dimension, |known| known.text.to_lowercase() == small);
    let in_other_case = |unit: &&Unit| unit.spellings().any(|known| is_in_other_case(&written, &Canonical::of(known)));
    match alike {
        Some(unit) => Some(unit).filter(in_other_case),
        None => only(dimension, |known| is_a_letter_away(&written, known)),
    }
}

/// Returns `true` if a spelling of a unit has a meaning and the unit has its value.
fn has_meaning(unit: &Unit, meaning: Meaning) -> bool {
    let value = unit.to_si(1.0) - unit.to_si(0.0);
    (meaning.factor - value).abs() <= 1e-9 * value.abs()
        && unit.spellings().any(|known| meanings(&Canonical::of(known)).iter().any(|own| own.is(meaning)))
}

/// Returns the only unit with a spelling that satisfies a predicate.
fn only(dimension: Dimension, is_near: impl Fn(&Canonical) -> bool) -> Option<&'static Unit> {
    let near = |unit: &&Unit| unit.spellings().any(|known| is_near(&Canonical::of(known)));
    let mut found = dimension.units().iter().filter(near);
    found.next().filter(|_| found.next().is_none())
}

/// Returns `true` if the letters are those of a spelling in another case, unless an `m` that is a prefix stands for an
/// `M`.
fn is_in_other_case(written: &Canonical, known: &Canonical) -> bool {
    if written.text.to_lowercase() != known.text.to_lowercase() {
        return false;
    }
    let signs = known.text.char_indices().zip(written.text.chars());
    signs.into_iter().all(|((place, sign), found)| {
        let is_alone = known.text.len() == place + 1 || known.begins(place + 1);
        found == sign || !['m', 'M'].contains(&sign) || !known.begins(place) || is_alone
    })
}

/// Returns `true` if a text differs from a spelling by one letter inserted, missing, wrong or exchanged with the next.
/// The first letter of a name may be a prefix and must agree.
fn is_a_letter_away(written: &Canonical, known: &Canonical) -> bool {
    let (text, spelling) = (written.text.as_str(), known.text.as_str());
    if text.len() < LETTERS_MIN || spelling.len() + 1 < LETTERS_MIN || strsim::damerau_levenshtein(text, spelling) != 1
    {
        return false;
    }
    let common = text.char_indices().zip(spelling.chars()).find(|((_, one), other)| one != other);
    let place = common.map_or(text.len().min(spelling.len()), |((place, _), _)| place);
    let is_word = |text: &str| {
        let sign = text.get(place..).and_then(|rest| rest.chars().next());
        sign.is_none_or(char::is_alphabetic)
    };
    !known.begins(place) && is_word(text) && is_word(spelling)
}
