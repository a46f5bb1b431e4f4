//! Encoders of an ordering code as simulated by `feedback`: parameters from the tables, pins from the wiring.

use crate::commission::encoder::{EncoderSide, rows};
use crate::wiring::{CodeWiring, Pin, Role, SignalMeaning};
use actuator::Feedback;
use catalogue::{Cell, Value};
use feedback::ssi::SsiFormat;
use feedback::{
    Absolute, CommutationPhases, Encoder, Interface, Protocol, Resolver, Shaft, Signal, SinePair, Span, SquareTracks,
};
use order_code::OrderCode;
use provenance::Datum;
use quantities::{Angle, EffectiveVoltage, ElectricPotential, Frequency, Measure, Unit, identified};

/// Interpolation steps within a period of the sine tracks, as assumed in the tables: 8 bit.
///
/// # Source
/// cha-manual tables 57.1, 58.1, 59.1, 68.1, footnote 2
pub const STEPS_OF_A_PERIOD: u32 = 256;

/// An encoder fitted to an actuator.
#[derive(Clone, Debug)]
pub struct Fitted {
    /// Role of its connector.
    pub role: Role,
    /// Signals of the encoder, without deviation.
    pub encoder: Encoder,
    /// Accuracy, range and battery from the manual.
    pub feedback: Feedback,
    /// Cells of the manual that determine the encoder.
    pub cells: Vec<&'static Cell>,
}

identified! {
    /// Assumption about an encoder that the manual leaves open or the simulation does not cover.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Assumed {
        /// Order of the two tracks.
        OrderOfTracks = "order_of_tracks",
        /// Position of the angle zero relative to the tracks, and the width of the mark.
        ZeroOfTracks = "zero_of_tracks",
        /// Position of the commutation signals.
        ZeroOfCommutation = "zero_of_commutation",
        /// Zero of the position relative to the rotor.
        ZeroOfPosition = "zero_of_position",
        /// Zero of the output encoder relative to the motor encoder.
        ZeroOfOutput = "zero_of_output",
        /// Timing of `EnDat`.
        TimesOfEndat = "times_of_endat",
        /// Timing of SSI.
        TimesOfSsi = "times_of_ssi",
        /// Frequency of the excitation, and windings without phase shift.
        Carrier = "carrier",
        /// Deviation curve.
        Deviation = "deviation",
        /// Count of turns restarting at zero after a loss of the battery.
        BatteryLost = "battery_lost",
    }
}

/// Returns the encoders of a code: the motor feedback and option EC; `None` if a datum required for the signals is
/// missing.
#[must_use]
pub fn encoders(code: &OrderCode) -> Option<Vec<Fitted>> {
    let parameters = configurator::parameters(code)?;
    let printed = rows(code);
    let of = |side: EncoderSide, role: Role, feedback: Feedback| {
        let cells: Vec<&'static Cell> = printed.iter().filter(|row| row.side == side).map(|row| row.cell).collect();
        let interface = Rows(&cells).interface()?;
        Some(Fitted { role, encoder: Encoder { interface, deviation: None }, feedback, cells })
    };
    let mut found = vec![of(EncoderSide::Motor, Role::Feedback, parameters.feedback)?];
    if code.has_output_encoder() {
        found.push(of(EncoderSide::Output, Role::OutputEncoder, parameters.feedback_out)?);
    }
    Some(found)
}

impl Fitted {
    /// Returns the largest deviation in either direction.
    #[must_use]
    pub fn accuracy(&self) -> Option<Angle> {
        self.feedback.accuracy.known().map(|accuracy| accuracy.value)
    }

    /// Returns the encoder with a deviation determined by a seed; without a stated accuracy it has none.
    #[must_use]
    pub fn deviating(mut self, seed: u64) -> Self {
        let periods = match &self.encoder.interface {
            Interface::Sine { pair, .. } => Some(pair.periods),
            Interface::Square { .. } | Interface::Resolver(_) => None,
        };
        self.encoder.deviation = self.accuracy().map(|accuracy| feedback::Deviation::new(accuracy, periods, seed));
        self
    }

    /// Returns the encoder shaft for a motor shaft, clockwise positive.
    #[must_use]
    pub fn shaft(&self, motor: Shaft, code: &OrderCode) -> Shaft {
        if self.role == Role::OutputEncoder { motor.behind_gear(u32::from(code.ratio.value())) } else { motor }
    }

    /// Returns the pins of a signal, plus end first.
    #[must_use]
    pub fn pins(&self, signal: Signal, wiring: &CodeWiring) -> Vec<Pin> {
        let carries = |pin: &&Pin| pin.carries.is_some_and(|carried| of_meaning(carried.meaning) == Some(signal));
        let connector = wiring.connector(self.role);
        let mut pins: Vec<Pin> = connector.into_iter().flat_map(|found| &found.pins).filter(carries).cloned().collect();
        pins.sort_by_key(|pin| pin.carries.and_then(|carried| carried.polarity));
        pins
    }

    /// Returns the cell that states a property.
    #[must_use]
    pub fn cell(&self, symbol: &str, condition: &str) -> Option<&'static Cell> {
        Rows(&self.cells).cell(symbol, condition)
    }

    /// Returns the assumptions about the encoder.
    #[must_use]
    pub fn assumed(&self, is_battery_lost: bool) -> Vec<Assumed> {
        let mut found = Vec::new();
        let has = |signal: Signal| self.encoder.periods(signal).is_some();
        // Table 66.6 states the cosine track of M128S; for the others the manual has only the letters.
        if has(Signal::A) && self.encoder.absolute().is_none_or(|absolute| absolute.protocol != Protocol::Ssi) {
            found.push(Assumed::OrderOfTracks);
        }
        if has(Signal::R) || has(Signal::Z) {
            found.push(Assumed::ZeroOfTracks);
        }
        if has(Signal::C) || has(Signal::U) {
            found.push(Assumed::ZeroOfCommutation);
        }
        match self.role {
            Role::OutputEncoder => found.push(Assumed::ZeroOfOutput),
            Role::Motor | Role::Feedback if !(has(Signal::R) || has(Signal::Z)) => found.push(Assumed::ZeroOfPosition),
            Role::Motor | Role::Feedback => {}
        }
        match self.encoder.absolute().map(|absolute| absolute.protocol) {
            Some(Protocol::EnDat) => found.push(Assumed::TimesOfEndat),
            Some(Protocol::Ssi) => found.push(Assumed::TimesOfSsi),
            None => {}
        }
        if has(Signal::Sine) {
            found.push(Assumed::Carrier);
        }
        if self.encoder.deviation.is_some() {
            found.push(Assumed::Deviation);
        }
        if is_battery_lost && self.feedback.buffered_by_battery {
            found.push(Assumed::BatteryLost);
        }
        found
    }

    /// Returns the number of encoder turns after which the absolute position restarts.
    #[must_use]
    pub fn turns(&self) -> Option<u64> {
        self.encoder.absolute().map(|absolute| 1 << absolute.format.turns)
    }
}

/// Returns the signal on a pin; `None` for supply, shield and others that do not depend on the angle.
const fn of_meaning(meaning: SignalMeaning) -> Option<Signal> {
    Some(match meaning {
        SignalMeaning::Track('A', _) => Signal::A,
        SignalMeaning::Track(_, _) => Signal::B,
        SignalMeaning::Reference => Signal::R,
        SignalMeaning::Zero => Signal::Z,
        SignalMeaning::CommutationTrack('C') => Signal::C,
        SignalMeaning::CommutationTrack(_) => Signal::D,
        SignalMeaning::CommutationPhase('U') => Signal::U,
        SignalMeaning::CommutationPhase('V') => Signal::V,
        SignalMeaning::CommutationPhase(_) => Signal::W,
        SignalMeaning::Data(_) => Signal::Data,
        SignalMeaning::Clock(_) => Signal::Clock,
        SignalMeaning::ResolverSine => Signal::Sine,
        SignalMeaning::ResolverCosine => Signal::Cosine,
        SignalMeaning::Excitation => Signal::Excitation,
        SignalMeaning::Phase(_)
        | SignalMeaning::ProtectiveEarth
        | SignalMeaning::Brake
        | SignalMeaning::Ptc
        | SignalMeaning::Kty => return None,
        SignalMeaning::Supply | SignalMeaning::Ground | SignalMeaning::SupplySense | SignalMeaning::GroundSense => {
            return None;
        }
        SignalMeaning::Shield => return None,
    })
}

/// Rows of the manual on one encoder.
struct Rows<'c>(&'c [&'static Cell]);

impl Rows<'_> {
    /// Returns the cell of a symbol, with the condition if one is given.
    fn cell(&self, symbol: &str, condition: &str) -> Option<&'static Cell> {
        let found = |cell: &&&'static Cell| {
            cell.place.symbol == symbol && (condition.is_empty() || cell.place.condition == condition)
        };
        self.0.iter().find(found).copied()
    }

    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole and within the bounds of the type"
    )]
    fn whole(&self, symbol: &str) -> Option<u32> {
        let value = self.cell(symbol, "")?.value.number()?;
        (value.fract() == 0.0 && (1.0..=f64::from(u32::MAX)).contains(&value)).then_some(value as u32)
    }

    /// Returns the number of bits of a counter with the stated number of values.
    fn bits(&self, symbol: &str) -> Option<u32> {
        let count = self.whole(symbol)?;
        count.is_power_of_two().then_some(count.ilog2())
    }

    fn interface(&self) -> Option<Interface> {
        if let Some(pole_pairs) = self.whole("pole_pairs_resolver") {
            return self.resolver(pole_pairs).map(Interface::Resolver);
        }
        let periods = self.whole("n_1_lines")?;
        if self.cell("signal_standard", "incremental").is_some() {
            let commutation = CommutationPhases { periods: self.whole("n_2_lines")? };
            return Some(Interface::Square { tracks: SquareTracks { periods }, commutation });
        }
        let absolute = match self.cell("protocol", "") {
            Some(cell) => Some(Absolute {
                protocol: if cell.corrected.starts_with("SSI") { Protocol::Ssi } else { Protocol::EnDat },
                format: SsiFormat { turns: self.bits("turns").unwrap_or(0), steps: self.bits("positions_per_turn")? },
            }),
            None => None,
        };
        let commutation = self.whole("n_2_lines").map(|periods| SinePair { periods, level: self.level("commutation") });
        Some(Interface::Sine {
            pair: SinePair { periods, level: self.level("incremental") },
            commutation,
            has_reference: self.cell("n_3_lines", "").is_some(),
            absolute,
        })
    }

    fn resolver(&self, pole_pairs: u32) -> Option<Resolver> {
        let frequency = self.cell("input_frequency", "")?;
        let lowest = match frequency.value {
            Value::Range { low, .. } => low,
            other => other.number()?,
        };
        let unit = Unit::of_dimension(Frequency::DIMENSION, frequency.unit)?;
        let excitation: Datum<EffectiveVoltage> = catalogue::datum_of(self.cell("U_b", "AC")?);
        Some(Resolver {
            pole_pairs,
            excitation: excitation.known()?.value,
            frequency: Frequency::new_in(lowest, unit),
            ratio: self.cell("transformation_ratio", "")?.value.number()?,
        })
    }

    /// Parses a peak-to-peak level: `1`, `0,8 ... 1,2` with the nominal value in the middle, or `1 +20 % ... -25 %`.
    fn level(&self, condition: &str) -> Option<Span> {
        let cell = self.cell("u_pp", condition)?;
        let unit = Unit::of_dimension(ElectricPotential::DIMENSION, cell.unit)?;
        let volts = |value: f64| ElectricPotential::new_in(value, unit);
        let (nominal, bounds) = match cell.value {
            Value::Range { low, high } => (f64::midpoint(low, high), Some([low, high])),
            Value::Text => {
                let mut numbers =
                    cell.corrected.split_whitespace().filter_map(|part| part.replace(',', ".").parse::<f64>().ok());
                let (nominal, plus, minus) = (numbers.next()?, numbers.next()?, numbers.next()?);
                (nominal, Some([nominal * (1.0 + minus / 100.0), nominal * (1.0 + plus / 100.0)]))
            }
            other => (other.number()?, None),
        };
        Some(Span { nominal: volts(nominal), bounds: bounds.map(|bounds| bounds.map(volts)) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wiring::wiring;

    fn fitted(code: &str) -> Vec<Fitted> {
        encoders(&order_code::parse(code).unwrap().code).unwrap()
    }

    /// Tables 57.1 to 61.1 and 68.1, typed by hand.
    #[test]
    fn the_encoders_are_those_of_the_tables() {
        let volts = |level: Option<Span>| {
            let level = level.unwrap();
            (level.nominal.si(), level.bounds.map(|bounds| bounds.map(|volt| (volt.si() * 1e6).round() / 1e6)))
        };
        let format = |fitted: &Fitted| fitted.encoder.absolute().map(|a| (a.protocol, a.format.turns, a.format.steps));
        let c1024 = &fitted("CHA-20A-100-H-C1024")[0];
        let Interface::Sine { pair, commutation, has_reference: true, absolute: None } = &c1024.encoder.interface
        else {
            panic!("{c1024:?}")
        };
        assert_eq!((pair.periods, volts(pair.level)), (1024, (1.0, Some([0.75, 1.2]))));
        assert_eq!(commutation.map(|c| (c.periods, volts(c.level))), Some((1, (1.0, None))));
        let both = fitted("CHA-25A-100-H-M512P-EC");
        assert_eq!(format(&both[0]), Some((Protocol::EnDat, 12, 13)));
        assert_eq!(format(&both[1]), Some((Protocol::EnDat, 0, 13)));
        assert_eq!((both[0].encoder.periods(Signal::A), both[1].encoder.periods(Signal::A)), (Some(512), Some(2048)));
        assert_eq!(format(&fitted("CHA-17A-100-H-M128S")[0]), Some((Protocol::Ssi, 12, 17)));
        let Interface::Resolver(res) = fitted("CHA-14A-100-N-RES")[0].encoder.interface.clone() else { panic!() };
        assert_eq!((res.pole_pairs, res.excitation.si(), res.frequency.si(), res.ratio), (1, 7.0, 5000.0, 0.5));
        let d2048 = &fitted("CHA-14A-100-N-D2048")[0].encoder;
        assert_eq!(
            (d2048.periods(Signal::A), d2048.periods(Signal::U), d2048.periods(Signal::Z)),
            (Some(2048), Some(5), Some(1))
        );
    }

    /// The signals of every wired code have their pins, two for a pair, and each pin that depends on the angle has a
    /// signal.
    #[test]
    fn wiring_and_encoder_agree() {
        let mut seen = 0;
        for code in configurator::Catalogue::cha().products(false).iter().filter_map(|product| product.id.order_code())
        {
            let (Some(wiring), Some(fitted)) = (wiring(code), encoders(code)) else { panic!("{code}") };
            for each in &fitted {
                for signal in each.encoder.signals() {
                    let pins = each.pins(signal, &wiring);
                    assert_eq!(pins.len(), 2, "{code} {signal:?}");
                    let names: Vec<&str> = pins.iter().map(|pin| pin.printed().split(' ').next().unwrap()).collect();
                    assert_eq!(names, [format!("{}+", signal.id()), format!("{}-", signal.id())], "{code}");
                }
                let connector = wiring.connector(each.role).unwrap();
                let signals = each.encoder.signals();
                for pin in &connector.pins {
                    let signal = pin.carries.and_then(|carried| of_meaning(carried.meaning));
                    assert!(signal.is_none_or(|signal| signals.contains(&signal)), "{code} pin {}", pin.name);
                }
                seen += 1;
            }
        }
        assert!(seen > 200, "{seen}");
    }

    #[test]
    fn a_deviation_is_bounded_by_the_printed_accuracy() {
        for code in ["CHA-20A-100-H-C1024", "CHA-25A-100-H-M512P", "CHA-14A-100-N-RES", "CHA-14A-100-N-D2048"] {
            let each = fitted(code).remove(0).deviating(3);
            let (deviation, most) = (each.encoder.deviation.clone().unwrap(), each.accuracy().unwrap().si());
            let at = |step: i32| deviation.at(Angle::from_si(f64::from(step) * 0.001)).si();
            let highest = (0..6284).map(|step| at(step).abs()).fold(0.0, f64::max);
            assert!(highest <= most && highest > 0.9 * most, "{code}: {highest} of {most}");
        }
    }
}
