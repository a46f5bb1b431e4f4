//! Words for the cycle on the chosen actuator: the duty types of IEC 60034-1.

use crate::operation;
use crate::texts::texts;
use quantities::Language;
use sizing::DutyType;

/// Returns the designation of a duty type.
#[must_use]
pub const fn duty_id(duty: DutyType) -> &'static str {
    match duty {
        DutyType::Continuous => "S1",
        DutyType::Intermittent => "S3",
        DutyType::WithStarting => "S4",
        DutyType::WithBraking => "S5",
        DutyType::ContinuousLoadChanges => "S6",
        DutyType::ContinuousWithBraking => "S7",
        DutyType::SpeedChanges | DutyType::HeldAtStandstill => "S8",
    }
}

/// Returns the name of a duty type.
#[must_use]
pub const fn duty_name(duty: DutyType, language: Language) -> &'static str {
    match duty {
        DutyType::Continuous => operation::continuous(language),
        DutyType::Intermittent => operation::intermittent(language),
        DutyType::WithStarting => operation::intermittent_with_starting(language),
        DutyType::WithBraking => operation::intermittent_with_braking(language),
        DutyType::ContinuousLoadChanges => operation::continuous_load_changes(language),
        DutyType::ContinuousWithBraking => operation::continuous_with_braking(language),
        DutyType::SpeedChanges | DutyType::HeldAtStandstill => operation::speed_changes(language),
    }
}

/// Returns the properties of the cycle from which its duty type follows.
#[must_use]
pub const fn duty_reason(duty: DutyType, language: Language) -> &'static str {
    match duty {
        DutyType::Continuous => operation::because_continuous(language),
        DutyType::Intermittent => operation::because_intermittent(language),
        DutyType::WithStarting => operation::because_starting(language),
        DutyType::WithBraking => operation::because_braking(language),
        DutyType::ContinuousLoadChanges => operation::because_load_changes(language),
        DutyType::ContinuousWithBraking => operation::because_without_rest(language),
        DutyType::SpeedChanges => operation::because_speed_changes(language),
        DutyType::HeldAtStandstill => operation::because_held(language),
    }
}

texts! {
    mounting_position = "mounting position" | "Einbaulage";
    not_stated = "not stated by the manual" | "in der Anleitung nicht angegeben";
    continuous = "continuous running duty" | "Dauerbetrieb";
    intermittent = "intermittent periodic duty" | "Aussetzbetrieb";
    intermittent_with_starting = "intermittent periodic duty with starting" | "Aussetzbetrieb mit Einfluss des Anlaufvorgangs";
    intermittent_with_braking =
        "intermittent periodic duty with electric braking" | "Aussetzbetrieb mit elektrischer Bremsung";
    continuous_load_changes = "continuous-operation periodic duty" | "ununterbrochener periodischer Betrieb";
    continuous_with_braking =
        "continuous-operation periodic duty with electric braking"
        | "ununterbrochener periodischer Betrieb mit elektrischer Bremsung";
    speed_changes =
        "continuous-operation periodic duty with related load/speed changes"
        | "ununterbrochener periodischer Betrieb mit Last- und Drehzahländerungen";
    because_continuous = "speed and torque are constant" | "Drehzahl und Drehmoment konstant";
    because_intermittent =
        "standstill without torque in every cycle; acceleration and braking contribute less than 10 % of ∫T²dt"
        | "in jedem Zyklus Stillstand ohne Drehmoment; Beschleunigen und Bremsen tragen weniger als 10 % zu ∫T²dt bei";
    because_starting =
        "standstill without torque in every cycle, starting contributes to the heating, no electric braking"
        | "in jedem Zyklus Stillstand ohne Drehmoment, der Anlauf trägt zur Erwärmung bei, keine elektrische Bremsung";
    because_braking =
        "standstill without torque, starting and electric braking in every cycle"
        | "in jedem Zyklus Stillstand ohne Drehmoment, Anlauf und elektrische Bremsung";
    because_load_changes = "constant speed, the torque changes, no standstill" | "konstante Drehzahl, wechselndes Drehmoment, kein Stillstand";
    because_without_rest =
        "starting and electric braking in every cycle, no standstill"
        | "in jedem Zyklus Anlauf und elektrische Bremsung, kein Stillstand";
    because_speed_changes = "the speed changes with the load, no standstill" | "Drehzahl ändert sich mit der Last, kein Stillstand";
    because_held =
        "the motor holds a torque at standstill and is never without current"
        | "der Motor hält im Stillstand ein Drehmoment und ist nie stromlos";
}
