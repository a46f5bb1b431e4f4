//! Scenarios of the page frame: panes, verdict, palette, links, and unsaved work.

use super::typed;
use crate::stage::OpenPage;
use crate::tab::{Worded, expect, key};
use serde_json::json;

/// Verdict, sketch, first plot and the five best codes are visible without scrolling in a window of common size.
pub(crate) fn in_sight(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    for language in ["en", "de"] {
        for (width, height) in [(1440, 900), (1280, 800), (1920, 1080)] {
            tab.sized(width, height, 1.0)?;
            stage.example("belt", language)?;
            let codes = (1..=5).map(|row| format!("table.ranking tbody:nth-of-type({row}) td.code"));
            let sought: Vec<String> = ["#standing", "#tightest", "figure.sketch svg", "#plot-cycle .frame"]
                .map(str::to_owned)
                .into_iter()
                .chain(codes)
                .collect();
            let script = "return arguments_[0].filter((each) => { const box = document.querySelector(each)?.getBoundingClientRect(); \
                return !box || box.height === 0 || box.top < 0 || box.bottom > innerHeight + 1 || box.left < 0 || box.right > innerWidth + 1; });";
            // The picture fills its pane once the size is known.
            tab.until("Math.abs(document.querySelector('#plot-cycle .frame').clientWidth - document.querySelector('#plot-cycle').dataset.width) < 8")?;
            let hidden = tab.run(script, vec![json!(sought)])?;
            expect(hidden == json!([]), || format!("{language}, {width} × {height}: out of sight: {hidden}"))?;
            let wide = tab.eval("(() => { const list = document.querySelector('#list'); return list.scrollWidth - list.clientWidth; })()")?;
            expect(wide.as_f64().is_some_and(|wide| wide < 1.0), || {
                format!("{language}, {width} × {height}: the list is {wide} px wider than its pane")
            })?;
            let scrolls = tab.eval("document.documentElement.scrollHeight > innerHeight + 1")?;
            expect(scrolls == json!(false), || format!("{language}, {width} × {height}: the window scrolls"))?;
        }
    }
    Ok(())
}

/// A narrow window has three tabs, and a count in the bar leads to its check.
pub(crate) fn narrow(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    tab.sized(375, 800, 1.0)?;
    stage.example("belt", "en")?;
    let shown = |pane: &str| format!("getComputedStyle(document.querySelector('{pane}')).display !== 'none'");
    tab.until(&format!("{} && !({})", shown("#moves"), shown("#demands")))?;
    tab.click("button[data-pane=\"2\"]")?;
    tab.until(&format!("{} && !({})", shown("#demands"), shown("#moves")))?;
    tab.click("#tightest")?;
    tab.until(&shown("#fits"))?;
    tab.there("#checks")
}

/// A border is moved by keys, and keeps its place at the next visit.
pub(crate) fn a_border_is_moved(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let wide = "Math.round(document.querySelector('#moves').getBoundingClientRect().width)";
    let before = tab.eval(wide)?.as_f64().unwrap_or_default();
    tab.run("document.querySelector('#border-1').focus();", Vec::new())?;
    tab.keys(&key::RIGHT.to_string().repeat(3))?;
    tab.until(&format!("{wide} > {}", before + 40.0))?;
    stage.example("belt", "en")?;
    tab.until(&format!("{wide} > {}", before + 40.0))
}

/// The palette finds a key behind a closed fold, a check and a code.
pub(crate) fn the_palette_finds(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    tab.run("document.activeElement.blur();", Vec::new())?;
    tab.keys("/")?;
    tab.there("#palette input")?;
    tab.keys("torsion_max")?;
    tab.there("#palette [data-found=key]")?;
    tab.keys(&key::ENTER.to_string())?;
    tab.until("document.activeElement.id === 'f-requirements-torsion_max'")?;
    tab.run("document.activeElement.blur();", Vec::new())?;
    tab.keys("/")?;
    tab.keys("peak torque")?;
    tab.there("#palette [data-found=check]")?;
    tab.click("#palette [data-found=check]")?;
    tab.until("document.activeElement.closest('#check-peak_torque') !== null")?;
    tab.run("document.activeElement.blur();", Vec::new())?;
    tab.keys("/")?;
    tab.keys("25a-50")?;
    tab.there("#palette [data-found=code]")?;
    tab.click("#palette [data-found=code]")?;
    tab.says("#standing", "CHA-25A-50")
}

/// A number takes the unit next to it, a comma is decimal in German, and another unit states the same value.
pub(crate) fn numbers_and_units(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "de")?;
    stage.change("#f-mechanism-belt-mass", "17,5")?;
    tab.says("#text", "mass = \"17.5 kg\"")?;
    tab.holds("#f-mechanism-belt-mass", "17,5")?;
    tab.run(
        "const unit = document.querySelector('#f-mechanism-belt-mass-u'); unit.focus(); unit.value = 'g'; unit.dispatchEvent(new Event('change', { bubbles: true }));",
        Vec::new(),
    )?;
    tab.says("#text", "mass = \"17500 g\"")?;
    tab.holds("#f-mechanism-belt-mass", "17500")
}

/// A link opens the same state in a browser without stored data, for a project begun from a tile too.
pub(crate) fn a_link_of_a_tile(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    typed::screw(stage)?;
    let mass = "#f-mechanism-screw-mass";
    stage.change(mass, "33 kg")?;
    tab.says("#text", "33 kg")?;
    let text = tab.value("#text")?;
    tab.click("#link")?;
    tab.until("location.hash.startsWith('#p=')")?;
    let address = tab.eval("location.href")?.as_str().unwrap_or_default().to_owned();
    // The token is the access of the browser to this server, not knowledge of the project.
    tab.run(
        "const token = localStorage.getItem('antrieb-token'); sessionStorage.clear(); localStorage.clear(); if (token !== null) localStorage.setItem('antrieb-token', token);",
        Vec::new(),
    )?;
    tab.open("about:blank")?;
    tab.open(&address)?;
    stage.ready()?;
    tab.until(&format!("document.querySelector('#text')?.value === {}", json!(text)))
}

/// Unsaved work is restored after a reload, and offered after a new start.
pub(crate) fn unsaved_work_stays(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.change("#f-mechanism-belt-mass", "39 kg")?;
    tab.until("document.querySelector('#file-state').textContent.includes('changed')")?;
    tab.reload()?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "39")?;
    stage.start("en")?;
    tab.click("#unsaved li button")?;
    stage.ready()?;
    tab.holds("#f-mechanism-belt-mass", "39")?;
    // Of a file of the folder it is offered where the file is opened.
    tab.fill("#file", "kept.toml")?;
    tab.click("#save")?;
    tab.says("#status", "kept.toml")?;
    stage.change("#f-mechanism-belt-mass", "40 kg")?;
    stage.start("en")?;
    tab.open(&stage.shell.at("open=kept.toml&lang=en"))?;
    tab.says("#draft", "kept.toml")?;
    tab.click("#draft button")?;
    tab.holds("#f-mechanism-belt-mass", "40")
}

/// The page reports a missing answer within seconds, and applies the values typed meanwhile once the connection is
/// back.
pub(crate) fn no_answer(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    tab.offline(true)?;
    tab.until("document.documentElement.dataset.away !== undefined")?;
    tab.says("#status", "No answer")?;
    // What is typed meanwhile in several fields is sent when antrieb answers again; until then the message stays.
    tab.fill("#f-mechanism-belt-mass", "33 kg")?;
    tab.fill("#f-mechanism-belt-pulley_diameter", "81 mm")?;
    std::thread::sleep(std::time::Duration::from_millis(400));
    tab.offline(false)?;
    tab.says("#text", "33 kg")?;
    tab.says("#text", "81 mm")?;
    tab.until("document.documentElement.dataset.away === undefined")?;
    // It is in the draft too, for a window that is closed before.
    tab.offline(true)?;
    tab.until("document.documentElement.dataset.away !== undefined")?;
    tab.fill("#f-mechanism-belt-mass", "34 kg")?;
    tab.until("Object.values(localStorage).some((draft) => draft.includes('34 kg'))")?;
    tab.open("about:blank")?;
    tab.offline(false)?;
    stage.start("en")?;
    tab.click("#unsaved li button")?;
    stage.ready()?;
    tab.says("#text", "34 kg")?;
    tab.says("#text", "81 mm")
}

/// Two axes that were never saved do not share their unsaved work; the start page lists both, and each goes on under its own name.
pub(crate) fn drafts_of_new_axes(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("screw", "en")?;
    stage.change("#f-mechanism-screw-mass", "77 kg")?;
    let first = tab.another()?;
    stage.example("arm", "en")?;
    stage.change("#f-mechanism-arm-mass", "8 kg")?;
    tab.back_to(first)?;
    tab.reload()?;
    stage.ready()?;
    tab.holds("#f-mechanism-screw-mass", "77")?;
    let listed = "[...document.querySelectorAll('#unsaved li')].map((row) => row.textContent).join()";
    stage.start("en")?;
    tab.until(&format!("{listed}.includes('screw') && {listed}.includes('arm')"))?;
    tab.run(
        "[...document.querySelectorAll('#unsaved li')].find((row) => row.textContent.includes('arm')).querySelector('button').click();",
        Vec::new(),
    )?;
    stage.ready()?;
    tab.holds("#f-mechanism-arm-mass", "8")?;
    tab.until("document.title.startsWith('•')")?;
    // Once saved it is no longer listed, and its address is that of the file.
    tab.fill("#file", "arm.toml")?;
    tab.click("#save")?;
    tab.says("#status", "arm.toml")?;
    tab.until("location.search.includes('open=arm.toml')")?;
    tab.reload()?;
    stage.ready()?;
    tab.holds("#f-mechanism-arm-mass", "8")?;
    stage.start("en")?;
    tab.until(&format!("{listed}.includes('screw') && !{listed}.includes('arm')"))?;
    tab.run("document.querySelector('#unsaved li button:last-child').click();", Vec::new())?;
    tab.until("document.querySelector('#unsaved').hidden")
}

/// File names as typed by users: a name in use is reported, a deleted file is written anew.
pub(crate) fn names_of_files(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    tab.fill("#file", "my axis")?;
    tab.click("#save")?;
    tab.says("#status", "my-axis.toml")?;
    tab.holds("#file", "my-axis.toml")?;
    stage.example("belt", "en")?;
    stage.change("#f-mechanism-belt-mass", "21 kg")?;
    tab.fill("#file", "my-axis.toml")?;
    tab.click("#save")?;
    tab.says("#status", "already exists")?;
    if let Some(folder) = stage.shell.folder() {
        tab.open(&stage.shell.at("open=my-axis.toml&lang=en"))?;
        stage.ready()?;
        std::fs::remove_file(folder.join("my-axis.toml")).map_err(|error| error.to_string())?;
        stage.change("#f-mechanism-belt-mass", "22 kg")?;
        tab.click("#save")?;
        tab.says("#status", "Saved: my-axis.toml")?;
        expect(folder.join("my-axis.toml").is_file(), || "nothing was written".to_owned())?;
    }
    Ok(())
}

/// Versions of the session restore an earlier state, and name their changes.
pub(crate) fn versions(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let before = tab.value("#text")?;
    stage.change("#f-mechanism-belt-mass", "41 kg")?;
    stage.change("#f-mechanism-belt-mass", "42 kg")?;
    tab.click("#versions")?;
    tab.says("#detail", "41 kg → 42 kg")?;
    tab.click("#detail div.entry [data-version]")?;
    tab.until(&format!("document.querySelector('#text').value === {}", json!(before)))
}

/// The curves of a picture as computed.
pub(crate) fn curves(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "de")?;
    let script = "const body = new URLSearchParams(new FormData(document.querySelector('#state'))); \
        return await (await fetch('/curves', { method: 'POST', body })).text();";
    let text = tab.run(script, Vec::new())?;
    let text = text.as_str().unwrap_or_default();
    let mut lines = text.lines();
    let heads = lines.next().unwrap_or_default();
    expect(heads.starts_with("t [s]\tx [mm]"), || format!("heads: {heads}"))?;
    let number = |cell: &str| cell.replace(',', ".").parse::<f64>();
    let rows: Vec<Vec<f64>> = lines
        .take_while(|line| !line.is_empty())
        .map(|line| line.split('\t').filter_map(|cell| number(cell).ok()).collect())
        .collect();
    let far = rows.iter().map(|row| row.get(1).copied().unwrap_or_default()).fold(0.0, f64::max);
    expect((far - 800.0).abs() < 1e-9 && rows.len() > 20, || format!("{} rows, {far} mm at most", rows.len()))
}

/// A simulated scenario next to the sizing, and the signals of an encoder.
pub(crate) fn the_twin(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("table", "en")?;
    tab.click("#view-simulation")?;
    tab.there("#plot-simulation")?;
    tab.says("#view", "Sizing")?;
    tab.run("const choice = document.querySelector('#scenario'); choice.value = 'emergency_stop'; choice.dispatchEvent(new Event('change', { bubbles: true }));", Vec::new())?;
    tab.says("#view", "Emergency stop")?;
    stage.accessible("simulation")?;
    tab.open(&stage.shell.at("tool=encoder&about=CHA-17A-100-H-M128S&lang=en"))?;
    tab.says("#tool", "EnDat").or_else(|_| tab.says("#tool", "SSI"))?;
    stage.accessible("encoder")
}

/// Number of clicks and entries to a first answer of a recording.
pub(crate) fn actions_to_an_answer(stage: &OpenPage<'_>) -> Worded {
    const MOST: usize = 25;
    let tab = &stage.tab;
    // A plain load, its table pasted, the motion replaced; the other beginnings have a scenario of their own.
    let load = typed::load(stage)?;
    let rows: String = (0..=200)
        .map(|row| f64::from(row) * 0.01)
        .map(|t| format!("{t:.2};{:.4}\n", 45.0 - 45.0 * (t * std::f64::consts::PI).cos()))
        .collect();
    tab.there("[data-recording]")?;
    tab.paste(&format!("t in s;phi in deg\n{rows}"))?;
    tab.click("#incoming-use")?;
    tab.until("document.querySelector('#text').value.includes('law = \"recorded\"') && !document.querySelector('#verdict.old')")?;
    let recording = load + 2;
    println!("       {}: actions to a first answer: recording {recording}", stage.shell.name());
    expect(recording <= MOST, || format!("recording: {recording} clicks, entries and choices"))?;
    Ok(())
}

/// A fault is shown without moving the field being edited; if nothing fits, another gearing is proposed.
pub(crate) fn faults_and_proposals(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let top = "Math.round(document.querySelector('#f-mechanism-belt-mass').getBoundingClientRect().top)";
    // In view before it is typed into, so that only the answer could move it.
    tab.run("document.querySelector('#f-mechanism-belt-mass').scrollIntoView({ block: 'center' });", Vec::new())?;
    let before = tab.eval(top)?;
    stage.change("#f-mechanism-belt-mass", "sixty")?;
    tab.says("#faults", "sixty")?;
    let after = tab.eval(top)?;
    expect(before == after, || format!("the field moved from {before} to {after}"))?;
    stage.change("#f-mechanism-belt-mass", "18 kg")?;
    tab.until("!document.querySelector('#faults li')")?;
    stage.start("en")?;
    tab.will_choose("lift.toml", LIFT)?;
    tab.click("[data-open]")?;
    stage.ready()?;
    // Each card says what changes, and a button changes it; undo leads back.
    tab.says(".remedies", "Travel per revolution")?;
    tab.says(".remedies", "Intermediate stage")?;
    let before = tab.value("#text")?;
    tab.click(".remedy button")?;
    tab.until("document.querySelector('#verdict').matches(':not(.fail)') && !document.querySelector('.remedies')")?;
    tab.click("#undo")?;
    tab.until(&format!("document.querySelector('#text').value === {}", json!(before)))
}

/// A lift whose lead suits no actuator.
const LIFT: &str = "format = 1\n[mechanism.screw]\nlead = \"20 mm\"\nmass = \"60 kg\"\ninclination = \"90 deg\"\n\
    [[motion]]\nlaw = \"trapezoid\"\ndistance = \"300 mm\"\ntime = \"2 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
    [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-300 mm\"\ntime = \"2 s\"\n[[motion]]\nlaw = \"dwell\"\ntime = \"1 s\"\n\
    [requirements]\nsupply = \"560 V\"\n";
