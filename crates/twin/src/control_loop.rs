//! The control loops.

use quantities::identified;

identified! {
    /// A control loop, the innermost first.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Loop {
        /// Current loop.
        Current = "current",
        /// Speed loop.
        Speed = "speed",
        /// Position loop.
        Position = "position",
    }
}
