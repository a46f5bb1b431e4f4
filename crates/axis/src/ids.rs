//! Identifiers of the faults of lower crates, which need none themselves.

use mechanism::BodyError;
use motion::{MoveFault, RecordedFault};

/// Returns the identifier of an impossible motion.
pub(crate) const fn motion(fault: &MoveFault) -> &'static str {
    match fault {
        MoveFault::NoSegment => "motion_empty",
        MoveFault::NoDuration => "motion_without_duration",
        MoveFault::NoTimeToChangeSpeed { .. } => "no_time_to_change_speed",
        MoveFault::NotDetermined { .. } => "move_not_determined",
        MoveFault::OutOfRange => "move_out_of_range",
        MoveFault::SpeedTooLow { .. } => "move_speed_too_low",
        MoveFault::SpeedTooHigh { .. } => "move_speed_too_high",
        MoveFault::AccelerationTooLow { .. } => "move_acceleration_too_low",
        MoveFault::RestToRestOnly => "rest_to_rest_only",
        MoveFault::EndSpeedAboveLimit => "end_speed_above_limit",
        MoveFault::StillMoving { .. } => "still_moving",
        MoveFault::PointsSpeedJumps { .. } => "points_speed_jumps",
        MoveFault::RecordingSpeedJumps { .. } => "recording_speed_jumps",
        MoveFault::RecordingPositionJumps { .. } => "recording_position_jumps",
        MoveFault::SpeedNotClosed { .. } => "speed_not_closed",
        MoveFault::PositionNotClosed { .. } => "position_not_closed",
    }
}

/// Returns the identifier of samples that do not form a motion.
pub(crate) const fn recorded(fault: &RecordedFault) -> &'static str {
    match fault {
        RecordedFault::TooFew { .. } => "samples_too_few",
        RecordedFault::NoCourse => "samples_without_course",
        RecordedFault::Uneven => "samples_uneven",
        RecordedFault::NotFinite { .. } => "samples_not_finite",
        RecordedFault::NotIncreasing { .. } => "samples_not_increasing",
        RecordedFault::WindowTooShort { .. } => "smoothing_too_short",
        RecordedFault::WindowTooLong { .. } => "smoothing_too_long",
        RecordedFault::WindowOverMotion { .. } => "smoothing_over_motion",
        RecordedFault::StampsUneven { .. } => "time_stamps_uneven",
        RecordedFault::Contradiction { .. } => "position_and_speed_contradict",
    }
}

/// Returns the identifier of a file that is no recording.
pub(crate) fn recording(fault: &recording::Fault) -> &'static str {
    use recording::{Fault, Limit};
    match fault {
        Fault::ReadFailed { .. } => "recording_read_failed",
        Fault::NoHeader => "recording_no_header",
        Fault::LineTooLong { .. } => "recording_line_too_long",
        Fault::QuoteOpen { .. } => "recording_quote_open",
        Fault::Ragged { .. } => "recording_ragged",
        Fault::CommasTwice { .. } => "recording_commas_twice",
        Fault::SpacesOnly => "recording_spaces_only",
        Fault::NotText => "recording_not_text",
        Fault::ColumnUnknown { .. } => "recording_column_unknown",
        Fault::ColumnTwice { .. } => "recording_column_twice",
        Fault::NoTable => "recording_no_table",
        Fault::TimeMissing { .. } => "recording_time_missing",
        Fault::CourseMissing { .. } => "recording_course_missing",
        Fault::UnitWithoutColumn { .. } => "recording_unit_without_column",
        Fault::Ambiguous { .. } => "recording_columns_ambiguous",
        Fault::ClockUnknown { .. } => "recording_clock_unknown",
        Fault::HeadingMissing { .. } => "recording_heading_missing",
        Fault::HeadingOfUnits { .. } => "recording_heading_of_units",
        Fault::TimesDiffer { .. } => "recording_times_differ",
        Fault::Foreign { .. } => "recording_other_format",
        Fault::Stopped => "recording_stopped",
        Fault::UnitMissing { .. } => "recording_unit_missing",
        Fault::UnitUnknown { .. } => "recording_unit_unknown",
        Fault::UnitWrong { .. } => "recording_unit_wrong",
        Fault::UnitScaled { .. } => "recording_unit_scaled",
        Fault::UnitContradiction { .. } => "recording_unit_contradiction",
        Fault::CourseMixed { .. } => "recording_course_mixed",
        Fault::WindowReversed { .. } => "recording_window_reversed",
        Fault::ValueMissing { .. } => "recording_value_missing",
        Fault::ValueUnreadable { .. } => "recording_value_unreadable",
        Fault::UnitOfCell { .. } => "recording_unit_of_cell",
        Fault::ValueNotFinite { .. } => "recording_value_not_finite",
        Fault::ValueImplausible { .. } => "recording_value_implausible",
        Fault::DecimalMixed { .. } => "recording_decimal_mixed",
        Fault::ThousandsGrouped { .. } => "recording_thousands_grouped",
        Fault::ThousandsPossible { .. } => "recording_thousands_possible",
        Fault::PositionJumps { .. } => "recording_position_jumps",
        Fault::ColumnType { .. } => "recording_column_type",
        Fault::Backwards { .. } => "recording_time_backwards",
        Fault::SameTime { .. } => "recording_same_time",
        Fault::TooClose { .. } => "recording_times_too_close",
        Fault::Gap { .. } => "recording_gap",
        Fault::SeveralAxes { .. } => "recording_several_axes",
        Fault::ScaleUnknown { .. } => "recording_scale_unknown",
        Fault::StepUndecided { .. } => "recording_step_undecided",
        Fault::TurnBegun { .. } => "recording_turn_begun",
        Fault::TooFewSamples { .. } => "recording_too_few_samples",
        Fault::TooManySamples { .. } => "recording_too_many_samples",
        Fault::Beyond { limit, .. } => match limit {
            Limit::FileBytes => "recording_file_too_large",
            Limit::Memory => "recording_memory",
            Limit::Rows => "recording_too_many_rows",
            Limit::Columns => "recording_too_many_columns",
            Limit::Nesting => "recording_groups_too_deep",
            Limit::PathBytes => "recording_path_too_long",
            Limit::RowGroups => "recording_too_many_row_groups",
            Limit::PageRatio => "recording_page_ratio",
            Limit::UnpackedBytes => "recording_unpacked_too_large",
            Limit::DeltaBlock => "recording_delta_block",
            Limit::BlankBytes => "recording_no_rows",
        },
        Fault::ParquetUnreadable { .. } => "recording_parquet_unreadable",
        Fault::Repeated { first, .. } | Fault::BelowRows { first, .. } => recording(first),
        Fault::Advised { fault, .. } => recording(fault),
        Fault::More { .. } => "recording_more_faults",
    }
}

/// Returns the identifier of an impossible body.
pub(crate) const fn body(error: &BodyError) -> &'static str {
    match error {
        BodyError::DimensionOutOfRange { .. } => "body_dimension_out_of_range",
        BodyError::DimensionMissing { .. } => "body_dimension_missing",
        BodyError::InnerNotBelowOuter { .. } => "body_inner_not_below_outer",
        BodyError::NoMass => "body_without_mass",
        BodyError::MassAndDensity { .. } => "body_mass_and_density",
        BodyError::NoVolume => "body_without_volume",
        BodyError::MassOutOfRange { .. } => "body_mass_out_of_range",
        BodyError::DensityOutOfRange { .. } => "body_density_out_of_range",
        BodyError::DistanceOutOfRange { .. } => "body_distance_out_of_range",
        BodyError::AngleNotFinite => "body_angle_not_finite",
        BodyError::NoPiece => "body_no_piece",
        BodyError::BeyondNumbers => "body_beyond_numbers",
    }
}
