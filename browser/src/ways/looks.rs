//! Scenarios of layout and accessibility.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect, key};

/// Narrow, common and wide windows, and double scale, without horizontal scrolling.
pub(crate) fn widths(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    for language in ["en", "de"] {
        for (width, height, scale) in [(375, 800, 1.0), (1280, 800, 1.0), (1920, 1080, 1.0), (640, 400, 2.0)] {
            let what = |page: &str| format!("{page}, {language}, {width} px at {scale}");
            tab.sized(width, height, scale)?;
            stage.start(language)?;
            stage.no_sideways_scroll(&what("start"))?;
            stage.example("belt", language)?;
            stage.no_sideways_scroll(&what("main"))?;
            stage.unfold()?;
            tab.click("#check-peak_torque button.plain")?;
            tab.there("#detail .formula")?;
            stage.no_sideways_scroll(&what("detail"))?;
        }
    }
    Ok(())
}

/// The printed page has verdict, diagram, ranking and values, also on the width of a sheet, and no controls.
pub(crate) fn on_paper(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    tab.sized(680, 960, 1.0)?;
    tab.on_paper(true)?;
    let is_shown = |selector: &str| tab.eval(&format!("document.querySelector('{selector}').checkVisibility()"));
    for shown in ["#standing", "#demands figure.plot svg", "#fits table.ranking", "#f-mechanism-belt-mass"] {
        expect(is_shown(shown)? == serde_json::Value::Bool(true), || format!("{shown} is not printed"))?;
    }
    for hidden in ["#head .bar", "#demands .views", ".plot-tools"] {
        expect(is_shown(hidden)? == serde_json::Value::Bool(false), || format!("{hidden} is printed"))?;
    }
    let [height, below] = ["#demands figure.plot svg", "#work"]
        .map(|selector| tab.eval(&format!("document.querySelector('{selector}').getBoundingClientRect().height")));
    let (height, below) = (height?.as_f64().unwrap_or_default(), below?.as_f64().unwrap_or_default());
    expect(height > 200.0 && below > height, || format!("the diagram is {height} px high, the page {below}"))?;
    tab.on_paper(false)
}

/// Accessibility of the start page, the main page, a fault, details, comparison and tools, in light and dark.
pub(crate) fn accessibility(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    tab.sized(1280, 900, 1.0)?;
    stage.start("en")?;
    stage.accessible("start")?;
    stage.example("belt", "en")?;
    for look in ["light", "dark"] {
        let what = |page: &str| format!("{page}, {look}");
        stage.accessible(&what("main"))?;
        stage.unfold()?;
        tab.click("#check-peak_torque button.plain")?;
        tab.there("#detail .formula")?;
        stage.accessible(&what("detail"))?;
        tab.click("#tools")?;
        tab.there("#detail [name=about], #detail input")?;
        stage.accessible(&what("tools"))?;
        tab.keys(&key::ESCAPE.to_string())?;
        stage.change("#f-mechanism-belt-mass", "sixty")?;
        stage.accessible(&what("fault"))?;
        stage.change("#f-mechanism-belt-mass", "60 kg")?;
        if look == "light" {
            tab.click("#theme")?;
            tab.until("document.documentElement.dataset.theme === 'dark'")?;
        }
    }
    for place in [1, 2] {
        let mark = tab.eval(&format!("[...document.querySelectorAll('input[name=mark]')][{place}].id"))?;
        let mark = mark.as_str().unwrap_or_default().to_owned();
        expect(!mark.is_empty(), || "nothing to compare".to_owned())?;
        tab.click(&format!("#{mark}"))?;
        tab.until(&format!("document.querySelector('#{mark}')?.dataset.checked === 'true'"))?;
    }
    tab.click("[hx-post='/compare']")?;
    tab.says("#detail", "CHA-")?;
    stage.accessible("compare, dark")
}
