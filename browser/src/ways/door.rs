//! Scenarios with a recording from outside: through each door to a preview, and from there into the project.

use crate::stage::OpenPage;
use crate::tab::{Worded, expect};
use serde_json::{Value, json};

/// Largest number of actions from the start page to an answer.
const ACTIONS_MOST: usize = 20;

/// Ways on which a file reaches the page.
#[derive(Clone, Copy)]
enum Door {
    Tile,
    Open,
    Drop,
    Paste,
}

impl Door {
    const ALL: [Self; 4] = [Self::Tile, Self::Open, Self::Drop, Self::Paste];

    const fn file(self) -> &'static str {
        match self {
            Self::Tile => "by-tile.csv",
            Self::Open => "opened.csv",
            Self::Drop => "dropped.csv",
            Self::Paste => "pasted.csv",
        }
    }

    /// Brings a file onto the page; returns the number of actions.
    fn bring(self, stage: &OpenPage<'_>, text: &str) -> Worded<usize> {
        let tab = &stage.tab;
        match self {
            Self::Tile => {
                tab.will_choose(self.file(), text)?;
                tab.click("#tile-recording")?;
                Ok(2)
            }
            Self::Open => {
                tab.will_choose(self.file(), text)?;
                tab.click("[data-open]")?;
                Ok(2)
            }
            Self::Drop => {
                tab.drop_file(self.file(), text)?;
                Ok(1)
            }
            Self::Paste => {
                tab.paste(text)?;
                Ok(1)
            }
        }
    }
}

/// Returns a swing with its torque; positions have the steps of a coarse encoder.
fn recording() -> String {
    let step = 0.02;
    let rows = (0..500_u32).map(|row| {
        let phase = std::f64::consts::TAU * f64::from(row) / 499.0;
        let position = 40.0 * (1.0 - phase.cos());
        format!("{:.3},{:.4},{:.3}\n", f64::from(row) * 0.004, step * (position / step).round(), 3.0 * phase.sin())
    });
    ["t [s],q [deg],M [N m]\n".to_owned()].into_iter().chain(rows).collect()
}

/// Every door leads to the same preview; the project that results contains what was chosen there, and nothing is written
/// before.
pub(crate) fn recording_through_the_door(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    // Another table that was pasted before would have the name.
    if let Some(folder) = stage.shell.folder() {
        let _ = std::fs::remove_file(folder.join(Door::Paste.file()));
    }
    for (width, height) in [(1440, 900), (375, 812)] {
        tab.sized(width, height, 1.0)?;
        for door in Door::ALL {
            stage.start("en")?;
            let kept = || stage.shell.folder().is_some_and(|folder| folder.join(door.file()).is_file());
            let before = kept();
            let mut actions = door.bring(stage, &recording())?;
            tab.there("#incoming-figure svg")?;
            tab.says("#detail-title", door.file())?;
            tab.says("#incoming-artefact", "steps of the file")?;
            tab.until("document.querySelector('#incoming-use').disabled")?;
            tab.click("#incoming-torque-whole")?;
            tab.until("!document.querySelector('#incoming-use').disabled")?;
            tab.says("#incoming-smoothing", "106 ms")?;
            tab.click("#incoming-window-106-ms")?;
            tab.until("document.querySelector('#incoming-window-106-ms').checked && !document.querySelector('#incoming[aria-busy]')")?;
            stage.accessible("the preview of a recording")?;
            stage.no_sideways_scroll("the preview of a recording")?;
            expect(kept() == before, || format!("{} was written early", door.file()))?;
            tab.click("#incoming-use")?;
            tab.there("#standing")?;
            stage.listens()?;
            actions += 3;
            let text = format!(
                "format = 1\n\n[mechanism.joint]\n\n[[motion]]\nlaw = \"recorded\"\nfile = \"{}\"\nsmoothing = \"106 ms\"\n",
                door.file()
            );
            tab.until(&format!("document.querySelector('#text')?.value === {}", json!(text)))?;
            tab.until("document.querySelector('#standing').textContent.includes('CHA-')")?;
            expect(stage.shell.folder().is_none() || kept(), || "no recording in the folder".to_owned())?;
            expect(actions <= ACTIONS_MOST, || format!("{actions} actions"))?;
            tab.run("window.onbeforeunload = null;", Vec::new())?;
        }
    }
    Ok(())
}

/// A recording along a line requires a mechanism; what is typed there stands in the project, and it has an answer.
pub(crate) fn recording_along_a_line(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    let rows = (0..400_u32).map(|row| {
        let phase = std::f64::consts::TAU * f64::from(row) / 399.0;
        format!("{:.3},{:.5},{:.3}\n", f64::from(row) * 0.02, 50.0 * (1.0 - phase.cos()), 90.0 * phase.sin())
    });
    let text: String = ["t [s],position [mm],force [N]\n".to_owned()].into_iter().chain(rows).collect();
    for (width, height) in [(1440, 900), (375, 812)] {
        tab.sized(width, height, 1.0)?;
        stage.start("en")?;
        tab.drop_file("line.csv", &text)?;
        tab.there("#incoming-figure svg")?;
        tab.click("#incoming-torque-process")?;
        tab.says("#incoming-why", "State the mechanism first.")?;
        let chosen = "const kind = document.querySelector('#incoming-mechanism-kind'); kind.value = 'screw'; \
            kind.dispatchEvent(new Event('change', { bubbles: true }));";
        tab.run(chosen, Vec::new())?;
        for (field, value) in [("lead", "20"), ("mass", "8"), ("inclination", "0")] {
            let field = format!("#f-mechanism-screw-{field}");
            tab.there(&field)?;
            tab.fill(&field, value)?;
            tab.until("!document.querySelector('#incoming[aria-busy]')")?;
        }
        tab.until("!document.querySelector('#incoming-use').disabled")?;
        stage.accessible("the preview of a recording along a line")?;
        stage.no_sideways_scroll("the preview of a recording along a line")?;
        tab.click("#incoming-use")?;
        tab.there("#standing")?;
        stage.listens()?;
        tab.says("#text", "lead = \"20 mm\"")?;
        tab.until(
            "document.querySelector('#standing').textContent.includes('CHA-') || document.querySelector('.remedies')",
        )?;
        tab.run("window.onbeforeunload = null;", Vec::new())?;
    }
    Ok(())
}

/// A file that is no recording has a sentence; project and page stay, and the next file is read as if it were the first.
pub(crate) fn hostile_recordings(stage: &OpenPage<'_>) -> Worded {
    let tab = &stage.tab;
    stage.example("arm", "en")?;
    let text = tab.value("#text")?;
    let files = [
        ("binary.csv", "\u{0}\u{1}\u{2}PK\u{3}\u{4}\u{0}\u{7f}".repeat(50)),
        ("empty.csv", String::new()),
        ("one-row.csv", "t [s],q [deg]\n0,1\n".to_owned()),
        ("nan.csv", format!("t [s],q [deg]\n{}", "0,NaN\n".repeat(5))),
        ("units-alone.csv", "t,q\ns,deg\n".to_owned()),
        ("wrong-order.csv", "t [s],q [deg]\n2,0\n1,1\n0,2\n".to_owned()),
    ];
    for (name, content) in files {
        tab.drop_file(name, &content)?;
        tab.says("#detail-title", name)?;
        tab.there("#incoming-faults")?;
        let said = tab.text("#incoming-faults")?;
        expect(said.len() > 60, || format!("{name}: {said}"))?;
        tab.until("document.querySelector('#incoming-use').disabled")?;
        expect(tab.value("#text")? == text, || format!("{name} changed the project"))?;
    }
    // Of two files that follow each other the second one is shown.
    tab.drop_file("first.csv", &recording())?;
    tab.drop_file("second.csv", &recording())?;
    tab.says("#detail-title", "second.csv")?;
    tab.there("#incoming-figure svg")?;
    tab.click("#incoming-torque-unused")?;
    tab.until("!document.querySelector('#incoming-use').disabled")?;
    tab.click("#detail [data-close]")?;
    expect(tab.value("#text")? == text, || "a closed preview changed the project".to_owned())?;
    let changed = tab.eval("document.title.startsWith('•')")?;
    expect(changed == Value::Bool(false), || "the project counts as changed".to_owned())
}
