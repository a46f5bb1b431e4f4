//! Enumerating, completing and correcting ordering codes.

use crate::rules::{Availability, BrokenRule, availability, looked_up};
use order_code::{Brake, Feedback, Field, Option1, Option2, OrderCode, Pattern, Ratio, Series, Size, Slot, Winding};
use std::sync::LazyLock;

/// Every code that can be written, whether it exists or not, without the special design.
static WRITABLE: LazyLock<Vec<OrderCode>> =
    LazyLock::new(|| Series::all().flat_map(|series| writable(series, true)).collect());

/// The codes of a series, those with options only where requested.
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

/// Every code without options that is available without asking, in the order of the fields.
pub(crate) fn plain() -> impl Iterator<Item = OrderCode> {
    let codes = Series::all().flat_map(|series| writable(series, false));
    codes.filter(|code| availability(code).is_ok_and(|found| found.is_available()))
}

/// Those of [`ALL`] as special designs.
static SPECIAL: LazyLock<Vec<(OrderCode, Availability)>> = LazyLock::new(|| {
    let special = ALL.iter().map(|(code, _)| OrderCode { special: true, ..*code });
    special.filter_map(|code| Some((code, availability(&code).ok()?))).collect()
});

/// Every valid code with its availability, in the order of the fields.
///
/// The special design is left out: it stands for any design to the customer's wish and could follow every code.
#[must_use]
pub fn all() -> &'static [(OrderCode, Availability)] {
    &ALL
}

/// The valid codes that a partial code allows; special designs only where it names the special design.
pub fn complete(pattern: &Pattern) -> impl Iterator<Item = &'static (OrderCode, Availability)> + '_ {
    let codes = if pattern.special == Slot::Exactly(true) { &SPECIAL } else { &ALL };
    codes.iter().filter(move |(code, _)| pattern.matches(code))
}

/// Why a partial code allows no code: the rules that every code with its words breaks. Where no single one is broken by
/// all of them, those of the codes that break the fewest, for each size in turn. Each with a code that breaks it; nothing
/// if the partial code allows one.
#[must_use]
pub fn broken_by_all(pattern: &Pattern) -> Vec<(OrderCode, BrokenRule)> {
    let plain = Pattern { special: Slot::Any, ..*pattern };
    if complete(&plain).next().is_some() {
        return Vec::new();
    }
    let found: Vec<(OrderCode, Vec<BrokenRule>)> =
        WRITABLE.iter().filter(|code| plain.matches(code)).map(|code| (*code, looked_up(code).1)).collect();
    // The code that breaks the fewest stands for all.
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

/// The words that the valid codes of each size have.
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

/// The words of a field that some valid code of a size has.
#[must_use]
pub fn tokens_of_size(field: Field, size: Size) -> &'static [&'static str] {
    if field == Field::Special {
        return size.series().words(field);
    }
    let found = TOKENS.iter().find(|(of, known, _)| (*of, *known) == (field, size));
    found.map(|(_, _, tokens)| tokens.as_slice()).unwrap_or_default()
}

/// What may stand at one field of a partial code.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The token; empty where the field may be left out.
    pub token: &'static str,
    /// Whether at least one code with it is available without asking.
    pub available: bool,
}

/// For each field, what may stand there in the codes that a partial code allows.
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
