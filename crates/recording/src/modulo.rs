//! Positions of modulo axes, which start again at one end of their range: 359.9°, 0.1°.

use std::f64::consts::TAU;
use std::ops::RangeInclusive;

/// Share of the range of the position that a jump to the other end has at least.
const JUMP_SHARE: f64 = 0.9;

/// Number of times that a jump exceeds the steps before and after it.
const JUMP_FACTOR: f64 = 20.0;

/// Largest step of a continuous rotation between two samples, as a share of a revolution.
const STEP_SHARE: f64 = 0.4;

/// Smallest and largest step between two samples, as a share of a revolution, of which the direction is not known if the positions
/// may be those of a modulo axis: half a revolution either way, with a tenth for the change of the speed between two samples.
const UNDECIDED: RangeInclusive<f64> = STEP_SHARE..=1.0 - STEP_SHARE;

/// Difference from a steady motion that the step across the end of the range may have, as a share of a revolution, in
/// addition to the larger of the steps before and after it.
const STEADY_SHARE: f64 = 0.01;

/// Removes the jumps of one revolution from the positions of a modulo axis \[rad\] and returns their number; zero if the
/// positions are continuous, or no positions of a modulo axis.
///
/// A step beyond half a revolution is such a jump if all positions lie within one revolution, every step is at most 0.4 of one once
/// its revolution is removed, and the motion is steady across the jump. Nearer to half a revolution the direction is not known, see
/// [`undecided_step`].
pub(crate) fn unwrap_revolutions(positions: &mut [f64]) -> usize {
    let (least, most) = range(positions);
    if most - least > TAU * (1.0 + 1e-9) {
        return 0;
    }
    let revolutions = |step: f64| (step / TAU).round();
    let bare = |step: f64| step - TAU * revolutions(step);
    let step_at = |index: usize| Some(positions.get(index + 1)? - positions.get(index)?);
    let is_steady = |index: usize, step: f64| {
        let near = [index.checked_sub(1), index.checked_add(1)].map(|index| step_at(index?).map(bare));
        let largest = near.iter().flatten().fold(0.0_f64, |most, step| most.max(step.abs()));
        near.iter().flatten().any(|other| (bare(step) - other).abs() <= largest + STEADY_SHARE * TAU)
    };
    let jumps = || steps(positions).enumerate().filter(|(_, step)| revolutions(*step) != 0.0);
    let is_modulo = steps(positions).all(|step| bare(step).abs() <= STEP_SHARE * TAU)
        && jumps().all(|(index, step)| is_steady(index, step));
    let count = jumps().count();
    if !is_modulo || count == 0 {
        return 0;
    }
    let (mut turns, mut before) = (0.0, positions.first().copied().unwrap_or(0.0));
    for position in positions.iter_mut().skip(1) {
        turns -= revolutions(*position - before);
        before = *position;
        *position += TAU * turns;
    }
    count
}

/// Returns the index of the sample after the first step of about half a revolution within positions of one revolution \[rad\], the step,
/// and the number of such steps: of a modulo axis its direction is not known.
pub(crate) fn undecided_step(positions: &[f64]) -> Option<(usize, f64, usize)> {
    let (least, most) = range(positions);
    if most - least > TAU * (1.0 + 1e-9) {
        return None;
    }
    let mut found = steps(positions).enumerate().filter(|(_, step)| UNDECIDED.contains(&(step.abs() / TAU)));
    let (index, step) = found.next()?;
    Some((index + 1, step, 1 + found.count()))
}

/// Returns the index of the sample after the first jump from one end of the range to the other against the motion, its
/// size, and the number of such jumps: no axis moves so, but a modulo axis of another range than one revolution logs so.
pub(crate) fn first_jump(positions: &[f64]) -> Option<(usize, f64, usize)> {
    let (least, most) = range(positions);
    let range = most - least;
    let jump = |(index, four): (usize, &[f64])| {
        let [first, before, behind, last] = four else { return None };
        let step = behind - before;
        let against = |other: f64| other * step < 0.0 && step.abs() >= JUMP_FACTOR * other.abs();
        // The four begin one step earlier, and a step ends at the sample behind it.
        (step.abs() >= JUMP_SHARE * range && against(before - first) && against(last - behind))
            .then_some((index + 2, step.abs()))
    };
    let mut found = positions.windows(4).enumerate().filter_map(jump);
    let (index, size) = found.next()?;
    Some((index, size, 1 + found.count()))
}

fn range(positions: &[f64]) -> (f64, f64) {
    positions.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), at| (least.min(*at), most.max(*at)))
}

fn steps(positions: &[f64]) -> impl Iterator<Item = f64> {
    positions.iter().zip(positions.iter().skip(1)).map(|(before, at)| at - before)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A generated motion over several revolutions: sines of two periods, quantised.
    fn motion(u: &mut arbtest::arbitrary::Unstructured<'_>) -> arbtest::arbitrary::Result<Vec<f64>> {
        let turns = f64::from(u.int_in_range(-40..=40_i32)?) / 8.0;
        let swing = f64::from(u.int_in_range(0..=30_i32)?) / 10.0;
        let start = f64::from(u.int_in_range(-100..=100_i32)?) / 17.0;
        let count = u.int_in_range(200..=400_usize)?;
        let at = |k: usize| {
            let part = k as f64 / count as f64;
            start + TAU * turns * (part - (TAU * part).sin() / TAU) + swing * (2.0 * TAU * part).sin()
        };
        Ok((0..=count).map(at).collect())
    }

    #[test]
    fn a_modulo_axis_gives_the_motion_of_the_axis() {
        arbtest::arbtest(|u| {
            let positions = motion(u)?;
            let start = if u.arbitrary()? { 0.0 } else { -TAU / 2.0 };
            let mut wrapped: Vec<f64> = positions.iter().map(|at| start + (at - start).rem_euclid(TAU)).collect();
            let count = wrapped.iter().zip(wrapped.iter().skip(1)).filter(|(a, b)| (*a - *b).abs() > TAU / 2.0).count();
            assert_eq!(unwrap_revolutions(&mut wrapped), count);
            let offset = wrapped[0] - positions[0];
            for (found, expected) in wrapped.iter().zip(&positions) {
                assert!((found - expected - offset).abs() < 1e-9, "{found} {expected}");
            }
            Ok(())
        });
    }

    #[test]
    fn a_continuous_motion_is_left_as_it_is() {
        arbtest::arbtest(|u| {
            let positions = motion(u)?;
            let mut found = positions.clone();
            assert_eq!(unwrap_revolutions(&mut found), 0);
            assert_eq!((found, first_jump(&positions)), (positions, None));
            Ok(())
        });
        // Coarse points of a planned motion, and points that do not continue a rotation.
        for degrees in
            [&[0.0, 120.0, 240.0, 360.0][..], &[0.0, 10.0, 20.0, 350.0, 360.0], &[0.0, 0.0, 200.0, 200.0, 0.0]]
        {
            let mut positions: Vec<f64> = degrees.iter().map(|degree: &f64| degree.to_radians()).collect();
            assert_eq!((unwrap_revolutions(&mut positions), first_jump(&positions)), (0, None), "{degrees:?}");
        }
    }

    /// A rotation of any steady speed, wrapped to one revolution, is given back, or its steps are undecided: none is read as another
    /// motion.
    #[test]
    fn a_wrapped_rotation_is_unwrapped_or_undecided() {
        for start in [0.0, -TAU / 2.0] {
            for thousandths in -990..=990_i32 {
                let step = f64::from(thousandths) / 1000.0;
                let positions: Vec<f64> = (0..40).map(|k| 0.1 + TAU * step * f64::from(k)).collect();
                let mut wrapped: Vec<f64> = positions.iter().map(|at| start + (at - start).rem_euclid(TAU)).collect();
                let offset = wrapped[0] - positions[0];
                if let Some((_, found, _)) = undecided_step(&wrapped) {
                    assert!((0.4..=0.6).contains(&(found.abs() / TAU)), "{step} {found}");
                    continue;
                }
                unwrap_revolutions(&mut wrapped);
                // Beyond half a revolution the samples are those of the rotation the other way.
                let shown = step - step.round();
                assert!(shown.abs() < 0.4, "{step}");
                for (k, found) in (0..).zip(&wrapped) {
                    let expected = positions[0] + TAU * shown * f64::from(k);
                    assert!((found - expected - offset).abs() < 1e-9, "{step}: {found} {expected}");
                }
            }
        }
    }

    #[test]
    fn a_jump_of_another_range_is_found() {
        let wrapped: Vec<f64> = (0..500).map(|k| (0.05 * f64::from(k)).rem_euclid(2.0 * TAU)).collect();
        let at = wrapped.windows(2).position(|pair| pair[1] < pair[0]).unwrap() + 1;
        let (index, size, count) = first_jump(&wrapped).unwrap();
        assert_eq!((index, count), (at, 1));
        assert!((size - 2.0 * TAU).abs() < 0.1, "{size}");
        assert_eq!(unwrap_revolutions(&mut wrapped.clone()), 0);
    }
}
