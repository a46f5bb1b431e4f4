//! Recovery from faults of the syntax, line by line: a line that cannot be read hides no fault of another one.
//!
//! The parser goes on behind most faults, but some of them swallow what follows: a key without a value the rest of its
//! table and the next ones, an open list or an open multi-line text everything down to the end. A faulty line is therefore
//! replaced by one of the same length that can be read, so that all places remain those of the file.

use std::ops::Range as Span;
use toml::de::{DeTable, DeValue};

/// Largest number of faults of the syntax that are recovered from.
const FAULTS_MOST: usize = 50;

/// Bytes that may be parsed for the recovery.
const BYTES_MOST: usize = 4 << 20;

/// A file with faults of the syntax as far as it can be read.
#[derive(Debug, Default)]
pub(crate) struct Recovery {
    /// Text to be read instead of that of the file, of equal length; `None` if the file itself is read.
    pub(crate) text: Option<String>,
    /// Faults of the syntax with the messages of the parser.
    pub(crate) faults: Vec<(Span<usize>, String)>,
    /// Lines that are replaced.
    pub(crate) replaced: Vec<Replaced>,
    /// Index of the first fault behind which parts of the file are not read; `None` if all others are.
    pub(crate) hiding: Option<usize>,
}

/// A line that is replaced.
#[derive(Debug)]
pub(crate) struct Replaced {
    /// Place of the line.
    pub(crate) line: Span<usize>,
    /// Key of the line, if no value could be put for it.
    key: Option<String>,
    /// First byte of the heading of its table; zero at the root.
    heading: usize,
}

impl Replaced {
    /// Returns `true` if the line states a key of the table with a place, for which no value could be put.
    pub(crate) fn states(&self, key: &str, table: &Span<usize>) -> bool {
        self.key.as_deref() == Some(key) && self.heading == table.start
    }
}

/// Fault of one parse.
type Found = (Span<usize>, String);

fn parsed(text: &str) -> (Read, Vec<Found>) {
    let (root, errors) = DeTable::parse_recoverable(text);
    let mut found: Vec<Found> =
        errors.iter().map(|error| (error.span().unwrap_or(0..0), error.message().to_owned())).collect();
    // The faults of values come behind those of the structure.
    found.sort_by_key(|(span, _)| span.start);
    let mut read = Read::default();
    read.see(root.get_ref());
    (read, found)
}

/// Amount of a file that a parse reads.
#[derive(Clone, Copy, Debug, Default)]
struct Read {
    /// Number of keys and of entries of lists of tables.
    keys: usize,
    /// Number of values that are none of the file.
    placeless: usize,
}

impl Read {
    fn see(&mut self, table: &DeTable<'_>) {
        for (_, value) in table {
            self.keys += 1;
            self.placeless += usize::from(value.span().is_empty());
            match value.get_ref() {
                DeValue::Table(inner) => self.see(inner),
                DeValue::Array(items) => {
                    for item in items.iter() {
                        if let DeValue::Table(inner) = item.get_ref() {
                            self.keys += 1;
                            self.see(inner);
                        }
                    }
                }
                _ => {}
            }
        }
    }

    /// Returns `true` if a line hides others, or its value has no place: read with it, before, less is known than without.
    const fn is_less_than(&self, without: &Self) -> bool {
        self.keys < without.keys || self.placeless > without.placeless
    }
}

impl Recovery {
    /// Finds the faults of a file, and what can be read of it.
    pub(crate) fn of(text: &str) -> Self {
        let mut recovery = Self::default();
        let (mut read, mut left) = parsed(text);
        if left.is_empty() {
            return recovery;
        }
        let lines = Lines::of(text);
        // All faulty lines replaced; and only those that hide others.
        let mut working = text.to_owned();
        let mut readable = text.to_owned();
        let mut parses = 0;
        while let Some((place, _)) = left.first() {
            let line = lines.at(place.start);
            let is_affordable = parses * text.len() <= BYTES_MOST && recovery.faults.len() < FAULTS_MOST;
            let best = lines
                .candidates(line, &working)
                .into_iter()
                .filter(|_| is_affordable)
                .flat_map(|candidate| {
                    lines.replacements(candidate, text).map(move |replacement| (candidate, replacement))
                })
                .filter_map(|(candidate, (replacement, key))| {
                    parses += 1;
                    let replaced = with(&working, &candidate_span(&lines, candidate), &replacement)?;
                    let (read, errors) = parsed(&replaced);
                    (errors.len() < left.len()).then_some((errors, candidate, replaced, replacement, key, read))
                })
                .min_by_key(|(errors, ..)| errors.len());
            let Some((errors, candidate, replaced, replacement, key, found)) = best else {
                // What is left hides the rest of the file.
                recovery.hiding = Some(recovery.faults.len());
                recovery.faults.append(&mut left);
                break;
            };
            let span = candidate_span(&lines, candidate);
            if candidate == line {
                recovery.faults.extend(left.drain(..).filter(|(place, _)| lines.at(place.start) == line));
            } else {
                // An open bracket or text is reported where it opens; the parser reports it where it cannot go on.
                let unclosed = left.iter().position(|(_, message)| message.starts_with("unclosed")).unwrap_or(0);
                let message = left.swap_remove(unclosed).1;
                let start = span.start + text.get(span.clone()).map_or(0, |line| line.len() - line.trim_start().len());
                recovery.faults.push((start..span.start + lines.written(candidate).trim_end().len(), message));
            }
            let is_heading = lines.is_heading(candidate);
            if is_heading {
                recovery.hiding.get_or_insert(recovery.faults.len() - 1);
            } else if read.is_less_than(&found) {
                if let Some(text) = with(&readable, &span, &replacement) {
                    readable = text;
                }
                recovery.replaced.push(Replaced { line: span, key, heading: lines.heading_of(candidate) });
            }
            (working, read, left) = (replaced, found, errors);
        }
        recovery.text = (!recovery.replaced.is_empty()).then_some(readable);
        recovery
    }
}

fn candidate_span(lines: &Lines<'_>, index: usize) -> Span<usize> {
    lines.spans.get(index).cloned().unwrap_or_default()
}

/// Returns a text with a part replaced by another of the same length.
fn with(text: &str, span: &Span<usize>, replacement: &str) -> Option<String> {
    Some([text.get(..span.start)?, replacement, text.get(span.end..)?].concat())
}

/// Lines of a text.
struct Lines<'t> {
    text: &'t str,
    /// Places without the ends of the lines.
    spans: Vec<Span<usize>>,
}

impl<'t> Lines<'t> {
    fn of(text: &'t str) -> Self {
        let mut start = 0;
        let spans = text.split_inclusive('\n').map(|line| {
            let end = start + line.trim_end_matches(['\n', '\r']).len();
            let span = start..end;
            start += line.len();
            span
        });
        Self { text, spans: spans.collect() }
    }

    fn written(&self, index: usize) -> &'t str {
        self.spans.get(index).and_then(|span| self.text.get(span.clone())).unwrap_or_default()
    }

    /// Returns the line in which a byte lies.
    fn at(&self, byte: usize) -> usize {
        self.spans.partition_point(|span| span.start <= byte).saturating_sub(1)
    }

    fn is_heading(&self, index: usize) -> bool {
        let line = self.written(index).trim_start();
        // An entry of a list of several lines begins with a bracket too, but holds more than a name.
        line.starts_with('[') && !line.contains(['"', '\'', ',']) && line.contains(char::is_alphabetic)
    }

    /// Returns the first byte of the heading above a line; zero without one.
    fn heading_of(&self, index: usize) -> usize {
        let above = (0..index).rev().find(|above| self.is_heading(*above));
        above.map_or(0, |above| {
            let line = self.written(above);
            candidate_span(self, above).start + line.len() - line.trim_start().len()
        })
    }

    /// Returns the lines that may be at fault for a fault in a line: this one, the one before, in which the fault shows only
    /// at its end, and the nearest ones before that open a bracket or a text of several lines without closing it.
    fn candidates(&self, line: usize, working: &str) -> Vec<usize> {
        let current =
            |index: usize| self.spans.get(index).and_then(|span| working.get(span.clone())).unwrap_or_default();
        let opens = |text: &str| {
            let count = |sought: char| text.chars().filter(|c| *c == sought).count();
            count('[') > count(']')
                || count('{') > count('}')
                || ["\"\"\"", "'''"].iter().any(|quotes| text.matches(quotes).count() % 2 == 1)
        };
        let mut found = vec![line];
        found.extend((0..line).rev().find(|index| !current(*index).trim().is_empty()));
        found.extend((0..line).rev().filter(|index| opens(current(*index))).take(2));
        found.dedup();
        found
    }

    /// Returns texts of the length of a line that can be read instead: its key with a value of no use, and nothing, with the
    /// key that it leaves out.
    fn replacements(&self, index: usize, text: &str) -> impl Iterator<Item = (String, Option<String>)> {
        let span = candidate_span(self, index);
        let line = text.get(span).unwrap_or_default();
        let bare = line.trim_start();
        let is_of_key = |c: char| c.is_ascii_alphanumeric() || matches!(c, '-' | '_' | '.');
        let key = bare.get(..bare.find(|c| !is_of_key(c)).unwrap_or(bare.len())).unwrap_or_default();
        let padded = |text: String| {
            let short = line.len().checked_sub(text.len())?;
            Some(text + &" ".repeat(short))
        };
        let named = (!key.is_empty()).then(|| key.rsplit('.').next().unwrap_or(key).to_owned());
        let of_key = (!key.is_empty() && !key.ends_with('.')).then(|| padded(format!("{key}={{}}"))).flatten();
        let nothing = padded(String::new()).map(|text| (text, named));
        of_key.map(|text| (text, None)).into_iter().chain(nothing)
    }
}

#[cfg(test)]
#[path = "recovery_tests.rs"]
mod tests;
