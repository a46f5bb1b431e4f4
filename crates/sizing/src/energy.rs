//! Power at the motor terminals over the cycle: energy taken and energy regenerated.

mod bent;
mod cells;
mod ramps;

use crate::axis::Axis;
use crate::check::CheckId;
use crate::comparison::{Asking, against_asked};
use crate::currents::{Currents, SPEED};
use crate::list::{Case, Outcome};
use crate::notes::Note;
use actuator::{Parameters, TerminalPower};
use cells::CellPower;
use derivation::{Finding, Workings};
use provenance::{Grade, Missing, Source};
use quantities::unit::{JOULE, NEWTON_METRE_PER_AMPERE, OHM, ONE, SECOND, WATT};
use quantities::{Energy, Measure, Power, ThermodynamicTemperature};
use ramps::Sweep;
use std::collections::BTreeMap;
use std::ops::Range;
use trace::{Block, Extent, Gram, Node, Panel, Ramps, Sought, Swept};

/// Winding temperature for which the resistance is stated, 20 °C in kelvin: the copper loss is least, so that the
/// regenerated energy is largest.
const COLD_WINDING: f64 = 293.15;

/// Power at the motor terminals, with a cold winding and the friction of the settled cycle.
pub(crate) struct CyclePower<'a> {
    currents: &'a Currents<'a>,
    motor: TerminalPower,
}

impl<'a> CyclePower<'a> {
    pub(crate) fn of(actuator: &Parameters, currents: Result<&'a Currents, &Missing>) -> Result<Self, Missing> {
        let currents = currents.map_err(|missing| *missing)?;
        Ok(Self { currents, motor: TerminalPower::of(actuator, ThermodynamicTemperature::from_si(COLD_WINDING))? })
    }

    /// Returns the current at an instant of a time in which the load drives, or does not \[A\].
    fn current(&self, node: &Node, driven: bool) -> f64 {
        let [inertia, load, direction, speed] = self.weights(driven);
        inertia * node.acceleration_rad_s2 + load * node.load_nm + direction * node.direction + speed * node.speed_rad_s
    }

    /// Returns the current as a weighted sum of (α, T_L, σ, ω) for a driving load, or otherwise.
    fn weights(&self, driven: bool) -> [f64; 4] {
        let [inertia, load, direction, speed] = self.currents.settled_weights();
        let passed = self.motor.passed(driven);
        [passed * inertia, passed * load, direction, speed]
    }

    /// Returns the power at an instant \[W\].
    pub(crate) fn at(&self, node: &Node) -> f64 {
        self.with(node, self.currents.point(node).is_driven())
    }

    /// Returns the power at an instant of a time in which the load drives, or does not \[W\].
    fn with(&self, node: &Node, driven: bool) -> f64 {
        self.motor.with(self.current(node, driven), node.speed_rad_s)
    }

    /// Returns J_out α + T_L \[Nm\].
    fn torque(&self, node: &Node) -> f64 {
        self.currents.point(node).torque_nm
    }

    /// Returns 1.5 R \[Ω\] and k_TM i [V/(rad/s)].
    fn constants(&self) -> (f64, f64) {
        (self.motor.copper_ohm(), self.motor.constant_v_s_per_rad())
    }

    /// Returns the energy of a time in which the load does not drive \[J\].
    fn driving(&self, gram: &Gram) -> f64 {
        let weights = self.weights(false);
        let (r, k) = self.constants();
        r * gram.square(weights) + k * gram.product(weights, SPEED)
    }

    /// Visits a gap between two instants with linear torque and speed: cut where the torque passes zero, since friction
    /// has another effect there.
    fn gap(&self, a: &Node, b: &Node, take: &mut impl FnMut(&Arc)) {
        let inertia = self.currents.inertia;
        let [from, to] = [a, b].map(|node| inertia * node.acceleration_rad_s2 + node.load_nm);
        if from * to < 0.0 {
            let zero = a.towards(b, from / (from - to));
            self.arc(a, &zero, from, take);
            self.arc(&zero, b, to, take);
        } else {
            self.arc(a, b, from + to, take);
        }
    }

    /// Visits the energy of each part of a gap with one sign of the power, in order \[J\].
    pub(crate) fn energies(&self, a: &Node, b: &Node, mut take: impl FnMut(f64)) {
        self.gap(a, b, &mut |arc| arc.parts(&mut take));
    }

    /// Visits a part of a gap with one sign of the torque: I and ω are linear there, so P is a parabola of time.
    fn arc(&self, a: &Node, b: &Node, torque: f64, take: &mut impl FnMut(&Arc)) {
        let braking = torque * a.direction < 0.0;
        let (i0, i1) = (self.current(a, braking), self.current(b, braking));
        let (w0, dw, di) = (a.speed_rad_s, b.speed_rad_s - a.speed_rad_s, i1 - i0);
        let (r, k) = self.constants();
        take(&Arc {
            duration: b.time_s - a.time_s,
            power: [(r * i0 + k * w0) * i0, 2.0 * r * i0 * di + k * (i0 * dw + w0 * di), (r * di + k * dw) * di],
        });
    }
}

/// Power as a parabola of time: P(u) = p_0 + p_1 u + p_2 u² with u from 0 to 1.
struct Arc {
    /// Time \[s\].
    duration: f64,
    /// p_0, p_1, p_2 \[W\].
    power: [f64; 3],
}

impl Arc {
    /// Returns P(u) \[W\].
    fn at(&self, u: f64) -> f64 {
        let [p0, p1, p2] = self.power;
        p0 + u * (p1 + u * p2)
    }

    /// Returns ∫P dt from the beginning to u \[J\].
    fn energy(&self, u: f64) -> f64 {
        let [p0, p1, p2] = self.power;
        self.duration * u * (p0 + u * (p1 / 2.0 + u * p2 / 3.0))
    }

    /// Returns the zeros of P within the arc, in order.
    fn zeros(&self) -> [Option<f64>; 2] {
        let [p0, p1, p2] = self.power;
        let root = p1 * p1 - 4.0 * p2 * p0;
        if root < 0.0 {
            return [None; 2];
        }
        // Without cancellation: one root from the sum, the other from the product.
        let q = -0.5 * (p1 + root.sqrt().copysign(p1));
        let within = |u: f64| (u > 0.0 && u < 1.0).then_some(u);
        match (within(q / p2), within(p0 / q)) {
            (Some(a), Some(b)) if a > b => [Some(b), Some(a)],
            found => [found.0, found.1],
        }
    }

    /// Visits the energy of each part with one sign of P, in order \[J\].
    fn parts(&self, mut take: impl FnMut(f64)) {
        let mut taken = 0.0;
        for u in self.zeros().into_iter().flatten().chain([1.0]) {
            let until = self.energy(u);
            take(until - taken);
            taken = until;
        }
    }

    /// Returns the least power \[W\].
    fn least(&self) -> f64 {
        let [p0, p1, p2] = self.power;
        let ends = p0.min(self.at(1.0));
        let vertex = -p1 / (2.0 * p2);
        if vertex > 0.0 && vertex < 1.0 { ends.min(self.at(vertex)) } else { ends }
    }
}

/// Energy in a capacitor bank that supplies the motor before the supply does.
#[derive(Clone, Copy, Debug, Default)]
struct Bank {
    /// Energy held \[J\].
    held: f64,
    /// Largest energy held so far \[J\].
    most: f64,
}

impl Bank {
    fn pass(&mut self, taken: f64) {
        self.held = (self.held - taken).max(0.0);
        self.most = self.most.max(self.held);
    }
}

/// Energies of panels with curved signals. Those of a panel that has repetitions are kept.
#[derive(Debug, Default)]
struct Passed {
    parts: Vec<f64>,
    kept: BTreeMap<usize, Range<usize>>,
    latest: Range<usize>,
}

impl Passed {
    /// Evaluates a panel, or reuses the result of an equal one; returns the larger of `peak` and its largest
    /// regenerated power.
    fn panel(&mut self, panel: &Panel<'_>, power: &CyclePower<'_>, peak: f64) -> f64 {
        let first = panel.like().filter(|like| like.has_others).map(|like| like.first);
        if let Some(known) = first.and_then(|first| self.kept.get(&first)) {
            // The largest power was counted with the first of the equal panels.
            self.latest = known.clone();
            return peak;
        }
        if self.kept.is_empty() {
            self.parts.clear();
        }
        let from = self.parts.len();
        let peak = bent::Walk::through(panel, power, peak, &mut self.parts);
        self.latest = from..self.parts.len();
        if let Some(first) = first {
            self.kept.insert(first, self.latest.clone());
        }
        peak
    }

    /// Returns the energy of each part of the last panel, in order \[J\].
    fn latest(&self) -> &[f64] {
        self.parts.get(self.latest.clone()).unwrap_or_default()
    }
}

/// Regenerated energy below this share of the energy taken is not reported.
const ROUNDING: f64 = 1e-12;

/// Energy balance of a cycle.
#[derive(Clone, Copy, Debug, Default)]
struct Balance {
    /// ∫P dt over the cycle \[J\].
    whole: f64,
    /// −∫P dt where P < 0 \[J\].
    back: f64,
    /// Largest −P \[W\].
    peak: f64,
    bank: Bank,
}

impl Balance {
    fn panel(&mut self, panel: &Panel<'_>, power: &CyclePower<'_>, passed: &mut Passed) {
        match panel.nodes {
            [a, .., b] if panel.is_straight() => {
                if b.time_s > a.time_s {
                    power.gap(a, b, &mut |arc| self.take(arc));
                }
            }
            _ => {
                self.peak = passed.panel(panel, power, self.peak);
                passed.latest().iter().for_each(|taken| self.part(*taken));
            }
        }
    }

    fn take(&mut self, arc: &Arc) {
        self.peak = self.peak.max(-arc.least());
        arc.parts(|taken| self.part(taken));
    }

    /// Adds the energy of a part in which the power has one sign.
    fn part(&mut self, taken: f64) {
        self.whole += taken;
        self.back -= taken.min(0.0);
        self.bank.pass(taken);
    }
}

/// Energy balance of a cycle with one actuator, while it is computed.
struct Account<'a> {
    power: &'a CyclePower<'a>,
    with_bank: bool,
    balance: Balance,
    passed: Passed,
    sweep: Sweep,
    /// For each recording, `true` if its cells are used and are already in the balance.
    by_cells: Vec<bool>,
}

impl<'a> Account<'a> {
    /// Begins the account with or without a capacitor bank; only a bank needs recordings in the order of time.
    fn of(axis: &Axis, power: &'a CyclePower<'a>) -> Self {
        let with_bank = axis.asked.dc_link_rise.is_some();
        let mut account = Self {
            power,
            with_bank,
            balance: Balance::default(),
            passed: Passed::default(),
            sweep: Sweep::of(power),
            by_cells: Vec::new(),
        };
        for strip in axis.trace.strips() {
            let cells = CellPower::of(strip, power);
            let serve = !with_bank && cells.serve();
            if serve {
                if let Some(root) = strip.root() {
                    cells.add(root, &mut account.balance, &mut account.passed);
                }
                account.balance.peak = strip.largest(&Returned(power), account.balance.peak);
            }
            account.by_cells.push(serve);
        }
        account
    }

    /// Returns `true` if the panels of a block must be evaluated: not if its cells are already in the balance, nor if
    /// the load does not drive in it, since the power then has one sign and the block is added as a whole.
    fn asks_for(&mut self, axis: &Axis, block: &Block) -> bool {
        if block.recording_index().and_then(|strip| self.by_cells.get(strip)).is_some_and(|cells| *cells) {
            return false;
        }
        if !axis.trace.is_short() && block.extent.power_sign(self.power.currents.inertia) == Some(1.0) {
            let taken = self.power.driving(&block.gram);
            self.balance.whole += taken;
            self.balance.bank.pass(taken);
            return false;
        }
        true
    }

    /// Adds some intervals, except the power that they would have without a driving load.
    fn ramps(&mut self, ramps: &[Ramps], extent: &Extent) {
        // Most blocks are below the largest power found so far.
        let with_peak = Returned(self.power).bound(extent) > self.balance.peak;
        let bank = self.with_bank.then_some(&mut self.balance.bank);
        let added = self.sweep.pass(ramps, with_peak, bank);
        self.balance.whole += added.beside;
        self.balance.back += added.back;
        self.balance.peak = self.balance.peak.max(added.peak);
    }

    fn panel(&mut self, panel: &Panel<'_>) {
        self.balance.panel(panel, self.power, &mut self.passed);
    }

    /// Adds a block whose panels are repeated several times in a row.
    fn repeated(&mut self, axis: &Axis, block: &Block) {
        let before = self.balance;
        self.once(axis, block);
        if block.times > 1.0 {
            let Balance { whole, back, .. } = self.balance;
            let all = |before: f64, once: f64| before + block.times * (once - before);
            // Effect of further periods on the bank: from the second on each adds the same amount.
            let first = self.balance.bank.held;
            self.once(axis, block);
            let bank = &mut self.balance.bank;
            bank.held += (block.times - 3.0).max(0.0) * (bank.held - first).max(0.0);
            if block.times > 2.0 {
                self.once(axis, block);
            }
            (self.balance.whole, self.balance.back) = (all(before.whole, whole), all(before.back, back));
        }
    }

    fn once(&mut self, axis: &Axis, block: &Block) {
        // Moments of the part evaluated as ramps.
        let mut gram = block.gram;
        axis.trace.sweep(block, &mut |swept| match swept {
            Swept::Ramps(ramps) => self.ramps(ramps, &block.extent),
            Swept::Panel(panel) => {
                if block.is_recorded() {
                    gram.take(&panel);
                }
                self.panel(&panel);
            }
        });
        if block.is_recorded() {
            self.balance.whole += self.power.driving(&gram);
        }
    }

    fn close(self) -> Balance {
        let mut balance = self.balance;
        // A cancellation error of the sum is no regenerated energy.
        if balance.back <= ROUNDING * balance.whole.abs() {
            (balance.back, balance.peak, balance.bank) = (0.0, 0.0, Bank::default());
        }
        balance
    }
}

/// Computes the energy balance of a cycle with one actuator.
fn balance(axis: &Axis, power: &CyclePower<'_>) -> Balance {
    let mut account = Account::of(axis, power);
    for block in axis.trace.blocks() {
        if account.asks_for(axis, block) {
            account.repeated(axis, block);
        }
    }
    account.close()
}

/// Regenerated power −P at an instant \[W\].
struct Returned<'a>(&'a CyclePower<'a>);

impl Sought for Returned<'_> {
    /// Bounds −P = −R I² − k ω I: the second term is largest at a corner, the first for the least |I|; for any I, at
    /// most (k ω)²/(4 R). In motor operation no power is regenerated.
    fn bound(&self, extent: &Extent) -> f64 {
        let (low, high) = extent.range(self.0.weights(true));
        let (back, forth) = extent.speeds_rad_s;
        let corners = [back * low, back * high, forth * low, forth * high];
        let least = if low > 0.0 {
            low
        } else if high < 0.0 {
            high
        } else {
            0.0
        };
        let (r, k) = self.0.constants();
        let returned = -k * corners.into_iter().fold(f64::INFINITY, f64::min);
        let open = k * extent.speed_rad_s;
        (returned - r * least * least).min(open * open / (4.0 * r)).max(0.0)
    }

    fn value(&self, node: &Node) -> f64 {
        -self.0.at(node)
    }

    fn on_line(&self, a: &Node, b: &Node) -> f64 {
        let mut most = f64::NEG_INFINITY;
        self.0.gap(a, b, &mut |arc| most = most.max(-arc.least()));
        most
    }
}

/// Returns `true` if a datum is missing without which the regenerated energy is unknown.
pub(crate) fn is_missing(actuator: &Parameters, currents: Result<&Currents, &Missing>) -> bool {
    CyclePower::of(actuator, currents).is_err()
}

/// Returns `true` if the regenerated power is below a share of its limit by the bounds of the blocks alone.
pub(crate) fn is_below(axis: &Axis, actuator: &Parameters, currents: Result<&Currents, &Missing>, share: f64) -> bool {
    let (Ok(power), Some(permitted)) = (CyclePower::of(actuator, currents), axis.asked.regeneration_power_max) else {
        return false;
    };
    let returned = Returned(&power);
    let most: f64 = axis.trace.blocks().iter().map(|block| returned.bound(&block.extent) * block.duration_s).sum();
    most < share * permitted.si() * axis.moments.duration.si()
}

/// Checks the mean regenerated power over the cycle, winding cold.
///
/// P = 1.5 R I² + k_TM I ω_mot at every instant; P < 0 is regenerated. Friction is part of I, so it reduces the
/// regenerated power. The energy taken follows from the balance: E_mot = ∫P dt + E_reg.
pub(crate) fn regeneration(case: &Case<'_>, work: &mut Workings) -> Outcome {
    let power = CyclePower::of(case.actuator, case.currents)?;
    let axis = case.axis;
    let balance = balance(axis, &power);
    let id = CheckId::Regeneration;
    let grade = power.currents.grade.worst(Grade::Computed);
    let mean = balance.back / axis.moments.duration.si();
    let permitted = axis.asked.regeneration_power_max.map(Measure::si);
    if work.is_on() {
        let source = Source::Model { name: "energy" };
        let what = Finding::EnergyReturned;
        let actuator = case.actuator;
        work.known("R_LL", &OHM, &actuator.resistance_ll);
        work.known("k_TM", &NEWTON_METRE_PER_AMPERE, &actuator.torque_constant_motor);
        work.known("k_Tout", &NEWTON_METRE_PER_AMPERE, &actuator.torque_constant_out);
        if let Some(ratio) = actuator.ratio.known() {
            work.given_number("i", ratio);
        }
        let share = power.motor.passed(true);
        work.formula("q_d", &ONE, share, "max(2*min(k_Tout/(i*k_TM), 1) - 1, 0)", &source);
        work.found("E_reg", &JOULE, balance.back, what, &source, grade);
        work.figure("t_0", &SECOND, axis.moments.duration.si(), &source, Grade::Computed);
        work.formula("P_reg", &WATT, mean, "E_reg/t_0", &source);
        work.value("P_reg");
    }
    work.asked("P_perm", &WATT, permitted, id);
    let mut check = against_asked(id, &WATT, mean, permitted, Source::Model { name: "energy" });
    check.grade = Some(grade);
    let notes = &mut check.notes;
    if let (Some(rise), Some(supply)) = (axis.asked.dc_link_rise, axis.supply) {
        // At a lower voltage, a capacitor takes less energy within the same rise.
        let low = supply.least().si();
        let high = low + rise.si();
        notes.push(Note::Capacitor {
            energy: Energy::from_si(balance.bank.most),
            capacitance_f: 2.0 * balance.bank.most / (high * high - low * low),
        });
    }
    notes.push(Note::EnergyPerCycle {
        motoring: Energy::from_si((balance.whole + balance.back).max(0.0)),
        regenerated: Energy::from_si(balance.back),
        peak: Power::from_si(balance.peak),
    });
    Ok(check)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(power: [f64; 3]) -> Arc {
        Arc { duration: 2.0, power }
    }

    /// P = −3 + 8u − 4u² has its zeros at ½ and 1½, P = 2 − 9u + 9u² at ⅓ and ⅔.
    #[test]
    fn zeros_and_least_power_by_hand() {
        assert_eq!(arc([-3.0, 8.0, -4.0]).zeros(), [None, Some(0.5)]);
        let [a, b] = arc([2.0, -9.0, 9.0]).zeros().map(Option::unwrap);
        assert!((a - 1.0 / 3.0).abs() < 1e-15 && (b - 2.0 / 3.0).abs() < 1e-15);
        assert_eq!(arc([2.0, -9.0, 9.0]).least(), -0.25);
        assert_eq!(arc([-1.0, 4.0, 0.0]).zeros().into_iter().flatten().collect::<Vec<_>>(), [0.25]);
        for none in [[1.0, 0.0, 0.0], [0.0; 3], [1.0, 0.0, 1.0], [-2.0, 0.5, 0.1]] {
            assert_eq!(arc(none).zeros(), [None; 2]);
        }
    }

    #[test]
    fn parts_agree_with_brute_force() {
        for power in [[-3.0, 8.0, -4.0], [2.0, -9.0, 9.0], [5.0, 1.0, -20.0], [-1.0, 0.0, 0.0], [4.0, -8.0, 0.0]] {
            let arc = arc(power);
            let (mut plus, mut minus) = (0.0, 0.0);
            arc.parts(|taken| if taken > 0.0 { plus += taken } else { minus -= taken });
            let steps = 100_000;
            let (mut brute_plus, mut brute_minus) = (0.0, 0.0);
            for step in 0..steps {
                let power = arc.at((f64::from(step) + 0.5) / f64::from(steps)) * arc.duration / f64::from(steps);
                if power > 0.0 { brute_plus += power } else { brute_minus -= power }
            }
            assert!((plus - brute_plus).abs() < 1e-8 && (minus - brute_minus).abs() < 1e-8, "{power:?}");
            assert!((plus - minus - arc.energy(1.0)).abs() < 1e-12, "{power:?}");
        }
    }
}
