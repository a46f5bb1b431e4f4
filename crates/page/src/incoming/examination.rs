//! Reading of a recording that is not part of a project, alone and within the project that would use it.

use super::choices::{Choices, TorqueUse};
use super::line::{LineMechanism, NO_MASS};
use crate::call::{Call, Shell};
use crate::names::kept_name;
use crate::state::PageState;
use axis::{AxisDiagnostic, AxisFault, AxisProject};
use project::{Edit, EditFault, edit, written};
use questions::{
    ExaminedRecording, IncomingFile, Progress, SmoothingEffect, Unread, read_all_watched, smoothing_effects,
};
use std::sync::Arc;
use words::own_hint;

/// A request about a file: the fields of the form, and the file.
pub(super) struct Request {
    pub(super) state: PageState,
    pub(super) choices: Choices,
    pub(super) file: IncomingFile,
}

impl Request {
    pub(super) fn of(call: &Call<'_>) -> Self {
        let mut parts = call.body.splitn(2, |byte| *byte == b'\n');
        let (fields, bytes) = (parts.next().unwrap_or_default(), parts.next().unwrap_or_default());
        let form = Call { media: Some("application/x-www-form-urlencoded"), body: fields, ..*call };
        let name = kept_name(&form.field("name").unwrap_or_default(), bytes);
        let file = IncomingFile::new(&name, bytes);
        let state = PageState::of(&form);
        let mut choices = Choices::of(&form, file.preview());
        if choices.is_along_a_line() {
            let SegmentPlace { prefix, .. } = SegmentPlace::of(&state);
            let is_whole = choices.torque == Some(TorqueUse::Whole);
            choices.line = LineMechanism::of(&form, (&state.text, &prefix), is_whole);
        }
        Self { state, choices, file }
    }
}

/// SegmentPlace of the recording in a project.
pub(super) struct SegmentPlace {
    /// `axis[2].` if the project has several axes, else empty.
    pub(super) prefix: String,
    /// Number of the segments that the axis has.
    pub(super) segments: usize,
}

impl SegmentPlace {
    pub(super) fn of(state: &PageState) -> Self {
        let keys = written(&state.text).unwrap_or_default();
        let several = keys.iter().any(|key| key.path == "axis[1]");
        let prefix = if several { format!("axis[{}].", state.axis + 1) } else { String::new() };
        let list = format!("{prefix}motion[");
        let index = |path: &str| path.strip_prefix(&list)?.split(']').next()?.parse::<usize>().ok();
        let segments = keys.iter().filter_map(|key| index(&key.path)).max().unwrap_or(0);
        Self { prefix, segments }
    }
}

/// Returns the text of the project with the recording under a name: only what is stated or chosen.
///
/// # Errors
/// When the text is no TOML.
pub(super) fn with_recording(
    state: &PageState,
    choices: &Choices,
    name: &str,
    smoothing: Option<&str>,
) -> Result<(String, usize), EditFault> {
    let SegmentPlace { prefix, segments } = SegmentPlace::of(state);
    let mut text = if state.text.trim().is_empty() { "format = 1\n".to_owned() } else { state.text.clone() };
    let mut apply = |path: &str, change: Edit<'_>| -> Result<(), EditFault> {
        text = edit(&text, &format!("{prefix}{path}"), change)?;
        Ok(())
    };
    let index = if choices.is_added { segments } else { 0 };
    if !choices.is_added {
        for _ in 0..segments {
            apply("motion[1]", Edit::Gone)?;
        }
    }
    let segment = format!("motion[{}]", index + 1);
    let is_whole = choices.torque == Some(TorqueUse::Whole);
    // A recorded torque contains that of the inertia; which one it is still decides about drive and resonance.
    let stated = written(&state.text).unwrap_or_default();
    let of_load = stated.into_iter().find(|key| key.path == format!("{prefix}load.inertia"));
    let inertia = of_load.and_then(|key| key.value).filter(|_| is_whole && choices.line.is_none());
    if is_whole || choices.line.is_some() {
        for load in ["load", "mechanism"] {
            apply(load, Edit::Gone)?;
        }
    }
    match &choices.line {
        Some(line) => {
            for (path, value) in &line.values {
                apply(path, Edit::Value(value))?;
            }
            if let Some(name) = line.name.filter(|_| is_whole) {
                apply(&format!("mechanism.{name}.mass"), Edit::Value(NO_MASS))?;
            }
        }
        None if is_whole => apply("mechanism.joint", Edit::Table)?,
        None => {}
    }
    if let Some(inertia) = inertia {
        apply("mechanism.joint.inertia", Edit::Value(&inertia))?;
    }
    if !choices.inertia.is_empty() && !is_whole && choices.line.is_none() {
        apply("load.inertia", Edit::Value(&choices.inertia))?;
    }
    apply(&segment, Edit::Table)?;
    let own = [("law".to_owned(), "recorded".to_owned()), ("file".to_owned(), name.to_owned())];
    let smoothing = smoothing.map(|window| ("smoothing".to_owned(), window.to_owned()));
    for (key, value) in own.into_iter().chain(choices.keys()).chain(smoothing) {
        apply(&format!("{segment}.{key}"), Edit::Value(&value))?;
    }
    if choices.runs_once {
        let head = if prefix.is_empty() { "axis." } else { "" };
        apply(&format!("{head}single_move"), Edit::Value("true"))?;
    }
    Ok((text, index))
}

/// Result of an examination of the file with the present choices.
#[derive(Default)]
pub(super) struct Examination {
    /// Recording, if it can be read.
    pub(super) examined: Option<ExaminedRecording>,
    /// Reasons why it cannot.
    pub(super) unreadable: Vec<(String, Option<String>)>,
    /// T_peak for each window; the acceleration while the load is open.
    pub(super) effects: Vec<SmoothingEffect>,
    /// Faults that the project has with the recording.
    pub(super) open: Vec<AxisDiagnostic>,
    /// The text of the project is no TOML.
    pub(super) has_faulty_text: bool,
}

pub(super) fn examine(request: &Request, shell: &dyn Shell, progress: &Progress) -> Examination {
    let Request { state, choices, file } = request;
    let l = state.language;
    let mut found = Examination::default();
    let files = file.among(shell.files(), progress);
    let axis = |text: &str| -> Result<Option<AxisProject>, Vec<AxisDiagnostic>> {
        match read_all_watched(text, &files, shell.catalogue(), progress) {
            Ok(mut axes) => Ok((state.axis < axes.len()).then(|| axes.swap_remove(state.axis))),
            Err(Unread::Faults(faults)) => Err(faults),
            Err(Unread::Refused(_)) => Ok(None),
        }
    };
    // With a question open there is no project yet.
    let has_answer = choices.is_answered();
    let mut project = None;
    match with_recording(state, choices, file.name(), None) {
        Err(_) => found.has_faulty_text = true,
        Ok(_) if !has_answer => {}
        Ok((text, index)) => {
            let stated = choices.smoothing.as_deref();
            let text = match stated {
                Some(window) => {
                    with_recording(state, choices, file.name(), Some(window)).map_or(text, |(text, _)| text)
                }
                None => text,
            };
            match axis(&text) {
                Ok(read) => project = read.map(|read| (read, index)),
                Err(faults) => {
                    found.open = faults;
                    // Of a cycle that does not close the peak torque is known all the same.
                    let once = Choices { runs_once: true, smoothing: None, ..choices.clone() };
                    let trial =
                        with_recording(state, &once, file.name(), None).ok().and_then(|(text, _)| axis(&text).ok());
                    project = trial.flatten().map(|read| (read, index));
                }
            }
        }
    }
    let of_project = project.as_ref().and_then(|(project, _)| {
        let read = project.recordings.iter().find(|read| read.file == file.name())?;
        Some(Arc::clone(&read.recording))
    });
    let recording = match of_project {
        Some(recording) => Ok(recording),
        None => file.read(&choices.layout(), shell.files(), progress).map(Arc::new),
    };
    let worded = |fault: &AxisFault| (words::fault_text(fault, l), own_hint(fault, l));
    let examined = recording.map_err(|faults| faults.iter().map(worded).collect::<Vec<_>>()).and_then(|recording| {
        ExaminedRecording::of(recording, choices.ratios())
            .map_err(|fault| vec![worded(&AxisFault::Recorded { name: file.name().to_owned(), fault })])
    });
    match examined {
        Ok(examined) => {
            let keys = written(&state.text).unwrap_or_default();
            let states_single =
                |key: &project::Written| key.path.ends_with("single_move") && key.value.as_deref() == Some("true");
            let is_single = choices.runs_once || keys.iter().any(states_single);
            let of = project.as_ref().map(|(project, index)| (project, *index));
            found.effects = smoothing_effects(of, is_single, &examined, choices.window(), progress);
            found.examined = Some(examined);
        }
        Err(reasons) => {
            found.unreadable = reasons;
            found.open.clear();
        }
    }
    found
}
