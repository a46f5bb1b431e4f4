//! Offset of the recorded position: own weight and payloads act at the same angle of the mechanism.

use super::regression::{Row, fit};
use super::windows::Window;
use mechanism::Plain;
use std::f64::consts::{PI, TAU};

/// Number of offsets at which the search begins.
const TRIED: u32 = 24;

/// Largest number of steps of the search.
const STEPS: usize = 30;

/// Step of the offset at which the search ends \[rad\].
const CLOSE: f64 = 1e-7;

/// Weight of the first segment at an offset of the position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turned {
    /// W: weight of the first segment \[Nm\].
    pub(super) weight_nm: f64,
    /// δ: angle of the mechanism at q = 0, beyond the stated one \[rad\].
    pub(super) offset_rad: f64,
}

impl Turned {
    /// Finds weight and offset with the smallest deviation of a run; `rows` returns the equations of the windows at an offset, whose
    /// columns at `place` are those of [`Self::columns`]. `None` if the weight has no sign or the search does not end.
    ///
    /// # Source
    /// Gauss–Newton from the best of 24 offsets, docs/theory/twin.md, *Identification*
    pub(super) fn find(stated_nm: f64, place: usize, rows: &dyn Fn(Self) -> Vec<Row>) -> Option<Self> {
        let started = |k: u32| {
            let offset_rad = TAU * f64::from(k) / f64::from(TRIED) - PI;
            let start = Self { weight_nm: stated_nm, offset_rad };
            // At a fixed offset only the weight is free.
            let mut rows = rows(start);
            rows.iter_mut().for_each(|row| {
                row.regressors.remove(place + 1);
            });
            let found = fit(&rows, &[], &[])?;
            let weight_nm = found.values.get(place).copied().filter(|weight| weight * stated_nm > 0.0)?;
            Some((found.square, Self { weight_nm, offset_rad }))
        };
        let (_, mut best) = (0..TRIED).filter_map(started).min_by(|a, b| a.0.total_cmp(&b.0))?;
        for _ in 0..STEPS {
            let found = fit(&rows(best), &[], &[])?;
            let (weight_nm, step) = (*found.values.get(place)?, *found.values.get(place + 1)?);
            if weight_nm * stated_nm <= 0.0 || !step.is_finite() {
                return None;
            }
            // A step beyond a quarter of a turn leaves the range in which the equations are linear.
            let offset_rad = best.offset_rad + step.clamp(-0.5, 0.5);
            best = Self { weight_nm, offset_rad: offset_rad - TAU * (offset_rad / TAU).round() };
            if step.abs() < CLOSE {
                return Some(best);
            }
        }
        None
    }

    /// Returns the mean of cos(q + φ + δ) over a window, and the change of the torque with δ: −W sin(q + φ + δ), with the weights that
    /// the segment adds to those of the first.
    pub(super) fn columns(self, window: &Window, first: &Plain, own: Option<&Plain>) -> [f64; 2] {
        let parts = |plain: &Plain| {
            let (sine, cosine) = (plain.angle_rad + self.offset_rad).sin_cos();
            [cosine * window.cosine - sine * window.sine, sine * window.cosine + cosine * window.sine]
        };
        let [cosine, sine] = parts(first);
        let added = own.map_or(0.0, |own| own.weight_nm * parts(own)[1] - first.weight_nm * sine);
        [cosine, -self.weight_nm * sine - added]
    }
}
