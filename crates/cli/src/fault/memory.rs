//! Limit of the memory of the recordings of a project.

use clap::ArgMatches;
use quantities::Language;
use questions::MEMORY_USUAL;
use questions::list::Unanswered;
use words::{Usage, UsageHint, usage_hint, usage_text};

/// Environment variable with the limit for calls without the option.
const VARIABLE: &str = "ANTRIEB_MEMORY";

/// Permissible limits: 1 MiB to 64 GiB.
const BYTES: std::ops::RangeInclusive<u64> = 1 << 20..=64 << 30;

/// Units with their number of bytes.
const UNITS: [(&str, u64); 6] =
    [("KiB", 1 << 10), ("MiB", 1 << 20), ("GiB", 1 << 30), ("kB", 1_000), ("MB", 1_000_000), ("GB", 1_000_000_000)];

/// Returns the limit of `--memory`, else of the variable, else the default.
pub(crate) fn allowed(matches: &ArgMatches, language: Language) -> Result<u64, Unanswered> {
    allowed_by(matches.try_get_one::<String>("memory").ok().flatten().cloned(), language)
}

/// Returns the limit that a call states, else that of the variable `ANTRIEB_MEMORY`, else the default, in bytes.
///
/// # Errors
/// A text that is no size, or a size out of bounds.
pub fn allowed_by(said: Option<String>, language: Language) -> Result<u64, Unanswered> {
    let Some(written) = said.or_else(|| std::env::var(VARIABLE).ok()) else { return Ok(MEMORY_USUAL) };
    bytes(&written).ok_or_else(|| {
        let hint = usage_hint(&UsageHint::Memory, language);
        let message = usage_text(&Usage::NoMemory { written: written.chars().take(40).collect() }, language);
        Unanswered::option("memory", (message, Some(hint)))
    })
}

/// Parses a whole number with its unit.
fn bytes(written: &str) -> Option<u64> {
    let written = written.trim();
    let (number, size) = UNITS.iter().find_map(|(unit, size)| Some((written.strip_suffix(unit)?, size)))?;
    let bytes = number.trim_end().parse::<u64>().ok()?.checked_mul(*size)?;
    Some(bytes).filter(|bytes| BYTES.contains(bytes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_has_a_unit_and_bounds() {
        assert_eq!(bytes("512 MiB"), Some(512 << 20));
        assert_eq!(bytes(" 2GB "), Some(2_000_000_000));
        for written in
            ["", "512", "MiB", "0 MiB", "-1 GiB", "1.5 GiB", "65 GiB", "900 KiB", "99999999999999999999 GB", "1 TiB"]
        {
            assert_eq!(bytes(written), None, "{written}");
        }
    }
}
