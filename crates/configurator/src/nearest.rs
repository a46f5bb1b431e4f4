//! The valid codes nearest to one that does not exist.

use crate::codes::all;
use crate::rules::Availability;
use order_code::{Brake, Field, OrderCode, Size, Winding};

/// A valid code with data, and its availability.
type Known = (OrderCode, Availability);

/// The valid codes that the manual prints data for.
fn with_data() -> impl Iterator<Item = &'static Known> {
    all().iter().filter(|(code, _)| catalogue::drive(code.size, code.winding, code.feedback).is_some())
}

/// The words of a code in alphabetical order, so that two codes with the same words in another order are equal.
fn sorted_words(text: &str) -> String {
    let mut words: Vec<&str> = text.split('-').collect();
    words.sort_unstable();
    words.join("-")
}

/// The valid codes nearest to a misspelt text, by the number of letters to insert, delete, change or swap; words in the
/// wrong order count as one step. Only codes with data, and with all the words that were understood if there are such; of
/// several as near, those available without asking first.
///
/// Cost: two edit distances (some 20 × 20 steps each) per valid code.
#[must_use]
pub fn nearest(text: &str, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let wanted: String = text.trim().to_uppercase().chars().take(40).collect();
    let wanted_words = sorted_words(&wanted);
    let understood: Vec<(Field, &str)> = match order_code::parse(text) {
        Err(faults) => Field::ALL.iter().filter_map(|field| Some((*field, faults.understood(*field)?))).collect(),
        Ok(_) => Vec::new(),
    };
    let keeps = |(code, _): &&Known| {
        understood.iter().all(|(field, word)| *field == Field::Special || code.token(*field) == Some(word))
    };
    let mut kept: Vec<&Known> = with_data().filter(keeps).collect();
    if kept.is_empty() {
        kept = with_data().collect();
    }
    let mut scored: Vec<(usize, bool, &Known)> = kept
        .into_iter()
        .map(|known| {
            let text = known.0.to_string();
            let as_written = order_code::edit_distance(&wanted, &text);
            let reordered = 1 + order_code::edit_distance(&wanted_words, &sorted_words(&text));
            (as_written.min(reordered), !known.1.is_available(), known)
        })
        .collect();
    scored.sort_by_key(|(distance, asked, (code, _))| (*distance, *asked, *code));
    let best = scored.first().map_or(0, |(distance, ..)| *distance);
    // A code that shares less than half of its letters is no help.
    let bound = (best + 1).min(wanted.chars().count() / 2);
    scored.into_iter().filter(|(distance, ..)| *distance <= bound).take(most).map(|(_, _, known)| known).collect()
}

/// The valid codes nearest to a well-spelt one that breaks a rule, by what the actuator is: how far its ratio and size are,
/// and which fields differ. Only codes with data; of several as near, those available without asking first.
#[must_use]
pub fn nearest_to(wanted: &OrderCode, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let mut scored: Vec<(f64, &Known)> = with_data().map(|known| (distance(wanted, &known.0), known)).collect();
    scored.sort_by(|(a, one), (b, other)| {
        let asked = |known: &Known| !known.1.is_available();
        a.total_cmp(b).then_with(|| (asked(one), one.0).cmp(&(asked(other), other.0)))
    });
    scored.into_iter().take(most).map(|(_, known)| known).collect()
}

/// How unlike two actuators are. The weights are ours and order nothing but the proposals: another brake or supply voltage
/// is another machine, a connector is not, and what nobody asked for is not proposed; a step in size weighs as much as a factor of 2.7 in the ratio.
fn distance(a: &OrderCode, b: &OrderCode) -> f64 {
    let one_if = |differs: bool, weight: f64| if differs { weight } else { 0.0 };
    let place = |size: Size| Size::ALL.iter().position(|known| *known == size).unwrap_or(0);
    let steps = place(a.size).abs_diff(place(b.size));
    let ratio = (f64::from(a.ratio.value()) / f64::from(b.ratio.value())).ln().abs();
    let same_voltage = (a.winding == Winding::E) == (b.winding == Winding::E);
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

    #[test]
    fn every_proposal_has_data() {
        for (code, _) in nearest("CHA-20A-100-H-REX", 40) {
            assert!(catalogue::drive(code.size, code.winding, code.feedback).is_some(), "{code}");
            assert!(code.to_string().starts_with("CHA-20A-100-H"), "what was understood is kept: {code}");
        }
    }
}
