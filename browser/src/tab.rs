//! A browser tab with the actions of a user: read, type, click, wait.

use crate::make::Make;
use fantoccini::actions::{InputSource, KeyAction, KeyActions, MOUSE_BUTTON_LEFT, MouseActions, PointerAction};
use fantoccini::wd::{TimeoutConfiguration, WebDriverCompatibleCommand, WindowHandle};
use fantoccini::{Client, Locator};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::rc::Rc;
use std::time::{Duration, Instant};
use tokio::runtime::Runtime;

/// Result with a failure as text.
pub(crate) type Worded<T = ()> = Result<T, String>;

/// Time limit of an action, for a machine under load.
const PATIENCE: Duration = Duration::from_secs(30);

/// Minimum width of a Firefox window in the tests; the browser permits no less than about 450 pixels.
const FIREFOX_LEAST: u32 = 500;

/// Longest time after a step until the focus has a place: a swap and what follows it are two tasks of the page.
const FOCUS_AFTER: Duration = Duration::from_secs(2);

/// Keys by their WebDriver codes.
pub(crate) mod key {
    pub(crate) const BACKSPACE: char = '\u{e003}';
    pub(crate) const TAB: char = '\u{e004}';
    pub(crate) const ENTER: char = '\u{e007}';
    pub(crate) const ESCAPE: char = '\u{e00c}';
    pub(crate) const SPACE: char = ' ';
    pub(crate) const END: char = '\u{e010}';
    pub(crate) const RIGHT: char = '\u{e014}';
    pub(crate) const CONTROL: char = '\u{e009}';
    pub(crate) const SHIFT: char = '\u{e008}';
}

/// A browser and its current tab.
pub(crate) struct Tab {
    client: Client,
    runtime: Rc<Runtime>,
    make: Make,
}

fn message(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// Returns a failure with the text of `what` unless the expectation holds.
pub(crate) fn expect(holds: bool, what: impl FnOnce() -> String) -> Worded {
    if holds { Ok(()) } else { Err(what()) }
}

/// Script that makes an element visible: shows its pane in a narrow window, or the hidden side of the left pane.
const SHOWN: &str = "const pane = found.closest('.pane'); \
    if (pane && getComputedStyle(pane).display === 'none') document.querySelector(`[data-pane=\"${{ moves: 1, demands: 2, fits: 3 }[pane.id]}\"]`)?.click(); \
    if (found.id === 'text') document.querySelector('[data-left=text]')?.click(); else if (found.closest('#left-pane-form')) document.querySelector('[data-left=form]')?.click();";

impl Tab {
    pub(crate) fn new(client: Client, runtime: Rc<Runtime>, make: Make) -> Worded<Self> {
        let progress = TimeoutConfiguration::new(Some(4 * PATIENCE), Some(4 * PATIENCE), None);
        runtime.block_on(client.update_timeouts(progress)).map_err(message)?;
        Ok(Self { client, runtime, make })
    }

    /// Closes the browser.
    pub(crate) fn close(self) {
        let _ = self.runtime.block_on(self.client.close());
    }

    /// Opens an address.
    pub(crate) fn open(&self, address: &str) -> Worded {
        self.runtime.block_on(self.client.goto(address)).map_err(message)
    }

    pub(crate) fn reload(&self) -> Worded {
        self.runtime.block_on(self.client.refresh()).map_err(message)
    }

    /// Opens a further tab, makes it current, and returns the previous one.
    pub(crate) fn another(&self) -> Worded<WindowHandle> {
        self.runtime.block_on(async {
            let before = self.client.window().await.map_err(message)?;
            let new = self.client.new_window(true).await.map_err(message)?;
            self.client.switch_to_window(new.handle).await.map_err(message)?;
            Ok(before)
        })
    }

    /// Makes another tab current, and returns the one that was.
    pub(crate) fn switch_to(&self, other: WindowHandle) -> Worded<WindowHandle> {
        self.runtime.block_on(async {
            let before = self.client.window().await.map_err(message)?;
            self.client.switch_to_window(other).await.map_err(message)?;
            Ok(before)
        })
    }

    /// Closes the tab and makes another one current.
    pub(crate) fn back_to(&self, before: WindowHandle) -> Worded {
        self.runtime.block_on(async {
            self.client.close_window().await.map_err(message)?;
            self.client.switch_to_window(before).await.map_err(message)
        })
    }

    /// Runs a script, the body of a function that may await promises, and returns its value.
    pub(crate) fn run(&self, script: &str, arguments: Vec<Value>) -> Worded<Value> {
        let script = format!(
            "const done = arguments[arguments.length - 1]; const given = arguments; \
             (async (...arguments_) => {{ {script} }})(...given).then((value) => done({{ value: value ?? null }}), (error) => done({{ error: String(error) }}));"
        );
        let answer = self.runtime.block_on(self.client.execute_async(&script, arguments)).map_err(message)?;
        match answer.get("error") {
            Some(error) => Err(format!("{error} in {script}")),
            None => Ok(answer.get("value").cloned().unwrap_or_default()),
        }
    }

    /// Returns the value of an expression.
    pub(crate) fn eval(&self, expression: &str) -> Worded<Value> {
        self.run(&format!("return {expression};"), Vec::new())
    }

    /// Waits until an expression is true.
    pub(crate) fn until(&self, expression: &str) -> Worded {
        let begin = Instant::now();
        loop {
            // Scripts cannot run while a page is loading.
            let now = self.eval(&format!("!!({expression})"));
            if now == Ok(Value::Bool(true)) {
                return self.keeps_its_frame(expression);
            }
            if begin.elapsed() > PATIENCE {
                let seen = self.text("body").unwrap_or_default();
                let seen: String = seen.chars().take(400).collect();
                return Err(format!(
                    "not within {} s: {expression} ({now:?}); the page says: {seen}",
                    PATIENCE.as_secs()
                ));
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// Checks the frame of the workbench after a step: the document does not scroll, nothing is wider than the window, and the focus is not
    /// lost. A low window scrolls as a whole.
    fn keeps_its_frame(&self, after: &str) -> Worded {
        let frame = "(document.querySelector('#work') && innerHeight > 500) ? [document.scrollingElement.scrollTop, document.scrollingElement.scrollWidth - innerWidth, window.hasFocus === true && document.activeElement === document.body] : null";
        let begin = Instant::now();
        let (found, is_lost) = loop {
            // A page that is being left has no frame.
            let Ok(Value::Array(found)) = self.eval(frame) else { return Ok(()) };
            let is_lost = found.get(2) == Some(&Value::Bool(true));
            // Between a swap and its end the focus is nowhere, and a driver may answer there.
            if !is_lost || begin.elapsed() > FOCUS_AFTER {
                break (found, is_lost);
            }
            std::thread::sleep(Duration::from_millis(20));
        };
        let is_kept = found.iter().take(2).all(|each| each.as_f64().is_some_and(|pixels| pixels <= 0.5));
        expect(is_kept && !is_lost, || {
            format!("after {after}: scrolled by, wider than the window by, focus on the body: {found:?}")
        })
    }

    /// Waits until an element is present.
    pub(crate) fn there(&self, selector: &str) -> Worded {
        self.until(&format!("document.querySelector({})", json!(selector)))
    }

    /// Waits until an element contains a text.
    pub(crate) fn says(&self, selector: &str, text: &str) -> Worded {
        self.until(&format!("document.querySelector({})?.textContent.includes({})", json!(selector), json!(text)))
    }

    /// Waits until a field has a value.
    pub(crate) fn holds(&self, selector: &str, value: &str) -> Worded {
        self.until(&format!("document.querySelector({})?.value === {}", json!(selector), json!(value)))
    }

    pub(crate) fn text(&self, selector: &str) -> Worded<String> {
        let found = self.run("return document.querySelector(arguments_[0])?.textContent;", vec![json!(selector)])?;
        found.as_str().map(str::to_owned).ok_or_else(|| format!("no {selector}"))
    }

    pub(crate) fn value(&self, selector: &str) -> Worded<String> {
        let found = self.run("return document.querySelector(arguments_[0])?.value;", vec![json!(selector)])?;
        found.as_str().map(str::to_owned).ok_or_else(|| format!("no {selector}"))
    }

    pub(crate) fn click(&self, selector: &str) -> Worded {
        self.listens(selector)?;
        // Folded sections are opened first, as by a user who searches in them.
        self.run(
            &format!(
                "const found = document.querySelector(arguments_[0]); {SHOWN} \
             for (let fold = found.closest('details'); fold; fold = fold.parentElement.closest('details')) if (!found.matches('summary')) fold.open = true; \
             found.scrollIntoView({{ block: 'center' }});"
            ),
            vec![json!(selector)],
        )?;
        let begin = Instant::now();
        loop {
            let clicked = self.runtime.block_on(async {
                let found = self.client.find(Locator::Css(selector)).await.map_err(message)?;
                found.click().await.map_err(|error| format!("{selector}: {error}"))
            });
            // An answer may replace the element between the two steps.
            let is_gone = clicked.as_ref().is_err_and(|error| error.contains("stale element"));
            if !is_gone || begin.elapsed() > PATIENCE {
                clicked?;
                let takes = format!(
                    "document.querySelector({})?.matches('button, input, select, summary') === true",
                    json!(selector)
                );
                // A mark in the page: another page begins without it, and with the focus on its body.
                self.eval(&format!("(window.hasFocus = {takes})"))?;
                return self.keeps_its_frame(selector);
            }
        }
    }

    /// Waits until an element is present and its event handlers are attached, which follows its insertion.
    fn listens(&self, selector: &str) -> Worded {
        self.there(selector)?;
        let found = format!("document.querySelector({})", json!(selector));
        self.until(&format!("{found}?.matches('[hx-post], [hx-get]') === false || {found}?._htmx?.initialized"))
    }

    /// Replaces the text of a field, and leaves the field.
    pub(crate) fn fill(&self, selector: &str, text: &str) -> Worded {
        self.listens(selector)?;
        self.run(
            &format!(
                "const found = document.querySelector(arguments_[0]); {SHOWN} \
             for (let fold = found.closest('details'); fold; fold = fold.parentElement.closest('details')) fold.open = true; \
             found.focus(); found.select();"
            ),
            vec![json!(selector)],
        )?;
        self.keys(text)?;
        self.run("window.hasFocus = false; document.activeElement.blur();", Vec::new())?;
        self.keeps_its_frame(selector)
    }

    /// Presses keys one after the other.
    pub(crate) fn keys(&self, keys: &str) -> Worded {
        let mut actions = KeyActions::new("keys".to_owned());
        for key in keys.chars() {
            actions = actions.then(KeyAction::Down { value: key }).then(KeyAction::Up { value: key });
        }
        self.runtime.block_on(self.client.perform_actions(actions)).map_err(message)
    }

    /// Presses a key while another one is down.
    pub(crate) fn chord(&self, held: char, key: char) -> Worded {
        let actions = KeyActions::new("keys".to_owned())
            .then(KeyAction::Down { value: held })
            .then(KeyAction::Down { value: key })
            .then(KeyAction::Up { value: key })
            .then(KeyAction::Up { value: held });
        self.runtime.block_on(self.client.perform_actions(actions)).map_err(message)
    }

    /// Drags an element by a number of pixels.
    pub(crate) fn drag(&self, selector: &str, (x, y): (i64, i64)) -> Worded {
        self.there(selector)?;
        self.run("document.querySelector(arguments_[0]).scrollIntoView({ block: 'center' });", vec![json!(selector)])?;
        // An answer that is on its way draws the picture anew, and another element may lie at the place of this one.
        self.until(&format!(
            "(() => {{ const {{ x, y }} = document.querySelector({}).getBoundingClientRect(); const [is, was] = [`${{x}} ${{y}}`, window.wasAt]; \
             window.wasAt = is; return is === was && !document.querySelector('.htmx-request'); }})()",
            json!(selector)
        ))?;
        self.runtime.block_on(async {
            let element = self.client.find(Locator::Css(selector)).await.map_err(message)?;
            let duration = Some(Duration::from_millis(100));
            let by = |x: i64, y: i64| PointerAction::MoveBy { duration, x: x as f64, y: y as f64 };
            let actions = MouseActions::new("pointer".to_owned())
                .then(PointerAction::MoveToElement { element, duration, x: 0.0, y: 0.0 })
                .then(PointerAction::Down { button: MOUSE_BUTTON_LEFT })
                .then(by(x / 2, y / 2))
                .then(by(x - x / 2, y - y / 2))
                .then(PointerAction::Up { button: MOUSE_BUTTON_LEFT });
            self.client.perform_actions(actions).await.map_err(|error| format!("{selector}: {error}"))
        })
    }

    /// Presses the tab key until an element has the focus, backwards to one that stands before: behind the last element the
    /// focus of Firefox leaves the page for good.
    pub(crate) fn tab_to(&self, selector: &str) -> Worded {
        let is_before = format!(
            "(document.activeElement.compareDocumentPosition(document.querySelector({}) ?? document.body) & Node.DOCUMENT_POSITION_PRECEDING) !== 0 && document.activeElement !== document.body",
            json!(selector)
        );
        let is_before = self.eval(&is_before)? == Value::Bool(true);
        for _ in 0..400 {
            if is_before {
                self.chord(key::SHIFT, key::TAB)?
            } else {
                self.keys(&key::TAB.to_string())?
            }
            if self.eval(&format!("document.activeElement.matches({})", json!(selector)))? == Value::Bool(true) {
                return Ok(());
            }
        }
        Err(format!("the tabulator does not lead to {selector}"))
    }

    /// Pastes a text into the page.
    pub(crate) fn paste(&self, text: &str) -> Worded {
        self.run(
            "const held = new DataTransfer(); held.setData('text/plain', arguments_[0]); \
             document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData: held, data: arguments_[0], dataType: 'text/plain', bubbles: true, cancelable: true }));",
            vec![json!(text)],
        )?;
        Ok(())
    }

    /// Drops a file onto the page.
    pub(crate) fn drop_file(&self, name: &str, text: &str) -> Worded {
        self.run(
            "const held = new DataTransfer(); held.items.add(new File([arguments_[1]], arguments_[0])); \
             document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: held, bubbles: true, cancelable: true }));",
            vec![json!(name), json!(text)],
        )?;
        Ok(())
    }

    /// Provides the file for the next file dialog that the page opens.
    pub(crate) fn will_choose(&self, name: &str, text: &str) -> Worded {
        self.run(
            "const [name, text] = arguments_; const click = HTMLInputElement.prototype.click; \
             HTMLInputElement.prototype.click = function () { \
               if (this.type !== 'file') return click.call(this); \
               HTMLInputElement.prototype.click = click; \
               const held = new DataTransfer(); held.items.add(new File([text], name)); \
               this.files = held.files; this.dispatchEvent(new Event('change')); };",
            vec![json!(name), json!(text)],
        )?;
        Ok(())
    }

    /// Sets the size of the page in CSS pixels, and the number of screen pixels per CSS pixel; Firefox has only one.
    pub(crate) fn sized(&self, width: u32, height: u32, scale: f64) -> Worded {
        match self.make {
            Make::Chromium => {
                let metrics = json!({ "width": width, "height": height, "deviceScaleFactor": scale, "mobile": false });
                self.command("Emulation.setDeviceMetricsOverride", metrics)
            }
            Make::Firefox => {
                // Its window has a minimum width, and a frame around the page.
                let width = width.max(FIREFOX_LEAST);
                let around = self.eval("[outerWidth - innerWidth, outerHeight - innerHeight]")?;
                let side = |inside: u32, place: usize| inside + around[place].as_u64().unwrap_or(0) as u32;
                let resized = self.client.set_window_size(side(width, 0), side(height, 1));
                self.runtime.block_on(resized).map_err(message)?;
                self.until(&format!("innerWidth === {width}"))
            }
        }
    }

    /// Disconnects or reconnects the network; Chromium only.
    pub(crate) fn offline(&self, is: bool) -> Worded {
        self.command("Network.enable", json!({}))?;
        let network = json!({ "offline": is, "latency": 0, "downloadThroughput": -1, "uploadThroughput": -1 });
        self.command("Network.emulateNetworkConditions", network)
    }

    /// Shows the page as it is printed, or on the screen again; Chromium only.
    pub(crate) fn on_paper(&self, is: bool) -> Worded {
        self.command("Emulation.setEmulatedMedia", json!({ "media": if is { "print" } else { "" } }))
    }

    /// Returns new errors in the console since the last call; the driver of Firefox does not provide them.
    pub(crate) fn faults(&self) -> Worded<Vec<String>> {
        if self.make == Make::Firefox {
            return Ok(Vec::new());
        }
        let log = Log;
        let answer = self.runtime.block_on(self.client.issue_cmd(log)).map_err(message)?;
        let severe = |entry: &&Value| entry.get("level").and_then(Value::as_str) == Some("SEVERE");
        let message = |entry: &Value| entry.get("message").and_then(Value::as_str).unwrap_or_default().to_owned();
        Ok(answer.as_array().into_iter().flatten().filter(severe).map(message).collect())
    }

    /// Returns a screenshot of the page.
    pub(crate) fn picture(&self) -> Worded<Vec<u8>> {
        self.runtime.block_on(self.client.screenshot()).map_err(message)
    }

    /// Returns the counters of the browser about the main thread of the page, by their names; `None` in Firefox.
    pub(crate) fn counters(&self) -> Worded<Option<BTreeMap<String, f64>>> {
        if self.make != Make::Chromium {
            return Ok(None);
        }
        self.command("Performance.enable", json!({}))?;
        let found = self.asked("Performance.getMetrics", json!({}))?;
        let counter = |each: &Value| Some((each["name"].as_str()?.to_owned(), each["value"].as_f64()?));
        Ok(Some(found["metrics"].as_array().into_iter().flatten().filter_map(counter).collect()))
    }

    fn command(&self, name: &'static str, arguments: Value) -> Worded {
        self.asked(name, arguments).map(drop)
    }

    fn asked(&self, name: &'static str, arguments: Value) -> Worded<Value> {
        self.runtime.block_on(self.client.issue_cmd(OfTheBrowser { name, arguments })).map_err(message)
    }
}

/// A browser-specific command outside the WebDriver standard.
#[derive(Debug)]
struct OfTheBrowser {
    name: &'static str,
    arguments: Value,
}

impl WebDriverCompatibleCommand for OfTheBrowser {
    fn endpoint(&self, base: &url::Url, session: Option<&str>) -> Result<url::Url, url::ParseError> {
        base.join(&format!("session/{}/goog/cdp/execute", session.unwrap_or_default()))
    }

    fn method_and_body(&self, _: &url::Url) -> (http::Method, Option<String>) {
        (http::Method::POST, Some(json!({ "cmd": self.name, "params": self.arguments }).to_string()))
    }
}

/// Command that reads the console.
#[derive(Debug)]
struct Log;

impl WebDriverCompatibleCommand for Log {
    fn endpoint(&self, base: &url::Url, session: Option<&str>) -> Result<url::Url, url::ParseError> {
        base.join(&format!("session/{}/se/log", session.unwrap_or_default()))
    }

    fn method_and_body(&self, _: &url::Url) -> (http::Method, Option<String>) {
        (http::Method::POST, Some(json!({ "type": "browser" }).to_string()))
    }
}
