//! Headings of quantities at the motor shaft, in front of the gear.

use crate::names::words;

/// Parameters of SINAMICS that hold a speed or a torque of the motor: actual and smoothed speeds, speed setpoints, and
/// torques (SINAMICS S120/S150 List Manual, r0020 to r0022, r0031, r0060 to r0063, r0079, r0080).
const SINAMICS: [u32; 10] = [20, 21, 22, 31, 60, 61, 62, 63, 79, 80];

/// Parameter of SINAMICS that holds the actual position of an encoder as it counts, Gn_XIST1, in front of every gear: r0482.
const ACTUAL_POSITION: u32 = 482;

/// Objects of CiA 402 whose values count in front of the gear ratio 6091h where the drive divides by it: velocity
/// demand, velocity actual value, velocity sensor (CiA 402-2).
const CIA_402: [&str; 3] = ["606b", "606c", "6069"];

/// Returns `true` if a heading denotes a quantity of the motor, by a word (`motor_speed`, `Motordrehzahl`) or by the
/// name that a drive gives it: SINAMICS `r0482[0]`, `r0061`, `r0063`, `r0080`, Kollmorgen `VL.FB`, CiA 402 `606C`.
#[must_use]
pub fn is_of_motor(heading: &str) -> bool {
    let words = words(heading);
    let pairs = || words.iter().zip(words.iter().skip(1)).map(|(first, second)| (first.as_str(), second.as_str()));
    let is_word = |word: &String| {
        let object = word.trim_start_matches("0x").trim_end_matches('h');
        matches!(word.as_str(), "mot" | "rotor") || word.starts_with("motor") || CIA_402.contains(&object)
    };
    let is_pair = |(first, second): (&str, &str)| {
        let is_parameter = || second.parse().is_ok_and(|number: u32| SINAMICS.contains(&number));
        first == "r" && is_parameter() || first == "vl" && matches!(second, "fb" | "fbfilter" | "fbunfiltered" | "cmd")
    };
    // Gn_XIST1: index 0 is encoder 1, that of the motor; 1 and 2 are encoders of the machine.
    let of_encoder = words
        .windows(2)
        .position(|pair| matches!(pair, [first, second] if first == "r" && second.parse() == Ok(ACTUAL_POSITION)));
    let index = of_encoder.map(|at| words.get(at + 2).map_or("0", String::as_str));
    words.iter().any(is_word) || pairs().any(is_pair) || index.is_some_and(|index| !["1", "2"].contains(&index))
}

#[cfg(test)]
mod tests {
    use super::is_of_motor;

    #[test]
    fn quantities_of_the_motor_are_known_by_their_headings() {
        for heading in [
            "r0061[0]: Speed actual value [1/min]",
            "Antriebsachse_1.r61[0]: Drehzahlistwert",
            "SERVO_02.r0063: Drehzahlistwert nach Filterung [1/min]",
            "r80[0]",
            "r0482[0]: Position [deg]",
            "Achse.r482: Gn_XIST1",
            "r61",
            "VL.FB [rpm]",
            "VL.CMD",
            "0x606C velocity actual value",
            "606Ch",
            "606C:00",
            "motor_speed_rpm",
            "Motordrehzahl [1/min]",
            "MotorTorque",
            "n_mot [1/min]",
            "Axis1.Motor.ActVelo",
        ] {
            assert!(is_of_motor(heading), "{heading}");
        }
        for heading in [
            "r0482[1]: Position [deg]",
            "r0482[2]",
            "speed [1/min]",
            "0x6064",
            "joint_2/velocity",
            "PL.FB",
            "q_r 5",
            "motion",
            "Drehzahl",
        ] {
            assert!(!is_of_motor(heading), "{heading}");
        }
    }
}
