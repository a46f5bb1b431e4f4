//! Bisection of points by their signals: repeated splitting along the signal with the widest spread. Points that end up
//! together are close in the signals, independent of time.

/// Some signals of an item in single precision, which is sufficient to find neighbours.
#[derive(Clone, Copy)]
pub(super) struct Point<const N: usize> {
    pub(super) signals: [f32; N],
    /// Index of the item.
    pub(super) index: u32,
}

/// Returns the range (largest minus smallest value) of each signal.
fn spread<const N: usize>(points: &[Point<N>]) -> [f32; N] {
    let (mut low, mut high) = ([f32::INFINITY; N], [f32::NEG_INFINITY; N]);
    for point in points {
        for ((low, high), value) in low.iter_mut().zip(&mut high).zip(point.signals) {
            *low = if value < *low { value } else { *low };
            *high = if value > *high { value } else { *high };
        }
    }
    let mut spread = [0.0; N];
    spread.iter_mut().zip(low).zip(high).for_each(|((spread, low), high)| *spread = high - low);
    spread
}

/// Returns the reciprocal of the range of each signal; zero for a constant signal.
pub(super) fn scale<const N: usize>(points: &[Point<N>]) -> [f32; N] {
    spread(points).map(|spread| if spread > 0.0 { 1.0 / spread } else { 0.0 })
}

/// Partitions the points at the median of the signal with the widest scaled spread and returns the index of the split.
pub(super) fn halve<const N: usize>(points: &mut [Point<N>], scale: &[f32; N]) -> usize {
    let spread = spread(points);
    let mut widest = (0, 0.0);
    for (signal, (spread, scale)) in spread.iter().zip(scale).enumerate() {
        if spread * scale > widest.1 {
            widest = (signal, spread * scale);
        }
    }
    let middle = points.len() / 2;
    let key = |point: &Point<N>| point.signals.get(widest.0).copied().unwrap_or(0.0);
    points.select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)));
    middle
}
