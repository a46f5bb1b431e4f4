//! Proposals for an invalid code: the valid codes nearest to it.

use crate::codes::all;
use crate::rules::Availability;
use order_code::{Brake, Field, OrderCode, Pattern};
use std::sync::LazyLock;
use strsim::osa_distance;

/// A valid code with data, and its availability.
type Known = (OrderCode, Availability);

/// A valid code with its canonical spelling, and with its words in alphabetical order.
struct Indexed {
    known: &'static Known,
    text: String,
    sorted: String,
}

/// The valid codes for which the manual states data, in the order of the fields.
static WITH_DATA: LazyLock<Vec<Indexed>> = LazyLock::new(|| {
    let has_data = |(code, _): &&Known| catalogue::drive(code.size, code.winding, code.feedback).is_some();
    let indexed = |known: &'static Known| {
        let text = known.0.to_string();
        Indexed { known, sorted: sorted_words(&text), text }
    };
    all().iter().filter(has_data).map(indexed).collect()
});

/// Length of the shortest code, `CHA-14A-30-H-RES`.
const LENGTH_MIN: usize = 16;

/// Number of characters of a misspelt text that are compared.
const LENGTH_MAX: usize = 40;

/// Returns the words of a code in alphabetical order: equal for two codes with the same words in another order.
fn sorted_words(text: &str) -> String {
    let mut words: Vec<&str> = text.split('-').collect();
    words.sort_unstable();
    words.join("-")
}

/// Returns the valid codes nearest to a misspelt text, by the number of characters to insert, delete, replace or swap
/// with their neighbour; words in the wrong order count as one step.
///
/// Proposed are codes with data that have every word that was understood or, if there are none, all words but one; of
/// equally near codes those available without request come first. A code further away than half of its characters is
/// not proposed.
///
/// Cost: two edit distances for each code that has the words understood.
#[must_use]
pub fn nearest(text: &str, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let wanted: String = text.trim().to_uppercase().chars().take(LENGTH_MAX).collect();
    let wanted_sorted = sorted_words(&wanted);
    let distance_max = wanted.chars().count().max(LENGTH_MIN) / 2;
    let pattern = kept(text);
    let distance =
        |entry: &Indexed| osa_distance(&wanted, &entry.text).min(1 + osa_distance(&wanted_sorted, &entry.sorted));
    let candidates = WITH_DATA.iter().filter(|entry| pattern.matches(&entry.known.0));
    let mut scored: Vec<(usize, bool, &Known)> =
        candidates.map(|entry| (distance(entry), !entry.known.1.is_available(), entry.known)).collect();
    scored.sort_by_key(|(distance, on_request, (code, _))| (*distance, *on_request, *code));
    let best = scored.first().map_or(0, |(distance, ..)| *distance);
    let limit = distance_max.min(best + 1);
    scored.into_iter().take_while(|(distance, ..)| *distance <= limit).take(most).map(|(.., known)| known).collect()
}

/// Returns the words of a text that proposals keep: all that were understood, if a code has them. Otherwise one of them
/// contradicts the others, and the word least specific to the machine is dropped first. No code here is a special
/// design.
fn kept(text: &str) -> Pattern {
    let Err(faults) = order_code::parse(text) else { return Pattern::default() };
    let without = |left_out: Option<Field>| {
        Pattern::of(faults.series(), |field| {
            faults.understood(field).filter(|_| field != Field::Special && Some(field) != left_out)
        })
    };
    let is_known = |pattern: &Pattern| WITH_DATA.iter().any(|entry| pattern.matches(&entry.known.0));
    std::iter::once(None)
        .chain(Field::ALL.iter().rev().map(|field| Some(*field)))
        .map(without)
        .find(is_known)
        .unwrap_or_default()
}

/// Returns at most `most` valid codes nearest to a well-spelt code that breaks a rule, by the difference of size and
/// ratio and by the fields that differ. Only codes with data are returned; among equally near codes, those available
/// without request come first.
#[must_use]
pub fn nearest_to(wanted: &OrderCode, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let of_series = WITH_DATA.iter().filter(|entry| entry.known.0.series() == wanted.series());
    let mut scored: Vec<(f64, &Known)> =
        of_series.map(|entry| (distance(wanted, &entry.known.0), entry.known)).collect();
    let order = |(a, one): &(f64, &Known), (b, other): &(f64, &Known)| {
        let asked = |known: &Known| !known.1.is_available();
        a.total_cmp(b).then_with(|| (asked(one), one.0).cmp(&(asked(other), other.0)))
    };
    // Only the codes returned are sorted.
    if most < scored.len() {
        scored.select_nth_unstable_by(most, order);
        scored.truncate(most);
    }
    scored.sort_by(order);
    scored.into_iter().take(most).map(|(_, known)| known).collect()
}

/// Returns the dissimilarity of two actuators \[1\]. The weights are chosen by antrieb and affect only the order of
/// the proposals: another brake or supply voltage is another machine, a connector is not, and options that were not
/// required are not proposed; a step in size weighs as much as a factor of 2.7 in the ratio.
fn distance(a: &OrderCode, b: &OrderCode) -> f64 {
    let one_if = |differs: bool, weight: f64| if differs { weight } else { 0.0 };
    let steps = a.size.place().abs_diff(b.size.place());
    let ratio = (f64::from(a.ratio.value()) / f64::from(b.ratio.value())).ln().abs();
    let general = |code: &OrderCode| catalogue::winding_data(code.winding).map(|data| data.general);
    let same_voltage = general(a) == general(b);
    one_if(steps > 0, 1.0)
        + 2.0 * f64::from(u8::try_from(steps).unwrap_or(u8::MAX))
        + one_if(a.ratio != b.ratio, 1.0)
        + 2.0 * ratio
        + one_if(a.winding != b.winding, if same_voltage { 1.0 } else { 3.0 })
        + one_if(a.feedback != b.feedback, 2.0)
        + one_if((a.brake == Brake::With) != (b.brake == Brake::With), 3.0)
        + one_if(a.option_1 != b.option_1, 2.0)
        + one_if(a.option_2 != b.option_2, if b.option_2.is_some() { 3.0 } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn proposals(text: &str) -> Vec<String> {
        let code = order_code::parse(text).unwrap().code;
        nearest_to(&code, 3).iter().map(|(code, _)| code.to_string()).collect()
    }

    #[test]
    fn what_cannot_be_keeps_what_can() {
        assert_eq!(
            proposals("CHA-20A-100-L-C1024-B"),
            ["CHA-20A-100-H-C1024-B", "CHA-20A-120-H-C1024-B", "CHA-20A-80-H-C1024-B"]
        );
        assert_eq!(proposals("CHA-40A-30-H-C1024"), ["CHA-40A-50-H-C1024", "CHA-40A-80-H-C1024", "CHA-32A-30-H-C1024"]);
        assert_eq!(proposals("CHA-14A-120-H-D2048").first().unwrap(), "CHA-14A-100-N-D2048");
    }

    /// 25A has no 48 V winding: size and ratio are kept, the winding is not.
    #[test]
    fn a_word_that_contradicts_the_others_goes() {
        let found = |text: &str| -> Vec<String> { nearest(text, 3).iter().map(|(code, _)| code.to_string()).collect() };
        let of_25 = found("CHA-25A-100-E");
        assert!(!of_25.is_empty() && of_25.iter().all(|code| code.starts_with("CHA-25A-100-")), "{of_25:?}");
        let of_20 = found("CHA-20A-100-H-C1024-EC-X");
        assert!(of_20.iter().all(|code| code.starts_with("CHA-20A-100-H-C1024")), "{of_20:?}");
        assert_eq!(found("CHA"), [""; 0], "too little to say anything");
        assert_eq!(WITH_DATA.iter().map(|entry| entry.text.len()).min(), Some(LENGTH_MIN));
    }

    #[test]
    fn every_proposal_has_data() {
        for (code, _) in nearest("CHA-20A-100-H-REX", 40) {
            assert!(catalogue::drive(code.size, code.winding, code.feedback).is_some(), "{code}");
            assert!(code.to_string().starts_with("CHA-20A-100-H"), "what was understood is kept: {code}");
        }
    }

    /// Every code with data in which one character is missing, doubled, swapped with its neighbour or replaced leads to itself.
    #[test]
    fn one_slip_leads_back_to_the_code() {
        for (place, entry) in WITH_DATA.iter().enumerate().step_by(37) {
            let letters: Vec<char> = entry.text.chars().collect();
            let at = 4 + place % (letters.len() - 5);
            let mut slips = vec![letters.clone(), letters.clone(), letters.clone(), letters.clone()];
            slips[0].remove(at);
            slips[1].insert(at, letters[at]);
            slips[2].swap(at, at + 1);
            slips[3][at] = '?';
            for slip in slips {
                let text: String = slip.into_iter().collect();
                if order_code::parse(&text).is_err() {
                    let found = nearest(&text, 40);
                    assert!(
                        found.iter().any(|(code, _)| *code == entry.known.0),
                        "{text}: {} is not in {found:?}",
                        entry.text
                    );
                }
            }
        }
    }

    /// Words in the wrong order count as one step, for any words between them.
    #[test]
    fn words_in_another_order_are_near() {
        let found = nearest("CHA-H-20A-C1042-100", 1);
        assert_eq!(found.first().map(|(code, _)| code.to_string()).as_deref(), Some("CHA-20A-100-H-C1024"));
    }
}
