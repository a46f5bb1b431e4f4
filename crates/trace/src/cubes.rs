//! ∫|T_L|³ |ω| dt for the cubic mean torque of a gear.

use super::recording::{Cell, Inside, Ramps, Strip, Swept};
use super::{Block, Node, Panel, Trace};
use motion::Interval;
use numeric::lobatto;
use wide::f64x4;

/// The moments ∫ α^i R^j ω^k |ω| dt of a cell, i + j + k ≤ 3, in the order of [`POWERS`], in the signals of the cells.
pub(super) type Moments = [f64; 20];

/// Exponents i, j, k and the multinomial coefficient 3!/(i! j! k! (3 − i − j − k)!).
const POWERS: [(i32, i32, i32, f64); 20] = [
    (0, 0, 0, 1.0),
    (1, 0, 0, 3.0),
    (0, 1, 0, 3.0),
    (0, 0, 1, 3.0),
    (2, 0, 0, 3.0),
    (0, 2, 0, 3.0),
    (0, 0, 2, 3.0),
    (1, 1, 0, 6.0),
    (1, 0, 1, 6.0),
    (0, 1, 1, 6.0),
    (3, 0, 0, 1.0),
    (0, 3, 0, 1.0),
    (0, 0, 3, 1.0),
    (2, 1, 0, 3.0),
    (2, 0, 1, 3.0),
    (1, 2, 0, 3.0),
    (0, 2, 1, 3.0),
    (1, 0, 2, 3.0),
    (0, 1, 2, 3.0),
    (1, 1, 1, 6.0),
];

/// Adds the contribution of a panel of a cell. Its three nodes integrate polynomials of the third degree only; T³ω of
/// straight lines has the fourth, so five nodes are used.
pub(super) fn add(moments: &mut Moments, panel: &Panel<'_>) {
    let ([first, .., last], true) = (panel.nodes, panel.is_straight()) else { return };
    for (s, weight) in lobatto(5) {
        let node = first.towards(last, *s);
        let (a, r, w) = (node.acceleration_rad_s2, node.load_nm, node.speed_rad_s);
        let weight = weight * panel.duration_s * w.abs();
        let (aa, rr, ww) = (a * a, r * r, w * w);
        let powers = [
            1.0,
            a,
            r,
            w,
            aa,
            rr,
            ww,
            a * r,
            a * w,
            r * w,
            aa * a,
            rr * r,
            ww * w,
            aa * r,
            aa * w,
            a * rr,
            rr * w,
            a * ww,
            r * ww,
            a * r * w,
        ];
        moments.iter_mut().zip(powers).for_each(|(sum, power)| *sum += weight * power);
    }
}

/// Adds the contribution of an interval with constant torque R and one direction: ∫|ω|^n dt in closed form.
pub(super) fn add_interval(moments: &mut Moments, r: f64, interval: &Interval) {
    let (h, [w0, w1]) = (interval.duration_s, interval.speed_rad_s);
    let (a, p, s, q) = ((w1 - w0) / h, w0 + w1, w0 * w0 + w1 * w1, w0 * w1);
    let sign = if p < 0.0 { -h } else { h };
    // ∫ω |ω|^… dt: σ h Σ ω_0^(n−k) ω_1^k/(n + 1)
    let (one, two) = (sign * p / 2.0, sign * (s + q) / 3.0);
    let (three, four) = (sign * p * s / 4.0, sign * (s * s + q * (s - q)) / 5.0);
    let (aa, rr) = (a * a, r * r);
    let powers = [
        one,
        a * one,
        r * one,
        two,
        aa * one,
        rr * one,
        three,
        a * r * one,
        a * two,
        r * two,
        aa * a * one,
        rr * r * one,
        four,
        aa * r * one,
        aa * two,
        a * rr * one,
        rr * two,
        a * three,
        r * three,
        a * r * two,
    ];
    moments.iter_mut().zip(powers).for_each(|(sum, power)| *sum += power);
}

/// Computes ∫|s + p α + r R + q ω|³ |ω| dt of a cell in which the torque in the bars keeps its sign.
fn cube(moments: &Moments, [p, r, s, q]: [f64; 4]) -> f64 {
    let powers = |x: f64| [1.0, x, x * x, x * x * x];
    let (of_p, of_r, of_s, of_q) = (powers(p), powers(r), powers(s), powers(q));
    let at = |of: &[f64; 4], n: i32| usize::try_from(n).ok().and_then(|n| of.get(n).copied()).unwrap_or(0.0);
    let term = |(moment, (i, j, k, count)): (&f64, (i32, i32, i32, f64))| {
        count * at(&of_p, i) * at(&of_r, j) * at(&of_q, k) * at(&of_s, 3 - i - j - k) * moment
    };
    moments.iter().zip(POWERS).map(term).sum::<f64>().abs()
}

impl Trace {
    /// Returns ∫|T_L|³ |ω| dt over the cycle, computed on first use; needed only by gears with a rating.
    pub fn cubes(&self) -> f64 {
        *self.cubes.get_or_init(|| {
            // The moments pay off for many loads; for a single one they cost more than a pass.
            let by_cells = |strip: &&Strip| self.is_changed && strip.has_moments();
            let passed = self.blocks.iter().filter(|block| !self.strip_of(block).as_ref().is_some_and(by_cells));
            let strips = self.strips.iter().filter(by_cells);
            let recorded = strips.filter_map(|strip| Some(cubes_of_cell(strip, strip.root()?)));
            passed.map(|block| self.cubes_of(block)).chain(recorded).sum()
        })
    }

    fn cubes_of(&self, block: &Block) -> f64 {
        let mut sum = 0.0;
        match self.strip_of(block) {
            Some(strip) => strip.sweep(block, &mut |passed| {
                sum += match passed {
                    Swept::Ramps(ramps) => ramps.iter().map(cubes_of_ramps).sum(),
                    Swept::Panel(panel) => cubes_of_panel(&panel),
                }
            }),
            None => self.panels(block, &mut |panel| sum += cubes_of_panel(&panel)),
        }
        sum
    }

    fn strip_of(&self, block: &Block) -> Option<&Strip> {
        self.strips.get(block.recording_index()?)
    }
}

/// Computes ∫|T|³ |ω| dt over straight intervals without a reversal.
///
/// Where T keeps its sign, Boole's rule is exact because T³ω has the fourth degree; after a zero z of T with the speed
/// ω_z there, ∫_z^1 = |T_1|³ (1 − z) (ω_z/20 + ω_1/5), and correspondingly before it.
pub(super) fn cubes_of_ramps(ramps: &Ramps) -> f64 {
    let [a, b] = ramps.load_nm.map(f64x4::new);
    let [v, w] = ramps.speed_rad_s.map(|speed| f64x4::new(speed).abs());
    let of = |value: f64| f64x4::splat(value);
    let cubed = |torque: f64x4| (torque * torque * torque).abs();
    let at = |share: f64| cubed(a + of(share) * (b - a)) * (v + of(share) * (w - v));
    let [quarter, half, three] = [0.25, 0.5, 0.75].map(at);
    let smooth =
        of(7.0 / 90.0) * (cubed(a) * v + cubed(b) * w) + of(32.0 / 90.0) * (quarter + three) + of(12.0 / 90.0) * half;
    let crosses = (a * b).simd_lt(f64x4::ZERO);
    let zero = crosses.select(a / (a - b), f64x4::ZERO);
    let between = (v + zero * (w - v)) * of(1.0 / 20.0);
    let cut = cubed(a) * zero * (between + of(0.2) * v) + cubed(b) * (f64x4::ONE - zero) * (between + of(0.2) * w);
    (f64x4::new(ramps.duration_s) * crosses.select(cut, smooth)).reduce_add()
}

/// Computes ∫|T|³ |ω| dt of a cell, from its moments if the torque keeps its sign and the cell has one direction, else
/// from its parts.
fn cubes_of_cell(strip: &Strip, cell: &Cell) -> f64 {
    let (back, forth) = cell.extent.direction;
    if back == forth {
        let weights = strip.weights([0.0, 1.0, 0.0, 0.0]);
        let (low, high) = cell.extent.range(weights);
        let [p, r, s, q] = weights;
        if (low >= 0.0 || high <= 0.0)
            && let Some(moments) = strip.cubic(cell)
        {
            // The cube is weighted by the angle travelled, which does not depend on the pace of the recording.
            return cube(moments, [p, r, s * back, q]);
        }
    }
    match cell.inside {
        Inside::Intervals(from, to) => {
            let mut sum = 0.0;
            strip.panels_within((from, to), &mut |panel| sum += cubes_of_panel(&panel));
            sum
        }
        Inside::Halves(halves) => {
            strip.children(halves).into_iter().flatten().map(|half| cubes_of_cell(strip, half)).sum()
        }
    }
}

pub(super) fn cubes_of_panel(panel: &Panel<'_>) -> f64 {
    match panel.nodes {
        [_, _, _] => few(panel),
        nodes => nodes.iter().map(|node| node.weight_s * cubed(node)).sum(),
    }
}

/// Returns |T|³ |ω| at a node.
fn cubed(node: &Node) -> f64 {
    (node.load_nm * node.load_nm * node.load_nm * node.speed_rad_s).abs()
}

/// Computes ∫|T|³ |ω| dt of a panel with three nodes, split where T passes zero. Three nodes do not suffice: straight
/// lines already give the fourth degree. The cube is smooth enough at its zero that the zero of the chord is a
/// sufficient place for the split.
fn few(panel: &Panel<'_>) -> f64 {
    let [first, _, last] = panel.nodes else { return 0.0 };
    let at = |s: f64| if panel.is_straight() { first.towards(last, s) } else { panel.at(s) };
    let part = |from: f64, to: f64| {
        (to - from) * lobatto(5).iter().map(|(s, w)| w * cubed(&at(from + s * (to - from)))).sum::<f64>()
    };
    let zero = if first.load_nm * last.load_nm < 0.0 { first.load_nm / (first.load_nm - last.load_nm) } else { 0.0 };
    panel.nodes.iter().map(|node| node.weight_s).sum::<f64>() * (part(0.0, zero) + part(zero, 1.0))
}
