//! Headings of quantities at the motor shaft, in front of the gear.

use crate::names::{Named, words};

/// Parameters of SINAMICS that hold a speed or a torque of the motor: actual and smoothed speeds, speed setpoints, and
/// torques (SINAMICS S120/S150 List Manual, r0020 to r0022, r0031, r0060 to r0063, r0079, r0080).
const SINAMICS: [u32; 10] = [20, 21, 22, 31, 60, 61, 62, 63, 79, 80];

/// Parameter of SINAMICS that holds the actual position of an encoder as it counts, Gn_XIST1, in front of every gear: r0482.
const ACTUAL_POSITION: u32 = 482;

/// Objects of CiA 402 whose values count in front of the gear ratio 6091h where the drive divides by it: velocity
/// demand, velocity actual value, velocity sensor (CiA 402-2).
const CIA_402: [&str; 3] = ["606b", "606c", "6069"];

/// Words of the motor and of the shaft in front of the gear.
const WORDS: [&str; 6] = ["rotor", "mtr", "airgap", "electromagnetic", "luftspaltmoment", "luftspaltdrehmoment"];

/// Beginnings of German compounds of the input shaft: `Antriebsdrehzahl`, `Eingangsmoment`.
const COMPOUNDS: [&str; 6] = [
    "antriebsdrehzahl",
    "antriebsmoment",
    "antriebsdrehmoment",
    "eingangsdrehzahl",
    "eingangsmoment",
    "eingangsdrehmoment",
];

/// Symbols of quantities of a shaft.
const SYMBOLS: [&str; 12] = ["n", "m", "t", "q", "phi", "theta", "omega", "w", "tau", "φ", "ω", "τ"];

/// Indices of the motor: n_M, M_M, τ_m, n_an.
const INDICES: [&str; 3] = ["m", "an", "in"];

/// Words of the input shaft before a quantity: `input speed`, `gear_input_torque`.
const INPUTS: [&str; 3] = ["input", "eingang", "antrieb"];

/// Words that place a quantity in front of the gear: `Drehzahl vor Getriebe`, `torque before gear`, `air gap torque`.
const IN_FRONT: [(&str, &str); 7] = [
    ("vor", "getriebe"),
    ("before", "gear"),
    ("before", "gearbox"),
    ("gear", "input"),
    ("gearbox", "input"),
    ("air", "gap"),
    ("inneres", "drehmoment"),
];

/// Quantities of a shaft.
const QUANTITIES: [&str; 9] =
    ["speed", "velocity", "torque", "position", "angle", "rpm", "drehzahl", "moment", "drehmoment"];

/// Returns `true` if a heading denotes a quantity of the motor, by a word (`motor_speed`, `Motordrehzahl`) or by the
/// name that a drive gives it: SINAMICS `r0482[0]`, `r0061`, `r0063`, `r0080`, Kollmorgen `VL.FB`, CiA 402 `606C`.
#[must_use]
pub fn is_of_motor(heading: &str) -> bool {
    let mut words = words(heading);
    // `vor dem Getriebe`, `before the gear`.
    words.retain(|word| word != "dem" && word != "the");
    let pairs = || words.iter().zip(words.iter().skip(1)).map(|(first, second)| (first.as_str(), second.as_str()));
    let is_word = |word: &String| {
        let object = word.trim_start_matches("0x").trim_end_matches('h');
        let is_in_front = || WORDS.contains(&word.as_str()) || COMPOUNDS.iter().any(|first| word.starts_with(first));
        let is_motor = || word.starts_with("motor") || word.ends_with("motor") || word.ends_with("mot");
        is_motor() || is_in_front() || CIA_402.contains(&object)
    };
    let is_pair = |(first, second): (&str, &str)| {
        let is_input = || QUANTITIES.contains(&second) && INPUTS.contains(&first);
        if is_input() || IN_FRONT.contains(&(first, second)) {
            return true;
        }
        let is_parameter = || second.parse().is_ok_and(|number: u32| SINAMICS.contains(&number));
        first == "r" && is_parameter() || first == "vl" && matches!(second, "fb" | "fbfilter" | "fbunfiltered" | "cmd")
    };
    // Gn_XIST1: index 0 is encoder 1, that of the motor; 1 and 2 are encoders of the machine.
    let of_encoder = words
        .windows(2)
        .position(|pair| matches!(pair, [first, second] if first == "r" && second.parse() == Ok(ACTUAL_POSITION)));
    let index = of_encoder.map(|at| words.get(at + 2).map_or("0", String::as_str));
    // Behind a symbol alone stands an index; `n_1_min` states a unit.
    let bare = self::words(&Named::marked(heading).bare);
    let is_indexed = matches!(bare.as_slice(), [symbol, index]
        if SYMBOLS.contains(&symbol.as_str()) && INDICES.contains(&index.as_str()) || symbol == "n" && index == "1");
    is_indexed
        || words.iter().any(is_word)
        || pairs().any(is_pair)
        || index.is_some_and(|index| !["1", "2"].contains(&index))
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
            "n_mot",
            "nMot",
            "nmot [1/min]",
            "Motordrehzahl",
            "motor_rpm",
            "MotorSpeed",
            "actual motor speed",
            "Actual_Motor_Speed [rpm]",
            "speed (motor) [1/min]",
            "Drehzahl Motor",
            "Motor-Istdrehzahl",
            "ServoMotor.Speed",
            "n1",
            "n_1 [1/min]",
            "n_M",
            "M_M [Nm]",
            "tau_m [Nm]",
            "theta_m [rad]",
            "omega_mot",
            "Antriebsdrehzahl",
            "n_an [1/min]",
            "input speed [rpm]",
            "gear_input_torque",
            "rotor position",
            "mtr_spd",
            "Drehzahl vor Getriebe [1/min]",
            "Drehzahl vor dem Getriebe [1/min]",
            "torque before gearbox [Nm]",
            "air gap torque [Nm]",
            "electromagnetic torque",
            "Luftspaltmoment [Nm]",
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
            "n2",
            "n_ab",
            "Abtriebsdrehzahl",
            "output speed [rpm]",
            "q1",
            "M [Nm]",
            "m",
            "t [ms]",
            "Antriebsachse_1.ActPos",
            "n [1/min]",
            "n_1_min",
            "n / 1/min",
            "q_m1",
            "motion",
            "Drehzahl",
            "Moment nach Getriebe [Nm]",
            "Moment nach dem Getriebe [Nm]",
            "Winkel vor dem Halt [deg]",
            "torque behind gear",
        ] {
            assert!(!is_of_motor(heading), "{heading}");
        }
    }
}
