//! Reads a project file against its description and reports every fault at once.

use crate::inputs::Input;
use crate::section::{Entry, Section};
use crate::spec::{Key, Kind, ROOT, Variants};
use crate::tolerance::{TOLERANCES_MOST, Tolerance};
use crate::{Diagnostic, Expected, Fault, Hint, Range};
use quantities::unit::ONE;
use quantities::{Dimension, HalfWidth, Reading, is_unseen};
use std::ops::Range as Span;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// Longest excerpt of a word of the user in a fault, in characters.
const WORD_SHOWN: usize = 60;

/// Longest free text.
const TEXT_MAX: usize = 200;

/// Magnitudes that a machine can have, in SI: from here products and powers of them stay finite.
const MAGNITUDES: std::ops::RangeInclusive<f64> = 1e-12..=1e12;

/// Most moves in one cycle, and most points of a curve.
const LIST_MAX: usize = 10_000;

pub(crate) struct Reader<'t> {
    pub(crate) text: &'t str,
    pub(crate) faults: Vec<Diagnostic>,
    /// The tolerances in the order in which they were read, each under its path in the file.
    pub(crate) tolerances: Vec<Tolerance>,
    /// Every value that is accepted, where that is asked for.
    pub(crate) inputs: Option<Vec<Input>>,
    damaged: bool,
    /// How many faults there are beyond those that are kept.
    more: usize,
}

/// So many faults are told one by one; of further ones only the count, so that the cost stays in proportion to the file.
const FAULTS_MOST: usize = 50;

impl<'t> Reader<'t> {
    pub(crate) const fn new(text: &'t str) -> Self {
        Self { text, faults: Vec::new(), tolerances: Vec::new(), inputs: None, damaged: false, more: 0 }
    }

    /// Reads the whole project file; faults are collected in `self.faults`.
    pub(crate) fn read(&mut self) -> Section {
        self.read_as(ROOT)
    }

    /// Reads a whole file against its description; faults are collected in `self.faults`.
    pub(crate) fn read_as(&mut self, keys: &'static [Key]) -> Section {
        let (root, errors) = DeTable::parse_recoverable(self.text);
        for error in &errors {
            let span = error.span().unwrap_or(0..0);
            self.fault(span, Fault::Syntax { message: error.message().to_owned() }, None);
        }
        self.damaged = !errors.is_empty();
        self.section(root.get_ref(), 0..0, keys, "", self.damaged)
    }

    /// A reader of the same text without faults, for a trial.
    pub(crate) const fn trial(&self) -> Self {
        Self::new(self.text)
    }

    /// Whether the syntax had errors, so that what seems missing may be there.
    pub(crate) const fn is_damaged(&self) -> bool {
        self.damaged
    }

    /// How many faults have been told so far.
    pub(crate) const fn fault_count(&self) -> usize {
        self.faults.len() + self.more
    }

    /// The faults, with a last one that counts those that were not told.
    pub(crate) fn into_faults(mut self) -> Vec<Diagnostic> {
        self.faults.sort_by_key(|fault| (fault.span.start, fault.span.end));
        self.faults.dedup();
        if self.more > 0 {
            let end = self.faults.last().map_or(0, |fault| fault.span.start);
            let fault = Fault::More { count: self.more };
            self.faults.push(Diagnostic::at(self.text, end..end, fault, None));
        }
        self.faults
    }

    pub(crate) fn fault(&mut self, span: Span<usize>, fault: Fault, hint: Option<Hint>) {
        if self.faults.len() >= FAULTS_MOST {
            self.more += 1;
            return;
        }
        let end = span.end.min(self.text.len());
        let start = span.start.min(end);
        self.faults.push(Diagnostic::at(self.text, start..end, fault, hint));
    }

    /// `damaged`: the syntax had errors, so a missing key may stand in the part that could not be read.
    fn section(
        &mut self,
        table: &DeTable<'_>,
        span: Span<usize>,
        keys: &'static [Key],
        path: &str,
        damaged: bool,
    ) -> Section {
        let mut section = Section { span: span.clone(), path: path.to_owned(), ..Section::default() };
        for (name, value) in table {
            let Some(key) = keys.iter().find(|key| key.name == name.get_ref().as_ref()) else {
                // In a damaged file the key may stand under a head that could not be read.
                if !damaged {
                    self.unknown_key(name, keys, path);
                }
                continue;
            };
            let path = joined(path, key.name);
            if let Some(entry) = self.entry(value, key, &path, damaged) {
                if let Some(number) = entry.plain() {
                    self.input(&path, &value.span(), number.map(|number| (number, &ONE)));
                }
                section.entries.insert(key.name, (entry, value.span()));
            } else {
                section.refused.push(key.name);
            }
        }
        if !damaged {
            for key in keys.iter().filter(|key| key.required) {
                if !table.iter().any(|(name, _)| name.get_ref().as_ref() == key.name) {
                    let list = matches!(key.kind, Kind::Variants(_));
                    let path = if list { key.name.to_owned() } else { joined(path, key.name) };
                    let fault = Fault::MissingKey { path, list };
                    self.fault(
                        span.start..span.start + usize::from(!span.is_empty()),
                        fault,
                        example(key).map(Hint::Example),
                    );
                }
            }
        }
        section
    }

    fn unknown_key(&mut self, name: &Spanned<std::borrow::Cow<'_, str>>, keys: &'static [Key], path: &str) {
        let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
        let fault = Fault::UnknownKey { path: joined(path, &shortened(name.get_ref(), WORD_SHOWN)) };
        let hint = self.nearest(name.get_ref(), &names);
        self.fault(name.span(), fault, hint);
    }

    /// "did you mean …", or the whole list where nothing is near.
    fn nearest(&self, written: &str, valid: &[&str]) -> Option<Hint> {
        if self.faults.len() >= FAULTS_MOST {
            return None;
        }
        let written: String = written.chars().take(60).collect();
        // A word that was cut short or spun out is nearer than its count of letters says.
        let akin = valid
            .iter()
            .find(|name| written.len() >= 3 && (name.starts_with(written.as_str()) || written.starts_with(**name)));
        if let Some(name) = akin {
            return Some(Hint::DidYouMean((*name).to_owned()));
        }
        let near = valid
            .iter()
            .map(|name| (strsim::damerau_levenshtein(&written.to_lowercase(), &name.to_lowercase()), *name))
            .min()
            .filter(|(distance, name)| *distance * 2 <= name.chars().count());
        Some(match near {
            Some((_, name)) => Hint::DidYouMean(name.to_owned()),
            None => Hint::valid(valid),
        })
    }

    fn entry(&mut self, value: &Spanned<DeValue<'_>>, key: &'static Key, path: &str, damaged: bool) -> Option<Entry> {
        let span = value.span();
        match (&key.kind, value.get_ref()) {
            (Kind::Quantity(dimension, range), DeValue::String(text)) => {
                self.quantity(text, span, (*dimension, *range), path).map(Entry::Quantity)
            }
            (Kind::Along(..), DeValue::String(text)) => self.along(text, span, key, path),
            (Kind::Quantity(dimension, _) | Kind::Along(dimension, ..), DeValue::Integer(_) | DeValue::Float(_)) => {
                let written = self.text.get(span.clone()).unwrap_or_default().to_owned();
                let fault = Fault::BareNumber { path: path.to_owned(), dimension: *dimension };
                self.fault(span, fault, Some(Hint::WithUnit { written, dimension: *dimension }));
                None
            }
            (Kind::Number(low, high), DeValue::Integer(_) | DeValue::Float(_)) => {
                let number: Option<f64> = self.text.get(span.clone()).and_then(|t| t.replace('_', "").parse().ok());
                match number.filter(|number| number.is_finite() && number >= low && number <= high) {
                    Some(number) => Some(Entry::Number(number)),
                    None => {
                        self.refuse(span, Fault::NumberOutOfRange { path: path.to_owned(), low: *low, high: *high })
                    }
                }
            }
            (Kind::Numbers(low, high, most), DeValue::Array(items)) => {
                self.numbers(items, (*low, *high, *most), span, path)
            }
            (Kind::Integer(low, high), DeValue::Integer(number)) => {
                let number = i64::from_str_radix(number.as_str(), number.radix()).ok();
                match number.filter(|number| number >= low && number <= high) {
                    Some(number) => Some(Entry::Integer(number)),
                    #[allow(clippy::cast_precision_loss, reason = "bounds are small")]
                    None => {
                        let (low, high) = (*low as f64, *high as f64);
                        self.refuse(span, Fault::NumberOutOfRange { path: path.to_owned(), low, high })
                    }
                }
            }
            (Kind::Bool, DeValue::Boolean(value)) => Some(Entry::Bool(*value)),
            (Kind::Text, DeValue::String(text)) => {
                if text.chars().count() > TEXT_MAX {
                    return self.refuse(span, Fault::TextTooLong { path: path.to_owned(), most: TEXT_MAX });
                }
                if text.chars().any(is_unseen) {
                    return self.refuse(span, Fault::ControlCharacter { path: path.to_owned() });
                }
                Some(Entry::Text(text.to_string()))
            }
            (Kind::OneOf(words), DeValue::String(text)) => self.word(text, span, words, path).map(Entry::Text),
            (Kind::ListOf(words), DeValue::Array(items)) => self.list(items, words, path),
            (Kind::Rows(dimensions), DeValue::Array(items)) => self.rows(items, dimensions, span, path),
            (Kind::Table(keys), DeValue::Table(table)) => {
                Some(Entry::Table(self.section(table, span, keys, path, damaged)))
            }
            (Kind::OneOrMany(keys, _), DeValue::Table(table)) => {
                Some(Entry::Table(self.section(table, span, keys, path, damaged)))
            }
            (Kind::OneOrMany(_, keys), DeValue::Array(items)) => self.tables(items, span, (keys, None), path, damaged),
            (Kind::Bodies, DeValue::Array(items)) => self.bodies(items, span, path),
            (Kind::Variants(variants), DeValue::Array(items)) => {
                self.tables(items, span, (variants.keys, Some(variants)), path, damaged)
            }
            (_, found) => {
                let (expected, found) = (key.kind.expected(), found.type_str());
                let fault = Fault::WrongType { path: path.to_owned(), expected, found };
                self.fault(span, fault, example(key).map(Hint::Example));
                None
            }
        }
    }

    pub(crate) fn refuse(&mut self, span: Span<usize>, fault: Fault) -> Option<Entry> {
        self.fault(span, fault, None);
        None
    }

    /// A quantity of the rotation or of the line; a unit of neither is told against the first.
    fn along(&mut self, text: &str, span: Span<usize>, key: &Key, path: &str) -> Option<Entry> {
        let Kind::Along(turning, line, range) = key.kind else { return None };
        let nominal = quantities::without_tolerance(text);
        let dimension = if quantities::parse(line, nominal).is_ok() { line } else { turning };
        self.quantity(text, span, (dimension, range), path).map(|si| Entry::Along(dimension, si))
    }

    fn quantity(
        &mut self,
        text: &str,
        span: Span<usize>,
        (dimension, range): (Dimension, Range),
        path: &str,
    ) -> Option<f64> {
        match quantities::parse_toleranced(dimension, text) {
            Err(error) => {
                let inner = self.inside(&span, text, error.span());
                self.fault(inner, Fault::Quantity { path: path.to_owned(), error }, None);
                None
            }
            Ok((reading, half)) => {
                let fine = range.holds(dimension, reading.si);
                if !self.is_plausible(reading.si, &span, text, path) {
                    return None;
                }
                if !fine {
                    let (path, written) = (path.to_owned(), text.to_owned());
                    let fault = match range {
                        Range::Any => Fault::BelowAbsoluteZero { path, written },
                        _ => Fault::QuantityOutOfRange { path, written, positive: range == Range::Positive },
                    };
                    self.fault(span, fault, None);
                    return None;
                }
                self.tolerance(&reading, half, &span, text, path, (dimension, range))?;
                self.input(path, &span, Some((reading.value, reading.unit)));
                Some(reading.si)
            }
        }
    }

    /// Notes a tolerance whose both ends are values that may stand here; `None` where they may not.
    fn tolerance(
        &mut self,
        reading: &Reading,
        half: Option<HalfWidth>,
        whole: &Span<usize>,
        text: &str,
        path: &str,
        (dimension, range): (Dimension, Range),
    ) -> Option<()> {
        // Nothing is toleranced by nothing.
        let Some(half) = half.filter(|half| half.si > 0.0) else { return Some(()) };
        let span = self.inside(whole, text, half.span);
        for end in [reading.si - half.si, reading.si + half.si] {
            if !range.holds(dimension, end) {
                let fault = Fault::ToleranceEnd { path: path.to_owned(), end, unit: reading.unit, range };
                self.fault(span, fault, None);
                return None;
            }
            if !self.is_plausible(end, &span, text, path) {
                return None;
            }
        }
        let (path, unit) = (path.to_owned(), reading.unit);
        self.note(Tolerance { path, nominal: reading.si, half_width: half.si, unit, span });
        Some(())
    }

    fn note(&mut self, tolerance: Tolerance) {
        if self.tolerances.len() == TOLERANCES_MOST {
            self.fault(tolerance.span.clone(), Fault::TooManyTolerances { most: TOLERANCES_MOST }, None);
        }
        self.tolerances.push(tolerance);
    }

    /// Refuses magnitudes that no machine has.
    fn is_plausible(&mut self, si: f64, span: &Span<usize>, text: &str, path: &str) -> bool {
        let plausible = si == 0.0 || MAGNITUDES.contains(&si.abs());
        if !plausible {
            let (path, written) = (path.to_owned(), text.to_owned());
            let fault = Fault::Implausible { path, written, low: *MAGNITUDES.start(), high: *MAGNITUDES.end() };
            self.fault(span.clone(), fault, None);
        }
        plausible
    }

    /// The place of a part of a string value in the file, where the string is written without escapes.
    fn inside(&self, span: &Span<usize>, text: &str, part: Span<usize>) -> Span<usize> {
        let raw = self.text.get(span.clone()).unwrap_or_default();
        match raw.find(text) {
            Some(at) if !text.is_empty() => {
                let start = span.start + at + part.start.min(text.len());
                let end = span.start + at + part.end.min(text.len());
                if start < end { start..end } else { span.clone() }
            }
            _ => span.clone(),
        }
    }

    fn word(&mut self, text: &str, span: Span<usize>, words: &'static [&'static str], path: &str) -> Option<String> {
        if words.contains(&text) {
            return Some(text.to_owned());
        }
        let hint = self.nearest(text, words);
        let fault = Fault::NotAChoice { path: path.to_owned(), written: shortened(text, WORD_SHOWN) };
        self.fault(span, fault, hint);
        None
    }

    fn list(&mut self, items: &DeArray<'_>, words: &'static [&'static str], path: &str) -> Option<Entry> {
        let mut list = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) => list.extend(self.word(text, item.span(), words, path)),
                other => {
                    let found = other.type_str();
                    let fault = Fault::WrongType { path: path.to_owned(), expected: Expected::Text, found };
                    self.fault(item.span(), fault, None);
                }
            }
        }
        Some(Entry::List(list))
    }

    fn tables(
        &mut self,
        items: &DeArray<'_>,
        span: Span<usize>,
        (keys, variants): (&'static [Key], Option<&'static Variants>),
        path: &str,
        damaged: bool,
    ) -> Option<Entry> {
        if items.len() > LIST_MAX {
            return self.refuse(span, Fault::TooManyEntries { path: path.to_owned(), most: LIST_MAX });
        }
        let mut sections = Vec::new();
        for (index, item) in items.iter().enumerate() {
            let path = format!("{path}[{}]", index + 1);
            match item.get_ref() {
                DeValue::Table(table) => {
                    sections.push(self.section(table, item.span(), keys, &path, damaged));
                    if let Some(variants) = variants {
                        self.variant(table, item.span(), variants, &path, damaged);
                    }
                }
                other => {
                    let fault = Fault::WrongType { path, expected: Expected::Table, found: other.type_str() };
                    self.fault(item.span(), fault, None);
                }
            }
        }
        Some(Entry::Tables(sections))
    }

    /// Solid bodies, one text each; a fault is told at the text that has it.
    fn bodies(&mut self, items: &DeArray<'_>, span: Span<usize>, path: &str) -> Option<Entry> {
        if items.len() > LIST_MAX {
            return self.refuse(span, Fault::TooManyEntries { path: path.to_owned(), most: LIST_MAX });
        }
        let mut lines: Vec<(&str, Span<usize>)> = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) if !text.contains('\n') => lines.push((text, item.span())),
                other => {
                    let found = other.type_str();
                    let fault = Fault::WrongType { path: path.to_owned(), expected: Expected::Text, found };
                    self.fault(item.span(), fault, None);
                }
            }
        }
        let text: Vec<&str> = lines.iter().map(|(text, _)| *text).collect();
        match crate::bodies::toleranced(&text.join("\n")) {
            Ok((answer, tolerances)) => {
                for (line, key, reading, half) in tolerances {
                    let Some((text, whole)) = lines.get(line) else { continue };
                    let path = format!("{path}[{}].{key}", line + 1);
                    self.tolerance(&reading, Some(half), whole, text, &path, (reading.unit.dimension, Range::Any))?;
                }
                for (number, (_, span)) in (1..).zip(&lines) {
                    self.input(&format!("{path}[{number}]"), span, None);
                }
                let bodies = answer.bodies.into_iter().map(|each| each.body).collect();
                (lines.len() == items.len()).then_some(Entry::Bodies(bodies))
            }
            Err(faults) => {
                let starts: Vec<usize> = lines
                    .iter()
                    .scan(0, |next, (text, _)| {
                        let start = *next;
                        *next += text.len() + 1;
                        Some(start)
                    })
                    .collect();
                for fault in faults {
                    let line = fault.line.saturating_sub(1);
                    let (Some((text, whole)), Some(start)) = (lines.get(line), starts.get(line)) else {
                        self.fault(span.clone(), in_body(path, fault.fault), fault.hint);
                        continue;
                    };
                    let part = fault.span.start.saturating_sub(*start)..fault.span.end.saturating_sub(*start);
                    let place = self.inside(whole, text, part);
                    self.fault(place, in_body(path, fault.fault), fault.hint);
                }
                None
            }
        }
    }

    /// The keys of a table must be those of its kind.
    fn variant(&mut self, table: &DeTable<'_>, span: Span<usize>, variants: &Variants, path: &str, damaged: bool) {
        let find = |name: &str| table.iter().find(|(key, _)| key.get_ref().as_ref() == name);
        let Some(kind) = find(variants.by).and_then(|(_, value)| value.get_ref().as_str()) else { return };
        // A misspelt kind is told elsewhere; what it misses is told after the kind that was probably meant.
        let near = |name: &str| strsim::damerau_levenshtein(name, &kind.chars().take(60).collect::<String>());
        let nearest = variants.kinds.iter().min_by_key(|(name, ..)| near(name));
        let Some((_, needed, allowed)) = nearest.filter(|(name, ..)| near(name) * 2 <= name.len()) else { return };
        let damaged = damaged || self.faults.len() >= FAULTS_MOST;
        if !damaged {
            for name in needed.iter().filter(|name| find(name).is_none()) {
                let hint = variants.keys.iter().find(|key| key.name == *name).and_then(example);
                let fault = Fault::MissingKey { path: joined(path, name), list: false };
                self.fault(span.start..span.start + usize::from(!span.is_empty()), fault, hint.map(Hint::Example));
            }
        }
        if !variants.kinds.iter().any(|(name, ..)| *name == kind) {
            return;
        }
        let belongs = |name: &str| {
            name == variants.by || [*needed, *allowed, variants.shared].iter().any(|names| names.contains(&name))
        };
        for (name, _) in table {
            let known = variants.keys.iter().any(|key| key.name == name.get_ref().as_ref());
            if known && !belongs(name.get_ref()) {
                let names: Vec<&str> = [*needed, *allowed].concat();
                let path = joined(path, name.get_ref());
                let fault = Fault::KeyOfAnotherKind { path, by: variants.by, kind: kind.to_owned() };
                self.fault(name.span(), fault, Some(Hint::valid(&names)));
            }
        }
    }

    fn rows(
        &mut self,
        items: &DeArray<'_>,
        dimensions: &'static [Dimension],
        span: Span<usize>,
        path: &str,
    ) -> Option<Entry> {
        if items.len() > LIST_MAX {
            return self.refuse(span, Fault::TooManyEntries { path: path.to_owned(), most: LIST_MAX });
        }
        let mut rows = Vec::new();
        for (index, item) in items.iter().enumerate() {
            let parts: Option<Vec<(&str, Span<usize>)>> = match item.get_ref() {
                DeValue::Array(row) if row.len() == dimensions.len() => {
                    row.iter().map(|part| Some((part.get_ref().as_str()?, part.span()))).collect()
                }
                _ => None,
            };
            let Some(parts) = parts else {
                self.fault(item.span(), Fault::NotARow { path: path.to_owned(), dimensions }, None);
                continue;
            };
            let row: Vec<Option<f64>> = (1..)
                .zip(parts.into_iter().zip(dimensions))
                .map(|(column, ((text, span), dimension))| self.part(*dimension, text, span, path, (index + 1, column)))
                .collect();
            rows.extend(row.into_iter().collect::<Option<Vec<f64>>>());
        }
        Some(Entry::Rows(rows))
    }

    fn part(
        &mut self,
        dimension: Dimension,
        text: &str,
        span: Span<usize>,
        path: &str,
        (row, column): (usize, usize),
    ) -> Option<f64> {
        match quantities::parse_toleranced(dimension, text) {
            Ok((reading, half)) => {
                if !self.is_plausible(reading.si, &span, text, path) {
                    return None;
                }
                let path = format!("{path}[{row}][{column}]");
                self.tolerance(&reading, half, &span, text, &path, (dimension, Range::Any))?;
                self.input(&path, &span, Some((reading.value, reading.unit)));
                Some(reading.si)
            }
            Err(error) => {
                let inner = self.inside(&span, text, error.span());
                self.fault(inner, Fault::Quantity { path: path.to_owned(), error }, None);
                None
            }
        }
    }
}

/// A key within a table.
pub(crate) fn joined(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// The beginning of a text of the user.
pub(crate) fn shortened(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}

fn in_body(path: &str, fault: Fault) -> Fault {
    Fault::InBody { path: path.to_owned(), fault: Box::new(fault) }
}

/// A line that would be valid for a key, `None` for one of no words.
pub fn example(key: &Key) -> Option<String> {
    let name = key.name;
    match key.kind {
        Kind::Quantity(dimension, _) => {
            let example = match name {
                "bearing_life_min" | "gear_life_min" => "20000 h",
                "tilt_angle_max" | "torsion_max" => "2 arcmin",
                "natural_frequency_min" => "25 Hz",
                "mass_max" => "10 kg",
                "pressure_angle" => "20 deg",
                "helix_angle" => "15 deg",
                "wheel_mass" => "1.2 kg",
                "length_max" => "200 mm",
                _ => dimension.example(),
            };
            Some(format!("{name} = \"{example}\""))
        }
        Kind::Integer(low, _) => Some(format!("{name} = {low}")),
        Kind::Number(low, _) => Some(format!("{name} = {low:.1}")),
        Kind::Numbers(..) => Some(format!("{name} = [1.0, 2.5]")),
        Kind::Bool => Some(format!("{name} = true")),
        Kind::Text => Some(format!("{name} = \"…\"")),
        Kind::OneOf(words) => words.first().map(|word| format!("{name} = \"{word}\"")),
        Kind::ListOf(words) => words.first().map(|word| format!("{name} = [\"{word}\"]")),
        Kind::Along(dimension, ..) => Some(format!("{name} = \"{}\"", dimension.example())),
        Kind::Rows(dimensions) => {
            let row: Vec<String> = dimensions.iter().map(|dimension| format!("\"{}\"", dimension.example())).collect();
            Some(format!("{name} = [[{}], …]", row.join(", ")))
        }
        Kind::Table(_) | Kind::OneOrMany(..) => Some(format!("[{name}]")),
        Kind::Bodies => Some(format!("{name} = [\"cylinder diameter=300mm length=20mm density=7850kg/m^3\"]")),
        Kind::Variants(_) => Some(format!("[[{name}]]")),
    }
}
