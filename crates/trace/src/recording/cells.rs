//! The intervals of a recording as a k-d tree over their signals: neighbours are close in acceleration, speed and
//! torque, not in time. A cell has close bounds even in a noisy recording, and a search or an integral that depends on
//! a sign visits few cells.

use super::straight::{Sums, bounds};
use super::{SHARED_FROM, Strip, in_two};
use crate::bisection::{Point, halve, scale};
use crate::cubes::{self, Moments};
use crate::{Extent, Gram, Panel};
use mechanism::Plain;

/// Maximum number of intervals in a cell that is not split.
const LEAF: usize = 128;

/// Intervals with close signals, with bounds and sums in the signals of the survey.
#[derive(Debug)]
pub struct Cell {
    /// Bounds of the intervals, in the signals of the cells.
    pub extent: Extent,
    /// Sums of the products of the signals.
    pub gram: Gram,
    /// Start of the first interval \[s\].
    pub(super) from: f64,
    /// Intervals or halves of the cell.
    pub inside: Inside,
    /// Index among the cells.
    pub(super) number: u32,
}

/// Content of a cell.
#[derive(Clone, Copy, Debug)]
pub enum Inside {
    /// Intervals, as a range of places in the order.
    Intervals(u32, u32),
    /// Two cells, by index.
    Halves([u32; 2]),
}

/// The tree, its root last.
#[derive(Debug, Default)]
pub(super) struct Cells {
    cells: Vec<Cell>,
    order: Vec<u32>,
}

/// The intervals of one direction.
#[derive(Clone, Copy, Debug)]
struct Group {
    direction: usize,
    count: usize,
    /// Sign of the speed; `None` if the axis reverses within the intervals.
    side: Option<f64>,
    /// Place of the first interval in the order.
    first: u32,
}

/// Number of directions: backwards, at rest, forwards, reversing.
const DIRECTIONS: usize = 4;

impl Cells {
    pub(super) fn of(strip: &Strip) -> Self {
        let speeds = strip.surveyed.recorded.speed_rad_s();
        let directions = || speeds.windows(2).map(|pair| if let [from, to] = pair { direction(*from, *to) } else { 0 });
        let mut counts = [0; DIRECTIONS];
        directions().for_each(|here| counts.iter_mut().skip(here).take(1).for_each(|count| *count += 1));
        let (mut groups, mut first) = (Vec::new(), 0);
        for ((direction, count), side) in counts.into_iter().enumerate().zip([Some(-1.0), Some(0.0), Some(1.0), None]) {
            if count > 0 {
                groups.push(Group { direction, count, side, first: self::count(first) });
            }
            first += count;
        }
        // Two threads: one per group if that divides the work, else one per half of each group.
        let shared = strip.intervals() >= SHARED_FROM;
        let by_group = shared && counts.iter().all(|count| *count <= strip.intervals() / 4 * 3);
        let tree = |group: &Group| {
            let indices =
                directions().enumerate().filter(|(_, direction)| *direction == group.direction).map(|(index, _)| index);
            if strip.surveyed.recorded.torque_nm().is_some() {
                let mut points = Vec::with_capacity(group.count);
                points.extend(indices.filter_map(|index| Point::with_recorded(strip, index)));
                Self::of_group(strip, group, &mut points, shared && !by_group)
            } else {
                let mut points = Vec::with_capacity(group.count);
                points.extend(indices.filter_map(|index| Point::of(strip, index)));
                Self::of_group(strip, group, &mut points, shared && !by_group)
            }
        };
        let mut trees = in_two(&groups, by_group, &tree).into_iter();
        let mut all = trees.next().unwrap_or_default();
        for tree in trees {
            let root = count(all.cells.len().saturating_sub(1));
            let own = all.follow(tree.cells);
            all.order.extend(tree.order);
            join(&mut all.cells, [root, own]);
        }
        all.cells.iter_mut().zip(0..).for_each(|(cell, number)| cell.number = number);
        all
    }

    /// Builds the cells of the intervals of one direction. The points are freed with each group: those of all
    /// directions would need as much memory as two columns of the recording.
    fn of_group<const N: usize>(strip: &Strip, group: &Group, points: &mut [Point<N>], shared: bool) -> Self {
        let of = (strip, group.side);
        let scale = scale(points);
        let mut tree = Self { cells: Vec::with_capacity(1 + cells_of(points.len())), order: Vec::new() };
        if shared && points.len() >= SHARED_FROM {
            // One thread per half; the cells of the second half are appended to those of the first.
            let middle = halve(points, &scale);
            let (low, high) = points.split_at_mut(middle);
            let mut others = Vec::with_capacity(cells_of(high.len()));
            let from = group.first + count(middle);
            let (a, b) = std::thread::scope(|scope| {
                let other = || split(of, high, from, &scale, &mut others);
                let other = std::thread::Builder::new().spawn_scoped(scope, other).ok();
                (split(of, low, group.first, &scale, &mut tree.cells), other.and_then(|other| other.join().ok()))
            });
            if b.is_none() {
                // The second half is computed here if the thread could not be started, as in a browser, or did not
                // finish.
                others.clear();
                split(of, high, from, &scale, &mut others);
            }
            let b = tree.follow(others);
            join(&mut tree.cells, [a, b]);
        } else {
            split(of, points, group.first, &scale, &mut tree.cells);
        }
        tree.order.extend(points.iter().map(|point| point.index));
        tree
    }

    /// Appends the cells of another tree and returns the index of its root.
    fn follow(&mut self, others: Vec<Cell>) -> u32 {
        let shift = count(self.cells.len());
        self.cells.extend(others.into_iter().map(|cell| Cell { inside: cell.inside.shifted(shift), ..cell }));
        count(self.cells.len().saturating_sub(1))
    }

    #[inline]
    pub(super) fn root(&self) -> Option<&Cell> {
        self.cells.last()
    }

    #[inline]
    pub(super) fn children(&self, halves: [u32; 2]) -> [Option<&Cell>; 2] {
        halves.map(|index| self.cells.get(index as usize))
    }

    /// Returns the moments of all cells for the cube of a torque.
    pub(super) fn moments(&self, strip: &Strip) -> Vec<Moments> {
        let of_leaf = |cell: &Cell| {
            let mut moments = [0.0; 20];
            if let Inside::Intervals(from, to) = cell.inside {
                let constant = strip.straight().map(|plain| plain.constant_nm);
                let constant = constant.filter(|_| strip.surveyed.recorded.torque_nm().is_none());
                for index in self.intervals(from, to) {
                    match (constant, strip.surveyed.interval(index)) {
                        (Some(torque), Some(interval)) => cubes::add_interval(&mut moments, torque, &interval),
                        _ => strip.raw_interval(index, &mut |panel| cubes::add(&mut moments, &panel)),
                    }
                }
            }
            moments
        };
        let mut all = in_two(&self.cells, strip.intervals() >= SHARED_FROM, &of_leaf);
        for (place, cell) in self.cells.iter().enumerate() {
            if let Inside::Halves(halves) = cell.inside {
                // Both halves stand before their parent.
                let (before, whole) = all.split_at_mut(place);
                let halves = halves.into_iter().filter_map(|half| before.get(half as usize));
                if let Some(whole) = whole.first_mut() {
                    halves.for_each(|half| whole.iter_mut().zip(half).for_each(|(sum, part)| *sum += part));
                }
            }
        }
        all
    }

    #[inline]
    pub(super) fn intervals(&self, from: u32, to: u32) -> impl Iterator<Item = usize> {
        self.order.get(from as usize..to as usize).unwrap_or_default().iter().map(|index| *index as usize)
    }
}

impl Inside {
    const fn shifted(self, by: u32) -> Self {
        match self {
            Self::Halves([a, b]) => Self::Halves([a + by, b + by]),
            Self::Intervals(..) => self,
        }
    }
}

/// Converts a number of intervals or cells; a file of more than 2³² samples is refused much earlier.
#[allow(clippy::cast_possible_truncation, reason = "see above")]
const fn count(n: usize) -> u32 {
    n as u32
}

/// Returns the maximum number of cells for a number of intervals, each halved until it is a leaf.
const fn cells_of(points: usize) -> usize {
    2 * points.div_ceil(LEAF).next_power_of_two()
}

// An interval as a point of α, ω at its middle, and T. A torque that follows from the load changes little within an
// interval and is taken at its middle; a recorded torque may be noise and is taken at both ends.

#[allow(clippy::cast_possible_truncation, reason = "only neighbourhood counts")]
impl Point<3> {
    /// Creates the point of an interval without a recorded torque.
    fn of(strip: &Strip, index: usize) -> Option<Self> {
        let interval = strip.surveyed.interval(index)?;
        let [from, to] = interval.speed_rad_s;
        let mut torque = 0.0;
        if strip.straight().is_none() {
            strip.raw_interval(index, &mut |panel: Panel<'_>| {
                torque = panel.nodes.get(panel.nodes.len() / 2).map_or(0.0, |node| node.load_nm);
            });
        }
        let signals = [interval.acceleration_rad_s2() as f32, (0.5 * (from + to)) as f32, torque as f32];
        Some(Self { signals, index: count(index) })
    }
}

#[allow(clippy::cast_possible_truncation, reason = "only neighbourhood counts")]
impl Point<4> {
    /// Creates the point of an interval with a recorded torque.
    fn with_recorded(strip: &Strip, index: usize) -> Option<Self> {
        let interval = strip.surveyed.interval(index)?;
        let [from, to] = interval.speed_rad_s;
        let mut torque = interval.torque_nm;
        if strip.straight().is_none() {
            let mut ends: Option<[f64; 2]> = None;
            strip.raw_interval(index, &mut |panel: Panel<'_>| {
                if let [first, .., last] = panel.nodes {
                    ends = Some([ends.map_or(first.load_nm, |[first, _]| first), last.load_nm]);
                }
            });
            torque = ends.unwrap_or(torque);
        }
        let [first, last] = torque.map(|torque| torque as f32);
        let signals = [interval.acceleration_rad_s2() as f32, (0.5 * (from + to)) as f32, first, last];
        Some(Self { signals, index: count(index) })
    }
}

/// Returns the index among the [`DIRECTIONS`] of an interval, from the speeds at its ends.
fn direction(from: f64, to: f64) -> usize {
    if from * to < 0.0 {
        3
    } else if from + to < 0.0 {
        0
    } else if from + to == 0.0 {
        1
    } else {
        2
    }
}

/// Adds the cells of some points, whose first has the place `first` in the order, and returns the index of the cell
/// that contains all of them.
fn split<const N: usize>(
    of: (&Strip, Option<f64>),
    points: &mut [Point<N>],
    first: u32,
    scale: &[f32; N],
    cells: &mut Vec<Cell>,
) -> u32 {
    if points.len() <= LEAF {
        let inside = Inside::Intervals(first, first + count(points.len()));
        // In memory order.
        points.sort_unstable_by_key(|point| point.index);
        let strip = of.0;
        let cell = match (strip.straight(), of.1) {
            (Some(plain), Some(direction)) => straight(strip, (plain, direction), points, inside),
            _ => {
                let mut cell = Cell { inside, ..Cell::NONE };
                for point in points.iter() {
                    strip.raw_interval(point.index as usize, &mut |panel| cell.add(&panel));
                }
                cell
            }
        };
        cells.push(cell);
        return count(cells.len() - 1);
    }
    let middle = halve(points, scale);
    let (low, high) = points.split_at_mut(middle);
    let halves = [split(of, low, first, scale, cells), split(of, high, first + count(middle), scale, cells)];
    join(cells, halves)
}

/// Creates the cell of straight intervals with one direction.
fn straight<const N: usize>(
    strip: &Strip,
    (plain, direction): (&Plain, f64),
    points: &[Point<N>],
    inside: Inside,
) -> Cell {
    const NONE: (f64, f64) = (f64::INFINITY, f64::NEG_INFINITY);
    let wider = |(low, high): (f64, f64), value: f64| (low.min(value), high.max(value));
    let (mut sums, mut acceleration, mut torque, mut speeds) = (Sums::default(), NONE, NONE, NONE);
    let mut from = f64::INFINITY;
    for interval in points.iter().filter_map(|point| strip.surveyed.interval(point.index as usize)) {
        sums.add(&interval);
        acceleration = wider(acceleration, interval.acceleration_rad_s2());
        let ([w0, w1], [t0, t1]) = (interval.speed_rad_s, interval.torque_nm);
        speeds = wider(wider(speeds, w0), w1);
        torque = wider(wider(torque, t0), t1);
        from = from.min(interval.start_s);
    }
    let extent = bounds(plain, direction, acceleration, torque, speeds);
    Cell { extent, gram: sums.gram(plain, direction), from, inside, number: 0 }
}

/// Adds the cell that joins two halves and returns its index.
fn join(cells: &mut Vec<Cell>, halves: [u32; 2]) -> u32 {
    let mut cell = Cell { inside: Inside::Halves(halves), ..Cell::NONE };
    for half in halves.iter().filter_map(|index| cells.get(*index as usize)) {
        cell.extent.join(&half.extent);
        cell.gram.join(&half.gram);
        cell.from = cell.from.min(half.from);
    }
    cells.push(cell);
    count(cells.len() - 1)
}

impl Cell {
    const NONE: Self = Self {
        extent: Extent::NONE,
        gram: Gram([[0.0; 4]; 4]),
        from: f64::INFINITY,
        inside: Inside::Intervals(0, 0),
        number: 0,
    };

    fn add(&mut self, panel: &Panel<'_>) {
        let mut extent = Extent::NONE;
        for node in panel.nodes {
            extent.widen(node);
            self.gram.add(node);
        }
        extent.bend(&panel.bow);
        self.extent.join(&extent);
        self.from = self.from.min(panel.nodes.first().map_or(f64::INFINITY, |node| node.time_s));
    }
}
