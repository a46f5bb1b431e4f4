//! Losses of a mechanism by direction of power: the side of each window follows from the recorded torque.

use super::Observed;
use super::load::{friction, mean};
use super::windows::Window;
use mechanism::{Extra, Mechanism, MechanismKind, Output, Stage};
use quantities::Measure;

/// A mechanism with losses, as three without a kink.
#[derive(Clone, Debug)]
pub(crate) struct Losses {
    /// The mechanism without losses.
    pub(crate) without: Mechanism,
    /// The mechanism with the losses of a direction of power whatever the torque: driving, driven.
    sided: [Mechanism; 2],
    /// T_c and b at the output, behind which the losses of the mechanism lie; zeros if it has none of its own.
    before: Option<[f64; 2]>,
    /// J_1 of a stage with losses \[kgm²\].
    stage_kgm2: Option<f64>,
}

/// The stated load in a window.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    /// Mean torque without friction, with the losses \[Nm\].
    pub(super) own: f64,
    /// Factor by which a torque behind the losses counts at the output \[1\].
    pub(super) factor: f64,
}

impl Part {
    /// No load and no losses.
    pub(super) const NONE: Self = Self { own: 0.0, factor: 1.0 };
}

/// Largest share of the torque in a window whose direction of power may be wrong. A choice.
pub(super) const OTHER_SIDE: f64 = 0.01;

/// Factors of the stated friction between which the side of a window may not depend on it. A choice.
const FRICTION: [f64; 2] = [0.5, 1.5];

impl Losses {
    /// Returns the losses of a mechanism; `None` if it has none.
    pub(crate) fn of(mechanism: &Mechanism) -> Option<Self> {
        let stage = mechanism.stage.filter(|stage| stage.efficiency_driving != 1.0 || stage.efficiency_driven != 1.0);
        if !mechanism.has_losses() && stage.is_none() {
            return None;
        }
        let with = |[driving, driven]: [f64; 2], [of_stage, of_stage_driven]: [f64; 2]| Mechanism {
            efficiency_driving: driving,
            efficiency_driven: driven,
            stage: mechanism.stage.map(|stage| Stage {
                efficiency_driving: of_stage,
                efficiency_driven: of_stage_driven,
                ..stage
            }),
            ..mechanism.clone()
        };
        let (driving, driven) = (mechanism.efficiency_driving, mechanism.efficiency_driven);
        let [of_stage, of_stage_driven] =
            mechanism.stage.map_or([1.0; 2], |stage| [stage.efficiency_driving, stage.efficiency_driven]);
        let mut without = with([1.0; 2], [1.0; 2]);
        if let MechanismKind::Hoist(hoist) = &mut without.kind {
            hoist.reeving = 1.0;
        }
        let sided = [
            with([driving, driving.recip()], [of_stage, of_stage.recip()]),
            with([driven.recip(), driven], [of_stage_driven.recip(), of_stage_driven]),
        ];
        let ratio = mechanism.stage_ratio();
        let friction = [mechanism.friction.coulomb.si() / ratio, mechanism.friction.viscous.si() / (ratio * ratio)];
        Some(Self {
            without,
            sided,
            before: mechanism.has_losses().then_some(friction),
            stage_kgm2: stage.map(|stage| stage.inertia_driving.si()),
        })
    }

    /// Returns T_c \[Nm\] and b [Nm s/rad] without losses.
    pub(super) fn friction(&self, extra: &Extra) -> [f64; 2] {
        let loading = self.without.loading(extra);
        let at = |speed_rad_s: f64| {
            let output = Output { position_rad: 0.0, speed_rad_s, acceleration_rad_s2: 0.0, direction: 1.0 };
            friction(&loading, output)
        };
        [at(0.0), at(1.0) - at(0.0)]
    }

    /// Returns the torque without losses and friction at rest \[Nm\].
    pub(super) fn constant_nm(&self, extra: &Extra) -> f64 {
        let loading = self.without.loading(extra);
        let output = Output { position_rad: 0.0, speed_rad_s: 0.0, acceleration_rad_s2: 0.0, direction: 1.0 };
        loading.at(&output).torque_nm - friction(&loading, output)
    }

    /// Returns the load in a window with the additions of a segment, without the friction of the first; `None` if the direction of
    /// power depends on noise or on a friction that the project need not know.
    ///
    /// T = T_f + T_0 + φ (…) + R, R = ⟨P⟩ − φ ⟨P/φ_k⟩, φ = ⟨φ_k⟩
    ///
    /// # Symbols
    /// P torque at the losses sample by sample, φ_k factor of its side, ⟨⟩ weighted mean over the window
    /// # Valid
    /// what swings in the torque accelerates flange and load in the ratio of their inertias
    pub(super) fn part(
        &self,
        run: &Observed,
        window: &Window,
        [flange_kgm2, noise_nm]: [f64; 2],
        [extra, first]: [&Extra; 2],
    ) -> Option<Part> {
        let slope = |mechanism: &Mechanism| {
            let at = |acceleration_rad_s2: f64| {
                let output = Output {
                    position_rad: window.position,
                    speed_rad_s: window.speed,
                    acceleration_rad_s2,
                    direction: window.sign,
                };
                mechanism.torque(&output, extra)
            };
            at(window.acceleration + 1.0) - at(window.acceleration)
        };
        let inertia = slope(&self.without);
        let factors = self.sided.each_ref().map(|sided| slope(sided) / inertia);
        let factors = factors.map(|factor| if factor.is_finite() { factor } else { 1.0 });
        let swings = (inertia / (inertia + flange_kgm2)).clamp(0.0, 1.0);
        let offsets = self.offsets(window, flange_kgm2);
        let [time, factor, swing_nm] = match one_side(run, window, &offsets, swings, noise_nm)? {
            Some(false) => [0.0, factors[0], 0.0],
            Some(true) => [1.0, factors[1], 0.0],
            None => both_sides(run, window, &offsets, swings, noise_nm, factors)?,
        };
        let without = self.without.loading(first);
        let part = |sided: &Mechanism| {
            let loading = sided.loading(extra);
            mean(run, window, &|output| loading.at(&output).torque_nm - friction(&without, output))
        };
        let [driving, driven] = self.sided.each_ref();
        let own = match time {
            0.0 => part(driving),
            1.0 => part(driven),
            share => (1.0 - share) * part(driving) + share * part(driven),
        };
        Some(Part { own: own + swing_nm, factor })
    }

    /// Returns the torques that may lie in front of the losses, in the direction of motion \[Nm\].
    fn offsets(&self, window: &Window, flange_kgm2: f64) -> Vec<f64> {
        let acceleration = window.acceleration * window.sign;
        let friction = self.before.map(|[coulomb, viscous]| coulomb + viscous * window.speed.abs());
        let frictions = friction.into_iter().flat_map(|friction| FRICTION.map(|factor| factor * friction));
        let stage = self.stage_kgm2.map(|stage| stage * acceleration);
        frictions.chain(stage).map(|torque| flange_kgm2 * acceleration + torque).collect()
    }
}

/// Standard deviations of the noise from the torque of zero at which it moves less than 10⁻⁶ of a torque to the other side.
const CLEAR: f64 = 5.0;

/// Returns `true` if all samples of a window are driven, `false` if all drive, beyond the noise and for each torque in front of the
/// losses; `None` within `Some` if there are both.
#[allow(clippy::option_option, reason = "no samples, or both sides")]
fn one_side(run: &Observed, window: &Window, offsets: &[f64], swings: f64, noise_nm: f64) -> Option<Option<bool>> {
    let torque = run.torque_nm.get(window.samples.clone())?;
    let ends = torque.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], torque_nm| {
        let ahead = window.sign * torque_nm;
        [low.min(ahead), high.max(ahead)]
    });
    let mean = window.torque * window.sign;
    let [low, high] = ends.map(|ahead| mean + swings * (ahead - mean));
    let [least, most] =
        offsets.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], x| [least.min(*x), most.max(*x)]);
    let drives = low - most > CLEAR * noise_nm;
    let is_driven = high - least < -CLEAR * noise_nm;
    Some((drives || is_driven).then_some(is_driven))
}

/// Returns the share of the driven samples, the mean factor and the torque from the swing of a window on both sides of the power;
/// `None` if its direction depends on noise or on a torque in front of the losses.
fn both_sides(
    run: &Observed,
    window: &Window,
    offsets: &[f64],
    swings: f64,
    noise_nm: f64,
    factors: [f64; 2],
) -> Option<[f64; 3]> {
    let at = |offset: f64| Sides::of(run, window, offset, swings, factors);
    #[allow(clippy::cast_precision_loss, reason = "at most three")]
    let middle = offsets.iter().sum::<f64>() / offsets.len() as f64;
    let sides = at(middle)?;
    if sides.turns > OTHER_SIDE || sides.noise(noise_nm) > OTHER_SIDE {
        return None;
    }
    let is_other = |offset: &f64| at(*offset).is_none_or(|other| (other.driven - sides.driven).abs() > OTHER_SIDE);
    (!offsets.iter().any(is_other)).then_some([sides.time, sides.factor, sides.swing_nm])
}

/// Directions of power in a window.
struct Sides {
    /// Share of the samples that are driven, weighted.
    time: f64,
    /// Share of the size of the torque that is driven.
    driven: f64,
    /// Mean factor.
    factor: f64,
    /// R: torque from the swing about the mean \[Nm\].
    swing_nm: f64,
    /// Share of the size of the torque, in means over a quarter of the window, on the other side than most of it.
    turns: f64,
    /// Mean size of the torque \[Nm\], and the torques with their weights.
    size_nm: f64,
    powers: Vec<[f64; 2]>,
}

impl Sides {
    fn of(run: &Observed, window: &Window, offset: f64, swings: f64, [driving, driven]: [f64; 2]) -> Option<Self> {
        let torque = run.torque_nm.get(window.samples.clone())?;
        #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
        let length = (torque.len() as f64 - 1.0).max(1.0);
        let mut powers = Vec::with_capacity(torque.len());
        let [mut all, mut time, mut other, mut size, mut sum, mut behind] = [0.0; 6];
        #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
        for (k, torque_nm) in torque.iter().enumerate() {
            let weight = (std::f64::consts::PI * k as f64 / length).sin().powi(4);
            let mean = window.torque * window.sign - offset;
            let power = mean + swings * (torque_nm - window.torque) * window.sign;
            all += weight;
            size += weight * power.abs();
            sum += weight * power;
            if power < 0.0 {
                time += weight;
                other -= weight * power;
                behind += weight * power / driven;
            } else {
                behind += weight * power / driving;
            }
            powers.push([weight, power]);
        }
        let time = time / all;
        let factor = driving + (driven - driving) * time;
        let swing_nm = if time > 0.0 && time < 1.0 { (sum - factor * behind) / all * window.sign } else { 0.0 };
        let size_nm = size / all;
        let quarters = powers
            .chunks(torque.len().div_ceil(4))
            .map(|quarter: &[[f64; 2]]| quarter.iter().map(|[weight, power]| weight * power).sum::<f64>());
        let [ahead, back] =
            quarters.fold([0.0; 2], |[ahead, back], part| [ahead + part.max(0.0), back - part.min(0.0)]);
        let turns = ahead.min(back) / (ahead + back);
        (size > 0.0).then_some(Self { time, driven: other / size, factor, swing_nm, turns, size_nm, powers })
    }

    /// Returns the share of the torque that noise moves to the other side at most.
    ///
    /// ⟨σ f(P/σ)⟩/⟨|P|⟩, f density of the normal distribution
    fn noise(&self, noise_nm: f64) -> f64 {
        if noise_nm <= 0.0 {
            return 0.0;
        }
        let density = |power: f64| (-0.5 * (power / noise_nm).powi(2)).exp() / (2.0 * std::f64::consts::PI).sqrt();
        let [all, moved] = self.powers.iter().fold([0.0; 2], |[all, moved], [weight, power]| {
            [all + weight, moved + weight * noise_nm * density(*power)]
        });
        moved / all / self.size_nm
    }
}
