//! `mount`: how an actuator is mounted.

use crate::answer::{Answer, written};
use crate::code::{parse_for_use, read_argument};
use crate::fault::{option_fault, simple};
use crate::laid_out::shown;
use crate::subject::{axes_of, refuse, refused_together};
use clap::ArgMatches;
use workbench::answers::Fit;
use workbench::text::terminal;
use workbench::{Language, MountAsked, OrderCode, Question, chapter};

/// `antrieb mount CODE`
pub(crate) fn mount(matches: &ArgMatches, as_json: bool, language: Language) -> Answer {
    let mut faults: Vec<Answer> = Vec::new();
    let code = parse_for_use(&read_argument(matches), as_json, language).map_err(|fault| faults.push(fault));
    let mut bore = |option: &str| {
        let text = matches.get_one::<String>(option)?;
        workbench::read_bore(text, language)
            .map_err(|fault| faults.push(option_fault(option, fault, as_json, language)))
            .ok()
    };
    let (both, load, housing) = (bore("bore"), bore("bore-load"), bore("bore-housing"));
    let asked = MountAsked { bore_load: load.or(both), bore_housing: housing.or(both), ..MountAsked::default() };
    let Ok((reading, talk)) = code else { return refused_together(faults, as_json) };
    if !faults.is_empty() {
        return refused_together(faults, as_json);
    }
    let code = reading.parsed.code;
    let found = match loaded(matches, &code, asked, as_json, language) {
        Ok(found) => found,
        Err(fault) => return fault,
    };
    let (asked, axis) = found;
    let Some(found) = workbench::mount(&code, &asked) else {
        return refuse(&workbench::Refusal::NoData, as_json, language);
    };
    let record = workbench::answer::mount(&found, &asked, axis.as_deref(), language);
    let data = if as_json { written(&record) } else { shown(&chapter::mount(&record, language), language) };
    Answer { talk, ..Answer::data(data) }.fits(record.verdict == Fit::Fits)
}

/// The question with the loads of a project, where one is named, and the name of its axis.
fn loaded(
    matches: &ArgMatches,
    code: &OrderCode,
    asked: MountAsked,
    as_json: bool,
    language: Language,
) -> Result<(MountAsked, Option<String>), Answer> {
    if !matches.contains_id("project") {
        return Ok((asked, None));
    }
    let projects = axes_of(Question::Other, matches, as_json, language)?;
    let [project] = projects.as_slice() else {
        let names: Vec<&str> = projects.iter().map(|project| project.name.as_str()).collect();
        return Err(simple(&terminal::several_axes(&names.join(", "), language), as_json, language));
    };
    let axis = workbench::joint_loads(project, code).map_err(|refusal| refuse(&refusal, as_json, language))?;
    Ok((MountAsked { axis, ..asked }, Some(project.name.clone())))
}
