//! Quantities: a finite value that is read back as printed, or a fault inside the text.

use crate::text::{any_edits, mutate, rest, tells};
use arbitrary::{Result, Unstructured};
use quantities::{Dimension, Language, Reading, Unit, format_significant, parse, parse_german, unit};

/// Number of digits in the printed form that is read back.
const DIGITS: usize = 6;

/// Tests an example of a dimension with edits, a number with a unit, or any text, as a quantity of its dimension and
/// two others.
pub fn run(data: &[u8]) {
    if let Ok((dimensions, text)) = made(data) {
        dimensions.into_iter().for_each(|dimension| hold(&text, dimension));
    }
}

/// Returns the text of a case.
pub fn shown(data: &[u8]) -> String {
    made(data).map(|(_, text)| text).unwrap_or_default()
}

fn made(data: &[u8]) -> Result<([Dimension; 3], String)> {
    let mut u = Unstructured::new(data);
    let first = u.choose(unit::ALL)?.dimension;
    let dimensions = [first, *u.choose(Dimension::ALL)?, *u.choose(Dimension::ALL)?];
    Ok((dimensions, text(&mut u, first)?))
}

fn text(u: &mut Unstructured<'_>, dimension: Dimension) -> Result<String> {
    Ok(match u.int_in_range(0..=3)? {
        0 => rest(u),
        1 => {
            let spellings: Vec<&str> = dimension.units().iter().flat_map(Unit::spellings).collect();
            let spelling = *u.choose(&spellings)?;
            let value = f64::from_bits(u.arbitrary()?);
            if u.ratio(1, 2)? { format!("{value:e} {spelling}") } else { format!("{value}{spelling}") }
        }
        _ => mutate(dimension.example(), &any_edits(u, 4)?),
    })
}

fn hold(text: &str, dimension: Dimension) {
    match parse(dimension, text) {
        Ok(reading) => read_again(text, dimension, &reading),
        Err(error) => {
            assert!(text.get(error.span()).is_some(), "{text:?}: {error:?}");
            for language in [Language::En, Language::De] {
                tells(&words::quantity_fault(&error, language));
                words::quantity_hint(&error, language).iter().for_each(|hint| tells(hint));
            }
        }
    }
}

fn read_again(text: &str, of: Dimension, reading: &Reading) {
    assert!(reading.si.is_finite() && reading.value.is_finite(), "{text:?} as {of:?}");
    for spelling in reading.unit.spellings() {
        // A ratio without a unit is a number.
        let spelling = if *reading.unit == unit::ONE { "" } else { spelling };
        let printed = format!("{} {spelling}", reading.value);
        let again = parse(of, &printed).map(|again| again.si.to_bits());
        assert_eq!(again.ok(), Some(reading.si.to_bits()), "{text:?} printed as {printed:?}");
    }
    // The displayed form in both languages. Outside these bounds a power of ten is printed.
    let value = reading.value;
    if (1e-3..1e5).contains(&value.abs()) {
        let [english, german] =
            [Language::En, Language::De].map(|language| format_significant(value, DIGITS, language));
        let near = |read: f64| (read - value).abs() <= value.abs() * 1e-5;
        assert!(english.replace('−', "-").parse().is_ok_and(near), "{value} printed as {english}");
        assert!(parse_german(&german).is_some_and(near), "{value} printed as {german}");
    }
}
