//! Every identifier of the commissioning has its words in both languages.
#![allow(missing_docs, reason = "a test")]

use installation::commission::expected::{Band, Measurand};
use installation::commission::recorded::{Cause, Unjudged};
use installation::commission::sinamics::ParameterChoice;
use installation::commission::{Conversion, Gap, ParameterId};
use order_code::{Ratio, Series};
use project::MeasuredKey;
use project::names::{MeasuredRootName, NoLoadName, SensorName};
use quantities::Language;
use words::{
    band_text, cause_text, choice_text, conversion_text, gap_text, measurand_name, measured_key_text, parameter_name,
    unjudged_text,
};

fn differ(what: &str, text: impl Fn(Language) -> String) {
    let [en, de] = Language::ALL.map(text);
    assert!(!en.trim().is_empty() && !de.trim().is_empty() && en != de, "{what}: {en:?} {de:?}");
}

#[test]
fn parameters_gaps_and_conversions() {
    for &id in ParameterId::ALL {
        differ(id.id(), |language| parameter_name(id, language).to_owned());
    }
    for conversion in Conversion::ALL {
        differ(conversion.id(), |language| conversion_text(conversion, language).to_owned());
    }
    let gaps = [
        Gap::RatedPoint,
        Gap::RatedVoltage,
        Gap::CommutationOffset,
        Gap::PolePosition,
        Gap::ThermalTimeConstant,
        Gap::Saliency,
        Gap::LoopGains,
        Gap::OwnObjects,
        Gap::NotPrinted(ParameterId::BrakeClosingTime),
    ];
    for gap in gaps {
        differ(gap.id(), |language| gap_text(gap, language));
    }
    for choice in [
        ParameterChoice::Synchronous,
        ParameterChoice::IdentifiedEncoder,
        ParameterChoice::EnteredEncoder,
        ParameterChoice::SensorAtEncoder,
        ParameterChoice::SensorKty,
    ] {
        differ("choice", |language| choice_text(choice, language).to_owned());
    }
}

#[test]
fn measurands_bands_and_reasons() {
    for what in Measurand::ALL {
        differ(what.id(), |language| measurand_name(what, language).to_owned());
    }
    for band in Band::ALL {
        differ(band.id(), |language| band_text(band, language).to_owned());
    }
    for why in [Unjudged::NotMeasured, Unjudged::NotStated, Unjudged::NotThere] {
        differ("unjudged", |language| unjudged_text(why, language).to_owned());
    }
    for key in [
        MeasuredKey::Root(MeasuredRootName::winding),
        MeasuredKey::Sensor(SensorName::kty),
        MeasuredKey::Root(MeasuredRootName::direction),
        MeasuredKey::NoLoad(NoLoadName::current),
    ] {
        differ("key", |language| measured_key_text(key, language).to_owned());
    }
}

#[test]
fn causes() {
    let causes = [
        Cause::OnePhase,
        Cause::Doubled,
        Cause::TerminalsJoined,
        Cause::WindingTemperature(91.5),
        Cause::Leads(0.12),
        Cause::Open,
        Cause::Short,
        Cause::PhaseVoltage,
        Cause::Amplitude,
        Cause::PhaseAmplitude,
        Cause::PeakToPeak,
        Cause::RootThree,
        Cause::SpeedFactor,
        Cause::SpeedOfFlange,
        Cause::Magnets,
        Cause::KtyPolesOrTemperature(41.0),
        Cause::OtherSensor,
        Cause::PtcResponded,
        Cause::BrakeNotConnected,
        Cause::HalfVoltage,
        Cause::HoldingCurrent,
        Cause::OpeningCurrent,
        Cause::SlowBrake,
        Cause::Dragging,
        Cause::ConvertedTwice,
        Cause::SpeedOfMotor,
        Cause::SameDirection,
        Cause::CountingReversed,
        Cause::OtherRatio(Ratio::at(Series::default(), 0)),
        Cause::PolePairs(3.0),
    ];
    for cause in causes {
        differ(cause.id(), |language| cause_text(cause, language));
    }
}
