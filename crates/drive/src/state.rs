//! The state machine of CiA 402, pure: a state and a command give the transition.

/// One line per state: its variant, its identifier and its bits of the statusword.
macro_rules! states {
    ($($(#[$about:meta])* $variant:ident $id:literal $bits:literal;)*) => {
        /// A state of the drive.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum State {
            $($(#[$about])* $variant,)*
        }

        impl State {
            /// All eight.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Its identifier.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$variant => $id,)* }
            }

            /// Its bits of the statusword: 0 to 3, 5 and 6.
            ///
            /// # Source
            /// cia-402
            #[must_use]
            pub const fn bits(self) -> u16 {
                match self { $(Self::$variant => $bits,)* }
            }
        }
    };
}

states! {
    /// Begins.
    NotReadyToSwitchOn "not_ready_to_switch_on" 0b000_0000;
    /// Waits for a controller.
    SwitchOnDisabled "switch_on_disabled" 0b100_0000;
    /// May be switched on.
    ReadyToSwitchOn "ready_to_switch_on" 0b010_0001;
    /// Power is on, no torque.
    SwitchedOn "switched_on" 0b010_0011;
    /// Follows its set-points.
    OperationEnabled "operation_enabled" 0b010_0111;
    /// Stops or has stopped at once.
    QuickStopActive "quick_stop_active" 0b000_0111;
    /// Stops because of a fault.
    FaultReactionActive "fault_reaction_active" 0b000_1111;
    /// Has stopped because of a fault.
    Fault "fault" 0b000_1000;
}

impl State {
    /// Whether the axis may be moved in it.
    #[must_use]
    pub const fn has_torque(self) -> bool {
        match self {
            Self::OperationEnabled | Self::QuickStopActive | Self::FaultReactionActive => true,
            Self::NotReadyToSwitchOn
            | Self::SwitchOnDisabled
            | Self::ReadyToSwitchOn
            | Self::SwitchedOn
            | Self::Fault => false,
        }
    }
}

/// What bits 0 to 3 of the controlword command.
///
/// # Source
/// cia-402
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// x110
    Shutdown,
    /// 0111, in state operation enabled: disable operation.
    SwitchOn,
    /// 1111
    EnableOperation,
    /// xx0x
    DisableVoltage,
    /// x01x
    QuickStop,
}

impl Command {
    /// Every one.
    pub const ALL: [Self; 5] =
        [Self::Shutdown, Self::SwitchOn, Self::EnableOperation, Self::DisableVoltage, Self::QuickStop];

    /// That of a controlword.
    #[must_use]
    pub const fn of(control: u16) -> Self {
        if control & 0b0010 == 0 {
            Self::DisableVoltage
        } else if control & 0b0100 == 0 {
            Self::QuickStop
        } else if control & 0b0001 == 0 {
            Self::Shutdown
        } else if control & 0b1000 == 0 {
            Self::SwitchOn
        } else {
            Self::EnableOperation
        }
    }
}

/// A transition of the state machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Transition {
    /// Its number in the profile.
    pub number: u8,
    /// The state behind it.
    pub to: State,
}

/// The transition that a command makes in a state; `None`: the state stays.
///
/// 15 (fault reset) needs a rising edge of bit 7 and is no command of the level; 0, 1, 13 and 14 are the drive's own.
///
/// # Source
/// cia-402
#[must_use]
pub const fn transition(state: State, command: Command) -> Option<Transition> {
    use Command as C;
    use State as S;
    let (number, to) = match (state, command) {
        (S::SwitchOnDisabled, C::Shutdown) => (2, S::ReadyToSwitchOn),
        // With enable operation the next transition follows at once.
        (S::ReadyToSwitchOn, C::SwitchOn | C::EnableOperation) => (3, S::SwitchedOn),
        (S::SwitchedOn, C::EnableOperation) => (4, S::OperationEnabled),
        (S::OperationEnabled, C::SwitchOn) => (5, S::SwitchedOn),
        (S::SwitchedOn, C::Shutdown) => (6, S::ReadyToSwitchOn),
        (S::ReadyToSwitchOn, C::DisableVoltage | C::QuickStop) => (7, S::SwitchOnDisabled),
        (S::OperationEnabled, C::Shutdown) => (8, S::ReadyToSwitchOn),
        (S::OperationEnabled, C::DisableVoltage) => (9, S::SwitchOnDisabled),
        (S::SwitchedOn, C::DisableVoltage | C::QuickStop) => (10, S::SwitchOnDisabled),
        (S::OperationEnabled, C::QuickStop) => (11, S::QuickStopActive),
        (S::QuickStopActive, C::DisableVoltage) => (12, S::SwitchOnDisabled),
        (S::QuickStopActive, C::EnableOperation) => (16, S::OperationEnabled),
        (S::NotReadyToSwitchOn | S::FaultReactionActive | S::Fault, _)
        | (S::SwitchOnDisabled, C::SwitchOn | C::EnableOperation | C::DisableVoltage | C::QuickStop)
        | (S::ReadyToSwitchOn, C::Shutdown)
        | (S::SwitchedOn, C::SwitchOn)
        | (S::OperationEnabled, C::EnableOperation)
        | (S::QuickStopActive, C::Shutdown | C::SwitchOn | C::QuickStop) => return None,
    };
    Some(Transition { number, to })
}
