//! Words about motions that cannot be.

use super::either;
use motion::{Law, MoveFault, Needed, PointsFault, RecordedFault};
use project::SegmentLaw;
use quantities::unit::{
    DEGREE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, MILLIMETRE, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE,
    SECOND,
};
use quantities::{Language, Measure, Unit, format_significant};

fn shown(si: f64, unit: &Unit, language: Language) -> String {
    format!("{} {}", format_significant(unit.from_si(si), 5, language), unit.symbol)
}

/// What a segment follows, in the words of VDI 2143.
#[must_use]
pub fn law_text(law: SegmentLaw, language: Language) -> &'static str {
    let (en, de) = match law {
        SegmentLaw::Law(Law::Trapezoid) | SegmentLaw::Manual => ("trapezoid", "Trapez"),
        SegmentLaw::Law(Law::Triangle) => ("triangle", "Dreieck"),
        SegmentLaw::Law(Law::Jerk) => ("limited jerk", "ruckbegrenzt"),
        SegmentLaw::Law(Law::Polynomial5) => ("polynomial 3-4-5", "Polynom 3-4-5"),
        SegmentLaw::Law(Law::ModifiedSine) => ("modified sine", "mod. Sinuslinie"),
        SegmentLaw::Law(Law::ModifiedTrapezoid) => ("modified trapezoid", "mod. Trapez"),
        SegmentLaw::Law(Law::SimpleSine) => ("simple sine", "einfache Sinuslinie"),
        SegmentLaw::Law(Law::InclinedSine) => ("inclined sine", "geneigte Sinuslinie"),
        SegmentLaw::Law(Law::Constant) => ("constant speed", "konstant"),
        SegmentLaw::Dwell => ("dwell", "Rast"),
        SegmentLaw::Recorded => ("recording", "Aufzeichnung"),
        SegmentLaw::Points => ("cam table", "Kurventabelle"),
    };
    match language {
        Language::En => en,
        Language::De => de,
    }
}

/// What is wrong with a move, and what would be possible.
///
/// `travel_m_per_rad`: travel per angle where the motion is stated along a line; its values are then those of the line.
pub(super) fn fault(fault: &MoveFault, travel_m_per_rad: Option<f64>, language: Language) -> (String, Option<String>) {
    let t = |en: &str, de: &str| either(language, en, de);
    let of = |si: f64, line: &Unit, turning: &Unit| match travel_m_per_rad {
        Some(travel) => shown(si * travel, line, language),
        None => shown(si, turning, language),
    };
    let speed = |si| of(si, &METRE_PER_SECOND, &REVOLUTION_PER_MINUTE);
    let way = |si| of(si, &MILLIMETRE, &DEGREE);
    let plain = |text: String| (text, None);
    match fault {
        MoveFault::NoSegment => {
            plain(t("the cycle needs at least one [[motion]]", "der Zyklus braucht mindestens ein [[motion]]"))
        }
        MoveFault::NoDuration => plain(t(
            "the cycle has no duration: all its times are zero",
            "der Zyklus hat keine Dauer: alle Zeiten sind null",
        )),
        MoveFault::NoTimeToChangeSpeed { braking } => {
            let key = if *braking { "brake" } else { "accelerate" };
            plain(either(
                language,
                format!("`{key}` must be greater than zero: a speed cannot be reached or left in no time"),
                format!(
                    "`{key}` muss größer als null sein: eine Drehzahl wird nicht in der Zeit null erreicht oder verlassen"
                ),
            ))
        }
        MoveFault::NotDetermined { given, needed } => {
            let needed = needed_words(*needed, language);
            (
                either(
                    language,
                    format!("this move is not determined by what is given ({given} of its quantities)"),
                    format!("diese Bewegung ist durch die Angaben nicht bestimmt ({given} ihrer Größen)"),
                ),
                Some(either(language, format!("give {needed}"), format!("anzugeben: {needed}"))),
            )
        }
        MoveFault::OutOfRange => plain(t(
            "a move takes time and goes somewhere: distance, time, speed and acceleration must not be zero",
            "eine Bewegung braucht Zeit und führt irgendwohin: Weg, Zeit, Drehzahl und Beschleunigung dürfen nicht null sein",
        )),
        MoveFault::SpeedTooLow { above } => (
            t(
                "the speed is too low to cover the distance in the time",
                "die Drehzahl reicht für Weg und Zeit nicht aus",
            ),
            Some(either(
                language,
                format!("it must be above {}", speed(above.si())),
                format!("sie muss über {} liegen", speed(above.si())),
            )),
        ),
        MoveFault::SpeedTooHigh { most } => (
            t(
                "the speed is too high: even a triangle of it takes less than the time",
                "die Drehzahl ist zu hoch: selbst ein Dreieck damit dauert kürzer als die Zeit",
            ),
            Some(either(
                language,
                format!("at most {}, or leave it out", speed(most.si())),
                format!("höchstens {}, oder weglassen", speed(most.si())),
            )),
        ),
        MoveFault::AccelerationTooLow { least } => {
            let least = of(least.si(), &METRE_PER_SECOND_SQUARED, &RADIAN_PER_SECOND_SQUARED);
            (
                t(
                    "the acceleration is too low for this move",
                    "die Beschleunigung reicht für diese Bewegung nicht aus",
                ),
                Some(either(language, format!("at least {least}"), format!("mindestens {least}"))),
            )
        }
        MoveFault::RestToRestOnly => (
            t("this law moves from rest to rest only", "dieses Gesetz führt nur von Stillstand zu Stillstand"),
            Some(t(
                "trapezoid, jerk and polynomial_5 can begin and end with a speed",
                "trapezoid, jerk und polynomial_5 können mit einer Drehzahl beginnen und enden",
            )),
        ),
        MoveFault::EndSpeedAboveLimit => plain(t(
            "the speed at the beginning or the end is above the largest speed of the move",
            "die Drehzahl am Anfang oder Ende liegt über der größten Drehzahl der Bewegung",
        )),
        MoveFault::StillMoving { speed: found } => plain(either(
            language,
            format!("the segment begins at {}: it needs the speed at which the one before ends", speed(found.si())),
            format!(
                "der Abschnitt beginnt mit {}: er braucht die Drehzahl, mit der der vorige endet",
                speed(found.si())
            ),
        )),
        MoveFault::SpeedNotClosed { end, start } => (
            either(
                language,
                format!("the cycle does not close: it ends at {} and begins at {}", speed(end.si()), speed(start.si())),
                format!(
                    "der Zyklus schließt nicht: er endet mit {} und beginnt mit {}",
                    speed(end.si()),
                    speed(start.si())
                ),
            ),
            Some(single_move(language)),
        ),
        MoveFault::PositionNotClosed { gap } => {
            let gap = way(gap.si());
            let (place_en, place_de) =
                if travel_m_per_rad.is_some() { ("", "") } else { (" (at the output)", " (am Abtrieb)") };
            (
                either(
                    language,
                    format!("the cycle does not close: it ends {gap}{place_en} from where it begins"),
                    format!("der Zyklus schließt nicht: er endet {gap}{place_de} vom Anfang entfernt"),
                ),
                Some(single_move(language)),
            )
        }
        MoveFault::PointsSpeedJumps { first, before } => (
            either(
                language,
                format!("the points begin at {}, the axis has {} there", speed(first.si()), speed(before.si())),
                format!("die Punkte beginnen mit {}, die Achse hat dort {}", speed(first.si()), speed(before.si())),
            ),
            Some(t(
                "state the speed of the axis with ends = \"stated\" and start_speed",
                "die Drehzahl der Achse mit ends = \"stated\" und start_speed angeben",
            )),
        ),
        MoveFault::RecordingSpeedJumps { first, before } => (
            either(
                language,
                format!("the recording begins at {}, the axis has {} there", speed(first.si()), speed(before.si())),
                format!(
                    "die Aufzeichnung beginnt mit {}, die Achse hat dort {}",
                    speed(first.si()),
                    speed(before.si())
                ),
            ),
            Some(t(
                "choose the window with from and to so that it begins at that speed, or state standstill",
                "mit from und to ein Fenster wählen, das mit dieser Drehzahl beginnt, oder standstill angeben",
            )),
        ),
        MoveFault::RecordingPositionJumps { gap } => plain(either(
            language,
            format!("the recording begins {} from where the axis stands", way(gap.si())),
            format!("die Aufzeichnung beginnt {} neben der Stellung der Achse", way(gap.si())),
        )),
    }
}

/// What is wrong with the points of a cam table.
pub(super) fn points_fault(fault: PointsFault, language: Language) -> String {
    let e = |en: String, de: String| either(language, en, de);
    match fault {
        PointsFault::TooFew { points, least } => e(
            format!("a cam table needs at least {least} points here, and has {points}"),
            format!("eine Kurventabelle braucht hier mindestens {least} Punkte, vorhanden: {points}"),
        ),
        PointsFault::NotFinite { index } => e(
            format!("point {} is beyond all numbers", index + 1),
            format!("Punkt {} liegt außerhalb aller Zahlen", index + 1),
        ),
        PointsFault::NotIncreasing { index } => e(
            format!("point {} is not after the one before it", index + 1),
            format!("Punkt {} liegt nicht nach dem vorigen", index + 1),
        ),
        PointsFault::Uneven => e(
            "the points lie so unevenly that no spline through them can be computed".to_owned(),
            "die Punkte liegen so ungleichmäßig, dass kein Spline durch sie berechnet werden kann".to_owned(),
        ),
    }
}

/// What is wrong with samples, and what to do.
pub(super) fn recorded_fault(fault: &RecordedFault, language: Language) -> (String, Option<String>) {
    let t = |en: &str, de: &str| either(language, en, de);
    match fault {
        RecordedFault::WindowTooShort { least } => {
            let least = shown(least.si(), &SECOND, language);
            (
                t(
                    "the smoothing window holds fewer than four samples somewhere",
                    "im Glättungsfenster liegen stellenweise weniger als vier Abtastwerte",
                ),
                Some(either(language, format!("at least {least}"), format!("mindestens {least}"))),
            )
        }
        RecordedFault::WindowTooLong { most } => (
            either(
                language,
                format!("the smoothing window holds more than {most} samples"),
                format!("im Glättungsfenster liegen mehr als {most} Abtastwerte"),
            ),
            None,
        ),
        RecordedFault::Contradiction { share } => {
            let share = format_significant(100.0 * share, 2, language);
            (
                either(
                    language,
                    format!("recorded position and recorded speed differ by {share} % of the travel"),
                    format!(
                        "aufgezeichnete Lage und aufgezeichnete Drehzahl weichen um {share} % des Wegs voneinander ab"
                    ),
                ),
                Some(t(
                    "check their units, or take one of them: columns.speed = \"none\"",
                    "Einheiten prüfen oder nur eine der beiden verwenden: columns.speed = \"none\"",
                )),
            )
        }
        RecordedFault::TooFew { samples } => (
            either(
                language,
                format!("{samples} samples are no motion, at least three are needed"),
                format!("{samples} Abtastwerte sind keine Bewegung, nötig sind mindestens drei"),
            ),
            None,
        ),
        RecordedFault::NoCourse => {
            (t("neither position nor speed is recorded", "weder Lage noch Drehzahl ist aufgezeichnet"), None)
        }
        RecordedFault::Uneven => (
            t("the columns do not have the same number of samples", "die Spalten haben nicht gleich viele Abtastwerte"),
            None,
        ),
        RecordedFault::NotFinite { index } => (
            either(
                language,
                format!("sample {} is not a finite number", index + 1),
                format!("Abtastwert {} ist keine endliche Zahl", index + 1),
            ),
            None,
        ),
        RecordedFault::NotIncreasing { index } => (
            either(
                language,
                format!("sample {} is not later than the one before it", index + 1),
                format!("Abtastwert {} liegt nicht nach dem vorigen", index + 1),
            ),
            None,
        ),
    }
}

fn single_move(language: Language) -> String {
    either(
        language,
        "add the way back, or write single_move = true under [axis]",
        "den Rückweg ergänzen oder unter [axis] single_move = true schreiben",
    )
}

fn needed_words(needed: Needed, language: Language) -> String {
    let (en, de) = match needed {
        Needed::TwoOfFour => {
            ("any two of distance, time, speed, acceleration", "zwei von distance, time, speed, acceleration")
        }
        Needed::TwoOrThreeOfFour => (
            "any three of distance, time, speed, acceleration, or two for a trapezoid with equal thirds",
            "drei von distance, time, speed, acceleration, oder zwei für ein Trapez mit gleichen Dritteln",
        ),
        Needed::DistanceAndLimits => {
            ("distance, speed, acceleration and jerk", "distance, speed, acceleration und jerk")
        }
        Needed::DistanceAndTime => (
            "distance and time, because the move does not begin and end at rest",
            "distance und time, weil die Bewegung nicht von Stillstand zu Stillstand führt",
        ),
        Needed::DistanceSpeedAcceleration => (
            "distance, speed and acceleration, because the move does not begin and end at rest",
            "distance, speed und acceleration, weil die Bewegung nicht von Stillstand zu Stillstand führt",
        ),
        Needed::SpeedAndTimeOrDistance => {
            ("speed and either time or distance", "speed und entweder time oder distance")
        }
    };
    either(language, en, de)
}
