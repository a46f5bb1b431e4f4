//! Title and description of a chart.

/// Title of a chart and its description, with the methods that set them.
macro_rules! titled {
    () => {
        /// Sets the title above the chart, which also names it to a screen reader.
        #[must_use]
        pub fn title(mut self, title: impl Into<Label>) -> Self {
            self.title = title.into();
            self
        }

        /// Sets the description for screen readers.
        #[must_use]
        pub fn description(mut self, text: &str) -> Self {
            text.clone_into(&mut self.description);
            self
        }
    };
}

pub(crate) use titled;
