//! Enumerating, completing and correcting ordering codes.

use crate::rules::{Availability, availability};
use order_code::{Brake, Feedback, Field, Option1, Option2, OrderCode, Pattern, Ratio, Size, Winding};
use std::sync::LazyLock;

static ALL: LazyLock<Vec<(OrderCode, Availability)>> = LazyLock::new(|| {
    let mut codes = Vec::new();
    for &size in Size::ALL {
        for &ratio in Ratio::ALL {
            for &winding in Winding::ALL {
                for &feedback in Feedback::ALL {
                    for brake in [Brake::Without, Brake::With] {
                        for option_1 in [None, Some(Option1::EC)] {
                            for option_2 in [None, Some(Option2::K), Some(Option2::R), Some(Option2::S)] {
                                let code = OrderCode {
                                    size,
                                    ratio,
                                    winding,
                                    feedback,
                                    brake,
                                    option_1,
                                    option_2,
                                    special: false,
                                };
                                if let Ok(found) = availability(&code) {
                                    codes.push((code, found));
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    codes
});

/// Every valid code with its availability, in the order of the fields.
///
/// The suffix SP is left out: it stands for any design to the customer's wish and could follow every code.
#[must_use]
pub fn all() -> &'static [(OrderCode, Availability)] {
    &ALL
}

/// The valid codes that a partial code allows.
pub fn complete(pattern: &Pattern) -> impl Iterator<Item = &'static (OrderCode, Availability)> + '_ {
    ALL.iter().filter(move |(code, _)| pattern.matches(code))
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

/// The words of a code in alphabetical order, so that two codes with the same words in another order are equal.
fn sorted_words(text: &str) -> String {
    let mut words: Vec<&str> = text.split('-').collect();
    words.sort_unstable();
    words.join("-")
}

/// The valid codes nearest to a text, by the number of letters to insert, delete, change or swap; words in the wrong
/// order count as one step.
///
/// Cost: two edit distances (some 20 × 20 steps each) per valid code.
#[must_use]
pub fn nearest(text: &str, most: usize) -> Vec<OrderCode> {
    let wanted: String = text.trim().to_uppercase().chars().take(40).collect();
    let wanted_words = sorted_words(&wanted);
    let mut scored: Vec<(usize, bool, OrderCode)> = ALL
        .iter()
        .map(|(code, availability)| {
            let text = code.to_string();
            let as_written = order_code::edit_distance(&wanted, &text);
            let reordered = 1 + order_code::edit_distance(&wanted_words, &sorted_words(&text));
            (as_written.min(reordered), !availability.is_available(), *code)
        })
        .collect();
    scored.sort();
    let best = scored.first().map_or(0, |(distance, _, _)| *distance);
    // A code that shares less than half of its letters is no help.
    let bound = (best + 1).min(wanted.chars().count() / 2);
    scored.into_iter().filter(|(distance, _, _)| *distance <= bound).take(most).map(|(_, _, code)| code).collect()
}
