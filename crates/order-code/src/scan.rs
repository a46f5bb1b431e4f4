//! Splitting of a text into words: separators, readings, and diagnosis of text without a reading.

use crate::departure::Departure;
use crate::error::{CodeError, CodeErrors, Expected, nearest_token};
use crate::field::Field;
use crate::grammar::{FieldWords, Series};
use crate::tokens::{FoundWord, Step, complete_readings, in_any_order, readings};
use std::cell::OnceCell;
use std::ops::Range;

/// Length limit of a code in characters: the longest code has 29, or 45 with spaces around its hyphens.
const LENGTH_MAX: usize = 64;

/// Length above which an unknown text may hold several words, so that a missing word cannot be distinguished from a
/// misspelt one.
const LENGTH_WORD_MAX: usize = 7;

/// Kind of text that is scanned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ScannedText {
    /// A code with all mandatory fields.
    Code,
    /// A partial code that may contain wildcards and end after any field.
    Pattern,
}

/// Returns the words of a text in the order of the fields, with its departures, or all faults.
pub(crate) fn scan(
    text: &str,
    series: Series,
    form: ScannedText,
) -> Result<(Vec<FoundWord>, Vec<Departure>), CodeErrors> {
    if let Some((at, _)) = text.char_indices().nth(LENGTH_MAX) {
        return Err(CodeError::TooLong { span: at..text.len(), most: LENGTH_MAX }.into());
    }
    let Parts { parts, departures, faults, trailing } = split(text, series);
    if parts.is_empty() && form == ScannedText::Code && faults.is_empty() {
        return Err(CodeError::Empty.into());
    }
    let only_hyphens = parts.is_empty() && !faults.is_empty();
    let mut reader = Reader {
        text,
        series,
        fields: series.words_of_fields(),
        form,
        next: 0,
        seen: Vec::new(),
        tokens: Vec::new(),
        departures,
        faults,
        swallowed: only_hyphens,
    };
    for (index, part) in parts.iter().enumerate() {
        reader.read(part, parts.get(index + 1..).unwrap_or_default());
    }
    if let Some(span) = trailing {
        let expected = reader.expected();
        reader.faults.push(CodeError::EmptyPart { span, expected });
    }
    reader.finish(parts.last().map_or(0, |part| part.span.end))
}

/// A part of the text between separators.
struct Part {
    capitals: String,
    series: Series,
    span: Range<usize>,
    /// Cache of [`Part::in_any_order`].
    any_order: OnceCell<Option<Vec<Step>>>,
}

impl Part {
    /// Returns the whole part as known words in any order; computed once.
    fn in_any_order(&self) -> Option<&[Step]> {
        self.any_order.get_or_init(|| in_any_order(&self.capitals, self.series)).as_deref()
    }
}

/// Parts of a text, with the departures and faults of its separators.
struct Parts {
    parts: Vec<Part>,
    departures: Vec<Departure>,
    faults: Vec<CodeError>,
    /// Separator after the last part.
    trailing: Option<Range<usize>>,
}

fn is_other_dash(c: char) -> bool {
    matches!(c, '‐' | '‑' | '‒' | '–' | '—' | '―' | '−')
}

fn is_dash(c: char) -> bool {
    c == '-' || is_other_dash(c)
}

/// Returns `true` for spaces of any width; tabs and line ends inside a code are slips.
fn is_space(c: char) -> bool {
    c.is_whitespace() && !c.is_control() && !matches!(c, '\u{2028}' | '\u{2029}')
}

fn split(text: &str, series: Series) -> Parts {
    let mut found = Parts { parts: Vec::new(), departures: Vec::new(), faults: Vec::new(), trailing: None };
    let trimmed = text.trim();
    if trimmed.len() != text.len() {
        found.departures.push(Departure::SurroundingSpace);
    }
    let mut rest = trimmed;
    let mut at = text.len() - text.trim_start().len();
    while !rest.is_empty() {
        let separates = |c: char| is_dash(c) || is_space(c);
        let (part, tail) = rest.split_at(rest.find(separates).unwrap_or(rest.len()));
        let (gap, next) = tail.split_at(tail.find(|c: char| !separates(c)).unwrap_or(tail.len()));
        let span = at..at + part.len();
        let gap_span = span.end..span.end + gap.len();
        at = gap_span.end;
        rest = next;
        if !part.is_empty() {
            // ASCII only: no other letter may become one of a word ("ſp" is not SP), and byte offsets must not change.
            found.parts.push(Part { capitals: part.to_ascii_uppercase(), series, span, any_order: OnceCell::new() });
        }
        let dashes = gap.chars().filter(|c| is_dash(*c)).count();
        if dashes > 0 && next.is_empty() && !found.parts.is_empty() {
            found.trailing = Some(gap_span);
        } else if dashes > 1 || (dashes == 1 && (part.is_empty() || next.is_empty())) {
            let expected = Expected { series, fields: Vec::new() };
            found.faults.push(CodeError::EmptyPart { span: gap_span, expected });
        } else {
            if gap.contains(is_space) {
                found.departures.push(Departure::Spaces { span: gap_span.clone() });
            }
            if let Some((offset, dash)) = gap.char_indices().find(|(_, c)| is_other_dash(*c)) {
                let start = gap_span.start + offset;
                found.departures.push(Departure::OtherDash { span: start..start + dash.len_utf8() });
            }
        }
    }
    found
}

/// Words and parts that follow a word: the remaining words of its part and the remaining parts.
struct Ahead<'a> {
    steps: &'a [Step],
    parts: &'a [Part],
}

impl Ahead<'_> {
    /// Returns `true` if a word of this field follows, in any order; used for faulty codes only.
    fn names(&self, field: Field) -> bool {
        let named = |steps: &[Step]| steps.iter().any(|step| step.0 == field);
        named(self.steps) || self.parts.iter().any(|part| part.in_any_order().is_some_and(named))
    }
}

/// Reads the parts one by one.
struct Reader<'a> {
    text: &'a str,
    series: Series,
    fields: &'static [FieldWords],
    form: ScannedText,
    /// Index of the first field that may follow.
    next: usize,
    /// Fields named so far, including those in a wrong position.
    seen: Vec<Field>,
    tokens: Vec<FoundWord>,
    departures: Vec<Departure>,
    faults: Vec<CodeError>,
    /// An unknown text was long enough to hold a missing word.
    swallowed: bool,
}

impl Reader<'_> {
    /// Reads one part; `ahead` are the remaining parts.
    fn read(&mut self, part: &Part, ahead: &[Part]) {
        if self.form == ScannedText::Pattern
            && part.capitals == "*"
            && let Some(known) = self.open().first()
        {
            self.tokens.push(FoundWord { field: known.field, token: None, span: part.span.clone() });
            self.next += 1;
            return;
        }
        let mut found = complete_readings(&part.capitals, self.open());
        if found.len() > 1 {
            let joined = |steps: &Vec<Step>| steps.iter().map(|step| step.1).collect::<Vec<_>>().join("-");
            let readings = found.iter().map(joined).collect();
            self.faults.push(CodeError::Ambiguous {
                span: part.span.clone(),
                found: self.written(&part.span),
                readings,
            });
            self.swallowed = true;
            return;
        }
        let steps = found.pop();
        match steps.as_deref().or_else(|| part.in_any_order()) {
            Some(steps) => self.place_all(steps, part.span.start, ahead),
            None => self.diagnose(part, ahead),
        }
    }

    /// Returns the fields that may follow, in their order.
    fn open(&self) -> &'static [FieldWords] {
        self.fields.get(self.next..).unwrap_or_default()
    }

    fn position(&self, field: Field) -> usize {
        self.fields.iter().position(|known| known.field == field).unwrap_or(0)
    }

    fn expected(&self) -> Expected {
        Expected { series: self.series, fields: self.reachable() }
    }

    /// Returns the fields whose words are allowed here: up to and including the first mandatory one.
    fn reachable(&self) -> Vec<Field> {
        let mut fields = Vec::new();
        for known in self.open().iter().filter(|known| !self.seen.contains(&known.field)) {
            fields.push(known.field);
            if !known.is_optional {
                break;
            }
        }
        fields
    }

    /// Returns the mandatory fields among `fields` that have not been named.
    fn needed(&self, fields: &[FieldWords]) -> Vec<Field> {
        let needed = fields.iter().filter(|known| !known.is_optional && !self.seen.contains(&known.field));
        needed.map(|known| known.field).collect()
    }

    fn written(&self, span: &Range<usize>) -> String {
        self.text.get(span.clone()).unwrap_or_default().chars().take(24).collect()
    }

    /// Places known words one after another, beginning at byte `start`.
    fn place_all(&mut self, steps: &[Step], start: usize, ahead: &[Part]) {
        for (index, (field, token, offset)) in steps.iter().enumerate() {
            let begin = start + offset;
            if index > 0 {
                self.departures.push(Departure::MissingHyphen { at: begin });
            }
            let later = Ahead { steps: steps.get(index + 1..).unwrap_or_default(), parts: ahead };
            self.place(FoundWord { field: *field, token: Some(token), span: begin..begin + token.len() }, &later);
        }
    }

    /// Places a known word, or records why it is not allowed here.
    fn place(&mut self, word: FoundWord, ahead: &Ahead<'_>) {
        let (field, span, place) = (word.field, word.span.clone(), self.position(word.field));
        let found = self.written(&span);
        if self.seen.contains(&field) {
            let expected = self.expected();
            self.faults.push(CodeError::Repeated { field, span, found, expected });
            return;
        }
        let skipped: Vec<Field> = self.needed(self.fields.get(self.next..place).unwrap_or_default());
        // The word is too late, or too early because words that must precede it still follow.
        if place < self.next || skipped.iter().any(|field| ahead.names(*field)) {
            let expected = self.expected();
            self.faults.push(CodeError::OutOfOrder { field, span, found, expected });
            self.seen.push(field);
            return;
        }
        let series = self.series;
        self.faults.extend(skipped.into_iter().map(|field| CodeError::Missing { field, at: span.start, series }));
        self.next = place + 1;
        self.seen.push(field);
        if word.token.is_some_and(|token| token != found) {
            self.departures.push(Departure::LowerCase { span });
        }
        self.tokens.push(word);
    }

    /// Records the faults of a part that is not a sequence of known words.
    fn diagnose(&mut self, part: &Part, ahead: &[Part]) {
        let whole_is_near = nearest_token(&part.capitals, self.series, &self.reachable()).is_some();
        let mut from = 0;
        if !whole_is_near && !part.capitals.contains('*') {
            // Known words without hyphens in front of the unknown one.
            if let Some((end, steps)) = readings(&part.capitals, self.open()).into_iter().max_by_key(|(end, _)| *end) {
                self.place_all(&steps, part.span.start, ahead);
                from = end;
            }
        }
        let rest = part.capitals.get(from..).unwrap_or_default();
        // Known words after it, if exactly one field is expected here.
        let expected = self.expected();
        let behind = match &expected[..] {
            [only] if !self.series.is_optional(*only) && !whole_is_near => {
                known_behind(rest, self.fields.get(self.position(*only) + 1..).unwrap_or_default())
            }
            _ => None,
        };
        let length = behind.as_ref().map_or(rest.len(), |(length, _)| *length);
        let start = part.span.start + from;
        let span = start..start + length;
        let steps = behind.as_ref().map_or(&[][..], |(_, steps)| steps);
        self.unknown(span, expected, &Ahead { steps, parts: ahead });
        if let Some((length, steps)) = behind {
            self.place_all(&steps, start + length, ahead);
        }
    }

    /// Records an unknown word.
    fn unknown(&mut self, span: Range<usize>, expected: Expected, ahead: &Ahead<'_>) {
        let found = self.written(&span);
        let near = nearest_token(&found, self.series, &expected).map(|(field, _)| field);
        let field = near.or(expected.first().copied()).unwrap_or(Field::Special);
        self.swallowed |= found.chars().count() > LENGTH_WORD_MAX;
        // The unknown word stands for the expected field, unless a word of that field still follows.
        if !self.series.is_optional(field) && !ahead.names(field) {
            self.next = self.next.max(self.position(field) + 1);
        }
        self.faults.push(CodeError::UnknownToken { field, span, found, expected });
    }

    fn finish(mut self, end: usize) -> Result<(Vec<FoundWord>, Vec<Departure>), CodeErrors> {
        if self.form == ScannedText::Code && !self.swallowed {
            let (missing, series) = (self.needed(self.open()), self.series);
            self.faults.extend(missing.into_iter().map(|field| CodeError::Missing { field, at: end, series }));
        }
        if !self.faults.is_empty() {
            let understood = self.tokens.iter().filter_map(|found| Some((found.field, found.token?))).collect();
            return Err(CodeErrors::new(self.faults, self.series, understood));
        }
        self.departures.sort_by_key(|departure| departure.span().map_or(0, |span| span.start));
        Ok((self.tokens, self.departures))
    }
}

/// Returns the length of the shortest beginning of `text` after which only known words of the fields follow, with those
/// words.
fn known_behind(text: &str, fields: &[FieldWords]) -> Option<(usize, Vec<Step>)> {
    text.char_indices().skip(1).find_map(|(at, _)| {
        let steps = complete_readings(text.get(at..)?, fields).into_iter().next()?;
        Some((at, steps))
    })
}
