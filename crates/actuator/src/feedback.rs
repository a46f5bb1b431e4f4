//! Position feedback: resolution, accuracy, absolute range.

use crate::battery::Battery;
use provenance::{Datum, Grade, Sourced};
use quantities::{Angle, Measure, Time};

/// Shaft on which a feedback is mounted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FeedbackSide {
    /// Motor shaft; errors reach the output divided by the ratio.
    #[default]
    Motor,
    /// Output shaft.
    Output,
}

/// Data of a feedback system, referred to its shaft.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Feedback {
    /// Shaft on which the feedback is mounted.
    pub side: FeedbackSide,
    /// Smallest step, with the interpolation assumed in the tables.
    pub resolution: Datum<Angle>,
    /// Step of the absolute position; not applicable without one.
    pub resolution_absolute: Datum<Angle>,
    /// Largest deviation in either direction.
    pub accuracy: Datum<Angle>,
    /// Number of turns in the absolute position; not applicable if turns are not counted.
    pub turns_absolute: Datum<f64>,
    /// The position within one turn is known immediately after switching on, not only for commutation.
    pub single_turn_absolute: bool,
    /// A battery retains the number of turns.
    pub buffered_by_battery: bool,
    /// Buffer battery; not applicable without one.
    pub battery: Datum<Battery>,
    /// Recommended replacement interval of an encoder with a battery; not applicable without one.
    pub exchange_interval: Datum<Time>,
}

impl Feedback {
    /// Returns the data of a shaft without feedback.
    #[must_use]
    pub const fn absent(side: FeedbackSide) -> Self {
        Self {
            side,
            resolution: Datum::NotApplicable,
            resolution_absolute: Datum::NotApplicable,
            accuracy: Datum::NotApplicable,
            turns_absolute: Datum::NotApplicable,
            single_turn_absolute: false,
            buffered_by_battery: false,
            battery: Datum::NotApplicable,
            exchange_interval: Datum::NotApplicable,
        }
    }

    /// Returns an angle of the encoder shaft referred to the output: φ_out = φ / i for the motor, φ for the output.
    fn at_output(&self, angle: &Datum<Angle>, ratio: &Datum<f64>) -> Datum<Angle> {
        match (angle, ratio.known(), self.side) {
            (_, _, FeedbackSide::Output) => angle.clone(),
            (Datum::Known(angle), Some(ratio), FeedbackSide::Motor) => Datum::Known(Sourced {
                value: Angle::from_si(angle.value.si() / ratio.value),
                source: angle.source.clone(),
                grade: angle.grade.worst(ratio.grade).worst(Grade::Computed),
                errata: angle.errata,
            }),
            (Datum::NotApplicable, _, FeedbackSide::Motor) => Datum::NotApplicable,
            (_, _, FeedbackSide::Motor) => Datum::NotPrinted,
        }
    }

    /// Returns the smallest step at the output.
    ///
    /// φ_out = φ / i for a feedback on the motor
    ///
    /// # Source
    /// docs/theory/feedback.md; agrees with the rows of the manual within their rounding
    #[must_use]
    pub fn resolution_out(&self, ratio: &Datum<f64>) -> Datum<Angle> {
        self.at_output(&self.resolution, ratio)
    }

    /// Returns the largest deviation at the output, φ / i for a motor feedback.
    #[must_use]
    pub fn accuracy_out(&self, ratio: &Datum<f64>) -> Datum<Angle> {
        self.at_output(&self.accuracy, ratio)
    }

    /// Returns the turns of the encoder shaft over which the position is absolute.
    fn absolute_turns(&self) -> Option<f64> {
        let single = self.single_turn_absolute.then_some(1.0);
        self.turns_absolute.known().map(|turns| turns.value).or(single)
    }

    /// Returns the turns of the output over which the position is absolute.
    ///
    /// N_out = N / i for a motor feedback that counts N turns, 1/i for one that codes a single turn; N or 1 for one at
    /// the output; `None` if nothing is absolute or the ratio is unknown
    ///
    /// # Source
    /// docs/theory/feedback.md; the cha-manual lists its whole turns
    #[must_use]
    pub fn absolute_turns_out(&self, ratio: &Datum<f64>) -> Option<f64> {
        let turns = self.absolute_turns()?;
        match self.side {
            FeedbackSide::Motor => Some(turns / ratio.known()?.value),
            FeedbackSide::Output => Some(turns),
        }
    }

    /// Returns `true` if an axis turning continuously in one direction loses its absolute reference when the count
    /// overflows, because the range is not a whole number of output turns. `None` if there is no absolute range.
    ///
    /// N mod i ≠ 0 on the motor
    ///
    /// # Source
    /// docs/theory/feedback.md
    #[must_use]
    pub fn endless_axis_loses_reference(&self, ratio: &Datum<f64>) -> Option<bool> {
        let turns = self.absolute_turns()?;
        match self.side {
            FeedbackSide::Motor => Some(turns % ratio.known()?.value != 0.0),
            FeedbackSide::Output => Some(turns.fract() != 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use provenance::{CellRef, Source};
    use quantities::unit::ARCSECOND;

    fn known<T>(value: T) -> Datum<T> {
        const CELL: CellRef = CellRef::of_the_manual("58.1", "x", "");
        Datum::Known(Sourced { value, source: Source::Cell(&CELL), grade: Grade::Printed, errata: &[] })
    }

    /// 4096 turns of 131072 steps, ±60″.
    fn multi_turn() -> Feedback {
        Feedback {
            resolution: known(Angle::from_si(std::f64::consts::TAU / 131_072.0)),
            accuracy: known(Angle::new_in(60.0, &ARCSECOND)),
            turns_absolute: known(4096.0),
            single_turn_absolute: true,
            ..Feedback::default()
        }
    }

    fn seconds(angle: &Datum<Angle>) -> f64 {
        angle.known().unwrap().value.in_unit(&ARCSECOND)
    }

    /// 1296000″/131072/100 = 0.0989″, in the manual 0,10; ±0.6″.
    #[test]
    fn the_ratio_divides_what_the_motor_sees() {
        let feedback = multi_turn();
        assert!((seconds(&feedback.resolution_out(&known(100.0))) - 0.098_877).abs() < 1e-6);
        assert!((seconds(&feedback.accuracy_out(&known(100.0))) - 0.6).abs() < 1e-12);
        assert_eq!(feedback.accuracy_out(&Datum::NotPrinted), Datum::NotPrinted);
        let out = Feedback { side: FeedbackSide::Output, ..multi_turn() };
        assert!((seconds(&out.accuracy_out(&Datum::NotPrinted)) - 60.0).abs() < 1e-12);
    }

    #[test]
    fn no_ratio_of_the_series_divides_4096() {
        for ratio in [30.0, 50.0, 80.0, 100.0, 120.0, 160.0] {
            assert_eq!(multi_turn().endless_axis_loses_reference(&known(ratio)), Some(true));
        }
        assert_eq!(multi_turn().endless_axis_loses_reference(&known(64.0)), Some(false));
        assert!((multi_turn().absolute_turns_out(&known(50.0)).unwrap() - 81.92).abs() < 1e-12);
    }

    #[test]
    fn what_is_not_absolute_has_no_range() {
        assert_eq!(Feedback::default().absolute_turns_out(&known(50.0)), None);
        assert_eq!(Feedback::default().endless_axis_loses_reference(&known(50.0)), None);
        let resolver = Feedback { single_turn_absolute: true, ..Feedback::default() };
        assert!((resolver.absolute_turns_out(&known(50.0)).unwrap() - 0.02).abs() < 1e-15);
        let absent = Feedback::absent(FeedbackSide::Output);
        assert_eq!(absent.accuracy_out(&known(50.0)), Datum::NotApplicable);
        let output = Feedback { side: FeedbackSide::Output, single_turn_absolute: true, ..absent };
        assert_eq!(output.endless_axis_loses_reference(&Datum::NotPrinted), Some(false));
    }
}
