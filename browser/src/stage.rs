//! Start of a scenario, and the steps shared by many of them.

use crate::shell::Shell;
use crate::tab::{Tab, Worded, expect};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A tab with the shell that it shows.
pub(crate) struct OpenPage<'s> {
    pub(crate) tab: Tab,
    pub(crate) shell: &'s Shell,
    pub(crate) downloads: &'s Path,
    pub(crate) axe: &'s str,
}

/// Rules of WCAG 2.2, levels A and AA, by their names in axe-core.
const RULES: [&str; 5] = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"];

impl OpenPage<'_> {
    /// Opens the start page.
    pub(crate) fn start(&self, language: &str) -> Worded {
        self.tab.open(&self.shell.at(&format!("lang={language}")))?;
        self.tab.there("#start-title")?;
        self.listens()
    }

    /// Opens an example.
    pub(crate) fn example(&self, kind: &str, language: &str) -> Worded {
        self.tab.open(&self.shell.at(&format!("new={kind}&lang={language}")))?;
        self.ready()
    }

    /// Waits until the page with a project has its answer and its scripts respond to keys.
    pub(crate) fn ready(&self) -> Worded {
        self.tab.there("#standing")?;
        self.listens()?;
        // The script has run: it shows the values at the instant, and the picture fills its pane.
        self.tab.until("document.querySelector('#instant-values')?.textContent !== ''")?;
        std::thread::sleep(Duration::from_millis(120));
        self.tab.until("(() => { const figure = document.querySelector('#demands figure.plot'); const frame = figure?.querySelector('.frame'); return !document.querySelector('.htmx-request') && (!frame || frame.clientWidth === 0 || Math.abs(frame.clientWidth - figure.dataset.width) < 8); })()")
    }

    /// Shows the checks of the selected actuator.
    pub(crate) fn unfold(&self) -> Worded {
        self.tab.there("tbody[aria-current] button.fold")?;
        if self.tab.eval("document.querySelector('#checks') === null")? == Value::Bool(true) {
            self.tab.click("tbody[aria-current] button.fold")?;
        }
        self.tab.there("#checks")
    }

    /// Waits until the scripts have started; before that, a field may be replaced while it is edited.
    pub(crate) fn listens(&self) -> Worded {
        self.tab.until("typeof htmx === 'object' && document.readyState === 'complete' && (document.documentElement.dataset.ready !== undefined || !document.querySelector('script[src*=\"site.js\"]'))")
    }

    /// Changes a value of the project by its path and waits for the answer of the page.
    pub(crate) fn change(&self, field: &str, value: &str) -> Worded {
        let mark = "document.querySelector('#work').dataset.before = ''; \
            addEventListener('htmx:after:swap', () => { document.documentElement.dataset.answered = String(Number(document.documentElement.dataset.answered ?? 0) + 1); }, { once: true });";
        let before = self
            .tab
            .run(&format!("{mark} return Number(document.documentElement.dataset.answered ?? 0);"), Vec::new())?;
        self.tab.fill(field, value)?;
        self.tab.until(&format!("Number(document.documentElement.dataset.answered ?? 0) > {before}"))?;
        // Each key may have its own answer; the last one is awaited.
        std::thread::sleep(Duration::from_millis(60));
        self.tab.until("!document.querySelector('.htmx-request')")
    }

    /// Checks that the visible part of the page violates no accessibility rule.
    pub(crate) fn accessible(&self, what: &str) -> Worded {
        self.tab
            .run(&format!("{}\nreturn null;", self.axe.replace("module.exports", "void 0")), Vec::new())
            .or_else(|_| self.tab.run("(0, eval)(arguments_[0]);", vec![json!(self.axe)]))?;
        let script = "const found = await axe.run(document, { runOnly: arguments_[0] }); \
            return { passed: found.passes.length, violations: found.violations.map((each) => `${each.id}: ${each.nodes.map((node) => node.target + ' ' + node.failureSummary).slice(0, 3).join(' | ')}`) };";
        let found = self.tab.run(script, vec![json!(RULES)])?;
        expect(found["passed"].as_u64().is_some_and(|passed| passed > 5), || {
            format!("axe looked at nothing of {what}")
        })?;
        let violations = found["violations"].as_array().cloned().unwrap_or_default();
        expect(violations.is_empty(), || format!("{what}: {}", Value::Array(violations)))
    }

    /// Checks that the page is no wider than the window.
    pub(crate) fn no_sideways_scroll(&self, what: &str) -> Worded {
        let script = "const wide = [...document.querySelectorAll('body *')].filter((each) => each.getBoundingClientRect().right > innerWidth + 1 && !each.closest('svg')).slice(0, 3).map((each) => each.tagName + '#' + each.id + '.' + each.className); \
            return [document.documentElement.scrollWidth, innerWidth, wide];";
        let found = self.tab.run(script, Vec::new())?;
        expect(found[0].as_u64() <= found[1].as_u64(), || format!("{what}: {found}"))
    }

    /// Clicks a button that downloads, and returns the path of the complete file.
    pub(crate) fn download(&self, button: &str, ending: &str) -> Worded<PathBuf> {
        let all = || -> Vec<PathBuf> {
            std::fs::read_dir(self.downloads).into_iter().flatten().flatten().map(|entry| entry.path()).collect()
        };
        let before = all();
        self.tab.click(button)?;
        let begin = Instant::now();
        while begin.elapsed() < Duration::from_secs(60) {
            let new: Vec<PathBuf> = all().into_iter().filter(|path| !before.contains(path)).collect();
            // During a download Firefox keeps the data in a second file next to the empty target.
            let is_part = |path: &PathBuf| path.extension().is_some_and(|found| found == "part");
            let found = new.iter().find(|path| path.extension().is_some_and(|found| found == ending)).cloned();
            let found = found.filter(|_| !new.iter().any(is_part));
            if let Some(path) = found {
                return Ok(path);
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        Err(format!("{button} gave no file with the ending {ending}: {}", self.tab.text("#status").unwrap_or_default()))
    }

    /// Checks that the console has no error and no resource was blocked.
    pub(crate) fn no_fault_in_the_console(&self) -> Worded {
        let mut faults = self.tab.faults()?;
        // Error responses are listed there too; the scenarios check the page's message.
        faults.retain(|fault| !fault.contains("the server responded with a status of 4"));
        // A missing network, or leaving unsaved work by script, is no fault either.
        let expected = ["ERR_INTERNET_DISCONNECTED", "Failed to fetch", "'beforeunload'"];
        faults.retain(|fault| expected.iter().all(|part| !fault.contains(part)));
        expect(faults.is_empty(), || faults.join("; "))
    }
}
