//! Mechanisms driven by an actuator: torque and inertia at its output.
//!
//! A [`Mechanism`] returns, for any state of the output (position, speed, acceleration), the torque that the actuator
//! must apply to the load, divided into useful torque and friction. The kinds differ only in their inertia and
//! position-dependent torque: a [`Rotor`] turns with the output, a [`Linear`] drive moves a mass along a line, a
//! [`SliderCrank`] does so with a variable lever, a [`Table`] is given point by point, and the torque of a [`Joint`] is
//! recorded. With a [`Stage`] between actuator and mechanism, states and torques still refer to the actuator's output.

mod arm;
mod belt;
mod body;
mod conveyor;
pub mod drawing;
mod equations;
mod explain;
mod explain_flange;
mod extremes;
mod flange;
mod four_bar;
mod friction;
mod hoist;
mod joint;
mod linear;
mod load;
mod loading;
mod rope;
mod rotor;
mod scissor_lift;
mod screw;
mod slider_crank;
mod stage;
mod table;
mod turntable;
mod winder;

pub use arm::{ArmBody, ArmShape};
pub use body::{Body, BodyError, BodyFault, BodyInertia, Inertia, Orientation, SolidShape, inertia};
pub use explain::At;
pub use explain_flange::FlangeLoadKind;
pub use extremes::Extremes;
pub use flange::{Aligned, Contact, FlangeForces, Mounting, Recurrence};
pub use four_bar::FourBar;
pub use friction::Friction;
pub use hoist::{Hoist, reeving_efficiency};
pub use joint::Joint;
pub use linear::{Linear, LinearKind};
pub use loading::{LoadTorque, Loading};
pub use rope::Rope;
pub use rotor::{Rotor, RotorKind};
pub use scissor_lift::ScissorLift;
pub use slider_crank::SliderCrank;
pub use stage::{Stage, StageKind};
pub use table::{Table, TableFault, TablePoint};
pub use winder::{Winder, Winding};

use drawing::{Drawing, MechanismValues};
use equations::{Equations, Reduced};
use quantities::unit::STANDARD_GRAVITY;
use quantities::{Force, Mass, Measure, MomentOfInertia, Torque};
use stage::with_losses;

/// Returns g_n, the standard acceleration of free fall [m/s²], exact by definition (ISO 80000-3).
#[must_use]
pub fn gravity_m_s2() -> f64 {
    STANDARD_GRAVITY.to_si(1.0)
}

/// Additions of a motion segment to the load.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extra {
    /// Mass carried on the slide, the belt or the slider of the rod.
    pub mass: Mass,
    /// Inertia carried at the output.
    pub inertia: MomentOfInertia,
    /// Process force along the line of a linear drive; a positive value acts against the positive direction.
    pub force: Force,
    /// Process torque at the output; a positive value acts against the positive direction.
    pub torque: Torque,
}

impl Extra {
    /// Returns zero additions.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }
}

/// State of the output in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output {
    /// Position q \[rad\].
    pub position_rad: f64,
    /// Speed ω [rad/s].
    pub speed_rad_s: f64,
    /// Acceleration α [rad/s²].
    pub acceleration_rad_s2: f64,
    /// σ: direction of motion, +1, −1, or 0 at rest; independent of ω because it is also needed at the ends of a move.
    pub direction: f64,
}

/// Defines the mechanisms, one per line: variant, key in the project file, module and example.
macro_rules! mechanisms {
    ($($(#[$about:meta])* $variant:ident $id:literal $module:ident $example:literal;)*) => {
        /// A mechanism by its name in a project file.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum MechanismId {
            $($(#[$about])* $variant,)*
        }

        impl MechanismId {
            /// The mechanisms in the order of the reference.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Returns the key of the table `[mechanism.<key>]`, or of `[load]` for a load at the output.
            #[must_use]
            pub const fn key(self) -> &'static str {
                match self { $(Self::$variant => $id,)* }
            }

            /// Returns a commented project file with the mechanism.
            #[must_use]
            pub const fn example(self) -> &'static str {
                match self { $(Self::$variant => include_str!(concat!("../../../examples/", $example, ".toml")),)* }
            }

            /// Returns the drawing, to the scale of the known values, with a call-out for each key visible in it.
            #[must_use]
            pub fn drawing(self, figures: &MechanismValues) -> Drawing {
                let described = match self { $(Self::$variant => crate::$module::drawing(figures),)* };
                described.finished(figures)
            }
        }
    };
}

mechanisms! {
    /// A load at the output, given by its inertia.
    Load "load" load "indexing-table";
    /// Bodies on a turning plate.
    Turntable "turntable" turntable "turntable";
    /// An unbalanced arm.
    Arm "arm" arm "tilting-arm";
    /// A screw with its slide.
    Screw "screw" screw "screw-axis";
    /// A belt or a rack with a slide.
    Belt "belt" belt "belt-axis";
    /// A conveyor or a roller.
    Conveyor "conveyor" conveyor "conveyor";
    /// Crank, rod and slider.
    SliderCrank "slider_crank" slider_crank "slider-crank";
    /// A joint of a robot with recorded torque.
    Joint "joint" joint "robot-joint";
    /// Inertia and torque as a function of position, point by point.
    Table "table" table "cam-table";
    /// Drum, rope and load.
    Hoist "hoist" hoist "hoist";
    /// A roll with variable diameter.
    Winder "winder" winder "winder";
    /// A platform on crossed arms.
    ScissorLift "scissor_lift" scissor_lift "scissor-lift";
    /// Crank, coupler and rocker.
    FourBar "four_bar" four_bar "four-bar";
}

impl MechanismId {
    /// Returns the mechanism with a key.
    #[must_use]
    pub fn of(key: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|id| id.key() == key)
    }
}

/// Defines the geometry faults, one per line: variant, identifier and the key at which it is reported.
macro_rules! geometry {
    ($($(#[$about:meta])* $fault:ident $id:literal at $key:literal;)*) => {
        /// Fault in the lengths and angles of a mechanism.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Geometry {
            $($(#[$about])* $fault,)*
        }

        impl Geometry {
            /// The faults in the order of the mechanisms.
            pub const ALL: &'static [Self] = &[$(Self::$fault),*];

            /// Returns the identifier of the fault.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$fault => $id,)* }
            }

            /// Returns the key at which the fault is reported.
            #[must_use]
            pub const fn key(self) -> &'static str {
                match self { $(Self::$fault => $key,)* }
            }
        }
    };
}

geometry! {
    /// The rope of a hoist has a mass but no length.
    RopeWithoutLength "rope_without_length" at "rope_mass";
    /// The full roll of a winder is not larger than its core.
    FullBelowCore "full_below_core" at "full_diameter";
    /// The initial roll is smaller than its core.
    StartBelowCore "start_below_core" at "start_diameter";
    /// The initial roll is larger than the full one.
    StartAboveFull "start_above_full" at "start_diameter";
    /// The arms of a lift are flat, or nearly so, at position zero.
    Flat "arms_flat" at "arm_angle";
    /// The arms of a lift are upright, or beyond, at position zero.
    Upright "arms_upright" at "arm_angle";
    /// One link is at least as long as the others together, so that the linkage cannot be assembled.
    NotAssembled "not_assembled" at "coupler";
    /// Coupler and rocker are too short for the crank in its farthest position: r + g ≥ c + l.
    TooShort "crank_blocked_far" at "coupler";
    /// The difference of coupler and rocker is too large for the crank in its nearest position: |g − r| ≤ |c − l|.
    TooUnequal "crank_blocked_near" at "coupler";
}

impl Geometry {
    /// Returns the faults whose condition is `true`, in order.
    pub(crate) fn found<const N: usize>(all: [(bool, Self); N]) -> Vec<Self> {
        all.into_iter().filter_map(|(wrong, fault)| wrong.then_some(fault)).collect()
    }
}

/// Defines the kinds of equations and forwards to them.
macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident;)*) => {
        /// Kind of the equations of a load.
        #[derive(Clone, Debug, PartialEq)]
        pub enum MechanismKind {
            $($(#[$about])* $kind($kind),)*
        }

        impl MechanismKind {
            /// Returns the equations.
            pub(crate) fn equations(&self) -> &dyn Equations {
                match self { $(Self::$kind(it) => it,)* }
            }

            #[inline]
            pub(crate) fn reduced(&self, position_rad: f64, extra: &Extra) -> Reduced {
                match self { $(Self::$kind(it) => it.reduced(position_rad, extra),)* }
            }

            #[inline]
            fn known_inertia(&self, reduced: &Reduced) -> Option<f64> {
                match self { $(Self::$kind(it) => it.known_inertia(reduced),)* }
            }

            #[inline]
            fn holding(&self, reduced: &Reduced, external_nm: f64) -> f64 {
                match self { $(Self::$kind(it) => it.holding(reduced, external_nm),)* }
            }

            fn with_masses(&self, factor: f64) -> Self {
                match self { $(Self::$kind(it) => Self::$kind(it.with_masses(factor)),)* }
            }
        }
    };
}

kinds! {
    /// Load turning with the output: direct load, turntable, unbalanced arm.
    Rotor;
    /// Load moving along a line in proportion to the angle: screw, belt, rack, conveyor.
    Linear;
    /// Crank, rod and slider.
    SliderCrank;
    /// Inertia and torque as a function of position, point by point.
    Table;
    /// A robot joint with recorded torque.
    Joint;
    /// Drum, rope and load.
    Hoist;
    /// A roll with variable diameter.
    Winder;
    /// A platform on crossed arms.
    ScissorLift;
    /// Crank, coupler and rocker.
    FourBar;
}

/// A load with its friction and the efficiency of the transmission.
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanism {
    /// Equations of the load.
    pub kind: MechanismKind,
    /// Friction at the output.
    pub friction: Friction,
    /// η while the actuator drives the load \[1\].
    pub efficiency_driving: f64,
    /// η while the load drives the actuator \[1\].
    pub efficiency_driven: f64,
    /// Stage between the actuator and the mechanism; the other fields refer to its mechanism side.
    pub stage: Option<Stage>,
}

/// Coefficients of a torque J α + T_h + W cos(q + q_0) + T_c σ + b ω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plain {
    /// J: inertia \[kgm²\].
    pub inertia_kgm2: f64,
    /// T_h: torque that is constant over the motion \[Nm\].
    pub constant_nm: f64,
    /// W: gravity torque of an unbalanced rotor at its largest lever \[Nm\]; zero if no torque depends on the position.
    pub weight_nm: f64,
    /// q_0: angle of the centre of mass above the horizontal at q = 0 \[rad\].
    pub angle_rad: f64,
    /// T_c: Coulomb friction \[Nm\].
    pub coulomb_nm: f64,
    /// b: viscous friction [Nm s/rad].
    pub viscous_nms: f64,
}

/// Condition on the position at the end of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Endless {
    /// The load is equal at every position and the travel is unlimited.
    Everywhere,
    /// The load repeats with each revolution.
    EachRevolution,
    /// The travel is limited: the cycle must return to its initial position.
    Never,
}

impl Mechanism {
    /// Creates a load that turns with the output, given by its inertia and its Coulomb friction.
    #[must_use]
    pub fn direct(inertia: MomentOfInertia, friction_torque: Torque) -> Self {
        Self {
            kind: MechanismKind::Rotor(Rotor::balanced(inertia)),
            friction: Friction { coulomb: friction_torque, ..Friction::none() },
            efficiency_driving: 1.0,
            efficiency_driven: 1.0,
            stage: None,
        }
    }

    /// Returns the load with all masses and inertias, those of the stage included, multiplied by a factor; friction,
    /// process and geometry remain.
    #[must_use]
    pub fn with_masses(&self, factor: f64) -> Self {
        let stage = self.stage.map(|stage| Stage {
            inertia_driving: MomentOfInertia::from_si(stage.inertia_driving.si() * factor),
            inertia_driven: MomentOfInertia::from_si(stage.inertia_driven.si() * factor),
            ..stage
        });
        Self { kind: self.kind.with_masses(factor), stage, ..self.clone() }
    }

    /// Returns the mechanism as named in a project file.
    #[must_use]
    pub fn id(&self) -> MechanismId {
        self.kind.equations().id()
    }

    /// Returns the lowest and highest position of the actuator's output that the geometry permits \[rad\].
    #[must_use]
    pub fn range_rad(&self) -> Option<(f64, f64)> {
        let (from, to) = self.kind.equations().range_rad()?;
        let (from, to) = (from * self.stage_ratio(), to * self.stage_ratio());
        Some((from.min(to), from.max(to)))
    }

    /// Returns the angle of the mechanism (its own, with a stage) that sixteen nodes resolve between two positions of
    /// the actuator's output \[rad\]; infinite if the load is a polynomial of the position, `None` if it does not
    /// depend on it.
    #[must_use]
    pub fn smooth_over(&self, from_rad: f64, to_rad: f64) -> Option<f64> {
        let ratio = self.stage_ratio();
        self.kind.equations().smooth_over(from_rad / ratio, to_rad / ratio)
    }

    /// Returns the torque required by the load beyond the transmission, before its losses \[Nm\].
    ///
    /// T_u = J(q) α + ½ J'(q) ω² + T_h(q) + T_g σ
    ///
    /// # Symbols
    /// J' slope of the inertia over the position [kgm²/rad], T_h gravity, process and external torque \[Nm\], T_g
    /// friction of guide and seals of a linear drive, referred to the output \[Nm\]
    /// # Source
    /// docs/theory/mechanisms.md, Lagrange's equation of one degree of freedom; cha-manual eq. 70.3, 70.5
    #[must_use]
    pub fn useful_torque(&self, output: &Output, extra: &Extra) -> f64 {
        self.loading(extra).at(output).useful_nm
    }

    /// Returns T_u, and the torque of ropes over sheaves with losses within it, zero for others \[Nm\].
    pub(crate) fn useful(&self, reduced: &Reduced, output: &Output, extra: &Extra) -> (f64, f64) {
        let own = reduced.inertia * output.acceleration_rad_s2
            + 0.5 * reduced.slope * output.speed_rad_s * output.speed_rad_s
            + reduced.holding
            + reduced.coulomb * output.direction;
        let external = self.friction.external.si();
        let ropes =
            if let MechanismKind::Hoist(hoist) = &self.kind { hoist.ropes_nm(own, output, extra) } else { None };
        match ropes {
            Some([without, with]) => (own + external + (with - without), with),
            None => (own + external, 0.0),
        }
    }

    /// Returns `true` if power is lost in a transmission, so that the torque has a kink where it changes sides.
    #[must_use]
    pub fn has_losses(&self) -> bool {
        self.efficiency_driving != 1.0 || self.efficiency_driven != 1.0 || self.has_lossy_sheaves()
    }

    /// Returns `true` if the ropes of a hoist run over sheaves with losses; then [`LoadTorque::ropes_nm`] changes its sign
    /// where the torque has a kink.
    #[must_use]
    pub const fn has_lossy_sheaves(&self) -> bool {
        matches!(&self.kind, MechanismKind::Hoist(hoist) if hoist.reeving != 1.0)
    }

    /// Returns the torque that the output must apply to the load \[Nm\].
    ///
    /// T = T_u/η_1 if T_u σ > 0, T_u η_2 if T_u σ < 0, plus T_c σ + b ω
    ///
    /// # Symbols
    /// η_1 efficiency while driving, η_2 while driven, T_c Coulomb friction at the output \[Nm\], b viscous friction [Nm s/rad]
    /// # Source
    /// docs/theory/mechanisms.md
    /// # Valid
    /// at rest (σ = 0) without friction and efficiency: the torque that holds without their help
    #[must_use]
    pub fn torque(&self, output: &Output, extra: &Extra) -> f64 {
        self.loading(extra).at(output).torque_nm
    }

    /// Returns the torque required by the mechanism, on its side of the stage \[Nm\].
    pub(crate) fn own_torque(&self, output: &Output, extra: &Extra) -> f64 {
        let reduced = self.kind.reduced(output.position_rad, extra);
        let (useful, _) = self.useful(&reduced, output, extra);
        self.passed(useful, output)
    }

    /// Returns the torque required for a useful torque, with the losses and the friction on the mechanism side of the
    /// stage \[Nm\].
    pub(crate) fn passed(&self, useful: f64, output: &Output) -> f64 {
        let passed = with_losses(useful, output.direction, [self.efficiency_driving, self.efficiency_driven]);
        passed + self.friction.coulomb.si() * output.direction + self.friction.viscous.si() * output.speed_rad_s
    }

    /// Returns J_L at a position of the actuator's output, referred to it.
    #[must_use]
    pub fn inertia(&self, position_rad: f64, extra: &Extra) -> MomentOfInertia {
        let reduced = self.kind.reduced(position_rad / self.stage_ratio(), extra);
        MomentOfInertia::from_si(self.inertia_of(&reduced))
    }

    /// Returns J_L, referred to the actuator's output \[kgm²\].
    pub(crate) fn inertia_of(&self, reduced: &Reduced) -> f64 {
        // An inertia that is not stated stays unknown with a stage too.
        let Some(inertia) = self.kind.known_inertia(reduced) else { return 0.0 };
        self.gearing().map_or(inertia, |stage| stage.inertia(inertia))
    }

    /// Returns the torque that holds the load at rest at a position without the help of friction.
    #[must_use]
    pub fn holding_torque(&self, position_rad: f64, extra: &Extra) -> Torque {
        let reduced = self.kind.reduced(position_rad / self.stage_ratio(), extra);
        Torque::from_si(self.holding_of(&reduced))
    }

    /// Returns the torque that holds the load, at the actuator's output \[Nm\].
    pub(crate) fn holding_of(&self, reduced: &Reduced) -> f64 {
        self.before_stage(self.kind.holding(reduced, self.friction.external.si()))
    }

    /// Returns `true` if torque or inertia depend on the position.
    #[must_use]
    pub fn depends_on_position(&self) -> bool {
        self.kind.equations().smooth_over(0.0, 0.0).is_some()
    }

    /// Returns the time of one evaluation of the equations, relative to that of a load turning with the output \[1\].
    #[must_use]
    pub const fn evaluation_cost(&self) -> f64 {
        match &self.kind {
            MechanismKind::FourBar(_) => 2.0,
            MechanismKind::SliderCrank(_) | MechanismKind::ScissorLift(_) => 1.5,
            MechanismKind::Table(_)
            | MechanismKind::Hoist(_)
            | MechanismKind::Winder(_)
            | MechanismKind::Linear(_)
            | MechanismKind::Rotor(_)
            | MechanismKind::Joint(_) => 1.0,
        }
    }

    /// Returns `true` if the torque is constant over a ramp of constant acceleration: no viscous friction, no
    /// dependence on the position.
    #[must_use]
    pub fn is_constant_over_ramps(&self) -> bool {
        !self.depends_on_position() && self.friction.viscous.si() == 0.0
    }

    /// Returns `true` if the torque that holds the load at rest is known.
    #[must_use]
    pub const fn knows_holding_torque(&self) -> bool {
        !matches!(&self.kind, MechanismKind::Joint(Joint { holding_torque: None, .. }))
    }

    /// Returns the torque as a sum of five terms with constant coefficients, if the mechanism has this form.
    ///
    /// T = J α + T_h + W cos(q + q_0) + T_c σ + b ω
    ///
    /// # Valid
    /// constant inertia, no losses and no stage, so that nothing switches with the sign of a torque and recorded torque
    /// is added unchanged
    #[must_use]
    pub fn plain(&self, extra: &Extra) -> Option<Plain> {
        if self.has_losses() || self.gearing().is_some() {
            return None;
        }
        let (reduced, weight_nm, angle_rad) = match &self.kind {
            MechanismKind::Rotor(rotor) => rotor.laden(extra).apart(),
            kind if kind.equations().smooth_over(0.0, 0.0).is_some() => return None,
            kind => (kind.reduced(0.0, extra), 0.0, 0.0),
        };
        Some(Plain {
            inertia_kgm2: reduced.inertia,
            constant_nm: reduced.holding + self.friction.external.si(),
            weight_nm,
            angle_rad,
            coulomb_nm: reduced.coulomb + self.friction.coulomb.si(),
            viscous_nms: self.friction.viscous.si(),
        })
    }

    /// Returns the condition on the position at the end of the cycle.
    #[must_use]
    pub fn endless(&self) -> Endless {
        self.kind.equations().endless()
    }

    /// Returns the travel along the line per angle of the actuator's output [m/rad], if it is constant.
    #[must_use]
    pub fn travel_m_per_rad(&self) -> Option<f64> {
        Some(self.kind.equations().travel_m_per_rad()? / self.stage_ratio())
    }

    /// Returns the positions of the mechanism (its own, with a stage) within 0…2π, or within the table, at which the
    /// reduced quantities have a kink.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        self.kind.equations().kinks()
    }
}

#[cfg(test)]
#[path = "mechanism_tests.rs"]
mod tests;
