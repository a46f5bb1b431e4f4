//! Modes of operation.

/// Mode of operation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(i64)]
pub(crate) enum Mode {
    /// No mode: the axis is held.
    #[default]
    None = 0,
    /// Profile position.
    ProfilePosition = 1,
    /// Profile velocity.
    ProfileVelocity = 3,
    /// Cyclic synchronous position.
    CyclicPosition = 8,
}

impl Mode {
    /// Returns the number of the mode in 6060h.
    ///
    /// # Source
    /// cia-402
    pub(crate) const fn number(self) -> i64 {
        self as i64
    }

    /// Returns the mode with a number.
    pub(crate) fn of(number: i64) -> Option<Self> {
        [Self::None, Self::ProfilePosition, Self::ProfileVelocity, Self::CyclicPosition]
            .into_iter()
            .find(|mode| mode.number() == number)
    }

    /// Returns `true` if the mode follows a position with supervision of the following error.
    pub(crate) const fn is_position(self) -> bool {
        match self {
            Self::ProfilePosition | Self::CyclicPosition => true,
            Self::None | Self::ProfileVelocity => false,
        }
    }
}
