//! A short cycle of straight panels, which every search looks at as a whole.

use super::{Kept, Node, Trace};

/// The ends of the panels and the lines between them.
#[derive(Clone, Debug, Default)]
pub(super) struct Straight {
    /// Of neighbouring ends with the same signals the first.
    pub(super) ends: Vec<Node>,
    /// Both ends of each panel along which a signal changes.
    pub(super) lines: Vec<[Node; 2]>,
}

/// So many ends before one are compared with it: those of a move and its pause.
const NEIGHBOURS: usize = 8;

impl Straight {
    /// Of a cycle that is short and has no other panels.
    pub(super) fn of(trace: &Trace) -> Option<Self> {
        if !trace.is_short() {
            return None;
        }
        let mut found = Self::default();
        for kept in &trace.panels {
            let [from, to] = trace.straight(kept)?;
            if kept.like.is_copy {
                continue;
            }
            for end in [from, to] {
                if found.ends.iter().rev().take(NEIGHBOURS).all(|known| known.signals() != end.signals()) {
                    found.ends.push(end);
                }
            }
            if from.signals() != to.signals() {
                found.lines.push([from, to]);
            }
        }
        Some(found)
    }
}

impl Trace {
    /// The ends of a straight panel.
    fn straight(&self, kept: &Kept) -> Option<[Node; 2]> {
        let panel = self.panel(kept);
        match panel.nodes {
            [from, .., to] if panel.is_straight() => Some([*from, *to]),
            _ => None,
        }
    }
}
