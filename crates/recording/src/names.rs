//! Names of columns in the notation of loggers: `time_s`, `Ist-Lage [mm]`, `Axis1.ActPos`.

use crate::layout::Role;
use quantities::{Dimension, Unit};

/// Words before or after the name of a quantity that mark it as measured.
pub(crate) const MEASURED: &[&str] =
    &["act", "actual", "ist", "meas", "measured", "mess", "gemessen", "fbk", "feedback", "istwert", "real"];
/// Words that mark a quantity as commanded: such a column is used if none was measured, as for a planned motion.
pub(crate) const COMMANDED: &[&str] = &[
    "set",
    "setpoint",
    "soll",
    "sollwert",
    "cmd",
    "command",
    "commanded",
    "ref",
    "reference",
    "target",
    "desired",
    "demand",
];
/// Words without meaning for the quantity.
const FILLING: &[&str] =
    &["axis", "ax", "achse", "joint", "gelenk", "value", "val", "wert", "log", "logger", "logged", "sensor", "signal"];

/// Maximum length of the name of a quantity, which bounds the work per column.
pub(crate) const NAME_BYTES: usize = 64;

/// Certainty with which a name denotes a quantity; the surest name is used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Sureness {
    /// The name alone, with or without a unit.
    Plain,
    /// With a prefix, a number, or a word that marks it as measured.
    Measured,
    /// With a word that marks it as commanded.
    Commanded,
}

/// A name without its unit, and the unit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Named {
    pub(crate) bare: String,
    pub(crate) unit: Option<String>,
}

impl Named {
    /// Splits off a unit in brackets or after a slash: `q [deg]`, `q(deg)`, `q {deg}`, `n / 1/min`, `n in 1/min`,
    /// `q/deg`. Among several brackets the last one that reads as a unit holds it: `Axis[1].ActPos [deg]`,
    /// `n [1/min] (actual)`; an index or a word about the measurement is part of the name.
    pub(crate) fn marked(written: &str) -> Self {
        let written = written.trim();
        match bracketed(written).or_else(|| behind_a_stroke(written)) {
            Some((bare, unit)) => Self { bare: bare.trim_end().to_owned(), unit: Some(unit.trim().to_owned()) },
            None => Self { bare: written.to_owned(), unit: None },
        }
    }

    /// Splits off a share of a rated value too: `Torque_pct`, `Drehmoment %`, which a heading of a recording states as it does a
    /// unit.
    pub(crate) fn with_share(written: &str) -> Self {
        let named = Self::marked(written);
        let is_split = |(bare, share): &(&str, &str)| !bare.trim().is_empty() && is_share(share);
        match named.bare.rsplit_once(['_', ' ']).filter(|split| named.unit.is_none() && is_split(split)) {
            Some((bare, share)) => Self { bare: bare.trim_end().to_owned(), unit: Some(share.to_owned()) },
            None => named,
        }
    }

    /// Splits off a unit of a role after an underscore or a space, `time_s`, `vel_mm_s`, `n_1_min`, `Pos mm`, if no unit is
    /// marked. `fits` tests the name first, which is cheaper than searching units.
    pub(crate) fn for_role(&self, role: Role, fits: impl Fn(&str) -> bool) -> Option<Self> {
        if self.unit.is_some() || self.bare.len() > NAME_BYTES {
            return None;
        }
        // The longest unit has three parts: `10_m_s`.
        let strokes: Vec<usize> = self.bare.match_indices(['_', ' ']).map(|(at, _)| at).collect();
        strokes.iter().rev().take(3).rev().find_map(|at| {
            let (bare, unit) = (self.bare.get(..*at)?, self.bare.get(at + 1..)?);
            let bare = bare.trim_end();
            let unit = (!bare.is_empty() && fits(bare)).then(|| unit_of(role, unit)).flatten()?;
            Some(Self { bare: bare.to_owned(), unit: Some(unit.ascii.to_owned()) })
        })
    }

    /// Returns the certainty with which the name denotes the quantity of a role.
    pub(crate) fn sureness(&self, role: Role) -> Option<Sureness> {
        if self.bare.len() > NAME_BYTES {
            return None;
        }
        let is_name = |name: &str| role.names().contains(&name);
        if is_name(&self.bare.to_lowercase()) {
            return Some(Sureness::Plain);
        }
        // With anything but a plain name, a unit of another dimension indicates another quantity; a share of a rated value is of
        // the same.
        let is_of_another = |unit: &str| {
            let is_unit = role.dimensions().iter().any(|of| Unit::of_dimension(*of, unit).is_some());
            !is_unit && (role == Role::Time || !is_share(unit))
        };
        if self.unit.as_deref().is_some_and(is_of_another) {
            return None;
        }
        let own = self.bare.rsplit(['.', ':', '!', '|', '\\', '/']).find(|part| !part.trim().is_empty())?;
        let mut words: Vec<String> = words(own).into_iter().flat_map(parted).collect();
        let _ = words.drain(..parameter_number(&words));
        let _ = words.drain(..axis_label(&words));
        let is_commanded = words.iter().any(|word| COMMANDED.contains(&word.as_str()));
        let core: String = words
            .iter()
            .map(String::as_str)
            .filter(|word| ![MEASURED, COMMANDED, FILLING].iter().any(|list| list.contains(word)))
            .filter(|word| !word.bytes().all(|byte| byte.is_ascii_digit()))
            .collect();
        // A commanded torque in percent is no load, and none that was measured.
        if is_commanded && self.unit.as_deref().is_some_and(is_share) {
            return None;
        }
        is_name(&core).then_some(if is_commanded { Sureness::Commanded } else { Sureness::Measured })
    }
}

/// Words for a share, as headings of loggers have them in the place of a unit.
const SHARES: [&str; 8] = ["pct", "perc", "percent", "percentage", "prozent", "permille", "promille", "permil"];

/// Returns `true` if a text in the place of a unit states a share of a rated value: `%`, `0.1%`, `% rated`, `pct`.
#[must_use]
pub fn is_share(unit: &str) -> bool {
    unit.contains(['%', '‰']) || words(unit).iter().any(|word| SHARES.contains(&word.as_str()))
}

/// Returns the number of words of a parameter number before a name, as drives write it: `r0063 Drehzahlistwert`,
/// `S-0-0051 Lageistwert`. A letter with fewer digits is a name, `q1`.
fn parameter_number(words: &[String]) -> usize {
    let is_number = |word: &String| word.bytes().all(|byte| byte.is_ascii_digit());
    match words {
        [index, _, ..] if is_object_index(index, true) => return 1,
        [zero, index, _, ..] if zero == "0x" && is_object_index(index, false) => return 2,
        _ => {}
    }
    let Some((letter, rest)) = words.split_first().filter(|(letter, _)| letter.len() == 1 && !is_number(letter)) else {
        return 0;
    };
    let numbers = rest.iter().take_while(|word| is_number(word)).count();
    let is_parameter = rest.iter().take(numbers).any(|number| number.len() > 2) && rest.len() > numbers;
    if is_parameter && letter.is_ascii() { 1 + numbers } else { 0 }
}

/// Letters that label an axis of a robot or of a machine tool; `r63` and `p63` are parameters of a drive.
const LABELS: [&str; 10] = ["j", "a", "b", "c", "u", "v", "w", "x", "y", "z"];

/// Returns the number of words of the label of an axis before a name, a letter with a number of one or two digits: `J3 torque`,
/// `A1 Position`, `X2 pos`. Without a further word it is the name itself, `q1`.
fn axis_label(words: &[String]) -> usize {
    let is_number = |word: &String| word.len() <= 2 && word.bytes().all(|byte| byte.is_ascii_digit());
    let is_name = |word: &String| word.len() > 1 && word.bytes().all(|byte| byte.is_ascii_alphabetic());
    match words {
        [letter, number, rest @ ..]
            if LABELS.contains(&letter.as_str()) && is_number(number) && rest.iter().any(is_name) =>
        {
            2
        }
        _ => 0,
    }
}

/// Returns `true` for the index of an object of a drive profile (CiA 402), `6064h`, or its four digits without the letter.
fn is_object_index(word: &str, has_letter: bool) -> bool {
    let digits = if has_letter { word.strip_suffix('h') } else { Some(word) };
    digits.is_some_and(|digits| digits.len() == 4 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
}

/// Words before the number or the letter of an axis or a channel.
const AXES: [&str; 15] = [
    "axis", "ax", "achse", "joint", "j", "gelenk", "drive", "antrieb", "motor", "servo", "link", "channel", "ch",
    "kanal", "robot",
];

/// Returns the word for an axis or a channel in a name and its number or letter: `axis1.pos`, `Achse_X.Ist-Lage`, `joint_2/effort`; of
/// a symbol with a number, `q1`, an empty word and the number.
pub(crate) fn axis_of(bare: &str) -> Option<(String, String)> {
    let words = words(bare);
    let is_index = |word: &String| {
        word.bytes().all(|byte| byte.is_ascii_digit()) || ["x", "y", "z", "a", "b", "c"].contains(&word.as_str())
    };
    if let [symbol, number] = words.as_slice()
        && number.bytes().all(|byte| byte.is_ascii_digit())
        && Role::ALL.iter().any(|role| role.names().contains(&symbol.as_str()))
    {
        return Some((String::new(), number.clone()));
    }
    // `A1 Position`, `X2_pos`: letter and number name the axis.
    if let ([letter, number, ..], 2) = (words.as_slice(), axis_label(&words))
        && letter != "j"
    {
        return Some(("label".to_owned(), format!("{letter}{number}")));
    }
    let named =
        words.iter().zip(words.iter().skip(1)).find(|(word, index)| AXES.contains(&word.as_str()) && is_index(index));
    named.map(|(word, index)| (word.clone(), index.clone()))
}

/// Splits a heading into the name and a unit marked as one: `q [deg]`, `q (deg)`, `q {deg}`, `n / 1/min`, `n in 1/min`.
#[must_use]
pub fn name_and_unit(heading: &str) -> (String, Option<String>) {
    let named = Named::marked(heading);
    (named.bare, named.unit)
}

/// Splits a German compound into the quantity and the word about its measurement, `istlage`, `drehzahlsollwert`,
/// `positionsistwert`; any other word stays whole.
fn parted(word: String) -> Vec<String> {
    let is_name = |text: &str| text.len() > 2 && Role::ALL.iter().any(|role| role.names().contains(&text));
    let before = ["ist", "soll"].into_iter().find_map(|mark| {
        let quantity = word.strip_prefix(mark).filter(|quantity| is_name(quantity))?;
        Some(vec![mark.to_owned(), quantity.to_owned()])
    });
    let behind = || {
        ["istwert", "sollwert"].into_iter().find_map(|mark| {
            let quantity = word.strip_suffix(mark)?;
            // Linking letters: `positions-`, `momenten-`.
            let bare = ["", "s", "en"].into_iter().filter_map(|link| quantity.strip_suffix(link));
            let quantity = bare.into_iter().find(|quantity| is_name(quantity))?;
            Some(vec![quantity.to_owned(), mark.to_owned()])
        })
    };
    before.or_else(behind).unwrap_or_else(|| vec![word.clone()])
}

/// Splits a name into the part outside and the text inside its brackets: the last brackets that read as a unit, else
/// those at its end that hold neither an index nor a word about the measurement.
fn bracketed(written: &str) -> Option<(String, &str)> {
    const BRACKETS: [(char, char); 3] = [('[', ']'), ('(', ')'), ('{', '}')];
    // Most names have one pair of brackets at their end, or none.
    let is_open = |sign: char| BRACKETS.iter().any(|(open, _)| *open == sign);
    let opened = written.rfind(is_open)?;
    let at_end = BRACKETS.into_iter().find_map(|(open, close)| {
        let inner = written.get(opened..)?.strip_prefix(open)?.strip_suffix(close)?;
        Some((written.get(..opened)?.trim_end(), inner))
    });
    if let Some((before, inner)) = at_end
        && !before.is_empty()
        && !inner.bytes().all(|byte| byte.is_ascii_digit())
        && Unit::of(inner).is_some()
    {
        return Some((before.strip_suffix('/').unwrap_or(before).to_owned(), inner));
    }
    let groups = written.char_indices().filter_map(|(place, sign)| {
        let (open, close) = BRACKETS.into_iter().find(|(open, _)| *open == sign)?;
        let rest = written.get(place + open.len_utf8()..)?;
        let inner = rest.get(..closing(rest, (open, close)).or_else(|| rest.find(close))?)?;
        let before = written.get(..place)?;
        let behind = rest.get(inner.len() + close.len_utf8()..)?;
        (!before.trim().is_empty()).then_some((before, inner, behind))
    });
    let groups: Vec<(&str, &str, &str)> = groups.take(GROUPS_MOST).collect();
    let is_unit = |(_, inner, _): &&(&str, &str, &str)| {
        !inner.bytes().all(|byte| byte.is_ascii_digit()) && Unit::of(inner).is_some()
    };
    // The brackets of a fraction belong to its unit: `[A/(1/min)]`.
    let is_within = |part: &(&str, &str, &str), whole: &(&str, &str, &str)| {
        whole.0.len() < part.0.len() && whole.2.len() < part.2.len()
    };
    let units: Vec<&(&str, &str, &str)> = groups.iter().filter(is_unit).collect();
    let unit = units.iter().rev().find(|part| !units.iter().any(|whole| is_within(part, whole))).copied();
    let is_about = |inner: &str| {
        if is_share(inner) {
            return false;
        }
        let words = words(inner);
        let about = |word: &String| {
            word.bytes().all(|byte| byte.is_ascii_digit())
                || [MEASURED, COMMANDED, FILLING].iter().any(|list| list.contains(&word.as_str()))
        };
        words.iter().all(about)
    };
    let at_end = || groups.last().filter(|(_, inner, behind)| behind.is_empty() && !is_about(inner));
    let (before, inner, behind) = unit.or_else(at_end)?;
    // `n / (1/min)` is a fraction in brackets, not a name that ends with a stroke.
    let before = before.trim_end();
    Some((format!("{}{behind}", before.strip_suffix('/').unwrap_or(before)), inner))
}

/// Returns the place of the bracket that closes one opened before a text.
fn closing(rest: &str, (open, close): (char, char)) -> Option<usize> {
    let mut depth = 0_usize;
    for (place, sign) in rest.char_indices() {
        if sign == open {
            depth += 1;
        } else if sign == close {
            let Some(outer) = depth.checked_sub(1) else { return Some(place) };
            depth = outer;
        }
    }
    None
}

/// Maximum number of brackets of a name that are examined.
const GROUPS_MOST: usize = 8;

fn behind_a_stroke(written: &str) -> Option<(String, &str)> {
    let parts = [" / ", " in "].iter().find_map(|by| written.split_once(by));
    // A fraction behind a space: `Speed mm/s`.
    let parts = parts.or_else(|| {
        let fraction = written.rsplit_once(' ').filter(|(bare, unit)| !bare.trim().is_empty() && unit.contains('/'))?;
        Unit::of(fraction.1).map(|_| fraction)
    });
    let parts =
        parts.or_else(|| written.split_once('/').filter(|(bare, unit)| !bare.is_empty() && Unit::of(unit).is_some()));
    parts.map(|(bare, unit)| (bare.to_owned(), unit))
}

/// Returns `true` if a heading is one of the usual names of a role.
pub(crate) fn is_usual_name(written: &str) -> bool {
    let named = Named::marked(written);
    let is_usual = |role: Role, bare: &str| Named { bare: bare.to_owned(), unit: None }.sureness(role).is_some();
    Role::ALL
        .into_iter()
        .any(|role| named.sureness(role).is_some() || named.for_role(role, |bare| is_usual(role, bare)).is_some())
}

/// Names of a column of whole seconds, and of the column of nanoseconds next to it.
const SECONDS: [&str; 4] = ["sec", "secs", "second", "seconds"];
const NANOSECONDS: [&str; 6] = ["nanosec", "nanosecs", "nsec", "nsecs", "nanosecond", "nanoseconds"];

/// Returns the part before the name of a column of whole seconds, `/header/stamp/` of `/header/stamp/sec`.
pub(crate) fn before_seconds(written: &str) -> Option<&str> {
    before(written, &SECONDS)
}

/// Returns the part before the name of a column of nanoseconds.
pub(crate) fn before_nanoseconds(written: &str) -> Option<&str> {
    before(written, &NANOSECONDS)
}

fn before<'w>(written: &'w str, names: &[&str]) -> Option<&'w str> {
    let written = written.trim();
    let start = written
        .rfind(|sign: char| !sign.is_ascii_alphabetic())
        .map_or(0, |at| at + written.get(at..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8));
    let (before, name) = written.split_at_checked(start)?;
    names.contains(&name.to_ascii_lowercase().as_str()).then_some(before)
}

/// Returns the unit of a role, spelt with underscores for slashes or spaces; in lower case if that is unambiguous.
fn unit_of(role: Role, written: &str) -> Option<&'static Unit> {
    unit_after_underscore(role.dimensions(), written)
}

/// Returns the unit of one of these dimensions that a name has behind an underscore: `s`, `1_min`, `N_m`, `kg_m2`.
#[must_use]
pub fn unit_after_underscore(dimensions: &[Dimension], written: &str) -> Option<&'static Unit> {
    let spellings =
        [written.replace('_', "/").replace("/per/", "/"), written.replace('_', ""), written.replace('_', " ")];
    let known = |spelling: &String| dimensions.iter().find_map(|of| Unit::of_dimension(*of, spelling));
    if let Some(unit) = spellings.iter().find_map(known) {
        return Some(unit);
    }
    let small = |unit: &&Unit| unit.spellings().any(|each| spellings.contains(&each.to_lowercase().replace(' ', "")));
    let mut found = dimensions.iter().flat_map(|of| of.units()).filter(small);
    found.next().filter(|_| found.next().is_none())
}

/// Splits a name into words in lower case: at other characters, between a lower-case and an upper-case letter, and
/// before digits.
pub(crate) fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = ' ';
    for sign in name.chars() {
        let is_new = before.is_lowercase() && sign.is_uppercase() || before.is_alphabetic() && sign.is_ascii_digit();
        if is_new || !sign.is_alphanumeric() {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| sign.is_alphanumeric()) {
            word.extend(sign.to_lowercase());
        }
        before = sign;
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_carries_its_unit_in_these_ways_only() {
        for (written, bare, unit) in [
            ("time [s]", "time", Some("s")),
            ("q(deg)", "q", Some("deg")),
            ("q {deg}", "q", Some("deg")),
            ("n / 1/min", "n", Some("1/min")),
            ("n / (1/min)", "n", Some("1/min")),
            ("n [1/min]", "n", Some("1/min")),
            ("K_INL [A/(1/min)]", "K_INL", Some("A/(1/min)")),
            ("k_E (V/(rad/s))", "k_E", Some("V/(rad/s)")),
            ("n in 1/min", "n", Some("1/min")),
            ("pos / °", "pos", Some("°")),
            ("t/s", "t", Some("s")),
            ("Speed mm/s", "Speed", Some("mm/s")),
            ("Drehzahl 1/min", "Drehzahl", Some("1/min")),
            ("v/vmax", "v/vmax", None),
            ("(deg)", "(deg)", None),
            ("Axis[1].ActPos [deg]", "Axis[1].ActPos", Some("deg")),
            ("q[2] [deg]", "q[2]", Some("deg")),
            ("q[2]", "q[2]", None),
            ("r0061[0]: Speed (1/min)", "r0061[0]: Speed", Some("1/min")),
            ("n (motor) [rpm]", "n (motor)", Some("rpm")),
            ("Position (actual)", "Position (actual)", None),
            ("Time [s] (relative)", "Time (relative)", Some("s")),
            ("q [degr]", "q", Some("degr")),
            ("q (1) (deg)", "q (1)", Some("deg")),
            ("M", "M", None),
            ("Axis1.ActTorque [0.1%]", "Axis1.ActTorque", Some("0.1%")),
            ("Torque_pct", "Torque", Some("pct")),
            ("Drehmoment %", "Drehmoment", Some("%")),
            ("Drehmoment in Prozent", "Drehmoment", Some("Prozent")),
            ("percent", "percent", None),
        ] {
            let named = Named::with_share(written);
            assert_eq!((named.bare.as_str(), named.unit.as_deref()), (bare, unit), "{written}");
        }
    }

    /// A label of an axis, as robots number them, and words of a logger are no part of a name; several axes stay apart.
    #[test]
    fn labels_of_axes_and_words_of_a_logger_are_no_part_of_a_name() {
        for (written, role) in [
            ("t_log [s]", Role::Time),
            ("log time [ms]", Role::Time),
            ("J3 angle [deg]", Role::Position),
            ("J3 torque [Nm]", Role::Torque),
            ("A1 Position [deg]", Role::Position),
            ("X2_pos", Role::Position),
            ("J3_velocity [deg/s]", Role::Speed),
            ("torque sensor [Nm]", Role::Torque),
            ("J12.ActTorque [Nm]", Role::Torque),
        ] {
            assert_eq!(Named::marked(written).sureness(role), Some(Sureness::Measured), "{written}");
        }
        for (written, role) in
            [("J3 [deg]", Role::Torque), ("J3 temperature [degC]", Role::Torque), ("J3 torque [A]", Role::Torque)]
        {
            assert_eq!(Named::marked(written).sureness(role), None, "{written}");
        }
        assert_eq!(axis_of("J3 torque"), Some(("j".to_owned(), "3".to_owned())));
    }

    #[test]
    fn a_unit_of_the_role_may_stand_behind_an_underscore() {
        for (written, role, bare, unit) in [
            ("time_s", Role::Time, "time", "s"),
            ("t_ms", Role::Time, "t", "ms"),
            ("position_deg", Role::Position, "position", "deg"),
            ("ist_weg_mm", Role::Position, "ist_weg", "mm"),
            ("v_m_s", Role::Speed, "v", "m/s"),
            ("omega_rad_per_s", Role::Speed, "omega", "rad/s"),
            ("n_1_min", Role::Speed, "n", "1/min"),
            ("n_rpm", Role::Speed, "n", "1/min"),
            ("torque_nm", Role::Torque, "torque", "N m"),
            ("M_N_m", Role::Torque, "M", "N m"),
            ("Pos mm", Role::Position, "Pos", "mm"),
            ("Time s", Role::Time, "Time", "s"),
            ("Ist Weg mm", Role::Position, "Ist Weg", "mm"),
            ("Torque N m", Role::Torque, "Torque", "N m"),
        ] {
            let named = Named::marked(written).for_role(role, |_| true).unwrap();
            assert_eq!((named.bare.as_str(), named.unit.as_deref()), (bare, Some(unit)), "{written}");
        }
        // Millinewton or meganewton: ambiguous in lower case.
        for (written, role) in
            [("time_s", Role::Speed), ("F_mn", Role::Torque), ("q_soll", Role::Position), ("_s", Role::Time)]
        {
            assert_eq!(Named::marked(written).for_role(role, |_| true), None, "{written}");
        }
    }

    /// Both guides name every word that is recognised.
    #[test]
    fn the_guides_name_every_word() {
        for page in ["guide", "anleitung"] {
            let path = format!("{}/../../docs/{page}/recordings.md", env!("CARGO_MANIFEST_DIR"));
            let text = std::fs::read_to_string(path).unwrap();
            let listed = |words: &[&str]| words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(" ");
            for role in Role::ALL {
                assert!(text.contains(&format!("| {} |", listed(role.names()))), "{page} {role:?}");
            }
            for words in [MEASURED, COMMANDED, FILLING] {
                assert!(text.contains(&listed(words)), "{page}: {words:?}");
            }
        }
    }

    #[test]
    fn prefixes_numbers_and_words_of_measuring_are_no_part_of_a_name() {
        let of = |written: &str, role| Named::marked(written).sureness(role);
        use Sureness::{Commanded, Measured, Plain};
        for (written, role, expected) in [
            ("Winkel", Role::Position, Some(Plain)),
            ("Ist-Lage [mm]", Role::Position, Some(Measured)),
            ("Axis1.ActPos", Role::Position, Some(Measured)),
            ("Position actual value", Role::Position, Some(Measured)),
            ("PosIst", Role::Position, Some(Measured)),
            ("q1", Role::Position, Some(Measured)),
            ("MAIN.axis.SetPos", Role::Position, Some(Commanded)),
            ("soll_drehzahl", Role::Speed, Some(Commanded)),
            ("/joint_2/effort", Role::Torque, Some(Measured)),
            ("TimeStamp", Role::Time, Some(Plain)),
            ("Axis[1].ActPos", Role::Position, Some(Measured)),
            ("Axis[1].ActVelo", Role::Speed, Some(Measured)),
            ("q[2]", Role::Position, Some(Measured)),
            ("r0061[0]: Speed", Role::Speed, Some(Measured)),
            ("Position (actual)", Role::Position, Some(Measured)),
            ("AngularPosition", Role::Position, Some(Plain)),
            ("Angular velocity", Role::Speed, Some(Measured)),
            ("FrictionTorque", Role::Torque, None),
            ("Istlage", Role::Position, Some(Measured)),
            ("Solldrehzahl", Role::Speed, Some(Commanded)),
            ("Lageistwert", Role::Position, Some(Measured)),
            ("Positionssollwert", Role::Position, Some(Commanded)),
            ("Momentenistwert", Role::Torque, Some(Measured)),
            ("Uhrzeit", Role::Time, Some(Plain)),
            ("Istmoment [%]", Role::Torque, Some(Measured)),
            ("Act. torque [% rated]", Role::Torque, Some(Measured)),
            ("6077h Torque actual value", Role::Torque, Some(Measured)),
            ("0x6064 Position actual value", Role::Position, Some(Measured)),
            ("Torque utilization [%]", Role::Torque, None),
            ("Torque Reference [%]", Role::Torque, None),
            ("Zeit ist [%]", Role::Time, None),
            ("List", Role::Position, None),
            ("istx", Role::Position, None),
            // Another quantity, or one at another place.
            ("position error", Role::Position, None),
            ("Motor position", Role::Position, None),
            ("ActPos [N]", Role::Position, None),
            ("positions", Role::Position, None),
            ("lag", Role::Position, None),
        ] {
            assert_eq!(of(written, role), expected, "{written}");
        }
    }
}
