//! What can be wrong with a body as it is written, in English and German.

use super::{AXES, BODY_SHAPES, BodyShape, BodyTolerance, Keyed, Line};
use crate::diagnostic::Diagnostic;
use crate::text::{Speak, either};
use mechanism::{BodyError, Orientation};
use quantities::unit::{KILOGRAM, KILOGRAM_PER_CUBIC_METRE, MILLIMETRE};
use quantities::{Dimension, HalfWidth, Language, Measure, Unit, format_significant};
use std::ops::Range;

/// More faults than this are counted, not told.
const FAULTS_MOST: usize = 50;

/// Longest excerpt of the text in a message, in characters.
const EXCERPT_MOST: usize = 60;

/// The faults of a text.
pub(super) struct Faults<'t> {
    text: &'t str,
    language: Language,
    found: Vec<Diagnostic>,
    more: usize,
    /// The tolerances of the bodies; `None` where none may stand.
    pub(super) tolerances: Option<Vec<BodyTolerance>>,
    /// The line that is being read, from zero, and where it begins.
    line: (usize, usize),
}

/// The keys that an error is about; empty where it is about the mass that is missing, or the whole body.
pub(super) const fn fields(error: &BodyError) -> &'static [&'static str] {
    match error {
        BodyError::DimensionOutOfRange { field, .. } => match field.as_bytes() {
            b"diameter" => &["diameter"],
            b"length" => &["length"],
            b"outer" => &["outer"],
            b"inner" => &["inner"],
            b"a" => &["a"],
            b"b" => &["b"],
            _ => &["height"],
        },
        BodyError::InnerNotBelowOuter { .. } => &["inner", "outer"],
        BodyError::MassAndDensity { .. } | BodyError::NoVolume | BodyError::DensityOutOfRange { .. } => &["density"],
        BodyError::MassOutOfRange { .. } => &["mass"],
        BodyError::DistanceOutOfRange { .. } => &["distance"],
        BodyError::AngleNotFinite => &["angle"],
        BodyError::NoPiece => &["count"],
        _ => &[],
    }
}

impl<'t> Faults<'t> {
    pub(super) const fn new(text: &'t str, language: Language) -> Self {
        Self { text, language, found: Vec::new(), more: 0, tolerances: None, line: (0, 0) }
    }

    pub(super) fn with_tolerances(text: &'t str, language: Language) -> Self {
        Self { tolerances: Some(Vec::new()), ..Self::new(text, language) }
    }

    /// Says which line comes now.
    pub(super) const fn begin(&mut self, index: usize, start: usize) {
        self.line = (index, start);
    }

    pub(super) const fn is_empty(&self) -> bool {
        self.found.is_empty()
    }

    /// The faults in the order of the text.
    pub(super) fn take(&mut self) -> Vec<Diagnostic> {
        let mut found = std::mem::take(&mut self.found);
        found.sort_by_key(|fault| (fault.span.start, fault.span.end));
        if self.more > 0 {
            let end = self.text.len();
            found.push(Diagnostic::at(self.text, end..end, self.language.more_faults(self.more), None));
        }
        found
    }

    fn fault(&mut self, span: Range<usize>, en: String, de: String, hint: Option<String>) {
        if self.found.len() >= FAULTS_MOST {
            self.more += 1;
            return;
        }
        self.found.push(Diagnostic::at(self.text, span, either(self.language, en, de), hint));
    }

    /// "did you mean …", or the whole list where nothing is near.
    fn nearest(&self, written: &str, valid: &[&str]) -> String {
        if self.found.len() >= FAULTS_MOST {
            return String::new();
        }
        match nearest_of(written, valid) {
            Some(name) => self.language.did_you_mean(name),
            None => self.language.valid_are(valid),
        }
    }

    /// The shape of a line.
    pub(super) fn shape(&mut self, line: &Line<'_>) -> Option<&'static BodyShape> {
        let found = BODY_SHAPES.iter().find(|shape| shape.name == line.shape.to_lowercase());
        if found.is_some() {
            return found;
        }
        let names: Vec<&str> = BODY_SHAPES.iter().map(|shape| shape.name).collect();
        if line.shape.is_empty() {
            let (en, de) = if line.pairs.is_empty() {
                ("a body is missing", "ein Körper fehlt")
            } else {
                ("the shape of the body is missing; it stands first", "die Form des Körpers fehlt; sie steht zuerst")
            };
            let hint = if line.pairs.is_empty() {
                self.language.for_example("cylinder diameter=200mm length=20mm density=7850kg/m^3")
            } else {
                self.language.valid_are(&names)
            };
            self.fault(line.shape_span.clone(), en.to_owned(), de.to_owned(), Some(hint));
            return None;
        }
        let hint = self.nearest(line.shape, &names);
        let word = excerpt(line.shape);
        self.fault(
            line.shape_span.clone(),
            format!("`{word}` is not a shape"),
            format!("`{word}` ist keine Form"),
            Some(hint),
        );
        None
    }

    /// Text that belongs to no key.
    pub(super) fn stray(&mut self, (text, span): &(&str, Range<usize>)) {
        let word = excerpt(text);
        let hint = self.language.for_example("diameter=200mm");
        self.fault(
            span.clone(),
            format!("`{word}` has no key; expected: key=value"),
            format!("`{word}` hat keinen Schlüssel; erwartet: Schlüssel=Wert"),
            Some(hint),
        );
    }

    /// A key that the shape does not have; gives the one that was probably meant.
    pub(super) fn unknown_key<'n>(
        &mut self,
        pair: &Keyed<'_>,
        shape: Option<&BodyShape>,
        valid: &[&'n str],
    ) -> Option<&'n str> {
        let key = excerpt(pair.key);
        if self.found.len() >= FAULTS_MOST {
            self.more += 1;
            return None;
        }
        let hint = self.nearest(pair.key, valid);
        let span = if pair.key.is_empty() { pair.value_span.clone() } else { pair.key_span.clone() };
        let (en, de) = match shape {
            Some(shape) => (
                format!("`{key}` is not a key of `{}`", shape.name),
                format!("`{key}` ist kein Schlüssel von `{}`", shape.name),
            ),
            None => (format!("unknown key `{key}`"), format!("unbekannter Schlüssel `{key}`")),
        };
        self.fault(span, en, de, Some(hint));
        nearest_of(pair.key, valid)
    }

    pub(super) fn twice(&mut self, pair: &Keyed<'_>) {
        let key = pair.key;
        self.fault(pair.key_span.clone(), format!("`{key}` is given twice"), format!("`{key}` steht zweimal da"), None);
    }

    pub(super) fn missing(&mut self, line: &Line<'_>, key: &str) {
        let hint = self.language.for_example(&format!("{key}=50mm"));
        self.fault(line.shape_span.clone(), format!("`{key}` is missing"), format!("`{key}` fehlt"), Some(hint));
    }

    /// A quantity in SI.
    pub(super) fn quantity(&mut self, pair: &Keyed<'_>, key: &'static str, dimension: Dimension) -> Option<f64> {
        let read = match self.tolerances {
            Some(_) => quantities::parse_toleranced(dimension, pair.value),
            None => quantities::parse(dimension, pair.value).map(|reading| (reading, None)),
        };
        let error = match read {
            Ok((reading, half)) => {
                if let (Some(tolerances), Some(half)) = (&mut self.tolerances, half) {
                    let (line, start) = self.line;
                    let from = pair.value_span.start.saturating_sub(start);
                    let span = from + half.span.start..from + half.span.end;
                    tolerances.push((line, key, reading, HalfWidth { span, ..half }));
                }
                return Some(reading.si);
            }
            Err(error) => error,
        };
        let span = if pair.value.is_empty() {
            pair.value_span.clone()
        } else {
            let inner = error.span();
            pair.value_span.start + inner.start..pair.value_span.start + inner.end
        };
        let message = |language| format!("`{}`: {}", pair.key, error.message(language));
        self.fault(span, message(Language::En), message(Language::De), error.hint(self.language));
        None
    }

    /// A number of pieces; zero is left to the mechanics.
    pub(super) fn count(&mut self, pair: &Keyed<'_>) -> Option<u32> {
        let plain = pair.value.bytes().all(|byte| byte.is_ascii_digit());
        let found = pair.value.parse().ok().filter(|_| plain);
        if found.is_none() {
            let value = excerpt(pair.value);
            let hint = self.language.for_example("count=4");
            self.fault(
                pair.value_span.clone(),
                format!("`count` must be a whole number from 1 to {}, not \"{value}\"", u32::MAX),
                format!("`count` muss eine ganze Zahl von 1 bis {} sein, nicht „{value}“", u32::MAX),
                Some(hint),
            );
        }
        found
    }

    /// How a cylinder lies.
    pub(super) fn axis(&mut self, pair: &Keyed<'_>) -> Option<Orientation> {
        match pair.value {
            "parallel" => return Some(Orientation::Parallel),
            "perpendicular" => return Some(Orientation::Perpendicular),
            _ => {}
        }
        let value = excerpt(pair.value);
        let hint = self.nearest(pair.value, &AXES);
        self.fault(
            pair.value_span.clone(),
            format!("`axis` cannot be \"{value}\""),
            format!("`axis` kann nicht „{value}“ sein"),
            Some(hint),
        );
        None
    }

    /// A body that cannot be.
    pub(super) fn body(&mut self, error: &BodyError, span: Range<usize>) {
        let (message, hint) = body_fault(error, self.language);
        self.fault(span, message.clone(), message, hint);
    }
}

/// What is wrong with a body that cannot be.
pub(crate) fn body_fault(error: &BodyError, language: Language) -> (String, Option<String>) {
    let positive = |key: &str, si: f64, unit: &Unit, or_zero: bool| {
        let value = format!("{} {}", format_significant(unit.from_si(si), 4, language), unit.symbol);
        let (en, de) = if or_zero {
            ("must not be negative", "darf nicht negativ sein")
        } else {
            ("must be greater than zero", "muss größer als null sein")
        };
        (format!("`{key}` {en}, not {value}"), format!("`{key}` {de}, nicht {value}"))
    };
    let fixed = |en: &str, de: &str| (en.to_owned(), de.to_owned());
    let (en, de) = match error {
        BodyError::DimensionOutOfRange { field, value } => positive(field, value.si(), &MILLIMETRE, *field == "inner"),
        BodyError::InnerNotBelowOuter { .. } => {
            fixed("`inner` must be smaller than `outer`", "`inner` muss kleiner als `outer` sein")
        }
        BodyError::NoMass => fixed("neither `mass` nor `density` is given", "weder `mass` noch `density` angegeben"),
        BodyError::MassAndDensity { .. } => fixed(
            "`mass` and `density` are both given; one gives the other",
            "`mass` und `density` sind beide angegeben; eines ergibt das andere",
        ),
        BodyError::NoVolume => fixed(
            "this shape has no volume, so `density` gives no mass",
            "diese Form hat kein Volumen, `density` ergibt also keine Masse",
        ),
        BodyError::MassOutOfRange { mass } => positive("mass", mass.si(), &KILOGRAM, false),
        BodyError::DensityOutOfRange { density } => positive("density", density.si(), &KILOGRAM_PER_CUBIC_METRE, false),
        BodyError::DistanceOutOfRange { distance } => positive("distance", distance.si(), &MILLIMETRE, true),
        BodyError::NoPiece => fixed("`count` must be at least 1", "`count` muss mindestens 1 sein"),
        _ => fixed(
            "the inertia is beyond the range of numbers",
            "das Massenträgheitsmoment liegt außerhalb des Zahlenbereichs",
        ),
    };
    let hint = match error {
        BodyError::NoMass => Some(language.for_example("mass=0.6kg")),
        BodyError::DistanceOutOfRange { .. } => Some(language.for_example("distance=80mm angle=180deg")),
        _ => None,
    };
    (either(language, en, de), hint)
}

/// The name that was probably meant.
fn nearest_of<'n>(written: &str, valid: &[&'n str]) -> Option<&'n str> {
    let written = excerpt(written).to_lowercase();
    let akin = valid.iter().copied().find(|name| written.len() >= 3 && name.starts_with(written.as_str()));
    let near = || {
        valid
            .iter()
            .map(|name| (strsim::damerau_levenshtein(&written, name), *name))
            .min()
            .filter(|(distance, name)| distance * 2 <= name.len())
            .map(|(_, name)| name)
    };
    akin.or_else(near)
}

fn excerpt(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).take(EXCERPT_MOST).collect()
}
