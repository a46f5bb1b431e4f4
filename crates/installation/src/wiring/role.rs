//! Role of a connector, and the cells that apply to it.

use catalogue::Cell;
use order_code::OrderCode;
use quantities::identified;

identified! {
    /// Role of a connector.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Role {
        /// Motor phases, protective earth, brake.
        Motor = "motor",
        /// Motor feedback.
        Feedback = "feedback",
        /// Encoder at the gear output, option EC.
        OutputEncoder = "output_encoder",
    }
}

/// Returns `true` if a cell applies to the size and feedback of a code.
pub(super) fn holds(cell: &Cell, role: Role, code: &OrderCode) -> bool {
    let size = format!("{}-{}", code.series().as_str(), code.size);
    let feedback = if role == Role::OutputEncoder { "EC" } else { code.feedback.as_str() };
    let among = |entry: &str, name: &str| entry.is_empty() || entry.split(" / ").any(|each| each == name);
    among(cell.place.drive, &size) && among(cell.feedback, feedback)
}
