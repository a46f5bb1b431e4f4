//! The valid codes nearest to one that does not exist.

use crate::codes::all;
use crate::rules::Availability;
use order_code::{Brake, Distances, Field, OrderCode, Pattern, Texts};
use std::sync::LazyLock;

/// A valid code with data, and its availability.
type Known = (OrderCode, Availability);

/// What a search must know of a code, worked out once.
struct Indexed {
    known: &'static Known,
    letters: Letters,
}

/// What a search must know of all codes.
struct Index {
    /// The valid codes that the manual prints data for, in the order of the fields.
    entries: Vec<Indexed>,
    /// Length of the shortest.
    letters_least: usize,
    /// As they are written.
    written: Texts,
    /// With their words in alphabetical order.
    reordered: Texts,
    /// Which entry each of `reordered` is of.
    of: Vec<usize>,
}

static WITH_DATA: LazyLock<Index> = LazyLock::new(|| {
    let has_data = |(code, _): &&Known| catalogue::drive(code.size, code.winding, code.feedback).is_some();
    let known: Vec<&'static Known> = all().iter().filter(has_data).collect();
    let texts: Vec<String> = known.iter().map(|(code, _)| code.to_string()).collect();
    let entry = |(known, text): (&&'static Known, &String)| Indexed { known, letters: Letters::of(text) };
    let mut sorted: Vec<(String, usize)> = texts.iter().map(|text| sorted_words(text)).zip(0..).collect();
    sorted.sort_unstable();
    Index {
        entries: known.iter().zip(&texts).map(entry).collect(),
        letters_least: texts.iter().map(String::len).min().unwrap_or_default(),
        written: Texts::new(texts.iter().map(String::as_str)),
        reordered: Texts::new(sorted.iter().map(|(text, _)| text.as_str())),
        of: sorted.into_iter().map(|(_, entry)| entry).collect(),
    }
});

/// The words of a code in alphabetical order, so that two codes with the same words in another order are equal.
fn sorted_words(text: &str) -> String {
    let mut words: Vec<&str> = text.split('-').collect();
    words.sort_unstable();
    words.join("-")
}

/// How often each letter, digit and hyphen stands in a text, and how many other characters; of a text of up to 255.
struct Letters {
    counts: [u8; 37],
    others: u8,
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
            let place = usize::try_from(place).ok();
            let count = place.and_then(|place| letters.counts.get_mut(place)).unwrap_or(&mut letters.others);
            *count = count.saturating_add(1);
        }
        letters
    }

    /// The distance of two texts is at least this: a letter that only one of them has costs a step, whatever the order.
    fn distance_at_least(&self, other: &Self) -> usize {
        let excess = |one: &Self, than: &Self| {
            let more = one.counts.iter().zip(&than.counts).map(|(one, than)| one.saturating_sub(*than));
            more.fold(one.others, u8::saturating_add)
        };
        usize::from(excess(self, other).max(excess(other, self)))
    }
}

/// The valid codes nearest to a misspelt text, by the number of letters to insert, delete, change or swap; words in the
/// wrong order count as one step. Only codes with data, and with all the words that were understood if there are such, else
/// with all but one; of several as near, those available without asking first.
///
/// Cost: a count of letters per valid code; a row of two tables of edit distances for each beginning of codes that may
/// lead to one near.
#[must_use]
pub fn nearest(text: &str, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let wanted: String = text.trim().to_uppercase().chars().take(40).collect();
    let Index { entries, letters_least, written, reordered, of } = &*WITH_DATA;
    let pattern = kept(text);
    // A code that shares less than half of its letters is no help; those that a text cut off lacks are not wrong.
    let half = wanted.chars().count().max(*letters_least) / 2;
    let letters = Letters::of(&wanted);
    let at_least = |entry: &Indexed| {
        let kept = pattern.matches(&entry.known.0);
        if kept { entry.letters.distance_at_least(&letters) } else { usize::MAX }
    };
    let least: Vec<usize> = entries.iter().map(at_least).collect();
    let Some(fewest) = least.iter().copied().min().filter(|fewest| *fewest <= half) else { return Vec::new() };
    let may_be = |entry: usize, bound: usize| least.get(entry).is_some_and(|least| *least <= bound);
    let (mut as_written, mut in_order) = (Distances::from(&wanted), Distances::from(&sorted_words(&wanted)));
    // First those that are as near as the letters let any be, then ever further away, until one is found; then those
    // that are one step further.
    let mut bound = half.min(fewest + 1);
    loop {
        let mut found: Vec<(usize, usize)> = Vec::new();
        written.within(&mut as_written, bound, |entry| may_be(entry, bound), |entry, far| found.push((entry, far)));
        if let Some(within) = bound.checked_sub(1) {
            let entry = |place: usize| of.get(place).copied().unwrap_or(usize::MAX);
            let asked = |place: usize| may_be(entry(place), bound);
            reordered.within(&mut in_order, within, asked, |place, far| found.push((entry(place), far + 1)));
        }
        match found.iter().map(|(_, far)| *far).min() {
            Some(best) if best < bound || bound == half => return ranked(found, best + 1, most),
            Some(_) => bound += 1,
            None if bound == half => return Vec::new(),
            None => bound = half.min(bound + 2),
        }
    }
}

/// The words of a text that a proposal keeps: all that were understood, if a code has them. Else one of them contradicts the
/// others: the first to be left out is the one that says least of the machine. No code here is a special design.
fn kept(text: &str) -> Pattern {
    let Err(faults) = order_code::parse(text) else { return Pattern::default() };
    let without = |left_out: Option<Field>| {
        Pattern::of(faults.series(), |field| {
            faults.understood(field).filter(|_| field != Field::Special && Some(field) != left_out)
        })
    };
    let is_known = |pattern: &Pattern| WITH_DATA.entries.iter().any(|entry| pattern.matches(&entry.known.0));
    std::iter::once(None)
        .chain(Field::ALL.iter().rev().map(|field| Some(*field)))
        .map(without)
        .find(is_known)
        .unwrap_or_default()
}

/// The codes found at most so far away: the nearest first, of several as near those available without asking.
fn ranked(found: Vec<(usize, usize)>, furthest: usize, most: usize) -> Vec<&'static Known> {
    let near = found.into_iter().filter(|(_, far)| *far <= furthest);
    let known = near.filter_map(|(entry, far)| Some((far, WITH_DATA.entries.get(entry)?.known)));
    let mut scored: Vec<(usize, bool, &Known)> =
        known.map(|(far, known)| (far, !known.1.is_available(), known)).collect();
    scored.sort_by_key(|(far, asked, (code, _))| (*code, *far, *asked));
    // One that is found as it is written and by its words counts with the fewer steps.
    scored.dedup_by_key(|(_, _, (code, _))| *code);
    scored.sort_by_key(|(far, asked, (code, _))| (*far, *asked, *code));
    scored.into_iter().take(most).map(|(_, _, known)| known).collect()
}

/// The valid codes nearest to a well-spelt one that breaks a rule, by what the actuator is: how far its ratio and size are,
/// and which fields differ. Only codes with data; of several as near, those available without asking first.
#[must_use]
pub fn nearest_to(wanted: &OrderCode, most: usize) -> Vec<&'static (OrderCode, Availability)> {
    let of_series = WITH_DATA.entries.iter().filter(|entry| entry.known.0.series() == wanted.series());
    let mut scored: Vec<(f64, &Known)> =
        of_series.map(|entry| (distance(wanted, &entry.known.0), entry.known)).collect();
    let order = |(a, one): &(f64, &Known), (b, other): &(f64, &Known)| {
        let asked = |known: &Known| !known.1.is_available();
        a.total_cmp(b).then_with(|| (asked(one), one.0).cmp(&(asked(other), other.0)))
    };
    // Only the first few are put in order.
    if most < scored.len() {
        scored.select_nth_unstable_by(most, order);
        scored.truncate(most);
    }
    scored.sort_by(order);
    scored.into_iter().take(most).map(|(_, known)| known).collect()
}

/// How unlike two actuators are. The weights are ours and order nothing but the proposals: another brake or supply voltage
/// is another machine, a connector is not, and options that were not requested are not proposed; a step in size weighs as much as a factor of 2.7 in the ratio.
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

    /// 48 V is not made of 25A: size and ratio stay, not the winding.
    #[test]
    fn a_word_that_contradicts_the_others_goes() {
        let found = |text: &str| -> Vec<String> { nearest(text, 3).iter().map(|(code, _)| code.to_string()).collect() };
        let of_25 = found("CHA-25A-100-E");
        assert!(!of_25.is_empty() && of_25.iter().all(|code| code.starts_with("CHA-25A-100-")), "{of_25:?}");
        let of_20 = found("CHA-20A-100-H-C1024-EC-X");
        assert!(of_20.iter().all(|code| code.starts_with("CHA-20A-100-H-C1024")), "{of_20:?}");
        assert_eq!(found("CHA"), [""; 0], "too little to say anything");
        assert_eq!(WITH_DATA.letters_least, "CHA-14A-30-H-RES".len());
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
        let with_data = || WITH_DATA.entries.iter().map(|entry| entry.known);
        let keeping = |left_out: &[Field]| -> Vec<&Known> {
            let counts = |field: &Field| *field != Field::Special && !left_out.contains(field);
            let mut counted = understood.clone();
            counted.retain(|(field, _)| counts(field));
            with_data()
                .filter(|(code, _)| counted.iter().all(|(field, word)| code.token(*field) == Some(*word)))
                .collect()
        };
        let mut kept = keeping(&[]);
        for field in Field::ALL.iter().rev() {
            if kept.is_empty() {
                kept = keeping(&[*field]);
            }
        }
        if kept.is_empty() {
            kept = with_data().collect();
        }
        let score = |known: &'static Known| {
            let text = known.0.to_string();
            let as_written = Distances::from(&wanted).to(&text);
            let reordered = 1 + Distances::from(&wanted_words).to(&sorted_words(&text));
            (as_written.min(reordered), !known.1.is_available(), known)
        };
        let mut scored: Vec<(usize, bool, &Known)> = kept.into_iter().map(score).collect();
        scored.sort_by_key(|(distance, asked, (code, _))| (*distance, *asked, *code));
        let best = scored.first().map_or(0, |(distance, ..)| *distance);
        let bound = (best + 1).min(wanted.chars().count().max(16) / 2);
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
            let mut letters: Vec<char> =
                WITH_DATA.entries[any(WITH_DATA.entries.len())].known.0.to_string().chars().collect();
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
