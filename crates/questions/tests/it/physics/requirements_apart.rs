//! Checks of the requirements: every one of them has a check of its own: no row of a table stands for two of them.

use super::{checks, read};
use sizing::{CheckId, Verdict};

const CODE: &str = "CHA-20A-100-H-M512P-B";

/// Keys of a project that state a limit or a demand: the table, the key, a value that is met and one that is not, and the check.
const REQUIREMENTS: &[(&str, &str, &str, &str, CheckId)] = &[
    ("drive", "current_continuous", "\"90 A\"", "\"0.1 A\"", CheckId::DriveCurrent),
    ("requirements", "torsion_max", "\"1 deg\"", "\"1e-4 deg\"", CheckId::Torsion),
    ("requirements", "natural_frequency_min", "\"0.1 Hz\"", "\"900 Hz\"", CheckId::NaturalFrequency),
    ("requirements", "bearing_life_min", "\"10 h\"", "\"1e8 h\"", CheckId::BearingLife),
    ("requirements", "gear_life_min", "\"1 h\"", "\"1e8 h\"", CheckId::GearLife),
    ("requirements", "tilt_angle_max", "\"1 deg\"", "\"1e-9 deg\"", CheckId::TiltAngle),
    ("requirements", "angle_error_max", "\"1 deg\"", "\"1 arcsec\"", CheckId::ErrorBudget),
    ("requirements", "deviation_max", "\"90 mm\"", "\"0.001 mm\"", CheckId::Deviation),
    ("requirements", "regeneration_power_max", "\"9 kW\"", "\"1e-6 W\"", CheckId::Regeneration),
    ("requirements", "resolution_max", "\"1 deg\"", "\"1e-4 arcsec\"", CheckId::FeedbackResolution),
    ("requirements", "stop_angle_max", "\"900 deg\"", "\"1e-3 deg\"", CheckId::BrakeEmergency),
    ("requirements", "emergency_stops", "2", "1000000", CheckId::BrakeStops),
    ("requirements", "service_life", "\"10 h\"", "\"1e8 h\"", CheckId::BrakeApplications),
    ("requirements", "holding_safety", "1.0", "99.0", CheckId::BrakeHolding),
    ("requirements", "collision_torque", "\"1 N m\"", "\"150 N m\"", CheckId::CollisionTorque),
    ("requirements", "collisions", "1", "1000000", CheckId::CollisionNumber),
    ("requirements", "humidity_max", "0.7", "0.99", CheckId::Humidity),
    ("requirements", "humidity_min", "0.4", "0.01", CheckId::HumidityMin),
    ("requirements", "vibration", "\"0.01 g\"", "\"90 g\"", CheckId::Vibration),
    ("requirements", "shock", "\"0.1 g\"", "\"900 g\"", CheckId::Shock),
    ("requirements", "protection", "\"IP54\"", "\"IP67\"", CheckId::Protection),
];

/// Returns the project with every requirement met but those of `violated`.
fn project(violated: &[usize]) -> String {
    let keys = |table: &str| {
        let of_table = REQUIREMENTS.iter().enumerate().filter(|(_, (of, ..))| *of == table);
        let line = |(place, (_, key, met, not_met, _)): (usize, &(&str, &str, &str, &str, CheckId))| {
            format!("{key} = {}\n", if violated.contains(&place) { not_met } else { met })
        };
        of_table.map(line).collect::<String>()
    };
    format!(
        "format = 1\n[mechanism.arm]\nmass = \"10 kg\"\ncentre_distance = \"100 mm\"\ninertia = \"0.05 kg m^2\"\n\
         axis_tilt = \"90 deg\"\n\
         [[motion]]\nlaw = \"modified_sine\"\ndistance = \"60 deg\"\ntime = \"0.6 s\"\n\
         [[motion]]\nlaw = \"dwell\"\ntime = \"2 s\"\nhold = \"brake\"\n\
         [[motion]]\nlaw = \"modified_sine\"\ndistance = \"-60 deg\"\ntime = \"0.6 s\"\n\
         [bearing]\noverhang = \"200 mm\"\nload_factor = 1.2\noperating_condition = \"normal\"\n\
         [drive]\n{}[requirements]\nlever_arm = \"300 mm\"\ncollision_time = \"0.1 s\"\noperation_per_day = \"16 h\"\n{}",
        keys("drive"),
        keys("requirements"),
    )
}

/// A violated requirement fails its own check, or advises where only a rating of another gear limits it; every other row stays.
#[test]
fn a_violated_requirement_fails_its_own_check_alone() {
    let of = |violated: &[usize]| -> Vec<(CheckId, Verdict)> {
        checks(&read(&project(violated)), CODE).iter().map(|check| (check.id, check.verdict)).collect()
    };
    let met = of(&[]);
    for (place, (_, key, _, _, id)) in REQUIREMENTS.iter().enumerate() {
        let of_check =
            |rows: &[(CheckId, Verdict)]| rows.iter().find(|(row, _)| row == id).map(|(_, verdict)| *verdict);
        assert_eq!(of_check(&met), Some(Verdict::Pass), "{key}");
        let found = of(&[place]);
        assert!(matches!(of_check(&found), Some(Verdict::Fail | Verdict::Advice)), "{key}: {:?}", of_check(&found));
        let others =
            |rows: &[(CheckId, Verdict)]| rows.iter().filter(|(row, _)| row != id).copied().collect::<Vec<_>>();
        assert_eq!(others(&found), others(&met), "{key}");
    }
    let all: Vec<usize> = (0..REQUIREMENTS.len()).collect();
    let found = of(&all);
    for (_, key, _, _, id) in REQUIREMENTS {
        let verdict = found.iter().find(|(row, _)| row == id).map(|(_, verdict)| *verdict);
        assert!(matches!(verdict, Some(Verdict::Fail | Verdict::Advice)), "{key} with all others: {verdict:?}");
    }
}
