//! The smooth parts of a cycle.

use super::{Extent, Node, rule};
use std::ops::Range;
use std::sync::OnceLock;

/// Which panels of the cycle a panel is like: those that show the same signals over the same time.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Like {
    /// Index of the first of them among the panels that are kept.
    pub first: usize,
    /// Whether it is not the first itself.
    pub is_copy: bool,
    /// Whether there are others.
    pub has_others: bool,
}

/// A smooth part of the cycle: between its nodes every signal is the polynomial through them.
#[derive(Clone, Copy, Debug)]
pub struct Panel<'a> {
    /// The nodes of a Gauss-Lobatto rule, two to sixteen.
    pub nodes: &'a [Node],
    /// Duration \[s\].
    pub duration_s: f64,
    /// Between two neighbouring nodes no signal leaves the straight line by more than this.
    pub bow: [f64; 4],
    /// What else is known of it, if it is kept.
    kept: Option<&'a Kept>,
}

impl<'a> Panel<'a> {
    /// One that is made whenever it is looked at.
    pub(super) const fn passing(nodes: &'a [Node], duration_s: f64, bow: [f64; 4]) -> Self {
        Self { nodes, duration_s, bow, kept: None }
    }

    /// Of a panel that is kept: bounds of its nodes and of what lies between them.
    #[inline]
    #[must_use]
    pub fn extent(&self) -> Option<&'a Extent> {
        self.kept.map(|kept| &kept.extent)
    }

    /// Of a panel that is kept: which panels of the cycle it is like.
    #[inline]
    #[must_use]
    pub fn like(&self) -> Option<Like> {
        self.kept.map(|kept| kept.like)
    }

    /// Of a panel that is kept and has many nodes: bounds of its stretches, each of so many parts between neighbouring nodes.
    #[inline]
    pub(super) fn stretches(&self, parts: usize) -> &'a [Extent] {
        let Some(kept) = self.kept.filter(|_| self.nodes.len() > parts + 1) else { return &[] };
        kept.stretches.get_or_init(|| {
            let firsts = (0..self.nodes.len() - 1).step_by(parts);
            let nodes = firsts.map(|first| self.nodes.get(first..).unwrap_or_default());
            nodes.map(|nodes| Extent::of(nodes.get(..=parts).unwrap_or(nodes), &self.bow)).collect()
        })
    }

    /// The instant at a share of the panel.
    #[inline]
    pub fn at(&self, share: f64) -> Node {
        match self.kept {
            Some(kept) if self.nodes.len() > PARABOLA => kept.series.at(self.nodes, share),
            _ => rule::between(self.nodes, share),
        }
    }

    /// The instant half-way between a node and the next.
    #[inline]
    #[must_use]
    pub fn middle(&self, node: usize) -> Node {
        rule::middle(self.nodes, node)
    }

    /// Whether every signal is straight.
    #[inline]
    pub fn is_straight(&self) -> bool {
        self.bow == [0.0; 4]
    }
}

/// Through so many nodes goes a parabola, which needs no series.
const PARABOLA: usize = 3;

/// A panel whose nodes are kept.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    pub(super) nodes: Range<usize>,
    pub(super) duration: f64,
    pub(super) bow: [f64; 4],
    pub(super) extent: Extent,
    pub(super) like: Like,
    /// Its polynomials.
    pub(super) series: rule::Series,
    /// Bounds of its stretches, found when it is first looked into.
    pub(super) stretches: OnceLock<Box<[Extent]>>,
}

impl Kept {
    /// The last nodes of those that are kept.
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
