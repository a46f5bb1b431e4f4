//! Direction of counting of the motor feedback.

use catalogue::Fact;
use order_code::{FeedbackKind, OrderCode};

/// Returns the fact that states the direction of increasing position.
///
/// Section 6.22 states it for the absolute encoders and the signal sequence of C1024 and D2048 for the same direction;
/// it states nothing for the resolver.
pub(super) fn counting_fact(code: &OrderCode) -> Option<&'static Fact> {
    let id = match code.feedback.kind()? {
        FeedbackKind::EndatMultiturn | FeedbackKind::SsiMultiturn => "position_rises_absolute",
        FeedbackKind::SineIncremental | FeedbackKind::SquareIncremental => "direction_of_signals",
        FeedbackKind::Resolver => return None,
    };
    catalogue::fact(id).filter(|fact| fact.holds_for.series == code.series())
}
