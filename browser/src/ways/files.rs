//! Scenarios with files: save, open, paste, download.

use crate::shell::Shell;
use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use serde_json::json;

pub(crate) fn save_and_open(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.change("#f-mechanism-belt-mass", "47 kg")?;
    tab.fill("#file", "saved.toml")?;
    tab.click("#save")?;
    tab.says("#status", "saved.toml")?;
    let text = tab.value("#text")?;
    if let Some(folder) = stage.shell.folder() {
        let there = std::fs::read_to_string(folder.join("saved.toml")).map_err(|error| error.to_string())?;
        expect(there == text, || format!("the disk has {there}"))?;
    }
    stage.start("en")?;
    tab.click("a[href*=\"open=saved.toml\"]")?;
    stage.ready()?;
    tab.until(&format!("document.querySelector('#text')?.value === {}", json!(text)))?;
    // The file is saved as a new version of the one that was opened.
    stage.change("#f-mechanism-belt-mass", "48 kg")?;
    tab.click("#save")?;
    tab.says("#status", "saved.toml")?;
    tab.until("!document.title.startsWith('•')")
}

pub(crate) fn two_tabs(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    tab.fill("#file", "shared.toml")?;
    tab.click("#save")?;
    tab.says("#status", "shared.toml")?;
    let elsewhere = |path: &str, value: &str| {
        let first = tab.another()?;
        tab.open(&stage.shell.at("open=shared.toml&lang=en"))?;
        stage.ready()?;
        stage.change(path, value)?;
        tab.click("#save")?;
        tab.until("!document.title.startsWith('•')")?;
        tab.back_to(first)
    };
    stage.change("#f-mechanism-belt-mass", "32 kg")?;
    elsewhere("#f-mechanism-belt-mass", "31 kg")?;
    // Both changed the same value: the difference is asked in words.
    tab.says("#disk", "here 32 kg, there 31 kg")?;
    tab.until("document.title.startsWith('•')")?;
    tab.click("#disk [data-prefer=theirs]")?;
    tab.holds("#f-mechanism-belt-mass", "31")?;
    tab.until("!document.title.startsWith('•')")?;
    // Of different values both are kept, and saved together.
    stage.change("#f-mechanism-belt-mass", "33 kg")?;
    elsewhere("#f-mechanism-belt-pulley_diameter", "81 mm")?;
    tab.click("#save")?;
    tab.holds("#f-mechanism-belt-pulley_diameter", "81")?;
    tab.holds("#f-mechanism-belt-mass", "33")?;
    tab.until("!document.title.startsWith('•')")?;
    // A tab without changes of its own follows.
    elsewhere("#f-mechanism-belt-pulley_diameter", "82 mm")?;
    tab.holds("#f-mechanism-belt-pulley_diameter", "82")?;
    tab.until("!document.title.startsWith('•')")?;
    tab.another()?;
    tab.open(&stage.shell.at("open=shared.toml&lang=en"))?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "33")?;
    tab.holds("#f-mechanism-belt-pulley_diameter", "82")
}

/// Two tabs with the same file keep their unsaved changes apart.
pub(crate) fn drafts_of_two_tabs(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    tab.fill("#file", "twice.toml")?;
    tab.click("#save")?;
    tab.says("#status", "twice.toml")?;
    let first = tab.another()?;
    tab.open(&stage.shell.at("open=twice.toml&lang=en"))?;
    stage.ready()?;
    stage.change("#f-mechanism-belt-mass", "34 kg")?;
    let second = tab.switch_to(first)?;
    stage.change("#f-mechanism-belt-mass", "32 kg")?;
    tab.reload()?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "32")?;
    let first = tab.switch_to(second)?;
    tab.reload()?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "34")?;
    tab.back_to(first)
}

/// Returns a recording with the columns time and angle, as written by a logger.
fn recording() -> String {
    let rows = (0..200)
        .map(|row| f64::from(row) * 0.01)
        .map(|t| format!("{t:.2};{:.4}\n", 45.0 - 45.0 * (t * std::f64::consts::PI).cos()));
    ["t in s;phi in deg\n".to_owned()].into_iter().chain(rows).collect()
}

pub(crate) fn paste_a_recording(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("table", "en")?;
    tab.paste(&recording())?;
    // The columns are shown before the project is changed.
    tab.says("#incoming-columns", "phi in deg")?;
    tab.click("#incoming-use")?;
    tab.says("#text", "file = \"pasted.csv\"")?;
    tab.until("document.querySelector('#text').value.split('[[motion]]').length === 2")?;
    tab.until("document.querySelector('#text').value.includes('law = \"recorded\"')")?;
    if let Some(folder) = stage.shell.folder() {
        expect(folder.join("pasted.csv").is_file(), || "no recording in the folder".to_owned())?;
    }
    // The file is read: a fault, if any, is not a missing file.
    let faults = tab.text("body")?;
    expect(!faults.contains("cannot be read") && !faults.contains("no such file"), || faults)
}

pub(crate) fn download(stage: &OpenPage<'_>) -> Worded {
    stage.example("belt", "en")?;
    let bytes = |path: std::path::PathBuf| std::fs::read(path).map_err(|error| error.to_string());
    let workbook = bytes(stage.download("#workbook", "xlsx")?)?;
    expect(workbook.starts_with(b"PK"), || "no workbook".to_owned())?;
    let data = bytes(stage.download("#data", "json")?)?;
    let data: serde_json::Value = serde_json::from_slice(&data).map_err(|error| error.to_string())?;
    expect(data.get("verdict").is_some(), || format!("no answer: {data}"))?;
    let project = bytes(stage.download("#project", "toml")?)?;
    let text = stage.tab.value("#text")?;
    expect(project == text.as_bytes(), || "another project".to_owned())
}

pub(crate) fn report(stage: &OpenPage<'_>) -> Worded {
    stage.example("belt", "en")?;
    let report = stage.download("#report", "pdf")?;
    let report = std::fs::read(report).map_err(|error| error.to_string())?;
    expect(report.starts_with(b"%PDF"), || "no PDF".to_owned())
}

/// Without a typesetting engine the page names the command that writes the report, and offers no button.
pub(crate) fn no_report(stage: &OpenPage<'_>) -> Worded {
    stage.example("belt", "de")?;
    stage.tab.until("!document.querySelector('#report')")?;
    stage.tab.says("#menu-export", "antrieb report")
}

pub(crate) fn reload(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.change("#f-mechanism-belt-mass", "39 kg")?;
    tab.click("#theme")?;
    tab.until("document.documentElement.dataset.theme === 'dark'")?;
    tab.reload()?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "39")?;
    tab.until("document.documentElement.dataset.theme === 'dark'")
}

pub(crate) fn no_network(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.start("en")?;
    tab.until("(await navigator.serviceWorker.ready).active?.state === 'activated'")?;
    // From the next load on the service worker answers for the page.
    tab.reload()?;
    tab.until("navigator.serviceWorker.controller")?;
    tab.offline(true)?;
    tab.open(&stage.shell.at("new=belt&lang=en"))?;
    stage.ready()?;
    stage.change("#f-mechanism-belt-mass", "52 kg")?;
    tab.offline(false)
}

pub(crate) fn opened_as_a_file(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    let Shell::Site { folder, .. } = stage.shell else { return Err("a page that is served is not a file".to_owned()) };
    let index = folder.join("index.html").canonicalize().map_err(|error| error.to_string())?;
    tab.open(&format!("file://{}?new=belt&lang=en", index.display()))?;
    stage.ready()?;
    stage.change("#f-mechanism-belt-mass", "53 kg")?;
    tab.says("#text", "53 kg")?;
    tab.fill("#file", "of-a-file.toml")?;
    tab.click("#save")?;
    tab.says("#status", "of-a-file.toml")?;
    tab.open(&format!("file://{}?lang=en", index.display()))?;
    tab.click("a[href*=\"open=of-a-file.toml\"]")?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "53")
}

pub(crate) fn forget(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    expect(matches!(stage.shell, Shell::Site { .. }), || "a folder of the disk is not emptied here".to_owned())?;
    stage.example("belt", "en")?;
    tab.click("#save")?;
    tab.says("#status", "axis.toml")?;
    tab.fill("#file", "other.toml")?;
    tab.click("#save")?;
    tab.says("#status", "other.toml")?;
    stage.start("en")?;
    // The focus goes on to the next file, and behind the last one to what opens a file.
    tab.click("[data-forget=\"axis.toml\"]")?;
    tab.until("!document.querySelector('[data-forget=\"axis.toml\"]')")?;
    tab.until("document.activeElement.dataset.forget === 'other.toml'")?;
    tab.click("[data-forget=\"other.toml\"]")?;
    tab.until("!document.querySelector('[data-forget]')")?;
    tab.until("'open' in document.activeElement.dataset")?;
    tab.reload()?;
    tab.there("#start-title")?;
    tab.until("!document.querySelector('[data-forget]')")
}
