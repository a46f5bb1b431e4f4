//! Choices of the file in the types of the engine.

use project::choices as stated;

/// Defines a function for each choice. A value of the file without one of the engine does not compile.
macro_rules! in_the_engine {
    ($($name:ident: $Choice:ident => $Engine:path { $($Variant:ident),+ })+) => {$(
        pub(crate) const fn $name(choice: stated::$Choice) -> $Engine {
            match choice {
                $(stated::$Choice::$Variant => <$Engine>::$Variant,)+
            }
        }
    )+};
}

in_the_engine! {
    law: Law => ::motion::Law { Trapezoid, Triangle, Jerk, Polynomial5, ModifiedSine, ModifiedTrapezoid, SimpleSine, InclinedSine, Constant }
    hold: Hold => ::motion::Hold { Motor, Brake, Free }
    spline: Spline => ::motion::Spline { Cubic, Quintic }
    orientation: Orientation => ::mechanism::Orientation { Parallel, Perpendicular }
    stage_kind: StageKind => ::mechanism::StageKind { Belt, Gear, Coupling }
    arm_shape: ArmShape => ::mechanism::ArmShape { Rod, Bar, Taper, Point }
    bearing_type: BearingDesign => ::actuator::BearingType { CrossedRoller, FourPoint }
    winding: WebWinding => ::mechanism::Winding { Up, Off }
    operating_condition: OperatingCondition => ::sizing::OperatingCondition { Normal, Shock, HighAccuracy }
    mains_phases: MainsPhases => ::sizing::MainsPhases { Single, Three }
    mounting_position: MountingPosition => ::sizing::MountingPosition { Horizontal, FlangeUp, FlangeDown, Changing }
    special_application: SpecialApplication => ::sizing::SpecialApplication { Aerospace, ExplosiveAtmosphere, Nuclear, Vacuum, Household, Medical, HumanContact, LiftingOfPersons, Amusement }
    reaction: Reaction => ::twin::Reaction { Ramp, Brake, Coast }
    failure: Failure => ::feedback::Failure { Track, Amplitude, Cable, Check, ErrorBit, DataLine }
    scenario: ScenarioId => ::twin::ScenarioId { Cycle, EmergencyStop, PowerFailure, BrakeStuck, HangingLoad, BlockedLoad, EncoderFailure, BatteryLoss, LinkSag, HotAmbient, ColdGrease, Collision }
    turn: Turn => ::installation::commission::recorded::Turn { Clockwise, CounterClockwise }
    counting: Counting => ::installation::commission::recorded::Counting { Rising, Falling }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requires equal words in equal order where the engine has identifiers of its own.
    #[test]
    fn a_choice_has_the_word_of_its_value_in_the_engine() {
        assert_eq!(stated::Law::IDS, ::motion::Law::IDS);
        assert_eq!(stated::Spline::IDS, ::motion::Spline::IDS);
        assert_eq!(stated::Reaction::IDS, ::twin::Reaction::IDS);
        assert_eq!(stated::ScenarioId::IDS, ::twin::ScenarioId::IDS);
        assert_eq!(stated::Failure::IDS, ::feedback::Failure::IDS);
        assert!(stated::Law::ALL.into_iter().all(|each| law(each).id() == each.id()));
        assert!(stated::Spline::ALL.into_iter().all(|each| spline(each).id() == each.id()));
        assert!(stated::Reaction::ALL.into_iter().all(|each| reaction(each).id() == each.id()));
        assert!(stated::ScenarioId::ALL.into_iter().all(|each| scenario(each).id() == each.id()));
        assert!(stated::Failure::ALL.into_iter().all(|each| failure(each).id() == each.id()));
    }
}
