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

/// Holds when the values at the cursor belong to the shown project.
pub(crate) const CURRENT: &str = "document.querySelector('#instant-values')?.dataset.old === undefined";

/// Script that compares the values at the cursor with rows of the exported course, and returns the texts of the rows and
/// the values that differ by more than half of their last digit.
const EXPORTED: &str = "const reply = await fetch('/api/v1/export?table=course&lang=en&format=csv', { method: 'POST', headers: { 'content-type': 'application/toml' }, body: document.querySelector('#text').value }); \
    const rows = (await reply.text()).trim().split('\\n').slice(1).map((row) => row.split(',').map(Number)); \
    const shown = () => [...document.querySelectorAll('#instant-values > span')].map((cell) => cell.children[1].textContent.replace('\\u2212', '-').replaceAll(',', '')); \
    const [mark, texts, off] = [document.querySelector('.mark-number'), [], []]; \
    const at = mark.dataset.instant; \
    for (let row = 0; row < rows.length; row += 7) { \
      const [time, ...values] = rows[row]; \
      if (rows.filter((each) => each[0] === time).length > 1) continue; \
      mark.dataset.instant = String(time); \
      mark.click(); \
      const found = shown(); \
      texts.push(found.join(' ')); \
      [time, ...values.slice(0, 4)].forEach((value, column) => { \
        const last = 10 ** -(found[column].split('.')[1]?.length ?? 0); \
        if (!(Math.abs(Number(found[column]) - value) <= 0.5000001 * last)) off.push(`${found[column]} for ${value} at ${time} s`); \
      }); \
    } \
    mark.dataset.instant = at; \
    return { texts, off };";

/// The values at the cursor are those of the exported course, in windows of any width, whole and narrowed.
pub(crate) fn values_at_the_cursor(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    for example in ["arm", "turntable"] {
        let mut before = None;
        for (width, height) in [(900, 900), (1440, 900), (1920, 1080)] {
            tab.sized(width, height, 1.0)?;
            stage.example(example, "en")?;
            tab.until(CURRENT)?;
            let found = tab.run(EXPORTED, Vec::new())?;
            expect(found["off"].as_array().is_some_and(Vec::is_empty), || {
                format!("{example} at {width}: {}", found["off"])
            })?;
            let texts = found["texts"].as_array().cloned().unwrap_or_default();
            expect(texts.len() > 10, || format!("{example}: {} rows", texts.len()))?;
            expect(before.as_ref().is_none_or(|before| *before == texts), || {
                format!("{example}: other values at {width}")
            })?;
            before = Some(texts);
        }
    }
    // A window of time shows the same numbers.
    let row = "document.querySelector('#instant-values').textContent";
    tab.run("const range = document.querySelector('#instant'); range.value = 300; range.dispatchEvent(new Event('input', { bubbles: true }));", Vec::new())?;
    tab.until(CURRENT)?;
    let numbers = "[...document.querySelectorAll('#instant-values b')].slice(1).map((each) => each.textContent).join()";
    let before = tab.eval(numbers)?;
    tab.click("#zoom-in")?;
    tab.until("document.querySelector('#zoom-out').ariaDisabled !== 'true'")?;
    tab.until(CURRENT)?;
    let (after, whole) = (tab.eval(numbers)?, tab.eval(row)?);
    expect(before == after, || format!("{before} in the whole, {after} in the window: {whole}"))?;
    tab.sized(1440, 900, 1.0)?;
    // A number of five digits is written as everywhere on a German page: a point between them would be read as a decimal one.
    stage.example("arm", "de")?;
    stage.change("#f-mechanism-arm-mass", "4000")?;
    tab.until(CURRENT)?;
    let written = "[...document.querySelectorAll('#instant-values b')].map((each) => each.textContent)";
    let is_plain = "/^−?\\d+(,\\d+)?(·10[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?$/u";
    let found = tab.eval(written)?;
    tab.until(&format!(
        "{written}.every((text) => {is_plain}.test(text)) && {written}.some((text) => /^−?\\d{{4,}}/u.test(text))"
    ))
    .map_err(|error| format!("{found}: {error}"))
}

/// A plane that is not over time has a cursor, by pointer and by keys, with the value of each curve.
pub(crate) fn across_a_plane(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    tab.click("#view-torque_speed")?;
    tab.there("#across-torque-speed")?;
    tab.tab_to("#across-torque-speed")?;
    tab.keys(&key::RIGHT.to_string())?;
    tab.says("#across-torque-speed-values", "continuous limit")?;
    tab.says("#across-torque-speed-values", "39.00")?;
    // The instant moves a point along the cycle.
    tab.until(CURRENT)?;
    let point = "document.querySelector('#plot-torque-speed .cursor-point')?.getAttribute('cy') ?? ''";
    let before = tab.eval(point)?;
    tab.tab_to("#instant")?;
    tab.keys(&key::RIGHT.to_string().repeat(30))?;
    let after = tab.eval(point)?;
    expect(before != after, || format!("the point stays at {before}"))?;
    tab.click("#list-map")?;
    tab.there("#across-map")?;
    tab.tab_to("#across-map")?;
    tab.keys(&key::RIGHT.to_string())?;
    tab.says("#across-map-values", "CHA-")?;
    tab.click("#view-error_budget")?;
    tab.there("#across-torsion")?;
    tab.tab_to("#across-torsion")?;
    tab.keys(&key::RIGHT.to_string())?;
    tab.says("#across-torsion-values", "arcmin")?;
    stage.accessible("cursor in a plane")
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
    tab.until(&format!("Math.abs({shown} - {whole}) < 1e-9"))?;
    // By the wheel around the pointer; the instant stays where it is.
    tab.run("const range = document.querySelector('#instant'); range.value = 40; range.dispatchEvent(new Event('input', { bubbles: true }));", Vec::new())?;
    tab.until(CURRENT)?;
    let row = tab.text("#instant-values b")?;
    let wheel = "const svg = document.querySelector('#plot-cycle .frame > svg'); const box = svg.getBoundingClientRect(); const plane = svg.querySelector('g.plane').dataset; \
        svg.dispatchEvent(new WheelEvent('wheel', { deltaY: -100, ctrlKey: true, clientX: box.left + 0.8 * box.width, clientY: box.top + box.height * (plane.top * 1 + plane.bottom * 1) / 2 / svg.viewBox.baseVal.height, bubbles: true, cancelable: true }));";
    tab.run(wheel, Vec::new())?;
    tab.until(&format!("{shown} < {}", 0.9 * whole))?;
    tab.until(CURRENT)?;
    let number = |text: &str| text.parse::<f64>().map_err(|_| format!("no instant: {text}"));
    let (before, after) = (number(&row)?, number(&tab.text("#instant-values b")?)?);
    expect((before - after).abs() < 1e-3, || format!("the instant moved from {before} to {after}"))?;
    tab.until("document.querySelector('#plot-cycle .cursor-line').style.display === 'none'")
}

/// Typing and dragging leave a cycle closed, in one step of undo; what cannot follow becomes a single move by a button.
pub(crate) fn a_cycle_stays_closed(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    let before = tab.value("#text")?;
    let is = |text: &str| format!("document.querySelector('#text').value === {}", serde_json::json!(text));
    let undone = |what: &str| -> Worded {
        // A pull may have several answers, of which the last one is awaited.
        std::thread::sleep(std::time::Duration::from_millis(300));
        tab.until(
            "!document.querySelector('.htmx-request') && document.querySelector('#undo').ariaDisabled === 'false'",
        )?;
        tab.click("#undo")?;
        tab.until(&is(&before)).map_err(|error| format!("{what}: one step back is not the beginning: {error}"))
    };
    let closed = "!document.querySelector('#demands.old') && !document.querySelector('#faults li')";
    // Key by key, over a value that is none and one that closes by itself.
    stage.change("#f-motion-1--distance", "117.5 deg")?;
    tab.until(closed)?;
    let typed = tab.value("#text")?;
    expect(typed.contains("\"117.5 deg\"") && typed.contains("\"-117.5 deg\""), || typed.clone())?;
    undone("a typed distance")?;
    stage.change("#f-motion-1--time", "0.9 s")?;
    tab.until(closed)?;
    undone("a typed time")?;
    tab.drag("#grip-2", (10, 12))?;
    tab.until(&format!("!({})", is(&before)))?;
    tab.until(closed)?;
    let pulled = tab.value("#text")?;
    expect(!pulled.contains("\"100 deg\"") && !pulled.contains("\"-100 deg\""), || pulled.clone())?;
    undone("a pulled end")?;
    // The peak of the speed changes the time.
    tab.drag("#peak-0", (0, -6))?;
    tab.until(&format!("!({})", is(&before)))?;
    tab.until(closed)?;
    let peak = tab.value("#text")?;
    expect(peak.contains("\"100 deg\"") && !peak.contains("time = \"1.2 s\""), || peak.clone())?;
    undone("a pulled peak")?;
    // Without a way back.
    tab.click("#f-motion-3--e button[hx-vals*='gone motion[3]']")?;
    tab.there("#single-move")?;
    expect(tab.eval("document.querySelector('#way-back') === null")? == serde_json::Value::Bool(true), || {
        "a way back is offered".to_owned()
    })?;
    tab.click("#single-move")?;
    tab.until(closed)?;
    tab.says("#text", "single_move = true")
}

/// Rows of a spreadsheet are pasted into the table of the segments, and all their faults are shown.
pub(crate) fn rows_are_pasted(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    let paste = |text: &str| -> Worded {
        let script = "const cell = document.querySelector('#f-motion-1--distance'); cell.focus(); const data = new DataTransfer(); data.setData('text/plain', arguments_[0]); \
            cell.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, data: arguments_[0], dataType: 'text/plain', bubbles: true, cancelable: true }));";
        tab.run(script, vec![serde_json::json!(text)]).map(|_| ())
    };
    paste("60\t0.7 s\n\t1 s\n-60\t0.8 s\n")?;
    tab.says("#text", "-60 deg")?;
    tab.until("!document.querySelector('#demands.old') && !document.querySelector('#faults li')")?;
    tab.holds("#f-motion-3--time", "0.8 s")?;
    paste(
        "Motion law\tDistance [deg]\tTime [s]\ntrapezoid\t45\t0.5\nmodified sine\t30\t0.4\ndwell\t\t1\npolynomial 3-4-5\t-75\t0.9\n",
    )?;
    tab.until("document.querySelectorAll('.segment-line[data-row]').length === 4")?;
    tab.until("!document.querySelector('#demands.old') && !document.querySelector('#faults li')")?;
    paste("far\tsoon\n1 kg\t2 s\n")?;
    tab.until("document.querySelectorAll('.segment-line [aria-invalid]').length === 3")?;
    stage.accessible("table of segments")
}

/// A gain is changed where its effect is seen, and a kept run stays beside the next one.
pub(crate) fn two_runs(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    let before = tab.value("#text")?;
    tab.click("#view-simulation")?;
    tab.there("#run-figures")?;
    tab.until(CURRENT)?;
    let field = "#gain-f-twin-position_gain";
    let used = tab.value(field)?;
    expect(used.parse::<f64>().is_ok_and(|gain| gain > 0.0), || format!("the gain in use: {used}"))?;
    let figure = |column: u8| {
        format!("document.querySelector('#run-figures tbody tr:nth-child(2) td:nth-child({column})').textContent")
    };
    let first = tab.eval(&figure(2))?;
    tab.click("#keep-run")?;
    tab.until(&format!("{} === {first}", figure(3)))?;
    tab.there("#plot-simulation .kept-run")?;
    let slide = "const range = document.querySelector('#gain-f-twin-position_gain-r'); range.value = Number(range.min) + 0.3; range.dispatchEvent(new Event('input', { bubbles: true }));";
    tab.run(slide, Vec::new())?;
    tab.says("#text", "position_gain = ")?;
    // The ranges of the kept run belong to the picture, not to the values of the file.
    tab.until("!document.querySelector('#text').value.includes('±')")?;
    tab.until(&format!("{} !== {first}", figure(2)))?;
    tab.until(&format!("{} === {first}", figure(3)))?;
    tab.there("#plot-simulation .kept-run")?;
    stage.accessible("two runs")?;
    tab.click("#gain-f-twin-position_gain-d")?;
    tab.until(&format!("document.querySelector('{field}').value === {}", serde_json::json!(used)))?;
    tab.until(&format!("{} === {first}", figure(2)))?;
    tab.click("#keep-run")?;
    tab.until("!document.querySelector('.kept-run')")?;
    // Tables are folded by subject.
    tab.until("document.querySelectorAll('#view details.subject').length > 3 && !document.querySelector('#view details.subject[open]')")?;
    expect(!before.contains("position_gain"), || before)
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
