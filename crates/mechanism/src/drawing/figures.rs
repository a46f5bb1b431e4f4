//! What of a mechanism is known when it is drawn.

/// What is known of a mechanism, in SI, by the names of its keys; what is not known keeps the proportion of the neutral drawing.
///
/// `winding` is −1 for a web that is wound off, `crossed` 1 for crossed links.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figures {
    known: Vec<(String, f64)>,
    motion_rad: Option<[f64; 2]>,
}

impl Figures {
    /// Nothing is known.
    #[must_use]
    pub const fn none() -> Self {
        Self { known: Vec::new(), motion_rad: None }
    }

    /// With the value of a key; one that is no finite number is not known.
    #[must_use]
    pub fn with(mut self, key: &str, si: f64) -> Self {
        if si.is_finite() {
            self.known.push((key.to_owned(), si));
        }
        self
    }

    /// With the lowest and highest position of the mechanism over the motion \[rad\]: all of it is to find room.
    #[must_use]
    pub fn over(mut self, from_rad: f64, to_rad: f64) -> Self {
        self.motion_rad =
            (from_rad.is_finite() && to_rad.is_finite() && from_rad <= to_rad).then_some([from_rad, to_rad]);
        self
    }

    /// The value of a key.
    #[must_use]
    pub fn of(&self, key: &str) -> Option<f64> {
        self.known.iter().find(|(name, _)| name == key).map(|(_, si)| *si)
    }

    /// Whether any value is known.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.known.is_empty()
    }

    /// The value of a length, where it is one.
    pub(crate) fn length(&self, key: &str) -> Option<f64> {
        self.of(key).filter(|value| *value > 0.0)
    }

    /// A count, at most as many as can be drawn.
    pub(crate) fn count(&self, key: &str, neutral: u32, most: u32) -> u32 {
        let count = self.of(key).unwrap_or_else(|| f64::from(neutral)).clamp(1.0, f64::from(most));
        (1..=most).rev().find(|each| f64::from(*each) <= count).unwrap_or(1)
    }

    /// Position of the mechanism at which it is drawn \[rad\].
    pub(crate) fn start_rad(&self) -> f64 {
        self.of("start_angle").unwrap_or(0.0)
    }

    /// Lowest and highest position over the motion \[rad\].
    pub(crate) const fn motion_rad(&self) -> Option<[f64; 2]> {
        self.motion_rad
    }

    /// Sheet per metre and the place at the beginning, for something that moves along a line between two places of the sheet.
    ///
    /// With a motion all of it fits in, at most at the scale that the other figures have; without one it begins at the neutral place.
    pub(crate) fn along(&self, per_rad: f64, scale: f64, [from, to]: [f64; 2], neutral: f64) -> (f64, f64) {
        let Some([low, high]) = self.motion_rad else { return (scale, neutral) };
        let room = to - from;
        let stroke = (high - low) * per_rad.abs();
        let scale = if stroke * scale > room { room / stroke } else { scale };
        let ahead = if per_rad < 0.0 { high - self.start_rad() } else { self.start_rad() - low };
        (scale, from + 0.5 * (room - stroke * scale) + ahead * per_rad.abs() * scale)
    }
}
