//! Quadrature counter for the edges of two tracks.

/// Error: both tracks changed at once, so an edge was missed and the direction of rotation is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MissedEdge;

/// Counter of the edges of two tracks, four per period; counts up while the first track leads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Quadrature {
    count: i64,
    last: Option<[bool; 2]>,
    missed: u64,
}

impl Quadrature {
    /// Returns the quarter of the period, numbered in their order while the first track leads.
    const fn quarter([a, b]: [bool; 2]) -> u8 {
        match (a, b) {
            (true, false) => 0,
            (true, true) => 1,
            (false, true) => 2,
            (false, false) => 3,
        }
    }

    /// Evaluates the levels of both tracks.
    ///
    /// # Errors
    /// Both levels changed since the last call; the count stays, and the miss is counted.
    pub const fn take(&mut self, tracks: [bool; 2]) -> Result<(), MissedEdge> {
        let Some(last) = self.last.replace(tracks) else { return Ok(()) };
        match (Self::quarter(tracks) + 4 - Self::quarter(last)) % 4 {
            1 => self.count = self.count.saturating_add(1),
            3 => self.count = self.count.saturating_sub(1),
            2 => {
                self.missed = self.missed.saturating_add(1);
                return Err(MissedEdge);
            }
            _ => {}
        }
        Ok(())
    }

    /// Returns the number of edges since the first sample, with sign.
    #[must_use]
    pub const fn count(&self) -> i64 {
        self.count
    }

    /// Returns the number of missed edges.
    #[must_use]
    pub const fn missed(&self) -> u64 {
        self.missed
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::SquareTracks;
    use quantities::{Angle, Measure};
    use std::f64::consts::TAU;

    /// 2048 lines yield the 8192 steps of table 61.1 in both directions.
    #[test]
    fn a_turn_has_four_edges_a_line() {
        for direction in [1.0, -1.0] {
            let mut counter = Quadrature::default();
            for at in 0..=20_000 {
                let angle = direction * TAU * f64::from(at) / 20_000.0 + 1e-5;
                counter.take(SquareTracks { periods: 2048 }.at(Angle::from_si(angle))).unwrap();
            }
            assert_eq!((counter.count(), counter.missed()), (if direction > 0.0 { 8192 } else { -8192 }, 0));
        }
    }

    #[test]
    fn a_missed_edge_is_counted_and_not_guessed() {
        let mut counter = Quadrature::default();
        counter.take([true, false]).unwrap();
        assert_eq!(counter.take([false, true]), Err(MissedEdge));
        assert_eq!((counter.count(), counter.missed()), (0, 1));
        counter.take([false, false]).unwrap();
        assert_eq!(counter.count(), 1);
    }
}
