//! Comparison of a user's pin list with the wiring of a code.

use super::pin_list::{ListedPin, PinList};
use super::signal::{is_nothing, plain, printed_signals, spellings};
use super::{CodeWiring, Connector, Pin, Role};
use crate::wiring::signal::SignalGroup;
use quantities::identified;

/// Result of a comparison.
#[derive(Clone, Debug)]
pub struct PinComparison {
    /// Findings in order of line; those without a line at the end.
    pub findings: Vec<PinFinding>,
    /// Number of rows of the list.
    pub rows: usize,
    /// Number of rows that agree with the manual.
    pub agreeing: usize,
}

impl PinComparison {
    /// Returns `true` if the list may be wired: no findings other than advice.
    #[must_use]
    pub fn agrees(&self) -> bool {
        self.findings.iter().all(|finding| finding.severity() == Severity::Advice)
    }
}

identified! {
    /// Severity of a finding.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Severity {
        /// Danger to people or parts.
        Danger = "danger",
        /// Malfunction, or a row that is not recognised.
        Fault = "fault",
        /// Advice without consequences for the function.
        Advice = "advice",
    }
}

/// A difference between list and manual.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PinFinding {
    /// Connector of the finding.
    pub role: Role,
    /// Line of the list; `None` for a finding about something missing.
    pub line: Option<usize>,
    /// Pin as named in the manual, or as written if there is none; empty for a finding about the connector.
    pub pin: String,
    /// Signal of the manual; empty for a finding about the connector.
    pub expected: &'static str,
    /// Kind of difference.
    pub difference: PinDifference,
}

/// Kind of difference.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PinDifference {
    /// The code lacks the connector.
    NoSuchConnector,
    /// The list has no row of the connector.
    ConnectorNotListed,
    /// The manual does not state the pins of the connector for the code, so that they cannot be compared.
    PinsNotPrinted,
    /// The list has the pin assignment of the other encoder, whose connector is equal: the supply is reversed.
    OtherEncoder {
        /// Connector whose pin assignment is listed.
        of: Role,
    },
    /// The connector lacks the pin.
    NoSuchPin,
    /// The pin is listed twice.
    PinTwice {
        /// Line of the first row.
        first: usize,
    },
    /// Both ends of a pair are exchanged.
    Reversed {
        /// Group of the signal.
        group: SignalGroup,
        /// Pin of the other end.
        with: String,
    },
    /// Two signals are exchanged.
    Swapped {
        /// Group of the more dangerous signal.
        group: SignalGroup,
        /// Pin of the other signal.
        with: String,
        /// Text of the signal.
        written: String,
    },
    /// A signal of the connector is on a wrong pin.
    WrongPin {
        /// Text of the signal.
        written: String,
        /// Group of the more dangerous signal.
        group: SignalGroup,
        /// Correct pins of the signal.
        belongs: Vec<String>,
    },
    /// The connector lacks the signal.
    ForeignSignal {
        /// Text of the signal.
        written: String,
    },
    /// No connector has the signal.
    UnknownSignal {
        /// Text of the signal.
        written: String,
        /// Nearest signal of the connector.
        nearest: Option<&'static str>,
    },
    /// A signal on a pin that is not connected.
    NotConnected {
        /// Text of the signal.
        written: String,
    },
    /// The list leaves the pin unconnected.
    LeftOpen {
        /// Group of the signal.
        group: SignalGroup,
    },
    /// The list lacks the pin.
    Missing {
        /// Group of the signal.
        group: SignalGroup,
    },
    /// The wire is listed without a shield.
    Unshielded,
    /// The colour differs from the manual.
    Colour {
        /// Text of the colour.
        written: String,
        /// Colour in the manual.
        printed: &'static str,
    },
}

impl PinDifference {
    /// Returns the identifier used in data exchange.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        match self {
            Self::NoSuchConnector => "no_such_connector",
            Self::ConnectorNotListed => "connector_not_listed",
            Self::PinsNotPrinted => "pins_not_printed",
            Self::OtherEncoder { .. } => "other_encoder",
            Self::NoSuchPin => "no_such_pin",
            Self::PinTwice { .. } => "pin_twice",
            Self::Reversed { .. } => "polarity_reversed",
            Self::Swapped { .. } => "swapped",
            Self::WrongPin { .. } => "wrong_pin",
            Self::ForeignSignal { .. } => "foreign_signal",
            Self::UnknownSignal { .. } => "unknown_signal",
            Self::NotConnected { .. } => "not_connected",
            Self::LeftOpen { .. } => "left_open",
            Self::Missing { group: SignalGroup::Shield } => "shield_missing",
            Self::Missing { group: SignalGroup::Earth } => "protective_earth_missing",
            Self::Missing { .. } => "pin_missing",
            Self::Unshielded => "unshielded",
            Self::Colour { .. } => "colour",
        }
    }
}

/// Returns `true` if a wrong wire of this group may cause harm.
const fn harms(group: SignalGroup) -> bool {
    matches!(group, SignalGroup::Phase | SignalGroup::Earth | SignalGroup::Brake | SignalGroup::Supply)
}

impl PinFinding {
    /// Returns the severity of the finding.
    #[must_use]
    pub const fn severity(&self) -> Severity {
        match &self.difference {
            PinDifference::OtherEncoder { .. } => Severity::Danger,
            PinDifference::Reversed { group, .. }
            | PinDifference::Swapped { group, .. }
            | PinDifference::WrongPin { group, .. }
                if harms(*group) =>
            {
                Severity::Danger
            }
            PinDifference::LeftOpen { group: SignalGroup::Earth }
            | PinDifference::Missing { group: SignalGroup::Earth } => Severity::Danger,
            PinDifference::ConnectorNotListed | PinDifference::Colour { .. } => Severity::Advice,
            PinDifference::LeftOpen { group: SignalGroup::Sense }
            | PinDifference::Missing { group: SignalGroup::Sense } => Severity::Advice,
            _ => Severity::Fault,
        }
    }
}

/// Compares a list with the wiring of a code.
#[must_use]
pub fn compare(wiring: &CodeWiring, list: &PinList) -> PinComparison {
    let mut findings = Vec::new();
    let mut agreeing = 0;
    for role in Role::ALL {
        let rows: Vec<&ListedPin> = list.pins.iter().filter(|listed| listed.role == role).collect();
        let finding = |line, difference| PinFinding { role, line, pin: String::new(), expected: "", difference };
        match (wiring.connector(role), rows.first()) {
            (None, Some(first)) => findings.push(finding(Some(first.line), PinDifference::NoSuchConnector)),
            (Some(_), None) => findings.push(finding(None, PinDifference::ConnectorNotListed)),
            (Some(connector), Some(first)) if connector.pins.is_empty() => {
                findings.push(finding(Some(first.line), PinDifference::PinsNotPrinted));
            }
            (Some(connector), Some(first)) => {
                if let Some(of) = other_encoder(wiring, connector, &rows) {
                    findings.push(finding(Some(first.line), PinDifference::OtherEncoder { of }));
                } else {
                    agreeing += of_connector(wiring, connector, &rows, &mut findings);
                }
            }
            (None, None) => {}
        }
    }
    remove_doubles(&mut findings);
    findings.sort_by_key(|finding| (finding.line.is_none(), finding.line));
    PinComparison { findings, rows: list.pins.len(), agreeing }
}

/// Removes the second report of an exchange of two pins.
fn remove_doubles(findings: &mut Vec<PinFinding>) {
    let mut seen: Vec<(Role, String, String)> = Vec::new();
    findings.retain(|PinFinding { role, pin, difference, .. }| {
        let (PinDifference::Reversed { with, .. } | PinDifference::Swapped { with, .. }) = difference else {
            return true;
        };
        let mirrored = seen.iter().any(|(of, first, second)| of == role && first == with && second == pin);
        seen.push((*role, pin.clone(), with.clone()));
        !mirrored
    });
}

/// Returns the pin of a connector named by a text: `7`, `07`, `Pin 7`, `pe`.
fn pin_named<'c>(connector: &'c Connector, text: &str) -> Option<&'c Pin> {
    let plain = plain(text);
    let name = ["PIN", "STIFT", "NO", "NR"].iter().find_map(|word| plain.strip_prefix(word)).unwrap_or(&plain);
    let name = name.trim_start_matches('0');
    connector.pins.iter().find(|pin| plain_eq(&pin.name, name))
}

/// Returns `true` if a row of the list names the signal of a pin.
fn has_signal(connector: &Connector, pin: &Pin, row: &ListedPin) -> bool {
    pins_of_signal(connector, &row.signal).iter().any(|each| each.name == pin.name)
}

fn plain_eq(one: &str, other: &str) -> bool {
    plain(one) == plain(other)
}

/// Returns the pins of a connector whose signal a text may name.
fn pins_of_signal<'c>(connector: &'c Connector, text: &str) -> Vec<&'c Pin> {
    let wanted = plain(text);
    let carrying = || connector.pins.iter().filter(|pin| pin.carries.is_some());
    // The spelling of the manual takes precedence over other spellings.
    let exact: Vec<&Pin> = carrying().filter(|pin| plain(pin.printed()) == wanted).collect();
    if !exact.is_empty() {
        return exact;
    }
    carrying().filter(|pin| spellings(pin.printed()).iter().any(|each| plain(each) == wanted)).collect()
}

/// Returns the number of connected pins of a connector on which a list agrees with the manual, and the number of supply
/// pins among them.
fn matching(connector: &Connector, rows: &[&ListedPin]) -> (usize, usize) {
    let carrying = rows.iter().filter(|row| !is_nothing(&row.signal));
    let agreeing: Vec<&Pin> = carrying
        .filter_map(|row| pin_named(connector, &row.pin).filter(|pin| has_signal(connector, pin, row)))
        .collect();
    (agreeing.len(), agreeing.iter().filter(|pin| pin.carries(SignalGroup::Supply)).count())
}

/// Returns the other encoder's role if the list has its pin assignment, which uses an equal connector.
fn other_encoder(wiring: &CodeWiring, connector: &Connector, rows: &[&ListedPin]) -> Option<Role> {
    let of = match connector.role {
        Role::Motor => return None,
        Role::Feedback => Role::OutputEncoder,
        Role::OutputEncoder => Role::Feedback,
    };
    let other = wiring.connector(of).filter(|other| other.kind.corrected == connector.kind.corrected)?;
    let ((own, own_supply), (foreign, foreign_supply)) = (matching(connector, rows), matching(other, rows));
    (foreign > own && own_supply == 0 && foreign_supply == 2).then_some(of)
}

/// Records the differences of one connector; returns the number of rows that agree.
fn of_connector(
    wiring: &CodeWiring,
    connector: &Connector,
    rows: &[&ListedPin],
    findings: &mut Vec<PinFinding>,
) -> usize {
    let role = connector.role;
    let mut seen: Vec<(&Pin, &ListedPin)> = Vec::new();
    for row in rows {
        let Some(pin) = pin_named(connector, &row.pin) else {
            let difference = PinDifference::NoSuchPin;
            findings.push(PinFinding { role, line: Some(row.line), pin: row.pin.clone(), expected: "", difference });
            continue;
        };
        let mut push = |difference| {
            let (pin, expected) = (pin.name.clone(), pin.printed());
            findings.push(PinFinding { role, line: Some(row.line), pin, expected, difference });
        };
        if let Some((_, first)) = seen.iter().find(|(known, _)| known.name == pin.name) {
            push(PinDifference::PinTwice { first: first.line });
            continue;
        }
        seen.push((pin, row));
        if row.shield == Some(false) && pin.carries.is_some() {
            push(PinDifference::Unshielded);
        }
        if let (Some(written), Some(printed)) = (&row.colour, pin.colour)
            && !same_colour(written, printed)
        {
            push(PinDifference::Colour { written: written.clone(), printed: printed.corrected });
        }
    }
    let mut agreeing = 0;
    for (pin, row) in &seen {
        match difference(connector, pin, row, &seen) {
            None => agreeing += 1,
            Some(difference) => {
                let (pin, expected) = (pin.name.clone(), pin.printed());
                findings.push(PinFinding { role, line: Some(row.line), pin, expected, difference });
            }
        }
    }
    for pin in &connector.pins {
        let Some(signal) = pin.carries else { continue };
        let free = signal.group() == SignalGroup::Brake && wiring.code.brake == order_code::Brake::Without;
        if !free && !seen.iter().any(|(known, _)| known.name == pin.name) {
            let difference = PinDifference::Missing { group: signal.group() };
            findings.push(PinFinding { role, line: None, pin: pin.name.clone(), expected: pin.printed(), difference });
        }
    }
    agreeing
}

/// Returns the more dangerous of two groups.
const fn graver(one: SignalGroup, other: SignalGroup) -> SignalGroup {
    if !harms(one) && harms(other) { other } else { one }
}

/// Returns the difference in the signal of one row; `None` if it agrees.
fn difference(connector: &Connector, pin: &Pin, row: &ListedPin, seen: &[(&Pin, &ListedPin)]) -> Option<PinDifference> {
    let written = row.signal.clone();
    if is_nothing(&row.signal) {
        return pin.carries.map(|signal| PinDifference::LeftOpen { group: signal.group() });
    }
    let meant = pins_of_signal(connector, &row.signal);
    if meant.iter().any(|each| each.name == pin.name) {
        return None;
    }
    // Among several pins with the signal, the one that has the signal of this pin.
    let row_of = |other: &Pin| seen.iter().find(|(known, _)| known.name == other.name).map(|(_, row)| row);
    let has_own = |other: &&&Pin| row_of(other).is_some_and(|row| has_signal(connector, pin, row));
    if let Some(foreign) = meant.first().and_then(|one| one.carries) {
        let group = pin.carries.map_or_else(|| foreign.group(), |own| graver(own.group(), foreign.group()));
        return Some(match (meant.iter().find(has_own), pin.carries) {
            (Some(other), Some(own)) if other.carries.is_some_and(|end| own.is_other_end_of(end)) => {
                PinDifference::Reversed { group, with: other.name.clone() }
            }
            (Some(other), Some(_)) => PinDifference::Swapped { group, with: other.name.clone(), written },
            _ => PinDifference::WrongPin {
                written,
                group,
                belongs: meant.iter().map(|each| each.name.clone()).collect(),
            },
        });
    }
    if pin.carries.is_none() {
        return Some(PinDifference::NotConnected { written });
    }
    let wanted = plain(&row.signal);
    if printed_signals().iter().any(|printed| spellings(printed).iter().any(|each| plain(each) == wanted)) {
        return Some(PinDifference::ForeignSignal { written });
    }
    let nearest = nearest(connector, &wanted);
    Some(PinDifference::UnknownSignal { written, nearest })
}

/// Returns the signal of a connector that is most similar to a text.
fn nearest(connector: &Connector, wanted: &str) -> Option<&'static str> {
    let scored = connector.pins.iter().filter(|pin| pin.carries.is_some()).flat_map(|pin| {
        let printed = pin.printed();
        spellings(printed).into_iter().map(move |each| (strsim::damerau_levenshtein(&plain(&each), wanted), printed))
    });
    let (distance, printed) = scored.min_by_key(|(distance, _)| *distance)?;
    (distance <= 1 + wanted.chars().count() / 3).then_some(printed)
}

/// Colours by English word, with the letters of IEC 60757, those used in Germany, and spellings without umlauts.
const COLOURS: [(&str, &[&str]); 13] = [
    ("red", &["RD", "RT"]),
    ("black", &["BK", "SW"]),
    ("white", &["WH", "WS", "WEISS", "WEISZ"]),
    ("brown", &["BN", "BR"]),
    ("blue", &["BU", "BL"]),
    ("yellow", &["YE", "GE"]),
    ("green", &["GN", "GRUEN"]),
    ("grey", &["GRAY", "GY", "GR"]),
    ("orange", &["OG", "OR"]),
    ("violet", &["PURPLE", "VT", "VIOLET", "VIOLETT"]),
    ("pink", &["PK", "RS", "ROSA"]),
    ("turquoise", &["TQ", "TUERKIS"]),
    ("transparent", &["CLEAR", "TR"]),
];

/// Iterates over the colours of the manual with their English words.
fn printed_colours() -> impl Iterator<Item = (&'static str, &'static str)> {
    let cells = catalogue::cells().filter(|cell| cell.place.symbol == "wire_colour");
    cells.map(|cell| (cell.corrected, cell.corrected_en()))
}

/// Returns the colours named by a text, in order; `None` if it contains another word.
fn colours(text: &str) -> Option<Vec<&'static str>> {
    let words = text.split(|sign: char| !sign.is_alphabetic()).filter(|word| !word.is_empty());
    let one = |word: &str| {
        let lower = word.to_lowercase();
        let printed = printed_colours().find(|(printed, _)| *printed == lower).map_or(lower.as_str(), |(_, en)| en);
        let capitals = word.to_uppercase();
        let named = COLOURS.iter().find(|(name, others)| *name == printed || others.contains(&capitals.as_str()));
        named.map(|(name, _)| *name)
    };
    let mut found = Vec::new();
    for word in words {
        match one(word) {
            Some(colour) => found.push(colour),
            // Two codes without a separator: GNYE.
            None => {
                let (first, second) = word.split_at_checked(2)?;
                found.extend([one(first)?, one(second)?]);
            }
        }
    }
    Some(found)
}

fn same_colour(written: &str, printed: &'static catalogue::Cell) -> bool {
    match (colours(written), colours(printed.corrected)) {
        (Some(written), Some(printed)) => written == printed,
        _ => plain_eq(written, printed.corrected) || plain_eq(written, printed.corrected_en()),
    }
}
