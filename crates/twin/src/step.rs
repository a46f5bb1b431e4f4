//! Solver: fourth-order Taylor series between kinks.
//!
//! Between two kinks every law of the plant is smooth: the gear stays in one region of its torsion curve, each
//! hysteresis element sticks or slips, and friction has one direction. The terms of the series then follow from each
//! other, and one evaluation of the laws makes a step. A step that would pass a kink ends at it. The energies are
//! trapezoidal sums over the nodes with Euler-Maclaurin corrections at both ends of a piece, of fourth order too.

mod series;

use crate::gear::Anchor;
use crate::plant::{Given, Plant, Sliding, State, Variables};
use numeric::root;
use series::{Pace, Series, sum};

/// Largest number of kinks located within one step; further ones are passed without being located.
const KINKS_MOST: u32 = 24;

/// Tolerances beyond which a piece has ended: twist \[rad\], twist rate [rad/s], torque \[Nm\]. Above the rounding
/// error, below any significance.
const BEYOND_RAD: f64 = 1e-12;
const BEYOND_RAD_S: f64 = 1e-11;
const BEYOND_NM: f64 = 1e-7;

/// Integrands of the energy balance: i_d, i_q, i², i_q Ω, Ω², Ω|T|, φ'², T ω.
type Powers = [f64; 8];

/// Constants between two kinks.
#[derive(Clone, Copy)]
struct Piece {
    /// u/L, R/L, ψ/L; zero without pulses.
    voltage: [f64; 2],
    decay: f64,
    flux: f64,
    /// p i
    electrical: f64,
    /// k, b, 1 and the dry friction over J_M, zero while the motor sticks; friction of the teeth per torque.
    constant: f64,
    viscous: f64,
    over_rotor: f64,
    dry: f64,
    mesh: f64,
    /// Sign of Ω T while sliding.
    rubbing: f64,
    /// 1/J_L, zero while the load sticks, and the dry friction of the load \[Nm\].
    over_load: f64,
    load_dry_nm: f64,
    /// Motor angle, twist and torque without damping at the start of the piece, and the stiffness from there on.
    theta: f64,
    phi: f64,
    static_nm: f64,
    stiffness: f64,
    damping_nms: f64,
    /// Range of twist in which the piece is valid.
    between: [f64; 2],
    directions: Directions,
    /// The load touches the stop.
    touches: bool,
}

/// Directions that must not reverse within a piece; zero where a reversal changes no law.
#[derive(Clone, Copy)]
struct Directions {
    /// Twist of the gear while a hysteresis element slips.
    twist: f64,
    /// Torque through the gear while the teeth rub.
    torque: f64,
    /// Motor and load while they slide with dry friction.
    motor: f64,
    load: f64,
}

/// A state with derived quantities.
#[derive(Clone, Copy)]
struct Node {
    x: Variables,
    phi: f64,
    /// φ' and T.
    rate: f64,
    gear: f64,
    /// e' and its next two derivatives.
    error: [f64; 3],
}

/// Cause of the end of a piece.
#[derive(Clone, Copy)]
enum Kink {
    Corner,
    Reversal,
    Pull,
    Motor,
    Load,
    Contact,
}

impl Kink {
    const ALL: [Self; 6] = [Self::Corner, Self::Reversal, Self::Pull, Self::Motor, Self::Load, Self::Contact];
}

/// Quantities that locate a kink.
#[derive(Clone, Copy)]
struct Place {
    phi: f64,
    /// φ' and T.
    rate: f64,
    gear: f64,
    motor_rad_s: f64,
    load_rad: f64,
    load_rad_s: f64,
}

impl Piece {
    /// Returns `true` if the piece is still valid at a node.
    #[inline(always)]
    fn holds(&self, node: &Node, given: &Given<'_>) -> bool {
        let [low, high] = self.between;
        let directions = &self.directions;
        (node.phi >= low)
            & (node.phi <= high)
            & (node.rate * directions.twist >= -BEYOND_RAD_S)
            & (node.gear * directions.torque >= -BEYOND_NM)
            & (node.x.motor_rad_s * directions.motor >= 0.0)
            & (node.x.load_rad_s * directions.load >= 0.0)
            && (given.stop.is_none() || self.distance(Kink::Contact, &node.place(), given) >= 0.0)
    }

    /// Returns the distance from a kink in its own measure; negative beyond it.
    fn distance(&self, kink: Kink, place: &Place, given: &Given<'_>) -> f64 {
        let [low, high] = self.between;
        let directions = &self.directions;
        match kink {
            Kink::Corner => (place.phi - low).min(high - place.phi),
            Kink::Reversal => place.rate * directions.twist + BEYOND_RAD_S,
            Kink::Pull => place.gear * directions.torque + BEYOND_NM,
            Kink::Motor => place.motor_rad_s * directions.motor,
            Kink::Load => place.load_rad_s * directions.load,
            Kink::Contact => {
                given.stop.map_or(0.0, |stop| {
                    let pressed = stop.pressed(place.load_rad, place.load_rad_s);
                    if self.touches { pressed } else { -pressed }
                }) + BEYOND_NM
            }
        }
    }

    /// Returns the first kink within a step, with the share of the step up to it.
    fn first(&self, series: &Series, (start, end): (&Node, &Node), given: &Given<'_>, h: f64) -> (f64, Kink) {
        let at = |kink, x: f64| {
            let [one, two, three, four] = series.phi;
            let slope = one + x * (2.0 * two + x * (3.0 * three + x * 4.0 * four));
            let place = Place {
                phi: start.phi + sum(&series.phi, x),
                rate: start.rate + (slope - one) / h,
                gear: start.gear + sum(&series.gear, x),
                motor_rad_s: start.x.motor_rad_s + sum(&series.x.motor_rad_s, x),
                load_rad: start.x.load_rad + sum(&series.x.load_rad, x),
                load_rad_s: start.x.load_rad_s + sum(&series.x.load_rad_s, x),
            };
            self.distance(kink, &place, given)
        };
        let of = |kink, node: &Node| self.distance(kink, &node.place(), given);
        let mut first = (1.0, Kink::Corner);
        for kink in Kink::ALL {
            let (before, after) = (of(kink, start), of(kink, end));
            if after >= 0.0 {
                continue;
            }
            let place = if before <= 0.0 { 0.0 } else { root(|x| at(kink, x), (0.0, before), (1.0, after), 1e-13) };
            if place <= first.0 {
                first = (place, kink);
            }
        }
        first
    }
}

impl Node {
    #[inline(always)]
    fn powers(&self) -> Powers {
        let Variables { current_d: i_d, current_q: i_q, motor_rad_s: omega, load_rad_s: speed, .. } = self.x;
        [
            i_d,
            i_q,
            i_d * i_d + i_q * i_q,
            i_q * omega,
            omega * omega,
            (omega * self.gear).abs(),
            self.rate * self.rate,
            self.gear * speed,
        ]
    }

    fn place(&self) -> Place {
        let Variables { motor_rad_s, load_rad, load_rad_s, .. } = self.x;
        Place { phi: self.phi, rate: self.rate, gear: self.gear, motor_rad_s, load_rad, load_rad_s }
    }
}

#[inline(always)]
fn add(worked: &mut Powers, weight: f64, powers: &Powers) {
    for (sum, power) in worked.iter_mut().zip(powers) {
        *sum += weight * power;
    }
}

impl Plant {
    /// Advances several steps of equal duration \[s\] under one voltage and one load.
    pub(crate) fn steps(&self, state: &mut State, given: &Given<'_>, count: u32, h: f64) {
        let (mut worked, mut inner) = (Powers::default(), Powers::default());
        let (mut piece, mut node) = self.piece(state, given);
        let mut pace = Pace::of(&piece, h);
        self.edge(&mut worked, &piece, &node, given, h);
        for _ in 0..count {
            let series = Series::of(&piece, &pace, &node, given);
            let end = self.node(&piece, given.anchor, series.end(&node.x));
            if piece.holds(&end, given) && !self.releases(state, &end, given) {
                node = end;
                add(&mut inner, 1.0, &node.powers());
            } else {
                self.edge(&mut worked, &piece, &node, given, -h);
                (piece, node) = self.over_kinks(&mut worked, state, (piece, node), given, h);
                pace = Pace::of(&piece, h);
                self.edge(&mut worked, &piece, &node, given, h);
            }
        }
        add(&mut worked, h, &inner);
        let acceleration = self.edge(&mut worked, &piece, &node, given, -h);
        self.close(state, &piece, &node);
        (state.gear_nm, state.acceleration_rad_s2) = (node.gear, acceleration);
        let [charge_d, charge_q, square, turned, fast, rubbed, sheared, given_on] = worked;
        let [u_d, u_q] = given.voltage;
        let terminal = 1.5 * (u_d * charge_d + u_q * charge_q);
        let energies = &mut state.energies;
        energies.terminal_j += terminal;
        energies.regenerated_j += (-terminal).max(0.0);
        energies.copper_j += 1.5 * self.resistance_ohm * square;
        energies.friction_j += self.viscous_nms * fast;
        energies.mesh_j += self.mesh * rubbed;
        energies.damping_j += self.damping_nms * sheared;
        energies.flange_j += given_on;
        energies.constants_j += (1.5 * self.flux_vs * self.electrical - self.torque_constant) * turned;
    }

    /// Advances a step with changing laws, piece by piece.
    #[cold]
    #[inline(never)]
    fn over_kinks(
        &self,
        worked: &mut Powers,
        state: &mut State,
        (mut piece, mut node): (Piece, Node),
        given: &Given<'_>,
        h: f64,
    ) -> (Piece, Node) {
        let mut left = h;
        for passed in 0..=KINKS_MOST {
            let series = Series::of(&piece, &Pace::of(&piece, left), &node, given);
            let end = self.node(&piece, given.anchor, series.end(&node.x));
            if piece.holds(&end, given) || passed == KINKS_MOST {
                self.stretch(worked, &piece, (&node, &end), given, left);
                node = end;
                if self.releases(state, &end, given) {
                    self.close(state, &piece, &node);
                    (piece, node) = self.piece(state, given);
                }
                break;
            }
            let (part, kink) = piece.first(&series, (&node, &end), given, left);
            let there = self.node(&piece, given.anchor, series.after(&node.x, part));
            self.stretch(worked, &piece, (&node, &there), given, part * left);
            left *= 1.0 - part;
            self.close(state, &piece, &there);
            self.pass(state, kink, &piece);
            (piece, node) = self.piece(state, given);
            if left <= 0.0 {
                break;
            }
        }
        (piece, node)
    }

    /// Adds the integrals between two nodes of one piece.
    fn stretch(&self, worked: &mut Powers, piece: &Piece, (from, to): (&Node, &Node), given: &Given<'_>, h: f64) {
        self.edge(worked, piece, from, given, h);
        add(worked, h, &to.powers());
        self.edge(worked, piece, to, given, -h);
    }

    /// Applies the change of state at a kink.
    fn pass(&self, state: &mut State, kink: Kink, piece: &Piece) {
        match kink {
            Kink::Corner | Kink::Contact => {}
            Kink::Reversal => state.turning = -piece.directions.twist,
            Kink::Pull => state.pull = -piece.directions.torque,
            Kink::Motor => {
                let omega = std::mem::take(&mut state.x.motor_rad_s);
                state.energies.friction_j += 0.5 * self.inertia_kgm2 * omega * omega;
                state.sliding.motor = 0.0;
            }
            Kink::Load => {
                state.x.load_rad_s = 0.0;
                state.sliding.load = 0.0;
            }
        }
    }

    /// Applies the results of a piece to the state.
    #[inline]
    fn close(&self, state: &mut State, piece: &Piece, node: &Node) {
        let slid = node.x.motor_rad - piece.theta;
        state.x = node.x;
        state.energies.hysteresis_j += self.hysteresis.advance(&mut state.force, node.phi - piece.phi);
        state.energies.friction_j += self.friction_nm * state.sliding.motor * slid;
        if self.brake_nm > 0.0 {
            state.energies.brake_j += self.brake_nm * state.sliding.motor * slid;
            state.slipped_rad += slid.abs();
        }
        state.twist_rad = node.phi;
    }

    /// Returns the piece that starts at a state.
    #[inline]
    fn piece(&self, state: &mut State, given: &Given<'_>) -> (Piece, Node) {
        let Variables { current_q: i_q, motor_rad: theta, motor_rad_s: omega, load_rad: q, load_rad_s: speed, .. } =
            state.x;
        let (error, slope, ..) = given.anchor.at(theta);
        let phi = theta - q - error;
        let rate = omega * (1.0 - slope) - speed;
        if rate.abs() > 2.0 * BEYOND_RAD_S {
            state.turning = rate.signum();
        }
        let (torque, mut stiffness, [mut low, mut high]) = self.spring.part(phi);
        let mut slips = false;
        let hysteresis = &self.hysteresis;
        let elements =
            state.force.iter().zip(&hysteresis.stiffness).zip(&hysteresis.slip_nm).zip(&hysteresis.compliance);
        let mut static_nm = torque;
        for (((force, k), most), compliance) in elements {
            static_nm += force;
            if force * state.turning >= *most {
                slips |= *k > 0.0;
            } else {
                stiffness += k;
                low = low.max(phi - (most + force) * compliance);
                high = high.min(phi + (most - force) * compliance);
            }
        }
        let gear = static_nm + self.damping_nms * rate;
        if gear.abs() > 2.0 * BEYOND_NM {
            state.pull = gear.signum();
        }
        self.let_go(state, i_q, gear, slope, given);
        let Sliding { motor: sliding, load: load_sliding } = state.sliding;
        let rubs = self.friction_nm + self.brake_nm > 0.0 || self.mesh > 0.0;
        let over_rotor = if sliding == 0.0 { 0.0 } else { 1.0 / self.inertia_kgm2 };
        let over_inductance = if state.pulses { 1.0 / self.inductance_h } else { 0.0 };
        let [u_d, u_q] = given.voltage;
        let piece = Piece {
            voltage: [u_d * over_inductance, u_q * over_inductance],
            decay: self.resistance_ohm * over_inductance,
            flux: self.electrical * self.flux_vs * over_inductance,
            electrical: if state.pulses { self.electrical } else { 0.0 },
            constant: self.torque_constant * over_rotor,
            viscous: self.viscous_nms * over_rotor,
            over_rotor,
            dry: sliding * (self.friction_nm + self.brake_nm) * over_rotor,
            mesh: sliding * self.mesh * state.pull,
            rubbing: sliding * state.pull,
            over_load: if load_sliding == 0.0 { 0.0 } else { 1.0 / given.load.inertia_kgm2 },
            load_dry_nm: load_sliding * given.load.coulomb_nm,
            theta,
            phi,
            static_nm,
            stiffness,
            damping_nms: self.damping_nms,
            between: [low - BEYOND_RAD, high + BEYOND_RAD],
            directions: Directions {
                twist: if slips { state.turning } else { 0.0 },
                torque: if self.mesh > 0.0 && sliding != 0.0 { state.pull } else { 0.0 },
                motor: if rubs { sliding } else { 0.0 },
                load: if given.load.coulomb_nm > 0.0 { load_sliding } else { 0.0 },
            },
            touches: given.stop.is_some_and(|stop| stop.pressed(q, speed) > 0.0),
        };
        let node = self.node(&piece, given.anchor, state.x);
        (piece, node)
    }

    /// Returns the quantities derived from a state.
    #[inline(always)]
    fn node(&self, piece: &Piece, anchor: &Anchor, x: Variables) -> Node {
        let Variables { motor_rad: theta, motor_rad_s: omega, load_rad: q, load_rad_s: speed, .. } = x;
        let (error, slope, bend, twist) = anchor.at(theta);
        let phi = theta - q - error;
        let rate = omega * (1.0 - slope) - speed;
        let gear = (piece.static_nm + piece.stiffness * (phi - piece.phi)) + piece.damping_nms * rate;
        Node { x, phi, rate, gear, error: [slope, bend, twist] }
    }

    /// Adds the contribution of an end of a piece to the integrals, h/2 f + h²/12 f', with −h for the other end;
    /// returns ω'.
    #[inline]
    fn edge(&self, worked: &mut Powers, piece: &Piece, node: &Node, given: &Given<'_>, h: f64) -> f64 {
        let Variables { current_d: i_d, current_q: i_q, motor_rad_s: omega, load_rad_s: speed, .. } = node.x;
        // The first terms over a step of one second are the slopes.
        let Series { x, phi, gear } = Series::of(piece, &Pace::of(piece, 1.0), node, given);
        let ([di_d, ..], [di_q, ..]) = (x.current_d, x.current_q);
        let ([rotor, ..], [load, ..]) = (x.motor_rad_s, x.load_rad_s);
        let ([_, rate, ..], [gear, ..]) = (phi, gear);
        let slopes = [
            di_d,
            di_q,
            2.0 * (i_d * di_d + i_q * di_q),
            di_q * omega + i_q * rotor,
            2.0 * omega * rotor,
            piece.rubbing * (rotor * node.gear + omega * gear),
            4.0 * node.rate * rate,
            gear * speed + node.gear * load,
        ];
        add(worked, 0.5 * h, &node.powers());
        add(worked, h.abs() * h / 12.0, &slopes);
        load
    }

    /// Returns `true` if the torque exceeds the breakaway torque and a sticking contact starts to slip.
    #[inline(always)]
    fn releases(&self, state: &State, node: &Node, given: &Given<'_>) -> bool {
        let Sliding { motor, load } = state.sliding;
        (motor == 0.0 && self.released(node.x.current_q, node.gear, node.error[0]) != 0.0)
            || (load == 0.0 && Self::load_released(node.gear, node.x.load_rad, given) != 0.0)
    }

    /// Starts the sliding of sticking contacts, from the torques at the start of a piece.
    fn let_go(&self, state: &mut State, i_q: f64, gear: f64, slope: f64, given: &Given<'_>) {
        if state.sliding.motor == 0.0 {
            state.sliding.motor = self.released(i_q, gear, slope);
        }
        if state.sliding.load == 0.0 {
            state.sliding.load = Self::load_released(gear, state.x.load_rad, given);
        }
    }

    /// Returns the direction in which a motor at rest is driven beyond its breakaway torque, otherwise zero.
    fn released(&self, i_q: f64, gear: f64, slope: f64) -> f64 {
        let driving = self.torque_constant * i_q - gear * (1.0 - slope);
        let held = self.friction_nm * self.breakaway + self.brake_nm + self.mesh * gear.abs();
        if driving.abs() > held { driving.signum() } else { 0.0 }
    }

    /// Returns the direction in which a load at rest is driven beyond its breakaway torque, otherwise zero.
    fn load_released(gear: f64, position: f64, given: &Given<'_>) -> f64 {
        let contact =
            given.stop.filter(|stop| stop.pressed(position, 0.0) > 0.0).map_or(0.0, |stop| stop.torque(position, 0.0));
        let driving = gear - given.load.torque(position, 0.0) - contact;
        if driving.abs() > given.load.coulomb_nm { driving.signum() } else { 0.0 }
    }
}
