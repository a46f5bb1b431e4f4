//! Times and transferred sizes; printed, and compared with their limits.

use crate::shell::Shell;
use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write;

/// Number of keys pressed.
const KEYS: usize = 40;

/// Maximum size of the page, its style and scripts as packed by hosts \[bytes\].
const WEIGHT_MOST: usize = 100_000;

pub(crate) fn times(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    let address = stage.shell.at("new=table&lang=en");
    tab.open(&address)?;
    stage.ready()?;
    // Repeated with warm caches, so that the page is measured and not the first disk access.
    let mut opened = Vec::new();
    let mut painted = Vec::new();
    for _ in 0..3 {
        tab.open("about:blank")?;
        tab.open(&address)?;
        stage.ready()?;
        painted.push(number(&tab.eval("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? -1")?));
        // The verdict is present when the script has filled in the values below it.
        opened.push(number(&tab.eval("performance.getEntriesByName('antrieb-answered')[0]?.startTime ?? performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd")?));
    }
    tab.open(&stage.shell.at("new=manual&lang=en"))?;
    stage.ready()?;
    let (half, most, thread) = keys(stage)?;
    let weight = weight(stage)?;
    println!(
        "       {}: first paint {:.0} ms, open to first answer {:.0} ms, key to page of one move {half:.0} ms (95 of 100 within {most:.0} ms){thread}, {} kB gzip",
        stage.shell.name(),
        median(&mut painted),
        median(&mut opened),
        weight / 1000,
    );
    expect(weight <= WEIGHT_MOST, || format!("{weight} bytes"))
}

/// Measures a turntable with its bodies, stage and bearing, whose smooth moves cost more.
pub(crate) fn times_of_a_table(stage: &OpenPage<'_>) -> Worded {
    stage.tab.open(&stage.shell.at("new=table&lang=en"))?;
    stage.ready()?;
    let (half, most, thread) = keys(stage)?;
    println!(
        "       {}: key to page of a table {half:.0} ms (95 of 100 within {most:.0} ms){thread}",
        stage.shell.name()
    );
    Ok(())
}

/// Number of requests beyond one for each key: the size of the picture may change with the lines above it.
const FURTHER_MOST: usize = 10;

/// Measures the time from a key in a field to the updated page: median and 95th percentile \[ms\], and in words the mean time
/// of the main thread. Fails if the page requests more than the keys need.
fn keys(stage: &OpenPage<'_>) -> Worded<(f64, f64, String)> {
    let before = stage.tab.counters()?;
    let script = "const field = document.querySelector('#f-load-inertia') ?? document.querySelector('#fields input'); const taken = []; let works = 0; \
        const count = (event) => { works += event.detail.ctx.request.action.endsWith('/work') ? 1 : 0; }; \
        addEventListener('htmx:before:request', count); \
        for (let key = 0; key < arguments_[0]; key++) { \
          const swapped = new Promise((done) => { const listen = (event) => { \
            if (!event.detail.ctx.request.action.endsWith('/work') || event.detail.ctx.sourceElement.id !== field.id) return; \
            removeEventListener('htmx:after:swap', listen); requestAnimationFrame(() => done(performance.now())); }; \
            addEventListener('htmx:after:swap', listen); }); \
          const begin = performance.now(); \
          field.value = `1.${key + 10} kg m^2`; \
          field.dispatchEvent(new Event('input', { bubbles: true })); \
          taken.push(await swapped - begin); \
          await new Promise((done) => setTimeout(done, 150)); \
        } \
        removeEventListener('htmx:before:request', count); \
        return { taken, works };";
    let found = stage.tab.run(script, vec![serde_json::json!(KEYS)])?;
    let thread = before.zip(stage.tab.counters()?).map_or_else(String::new, |(before, after)| {
        let each = |name: &str| (after.get(name).unwrap_or(&f64::NAN) - before.get(name).unwrap_or(&f64::NAN)) / KEYS as f64;
        let [all, script, style, layout] =
            ["TaskDuration", "ScriptDuration", "RecalcStyleDuration", "LayoutDuration"].map(|name| 1e3 * each(name));
        let [styles, layouts] = ["RecalcStyleCount", "LayoutCount"].map(each);
        format!(
            ", main thread {all:.0} ms a key: script {script:.0}, {styles:.0} styles {style:.1}, {layouts:.0} layouts {layout:.1}"
        )
    });
    let taken = found.get("taken").cloned().unwrap_or_default();
    let works = found.get("works").and_then(serde_json::Value::as_u64).unwrap_or(u64::MAX);
    expect(works <= (KEYS + FURTHER_MOST) as u64, || format!("{works} requests for {KEYS} keys"))?;
    let mut taken: Vec<f64> = taken.as_array().into_iter().flatten().map(number).collect();
    expect(taken.len() == KEYS, || format!("{} of {KEYS} keys answered", taken.len()))?;
    let half = median(&mut taken);
    Ok((half, taken.get(KEYS * 95 / 100).copied().unwrap_or_default(), thread))
}

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// Returns the packed size of the page, its style and its scripts; without the engine of the site, which
/// `cargo xtask site` reports.
fn weight(stage: &OpenPage<'_>) -> Worded<usize> {
    let own: &[&str] = if matches!(stage.shell, Shell::Site { .. }) { &["site.js"] } else { &[] };
    let mut whole = 0;
    let mut add = |bytes: &[u8]| -> Worded {
        let mut packer = GzEncoder::new(Vec::new(), Compression::default());
        packer.write_all(bytes).map_err(|error| error.to_string())?;
        whole += packer.finish().map_err(|error| error.to_string())?.len();
        Ok(())
    };
    let page = stage.tab.run("return await (await fetch('/?new=table&lang=en')).text();", Vec::new())?;
    add(page.as_str().unwrap_or_default().as_bytes())?;
    for name in own.iter().map(|name| (*name).to_owned()).chain(page::ASSETS.map(|(name, _)| format!("assets/{name}")))
    {
        // Without a server `fetch` is answered by the engine, which has no script of its own; an XMLHttpRequest is not.
        let script = "const request = new XMLHttpRequest(); request.open('GET', arguments_[0]); \
            await new Promise((done) => { request.onloadend = done; request.send(); }); \
            return request.status === 200 ? request.responseText : null;";
        let text = stage.tab.run(script, vec![serde_json::json!(name)])?;
        add(text.as_str().ok_or_else(|| format!("{name} is not there"))?.as_bytes())?;
    }
    Ok(whole)
}

/// Number of samples of a long recording.
const LONG: u32 = 100_000;

/// Maximum time of script and layout for one moved instant, in half of the frames \[ms\]: a sixtieth of a second.
const OWN_MOST: f64 = 16.0;

/// A long recording: its numbers appear before its picture, and the instant moves through it with every frame.
pub(crate) fn a_long_recording(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    let folder = stage.shell.folder().ok_or("no folder")?;
    let row = |at: u32| {
        let time = f64::from(at) * 1e-4;
        format!(
            "{time:.4};{:.6}\n",
            45.0 - 45.0 * (0.2 * std::f64::consts::PI * time).cos() + 0.01 * (60.0 * time).sin()
        )
    };
    let csv: String = std::iter::once(String::from("time_s;position_deg\n")).chain((0..=LONG).map(row)).collect();
    let project = "format = 1\n[axis]\nsingle_move = true\n[load]\ninertia = \"1.3 kg m^2\"\n[[motion]]\nlaw = \"recorded\"\nfile = \"long.csv\"\n[requirements]\nsupply = \"560 V\"\n";
    for (name, text) in [("long.csv", csv.as_str()), ("long.toml", project)] {
        std::fs::write(folder.join(name), text).map_err(|error| error.to_string())?;
    }
    tab.open(&stage.shell.at("open=long.toml&lang=en"))?;
    stage.ready()?;
    let torque = "[...document.querySelectorAll('#plot-cycle g.line path')].pop().getAttribute('d')";
    let before = tab.eval(torque)?;
    stage.change("#f-load-inertia", "1.6 kg m^2")?;
    tab.until(&format!("{torque} !== {before}"))?;
    let (half, most, thread) = keys(stage)?;
    // The instant moves at every frame for two seconds, once the picture of the last key is drawn: until then the
    // server occupies one of the cores.
    stage.ready()?;
    let script = "const range = document.querySelector('#instant'); range.focus(); \
        document.querySelector('figure.plot').dispatchEvent(new PointerEvent('pointerdown', { bubbles: true })); \
        await new Promise((done) => setTimeout(done, 1500)); \
        const begin = performance.now(); let frames = 0; const own = []; \
        await new Promise((done) => { const step = (now) => { frames++; range.value = (now - begin) % 1000; \
          const from = performance.now(); range.dispatchEvent(new Event('input', { bubbles: true })); range.getBoundingClientRect(); \
          own.push(performance.now() - from); \
          if (now - begin < 2000) requestAnimationFrame(step); else done(); }; requestAnimationFrame(step); }); \
        own.sort((a, b) => a - b); \
        return [1000 * frames / (performance.now() - begin), own[Math.floor(own.length / 2)]];";
    let moved = tab.run(script, Vec::new())?;
    let [frames, own] = [0, 1].map(|at| moved.get(at).map_or(f64::NAN, number));
    println!(
        "       {}: {LONG} samples: key to numbers {half:.0} ms (95 of 100 within {most:.0} ms){thread}, {frames:.0} frames a second while the instant moves, {own:.1} ms of script and layout each",
        stage.shell.name()
    );
    // The browser's own drawing without a graphics card is not counted.
    expect(own < OWN_MOST, || format!("{own:.1} ms of script and layout for a frame"))
}
