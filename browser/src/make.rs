//! Make of the browser.

use std::path::Path;

/// Make of the browser, for differences left open by the WebDriver standard.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Make {
    Chromium,
    Firefox,
}

impl Make {
    /// Returns the make that belongs to the driver program.
    pub(crate) fn of(driver: &Path) -> Self {
        let is_gecko = driver.file_stem().is_some_and(|name| name.to_string_lossy().starts_with("gecko"));
        if is_gecko { Self::Firefox } else { Self::Chromium }
    }

    /// Returns the words before the port in the start message of the driver.
    pub(crate) const fn before_the_port(self) -> &'static str {
        match self {
            Self::Chromium => "started successfully on port ",
            Self::Firefox => "Listening on 127.0.0.1:",
        }
    }
}
