//! A list of pins and the dimensions of a cable, as stated by the user.

use crate::chapters::read_quantity;
use installation::wiring::{CodeWiring, ListFault, PinComparison, compare, read_pin_list};
use quantities::unit::{METRE, SQUARE_MILLIMETRE};
use quantities::{Area, Language, Length, Measure};
use words::{Worded, wiring};

/// Largest length of a cable \[m\].
pub(crate) const CABLE_LENGTH_MAX_M: f64 = 1000.0;

/// Largest cross-section of a wire \[mm²\].
pub(crate) const CROSS_SECTION_MAX_MM2: f64 = 1000.0;

/// Reads a list of pins, in the encoding of any spreadsheet program, and compares it with the wiring; for a list with
/// faults, returns the decoded text with its faults.
///
/// # Errors
/// Errors of the source; bytes in memory have none.
pub(crate) fn read_list(
    wiring: &CodeWiring,
    bytes: &[u8],
    language: Language,
) -> std::io::Result<Result<PinComparison, (String, Vec<Worded>)>> {
    let (text, _) = recording::read_text(bytes)?;
    let worded = |fault: &ListFault| {
        let (message, hint) = (wiring::list_fault(fault, language), wiring::list_fault_hint(fault, language));
        Worded::at(&text, fault.span(), fault.id(), message, hint)
    };
    let compared = read_pin_list(&text).map(|list| compare(wiring, &list));
    let compared = compared.map_err(|faults| faults.iter().map(worded).collect());
    Ok(compared.map_err(|faults| (text, faults)))
}

/// Parses the length of a cable.
///
/// # Errors
/// The fault of the text, and a hint.
pub(crate) fn cable_length(text: &str, language: Language) -> Result<Length, (String, Option<String>)> {
    let length: Length = read_quantity(text, language)?;
    let metres = length.in_unit(&METRE);
    if metres > 0.0 && metres <= CABLE_LENGTH_MAX_M {
        return Ok(length);
    }
    Err((wiring::length_must_be_positive(&CABLE_LENGTH_MAX_M, language), None))
}

/// Parses the cross-section of a wire.
///
/// # Errors
/// The fault of the text, and a hint.
pub(crate) fn cross_section(text: &str, language: Language) -> Result<Area, (String, Option<String>)> {
    let area: Area = read_quantity(text, language)?;
    let section = area.in_unit(&SQUARE_MILLIMETRE);
    if section > 0.0 && section <= CROSS_SECTION_MAX_MM2 {
        return Ok(area);
    }
    Err((wiring::section_must_be_positive(&CROSS_SECTION_MAX_MM2, language), None))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::codes::list_codes;
    use catalogue::Topic;
    use installation::facts::{Order, facts_about};

    #[test]
    fn every_fact_on_wiring_and_safety_is_in_the_answer_of_some_code() {
        let codes = list_codes(None);
        for fact in catalogue::facts().iter().filter(|fact| fact.topics.contains(&Topic::Wiring)) {
            let worded = |code: &order_code::OrderCode| {
                let wiring = installation::wiring::wiring(code);
                let record = wiring.map(|wiring| crate::answer::wiring(&wiring, None, Language::De));
                record.is_some_and(|record| record.rules.iter().any(|rule| rule.id == fact.id && rule.text == fact.de))
            };
            let with = codes
                .iter()
                .find(|(code, _)| facts_about(Topic::Wiring, code, Order::Data).iter().any(|f| f.id == fact.id));
            assert!(with.is_some_and(|(code, _)| worded(code)), "{}", fact.id);
        }
    }

    #[test]
    fn a_list_in_utf_16_and_one_in_windows_1252_are_read() {
        let code = order_code::parse("CHA-25A-100-H-M512P").unwrap().code;
        let wiring = installation::wiring::wiring(&code).unwrap();
        let list = "Stecker;Stift;Signal;Farbe\r\nMotor;6;W;weiß\r\n";
        let wide: Vec<u8> = [0xfeff].into_iter().chain(list.encode_utf16()).flat_map(u16::to_le_bytes).collect();
        let narrow: Vec<u8> = list.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
        for bytes in [list.as_bytes(), &wide, &narrow] {
            let comparison = read_list(&wiring, bytes, Language::De).unwrap().unwrap();
            assert_eq!((comparison.rows, comparison.agreeing), (1, 1), "{:?}", comparison.findings);
            assert!(!comparison.findings.iter().any(|finding| finding.difference.id() == "colour"));
        }
    }
}
