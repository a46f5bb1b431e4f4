//! Order of the words of a call about a recording.

use super::{RECORDING, Sorting, has_ending};
use clap::Arg;

impl<'c> Sorting<'c> {
    /// Adds the kind of a project that begins with a recording and has none: `new log.csv`.
    pub(super) fn begun_by_recording(&mut self, bare: &[(usize, &'c str)]) {
        let is_new = self.called.entry.is_some_and(|entry| entry.command == "new");
        let has_kind = bare.iter().any(|(place, _)| self.placed.iter().all(|(other, _)| other != place));
        if !is_new || has_kind || !self.given.contains(&"from") {
            return;
        }
        match self.placed.iter_mut().find(|(_, words)| words.first().is_some_and(|word| word == "--from")) {
            Some((_, words)) => words.insert(0, RECORDING.to_owned()),
            None => self.kind_due = true,
        }
    }

    /// Exchanges a project that stands before the recording of it.
    pub(super) fn ordered(&mut self, bare: &[(usize, &str)]) {
        let positions: Vec<&Arg> = self.called.command.get_positionals().collect();
        let [trace, project] = &positions[..] else { return };
        let is_file = |position: &Arg, name: &str| position.get_id().as_str() == name;
        if !(is_file(trace, "trace") && is_file(project, "project")) {
            return;
        }
        let kept: Vec<&(usize, &str)> =
            bare.iter().filter(|(place, _)| self.placed.iter().all(|(other, _)| other != place)).collect();
        if let [(first, one), (second, other)] = &kept[..]
            && has_ending(one, &[".toml"])
            && !has_ending(other, &[".toml"])
        {
            self.placed.push((*first, vec![(*other).to_owned()]));
            self.placed.push((*second, vec![(*one).to_owned()]));
        }
    }
}
