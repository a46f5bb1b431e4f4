//! Words for impossible motions.

use crate::texts::said;
use crate::{pick, terms};
use axis::SegmentLoadKey;
use motion::{MoveFault, Needed, PointsFault, RecordedFault};
use project::SegmentLaw;
use project::choices::Law;
use quantities::unit::{
    DEGREE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED, MILLIMETRE, RADIAN_PER_SECOND_SQUARED, REVOLUTION_PER_MINUTE,
    SECOND,
};
use quantities::{Language, Measure, Unit, format_significant, with_symbol};

fn shown(si: f64, unit: &Unit, language: Language) -> String {
    with_symbol(&format_significant(unit.from_si(si), 5, language), unit.symbol_in(language))
}

/// Returns the name of a load that acts in a segment.
#[must_use]
pub fn segment_load(load: SegmentLoadKey, language: Language) -> &'static str {
    match load {
        SegmentLoadKey::Payload => terms::payload(language),
        SegmentLoadKey::PayloadInertia => terms::payload_inertia(language),
        SegmentLoadKey::ProcessForce => terms::acting_process_force(language),
        SegmentLoadKey::ExternalTorque => terms::acting_external_torque(language),
    }
}

/// Returns the motion law of a segment, in the terms of VDI 2143.
#[must_use]
pub fn law_text(law: SegmentLaw, language: Language) -> &'static str {
    let (en, de) = match law {
        SegmentLaw::Law(Law::Trapezoid) | SegmentLaw::Manual => ("trapezoid", "Trapez"),
        SegmentLaw::Law(Law::Triangle) => ("triangle", "Dreieck"),
        SegmentLaw::Law(Law::Jerk) => ("jerk-limited", "ruckbegrenzt"),
        SegmentLaw::Law(Law::Polynomial5) => ("polynomial 3-4-5", "Polynom 3-4-5"),
        SegmentLaw::Law(Law::ModifiedSine) => ("modified sine", "mod. Sinuslinie"),
        SegmentLaw::Law(Law::ModifiedTrapezoid) => ("modified trapezoid", "mod. Trapez"),
        SegmentLaw::Law(Law::SimpleSine) => ("simple sine", "einfache Sinuslinie"),
        SegmentLaw::Law(Law::InclinedSine) => ("inclined sine", "geneigte Sinuslinie"),
        SegmentLaw::Law(Law::Constant) => ("constant speed", "konstant"),
        SegmentLaw::Dwell => ("dwell", "Rast"),
        SegmentLaw::Recorded => ("recording", "Aufzeichnung"),
        SegmentLaw::Points => ("cam table", "Kurventabelle"),
        SegmentLaw::Open => ("polynomial 3-4-5, assumed", "Polynom 3-4-5, angenommen"),
        SegmentLaw::Web => ("web run", "Bahnlauf"),
    };
    pick(language, en, de)
}

/// Returns the fault of a move and the possible values.
///
/// `travel_m_per_rad`: travel per angle if the motion is stated along a line; the values are then those of the line.
pub(super) fn fault(fault: &MoveFault, travel_m_per_rad: Option<f64>, language: Language) -> (String, Option<String>) {
    let of = |si: f64, line: &Unit, turning: &Unit| match travel_m_per_rad {
        Some(travel) => shown(si * travel, line, language),
        None => shown(si, turning, language),
    };
    let speed = |si| of(si, &METRE_PER_SECOND, &REVOLUTION_PER_MINUTE);
    let way = |si| of(si, &MILLIMETRE, &DEGREE);
    let plain = |text: String| (text, None);
    match fault {
        MoveFault::NoSegment => plain(said!(language =>
            "the cycle requires at least one [[motion]]"
            | "der Zyklus erfordert mindestens ein [[motion]]"
        )),
        MoveFault::NoDuration => plain(said!(language =>
            "the cycle has no duration: all its times are zero"
            | "der Zyklus hat keine Dauer: alle Zeiten sind null"
        )),
        MoveFault::NoTimeToChangeSpeed { braking } => {
            let key = if *braking { "brake" } else { "accelerate" };
            plain(said!(language =>
                "`{key}` must be greater than zero: a change of speed takes time"
                | "`{key}` muss größer als null sein: eine Drehzahländerung dauert eine endliche Zeit"
            ))
        }
        MoveFault::NotDetermined { given, needed } => {
            let is_over = *given > needed.most();
            let needed = needed_words(*needed, language);
            (
                if is_over {
                    said!(language =>
                        "the stated quantities overdetermine this move (quantities stated: {given})"
                        | "diese Bewegung ist durch die Angaben überbestimmt (angegebene Größen: {given})"
                    )
                } else {
                    said!(language =>
                        "the stated quantities do not determine this move (quantities stated: {given})"
                        | "diese Bewegung ist durch die Angaben nicht bestimmt (angegebene Größen: {given})"
                    )
                },
                Some(said!(language => "state {needed}" | "anzugeben: {needed}")),
            )
        }
        MoveFault::OutOfRange => plain(said!(language =>
            "distance, time, speed and acceleration of a move must not be zero"
            | "Weg, Zeit, Drehzahl und Beschleunigung einer Bewegung dürfen nicht null sein"
        )),
        MoveFault::SpeedTooLow { above } => (
            said!(language =>
                "the speed is too low to cover the distance in the time"
                | "die Drehzahl reicht für Weg und Zeit nicht aus"
            ),
            Some(said!(language => "it must be above {}" | "sie muss über {} liegen", speed(above.si()))),
        ),
        MoveFault::SpeedTooHigh { most } => (
            said!(language =>
                "the speed is too high: even a triangular profile takes less than the stated time"
                | "die Drehzahl ist zu hoch: selbst ein Dreieckprofil dauert kürzer als die angegebene Zeit"
            ),
            Some(said!(language => "at most {}, or omit it" | "höchstens {}, oder weglassen", speed(most.si()))),
        ),
        MoveFault::AccelerationTooLow { least } => {
            let least = of(least.si(), &METRE_PER_SECOND_SQUARED, &RADIAN_PER_SECOND_SQUARED);
            (
                said!(language =>
                    "the acceleration is too low for this move"
                    | "die Beschleunigung reicht für diese Bewegung nicht aus"
                ),
                Some(said!(language => "at least {least}" | "mindestens {least}")),
            )
        }
        MoveFault::RestToRestOnly => (
            said!(language =>
                "this law applies to moves from standstill to standstill only"
                | "dieses Gesetz gilt nur für Bewegungen von Stillstand zu Stillstand"
            ),
            Some(said!(language =>
                "trapezoid, jerk and polynomial_5 can begin and end at a speed"
                | "trapezoid, jerk und polynomial_5 können mit einer Drehzahl beginnen und enden"
            )),
        ),
        MoveFault::EndSpeedAboveLimit => plain(said!(language =>
            "the speed at the beginning or the end is above the largest speed of the move"
            | "die Drehzahl am Anfang oder Ende liegt über der größten Drehzahl der Bewegung"
        )),
        MoveFault::StillMoving { speed: found } => plain(said!(language =>
            "the segment begins at {}: it must begin at the end speed of the previous segment"
            | "der Abschnitt beginnt mit {}: er muss mit der Enddrehzahl des vorigen Abschnitts beginnen", speed(found.si())
        )),
        MoveFault::SpeedNotClosed { end, start } => (
            said!(language =>
                "the cycle does not close: it ends at {} and begins at {}"
                | "der Zyklus schließt nicht: er endet mit {} und beginnt mit {}", speed(end.si()), speed(start.si())
            ),
            Some(single_move(language)),
        ),
        MoveFault::PositionNotClosed { gap } => {
            let gap = way(gap.si());
            let (place_en, place_de) =
                if travel_m_per_rad.is_some() { ("", "") } else { (" (at the output)", " (am Abtrieb)") };
            (
                said!(language =>
                    "the cycle does not close: it ends {gap}{place_en} from where it begins"
                    | "der Zyklus schließt nicht: er endet {gap}{place_de} vom Anfang entfernt"
                ),
                Some(single_move(language)),
            )
        }
        MoveFault::PointsSpeedJumps { first, before } => (
            said!(language =>
                "the points begin at {}, the axis has {} there"
                | "die Punkte beginnen mit {}, die Achse hat dort {}", speed(first.si()), speed(before.si())
            ),
            Some(said!(language =>
                "state the speed of the axis with `ends = \"stated\"` and `start_speed`"
                | "die Drehzahl der Achse mit `ends = \"stated\"` und `start_speed` angeben"
            )),
        ),
        MoveFault::RecordingSpeedJumps { first, before } => (
            said!(language =>
                "the recording begins at {}, the axis has {} there"
                | "die Aufzeichnung beginnt mit {}, die Achse hat dort {}", speed(first.si()), speed(before.si())
            ),
            Some(said!(language =>
                "choose the window so that it begins at that speed, from = \"…\" and to = \"…\", or state standstill = \"…\""
                | "ein Fenster wählen, das mit dieser Drehzahl beginnt, from = \"…\" und to = \"…\", oder standstill = \"…\" angeben"
            )),
        ),
        MoveFault::RecordingPositionJumps { gap } => plain(said!(language =>
            "the recording begins {} away from the position of the axis"
            | "die Aufzeichnung beginnt {} neben der Position der Achse", way(gap.si())
        )),
    }
}

/// Returns the fault in the points of a cam table.
pub(super) fn points_fault(fault: PointsFault, language: Language) -> String {
    match fault {
        PointsFault::TooFew { points, least } => said!(language =>
            "this cam table requires at least {least} points; it has {points}"
            | "die Kurventabelle erfordert hier mindestens {least} Punkte, vorhanden sind {points}"
        ),
        PointsFault::NotFinite { index } => {
            said!(language => "point {} is not a finite number" | "Punkt {} ist keine endliche Zahl", index + 1)
        }
        PointsFault::NotIncreasing { index } => said!(language =>
            "point {} is not after the one before it"
            | "Punkt {} liegt nicht nach dem vorigen", index + 1
        ),
        PointsFault::Uneven => said!(language =>
            "the points are spaced too unevenly for a spline to be computed"
            | "die Punkte liegen zu ungleichmäßig, um einen Spline zu berechnen"
        ),
    }
}

/// Returns the fault in samples and the remedy.
pub(super) fn recorded_fault(fault: &RecordedFault, language: Language) -> (String, Option<String>) {
    match fault {
        RecordedFault::WindowTooShort { least } => {
            let least = least.map(|least| shown(least.si(), &SECOND, language));
            (
                said!(language =>
                    "the smoothing window contains fewer than four samples in places"
                    | "im Glättungsfenster liegen stellenweise weniger als vier Abtastwerte"
                ),
                Some(match least {
                    Some(least) => said!(language => "at least {least}" | "mindestens {least}"),
                    None => said!(language =>
                        "the recording is too short for a window: leave out smoothing"
                        | "die Aufzeichnung ist zu kurz für ein Fenster: smoothing weglassen"
                    ),
                }),
            )
        }
        RecordedFault::WindowOverMotion { window, duration } => {
            let [window, duration] = [window, duration].map(|time| shown(time.si(), &SECOND, language));
            (
                said!(language =>
                    "the smoothing window of {window} is wider than the recording of {duration}"
                    | "das Glättungsfenster von {window} ist breiter als die Aufzeichnung von {duration}"
                ),
                Some(said!(language =>
                    "a window far shorter than the shortest acceleration"
                    | "ein Fenster weit kürzer als die kürzeste Beschleunigung"
                )),
            )
        }
        RecordedFault::WindowTooLong { most } => (
            said!(language =>
                "the smoothing window contains more than {most} samples"
                | "im Glättungsfenster liegen mehr als {most} Abtastwerte"
            ),
            None,
        ),
        RecordedFault::Contradiction { share, factor } => {
            let share = format_significant(100.0 * share, 2, language);
            let factor = factor.map(|factor| format_significant(factor, 4, language));
            (
                match &factor {
                    Some(factor) => said!(language =>
                        "the recorded speed is {factor} times that of the recorded position"
                        | "die aufgezeichnete Drehzahl ist das {factor}-Fache derjenigen aus der aufgezeichneten Position"
                    ),
                    None => said!(language =>
                        "recorded position and recorded speed differ by {share} % of the travel"
                        | "aufgezeichnete Position und aufgezeichnete Drehzahl weichen um {share} % des Wegs voneinander ab"
                    ),
                },
                Some(said!(language =>
                    "check their units and the side of the gear (recorded_ratio), or use only one of them: columns.speed = \"none\""
                    | "Einheiten und Getriebeseite (recorded_ratio) prüfen oder nur eine der beiden verwenden: columns.speed = \"none\""
                )),
            )
        }
        RecordedFault::StampsUneven { scatter, interval } => {
            let of = |seconds: f64| format!("{} ms", format_significant(1e3 * seconds, 3, language));
            let (scatter, interval) = (of(scatter.si()), of(interval.si()));
            (
                said!(language =>
                    "the rows are not evenly spaced: the time stamps deviate by {scatter} (standard deviation) from equal intervals of {interval}"
                    | "die Zeilen haben keinen gleichen Abstand: die Zeitstempel weichen um {scatter} (Standardabweichung) von gleichen Abständen zu {interval} ab"
                ),
                Some(said!(language =>
                    "leave out time_stamps = \"even\", or select a part with one interval, from = \"…\" and to = \"…\""
                    | "time_stamps = \"even\" weglassen oder einen Abschnitt mit einem einzigen Abstand wählen, from = \"…\" und to = \"…\""
                )),
            )
        }
        RecordedFault::TooFew { samples } => (
            said!(language =>
                "{samples} samples are not a motion; at least three are required"
                | "{samples} Abtastwerte ergeben keine Bewegung; erforderlich sind mindestens drei"
            ),
            None,
        ),
        RecordedFault::NoCourse => (
            said!(language => "neither position nor speed is recorded" | "weder Position noch Drehzahl ist aufgezeichnet"),
            None,
        ),
        RecordedFault::Uneven => (
            said!(language =>
                "the columns do not have the same number of samples"
                | "die Spalten haben nicht gleich viele Abtastwerte"
            ),
            None,
        ),
        RecordedFault::NotFinite { index } => (
            said!(language => "sample {} is not a finite number" | "Abtastwert {} ist keine endliche Zahl", index + 1),
            None,
        ),
        RecordedFault::NotIncreasing { index } => (
            said!(language =>
                "sample {} is not later than the one before it"
                | "Abtastwert {} liegt nicht nach dem vorigen", index + 1
            ),
            None,
        ),
    }
}

fn single_move(language: Language) -> String {
    said!(language =>
        "add the return move, or make it a single move (`axis.single_move`)"
        | "den Rückweg ergänzen oder als einmalige Bewegung kennzeichnen (`axis.single_move`)"
    )
}

fn needed_words(needed: Needed, language: Language) -> String {
    let (en, de) = match needed {
        Needed::TwoOfFour => (
            "any two of `distance`, `time`, `speed`, `acceleration`",
            "zwei von `distance`, `time`, `speed`, `acceleration`",
        ),
        Needed::TwoOrThreeOfFour => (
            "any three of `distance`, `time`, `speed`, `acceleration`, or two for a trapezoid with equal thirds",
            "drei von `distance`, `time`, `speed`, `acceleration`, oder zwei für ein Trapez mit gleichen Dritteln",
        ),
        Needed::DistanceAndLimits => {
            ("`distance`, `speed`, `acceleration` and `jerk`", "`distance`, `speed`, `acceleration` und `jerk`")
        }
        Needed::DistanceAndTime => (
            "`distance` and `time`, because the move does not begin and end at rest",
            "`distance` und `time`, weil die Bewegung nicht von Stillstand zu Stillstand führt",
        ),
        Needed::DistanceSpeedAcceleration => (
            "`distance`, `speed` and `acceleration`, because the move does not begin and end at rest",
            "`distance`, `speed` und `acceleration`, weil die Bewegung nicht von Stillstand zu Stillstand führt",
        ),
        Needed::SpeedAndTimeOrDistance => {
            ("`speed` and either `time` or `distance`", "`speed` und entweder `time` oder `distance`")
        }
    };
    pick(language, en, de).to_owned()
}

/// Returns the way to state a time of a recording with clock times.
pub(crate) fn time_of_clock(language: Language) -> String {
    said!(language =>
        "clock times of a recording count from its first row: write the time since then, such as \"12.5 s\""
        | "Uhrzeiten einer Aufzeichnung zählen ab ihrer ersten Zeile: die Zeit seitdem angeben, etwa \"12.5 s\""
    )
}

/// Returns the ways to make a recorded cycle close.
pub(crate) fn close_the_recording(language: Language) -> String {
    said!(language =>
        "choose the window, from = \"…\" and to = \"…\", state standstill = \"…\", or state single_move = true under [axis]"
        | "das Fenster wählen, from = \"…\" und to = \"…\", standstill = \"…\" oder unter [axis] single_move = true angeben"
    )
}

/// Returns the turns of a winder for a speed of its web, or the web wound by one turn.
pub(crate) fn web_of_winder(web_m_s: Option<f64>, diameters_m: [f64; 2], language: Language) -> String {
    let [start, core] = diameters_m.map(|diameter| shown(diameter, &MILLIMETRE, language));
    match web_m_s {
        Some(web) => {
            // A line of the project file has a decimal point.
            let line = |value: f64| format_significant(value, 4, Language::OF_ERRORS);
            let speed = |diameter: f64| line(REVOLUTION_PER_MINUTE.from_si(2.0 * web / diameter));
            let [at_start, at_core] = diameters_m.map(speed);
            said!(language =>
                "the diameter changes with every turn, n = v/(π D): speed = \"{at_start} 1/min\" at the start diameter {start}, \"{at_core} 1/min\" at the core {core}; at a constant line speed over the whole roll: law = \"web\""
                | "der Durchmesser ändert sich mit jeder Umdrehung, n = v/(π D): speed = \"{at_start} 1/min\" am Anfangsdurchmesser {start}, \"{at_core} 1/min\" an der Hülse {core}; bei konstanter Bahngeschwindigkeit über den ganzen Wickel: law = \"web\""
            )
        }
        None => {
            let wound = |diameter: f64| format_significant(std::f64::consts::PI * diameter, 4, language);
            let [at_start, at_core] = diameters_m.map(wound);
            said!(language =>
                "the diameter changes with every turn: state turns of the roll in rev; one turn winds {at_start} m at the start diameter {start}, {at_core} m at the core {core}"
                | "der Durchmesser ändert sich mit jeder Umdrehung: Umdrehungen des Wickels in rev angeben; eine Umdrehung wickelt {at_start} m am Anfangsdurchmesser {start}, {at_core} m an der Hülse {core}"
            )
        }
    }
}
