//! Headings of a table whose columns are keys of a project: a key with the unit of its numbers.
#![allow(clippy::result_large_err, reason = "a fault is found once for a table, not for each of its rows")]

use crate::edit::key_at;
use crate::key::{Key, Kind};
use crate::nearest::{nearest, other_names};
use crate::read::{MAGNITUDES, Reader, joined, shortened};
use crate::root::KEYS;
use crate::{Fault, Hint, Range, TabularFault};
use quantities::unit::PERCENT;
use quantities::{Dimension, QuantityError, Unit};
use std::borrow::Cow;

/// Longest excerpt of a heading in a fault, in characters.
const HEADING_SHOWN: usize = 80;

/// Beginning of a key of the mechanism that the project states, without its name: `mechanism.mass`.
pub(crate) const OF_MECHANISM: &str = "mechanism.";

/// A column whose cells are values of a key: `load.inertia [kg m^2]`, `motion[1].law`.
#[derive(Clone, Debug)]
pub struct Heading {
    /// Path of the key within the axis, entries of lists counted from one: `motion[1].time`.
    pub path: String,
    /// The description of the key.
    pub key: &'static Key,
    /// Unit of the numbers in its cells; `None` for a key without a unit.
    pub unit: Option<&'static Unit>,
}

/// Counting of list entries in the headings of a table. Entries count from one, as in project files and faults: the
/// meaning of a heading does not depend on the other columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    /// One of the headings has an entry with the number zero: headings that count entries are refused, since each may
    /// mean the next one.
    FromZero,
    /// `motion[1]` is the first segment.
    FromOne,
}

impl Counted {
    /// Returns `FromZero` if one of the headings has an entry with the number zero, else `FromOne`.
    pub fn of<'h>(headings: impl IntoIterator<Item = &'h str>) -> Self {
        let is_zero = |part: &str| part.split_once(']').is_some_and(|(index, _)| index.trim().parse() == Ok(0));
        let has_zero = headings.into_iter().any(|heading| parts(heading).0.split('[').skip(1).any(is_zero));
        if has_zero { Self::FromZero } else { Self::FromOne }
    }
}

/// Fault of a heading or a cell, with a hint.
pub type Objection = (Fault, Option<Hint>);

impl Heading {
    /// Reads a heading; `axis` is the index of the axis among several.
    ///
    /// # Errors
    /// If the project file has no such key, its values cannot be in cells, the unit is missing or wrong, or entries are
    /// counted from zero; then the hint is the heading that counts from one.
    pub fn read(written: &str, counted: Counted, axis: Option<usize>) -> Result<Self, Objection> {
        let (name, unit) = parts(written);
        let (name, unit) = (name.as_ref(), unit.as_deref());
        let unknown = || (Fault::UnknownKey { path: shortened(name, HEADING_SHOWN) }, nearest_key(name, &[]));
        let (path, key) = located(name, counted, axis).ok_or_else(unknown)?;
        if counted == Counted::FromZero && path != name {
            let now = unit.map_or_else(|| path.clone(), |unit| format!("{path} [{unit}]"));
            let fault = TabularFault::CountsFromZero { path: shortened(name, HEADING_SHOWN) };
            return Err((Fault::Tabular(fault), Some(Hint::DidYouMean(now))));
        }
        let in_unit = |dimensions: &[Dimension]| unit_of(dimensions, unit).map_err(|error| quantity(name, error));
        if !may_be_a_column(key) {
            return Err((Fault::Tabular(TabularFault::NoColumn { path }), nearest_key(name, &[])));
        }
        let unit = match key.kind {
            Kind::Quantity(dimension, _) => Some(in_unit(&[dimension])?),
            Kind::Along(turning, line, _) => Some(in_unit(&[turning, line])?),
            Kind::Number(..) if key.kind.is_ratio() && unit == Some(PERCENT.ascii) => Some(&PERCENT),
            _ => {
                if let Some(unit) = unit {
                    let unit = shortened(unit, HEADING_SHOWN);
                    return Err((Fault::Tabular(TabularFault::UnitOfNoQuantity { path, unit }), None));
                }
                None
            }
        };
        Ok(Self { path, key, unit })
    }

    /// Returns `true` if a text is a heading, with or without the unit that its key needs.
    #[must_use]
    pub fn is_one(written: &str) -> bool {
        located(&parts(written).0, Counted::of([written]), None).is_some_and(|(_, key)| may_be_a_column(key))
    }

    /// Returns the dimensions of the unit that a heading lacks; `None` if it states one or needs none.
    #[must_use]
    pub fn lacks_unit_of(written: &str) -> Option<Vec<Dimension>> {
        let (name, unit) = parts(written);
        if unit.is_some() {
            return None;
        }
        match key_at(&from_one(&name, Counted::FromOne)?)?.kind {
            Kind::Quantity(dimension, _) => Some(vec![dimension]),
            Kind::Along(turning, line, _) => Some(vec![turning, line]),
            _ => None,
        }
    }

    /// Returns `true` if its cells are numbers.
    #[must_use]
    pub const fn is_number(&self) -> bool {
        matches!(self.key.kind, Kind::Quantity(..) | Kind::Along(..) | Kind::Number(..))
    }

    /// Returns the unit of a quantity, and its permissible range.
    const fn measured(&self) -> Option<(&'static Unit, Range)> {
        match (self.unit, self.key.kind) {
            (Some(unit), Kind::Quantity(_, range) | Kind::Along(_, _, range)) => Some((unit, range)),
            _ => None,
        }
    }

    /// Returns the number of a cell as in the project, in SI; `None` if a project file with it would be refused.
    #[must_use]
    pub fn si(&self, cell: f64) -> Option<f64> {
        if let Some((unit, range)) = self.measured() {
            let si = unit.to_si(cell);
            let plausible = si == 0.0 || MAGNITUDES.contains(&si.abs());
            return (plausible && cell.is_finite() && range.holds(unit.dimension, si)).then_some(si);
        }
        match self.key.kind {
            Kind::Number(low, high) => {
                let si = if self.unit.is_some() { cell / 100.0 } else { cell };
                (low..=high).contains(&si).then_some(si)
            }
            _ => None,
        }
    }

    /// Returns the reason why a project file with the number of a cell would be refused.
    #[must_use]
    pub fn refusal(&self, cell: f64) -> Option<Fault> {
        if self.si(cell).is_some() {
            return None;
        }
        let (path, written) = (self.path.clone(), self.written(cell));
        if !cell.is_finite() {
            return Some(Fault::Tabular(TabularFault::NotANumber { path, written: cell.to_string() }));
        }
        if let Some((unit, range)) = self.measured() {
            let mut reader = Reader::new(&written);
            let _ = reader.quantity((&written, 0..written.len()), (&[unit.dimension], range), (&path, &path));
            return reader.report.into_faults().into_iter().next().map(|found| found.fault);
        }
        match self.key.kind {
            Kind::Number(low, high) => Some(Fault::NumberOutOfRange { path, low, high }),
            #[allow(clippy::cast_precision_loss, reason = "bounds are small")]
            Kind::Integer(low, high) => Some(Fault::NumberOutOfRange { path, low: low as f64, high: high as f64 }),
            _ => None,
        }
    }

    /// Returns the number of a cell as written behind the key of a project file.
    #[must_use]
    pub fn written(&self, cell: f64) -> String {
        match (self.unit, self.key.kind) {
            (Some(_), Kind::Number(..)) => (cell / 100.0).to_string(),
            (Some(unit), _) => format!("{cell} {}", unit.ascii),
            (None, _) => cell.to_string(),
        }
    }

    /// Returns the word of a cell as a project file has it: `TRUE`, `True` and `WAHR`, as spreadsheets and data frames write
    /// them, are `true`.
    #[must_use]
    pub fn word<'c>(&self, cell: &'c str) -> &'c str {
        match self.key.kind {
            Kind::Bool => truth(cell).unwrap_or(cell),
            _ => cell,
        }
    }

    /// Returns the fault of a word in one of its cells.
    #[must_use]
    pub fn objection(&self, cell: &str) -> Option<Objection> {
        let not_a_choice = |word: &str, words: &[&str]| {
            let written = shortened(word, HEADING_SHOWN);
            (Fault::NotAChoice { path: self.path.clone(), written }, Some(nearest(word, words)))
        };
        match self.key.kind {
            Kind::OneOf(words) => (!words.contains(&cell)).then(|| not_a_choice(cell, words)),
            Kind::ListOf(words) => {
                let mut each = cell.split([',', ';']).map(str::trim);
                each.find(|word| !words.contains(word)).map(|word| not_a_choice(word, words))
            }
            Kind::Bool => (!["true", "false"].contains(&cell)).then(|| not_a_choice(cell, &["true", "false"])),
            _ => None,
        }
    }
}

/// Words for true and false in any case, in both languages.
const TRUTHS: [(&str, [&str; 6]); 2] =
    [("true", ["true", "wahr", "yes", "ja", "on", "an"]), ("false", ["false", "falsch", "no", "nein", "off", "aus"])];

/// Returns `true` or `false` as a project file has it, for a word that means it.
#[must_use]
pub fn truth(word: &str) -> Option<&'static str> {
    let is_one_of = |words: &[&str; 6]| words.contains(&&*word.to_lowercase());
    TRUTHS.iter().find(|(_, words)| is_one_of(words)).map(|(truth, _)| *truth)
}

/// Splits a heading into key and unit: the unit is in the last brackets, behind a space or a text that is no entry of a
/// list, or marked as in the heading of a recording: `load.inertia (kg m^2)`, `load.inertia / kg m^2`.
pub(crate) fn parts(written: &str) -> (Cow<'_, str>, Option<Cow<'_, str>>) {
    let written = written.trim();
    let split = written.strip_suffix(']').and_then(|rest| rest.rsplit_once('['));
    match split {
        Some((name, unit)) if name.ends_with(char::is_whitespace) || unit.trim().parse::<usize>().is_err() => {
            (name.trim_end().into(), Some(unit.trim().into()))
        }
        _ => match recording::name_and_unit(written) {
            (name, Some(unit)) => (name.into(), Some(unit.into())),
            (_, None) => (written.into(), None),
        },
    }
}

/// Splits a heading whose unit stands behind an underscore or a blank, as in a recording: `time_s`, `motion[1].payload_kg`,
/// `ambient degC`. The part before it is a key or a word for one, and the unit is one of its quantity.
pub(crate) fn underscored(written: &str) -> Option<(&str, &'static Unit)> {
    /// Parts of the longest unit: `10_m_s`.
    const PARTS_MOST: usize = 3;
    let written = written.trim();
    if written.len() > HEADING_SHOWN || parts(written).1.is_some() || Heading::is_one(written) {
        return None;
    }
    let strokes: Vec<usize> = written.match_indices(['_', ' ']).map(|(at, _)| at).collect();
    strokes.iter().rev().take(PARTS_MOST).rev().find_map(|at| {
        let (name, unit) = (written.get(..*at)?.trim_end(), written.get(at + 1..)?);
        Some((name, recording::unit_after_underscore(&dimensions_of(name), unit)?))
    })
}

/// Returns the dimensions of a key, or of the keys that a word may stand for.
fn dimensions_of(name: &str) -> Vec<Dimension> {
    if let Some(key) = from_one(&with_brackets(name), Counted::FromOne).and_then(|path| key_at(&path)) {
        return key.kind.dimensions();
    }
    let word = name.to_lowercase();
    let word = word.strip_prefix(OF_MECHANISM).unwrap_or(&word);
    let others = other_names(word);
    let mut all = Vec::new();
    columns(KEYS, "", "[1]", &mut all);
    let last = |path: &String| path.rsplit('.').next().unwrap_or(path).to_owned();
    let meant = all.iter().filter(|path| last(path) == word || others.contains(&last(path).as_str()));
    meant.filter_map(|path| key_at(path)).flat_map(|key| key.kind.dimensions()).collect()
}

/// Returns the path of a key of an axis, entries of lists counted from one, and its description; `None` if the project file
/// has no such key.
fn located(name: &str, counted: Counted, axis: Option<usize>) -> Option<(String, &'static Key)> {
    let path = from_one(name, counted)?;
    let within = axis.map_or_else(|| path.clone(), |index| format!("axis[{}].{path}", index + 1));
    let is_of_an_axis =
        !["axis", "catalogue", "curve", "format"].contains(&path.split(['.', '[']).next().unwrap_or_default());
    let key = key_at(&within).filter(|_| is_of_an_axis && names_its_entries(&within))?;
    Some((path, key))
}

/// Returns `true` if a cell can hold a value of a key.
pub(crate) const fn may_be_a_column(key: &Key) -> bool {
    !matches!(
        key.kind,
        Kind::Numbers(..)
            | Kind::Texts
            | Kind::Rows(_)
            | Kind::Table(_)
            | Kind::OneOrMany(..)
            | Kind::Bodies
            | Kind::Variants(_)
    )
}

/// Returns the path with the entries of its lists counted from one; `None` if it is invalid.
fn from_one(path: &str, counted: Counted) -> Option<String> {
    let mut parts = path.split('[');
    let mut found = parts.next()?.to_owned();
    for part in parts {
        let (index, rest) = part.split_once(']')?;
        let index: usize = index.parse().ok()?;
        let index = match counted {
            Counted::FromZero => index.checked_add(1)?,
            Counted::FromOne => index,
        };
        found.push_str(&format!("[{index}]{rest}"));
    }
    Some(found)
}

/// Returns a path with its entries in brackets: `motion.1.time` is `motion[1].time`.
#[must_use]
pub fn with_brackets(path: &str) -> String {
    let is_entry = |part: &str| !part.is_empty() && part.chars().all(|sign| sign.is_ascii_digit());
    path.split('.').fold(String::new(), |path, part| match part {
        _ if path.is_empty() => part.to_owned(),
        _ if is_entry(part) => format!("{path}[{part}]"),
        _ => format!("{path}.{part}"),
    })
}

/// Returns `true` if each list in a path has the number of its entry.
fn names_its_entries(path: &str) -> bool {
    path.match_indices('.').all(|(at, _)| {
        let above = path.get(..at).unwrap_or_default();
        let is_list = key_at(above).is_some_and(|key| matches!(key.kind, Kind::Variants(_) | Kind::OneOrMany(..)));
        !is_list || above.ends_with(']')
    })
}

/// Returns the unit of a heading, checked against the dimensions of the key.
fn unit_of(dimensions: &[Dimension], unit: Option<&str>) -> Result<&'static Unit, (QuantityError, Vec<Dimension>)> {
    let sample = format!("1 {}", unit.unwrap_or_default());
    let found = dimensions.iter().map(|dimension| quantities::parse(*dimension, &sample));
    let mut errors = Vec::new();
    for (dimension, read) in dimensions.iter().zip(found) {
        match read {
            Ok(reading) => return Ok(reading.unit),
            Err(error) => errors.push((error, dimension)),
        }
    }
    // The error of a similarly spelt unit, else the first.
    let is_near = |error: &QuantityError| matches!(error, QuantityError::UnitUnknown { nearest: Some(_), .. });
    let place = errors.iter().position(|(error, _)| is_near(error)).unwrap_or(0);
    let (error, of) = errors.swap_remove(place);
    Err((error, dimensions.iter().copied().filter(|dimension| dimension != of).collect()))
}

fn quantity(name: &str, (error, also): (QuantityError, Vec<Dimension>)) -> Objection {
    (Fault::Quantity { path: shortened(name, HEADING_SHOWN), error, also }, None)
}

/// Returns the heading that was probably meant, with its table if only its own name is written; of several near ones the key
/// that the project states, `stated`, else one of a table that it states.
#[must_use]
pub fn nearest_heading(written: &str, stated: &[&str]) -> Option<Hint> {
    nearest_key(parts(written).0.as_ref(), stated)
}

/// Returns `true` if a heading is not meant as a key: it states no unit and no path, and no key has a similar name. Such a
/// column identifies rows, as `id` or `joint` do.
#[must_use]
pub fn is_label(written: &str) -> bool {
    let (name, unit) = parts(written);
    let name = name.to_lowercase();
    let is_path = name.contains(['.', '[']) && !name.contains(char::is_whitespace);
    if unit.is_some()
        || underscored(written).is_some()
        || name.is_empty()
        || is_path
        || name.chars().count() > HEADING_SHOWN
    {
        return false;
    }
    let mut all = Vec::new();
    columns(KEYS, "", "[1]", &mut all);
    let others = other_names(&name);
    let plain = |text: &str| text.replace([' ', '_', '-'], ".");
    let is_meant = |path: &String| {
        let last = path.rsplit('.').next().unwrap_or(path);
        let is_near = |found: &str, own: &str| {
            let letters = strsim::damerau_levenshtein(found, own);
            letters == 0 || (own.len() > NAME_LEAST && letters * NAME_LEAST <= own.len())
        };
        let is_akin = name.len() >= NAME_LEAST && last.strip_prefix(&*name).is_some_and(|rest| rest.starts_with('_'));
        is_akin || others.contains(&last) || is_near(&name, last) || is_near(&plain(&name), &plain(path))
    };
    !all.iter().any(is_meant)
}

/// Letters by which a key of another table must be nearer than a key that the project states.
const FOREIGN: usize = 2;

/// Length of the shortest name that is recognised with a wrong letter, or without the words behind it.
const NAME_LEAST: usize = 4;

fn nearest_key(written: &str, stated: &[&str]) -> Option<Hint> {
    let written: String = shortened(written, HEADING_SHOWN).to_lowercase();
    let mut all = Vec::new();
    columns(KEYS, "", "[1]", &mut all);
    let own_name = written.rsplit('.').next().unwrap_or(&written);
    let others = other_names(own_name);
    let distance = |path: &String| {
        let last = path.rsplit('.').next().unwrap_or(path);
        let whole = strsim::damerau_levenshtein(&written, path);
        // Spelt with underscores for points, or without its table.
        let plain = strsim::damerau_levenshtein(&written.replace('_', "."), &path.replace('_', "."));
        let table = usize::from(written.contains('.'));
        let letters = strsim::damerau_levenshtein(own_name, last);
        let is_near = (letters + table) * 3 <= last.len() && (letters == 0 || last.len() > NAME_LEAST);
        let own = if is_near { letters + table } else { usize::MAX };
        // `friction` of `friction_torque`, or the name that another program has for it.
        let begins = |rest: &str| rest.starts_with('_') && own_name.len() >= NAME_LEAST;
        let is_akin = last.strip_prefix(own_name).is_some_and(begins) || others.contains(&last);
        whole.min(plain).min(own).min(if is_akin { 1 + table } else { usize::MAX })
    };
    // A key of the project, of one of its tables, or of another one.
    let far = |path: &String| {
        let table = path.rsplit_once('.').map_or(path.as_str(), |(table, _)| table);
        let is_stated = |is_one: &dyn Fn(&str) -> bool| stated.iter().any(|known| is_one(known));
        if is_stated(&|known| known == path) {
            0
        } else if is_stated(&|known| known.strip_prefix(table).is_some_and(|rest| rest.starts_with('.'))) {
            1
        } else {
            1 + FOREIGN
        }
    };
    let near = all.iter().map(|path| (distance(path), path)).filter(|(near, path)| *near <= path.len() / 2);
    let (.., path) =
        near.map(|(near, path)| (near + far(path), near, path)).min_by_key(|(all, near, _)| (*all, *near))?;
    Some(Hint::DidYouMean(path.clone()))
}

/// Collects the paths of the keys that can be columns.
fn columns(keys: &'static [Key], above: &str, first: &str, found: &mut Vec<String>) {
    for key in keys {
        let path = joined(above, key.name);
        match key.kind {
            Kind::Table(below) => columns(below, &path, first, found),
            Kind::Variants(variants) if path == "motion" => {
                columns(variants.keys, &format!("{path}{first}"), first, found)
            }
            Kind::OneOrMany(..)
            | Kind::Variants(_)
            | Kind::Numbers(..)
            | Kind::Texts
            | Kind::Rows(_)
            | Kind::Bodies => {}
            Kind::Quantity(..)
            | Kind::Along(..)
            | Kind::Number(..)
            | Kind::Integer(..)
            | Kind::Bool
            | Kind::Text
            | Kind::OneOf(_)
            | Kind::ListOf(_) => {
                if !above.is_empty() {
                    found.push(path);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(written: &str) -> Result<Heading, Objection> {
        Heading::read(written, Counted::of([written]), None)
    }

    #[test]
    fn a_heading_is_a_key_with_the_unit_of_its_cells() {
        let inertia = read("load.inertia [kg m^2]").unwrap();
        assert_eq!((inertia.path.as_str(), inertia.si(1.3)), ("load.inertia", Some(1.3)));
        assert_eq!(inertia.written(1.3), "1.3 kg m^2");
        let time = read("motion[1].time[ms]").unwrap();
        assert_eq!((time.path.as_str(), time.si(250.0)), ("motion[1].time", Some(0.25)));
        assert_eq!(read("motion[1].time [s]").unwrap().path, "motion[1].time");
        let along = read("motion[1].distance [mm]").unwrap();
        assert_eq!(along.si(5.0), Some(0.005));
        assert!(matches!(read("motion[1].law").unwrap().key.kind, Kind::OneOf(words) if words.contains(&"trapezoid")));
        assert!(matches!(read("requirements.feedback").unwrap().key.kind, Kind::ListOf(_)));
        assert!(matches!(read("mechanism.arm.efficiency").unwrap().key.kind, Kind::Number(..)));
    }

    /// A heading means the same entry, independent of the other columns; if one counts from zero, headings with an
    /// entry are refused, each with a hint that counts from one.
    #[test]
    fn entries_are_counted_from_one_whatever_else_there_is() {
        let (mut read_alike, mut refused) = (0, 0);
        let all = ["motion[1].time [s]", "motion[2].payload[kg]", "motion[3].law", "load.inertia [kg m^2]"];
        let zero = ["motion[0].time [s]", "motion[00].law", "motion[0].payload[kg]"];
        for set in 0..1_u32 << 7 {
            let headings: Vec<&str> = all
                .iter()
                .chain(&zero)
                .enumerate()
                .filter(|(bit, _)| set >> bit & 1 == 1)
                .map(|(_, each)| *each)
                .collect();
            let counted = Counted::of(headings.iter().copied());
            let has_zero = headings.iter().any(|heading| zero.contains(heading));
            for heading in headings {
                match Heading::read(heading, counted, None) {
                    Ok(found) => {
                        assert!(
                            heading.starts_with(&found.path) && (!has_zero || heading.starts_with("load")),
                            "{heading}"
                        );
                        read_alike += 1;
                    }
                    Err((Fault::Tabular(TabularFault::CountsFromZero { path }), Some(Hint::DidYouMean(now)))) => {
                        assert!(has_zero && heading.starts_with(&path), "{heading}");
                        let next =
                            |heading: &str| -> usize { heading.split(['[', ']']).nth(1).unwrap().parse().unwrap() };
                        assert_eq!(next(&now), next(heading) + 1, "{heading}: {now}");
                        assert!(Heading::read(&now, Counted::FromOne, None).is_ok(), "{now}");
                        refused += 1;
                    }
                    Err(other) => panic!("{heading}: {other:?}"),
                }
            }
        }
        assert!(read_alike > 80 && refused > 200, "{read_alike} {refused}");
    }

    #[test]
    fn a_number_that_a_project_file_refuses_is_refused() {
        let inertia = read("load.inertia [kg m^2]").unwrap();
        assert_eq!([-1.0, f64::NAN, f64::INFINITY, 1e13, 1e-13].map(|cell| inertia.si(cell)), [None; 5]);
        let ambient = read("requirements.ambient [degC]").unwrap();
        assert_eq!((ambient.si(-300.0), ambient.si(20.0)), (None, Some(293.15)));
    }

    #[test]
    fn an_unknown_heading_is_answered_with_the_nearest_key() {
        for (written, near) in [
            ("load.inerta [kg m^2]", "load.inertia"),
            ("inertia [kg m^2]", "load.inertia"),
            ("load_inertia [kg m^2]", "load.inertia"),
            ("motion[0].tme [s]", "motion[1].time"),
            ("motion.time [s]", "motion[1].time"),
            ("requirement.ambient [degC]", "requirements.ambient"),
        ] {
            let (fault, hint) = read(written).unwrap_err();
            assert!(
                matches!(fault, Fault::UnknownKey { .. } | Fault::Tabular(TabularFault::NoColumn { .. })),
                "{written}: {fault:?}"
            );
            assert_eq!(hint, Some(Hint::DidYouMean(near.to_owned())), "{written}");
        }
    }

    #[test]
    fn a_unit_is_written_and_fits() {
        for written in ["load.inertia", "load.inertia [kg]", "load.inertia [kgm3]", "motion[1].distance [s]"] {
            assert!(matches!(read(written), Err((Fault::Quantity { .. }, _))), "{written}");
        }
        assert!(matches!(read("motion[1].law [s]"), Err((Fault::Tabular(TabularFault::UnitOfNoQuantity { .. }), _))));
        for written in ["load", "axis.name", "format", "mechanism.table.points"] {
            assert!(
                matches!(
                    read(written),
                    Err((Fault::Tabular(TabularFault::NoColumn { .. }) | Fault::UnknownKey { .. }, _))
                ),
                "{written}"
            );
        }
    }

    #[test]
    fn a_wrong_word_is_answered_with_the_nearest() {
        let law = read("motion[1].law").unwrap();
        assert!(law.objection("trapezoid").is_none());
        let (_, hint) = law.objection("trapezoyd").unwrap();
        assert_eq!(hint, Some(Hint::DidYouMean("trapezoid".to_owned())));
        let feedback = read("requirements.feedback").unwrap();
        assert!(feedback.objection("C1024, M512P").is_none() && feedback.objection("C1024, M513P").is_some());
    }
}
