//! Scenarios from the start page to a first answer.

use crate::stage::OpenPage;
use crate::tab::Worded;
use serde_json::json;

const PROJECT: &str = "# a table\nformat = 1\n[load]\ninertia = \"1.3 kg m^2\"\n[[motion]]\nlaw = \"trapezoid\"\ndistance = \"48 deg\"\ntime = \"1.3 s\"\n[requirements]\nsupply = \"560 V\"\n";

/// A mechanism tile, a few values, an answer.
pub(crate) fn with_figures(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.start("en")?;
    tab.click(".tiles li:nth-child(5) .tile")?;
    tab.there("#begin form")?;
    stage.accessible("beginning")?;
    for (path, value) in [
        ("mechanism-belt-pulley_diameter", "90"),
        ("mechanism-belt-mass", "25 kg"),
        ("motion-1--distance", "500"),
        ("motion-1--time", "2"),
        ("motion-2--time", "1"),
    ] {
        tab.fill(&format!("#f-{path}"), value)?;
    }
    tab.click("#begin form button[type=submit]")?;
    stage.ready()?;
    tab.says("#text", "25 kg")?;
    // What was begun and never saved is kept without a change: the start page leads back to it.
    tab.until("document.title.startsWith('•')")?;
    stage.start("en")?;
    tab.click("#unsaved li button")?;
    stage.ready()?;
    tab.says("#text", "25 kg")
}

/// An example from the list.
pub(crate) fn with_an_example(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.start("de")?;
    tab.says("#start-title", "Was möchten Sie bewegen?")?;
    tab.click("a[href*=\"new=belt\"]")?;
    stage.ready()?;
    tab.says("#demands-title", "Belastung")?;
    // The link back leads to the start page.
    tab.click("a[data-leaves]")?;
    tab.there("#start-title")
}

/// A project file from disk.
pub(crate) fn with_a_file(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.start("en")?;
    tab.will_choose("turntable.toml", PROJECT)?;
    tab.click("[data-open]")?;
    stage.ready()?;
    tab.holds("#file", "turntable.toml")?;
    tab.holds("#text", PROJECT)
}

/// A link that contains the whole project after its `#`.
pub(crate) fn with_a_link(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.change("#f-mechanism-belt-mass", "21 kg")?;
    tab.says("#text", "21 kg")?;
    let text = tab.value("#text")?;
    tab.click("#link")?;
    tab.until("location.hash.startsWith('#p=')")?;
    let hash = tab.eval("location.hash")?;
    // A new browser would show the start page.
    tab.run("sessionStorage.clear();", Vec::new())?;
    tab.open("about:blank")?;
    tab.open(&format!("{}{}", stage.shell.at("lang=en"), hash.as_str().unwrap_or_default()))?;
    stage.ready()?;
    tab.until(&format!("document.querySelector('#text')?.value === {}", json!(text)))
}
