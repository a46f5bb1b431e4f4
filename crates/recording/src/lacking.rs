//! Samples that lack a value, and what can be read without them.

use crate::faults::{Remedy, Stamp};
use crate::layout::Role;

/// Samples that lack a value.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lacking {
    /// Runs of them, from an index up to another one; the last is extended once there are more than two.
    runs: Vec<(usize, usize)>,
    /// Channels without some values, by their indices.
    channels: Vec<usize>,
}

impl Lacking {
    /// Adds a sample that lacks the value of a channel.
    pub(crate) fn note(&mut self, index: usize, channel: usize) {
        // More runs than those at both ends have one answer.
        const RUNS_MOST: usize = 3;
        if !self.channels.contains(&channel) {
            self.channels.push(channel);
        }
        let is_full = self.runs.len() >= RUNS_MOST;
        match self.runs.last_mut() {
            Some((_, end)) if *end >= index || is_full => *end = index + 1,
            _ => self.runs.push((index, index + 1)),
        }
    }

    /// Returns the channels without some values, each with the way to read the recording nevertheless. `roles` are those of all
    /// channels, `count` the number of samples if all were read, and `stamp` returns the time of one.
    pub(crate) fn remedies(
        &self,
        roles: &[Role],
        count: Option<usize>,
        stamp: impl Fn(usize) -> Stamp,
    ) -> Vec<(usize, Remedy)> {
        let is_whole = |(place, _): &(usize, &Role)| !self.channels.contains(place);
        let whole: Vec<Role> = roles.iter().enumerate().filter(is_whole).map(|(_, role)| *role).collect();
        let rows = count.and_then(|count| self.complete_rows(count, stamp));
        let remedy = |channel: &usize| {
            let role = *roles.get(*channel)?;
            Some((*channel, if is_spare(role, &whole) { Remedy::Without(role) } else { rows? }))
        };
        self.channels.iter().filter_map(remedy).collect()
    }

    /// Returns the window in which no sample lacks a value, unless such samples stand among others; `None` if every sample lacks one.
    fn complete_rows(&self, count: usize, stamp: impl Fn(usize) -> Stamp) -> Option<Remedy> {
        let (first, last) = (self.runs.first(), self.runs.last());
        let lead = first.filter(|(start, _)| *start == 0).map(|(_, end)| *end);
        let tail = last.filter(|(start, end)| *end == count && *start > 0).map(|(start, _)| *start);
        let at_ends = usize::from(lead.is_some()) + usize::from(tail.is_some());
        // Two samples make no motion.
        let is_some = tail.unwrap_or(count).saturating_sub(lead.unwrap_or(0)) > 2;
        if lead == Some(count) {
            return None;
        }
        if at_ends != self.runs.len() || !is_some {
            return Some(Remedy::Delete);
        }
        Some(Remedy::Within { from: lead.map(&stamp), to: tail.map(|tail| stamp(tail.saturating_sub(1))) })
    }
}

/// Returns `true` if a recording can be read without the column of a role, where those of other roles are `whole`.
pub(crate) fn is_spare(role: Role, whole: &[Role]) -> bool {
    match role {
        Role::Torque => true,
        Role::Position => whole.contains(&Role::Speed),
        Role::Speed => whole.contains(&Role::Position),
        Role::Time => false,
    }
}
