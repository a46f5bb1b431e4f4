//! Times and transferred sizes; printed, and compared with their limits.

use crate::shell::Shell;
use crate::stage::Stage;
use crate::tab::{Worded, expect};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::io::Write;

/// Keys that are pressed.
const KEYS: usize = 15;

/// The page before it listens: what a browser fetches at first, packed as hosts do.
const WEIGHT_MOST: usize = 350_000;

pub(crate) fn times(stage: &Stage<'_>) -> Worded {
    let tab = &stage.tab;
    let address = stage.shell.at("new=table&lang=en");
    tab.open(&address)?;
    stage.ready()?;
    // Once more with warm caches: the result is the page, not the first disk access.
    let mut opened = Vec::new();
    let mut painted = Vec::new();
    for _ in 0..3 {
        tab.open("about:blank")?;
        tab.open(&address)?;
        stage.ready()?;
        painted.push(number(&tab.eval("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? -1")?));
        // The verdict is there when the script has filled in the values below it.
        opened.push(number(&tab.eval("performance.getEntriesByName('antrieb-answered')[0]?.startTime ?? performance.getEntriesByType('navigation')[0].domContentLoadedEventEnd")?));
    }
    tab.open(&stage.shell.at("new=manual&lang=en"))?;
    stage.ready()?;
    let (half, slowest) = keys(stage)?;
    let weight = weight(stage)?;
    println!(
        "       {}: first paint {:.0} ms, open to first answer {:.0} ms, key to page of one move {half:.0} ms (slowest {slowest:.0} ms), {} kB gzip",
        stage.shell.name(),
        median(&mut painted),
        median(&mut opened),
        weight / 1000,
    );
    expect(weight <= WEIGHT_MOST, || format!("{weight} bytes"))
}

/// The same of a turntable with its bodies, stage and bearing, whose smooth moves cost more.
pub(crate) fn times_of_a_table(stage: &Stage<'_>) -> Worded {
    stage.tab.open(&stage.shell.at("new=table&lang=en"))?;
    stage.ready()?;
    let (half, slowest) = keys(stage)?;
    println!("       {}: key to page of a table {half:.0} ms (slowest {slowest:.0} ms)", stage.shell.name());
    Ok(())
}

/// From a key in a field to the page that shows what follows: half of the times, and the
/// longest \[ms\].
fn keys(stage: &Stage<'_>) -> Worded<(f64, f64)> {
    let script = "const field = document.querySelector('#f-load-inertia') ?? document.querySelector('#fields input'); const taken = []; \
        for (let key = 0; key < arguments_[0]; key++) { \
          const swapped = new Promise((done) => addEventListener('htmx:after:swap', () => requestAnimationFrame(() => done(performance.now())), { once: true })); \
          const begin = performance.now(); \
          field.value = `1.${key + 10} kg m^2`; \
          field.dispatchEvent(new Event('input', { bubbles: true })); field.dispatchEvent(new Event('change', { bubbles: true })); \
          taken.push(await swapped - begin); \
          await new Promise((done) => setTimeout(done, 150)); \
        } return taken;";
    let taken = stage.tab.run(script, vec![serde_json::json!(KEYS)])?;
    let mut taken: Vec<f64> = taken.as_array().into_iter().flatten().map(number).collect();
    expect(taken.len() == KEYS, || format!("{} of {KEYS} keys answered", taken.len()))?;
    let half = median(&mut taken);
    Ok((half, taken.last().copied().unwrap_or_default()))
}

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
}

/// The page, its style and its scripts, packed; of the site without the engine, which `cargo xtask site` reports.
fn weight(stage: &Stage<'_>) -> Worded<usize> {
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
    for name in own.iter().map(|name| (*name).to_owned()).chain(page::ASSETS.map(|name| format!("assets/{name}"))) {
        let script = "const answer = await fetch(arguments_[0]); return answer.ok ? await answer.text() : null;";
        let text = stage.tab.run(script, vec![serde_json::json!(name)])?;
        add(text.as_str().ok_or_else(|| format!("{name} is not there"))?.as_bytes())?;
    }
    Ok(whole)
}
