//! From what is moved to torque and inertia at the output of the actuator.
//!
//! A [`Mechanism`] answers for any state of the output (position, speed, acceleration) which torque the actuator must
//! give to the load, split into the part that does useful work and friction. The kinds differ only in how inertia and
//! position-dependent torque arise: a [`Rotor`] turns with the output, a [`Linear`] drive moves a mass along a line, a
//! [`SliderCrank`] does so with a changing lever, a [`Table`] is given point by point, the torque of a [`Joint`] is recorded.
//! Between actuator and mechanism there may be a [`Stage`]; states and torques are those at the actuator's output all the same.

mod arm;
mod belt;
mod body;
mod conveyor;
pub mod drawing;
mod equations;
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

pub use body::{Body, BodyError, BodyFault, BodyInertia, Inertia, Orientation, Shape, inertia};
pub use equations::Effects;
pub use flange::{Aligned, Contact, FlangeForces, Mounting, Recurrence};
pub use four_bar::FourBar;
pub use friction::Friction;
pub use hoist::{Hoist, reeving_efficiency};
pub use joint::Joint;
pub use linear::{Linear, LinearKind};
pub use loading::{Load, Loading};
pub use rope::Rope;
pub use rotor::{Rotor, RotorKind};
pub use scissor_lift::ScissorLift;
pub use slider_crank::SliderCrank;
pub use stage::{Stage, StageKind};
pub use table::{Table, TableFault, TablePoint};
pub use winder::{Winder, Winding};

use drawing::{Drawing, Figures};
use equations::{Equations, Reduced};
use quantities::unit::STANDARD_GRAVITY;
use quantities::{Force, Mass, Measure, MomentOfInertia, Torque};
use stage::with_losses;

/// g_n: standard acceleration of free fall [m/s²], exact by definition (ISO 80000-3).
#[must_use]
pub fn gravity_m_s2() -> f64 {
    STANDARD_GRAVITY.to_si(1.0)
}

/// What a segment of the motion adds to the load.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Extra {
    /// Mass carried along: on the slide, the belt or the rod's slider.
    pub mass: Mass,
    /// Inertia carried along at the output.
    pub inertia: MomentOfInertia,
    /// Process force along the line of a linear drive, counted against the positive direction.
    pub force: Force,
    /// Process torque at the output, counted against the positive direction.
    pub torque: Torque,
}

impl Extra {
    /// Nothing added.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }
}

/// Where the output stands, in SI: q \[rad\], ω [rad/s], α [rad/s²].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Output {
    /// q \[rad\]
    pub position_rad: f64,
    /// ω [rad/s]
    pub speed_rad_s: f64,
    /// α [rad/s²]
    pub acceleration_rad_s2: f64,
    /// σ: direction of motion, +1, −1, or 0 at rest; kept apart from ω because it is also asked at the ends of a move.
    pub direction: f64,
}

/// One line per mechanism: its variant, its key in the project file, its module, its example.
macro_rules! mechanisms {
    ($($(#[$about:meta])* $variant:ident $id:literal $module:ident $example:literal;)*) => {
        /// A mechanism as a project file names it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub enum MechanismId {
            $($(#[$about])* $variant,)*
        }

        impl MechanismId {
            /// All of them, in the order of the reference.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            /// Its key: the table `[mechanism.<key>]`, and `[load]` for a load at the output.
            #[must_use]
            pub const fn key(self) -> &'static str {
                match self { $(Self::$variant => $id,)* }
            }

            /// A project file with it, commented.
            #[must_use]
            pub const fn example(self) -> &'static str {
                match self { $(Self::$variant => include_str!(concat!("../../../examples/", $example, ".toml")),)* }
            }

            /// Its drawing, to the scale of what is known, with a call-out for each key that can be seen in it.
            #[must_use]
            pub fn drawing(self, figures: &Figures) -> Drawing {
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
    /// Inertia and torque over the position, point by point.
    Table "table" table "cam-table";
    /// Drum, rope and load.
    Hoist "hoist" hoist "hoist";
    /// A roll that grows or shrinks.
    Winder "winder" winder "winder";
    /// A platform on crossed arms.
    ScissorLift "scissor_lift" scissor_lift "scissor-lift";
    /// Crank, coupler and rocker.
    FourBar "four_bar" four_bar "four-bar";
}

impl MechanismId {
    /// The mechanism of a key.
    #[must_use]
    pub fn of(key: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|id| id.key() == key)
    }
}

/// One line per fault: its variant, its identifier, the key that it is reported at.
macro_rules! geometry {
    ($($(#[$about:meta])* $fault:ident $id:literal at $key:literal;)*) => {
        /// Why stated lengths and angles make no mechanism.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Geometry {
            $($(#[$about])* $fault,)*
        }

        impl Geometry {
            /// All of them.
            pub const ALL: &'static [Self] = &[$(Self::$fault),*];

            /// Its identifier.
            #[must_use]
            pub const fn id(self) -> &'static str {
                match self { $(Self::$fault => $id,)* }
            }

            /// The key that it is reported at.
            #[must_use]
            pub const fn key(self) -> &'static str {
                match self { $(Self::$fault => $key,)* }
            }
        }
    };
}

geometry! {
    /// The rope of a hoist has a mass and no length.
    RopeWithoutLength "rope_without_length" at "rope_mass";
    /// The full roll of a winder is not wider than its core.
    FullBelowCore "full_below_core" at "full_diameter";
    /// The roll begins thinner than its core.
    StartBelowCore "start_below_core" at "start_diameter";
    /// The roll begins thicker than full.
    StartAboveFull "start_above_full" at "start_diameter";
    /// The arms of a lift lie flat, or nearly, at position zero.
    Flat "arms_flat" at "arm_angle";
    /// The arms of a lift stand upright, or beyond, at position zero.
    Upright "arms_upright" at "arm_angle";
    /// One link is as long as the others together, or longer: the linkage cannot be assembled.
    NotAssembled "not_assembled" at "coupler";
    /// Coupler and rocker are too short for the crank at its farthest: r + g ≥ c + l.
    TooShort "crank_blocked_far" at "coupler";
    /// Coupler and rocker differ by more than the crank leaves at its nearest: |g − r| ≤ |c − l|.
    TooUnequal "crank_blocked_near" at "coupler";
}

impl Geometry {
    /// Those that hold, in their order.
    pub(crate) fn found<const N: usize>(all: [(bool, Self); N]) -> Vec<Self> {
        all.into_iter().filter_map(|(wrong, fault)| wrong.then_some(fault)).collect()
    }
}

/// The kinds of equations, each with its answers.
macro_rules! kinds {
    ($($(#[$about:meta])* $kind:ident;)*) => {
        /// How the load hangs on the output.
        #[derive(Clone, Debug, PartialEq)]
        pub enum MechanismKind {
            $($(#[$about])* $kind($kind),)*
        }

        impl MechanismKind {
            /// Its answers.
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
    /// Turns with the output: direct load, turntable, unbalanced arm.
    Rotor;
    /// Moves along a line in proportion to the angle: screw, belt, rack, conveyor.
    Linear;
    /// Crank, rod and slider.
    SliderCrank;
    /// Inertia and torque over the position, point by point.
    Table;
    /// A joint of a robot: its torque is recorded with the motion.
    Joint;
    /// Drum, rope and load.
    Hoist;
    /// A roll that grows or shrinks.
    Winder;
    /// A platform on crossed arms.
    ScissorLift;
    /// Crank, coupler and rocker.
    FourBar;
}

/// A load with its friction and the efficiency of what lies between.
#[derive(Clone, Debug, PartialEq)]
pub struct Mechanism {
    /// How the load hangs on the output.
    pub kind: MechanismKind,
    /// Friction at the output.
    pub friction: Friction,
    /// η while the actuator drives the load.
    pub efficiency_driving: f64,
    /// η while the load drives the actuator.
    pub efficiency_driven: f64,
    /// What lies between the actuator and the mechanism; all of the above is on its far side.
    pub stage: Option<Stage>,
}

/// The factors of a torque J α + T_h + W cos(q + q_0) + T_c σ + b ω.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plain {
    /// J \[kgm²\]
    pub inertia_kgm2: f64,
    /// T_h: what does not change over the motion \[Nm\].
    pub constant_nm: f64,
    /// W: the weight of an unbalanced rotor at its largest lever \[Nm\]; zero where no torque depends on the position.
    pub weight_nm: f64,
    /// q_0: angle of the centre of mass above the horizontal at q = 0 \[rad\].
    pub angle_rad: f64,
    /// T_c: Coulomb friction \[Nm\].
    pub coulomb_nm: f64,
    /// b: viscous friction [Nm s/rad].
    pub viscous_nms: f64,
}

/// What must agree between the end of a cycle and its beginning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Endless {
    /// The load is the same at every position and the travel has no end.
    Everywhere,
    /// The load repeats with each revolution.
    EachRevolution,
    /// The travel is bounded: the cycle must come back.
    Never,
}

impl Mechanism {
    /// A load that turns with the output, given by its inertia and its Coulomb friction.
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

    /// The same load with all its masses and inertias times a factor; friction, process and geometry stay.
    #[must_use]
    pub fn with_masses(&self, factor: f64) -> Self {
        Self { kind: self.kind.with_masses(factor), ..self.clone() }
    }

    /// Which mechanism it is.
    #[must_use]
    pub fn id(&self) -> MechanismId {
        self.kind.equations().id()
    }

    /// What a segment of the motion can add to it.
    #[must_use]
    pub fn effects(&self) -> Effects {
        self.kind.equations().effects()
    }

    /// Lowest and highest position of the actuator's output that the geometry allows \[rad\].
    #[must_use]
    pub fn range_rad(&self) -> Option<(f64, f64)> {
        let (from, to) = self.kind.equations().range_rad()?;
        let (from, to) = (from * self.stage_ratio(), to * self.stage_ratio());
        Some((from.min(to), from.max(to)))
    }

    /// The angle of the mechanism, behind a stage, that sixteen nodes cover between two positions of the actuator's output
    /// \[rad\]; infinite where the load is a polynomial of the position, `None` where it does not depend on it.
    #[must_use]
    pub fn smooth_over(&self, from_rad: f64, to_rad: f64) -> Option<f64> {
        let ratio = self.stage_ratio();
        self.kind.equations().smooth_over(from_rad / ratio, to_rad / ratio)
    }

    /// Torque that the load takes on the far side of the transmission, before its losses \[Nm\].
    ///
    /// T_u = J(q) α + ½ J'(q) ω² + T_h(q) + T_g σ
    ///
    /// # Symbols
    /// J' slope of the inertia over the position [kgm²/rad], T_h gravity, process and external torque \[Nm\],
    /// T_g friction of guide and seals of a linear drive, referred to the output \[Nm\]
    /// # Source
    /// docs/theory/mechanisms.md, Lagrange's equation of one degree of freedom; cha-manual eq. 70.3, 70.5
    #[must_use]
    pub fn useful_torque(&self, output: &Output, extra: &Extra) -> f64 {
        self.loading(extra).at(output).useful_nm
    }

    pub(crate) fn useful(&self, reduced: &Reduced, output: &Output) -> f64 {
        reduced.inertia * output.acceleration_rad_s2
            + 0.5 * reduced.slope * output.speed_rad_s * output.speed_rad_s
            + reduced.holding
            + self.friction.external.si()
            + reduced.coulomb * output.direction
    }

    /// Torque that the output must give to the load \[Nm\].
    ///
    /// T = T_u/η_1 if T_u σ > 0, T_u η_2 if T_u σ < 0, plus T_c σ + b ω
    ///
    /// # Symbols
    /// η_1 efficiency while driving, η_2 while driven, T_c Coulomb friction at the output \[Nm\], b viscous friction [Nm s/rad]
    /// # Source
    /// docs/theory/mechanisms.md
    /// # Valid
    /// at rest (σ = 0) neither friction nor efficiency counts: the torque that holds without their help
    #[must_use]
    pub fn torque(&self, output: &Output, extra: &Extra) -> f64 {
        self.loading(extra).at(output).torque_nm
    }

    /// The torque that the mechanism takes, behind the stage \[Nm\].
    pub(crate) fn own_torque(&self, output: &Output, extra: &Extra) -> f64 {
        let reduced = self.kind.reduced(output.position_rad, extra);
        self.passed(self.useful(&reduced, output), output)
    }

    /// What the mechanism takes for a useful torque, with its losses and the friction at its side of the stage \[Nm\].
    pub(crate) fn passed(&self, useful: f64, output: &Output) -> f64 {
        let passed = with_losses(useful, output.direction, [self.efficiency_driving, self.efficiency_driven]);
        passed + self.friction.coulomb.si() * output.direction + self.friction.viscous.si() * output.speed_rad_s
    }

    /// J_L at a position of the actuator's output, referred to it.
    #[must_use]
    pub fn inertia(&self, position_rad: f64, extra: &Extra) -> MomentOfInertia {
        let reduced = self.kind.reduced(position_rad / self.stage_ratio(), extra);
        MomentOfInertia::from_si(self.inertia_of(&reduced))
    }

    /// J_L \[kgm²\]
    pub(crate) fn inertia_of(&self, reduced: &Reduced) -> f64 {
        // What is not stated does not become known by a stage.
        let Some(inertia) = self.kind.known_inertia(reduced) else { return 0.0 };
        self.gearing().map_or(inertia, |stage| stage.inertia(inertia))
    }

    /// Torque that holds the load at rest at a position without the help of friction.
    #[must_use]
    pub fn holding_torque(&self, position_rad: f64, extra: &Extra) -> Torque {
        let reduced = self.kind.reduced(position_rad / self.stage_ratio(), extra);
        Torque::from_si(self.holding_of(&reduced))
    }

    /// Torque that holds the load \[Nm\].
    pub(crate) fn holding_of(&self, reduced: &Reduced) -> f64 {
        self.before_stage(self.kind.holding(reduced, self.friction.external.si()))
    }

    /// Whether torque or inertia depend on the position.
    #[must_use]
    pub fn depends_on_position(&self) -> bool {
        self.kind.equations().smooth_over(0.0, 0.0).is_some()
    }

    /// Time of one evaluation of its equations by that of a load that turns with the output.
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

    /// Whether the torque over a ramp of constant acceleration is constant: no viscous friction, no dependence on the
    /// position.
    #[must_use]
    pub fn is_constant_over_ramps(&self) -> bool {
        !self.depends_on_position() && self.friction.viscous.si() == 0.0
    }

    /// Whether the torque that holds the load at rest is known.
    #[must_use]
    pub const fn knows_holding_torque(&self) -> bool {
        !matches!(&self.kind, MechanismKind::Joint(Joint { holding_torque: None, .. }))
    }

    /// The torque as a sum of five parts with constant factors, where the mechanism is one.
    ///
    /// T = J α + T_h + W cos(q + q_0) + T_c σ + b ω
    ///
    /// # Valid
    /// constant inertia, no efficiency and no stage, so that nothing switches with the sign of a torque and
    /// recorded torque counts as it is
    #[must_use]
    pub fn plain(&self, extra: &Extra) -> Option<Plain> {
        let losses = self.efficiency_driving != 1.0 || self.efficiency_driven != 1.0;
        if losses || self.gearing().is_some() {
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

    /// What the cycle must come back to.
    #[must_use]
    pub fn endless(&self) -> Endless {
        self.kind.equations().endless()
    }

    /// Travel along the line per angle of the actuator's output [m/rad], where it is constant.
    #[must_use]
    pub fn travel_m_per_rad(&self) -> Option<f64> {
        Some(self.kind.equations().travel_m_per_rad()? / self.stage_ratio())
    }

    /// Positions of the mechanism, behind a stage, within 0…2π (or the table's span) at which the reduced quantities have a kink.
    #[must_use]
    pub fn kinks(&self) -> Vec<f64> {
        self.kind.equations().kinks()
    }
}

#[cfg(test)]
#[path = "mechanism_tests.rs"]
mod tests;
