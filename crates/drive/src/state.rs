//! State machine of CiA 402 as a pure function of state and command.

/// Defines the states, one per line: variant, identifier and bits of the statusword.
macro_rules! states {
    ($($(#[$about:meta])* $variant:ident $id:literal $bits:literal;)*) => {
        /// State of the drive.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum State {
            $($(#[$about])* $variant,)*
        }

        impl State {
            /// The eight states, in the order of the profile.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Returns the identifier of the state.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$variant => $id,)* }
            }

            /// Returns the bits 0 to 3, 5 and 6 of the statusword.
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
    /// Initialising.
    NotReadyToSwitchOn "not_ready_to_switch_on" 0b000_0000;
    /// Switched off, waiting for a controller.
    SwitchOnDisabled "switch_on_disabled" 0b100_0000;
    /// Ready for the power supply.
    ReadyToSwitchOn "ready_to_switch_on" 0b010_0001;
    /// Power on, without torque.
    SwitchedOn "switched_on" 0b010_0011;
    /// Setpoints are followed.
    OperationEnabled "operation_enabled" 0b010_0111;
    /// Stopping or stopped by a quick stop.
    QuickStopActive "quick_stop_active" 0b000_0111;
    /// Stopping because of a fault.
    FaultReactionActive "fault_reaction_active" 0b000_1111;
    /// Stopped because of a fault.
    Fault "fault" 0b000_1000;
}

impl State {
    /// Returns `true` if the motor can produce torque in this state.
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

/// Command encoded in bits 0 to 3 of the controlword.
///
/// # Source
/// cia-402
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Command {
    /// Bits x110.
    Shutdown,
    /// Bits 0111; in the state operation enabled the command is disable operation.
    SwitchOn,
    /// Bits 1111.
    EnableOperation,
    /// Bits xx0x.
    DisableVoltage,
    /// Bits x01x.
    QuickStop,
}

impl Command {
    /// The five commands.
    pub const ALL: [Self; 5] =
        [Self::Shutdown, Self::SwitchOn, Self::EnableOperation, Self::DisableVoltage, Self::QuickStop];

    /// Returns the command of a controlword.
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
    /// Number of the transition in the profile.
    pub number: u8,
    /// State after the transition.
    pub to: State,
}

/// Returns the transition that a command causes in a state; `None` if the state remains.
///
/// Transition 15 (fault reset) needs a rising edge of bit 7 and is no command of the level; 0, 1, 13 and 14 are caused
/// by the drive itself.
///
/// # Source
/// cia-402
#[must_use]
pub const fn transition(state: State, command: Command) -> Option<Transition> {
    use Command as C;
    use State as S;
    let (number, to) = match (state, command) {
        (S::SwitchOnDisabled, C::Shutdown) => (2, S::ReadyToSwitchOn),
        // The command enable operation causes the next transition at once.
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
