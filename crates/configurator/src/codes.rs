//! Lists, completion and correction of ordering codes.

use crate::rules::{Availability, BrokenRule, availability, looked_up};
use order_code::{Brake, Feedback, Field, Option1, Option2, OrderCode, Pattern, Ratio, Series, Size, Slot, Winding};
use std::sync::LazyLock;

/// Combinations of words without the special design, valid or not.
static WRITABLE: LazyLock<Vec<OrderCode>> =
    LazyLock::new(|| Series::all().flat_map(|series| writable(series, true)).collect());

/// Returns all combinations of words of a series, with options only if `with_options`.
fn writable(series: Series, with_options: bool) -> Vec<OrderCode> {
    let brakes = if series.words(Field::Brake).is_empty() { &[Brake::Without] } else { Brake::ALL };
    let most = if with_options { usize::MAX } else { 0 };
    let options_1 = || std::iter::once(None).chain(Option1::all(series).take(most).map(Some));
    let options_2 = || std::iter::once(None).chain(Option2::all(series).take(most).map(Some));
    let mut codes = Vec::new();
    for size in Size::all(series) {
        for ratio in Ratio::all(series) {
            for winding in Winding::all(series) {
                for feedback in Feedback::all(series) {
                    for &brake in brakes {
                        for option_1 in options_1() {
                            let code = |option_2| OrderCode {
                                size,
                                ratio,
                                winding,
                                feedback,
                                brake,
                                option_1,
                                option_2,
                                special: false,
                            };
                            codes.extend(options_2().map(code));
                        }
                    }
                }
            }
        }
    }
    codes
}

static ALL: LazyLock<Vec<(OrderCode, Availability)>> =
    LazyLock::new(|| WRITABLE.iter().filter_map(|code| Some((*code, availability(code).ok()?))).collect());

/// Iterates over the codes without options that are available without request, in the order of the fields.
pub(crate) fn plain() -> impl Iterator<Item = OrderCode> {
    Series::all().flat_map(|series| writable(series, false)).filter(is_plain)
}

/// Returns `true` for a code without options that is available without request.
pub(crate) fn is_plain(code: &OrderCode) -> bool {
    let bare = code.option_1.is_none() && code.option_2.is_none() && !code.special;
    bare && availability(code).is_ok_and(|found| found.is_available())
}

/// Codes of [`ALL`] as special designs.
static SPECIAL: LazyLock<Vec<(OrderCode, Availability)>> = LazyLock::new(|| {
    let special = ALL.iter().map(|(code, _)| OrderCode { special: true, ..*code });
    special.filter_map(|code| Some((code, availability(&code).ok()?))).collect()
});

/// Returns all valid codes with their availability, in the order of the fields.
///
/// The special design is omitted: it stands for any design to customer specification and could follow every code.
#[must_use]
pub fn all() -> &'static [(OrderCode, Availability)] {
    &ALL
}

/// Iterates over the valid codes that a partial code allows; special designs only if it names the special design.
pub fn complete(pattern: &Pattern) -> impl Iterator<Item = &'static (OrderCode, Availability)> + '_ {
    let codes = if pattern.special == Slot::Exactly(true) { &SPECIAL } else { &ALL };
    codes.iter().filter(move |(code, _)| pattern.matches(code))
}

/// Returns the rules that exclude every code allowed by a partial code, each with a code that breaks it; empty if the
/// partial code allows an valid code. These are the rules broken by all its codes or, if there is none, those
/// broken by the code with the fewest broken rules of each size.
#[must_use]
pub fn broken_by_all(pattern: &Pattern) -> Vec<(OrderCode, BrokenRule)> {
    let mut plain = *pattern;
    plain.special = Slot::Any;
    if complete(&plain).next().is_some() {
        return Vec::new();
    }
    let found: Vec<(OrderCode, Vec<BrokenRule>)> =
        WRITABLE.iter().filter(|code| plain.matches(code)).map(|code| (*code, looked_up(code).1)).collect();
    // The code with the fewest broken rules represents all of them.
    let Some((code, rules)) = found.iter().min_by_key(|(_, broken)| broken.len()) else { return Vec::new() };
    let of_all = |rule: &BrokenRule| found.iter().all(|(_, broken)| broken.contains(rule));
    let common: Vec<(OrderCode, BrokenRule)> =
        rules.iter().filter(|rule| of_all(rule)).map(|rule| (*code, *rule)).collect();
    if !common.is_empty() {
        return common;
    }
    let best = |size: &Size| found.iter().filter(|(code, _)| code.size == *size).min_by_key(|(_, broken)| broken.len());
    let each = sizes().filter_map(|size| best(&size));
    each.flat_map(|(code, broken)| broken.iter().map(|rule| (*code, *rule))).collect()
}

/// Words that occur in the valid codes of each size, by field.
static TOKENS: LazyLock<Vec<(Field, Size, Vec<&'static str>)>> = LazyLock::new(|| {
    let of_size = |field: Field, size: Size| {
        let stands = |token: &&str| ALL.iter().any(|(code, _)| code.size == size && code.token(field) == Some(token));
        (field, size, size.series().words(field).iter().copied().filter(stands).collect())
    };
    Field::ALL.iter().flat_map(|field| sizes().map(move |size| of_size(*field, size))).collect()
});

fn sizes() -> impl Iterator<Item = Size> {
    Series::all().flat_map(Size::all)
}

/// Returns the words of a field that occur in at least one valid code of a size.
#[must_use]
pub fn tokens_of_size(field: Field, size: Size) -> &'static [&'static str] {
    if field == Field::Special {
        return size.series().words(field);
    }
    let found = TOKENS.iter().find(|(of, known, _)| (*of, *known) == (field, size));
    found.map(|(_, _, tokens)| tokens.as_slice()).unwrap_or_default()
}

/// A word allowed at one field of a partial code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Word; empty if the field may be omitted.
    pub token: &'static str,
    /// At least one code with this word is available without request.
    pub available: bool,
}

/// Returns, for each field, the words that occur in the valid codes allowed by a partial code.
#[must_use]
pub fn choices(pattern: &Pattern) -> Vec<(Field, Vec<Choice>)> {
    let codes: Vec<&(OrderCode, Availability)> = complete(pattern).collect();
    Field::ALL
        .iter()
        .copied()
        .filter(|field| !matches!(field, Field::Series | Field::Special))
        .map(|field| {
            let mut found: Vec<Choice> = Vec::new();
            for (code, availability) in codes.iter().copied() {
                let token = code.token(field).unwrap_or("");
                let ready = !availability.on_request.contains(&field);
                match found.iter_mut().find(|choice| choice.token == token) {
                    Some(choice) => choice.available |= ready,
                    None => found.push(Choice { token, available: ready }),
                }
            }
            (field, found)
        })
        .collect()
}
