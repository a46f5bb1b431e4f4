//! ∫|T_L|³ |ω| dt for the cubic mean torque of a gear.

use super::recording::Strip;
use super::{Block, Node, Panel, Place, Trace};
use motion::lobatto;

/// The moments ∫ α^i ω^j |ω| dt of a block that turns one way, i + j ≤ 3, in the order of [`POWERS`].
pub(super) type Moments = [f64; 10];

/// i, j and 3!/(i! j! (3 − i − j)!)
const POWERS: [(i32, i32, f64); 10] = [
    (0, 0, 1.0),
    (1, 0, 3.0),
    (0, 1, 3.0),
    (2, 0, 3.0),
    (1, 1, 6.0),
    (0, 2, 3.0),
    (3, 0, 1.0),
    (2, 1, 3.0),
    (1, 2, 3.0),
    (0, 3, 1.0),
];

/// The moments of a block in the signals of the survey, where it turns one way under a recorded torque that does not change.
pub(super) fn moments(strip: &Strip, block: &Block) -> Option<Moments> {
    let (load, direction) = (block.extent.load, block.extent.direction);
    if load.1 - load.0 > 1e-12 * load.1.abs().max(load.0.abs()) || direction.0 != direction.1 {
        return None;
    }
    let mut moments = [0.0; 10];
    strip.raw_panels(block, &mut |panel: Panel<'_>| {
        for node in panel.nodes {
            let (a, w) = (node.acceleration, node.speed);
            let weight = node.weight * w.abs();
            let (aa, ww) = (a * a, w * w);
            let powers = [1.0, a, w, aa, a * w, ww, aa * a, aa * w, a * ww, ww * w];
            moments.iter_mut().zip(powers).for_each(|(sum, power)| *sum += weight * power);
        }
    });
    Some(moments)
}

/// ∫|k + p α + q ω|³ |ω| dt of a block in which that torque has one sign.
fn cube(moments: &Moments, [k, p, q]: [f64; 3]) -> f64 {
    let term =
        |(moment, (i, j, count)): (&f64, (i32, i32, f64))| count * k.powi(3 - i - j) * p.powi(i) * q.powi(j) * moment;
    moments.iter().zip(POWERS).map(term).sum::<f64>().abs()
}

impl Trace {
    /// ∫|T_L|³ |ω| dt; only gears with a rating ask for it.
    pub(crate) fn cubes(&self) -> f64 {
        *self.cubes.get_or_init(|| self.blocks.iter().map(|block| self.cubes_of(block)).sum())
    }

    fn cubes_of(&self, block: &Block) -> f64 {
        let (low, high) = block.extent.load;
        if let (Place::Recorded { strip, intervals }, true) = (&block.place, low >= 0.0 || high <= 0.0)
            && let Some(strip) = self.strips.get(*strip)
            && let Some((moments, factors)) = strip.cubic(intervals.start, block.extent.direction.0)
        {
            return cube(&moments, factors);
        }
        let mut sum = 0.0;
        self.panels(block, &mut |panel| {
            sum += match panel.nodes {
                [_, _, _] => few(&panel),
                nodes => nodes.iter().map(|node| node.weight * cubed(node)).sum(),
            };
        });
        sum
    }
}

/// |T|³ |ω|
fn cubed(node: &Node) -> f64 {
    (node.load * node.load * node.load * node.speed).abs()
}

/// ∫|T|³ |ω| dt of a panel with three nodes, cut where T passes zero: with straight lines of the fourth degree already, for
/// which the nodes themselves are not enough. The cube is smooth enough at its zero that the place of the straight line
/// through the ends serves.
fn few(panel: &Panel<'_>) -> f64 {
    let [first, _, last] = panel.nodes else { return 0.0 };
    let at = |s: f64| if panel.is_straight() { first.towards(last, s) } else { panel.at(s) };
    let part = |from: f64, to: f64| {
        (to - from) * lobatto(5).iter().map(|(s, w)| w * cubed(&at(from + s * (to - from)))).sum::<f64>()
    };
    let zero = if first.load * last.load < 0.0 { first.load / (first.load - last.load) } else { 0.0 };
    panel.nodes.iter().map(|node| node.weight).sum::<f64>() * (part(0.0, zero) + part(zero, 1.0))
}
