//! Losses of a mechanism by direction of power: the side of each window follows from the recorded torque.

use super::Observed;
use super::load::mean;
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

/// Share of the torque on the other side of the power up to which a window counts as one of one side. A choice.
pub(super) const OTHER_SIDE: f64 = 0.01;

/// Factors of the stated friction between which the side of a window may not depend on it. A choice.
const FRICTION: [f64; 2] = [0.5, 1.5];

/// Number of samples over which the sign of a power is determined, half of them on each side.
const SIGN_HALF: usize = 4;

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

    /// Returns half the difference of the torques of both directions without losses \[Nm\].
    pub(super) fn coulomb_nm(&self, extra: &Extra) -> f64 {
        let at = |direction: f64| {
            let output = Output { position_rad: 0.0, speed_rad_s: 0.0, acceleration_rad_s2: 0.0, direction };
            self.without.torque(&output, extra)
        };
        0.5 * (at(1.0) - at(-1.0))
    }

    /// Returns the load in a window; `None` if the power changes its direction within it, or may do so.
    pub(super) fn part(&self, run: &Observed, window: &Window, flange_kgm2: f64, extra: &Extra) -> Option<Part> {
        let is_driven = self.is_driven(run, window, flange_kgm2)?;
        let sided = self.sided.get(usize::from(is_driven))?;
        let (loading, without) = (sided.loading(extra), self.without.loading(extra));
        let own = mean(run, window, &|output| {
            let back = Output { speed_rad_s: -output.speed_rad_s, direction: -output.direction, ..output };
            let friction = 0.5 * (without.at(&output).torque_nm - without.at(&back).torque_nm);
            loading.at(&output).torque_nm - friction
        });
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
        let factor = slope(sided) / slope(&self.without);
        Some(Part { own, factor: if factor.is_finite() { factor } else { 1.0 } })
    }

    /// Returns `true` if the load drives the actuator in the whole window, `false` if the actuator drives.
    fn is_driven(&self, run: &Observed, window: &Window, flange_kgm2: f64) -> Option<bool> {
        let torque = run.torque_nm.get(window.samples.clone())?;
        let speed = window.speed.abs();
        let flange = flange_kgm2 * window.acceleration * window.sign;
        let friction = self.before.map(|[coulomb, viscous]| coulomb + viscous * speed);
        let offsets = friction.into_iter().flat_map(|friction| FRICTION.map(|factor| flange + factor * friction));
        let offsets = offsets.chain(self.stage_kgm2.map(|stage| flange + stage * window.acceleration * window.sign));
        let mut side = None;
        for offset in offsets {
            let [mut driving, mut driven] = [0.0; 2];
            #[allow(clippy::cast_precision_loss, reason = "counts of samples")]
            for (k, group) in torque.chunks(2 * SIGN_HALF + 1).enumerate() {
                let place = (k * (2 * SIGN_HALF + 1) + group.len() / 2) as f64 / torque.len() as f64;
                let weight = (std::f64::consts::PI * place).sin().powi(4) * group.len() as f64;
                let power = group.iter().sum::<f64>() / group.len() as f64 * window.sign - offset;
                if power > 0.0 { driving += weight * power } else { driven -= weight * power }
            }
            let all = driving + driven;
            let own = if driven <= OTHER_SIDE * all {
                false
            } else if driving <= OTHER_SIDE * all {
                true
            } else {
                return None;
            };
            if *side.get_or_insert(own) != own {
                return None;
            }
        }
        side
    }
}
