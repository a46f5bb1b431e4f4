//! Reader of a project file by its description; reports every fault at once.

use crate::bodies::BodyText;
use crate::inputs::Input;
use crate::key::{Key, Kind, Variants, example, keys_at};
use crate::nearest::{in_another_table, meant, nearest, of_the_kind, of_the_quantity};
use crate::recovery::{Recovery, SyntaxFault, is_invisible};
use crate::report::FaultReport;
use crate::section::{Fields, Section};
use crate::stated::SectionHead;
use crate::tolerance::{TOLERANCES_MOST, Tolerance};
use crate::value::{BodyLines, QuantityRow, Rows, ValueCell, WordChoice};
use crate::{Diagnostic, Expected, Fault, Hint, PROJECT_MAX_BYTES, Range};
use quantities::{Dimension, HalfWidth, QuantityError, Reading};
use std::borrow::Cow;
use std::ops::Range as Span;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// Longest excerpt of a word of the user in a fault, in characters.
pub(crate) const WORD_SHOWN: usize = 60;

/// Magnitudes that a machine can have, in SI; their products and powers stay finite.
pub(crate) const MAGNITUDES: std::ops::RangeInclusive<f64> = 1e-12..=1e12;

/// Largest number of moves in one cycle, and of points of a curve.
const LIST_MAX: usize = 10_000;

/// A value of the file with its key.
pub struct FoundValue<'v, 'd> {
    pub(crate) value: &'v DeValue<'d>,
    /// Place in the file, in bytes.
    pub(crate) span: Span<usize>,
    pub(crate) key: &'static Key,
    /// Path: `motion[2].speed`.
    pub(crate) path: &'v str,
}

/// A file while it is read by its description.
pub struct Reader<'t> {
    pub(crate) report: FaultReport<'t>,
    /// Tolerances in the order in which they were read, each under its path in the file.
    pub(crate) tolerances: Vec<Tolerance>,
    /// Accepted values, if requested.
    pub(crate) inputs: Option<Vec<Input>>,
    /// Parts of the file could not be read.
    torn: bool,
}

impl<'t> Reader<'t> {
    pub(crate) const fn new(text: &'t str) -> Self {
        Self { report: FaultReport::new(text), tolerances: Vec::new(), inputs: None, torn: false }
    }

    /// Creates a reader of a file that is not too large.
    pub(crate) fn of_file(text: &'t str) -> Result<Self, Vec<Diagnostic>> {
        Self::within(text, PROJECT_MAX_BYTES)
    }

    /// Creates a reader of a file of at most so many bytes.
    pub(crate) fn within(text: &'t str, most: usize) -> Result<Self, Vec<Diagnostic>> {
        if text.len() > most {
            let fault = Fault::FileTooLarge { bytes: text.len(), most };
            return Err(vec![Diagnostic::at(text, 0..0, fault, None)]);
        }
        Ok(Self::new(text))
    }

    /// Reads a whole file; faults are collected in `self.report`.
    pub(crate) fn read<S: Section>(&mut self) -> S {
        let mut recovery = Recovery::of(self.text(), &|path: &[String]| keys_at(S::KEYS, path));
        self.torn = recovery.is_torn;
        let faults = std::mem::take(&mut recovery.faults);
        let is_damaged = !faults.is_empty();
        for (span, fault) in faults {
            let fault = match fault {
                SyntaxFault::Message { message, hides } => Fault::Syntax { message, hides },
                SyntaxFault::Invisible(sign) => Fault::InvisibleCharacter { sign },
            };
            self.fault(span, fault, None);
        }
        if is_damaged {
            self.report.damage(std::mem::take(&mut recovery.damage), recovery.stopped);
        }
        self.section(&recovery.table(), 0..0, "")
    }

    pub(crate) const fn text(&self) -> &'t str {
        self.report.text()
    }

    pub(crate) fn fault(&mut self, span: Span<usize>, fault: Fault, hint: Option<Hint>) {
        self.report.fault(span, fault, hint);
    }

    fn section<S: Section>(&mut self, table: &DeTable<'_>, span: Span<usize>, path: &str) -> S {
        let mut section = S::absent(&SectionHead::new(path, span.clone()));
        self.fill(&mut section, table, S::KEYS, path);
        self.missing(table, &span, S::KEYS, path);
        section
    }

    /// Reads every key of a table into its field.
    fn fill(&mut self, section: &mut dyn Fields, table: &DeTable<'_>, keys: &'static [Key], path: &str) {
        let mut unknown = Vec::new();
        for (name, value) in table {
            let Some(key) = keys.iter().find(|key| is_name(name.get_ref(), key, table)) else {
                unknown.push((name, value));
                continue;
            };
            self.invisible(name);
            let path = joined(path, key.name);
            let Some(field) = section.field_mut(key.name) else { continue };
            if self.report.is_unread(&value.span()) {
                field.refuse_value();
                continue;
            }
            field.read(&FoundValue { value: value.get_ref(), span: value.span(), key, path: &path }, self);
            // A list is not that of the file without the rows that cannot be read.
            if self.report.is_partial(&value.span()) {
                field.refuse_value();
            }
        }
        section.head_mut().has_strays |= !unknown.is_empty();
        // Only the first faults of the file are listed, with their hints.
        unknown.sort_by_key(|(name, _)| name.span().start);
        for (name, value) in unknown {
            let is_reported = self.report.is_unread(&name.span()) || self.report.is_of_damaged_heading(&name.span());
            // The key may belong to a heading that could not be read.
            if !self.torn && !is_reported {
                self.unknown_key((name, value.get_ref()), (table, keys), path);
            }
        }
    }

    /// Reports an invisible character in a key with quotation marks.
    fn invisible(&mut self, name: &Spanned<Cow<'_, str>>) {
        if let Some(sign) = name.get_ref().chars().find(|sign| is_invisible(*sign)) {
            self.fault(name.span(), Fault::InvisibleCharacter { sign }, None);
        }
    }

    /// Returns `true` if a table has an entry that could not be read and whose key is not known: it may be any key.
    fn has_nameless(&self, table: &DeTable<'_>, keys: &'static [Key]) -> bool {
        let is_nameless = |name: &Spanned<Cow<'_, str>>| {
            self.report.is_unread(&name.span()) && !keys.iter().any(|key| key.name == name.get_ref())
        };
        self.report.is_damaged() && table.iter().any(|(name, _)| is_nameless(name))
    }

    /// Reports the missing required keys of a table.
    fn missing(&mut self, table: &DeTable<'_>, span: &Span<usize>, keys: &'static [Key], path: &str) {
        // A missing key may be in a part that could not be read.
        if self.torn || self.has_nameless(table, keys) {
            return;
        }
        for key in keys.iter().filter(|key| key.required) {
            if !table.iter().any(|(name, _)| is_name(name.get_ref(), key, table)) {
                let list = matches!(key.kind, Kind::Variants(_));
                let path = if list { key.name.to_owned() } else { joined(path, key.name) };
                let place = span.start..span.start + usize::from(!span.is_empty());
                let hint = match key.kind {
                    Kind::OneOf(words) => Some(Hint::valid(words)),
                    _ => example(key).map(Hint::Example),
                };
                self.fault(place, Fault::MissingKey { path, list }, hint);
            }
        }
    }

    fn unknown_key(
        &mut self,
        (name, value): (&Spanned<Cow<'_, str>>, &DeValue<'_>),
        (table, keys): (&DeTable<'_>, &'static [Key]),
        path: &str,
    ) {
        let names: Vec<&str> = keys.iter().map(|key| key.name).collect();
        let hint = self.nearest(&name.span(), name.get_ref(), &names).map(|near| match near {
            Hint::ValidAre(_) => {
                let elsewhere = || in_another_table(name.get_ref(), (table, path));
                // A load of a segment has its own table in every project; other tables may have nothing to do with this one.
                let found = meant(name.get_ref(), keys).or_else(|| elsewhere().filter(Hint::is_of_a_segment));
                let found = found.or_else(|| of_the_quantity(value.as_str()?, keys));
                found.or_else(elsewhere).or_else(|| of_the_kind(table, keys)).unwrap_or(near)
            }
            near => near,
        });
        self.fault(name.span(), Fault::UnknownKey { path: joined(path, &shortened(name.get_ref(), WORD_SHOWN)) }, hint);
    }

    fn nearest(&self, span: &Span<usize>, written: &str, valid: &[&str]) -> Option<Hint> {
        self.report.is_listed(span.start).then(|| nearest(written, valid))
    }

    /// Reports a value of another type than its key has.
    pub(crate) fn wrong_type<T>(&mut self, found: &FoundValue<'_, '_>) -> Option<T> {
        let (expected, written) = (found.key.kind.expected(), found.value.type_str());
        let fault = Fault::WrongType { path: found.path.to_owned(), expected, found: written };
        self.fault(found.span.clone(), fault, example(found.key).map(Hint::Example));
        None
    }

    pub(crate) fn refuse<T>(&mut self, span: Span<usize>, fault: Fault) -> Option<T> {
        self.fault(span, fault, None);
        None
    }

    /// Returns a quantity in SI, rotational or linear if its key allows both.
    pub(crate) fn quantity_of(&mut self, found: &FoundValue<'_, '_>) -> Option<ValueCell> {
        let (dimensions, range): (&[Dimension], Range) = match found.key.kind {
            Kind::Quantity(dimension, range) => (&[dimension], range),
            Kind::Along(turning, line, range) => (&[turning, line], range),
            _ => return self.wrong_type(found),
        };
        match (found.value, dimensions) {
            (DeValue::String(text), _) => {
                self.quantity((text, found.span.clone()), (dimensions, range), (found.path, found.path))
            }
            (DeValue::Integer(_) | DeValue::Float(_), [dimension, ..]) => {
                let written = self.text().get(found.span.clone()).unwrap_or_default().to_owned();
                let fault = Fault::BareNumber { path: found.path.to_owned(), dimension: *dimension };
                self.fault(found.span.clone(), fault, Some(Hint::WithUnit { written, dimension: *dimension }));
                None
            }
            _ => self.wrong_type(found),
        }
    }

    /// Returns a plain number within bounds.
    pub(crate) fn number(&mut self, found: &FoundValue<'_, '_>) -> Option<f64> {
        if let (Kind::Number(low, high), DeValue::String(text)) = (found.key.kind, found.value)
            && found.key.kind.is_ratio()
            && text.trim_end().ends_with('%')
        {
            return match quantities::parse(Dimension::Ratio, text) {
                // Of two decimal numbers the nearest to the quotient: 80 % is 0.8.
                Ok(reading) if (low..=high).contains(&(reading.value / 100.0)) => Some(reading.value / 100.0),
                Ok(_) => {
                    let fault = Fault::NumberOutOfRange { path: found.path.to_owned(), low, high };
                    self.refuse(found.span.clone(), fault)
                }
                Err(error) => {
                    let fault = Fault::Quantity { path: found.path.to_owned(), error, also: Vec::new() };
                    self.refuse(found.span.clone(), fault)
                }
            };
        }
        let (Kind::Number(low, high), DeValue::Integer(_) | DeValue::Float(_)) = (found.key.kind, found.value) else {
            return self.wrong_type(found);
        };
        self.bounded(found.value, found.span.clone(), found.path, (low, high))
    }

    /// Returns a whole number within bounds.
    pub(crate) fn integer(&mut self, found: &FoundValue<'_, '_>) -> Option<u32> {
        let (Kind::Integer(low, high), DeValue::Integer(number)) = (found.key.kind, found.value) else {
            return self.wrong_type(found);
        };
        let number = i64::from_str_radix(number.as_str(), number.radix()).ok();
        let number = number.filter(|number| *number >= low && *number <= high).and_then(|n| u32::try_from(n).ok());
        if number.is_none() {
            #[allow(clippy::cast_precision_loss, reason = "bounds are small")]
            let (low, high) = (low as f64, high as f64);
            self.fault(found.span.clone(), Fault::NumberOutOfRange { path: found.path.to_owned(), low, high }, None);
        }
        number
    }

    /// Returns one of a fixed set of words.
    pub(crate) fn choice<W: WordChoice>(&mut self, found: &FoundValue<'_, '_>) -> Option<W> {
        let DeValue::String(text) = found.value else { return self.wrong_type(found) };
        self.word(text, found.span.clone(), found.path)
    }

    fn word<W: WordChoice>(&mut self, text: &str, span: Span<usize>, path: &str) -> Option<W> {
        let choice = W::of_word(text);
        if choice.is_none() {
            let hint = self.nearest(&span, text, W::WORDS);
            let fault = Fault::NotAChoice { path: path.to_owned(), written: shortened(text, WORD_SHOWN) };
            self.fault(span, fault, hint);
        }
        choice
    }

    /// Returns several words of a fixed set; other words are reported and left out.
    pub(crate) fn choices<W: WordChoice>(&mut self, found: &FoundValue<'_, '_>) -> Option<Vec<W>> {
        let DeValue::Array(items) = found.value else { return self.wrong_type(found) };
        if items.is_empty() {
            // It would require nothing, or nothing that can be met: the key is omitted instead.
            self.fault(
                found.span.clone(),
                Fault::EmptyList { path: found.path.to_owned() },
                Some(Hint::valid(W::WORDS)),
            );
            return None;
        }
        let mut list = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) => list.extend(self.word(text, item.span(), found.path)),
                other => self.of_another_type(found.path, item.span(), Expected::Text, other),
            }
        }
        Some(list)
    }

    /// Reports an entry of another type than the list has.
    pub(crate) fn of_another_type(&mut self, path: &str, span: Span<usize>, expected: Expected, found: &DeValue<'_>) {
        self.fault(span, Fault::WrongType { path: path.to_owned(), expected, found: found.type_str() }, None);
    }

    /// Reads a table.
    pub(crate) fn table<S: Section>(&mut self, found: &FoundValue<'_, '_>) -> Option<S> {
        match found.value {
            DeValue::Table(table) => Some(self.section(table, found.span.clone(), found.path)),
            _ => self.wrong_type(found),
        }
    }

    /// Returns a quantity of one of several dimensions, in SI; another unit is reported for the dimension with the
    /// nearest one. `path` is that of the key, `place` that of the value.
    pub(crate) fn quantity(
        &mut self,
        (text, span): (&str, Span<usize>),
        (dimensions, range): (&[Dimension], Range),
        (path, place): (&str, &str),
    ) -> Option<ValueCell> {
        let dimension = one_of(dimensions, text)?;
        match quantities::parse_toleranced(dimension, text) {
            Err(_) => {
                for error in quantities::quantity_faults(dimension, text) {
                    let inner = inside(self.text(), &span, text, error.span());
                    let also = dimensions.iter().copied().filter(|other| *other != dimension).collect();
                    // The bounds of a recording are not those of its clock.
                    let is_bound = [".from", ".to"].iter().any(|key| path.ends_with(key));
                    let hint = (is_bound && is_clock(text)).then_some(Hint::TimeOfClock);
                    self.fault(inner, Fault::Quantity { path: path.to_owned(), error, also }, hint);
                }
                None
            }
            Ok((reading, half)) => {
                if !self.is_plausible(reading.si, &span, text, path) {
                    return None;
                }
                if !range.holds(dimension, reading.si) {
                    let (path, written) = (path.to_owned(), text.to_owned());
                    let fault = match range {
                        Range::Any => Fault::BelowAbsoluteZero { path, written },
                        _ => Fault::QuantityOutOfRange { path, written, positive: range == Range::Positive },
                    };
                    self.fault(span, fault, None);
                    return None;
                }
                self.tolerance(&reading, half, &span, text, place, (dimension, range))?;
                self.input(place, &span, Some((reading.value, reading.unit)));
                Some((dimension, reading.si))
            }
        }
    }

    /// Records a tolerance if both of its ends are permissible values; `None` if they are not.
    fn tolerance(
        &mut self,
        reading: &Reading,
        half: Option<HalfWidth>,
        whole: &Span<usize>,
        text: &str,
        path: &str,
        (dimension, range): (Dimension, Range),
    ) -> Option<()> {
        // A tolerance of zero is ignored.
        let Some(half) = half.filter(|half| half.si > 0.0) else { return Some(()) };
        let span = inside(self.text(), whole, text, half.span);
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

    /// Reports magnitudes that no machine has.
    fn is_plausible(&mut self, si: f64, span: &Span<usize>, text: &str, path: &str) -> bool {
        let plausible = si == 0.0 || MAGNITUDES.contains(&si.abs());
        if !plausible {
            let (path, written) = (path.to_owned(), text.to_owned());
            let fault = Fault::Implausible { path, written, low: *MAGNITUDES.start(), high: *MAGNITUDES.end() };
            self.fault(span.clone(), fault, None);
        }
        plausible
    }

    /// Reads an array of tables; with `variants` each is of one of several kinds.
    pub(crate) fn tables<S: Section>(
        &mut self,
        found: &FoundValue<'_, '_>,
        variants: Option<&'static Variants>,
    ) -> Option<Vec<S>> {
        let items = self.items(found)?;
        let mut sections = Vec::new();
        for (index, item) in items.iter().enumerate() {
            let path = format!("{}[{}]", found.path, index + 1);
            match item.get_ref() {
                DeValue::Table(table) => {
                    sections.push(self.section(table, item.span(), &path));
                    if let Some(variants) = variants {
                        self.variant(table, item.span(), variants, &path);
                    }
                }
                other => self.of_another_type(&path, item.span(), Expected::Table, other),
            }
        }
        Some(sections)
    }

    /// Returns the entries of a list, if there are not too many.
    pub(crate) fn items<'v, 'd>(&mut self, found: &FoundValue<'v, 'd>) -> Option<&'v DeArray<'d>> {
        let DeValue::Array(items) = found.value else { return self.wrong_type(found) };
        if items.len() > LIST_MAX {
            let fault = Fault::TooManyEntries { path: found.path.to_owned(), most: LIST_MAX };
            return self.refuse(found.span.clone(), fault);
        }
        Some(items)
    }

    /// Reads solid bodies, one text each; a fault is reported at its text.
    pub(crate) fn bodies(&mut self, found: &FoundValue<'_, '_>) -> Option<BodyLines> {
        let (items, path, span) = (self.items(found)?, found.path, &found.span);
        let mut lines: Vec<(&str, Span<usize>)> = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::String(text) if !text.contains('\n') => lines.push((text, item.span())),
                other => self.of_another_type(path, item.span(), Expected::Text, other),
            }
        }
        let text = lines.iter().map(|(text, _)| *text).collect::<Vec<_>>().join("\n");
        let starts: Vec<usize> = crate::bodies::lines(&text).map(|(start, _)| start).collect();
        let file = self.text();
        let place = |line: usize, part: Span<usize>| match (lines.get(line), starts.get(line)) {
            (Some((text, whole)), Some(start)) => {
                inside(file, whole, text, part.start.saturating_sub(*start)..part.end.saturating_sub(*start))
            }
            _ => span.clone(),
        };
        let (BodyText { bodies, faults, more }, tolerances) = crate::bodies::toleranced(&text, &place);
        let is_whole = faults.is_empty() && lines.len() == items.len();
        if faults.is_empty() {
            for (line, key, reading, half) in tolerances {
                let Some((text, whole)) = lines.get(line) else { continue };
                let path = format!("{path}[{}].{key}", line + 1);
                self.tolerance(&reading, Some(half), whole, text, &path, (reading.unit.dimension, Range::Any))?;
            }
            for (number, (_, span)) in (1..).zip(&lines) {
                self.input(&format!("{path}[{number}]"), span, None);
            }
        }
        for fault in faults {
            let at = place(fault.line.saturating_sub(1), fault.span);
            self.fault(at, in_body(path, fault.fault), fault.hint);
        }
        if more > 0 {
            self.fault(span.clone(), in_body(path, Fault::More { count: more }), None);
        }
        Some(BodyLines { bodies, is_whole })
    }

    /// Checks that the keys of a table are those of its kind.
    fn variant(&mut self, table: &DeTable<'_>, span: Span<usize>, variants: &Variants, path: &str) {
        let is = |written: &str, name: &str| written == name || written.replace(is_invisible, "") == name;
        let find = |name: &str| table.iter().find(|(key, _)| is(key.get_ref(), name));
        let Some(kind) = find(variants.by).and_then(|(_, value)| value.get_ref().as_str()) else { return };
        // An unknown kind is reported elsewhere; until it is known, no key can be missing that only some kinds need.
        let Some((_, needed, allowed)) = variants.kinds.iter().find(|(name, ..)| *name == kind) else { return };
        let is_silent = self.torn || !self.report.is_listed(span.start) || self.has_nameless(table, variants.keys);
        if !is_silent {
            let missing: Vec<&str> = needed.iter().filter(|name| find(name).is_none()).copied().collect();
            for name in missing {
                let hint = variants.keys.iter().find(|key| key.name == name).and_then(example);
                let fault = Fault::MissingKey { path: joined(path, name), list: false };
                self.fault(span.start..span.start + usize::from(!span.is_empty()), fault, hint.map(Hint::Example));
            }
        }
        let belongs = |name: &str| {
            name == variants.by || [*needed, *allowed, variants.shared].iter().any(|names| names.contains(&name))
        };
        for (name, _) in table {
            let written = name.get_ref().replace(is_invisible, "");
            let known = variants.keys.iter().find(|key| key.name == written);
            if let Some(key) = known.filter(|_| !belongs(&written)) {
                let names: Vec<&str> = [*needed, *allowed].concat();
                let list = path.rsplit('.').next().and_then(|last| last.split('[').next()).unwrap_or_default();
                // A key of one kind alone: that of a table of its own.
                let hint = match variants.only_kind_with(&written) {
                    Some(line) => Hint::KeyOfTable { key: key.name, table: format!("[[{list}]] {line}") },
                    None => Hint::valid(&names),
                };
                let path = joined(path, &written);
                let fault = Fault::KeyOfAnotherKind { path, by: variants.by, kind: kind.to_owned() };
                self.fault(name.span(), fault, Some(hint));
            }
        }
    }

    /// Reads rows of quantities.
    pub(crate) fn rows<P: QuantityRow>(&mut self, found: &FoundValue<'_, '_>) -> Option<Rows<P>> {
        let (items, path, columns) = (self.items(found)?, found.path, P::COLUMNS);
        let mut rows = Vec::new();
        for (index, item) in items.iter().enumerate() {
            let parts: Option<Vec<(&str, Span<usize>)>> = match item.get_ref() {
                DeValue::Array(row) if row.len() == columns.len() => {
                    row.iter().map(|part| Some((part.get_ref().as_str()?, part.span()))).collect()
                }
                _ => None,
            };
            let Some(parts) = parts else {
                self.fault(item.span(), Fault::NotARow { path: path.to_owned(), columns }, None);
                continue;
            };
            let row: Vec<Option<ValueCell>> = (1..)
                .zip(parts.into_iter().zip(columns))
                .map(|(number, (part, column))| {
                    let place = format!("{path}[{}][{number}]", index + 1);
                    self.quantity(part, (column, Range::Any), (path, &place))
                })
                .collect();
            let row = row.into_iter().collect::<Option<Vec<ValueCell>>>().and_then(|row| P::of(&row));
            rows.extend(row.map(|row| (row, item.span())));
        }
        let is_whole = rows.len() == items.len();
        Some(Rows { rows, is_whole })
    }
}

/// Returns the place of a part of a string value in the file, if the string is written without escapes.
fn inside(file: &str, span: &Span<usize>, text: &str, part: Span<usize>) -> Span<usize> {
    let raw = file.get(span.clone()).unwrap_or_default();
    match raw.find(text) {
        Some(at) if !text.is_empty() => {
            let start = span.start + at + part.start.min(text.len());
            let end = span.start + at + part.end.min(text.len());
            if start < end { start..end } else { span.clone() }
        }
        _ => span.clone(),
    }
}

/// Returns `true` if a name is that of a key, apart from invisible characters if the table has no other one of the name.
fn is_name(written: &str, key: &Key, table: &DeTable<'_>) -> bool {
    let is_spoiled = || written.chars().any(is_invisible) && written.replace(is_invisible, "") == key.name;
    written == key.name || (is_spoiled() && !table.iter().any(|(name, _)| name.get_ref() == key.name))
}

/// Returns `true` if a text has a colon between digits, as the time of a clock.
fn is_clock(text: &str) -> bool {
    text.as_bytes().windows(3).any(|three| matches!(three, [b'0'..=b'9', b':', b'0'..=b'9']))
}

/// Returns the dimension that a text states; if it states none of them, the one with a similarly spelt unit, else the
/// first.
fn one_of(dimensions: &[Dimension], text: &str) -> Option<Dimension> {
    if let [only] = dimensions {
        return Some(*only);
    }
    let nominal = quantities::without_tolerance(text);
    let distance = |dimension: &Dimension| match quantities::parse(*dimension, nominal) {
        Ok(_) => 0,
        Err(QuantityError::UnitUnknown { nearest: None, .. } | QuantityError::WrongQuantity { .. }) => 2,
        Err(_) => 1,
    };
    dimensions.iter().copied().min_by_key(distance)
}

/// Joins a path and a key.
pub(crate) fn joined(path: &str, key: &str) -> String {
    if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") }
}

/// Returns the beginning of a text of the user.
#[must_use]
pub fn shortened(text: &str, most: usize) -> String {
    text.chars().take(most).collect()
}

fn in_body(path: &str, fault: Fault) -> Fault {
    Fault::InBody { path: path.to_owned(), fault: Box::new(fault) }
}
