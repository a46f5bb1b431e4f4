//! Statements of a word about actuators: the codes that a part of a code allows, and the battery of a code.

use super::spoken::seems_code;
use quantities::Language;

/// Returns the codes of the actuators with data that a part of a code allows; none for a complete code, and for another word.
pub(super) fn readings(word: &str, language: Language) -> Vec<String> {
    if !seems_code(word) || questions::read_code(word, language).is_ok() {
        return Vec::new();
    }
    let pattern = questions::list::code_list::read_pattern(word, language).ok();
    let codes = pattern.map(|pattern| questions::list::code_list::list_codes(Some(&pattern)));
    let available = codes.into_iter().flatten().filter(|(_, found)| found.is_available());
    available.map(|(code, _)| code.to_string()).collect()
}

/// Returns `true` if the encoder of the actuator with a code is buffered by a battery; `None` for a word that is no code.
pub(super) fn has_battery(word: &str, language: Language) -> Option<bool> {
    Some(questions::has_battery(&questions::read_code(word, language).ok()?.parsed.code))
}
