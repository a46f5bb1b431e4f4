//! A stated duration of the whole cycle, which the dwells of the motion fill.

use crate::edit::{Edit, edit, written};
use crate::scaled::{EXACT_DIGITS, shown};
use quantities::{Dimension, parse};

/// A text whose dwells fill a cycle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FilledCycle {
    /// The text.
    pub text: String,
    /// Changed keys, each with its value before and after; empty where there is none.
    pub changes: Vec<(String, String, String)>,
}

/// Reason why the dwells of a motion cannot fill a cycle.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unfilled {
    /// The moves alone take as long as the cycle, or longer: their duration.
    TooShort {
        /// Duration of the moves, as a quantity.
        moves: String,
    },
    /// The text has no motion, or the value is no duration.
    NoCycle,
}

/// A segment as far as it decides the duration of the cycle.
struct SegmentTime {
    path: String,
    is_dwell: bool,
    /// Stated duration \[s\].
    time_s: Option<f64>,
}

/// Returns the text with a cycle of a stated duration: the dwells fill what the moves leave, in proportion to their stated
/// durations. A single dwell, and the last one where the duration of a move is not stated, states the cycle instead of a
/// duration; without a dwell one is appended. `prefix` stands before the keys of the axis.
///
/// # Errors
/// [`Unfilled`].
pub fn cycle_filled(text: &str, prefix: &str, cycle: &str) -> Result<FilledCycle, Unfilled> {
    let all = written(text).ok_or(Unfilled::NoCycle)?;
    let cycle_s = parse(Dimension::Time, cycle).map_err(|_| Unfilled::NoCycle)?.si;
    let value = |path: &str| all.iter().find(|key| key.path == path).and_then(|key| key.value.as_deref());
    let place = (1..).map(|place: usize| format!("{prefix}motion[{place}]"));
    let paths = place.take_while(|path| all.iter().any(|key| key.path == *path));
    let segments: Vec<SegmentTime> = paths
        .map(|path| SegmentTime {
            is_dwell: value(&format!("{path}.law")) == Some("dwell"),
            time_s: value(&format!("{path}.time"))
                .and_then(|time| parse(Dimension::Time, time).ok())
                .map(|time| time.si),
            path,
        })
        .collect();
    if segments.is_empty() {
        return Err(Unfilled::NoCycle);
    }
    let moves_s: Option<f64> = segments.iter().filter(|segment| !segment.is_dwell).map(|segment| segment.time_s).sum();
    let dwells: Vec<&SegmentTime> = segments.iter().filter(|segment| segment.is_dwell).collect();
    if let Some(moves_s) = moves_s.filter(|moves_s| *moves_s >= cycle_s) {
        let moves = shown(moves_s, EXACT_DIGITS).unwrap_or_default();
        return Err(Unfilled::TooShort { moves: format!("{moves} s") });
    }
    let mut filled = FilledCycle { text: text.to_owned(), changes: Vec::new() };
    let mut set = |path: String, to: &str| -> Result<(), Unfilled> {
        let before = value(&path).unwrap_or_default();
        if before != to {
            filled.text = edit(&filled.text, &path, Edit::Value(to)).map_err(|_| Unfilled::NoCycle)?;
            filled.changes.push((path, before.to_owned(), to.to_owned()));
        }
        Ok(())
    };
    match (&dwells[..], moves_s) {
        ([], _) => {
            let path = format!("{prefix}motion[{}]", segments.len() + 1);
            let text = edit(text, &path, Edit::Table).map_err(|_| Unfilled::NoCycle)?;
            filled.text = text;
            for (key, to) in [("law", "dwell"), ("cycle", cycle)] {
                let path = format!("{path}.{key}");
                filled.text = edit(&filled.text, &path, Edit::Value(to)).map_err(|_| Unfilled::NoCycle)?;
                filled.changes.push((path, String::new(), to.to_owned()));
            }
        }
        ([_, _, ..], Some(moves_s)) => {
            let stated: Option<f64> = dwells.iter().map(|dwell| dwell.time_s).sum();
            let stated = stated.filter(|sum| *sum > 0.0);
            #[allow(clippy::cast_precision_loss, reason = "a count of segments")]
            let even = 1.0 / dwells.len() as f64;
            for dwell in &dwells {
                let share = stated.map_or(even, |sum| dwell.time_s.unwrap_or_default() / sum);
                let time = shown((cycle_s - moves_s) * share, EXACT_DIGITS).ok_or(Unfilled::NoCycle)?;
                set(format!("{}.cycle", dwell.path), "")?;
                set(format!("{}.time", dwell.path), &format!("{time} s"))?;
            }
        }
        ([others @ .., last], _) => {
            for dwell in others {
                set(format!("{}.cycle", dwell.path), "")?;
            }
            set(format!("{}.time", last.path), "")?;
            set(format!("{}.cycle", last.path), cycle)?;
        }
    }
    Ok(filled)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn motion(segments: &[&str]) -> String {
        let of = |segment: &&str| format!("[[motion]]\n{}\n", segment.replace("; ", "\n"));
        segments.iter().map(of).collect()
    }

    const MOVE: &str = "law = \"open\"; distance = \"90 deg\"; time = \"400 ms\"";
    const DWELL: &str = "law = \"dwell\"; time = \"1 s\"";

    #[test]
    fn the_dwells_fill_a_cycle_in_proportion() {
        let filled = cycle_filled(&motion(&[MOVE, DWELL, MOVE, DWELL]), "", "2 s").unwrap();
        let dwell = "law = \"dwell\"; time = \"0.6 s\"";
        assert_eq!(filled.text, motion(&[MOVE, dwell, MOVE, dwell]));
        assert_eq!(filled.changes.len(), 2);
        let longer = "law = \"dwell\"; time = \"3 s\"";
        let filled = cycle_filled(&motion(&[MOVE, DWELL, MOVE, longer]), "", "4800 ms").unwrap();
        assert_eq!(filled.text, motion(&[MOVE, DWELL, MOVE, longer]), "the stated dwells fill it already");
    }

    #[test]
    fn a_single_dwell_and_the_last_behind_a_move_without_a_time_state_the_cycle() {
        let filled = cycle_filled(&motion(&[MOVE, DWELL]), "", "2 s").unwrap();
        assert_eq!(filled.text, motion(&[MOVE, "law = \"dwell\"; cycle = \"2 s\""]));
        let open = "law = \"open\"; distance = \"90 deg\"; speed = \"20 1/min\"";
        let filled = cycle_filled(&motion(&[open, DWELL, open, DWELL]), "", "9 s").unwrap();
        assert_eq!(filled.text, motion(&[open, DWELL, open, "law = \"dwell\"; cycle = \"9 s\""]));
        let filled = cycle_filled(&motion(&[MOVE, MOVE]), "", "2 s").unwrap();
        assert!(filled.text.ends_with("[[motion]]\nlaw = \"dwell\"\ncycle = \"2 s\"\n"), "{}", filled.text);
        // The prefix is that of the axis.
        let axis = motion(&[MOVE, DWELL]).replace("[[motion]]", "[[axis.motion]]");
        let filled = cycle_filled(&format!("[[axis]]\n{axis}"), "axis[1].", "2 s").unwrap();
        assert!(filled.text.contains("cycle = \"2 s\""), "{}", filled.text);
    }

    #[test]
    fn a_cycle_that_the_moves_exceed_is_refused_with_their_duration() {
        let text = motion(&[MOVE, DWELL, MOVE, DWELL]);
        assert_eq!(cycle_filled(&text, "", "0.7 s"), Err(Unfilled::TooShort { moves: "0.8 s".to_owned() }));
        for (text, cycle) in [(text.as_str(), "2"), (text.as_str(), "2 kg"), ("", "2 s"), ("a = = b", "2 s")] {
            assert_eq!(cycle_filled(text, "", cycle), Err(Unfilled::NoCycle));
        }
    }
}
