//! Scenarios with the tools of an axis, and with a further axis.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect};

/// Bodies are entered in rows, drawn as they are typed, and fill the field beside which the tool was opened.
pub(crate) fn inertia_fills_its_field(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    tab.click("#f-mechanism-arm-inertia-b")?;
    tab.there("#body-0")?;
    let choose = |field: &str, value: &str| {
        let script = "const [field, value] = arguments_; const found = document.querySelector(field); found.value = value; \
            found.dispatchEvent(new Event('change', { bubbles: true }));";
        tab.run(script, vec![field.into(), value.into()])
    };
    let _ = choose("#t-shape-0", "disc")?;
    tab.there("#t-diameter-0")?;
    tab.fill("#t-diameter-0", "200")?;
    tab.fill("#t-length-0", "20")?;
    tab.fill("#t-mass-0", "5")?;
    tab.there("#bodies-drawing circle")?;
    tab.says("#fill-inertia", "0.025 kgm²")?;
    let _ = choose("#t-shape-1", "point")?;
    tab.there("#t-distance-1")?;
    tab.fill("#t-mass-1", "1")?;
    tab.fill("#t-distance-1", "100")?;
    tab.says("#fill-inertia", "0.035 kgm²")?;
    stage.accessible("bodies of a moment of inertia")?;
    tab.click("#fill-inertia")?;
    tab.until("document.querySelector('#text').value.includes('inertia = \"0.035 kg m^2\"')")?;
    tab.holds("#f-mechanism-arm-inertia", "0.035")?;
    tab.until("!document.querySelector('#detail').firstElementChild")?;
    tab.click("#undo")?;
    tab.holds("#f-mechanism-arm-inertia", "0.55")
}

/// An axis is added to the file; each axis has its tab, and all of them together their power over time.
pub(crate) fn a_further_axis(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    tab.click("#new-axis")?;
    tab.click("#further-4")?;
    tab.there("#begin form")?;
    for (field, value) in [("pulley_diameter", "80"), ("mass", "12")] {
        tab.fill(&format!("#f-mechanism-belt-{field}"), value)?;
    }
    for (field, value) in [("1--distance", "500"), ("1--time", "1"), ("2--time", "1")] {
        tab.fill(&format!("#begin #f-motion-{field}"), value)?;
    }
    tab.click("#begin form button[type=submit]")?;
    tab.there("#axis-1[aria-current]")?;
    tab.says("#text", "[[axis]]")?;
    tab.until("document.querySelector('#standing')?.textContent.includes('CHA-')")?;
    tab.click("#view-wiring")?;
    tab.until("document.querySelector('#tool-view')?.textContent.includes(document.querySelector('#standing strong.code').textContent.trim())")?;
    let first = tab.text("#standing strong.code")?;
    tab.click("#axis-0")?;
    tab.there("#axis-0[aria-current]")?;
    tab.until("document.querySelector('#tool-view')?.textContent.includes(document.querySelector('#standing strong.code').textContent.trim())")?;
    let second = tab.text("#standing strong.code")?;
    expect(first != second, || format!("both axes have {first}"))?;
    tab.click("#axis-all")?;
    tab.there("#power-of-axes svg")?;
    stage.accessible("all axes")
}

/// A download has the name of the project.
pub(crate) fn names_of_downloads(stage: &OpenPage<'_>) -> Worded {
    stage.example("belt", "en")?;
    // A project without a name of its own has that of its axis.
    let path = stage.download("#workbook", "xlsx")?;
    let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    expect(name.starts_with("belt-axis"), || name.clone())?;
    stage.tab.fill("#file", "my lift.toml")?;
    for (button, ending) in [("#workbook", "xlsx"), ("#data", "json")] {
        let path = stage.download(button, ending)?;
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        expect(name.starts_with("my-lift") && name.ends_with(ending), || name.clone())?;
    }
    Ok(())
}
