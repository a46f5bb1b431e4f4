//! Symbols of derivations, and what was searched or integrated.

use crate::{pick, unpadded};
use quantities::Language;
use sizing::derivation::{Finding, Formula};

/// Greek letters by the names that symbols write.
const GREEK: [(&str, &str); 14] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("dtheta", "Δϑ"),
    ("eta", "η"),
    ("gamma", "γ"),
    ("kappa", "κ"),
    ("mu", "µ"),
    ("omega", "ω"),
    ("phi", "φ"),
    ("psi", "ψ"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("theta", "ϑ"),
];

/// Figures that the tables name in words, by the symbol that stands for them in a formula.
const LONG: [(&str, &str); 12] = [
    ("accuracy", "φ_acc"),
    ("accuracy_out", "φ_acc,out"),
    ("approvals", "N_appr"),
    ("approvals_needed", "N_appr,req"),
    ("dU", "ΔU"),
    ("hysteresis_loss", "φ_hys"),
    ("lost_motion", "φ_lm"),
    ("repeatability", "φ_rep"),
    ("resolution", "φ_res"),
    ("resolution_out", "φ_res,out"),
    ("transmission_accuracy", "φ_tr"),
    ("transformation_ratio", "k_res"),
];

/// A symbol as people write it: `omega_1` is ω_1.
#[must_use]
pub fn symbol_shown(symbol: &str) -> String {
    if let Some((_, shown)) = LONG.iter().find(|(name, _)| *name == symbol) {
        return (*shown).to_owned();
    }
    let (head, tail) = symbol.split_once('_').map_or((symbol, None), |(head, tail)| (head, Some(tail)));
    let head = GREEK.iter().find(|(name, _)| *name == head).map_or(head, |(_, letter)| letter);
    tail.map_or_else(|| head.to_owned(), |tail| format!("{head}_{tail}"))
}

/// Returns what was searched or integrated as text: the formula, if it has one, and the condition.
#[must_use]
pub fn found_text(what: Finding, language: Language) -> String {
    let condition = found_condition(what, language);
    match what.formula().and_then(|text| Formula::parse(text).ok()) {
        Some(formula) => {
            format!("{} {condition}", formula.shown(&symbol_shown, &|number| unpadded(number, 6, language)))
        }
        None => condition,
    }
}

/// Returns where or under which condition the formula of a search or an integral holds, or its whole text if it has no
/// formula.
#[must_use]
pub fn found_condition(what: Finding, language: Language) -> String {
    let (en, de) = match what {
        Finding::AccelerationAt => ("acceleration at t", "Beschleunigung bei t"),
        Finding::PeakSpeed
        | Finding::Travel
        | Finding::CopperLoss
        | Finding::AngleTravelled
        | Finding::AccelerationRms
        | Finding::LoadRms
        | Finding::Correlation
        | Finding::EffectiveCurrent
        | Finding::CubicMeanTorque
        | Finding::RadialMeanOverCycle
        | Finding::AxialMeanOverCycle
        | Finding::MomentMeanOverCycle => ("over the cycle", "im Zyklus"),
        Finding::EnergyReturned => (
            "over the cycle, with I = q·T/k_Tout + σ·(I_s + K·|n|); q = q_d while the load drives the motor, otherwise 1",
            "im Zyklus, mit I = q·T/k_Tout + σ·(I_s + K·|n|); q = q_d, solange die Last den Motor treibt, sonst 1",
        ),
        Finding::RadialMean | Finding::AxialMean | Finding::MomentMean => ("over the segments", "über die Abschnitte"),
        Finding::FrictionOfColdGear => ("(cold gear)", "(kaltes Getriebe)"),
        Finding::LeastTension => (
            "of what the rope bears, at the instant nearest to slack",
            "der Last am Seil zum Zeitpunkt, der dem Schlaffwerden am nächsten ist",
        ),
        Finding::TorqueOfLoadAt => ("load torque at t", "Lastmoment bei t"),
        Finding::PositionAt => ("position at t", "Position bei t"),
        Finding::PositionOfLargestHolding => {
            ("position of the cycle with the largest holding torque", "Position im Zyklus mit dem größten Haltemoment")
        }
        Finding::PositionOfLargestInertia => {
            ("position with the largest moment of inertia", "Position mit dem größten Massenträgheitsmoment")
        }
        Finding::PositionOfLeastInertia => {
            ("position with the smallest moment of inertia", "Position mit dem kleinsten Massenträgheitsmoment")
        }
        Finding::RecordedTorqueAt => ("recorded torque at t", "aufgezeichnetes Drehmoment bei t"),
        Finding::InertiaOfBodies => {
            ("over the bodies, by Steiner's theorem", "über die Körper nach dem Satz von Steiner")
        }
        Finding::MassOfBodies | Finding::CentreOfBodies | Finding::AngleOfBodies => {
            ("over the bodies", "über die Körper")
        }
        Finding::SpeedAt => ("speed at t", "Drehzahl bei t"),
        Finding::AngularVelocityAt => ("angular velocity at t", "Winkelgeschwindigkeit bei t"),
        Finding::DirectionAt => ("direction at t", "Richtung bei t"),
        Finding::SpeedNearResonance => (
            "constant speed from t on that is nearest to a resonance",
            "konstante Drehzahl ab t, die einer Resonanz am nächsten liegt",
        ),
        Finding::ContinuousCurve => ("continuous curve at n_av", "Dauerkennlinie bei n_av"),
        Finding::ShortTimeCurve => ("short-time curve at n, at most T_max", "Kurzzeitkennlinie bei n, höchstens T_max"),
        Finding::SpeedBeyondCurve => ("n is above n_end", "n liegt über n_end"),
        Finding::EdgeOfBand => ("edge of the band at n", "Rand des Bandes bei n"),
        Finding::LowerEdgeOfBand => ("lower edge of the band at n_av", "unterer Rand des Bandes bei n_av"),
        Finding::MeanSpeedUpToRated => ("at most the rated speed", "höchstens die Bemessungsdrehzahl"),
        Finding::GearAsHousing => {
            ("gear temperature, equal to the housing temperature", "Getriebetemperatur gleich Gehäusetemperatur")
        }
        Finding::CurrentWithinVoltage => ("largest current at n within U_M", "größter Strom bei n innerhalb U_M"),
        Finding::GearCold => (
            "cold gear, at ambient temperature, at most that of the no-load data: the less favourable of both states",
            "kaltes Getriebe, auf Umgebungstemperatur, höchstens der der Leerlaufdaten: der ungünstigere der beiden Zustände",
        ),
        Finding::GearSettled => (
            "gear in thermal steady state: the less favourable of both states",
            "Getriebe im thermischen Beharrungszustand: der ungünstigere der beiden Zustände",
        ),
        Finding::StateCold => (
            "cold gear: ambient temperature, at most that of the no-load data",
            "kaltes Getriebe: Umgebungstemperatur, höchstens die der Leerlaufdaten",
        ),
        Finding::StateSettled => ("gear in thermal steady state", "Getriebe im thermischen Beharrungszustand"),
        Finding::StateWarmest => (
            "highest temperature of the table, without a heat model",
            "höchste Temperatur der Tabelle, ohne Erwärmungsmodell",
        ),
        Finding::LawOfFriction => ("friction law at theta_g", "Reibungsgesetz bei theta_g"),
        Finding::TimeAboveContinuous => {
            ("longest time over the cycle with |I| above I_D", "längste Zeit im Zyklus mit |I| über I_D")
        }
        Finding::CurrentOfCurve => (
            "current of the published short-time curve at n, at least I_max",
            "Strom der veröffentlichten Kurzzeitkennlinie bei n, mindestens I_max",
        ),
        Finding::FrictionLoss => {
            ("over the cycle, with the coil of an open brake", "im Zyklus, mit der Spule einer geöffneten Bremse")
        }
        Finding::WindingRise => (
            "largest temperature rise of the winding above its mean in the steady-state cycle",
            "größte Erwärmung der Wicklung über ihren Mittelwert im eingeschwungenen Zyklus",
        ),
        Finding::CurvesOverModel => (
            "ratio of published curves to the model at this duty; 1 where none is published",
            "veröffentlichte Kennlinien bezogen auf das Modell bei dieser Betriebsart; 1, wo keine veröffentlicht ist",
        ),
        Finding::OverloadLag => (
            "maximum of (I/I_0)² filtered by a first-order lag with τ_w in the steady-state cycle",
            "Maximum von (I/I_0)² nach Verzögerungsglied erster Ordnung mit τ_w im eingeschwungenen Zyklus",
        ),
        Finding::OverloadPermitted => (
            "(I/I_0)² permitted by the continuous curve at n_av, at least 1",
            "(I/I_0)² nach der Dauerkennlinie bei n_av, mindestens 1",
        ),
        Finding::AxialForceMax | Finding::RadialForceMax => {
            ("over the segments in motion", "über die Abschnitte mit Bewegung")
        }
        Finding::LargestOverSegments => ("largest over the segments", "größte über die Abschnitte"),
        Finding::LargestTogether => (
            "of the largest F_r, F_a and M of the cycle, at different instants: on the safe side",
            "aus den größten F_r, F_a und M des Zyklus zu verschiedenen Zeitpunkten: auf der sicheren Seite",
        ),
        Finding::LargestOfMechanism => (
            "largest over the cycle, from mechanism and stated loads",
            "größte im Zyklus, aus Mechanik und angegebenen Lasten",
        ),
        Finding::LargestInMotion => (
            "largest while the gear turns, stated loads included",
            "größter Wert bei drehendem Getriebe, einschließlich angegebener Lasten",
        ),
        Finding::LargestAtRest => (
            "largest while the gear rests, stated loads included",
            "größter Wert bei stehendem Getriebe, einschließlich angegebener Lasten",
        ),
        Finding::TensionOfWeight => ("weight on the rope at that instant", "Gewicht am Seil zu diesem Zeitpunkt"),
        Finding::SegmentOfLargestMoment => ("in the segment of the largest M", "im Abschnitt mit dem größten M"),
        Finding::EverySegmentInMotion => ("in every segment in motion", "in jedem Abschnitt mit Bewegung"),
        Finding::TiltBehindStage => (
            "tilting of the flange does not rotate the parts behind the stage",
            "ein Kippen des Flansches verdreht die Teile hinter der Stufe nicht",
        ),
        Finding::NotKnown => ("not known: set to 0", "nicht bekannt: mit 0 angesetzt"),
        Finding::Brakings => ("dwells per cycle held by the brake", "Stillstände je Zyklus, bei denen die Bremse hält"),
        Finding::BatteryLife => ("life at t_op per day after t_store", "Lebensdauer bei t_op je Tag nach t_store"),
    };
    with_shown_symbols(pick(language, en, de))
}

/// The symbols among the words of a text as people write them: `theta_g` is ϑ_g.
fn with_shown_symbols(text: &str) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut shown = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(from) = rest.find(is_part) {
        let (before, tail) = rest.split_at(from);
        let (word, after) = tail.split_at(tail.find(|c| !is_part(c)).unwrap_or(tail.len()));
        shown.push_str(before);
        if word.contains('_') {
            shown.push_str(&symbol_shown(word))
        } else {
            shown.push_str(word)
        }
        rest = after;
    }
    shown.push_str(rest);
    shown
}
