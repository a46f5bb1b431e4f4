//! A cycle that an edit has opened is closed again: the way back follows.

use crate::{Progress, moves, read_all_watched, segment_handles};
use axis::{AxisDiagnostic, AxisFault, AxisProject, Catalogue, Files};
use motion::MoveFault;
use project::{Edit, edit, stretch};
use std::sync::Arc;

/// Gap relative to the way travelled that counts as closed: that of the digits of a scaled distance.
const CLOSED: f64 = 1e-9;

/// Returns `true` if a fault is that the cycle does not come back to its position.
#[must_use]
pub fn is_open_cycle(fault: &AxisDiagnostic) -> bool {
    matches!(fault.fault, AxisFault::Move { fault: MoveFault::PositionNotClosed { .. }, .. })
}

/// A text of a project with the resources that it is read with.
#[derive(Clone, Copy)]
pub struct OpenCycle<'t> {
    /// Text whose cycle is open.
    pub text: &'t str,
    /// Last text that was closed; empty if there was none.
    pub before: &'t str,
    /// Prefix of the paths of the axis: `axis[2].` if the file has several, else empty.
    pub prefix: &'t str,
    /// Index of the edited segment, which stays as it is; `None` to let any segment follow.
    pub edited: Option<usize>,
    /// Files that the text may name.
    pub files: &'t dyn Files,
    /// Products that are offered.
    pub catalogue: &'t Arc<dyn Catalogue>,
}

/// Returns the text with segments scaled in their distance so that the cycle is closed: those of the way back, in
/// proportion; if there are none, the other segments of the same direction. `None` if no scale of them closes it, which
/// a recording, a segment in motion at an end and a way back of no length do not allow.
#[must_use]
pub fn closed(open: &OpenCycle<'_>, progress: &Progress) -> Option<String> {
    let found = open.single(open.text, progress)?;
    let target = open.single(open.before, progress).map_or(0.0, |before| distances(&before).iter().sum());
    let ways = distances(&found);
    let gap = ways.iter().sum::<f64>() - target;
    let travelled: f64 = ways.iter().map(|way| way.abs()).sum();
    if gap.abs() <= CLOSED * travelled {
        return None;
    }
    let direction = match open.edited {
        Some(edited) => *ways.get(edited)?,
        None => gap,
    };
    let handles = segment_handles(&found);
    let scaled = |side: f64| -> Vec<usize> {
        let goes = handles.segment_handles.iter().filter(|handle| handle.goes).map(|handle| handle.segment);
        goes.filter(|index| Some(*index) != open.edited)
            .filter(|index| ways.get(*index).is_some_and(|way| way * side > 0.0))
            .collect()
    };
    let sides = [scaled(-direction), scaled(direction)];
    let segments = sides.into_iter().find(|segments| !segments.is_empty())?;
    let sum: f64 = segments.iter().filter_map(|index| ways.get(*index)).sum();
    let factor = 1.0 - gap / sum;
    if !factor.is_finite() || factor <= 0.0 {
        return None;
    }
    let path = |index: usize| format!("{}motion[{}]", open.prefix, index + 1);
    segments
        .iter()
        .try_fold(open.text.to_owned(), |text, index| stretch(&text, &path(*index), 1.0, factor))
        .ok()
        .filter(|text| text != open.text)
}

impl OpenCycle<'_> {
    /// Reads the axis of a text as a single move, which need not be closed.
    fn single(&self, text: &str, progress: &Progress) -> Option<AxisProject> {
        let number = self.prefix.strip_prefix("axis[").and_then(|rest| rest.split_once(']')?.0.parse().ok());
        let index: usize = number.unwrap_or(1);
        let path = if number.is_some() { format!("{}single_move", self.prefix) } else { "axis.single_move".to_owned() };
        let text = edit(text, &path, Edit::Value("true")).ok()?;
        let projects = read_all_watched(&text, self.files, self.catalogue, progress).ok()?;
        projects.into_iter().nth(index.checked_sub(1)?)
    }
}

/// Returns the signed distance of each segment at the output.
fn distances(project: &AxisProject) -> Vec<f64> {
    let found = moves(project);
    let of = |course: Option<[f64; 3]>| course.map_or(0.0, |[distance, ..]| distance / found.per_output);
    let pieces = project.axis.motion.pieces();
    let way = |(index, each): (usize, &crate::Move<'_>)| {
        let mut own = pieces.iter().filter(|piece| piece.segment == index);
        let Some(first) = own.next() else { return of(each.course) };
        own.next_back().unwrap_or(first).end().position_rad - first.position_rad
    };
    found.moves.iter().enumerate().map(way).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{embedded_catalogue, read};
    use axis::NoFiles;

    fn cycle(motion: &str) -> String {
        format!("format = 1\n[mechanism.screw]\nlead = \"10 mm\"\nmass = \"20 kg\"\n{motion}")
    }

    fn segment(law: &str, keys: &str) -> String {
        format!("[[motion]]\nlaw = \"{law}\"\n{keys}\n")
    }

    fn follow(text: &str, before: &str, edited: Option<usize>) -> Option<String> {
        let open = OpenCycle { text, before, prefix: "", edited, files: &NoFiles, catalogue: embedded_catalogue() };
        closed(&open, &Progress::endless())
    }

    /// Opens cycles of several laws by every edit of one segment, and closes them.
    #[test]
    fn the_way_back_of_any_law_follows_any_edited_segment() {
        let rest = segment("dwell", "time = \"0.4 s\"");
        let moves = |way: &str| {
            [
                segment("trapezoid", &format!("distance = \"{way}\"\ntime = \"1 s\"")),
                segment("polynomial_5", &format!("distance = \"{way}\"\nspeed = \"0.8 m/s\"")),
                segment("modified_sine", &format!("distance = \"{way}\"\nacceleration = \"3 m/s^2\"")),
                segment(
                    "jerk",
                    &format!(
                        "distance = \"{way}\"\nspeed = \"0.5 m/s\"\nacceleration = \"3 m/s^2\"\njerk = \"40 m/s^3\""
                    ),
                ),
            ]
        };
        let mut count = 0;
        for there in moves("300 mm") {
            for back in moves("-300 mm") {
                let before = cycle(&[there.as_str(), &rest, &back, &rest].concat());
                assert!(read(&before).is_ok(), "{before}");
                for (index, (was, to)) in
                    [("\"300 mm\"", "\"437.5 mm\""), ("\"300 mm\"", "\"3 mm\""), ("\"-300 mm\"", "\"-281.3 mm\"")]
                        .into_iter()
                        .enumerate()
                {
                    let edited = if index < 2 { 0 } else { 2 };
                    let open = before.replacen(was, to, 1);
                    assert!(read(&open).is_err(), "{open}");
                    let text = follow(&open, &before, Some(edited)).unwrap();
                    assert!(read(&text).is_ok(), "{text}");
                    assert!(text.contains(to), "the edited segment stays: {text}");
                    let magnitude = to.trim_start_matches(['"', '-']);
                    assert_eq!(text.matches(magnitude).count(), 2, "{text}");
                    count += 1;
                }
            }
        }
        assert_eq!(count, 48);
    }

    #[test]
    fn several_segments_of_the_way_back_share_it_in_proportion() {
        let parts = [("300 mm", "1 s"), ("-100 mm", "0.5 s"), ("-200 mm", "0.7 s")];
        let all: String = parts
            .iter()
            .map(|(way, time)| segment("trapezoid", &format!("distance = \"{way}\"\ntime = \"{time}\"")))
            .collect();
        let before = cycle(&all);
        let open = before.replace("\"300 mm\"", "\"360 mm\"");
        let text = follow(&open, &before, Some(0)).unwrap();
        assert!(text.contains("\"-120 mm\"") && text.contains("\"-240 mm\"") && read(&text).is_ok(), "{text}");
        // Without an edited segment, the shorter way follows the longer one.
        let by_itself = follow(&open, "", None).unwrap();
        assert!(read(&by_itself).is_ok() && by_itself.contains("\"360 mm\""), "{by_itself}");
    }

    #[test]
    fn a_manual_move_follows_by_its_speed() {
        let keys = |speed: &str| {
            format!(
                "speed = \"{speed}\"\naccelerate = \"0.1 s\"\nrun = \"0.3 s\"\nbrake = \"0.1 s\"\npause = \"0.5 s\""
            )
        };
        let of = |there: &str, back: &str| cycle(&(segment("manual", &keys(there)) + &segment("manual", &keys(back))));
        let text = follow(&of("0.7 m/s", "-0.3 m/s"), &of("0.3 m/s", "-0.3 m/s"), Some(0)).unwrap();
        assert!(text.contains("\"-0.7 m/s\"") && read(&text).is_ok(), "{text}");
    }

    #[test]
    fn what_no_way_back_can_close_stays_open() {
        let only = cycle(&segment("trapezoid", "distance = \"300 mm\"\ntime = \"1 s\""));
        assert_eq!(follow(&only, "", Some(0)), None);
        assert_eq!(follow(&only, "", None), None);
        assert_eq!(follow("format = = 1", "", None), None);
        let shut = cycle(
            &(segment("trapezoid", "distance = \"300 mm\"\ntime = \"1 s\"")
                + &segment("trapezoid", "distance = \"-300 mm\"\ntime = \"1 s\"")),
        );
        assert_eq!(follow(&shut, &shut, Some(0)), None);
    }
}
