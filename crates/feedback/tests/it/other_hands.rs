//! Against other hands: crccheck and scipy, whose traces stand in validation/feedback with their scripts and versions.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing, reason = "a test fails loudly")]

use feedback::endat::crc;
use feedback::{TrackingLoop, Word};
use quantities::{Angle, Measure};

#[test]
fn random_words_have_the_check_of_crccheck() {
    let mut words = 0;
    let lines = include_str!("../../../../validation/feedback/words.csv").lines().skip(2);
    for line in lines {
        let (bits, check) = line.split_once(',').unwrap();
        let word: Word = bits.parse().unwrap();
        assert_eq!(format!("{:05b}", crc(word)), check, "{bits}");
        words += 1;
    }
    assert_eq!(words, 600);
}

/// Within 1e-7 of the step of 0.1 mrad: the loop here is driven by the sine of the error, that of scipy by the error itself, and the
/// filter of scipy rounds near its double pole at one. On the ramp the error reaches 3 mrad and its sine differs more.
#[test]
fn the_tracking_loop_answers_as_that_of_scipy() {
    let trace = include_str!("../../../../validation/feedback/tracking.csv");
    let rows: Vec<[f64; 3]> = trace
        .lines()
        .skip(3)
        .map(|line| {
            let mut cells = line.split(',').map(|cell| cell.parse::<f64>().unwrap());
            [cells.next().unwrap(), cells.next().unwrap(), cells.next().unwrap()]
        })
        .collect();
    assert!(rows.len() > 130);
    for (column, most) in [(1, 1e-11), (2, 1e-7)] {
        let mut tracking = TrackingLoop::at_rest(Angle::from_si(0.0));
        let mut rows = rows.iter().peekable();
        for step in 1..=39_601_u32 {
            let time = f64::from(step) / TrackingLoop::RATE_HZ;
            let angle = if column == 1 { 1e-4 } else { 5.0 * time };
            let found = tracking.step([f64::sin(angle), f64::cos(angle)]).angle.si();
            if let Some(row) = rows.next_if(|row| row[0] == f64::from(step)) {
                assert!((found - row[column]).abs() < most, "step {step}: {found} {}", row[column]);
            }
        }
        assert!(rows.next().is_none());
    }
}
