//! Faults of the drive: error codes and bits of the error register.

use feedback::Finding;
use twin::{EventKind, Twin};

/// A fault of the drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u16)]
pub enum Trouble {
    /// DC link voltage too high.
    LinkHigh = 0x3210,
    /// DC link voltage too low.
    LinkLow = 0x3220,
    /// Overload, I²t.
    Overload = 0x2350,
    /// Winding temperature too high.
    Winding = 0x4310,
    /// The simulation diverged.
    Diverged = 0x6100,
    /// No valid position from the resolver.
    Resolver = 0x7303,
    /// No valid position from the incremental tracks of the encoder.
    Incremental = 0x7305,
    /// No valid position from the absolute words of the encoder.
    Position = 0x7320,
    /// The controller's heartbeat is missing.
    Guarding = 0x8130,
    /// Speed too high.
    Overspeed = 0x8400,
    /// Following error too large.
    Following = 0x8611,
}

impl Trouble {
    /// Returns the error code used in 603Fh and in the emergency message.
    ///
    /// # Source
    /// cia-301, cia-402; sensor codes (resolver 1, incremental sensor 1, position) as named in `cia402appl.h` of
    /// Beckhoff's EtherCAT slave stack code
    #[must_use]
    pub const fn code(self) -> u16 {
        self as u16
    }

    /// Returns the bits of the error register 1001h.
    ///
    /// # Source
    /// cia-301
    #[must_use]
    pub const fn register(self) -> u8 {
        const GENERIC: u8 = 1;
        GENERIC
            | match self {
                Self::Overload => 1 << 1,
                Self::LinkHigh | Self::LinkLow => 1 << 2,
                Self::Winding => 1 << 3,
                Self::Guarding => 1 << 4,
                Self::Resolver | Self::Incremental | Self::Position | Self::Overspeed | Self::Following => 1 << 5,
                Self::Diverged => 0,
            }
    }

    /// Returns `true` if the motor can still be braked along a ramp.
    #[must_use]
    pub const fn can_ramp(self) -> bool {
        match self {
            Self::Overload | Self::Winding | Self::Following | Self::Guarding => true,
            Self::LinkHigh | Self::LinkLow | Self::Diverged | Self::Overspeed => false,
            Self::Resolver | Self::Incremental | Self::Position => false,
        }
    }

    /// Returns the fault of an event reported by the supervision of a twin.
    pub(crate) fn of(event: EventKind, twin: &Twin<'_>) -> Option<Self> {
        match event {
            EventKind::Overload => Some(Self::Overload),
            EventKind::WindingShutdown | EventKind::PtcResponse => Some(Self::Winding),
            EventKind::FollowingError => Some(Self::Following),
            EventKind::LinkLow => Some(Self::LinkLow),
            EventKind::LinkHigh => Some(Self::LinkHigh),
            EventKind::NoPosition => Some(Self::of_feedback(twin)),
            EventKind::Overspeed => Some(Self::Overspeed),
            EventKind::Diverged => Some(Self::Diverged),
            EventKind::Scenario
            | EventKind::Ramp
            | EventKind::PulsesOff
            | EventKind::BrakeCloses
            | EventKind::BrakeClosed
            | EventKind::BrakeClosedMoving
            | EventKind::BrakeOpen
            | EventKind::BrakeSlips
            | EventKind::AtRest
            | EventKind::Limited
            | EventKind::WindingWarning
            | EventKind::BrakeResistor
            | EventKind::TurnsLost
            | EventKind::Demagnetisation
            | EventKind::CollisionTorque => None,
        }
    }

    /// Returns the fault of a failed feedback, by the check that detected it.
    fn of_feedback(twin: &Twin<'_>) -> Self {
        let noticed = twin.failed().and_then(|failed| failed.noticed);
        match noticed {
            _ if twin.has_resolver() => Self::Resolver,
            Some((Finding::Start | Finding::Check | Finding::ErrorBit | Finding::Difference, _)) => Self::Position,
            Some((Finding::Amplitude | Finding::Commutation | Finding::Sector, _)) | None => Self::Incremental,
        }
    }
}
