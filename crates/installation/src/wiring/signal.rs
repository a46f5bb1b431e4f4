//! Signals on pins, and their spellings.

use super::role::Role;
use order_code::{Feedback, FeedbackKind};
use quantities::identified;

/// A signal of a table, unique on its connector.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WiringSignal {
    /// Meaning of the signal.
    pub meaning: SignalMeaning,
    /// End of a pair, if the signal has two.
    pub polarity: Option<Polarity>,
}

/// End of a pair.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Polarity {
    /// Plus end.
    Plus,
    /// Minus end.
    Minus,
}

/// Meaning of a signal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignalMeaning {
    /// Motor phase, by its letter.
    Phase(char),
    /// Protective earth.
    ProtectiveEarth,
    /// Supply of the holding brake.
    Brake,
    /// End of the PTC thermistors of the winding.
    Ptc,
    /// KTY sensor of the winding.
    Kty,
    /// Supply of the encoder.
    Supply,
    /// Ground of the encoder.
    Ground,
    /// Sense line of the supply.
    SupplySense,
    /// Sense line of the ground.
    GroundSense,
    /// Incremental track, by its letter and its form.
    Track(char, TrackForm),
    /// Reference mark.
    Reference,
    /// Zero pulse.
    Zero,
    /// Commutation track with one period per turn.
    CommutationTrack(char),
    /// Commutation signal of a motor phase.
    CommutationPhase(char),
    /// Data of the serial interface.
    Data(Protocol),
    /// Clock of the serial interface.
    Clock(Protocol),
    /// Sine winding of the resolver.
    ResolverSine,
    /// Cosine winding of the resolver.
    ResolverCosine,
    /// Excitation of the resolver.
    Excitation,
    /// Inner shield of the cable.
    Shield,
}

/// Form of an incremental track.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TrackForm {
    /// Sinusoidal, 1 V peak to peak; the manual does not state which track is the sine.
    Sinusoidal,
    /// Sine track.
    Sine,
    /// Cosine track.
    Cosine,
    /// Square wave, RS422.
    Square,
}

/// Serial interface of an encoder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Protocol {
    /// `EnDat`.
    EnDat,
    /// SSI.
    Ssi,
}

identified! {
    /// A group of signals of one kind.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum SignalGroup {
        /// Motor phases.
        Phase = "phase",
        /// Protective earth.
        Earth = "protective_earth",
        /// Holding brake.
        Brake = "brake",
        /// PTC thermistors.
        Ptc = "ptc",
        /// KTY sensor.
        Kty = "kty",
        /// Supply and ground of the encoder.
        Supply = "supply",
        /// Sense lines.
        Sense = "sense",
        /// Incremental tracks.
        Incremental = "incremental",
        /// Reference mark and zero pulse.
        Reference = "reference",
        /// Commutation.
        Commutation = "commutation",
        /// Data and clock.
        Serial = "serial",
        /// Windings of the resolver.
        Resolver = "resolver",
        /// Shield.
        Shield = "shield",
    }
}

/// Returns the signals of all pin tables without duplicates.
pub(super) fn printed_signals() -> Vec<&'static str> {
    let mut found: Vec<&'static str> = Vec::new();
    let tables = catalogue::series().iter().flat_map(catalogue::SeriesData::pin_tables);
    for cell in tables.filter_map(catalogue::table).flat_map(catalogue::ManualTable::cells) {
        let carries = matches!(cell.place.symbol, "signal" | "motor_phase") && cell.corrected != "-";
        if carries && !found.contains(&cell.corrected) {
            found.push(cell.corrected);
        }
    }
    found
}

impl WiringSignal {
    /// Returns the signal stated in a table; `None` if the field is empty or has a dash.
    #[must_use]
    pub fn of_print(printed: &str, role: Role, feedback: Feedback) -> Option<Self> {
        let is_motor_of = |kind| role == Role::Feedback && feedback.kind() == Some(kind);
        let serial = if is_motor_of(FeedbackKind::SsiMultiturn) { Protocol::Ssi } else { Protocol::EnDat };
        let of = |meaning| Some(Self { meaning, polarity: None });
        match printed {
            "U" | "V" | "W" => return of(SignalMeaning::Phase(printed.chars().next()?)),
            "PE" => return of(SignalMeaning::ProtectiveEarth),
            "Temp PTC" => return of(SignalMeaning::Ptc),
            "Up" => return of(SignalMeaning::Supply),
            "GND" => return of(SignalMeaning::Ground),
            "Up Sensor" => return of(SignalMeaning::SupplySense),
            "GND Sensor" => return of(SignalMeaning::GroundSense),
            "Inner Schirm" | "Innenschirm" => return of(SignalMeaning::Shield),
            _ => {}
        }
        // "A+ COS+" names a track and its form, "Temp+ KTY" an end and its sensor.
        let (name, rest) = printed.split_once(' ').unwrap_or((printed, ""));
        let (base, polarity) = match (name.strip_suffix('+'), name.strip_suffix('-')) {
            (Some(base), _) => (base, Polarity::Plus),
            (_, Some(base)) => (base, Polarity::Minus),
            _ => return None,
        };
        let square = is_motor_of(FeedbackKind::SquareIncremental);
        let form = match rest.get(..3) {
            Some("SIN") => TrackForm::Sine,
            Some("COS") => TrackForm::Cosine,
            _ if square => TrackForm::Square,
            _ => TrackForm::Sinusoidal,
        };
        let letter = base.chars().next()?;
        let meaning = match base {
            "BR" => SignalMeaning::Brake,
            "Temp" => SignalMeaning::Kty,
            "A" | "B" => SignalMeaning::Track(letter, form),
            "C" | "D" => SignalMeaning::CommutationTrack(letter),
            "U" | "V" | "W" => SignalMeaning::CommutationPhase(letter),
            "R" => SignalMeaning::Reference,
            "Z" => SignalMeaning::Zero,
            "DATA" => SignalMeaning::Data(serial),
            "CLOCK" => SignalMeaning::Clock(serial),
            "SIN" => SignalMeaning::ResolverSine,
            "COS" => SignalMeaning::ResolverCosine,
            "Vss" => SignalMeaning::Excitation,
            _ => return None,
        };
        Some(Self { meaning, polarity: Some(polarity) })
    }

    /// Returns the group of the signal.
    #[must_use]
    pub const fn group(self) -> SignalGroup {
        match self.meaning {
            SignalMeaning::Phase(_) => SignalGroup::Phase,
            SignalMeaning::ProtectiveEarth => SignalGroup::Earth,
            SignalMeaning::Brake => SignalGroup::Brake,
            SignalMeaning::Ptc => SignalGroup::Ptc,
            SignalMeaning::Kty => SignalGroup::Kty,
            SignalMeaning::Supply | SignalMeaning::Ground => SignalGroup::Supply,
            SignalMeaning::SupplySense | SignalMeaning::GroundSense => SignalGroup::Sense,
            SignalMeaning::Track(..) => SignalGroup::Incremental,
            SignalMeaning::Reference | SignalMeaning::Zero => SignalGroup::Reference,
            SignalMeaning::CommutationTrack(_) | SignalMeaning::CommutationPhase(_) => SignalGroup::Commutation,
            SignalMeaning::Data(_) | SignalMeaning::Clock(_) => SignalGroup::Serial,
            SignalMeaning::ResolverSine | SignalMeaning::ResolverCosine | SignalMeaning::Excitation => {
                SignalGroup::Resolver
            }
            SignalMeaning::Shield => SignalGroup::Shield,
        }
    }

    /// Returns `true` if two signals are the ends of one pair.
    #[must_use]
    pub fn is_other_end_of(self, other: Self) -> bool {
        let supply = |one, other| one == SignalMeaning::Supply && other == SignalMeaning::Ground;
        let ends = self.meaning == other.meaning && self.polarity != other.polarity;
        ends || supply(self.meaning, other.meaning) || supply(other.meaning, self.meaning)
    }
}

/// Returns the plain spelling used for comparison: capitals, one kind of minus, no white space or separators.
pub(super) fn plain(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '–' | '—' | '−' | '‑' => out.push('-'),
            sign if sign.is_whitespace() || matches!(sign, '_' | '.' | '/' | '(' | ')' | '\u{feff}') => {}
            sign => out.extend(sign.to_uppercase()),
        }
    }
    out
}

/// Spellings of an unconnected pin.
const NOTHING: [&str; 12] =
    ["", "-", "NC", "N/C", "FREE", "UNUSED", "NOTCONNECTED", "FREI", "UNBELEGT", "NICHTBELEGT", "NONE", "LEER"];

/// Returns `true` if a text denotes an unconnected pin.
pub(super) fn is_nothing(text: &str) -> bool {
    NOTHING.contains(&plain(text).as_str())
}

/// Returns the plain spellings of a signal: that of the manual, each of its words, and those common in practice.
pub(super) fn spellings(printed: &str) -> Vec<String> {
    let mut found = vec![plain(printed)];
    let field: &[&str] = match printed {
        "Temp+ KTY" => &["KTY+", "KTYTEMP+", "TEMPKTY+", "TEMP+", "+TEMP", "KTY84+"],
        "Temp- KTY" => &["KTY-", "KTYTEMP-", "TEMPKTY-", "TEMP-", "-TEMP", "KTY84-"],
        "Temp PTC" => &["PTC", "PTC1", "PTC2", "PTCTEMP", "PTC+", "PTC-"],
        "BR+" => &["BRAKE+", "BREMSE+", "BRK+", "+BR", "+BRAKE"],
        "BR-" => &["BRAKE-", "BREMSE-", "BRK-", "-BR", "-BRAKE"],
        "PE" => &["SL", "GROUNDPE", "EARTH", "SCHUTZLEITER", "PROTECTIVEEARTH"],
        "Up" => &["U_P", "UB", "VCC", "5V", "+5V", "SUPPLY", "VERSORGUNG"],
        "GND" => &["0V", "MASSE", "UN", "GROUND"],
        "Up Sensor" => &["UPSENSE", "5VSENSE", "SENSE+", "SENSEUP", "+5VSENSE"],
        "GND Sensor" => &["GNDSENSE", "0VSENSE", "SENSE-", "SENSEGND", "0VSENSOR"],
        "Inner Schirm" | "Innenschirm" => &["INNERSCHIRM", "INNENSCHIRM", "INNERSHIELD", "SHIELD", "SCHIRM"],
        "U" => &["PHASEU", "U1", "MOTORU"],
        "V" => &["PHASEV", "V1", "MOTORV"],
        "W" => &["PHASEW", "W1", "MOTORW"],
        "CLOCK+" => &["CLK+", "TAKT+"],
        "CLOCK-" => &["CLK-", "TAKT-"],
        "DATA+" => &["DAT+", "DATEN+"],
        "DATA-" => &["DAT-", "DATEN-"],
        "Vss+" => &["EXC+", "REF+", "ERREGUNG+"],
        "Vss-" => &["EXC-", "REF-", "ERREGUNG-"],
        _ => &[],
    };
    found.extend(field.iter().map(|text| (*text).to_owned()));
    // "A+ COS+": each name is unique on its connector.
    let names: Vec<&str> = printed.split(' ').collect();
    if let [first, second] = names.as_slice()
        && [first, second].iter().all(|name| name.ends_with(['+', '-']))
    {
        found.extend([plain(first), plain(second), plain(&format!("{second}{first}"))]);
    }
    found
}
