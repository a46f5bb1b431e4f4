//! Scenarios of the form and its answer.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect, key};
use crate::ways::pictures::CURRENT;

pub(crate) fn a_value_changes_the_verdict(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let before = tab.text("#answer")?;
    stage.change("#f-mechanism-belt-mass", "60 kg")?;
    tab.says("#text", "mass = \"60 kg\"")?;
    let after = tab.text("#answer")?;
    expect(before != after, || format!("the same answer: {after}"))?;
    // A value that is emptied and typed anew keeps its line, with the comment.
    let commented = "const text = document.querySelector('#text'); \
        text.value = text.value.replace('mass = \"60 kg\"', 'mass = \"60 kg\" # with gripper'); \
        text.dispatchEvent(new Event('change', { bubbles: true }));";
    tab.run(commented, Vec::new())?;
    tab.until("!document.querySelector('.htmx-request')")?;
    let field = "const mass = document.querySelector('#f-mechanism-belt-mass'); mass.focus(); mass.select();";
    tab.run(field, Vec::new())?;
    tab.keys(&key::BACKSPACE.to_string())?;
    tab.until("!document.querySelector('#text').value.includes('with gripper')")?;
    tab.keys("61")?;
    tab.says("#text", "mass = \"61 kg\" # with gripper")?;
    stage.change("#f-mechanism-belt-mass", "6000 kg")?;
    tab.says("#answer", "No actuator")
}

pub(crate) fn a_fault_stands_at_its_field(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let before = tab.text("#standing")?;
    // The bar keeps its height, whatever it says.
    let height = || tab.eval("document.querySelector('#verdict').offsetHeight");
    let high = height()?;
    stage.change("#f-mechanism-belt-mass", "sixty")?;
    expect(height()? == high, || format!("the verdict was {high} px high"))?;
    tab.until("document.querySelector('#f-mechanism-belt-mass').getAttribute('aria-invalid') === 'true'")?;
    tab.says("#f-mechanism-belt-mass-x", "sixty")?;
    tab.there("#demands.old")?;
    let kept = tab.text("#verdict")?;
    expect(kept.contains(before.trim()), || format!("the last result is gone: {kept}"))?;
    stage.change("#f-mechanism-belt-mass", "6000 kg")?;
    expect(height()? == high, || format!("the verdict was {high} px high"))?;
    stage.change("#f-mechanism-belt-mass", "60 kg")?;
    tab.until("!document.querySelector('#demands.old') && !document.querySelector('[aria-invalid]')")?;
    // The row of values follows, also where the field is left at once.
    tab.until("!document.querySelector('#instant-values').hasAttribute('data-old')")
}

pub(crate) fn undo_and_redo(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let before = tab.value("#f-mechanism-belt-mass")?;
    stage.change("#f-mechanism-belt-mass", "44 kg")?;
    tab.click("#undo")?;
    tab.holds("#f-mechanism-belt-mass", &before)?;
    tab.click("#redo")?;
    tab.holds("#f-mechanism-belt-mass", "44")?;
    tab.says("#text", "44 kg")?;
    // A cell that has the focus shows the text of the step too.
    let cell = tab.run("return '#' + document.querySelector('#fields input[data-cell]').id;", Vec::new())?;
    let cell = cell.as_str().unwrap_or_default();
    let before = tab.value(cell)?;
    tab.fill(cell, "123.4")?;
    tab.says("#text", "123.4")?;
    let undone = "document.querySelector(arguments_[0]).focus(); document.querySelector('#undo').click();";
    tab.run(undone, vec![cell.into()])?;
    tab.holds(cell, &before)?;
    tab.until(&format!("document.activeElement.id === '{}'", cell.trim_start_matches('#')))
}

pub(crate) fn a_number_is_explained(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.unfold()?;
    tab.click("#check-peak_torque button.plain")?;
    tab.there("#detail .formula")?;
    tab.until("document.activeElement.id === 'detail-title'")?;
    // Escape closes it, and the focus returns.
    tab.keys(&key::ESCAPE.to_string())?;
    tab.until("!document.querySelector('#detail').firstElementChild")?;
    tab.until("document.activeElement.closest('#check-peak_torque') !== null")
}

pub(crate) fn language_and_dark(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    stage.change("#f-mechanism-belt-mass", "44 kg")?;
    tab.click("#language")?;
    tab.says("#demands-title", "Belastung")?;
    tab.until("document.documentElement.lang === 'de'")?;
    let light = tab.eval("getComputedStyle(document.documentElement).backgroundColor")?;
    tab.click("#theme")?;
    tab.until("document.documentElement.dataset.theme === 'dark'")?;
    let dark = tab.eval("getComputedStyle(document.documentElement).backgroundColor")?;
    expect(light != dark, || format!("as light as before: {dark}"))?;
    tab.says("#text", "44 kg")?;
    // The theme is kept for the next visit.
    stage.start("en")?;
    tab.until("document.documentElement.dataset.theme === 'dark'")?;
    // The page in another theme or language keeps the results of its examples, in its language.
    let results = |word: &str| {
        format!(
            "[...document.querySelectorAll('.card > span > .small')].length > 8 && \
             [...document.querySelectorAll('.card > span > .small')].every((each) => each.textContent.includes('{word}'))"
        )
    };
    tab.until(&results("cycle\u{a0}"))?;
    tab.click("#theme")?;
    tab.until("document.documentElement.dataset.theme !== 'dark'")?;
    tab.until(&results("cycle\u{a0}"))?;
    tab.click("a.button[lang=de]")?;
    tab.until(&results("Zyklus\u{a0}"))?;
    // A theme in the address stands before that of the last visit.
    tab.open(&stage.shell.at("theme=dark&lang=en"))?;
    stage.listens()?;
    tab.until("document.documentElement.dataset.theme === 'dark'")?;
    tab.until(&results("cycle\u{a0}"))
}

pub(crate) fn compare(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("belt", "en")?;
    let marks = tab.eval("[...document.querySelectorAll('input[name=mark]')].slice(0, 2).map((mark) => mark.id)")?;
    let marks: Vec<&str> = marks.as_array().into_iter().flatten().filter_map(|mark| mark.as_str()).collect();
    for mark in &marks {
        tab.click(&format!("#{mark}"))?;
        tab.until(&format!("document.querySelector('#{mark}')?.dataset.checked === 'true'"))?;
    }
    tab.click("[hx-post='/compare']")?;
    for mark in marks {
        tab.says("#detail", mark.trim_start_matches("m-"))?;
    }
    Ok(())
}

/// Example, changed verdict and plots, by keyboard only.
pub(crate) fn by_keyboard(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.start("en")?;
    tab.tab_to("a[href*=\"new=belt\"]")?;
    tab.keys(&key::ENTER.to_string())?;
    stage.ready()?;
    tab.tab_to("#f-mechanism-belt-mass")?;
    tab.chord(key::CONTROL, 'a')?;
    tab.keys("61 kg")?;
    tab.keys(&key::TAB.to_string())?;
    tab.says("#text", "61 kg")?;
    tab.tab_to("#instant")?;
    tab.until(CURRENT)?;
    let place = "[...document.querySelectorAll('.cursor-line, .cursor-point')].map((mark) => mark.getAttribute('x1') ?? mark.getAttribute('cx') + ' ' + mark.getAttribute('cy')).join()";
    let (before, marks) = (tab.text("#instant-values")?, tab.eval(place)?);
    tab.keys(&key::RIGHT.to_string().repeat(5))?;
    let (moved, moved_marks) = (tab.text("#instant-values")?, tab.eval(place)?);
    expect(before != moved && marks != moved_marks, || format!("the cursor stays: {moved}"))?;
    let spoken = tab.eval("document.querySelector('#instant').getAttribute('aria-valuetext')")?;
    let plain = |text: &str| text.replace([',', ' '], "").split_whitespace().collect::<String>();
    expect(spoken.as_str().map(plain) == Some(plain(&moved)), || format!("it says {spoken} and shows {moved}"))?;
    tab.keys(&key::END.to_string())?;
    tab.tab_to("tbody[aria-current] button.fold")?;
    tab.keys(&key::SPACE.to_string())?;
    tab.there("#checks")?;
    tab.tab_to("#check-peak_torque button.plain")?;
    tab.keys(&key::SPACE.to_string())?;
    tab.there("#detail .formula")
}
