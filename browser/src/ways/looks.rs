//! Scenarios of layout and accessibility.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect, key};

/// Narrow, common and wide windows, and double scale, without horizontal scrolling.
pub(crate) fn widths(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    for language in ["en", "de"] {
        for (width, height, scale) in
            [(375, 800, 1.0), (1024, 768, 1.0), (1280, 800, 1.0), (1920, 1080, 1.0), (640, 400, 2.0)]
        {
            let what = |page: &str| format!("{page}, {language}, {width} px at {scale}");
            tab.sized(width, height, scale)?;
            stage.start(language)?;
            stage.no_sideways_scroll(&what("start"))?;
            stage.example("belt", language)?;
            stage.no_sideways_scroll(&what("main"))?;
            stage.unfold()?;
            let beyond = tab.eval(
                "document.querySelector('#checks table').getBoundingClientRect().right - document.querySelector('#fits').getBoundingClientRect().right",
            )?;
            expect(beyond.as_f64().is_some_and(|beyond| beyond <= 0.5), || {
                format!("{}: checks {beyond} px beyond", what("main"))
            })?;
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

/// The command and the key print the first page of the report instead of the window.
pub(crate) fn first_page(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "de")?;
    tab.run("window.prints = 0; window.print = () => { window.prints += 1; };", Vec::new())?;
    let code = tab.text("#standing strong.code")?;
    for (count, press) in [
        (1, "document.querySelector('#print').click();"),
        (2, "window.dispatchEvent(new KeyboardEvent('keydown', { key: 'p', ctrlKey: true, cancelable: true }));"),
    ] {
        tab.run(press, Vec::new())?;
        tab.until(&format!("window.prints === {count}"))?;
        let page = tab.eval("document.querySelector('#paper').textContent")?;
        let page = page.as_str().unwrap_or_default();
        for word in [code.as_str(), "Auslegungsbericht", "Maßgebender Nachweis", "Freigegeben"] {
            expect(page.contains(word), || format!("no {word} on {page}"))?;
        }
        tab.run("window.dispatchEvent(new Event('afterprint'));", Vec::new())?;
        tab.until("document.querySelector('#paper') === null")?;
    }
    Ok(())
}

/// Accessibility of the states of the gallery, in light and dark.
pub(crate) fn accessibility(stage: &OpenPage<'_>) -> Worded {
    for state in &page::STATES {
        for theme in ["light", "dark"] {
            let other = state.query.contains("theme=") && theme == "light";
            let more = if state.query.contains("theme=") { String::new() } else { format!("&theme={theme}") };
            if other {
                continue;
            }
            crate::ways::screens::opened(stage, state, &format!("{more}&lang=en"))?;
            stage.accessible(&format!("{}, {theme}", state.name))?;
        }
    }
    Ok(())
}

/// Height above the panes on a phone: the name, one row of controls and two rows of the verdict; symbols of a drawing are legible in every
/// window.
pub(crate) fn a_phone(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    for language in ["en", "de"] {
        tab.sized(375, 812, 1.0)?;
        stage.example("arm", language)?;
        let top =
            tab.eval("document.querySelector('#panes').getBoundingClientRect().top")?.as_f64().unwrap_or(f64::MAX);
        expect(top <= 170.0, || format!("{language}: {top} px above the panes"))?;
        stage.no_sideways_scroll("phone")?;
        for (width, height) in [(375, 812), (812, 375), (1024, 768), (1440, 900), (1920, 1080)] {
            tab.sized(width, height, 1.0)?;
            let least = "Math.min(...[...document.querySelectorAll('#moves svg.drawn text')].filter((text) => text.checkVisibility()).map((text) => \
                parseFloat(getComputedStyle(text).fontSize) * text.getScreenCTM().a))";
            tab.until(&format!("{least} >= 11"))?;
        }
    }
    Ok(())
}

/// A chapter of the theory opens in the drawer, with a way back to the derivation; formulas have the font for mathematics.
pub(crate) fn a_chapter(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.unfold()?;
    tab.click("#check-continuous_torque button.plain")?;
    tab.there("#detail msqrt")?;
    tab.until("document.fonts.check('16px \"Antrieb Math\"')")?;
    tab.click("#detail a[data-chapter]")?;
    tab.there("#detail #theory h2")?;
    tab.click("#detail #theory a[href$='.html']")?;
    tab.there("#detail #theory")?;
    tab.click("#detail-back")?;
    tab.click("#detail-back")?;
    tab.there("#detail msqrt")?;
    tab.keys(&key::ESCAPE.to_string())?;
    // A German page leads to German chapters, and these to each other.
    stage.example("belt", "de")?;
    stage.unfold()?;
    tab.click("#check-continuous_torque button.plain")?;
    tab.click("#detail a[href='theory/de/continuous-torque.html']")?;
    tab.there("#detail #theory #schätzung")?;
    tab.click("#detail #theory a[href*='/theory/de/'][href$='.html']")?;
    tab.there("#detail #theory #kreuzvalidierung")?;
    tab.keys(&key::ESCAPE.to_string())
}
