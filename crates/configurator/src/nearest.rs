//! The valid codes nearest to one that does not exist.

use crate::codes::all;
use crate::rules::Availability;
use order_code::{Brake, Distances, Field, OrderCode, Size, Winding};
use std::sync::LazyLock;

/// A valid code with data, and its availability.
type Known = (OrderCode, Availability);

/// What a search must know of a code, worked out once.
struct Entry {
    known: &'static Known,
    text: String,
    /// Its words in alphabetical order.
    sorted: String,
    letters: Letters,
}

/// The valid codes that the manual prints data for.
static WITH_DATA: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let has_data = |(code, _): &&Known| catalogue::drive(code.size, code.winding, code.feedback).is_some();
    let entry = |known: &'static Known| {
        let text = known.0.to_string();
        Entry { known, sorted: sorted_words(&text), letters: Letters::of(&text), text }
    };
    all().iter().filter(has_data).map(entry).collect()
});

/// The words of a code in alphabetical order, so that two codes with the same words in another order are equal.
fn sorted_words(text: &str) -> String {
    let mut words: Vec<&str> = text.split('-').collect();
    words.sort_unstable();
    words.join("-")
}

/// How often each letter, digit and hyphen stands in a text, and how many other characters.
struct Letters {
    counts: [u8; 37],
    others: usize,
}

impl Letters {
    fn of(text: &str) -> Self {
        let mut letters = Self { counts: [0; 37], others: 0 };
        for letter in text.chars() {
            let place = match letter {
                'A'..='Z' => u32::from(letter) - u32::from('A'),
                '0'..='9' => u32::from(letter) - u32::from('0') + 26,
                '-' => 36,
                _ => u32::MAX,
            };
            match usize::try_from(place).ok().and_then(|place| letters.counts.get_mut(place)) {
                Some(count) => *count = count.saturating_add(1),
                None => letters.others += 1,
            }
        }
        letters
    }

    /// The distance of two texts is at least this: a letter that only one of them has costs a step, whatever the order.
    fn distance_at_least(&self, other: &Self) -> usize {
        let excess = |one: &Self, than: &Self| {
            let more = one.counts.iter().zip(&than.counts).map(|(one, than)| one.saturating_sub(*than));
            more.map(usize::from).sum::<usize>() + one.others
        };
        excess(self, other).max(excess(other, self))
    }
}

/// The valid codes nearest to a misspelt text, by the number of letters to insert, delete, change or swap; words in the
/// wrong order count as one step. Only codes with data, and with all the words that were understood if there are such; of
/// several as near, those available without asking first.
///
/// Cost: a count of letters per valid code; two edit distances for each that may be near by it.
#[must_use]
pub fn nearest(text: &str, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let wanted: String = text.trim().to_uppercase().chars().take(40).collect();
    // Every code has the series, none of these is a special design.
    let telling = Field::ALL.iter().filter(|field| !matches!(field, Field::Series | Field::Special));
    let understood: Vec<(Field, &str)> = match order_code::parse(text) {
        Err(faults) => telling.filter_map(|field| Some((*field, faults.understood(*field)?))).collect(),
        Ok(_) => Vec::new(),
    };
    let keeps = |code: &OrderCode| understood.iter().all(|(field, word)| code.token(*field) == Some(word));
    let mut kept: Vec<&Entry> = WITH_DATA.iter().filter(|entry| keeps(&entry.known.0)).collect();
    if kept.is_empty() {
        kept = WITH_DATA.iter().collect();
    }
    // A code that shares less than half of its letters is no help.
    let half = wanted.chars().count() / 2;
    let letters = Letters::of(&wanted);
    let at_least = kept.into_iter().map(|entry| (entry.letters.distance_at_least(&letters), entry));
    let near: Vec<(usize, &Entry)> = at_least.filter(|(least, _)| *least <= half).collect();
    let mut written = Distances::from(&wanted);
    let mut reordered = Distances::from(&sorted_words(&wanted));
    let mut score = |least: usize, entry: &Entry, most: usize| {
        let as_written = written.within(&entry.text, most);
        // As many steps as the letters ask for at least, or one more: other words in another order are not nearer.
        if as_written.is_some_and(|steps| steps <= least + 1) || most == 0 {
            return as_written;
        }
        let in_order = reordered.within(&entry.sorted, most - 1).map(|steps| steps + 1);
        as_written.into_iter().chain(in_order).min()
    };
    // Those with the fewest letters apart tell how near the best one is at most, the others are looked at within that.
    let fewest = near.iter().map(|(least, _)| *least).min().unwrap_or(0);
    let mut scored: Vec<(usize, bool, &Known)> = Vec::new();
    let mut bound = half;
    for first in [true, false] {
        for (least, entry) in near.iter().filter(|(least, _)| (*least == fewest) == first) {
            if *least > bound {
                continue;
            }
            let Some(distance) = score(*least, entry, bound) else { continue };
            bound = bound.min(distance + 1);
            scored.push((distance, !entry.known.1.is_available(), entry.known));
        }
    }
    scored.retain(|(distance, ..)| *distance <= bound);
    scored.sort_by_key(|(distance, asked, (code, _))| (*distance, *asked, *code));
    scored.into_iter().take(most).map(|(_, _, known)| known).collect()
}

/// The valid codes nearest to a well-spelt one that breaks a rule, by what the actuator is: how far its ratio and size are,
/// and which fields differ. Only codes with data; of several as near, those available without asking first.
#[must_use]
pub fn nearest_to(wanted: &OrderCode, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let mut scored: Vec<(f64, &Known)> =
        WITH_DATA.iter().map(|entry| (distance(wanted, &entry.known.0), entry.known)).collect();
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

    /// Enough for every way through the search; a comparison with every code takes tens of milliseconds.
    const CASES: usize = 40;

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

    /// What [`nearest`] is to find, found by comparing with every code.
    fn nearest_of_all(text: &str, most: usize) -> Vec<&'static Known> {
        let wanted: String = text.trim().to_uppercase().chars().take(40).collect();
        let wanted_words = sorted_words(&wanted);
        let understood: Vec<(Field, &str)> = match order_code::parse(text) {
            Err(faults) => Field::ALL.iter().filter_map(|field| Some((*field, faults.understood(*field)?))).collect(),
            Ok(_) => Vec::new(),
        };
        let keeps = |(code, _): &&Known| {
            understood.iter().all(|(field, word)| *field == Field::Special || code.token(*field) == Some(word))
        };
        let with_data = || WITH_DATA.iter().map(|entry| entry.known);
        let mut kept: Vec<&Known> = with_data().filter(keeps).collect();
        if kept.is_empty() {
            kept = with_data().collect();
        }
        let score = |known: &'static Known| {
            let text = known.0.to_string();
            let as_written = order_code::edit_distance(&wanted, &text);
            let reordered = 1 + order_code::edit_distance(&wanted_words, &sorted_words(&text));
            (as_written.min(reordered), !known.1.is_available(), known)
        };
        let mut scored: Vec<(usize, bool, &Known)> = kept.into_iter().map(score).collect();
        scored.sort_by_key(|(distance, asked, (code, _))| (*distance, *asked, *code));
        let best = scored.first().map_or(0, |(distance, ..)| *distance);
        let bound = (best + 1).min(wanted.chars().count() / 2);
        scored.into_iter().filter(|(distance, ..)| *distance <= bound).take(most).map(|(_, _, known)| known).collect()
    }

    /// The same proposals as by comparing with every code, for codes with a few letters and words changed.
    #[test]
    fn what_is_left_out_is_not_near() {
        let mut state = 7_u64;
        let mut any = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            usize::try_from(state >> 33).unwrap() % below
        };
        let pieces = ["", "-", "A", "B", "C", "0", "1", "4", "X", "ß", " ", "EC", "SP", "100", "20A", "H", "--", "RES"];
        let mut proposed = 0;
        for _ in 0..CASES {
            let mut letters: Vec<char> = WITH_DATA[any(WITH_DATA.len())].text.chars().collect();
            if any(3) == 0 {
                letters.reverse();
            }
            if any(3) == 0 {
                let text: String = letters.into_iter().collect();
                let mut words: Vec<&str> = text.split('-').collect();
                let length = words.len();
                words.swap(any(length), any(length));
                letters = words.join("-").chars().collect();
            }
            for _ in 0..any(5) {
                let (at, gone) = (any(letters.len() + 1), any(4));
                letters.splice(at..(at + gone).min(letters.len()), pieces[any(pieces.len())].chars());
            }
            let text: String = letters.into_iter().collect();
            let found = nearest(&text, 3);
            assert_eq!(found, nearest_of_all(&text, 3), "{text}");
            proposed += usize::from(!found.is_empty());
        }
        assert!(proposed > CASES / 2 && proposed < CASES, "{proposed} of {CASES}");
    }
}
