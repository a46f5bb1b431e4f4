//! Scenarios of the pictures and of the tools next to the project.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect, key};

/// Dragging the end of a segment is one undo step.
pub(crate) fn an_end_is_pulled(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let before = tab.value("#text")?;
    let verdict = tab.text("#demands")?;
    // Later: the rest before it lasts longer, and the cycle still closes.
    tab.drag("#grip-1", (40, 0))?;
    tab.until(&format!("document.querySelector('#text').value !== {}", serde_json::json!(before)))?;
    tab.until("!document.querySelector('#demands.old') && !document.querySelector('#faults li')")?;
    expect(tab.text("#demands")? != verdict, || "the demand is the one before".to_owned())?;
    tab.until("document.querySelector('#undo').ariaDisabled === 'false'")?;
    tab.click("#undo")?;
    tab.holds("#text", &before)?;
    tab.until("document.querySelector('#undo').ariaDisabled === 'true'")
}

/// The end of a segment is moved by keys.
pub(crate) fn an_end_is_pulled_by_keys(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let spoken = "document.querySelector('#grip-1').getAttribute('aria-valuetext')";
    let (text, before) = (tab.value("#text")?, tab.eval(spoken)?);
    tab.run("document.querySelector('#grip-1').focus();", Vec::new())?;
    tab.keys(&key::RIGHT.to_string())?;
    tab.until(&format!("document.querySelector('#text').value !== {}", serde_json::json!(text)))?;
    tab.until(&format!("{spoken} !== {before}"))?;
    tab.until("document.activeElement.id === 'grip-1'")
}

/// The pictures over time are zoomed in and back to the whole.
pub(crate) fn the_time_is_narrowed(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let shown = "(() => { const plane = document.querySelector('#plot-cycle g.plane[data-x-max]').dataset; return plane.xMax - plane.xMin; })()";
    let whole = tab.eval(shown)?.as_f64().ok_or("no cycle")?;
    tab.click("#zoom-in")?;
    tab.until(&format!("{shown} < {}", 0.9 * whole))?;
    tab.click("#zoom-whole")?;
    tab.until(&format!("Math.abs({shown} - {whole}) < 1e-9"))
}

/// A tolerance is entered next to its value.
pub(crate) fn a_tolerance(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let text = tab.value("#text")?;
    expect(!text.contains('±'), || format!("there is one already: {text}"))?;
    tab.fill("#f-mechanism-belt-mass-pm", "5 %")?;
    tab.says("#text", "±")
}

/// A calculator answers while it is edited, and reports faults.
pub(crate) fn the_tools_know_the_actuator(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let code = tab.text("#standing strong.code")?;
    tab.click("#tools")?;
    tab.holds("#about", &code)?;
    for tool in ["wiring", "commission", "encoder", "upkeep"] {
        let button = format!("#detail nav.kinds button[hx-vals*='\"{tool}\"']");
        tab.click(&button)?;
        tab.until(&format!("document.querySelector({})?.ariaPressed === 'true'", serde_json::json!(button)))?;
        tab.holds("#about", &code)?;
    }
    Ok(())
}

pub(crate) fn a_calculator(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    tab.open(&stage.shell.at("tool=torsion&lang=en"))?;
    tab.there("#tool #about")?;
    stage.listens()?;
    tab.fill("#about", "CHA-25A-100-H-C1024")?;
    tab.fill("#t-torque", "30 N m")?;
    tab.says("#tool strong", "2.65 arcmin")?;
    tab.fill("#t-torque", "30 kg")?;
    tab.says("#tool .fault", "kg")?;
    stage.accessible("calculator")
}
