//! Reference values by other hands; no tool rewrites this file.
//!
//! The legends of the manual's performance figures (pages 19 to 49): one curve for U_M = 220 ... 430 V at 14A-H/N,
//! 17A-H/N and 20A; two curves, for 430 V and 220 V, from 25A up. So the former reach n_mot,max and I_max with 220 V,
//! the latter do not at every ratio.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use actuator::MotorVoltage;
use order_code::{Brake, Feedback, Ratio, Series, Size, Winding};

/// Returns the terminal voltages at n_mot,max and I_max over the ratios of a size, in volts.
fn volts(size: Size) -> Vec<f64> {
    use quantities::Measure;
    let series = Series::default();
    let feedback = Feedback::of(series, if size.number() <= 17 { "RES" } else { "C1024" }).unwrap();
    Ratio::all(series)
        .filter_map(|ratio| {
            let (winding, brake) = (Winding::of(series, "H").unwrap(), Brake::Without);
            let code = order_code::OrderCode {
                size,
                ratio,
                winding,
                feedback,
                brake,
                option_1: None,
                option_2: None,
                special: false,
            };
            configurator::availability(&code).ok()?;
            let actuator = configurator::parameters(&code)?;
            let motor = MotorVoltage::of(&actuator).unwrap();
            let speed = actuator::speed_max(&actuator).unwrap().value;
            Some(motor.at(speed, actuator.current_max.known().unwrap().value).si())
        })
        .collect()
}

#[test]
fn the_voltage_model_agrees_with_the_legends_of_the_figures() {
    for size in Size::all(Series::default()) {
        let volts = volts(size);
        assert!(volts.len() >= 4, "{size}");
        let largest = volts.iter().copied().fold(0.0, f64::max);
        if size.number() <= 20 {
            assert!(largest <= 216.5, "{size}: {volts:?}");
        } else {
            assert!(largest > 220.0, "{size}: {volts:?}");
        }
    }
}
