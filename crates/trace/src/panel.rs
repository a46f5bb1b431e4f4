//! The smooth parts of a cycle.

use super::{Extent, Node, rule};
use std::ops::Range;
use std::sync::OnceLock;

/// Relation of a panel to the panels of the cycle that have the same signals over the same time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Like {
    /// Index of the first such panel among the stored ones.
    pub first: usize,
    /// The panel is not the first one.
    pub is_copy: bool,
    /// There are several such panels.
    pub has_others: bool,
}

/// A smooth part of the cycle: between its nodes every signal is the polynomial through them.
#[derive(Clone, Copy, Debug)]
pub struct Panel<'a> {
    /// The nodes of a Gauss-Lobatto rule, two to sixteen.
    pub nodes: &'a [Node],
    /// Duration \[s\].
    pub duration_s: f64,
    /// Largest deviation of each signal from the straight line between two neighbouring nodes.
    pub bow: [f64; 4],
    /// Further data of a stored panel.
    kept: Option<&'a Kept>,
}

impl<'a> Panel<'a> {
    /// Creates a panel that is computed for one visit and not stored.
    pub(super) const fn passing(nodes: &'a [Node], duration_s: f64, bow: [f64; 4]) -> Self {
        Self { nodes, duration_s, bow, kept: None }
    }

    /// Returns the instant at which the panel begins \[s\].
    #[inline]
    pub(super) fn start_s(&self) -> f64 {
        self.nodes.first().map_or(0.0, |node| node.time_s)
    }

    /// Returns the bounds of a stored panel: its nodes and the curve between them.
    #[inline]
    #[must_use]
    pub fn extent(&self) -> Option<&'a Extent> {
        self.kept.map(|kept| &kept.extent)
    }

    /// Returns the relation of a stored panel to those with the same signals.
    #[inline]
    #[must_use]
    pub fn like(&self) -> Option<Like> {
        self.kept.map(|kept| kept.like)
    }

    /// Returns the bounds of the stretches of a stored panel with many nodes, each stretch spanning `parts` intervals
    /// between nodes; empty for other panels.
    #[inline]
    pub(super) fn stretches(&self, parts: usize) -> &'a [Extent] {
        let Some(kept) = self.kept.filter(|_| self.nodes.len() > parts + 1) else { return &[] };
        kept.stretches.get_or_init(|| {
            let firsts = (0..self.nodes.len() - 1).step_by(parts);
            let nodes = firsts.map(|first| self.nodes.get(first..).unwrap_or_default());
            nodes.map(|nodes| Extent::of(nodes.get(..=parts).unwrap_or(nodes), &self.bow)).collect()
        })
    }

    /// Returns the instant at a share of the panel.
    #[inline]
    pub fn at(&self, share: f64) -> Node {
        match self.kept {
            Some(kept) if self.nodes.len() > PARABOLA => kept.series.at(self.nodes, share),
            _ => rule::between(self.nodes, share),
        }
    }

    /// Returns the instant half-way between a node and the next.
    #[inline]
    #[must_use]
    pub fn middle(&self, node: usize) -> Node {
        rule::middle(self.nodes, node)
    }

    /// Returns `true` if every signal is straight.
    #[inline]
    pub fn is_straight(&self) -> bool {
        self.bow == [0.0; 4]
    }
}

/// Number of nodes through which the polynomial is a parabola and needs no series.
const PARABOLA: usize = 3;

/// A panel whose nodes are stored.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    pub(super) nodes: Range<usize>,
    pub(super) duration: f64,
    pub(super) bow: [f64; 4],
    pub(super) extent: Extent,
    pub(super) like: Like,
    /// Series of the polynomials through the nodes.
    pub(super) series: rule::Series,
    /// Bounds of the stretches, computed on first use.
    pub(super) stretches: OnceLock<Box<[Extent]>>,
}

impl Kept {
    /// Creates the panel of the stored nodes from `first` on.
    pub(super) fn of(nodes: &[Node], first: usize, duration: f64, bow: [f64; 4]) -> Self {
        let extent = Extent::of(nodes.get(first..).unwrap_or_default(), &bow);
        let (like, series, stretches) = (Like::default(), rule::Series::default(), OnceLock::new());
        Self { nodes: first..nodes.len(), duration, bow, extent, like, series, stretches }
    }

    #[inline]
    pub(super) fn panel<'a>(&'a self, nodes: &'a [Node]) -> Panel<'a> {
        let nodes = nodes.get(self.nodes.clone()).unwrap_or_default();
        Panel { nodes, duration_s: self.duration, bow: self.bow, kept: Some(self) }
    }
}
