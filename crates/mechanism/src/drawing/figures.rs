//! Known values of a mechanism for its drawing.

/// Known values of a mechanism in SI, by the names of their keys; the drawing keeps neutral proportions for unknown
/// ones.
///
/// `winding` is −1 for a web that is wound off, `crossed` 1 for a crossed linkage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MechanismValues {
    known: Vec<(String, f64)>,
    motion_rad: Option<[f64; 2]>,
}

impl MechanismValues {
    /// Creates an empty list of values.
    #[must_use]
    pub const fn none() -> Self {
        Self { known: Vec::new(), motion_rad: None }
    }

    /// Adds the value of a key; a value that is not finite is ignored.
    #[must_use]
    pub fn with(mut self, key: &str, si: f64) -> Self {
        if si.is_finite() {
            self.known.push((key.to_owned(), si));
        }
        self
    }

    /// Sets the lowest and highest position of the mechanism over the motion \[rad\], for which the drawing reserves
    /// space.
    #[must_use]
    pub fn over(mut self, from_rad: f64, to_rad: f64) -> Self {
        self.motion_rad =
            (from_rad.is_finite() && to_rad.is_finite() && from_rad <= to_rad).then_some([from_rad, to_rad]);
        self
    }

    /// Returns the value of a key.
    #[must_use]
    pub fn of(&self, key: &str) -> Option<f64> {
        self.known.iter().find(|(name, _)| name == key).map(|(_, si)| *si)
    }

    /// Returns `true` if no value is known.
    #[must_use]
    pub fn is_none(&self) -> bool {
        self.known.is_empty()
    }

    /// Returns the value of a positive length.
    pub(crate) fn length(&self, key: &str) -> Option<f64> {
        self.of(key).filter(|value| *value > 0.0)
    }

    /// Returns a count, limited to the largest that can be drawn.
    pub(crate) fn count(&self, key: &str, neutral: u32, most: u32) -> u32 {
        let count = self.of(key).unwrap_or_else(|| f64::from(neutral)).clamp(1.0, f64::from(most));
        (1..=most).rev().find(|each| f64::from(*each) <= count).unwrap_or(1)
    }

    /// Returns the position of the mechanism at which it is drawn \[rad\].
    pub(crate) fn start_rad(&self) -> f64 {
        self.of("start_angle").unwrap_or(0.0)
    }

    /// Returns the lowest and highest position over the motion \[rad\].
    pub(crate) const fn motion_rad(&self) -> Option<[f64; 2]> {
        self.motion_rad
    }

    /// Returns the scale [sheet/m] and the initial place of a part moving along a line between two places of the sheet.
    ///
    /// A motion is scaled to fit, at most to the given scale; without one the part starts at the neutral place.
    pub(crate) fn along(&self, per_rad: f64, scale: f64, [from, to]: [f64; 2], neutral: f64) -> (f64, f64) {
        let Some([low, high]) = self.motion_rad else { return (scale, neutral) };
        let room = to - from;
        let stroke = (high - low) * per_rad.abs();
        let scale = if stroke * scale > room { room / stroke } else { scale };
        let ahead = if per_rad < 0.0 { high - self.start_rad() } else { self.start_rad() - low };
        (scale, from + 0.5 * (room - stroke * scale) + ahead * per_rad.abs() * scale)
    }
}
