//! Ambient temperatures at which an actuator fits.

use numeric::border;

/// Range of ambient temperatures, −20 °C to 80 °C \[K\].
const AMBIENT_RANGE: (f64, f64) = (253.15, 353.15);

/// Step of the search \[K\].
const AMBIENT_STEP: f64 = 5.0;

/// Returns both sides of the ends of the ambient temperatures at which the actuator fits \[K\], the lower and the upper one:
/// those about the present temperature, or the nearest ones, below it first. An end outside the range is `None`: no check that
/// was made depends on the temperature there. `narrow` is the distance of the two sides as a share of a step. `None` if it
/// fits at no temperature of the range.
#[allow(clippy::type_complexity, reason = "two sides of two ends")]
pub(super) fn ambient_region<S>(
    present: f64,
    narrow: f64,
    mut excess: impl FnMut(f64) -> Result<f64, S>,
) -> Result<Option<[Option<(f64, f64)>; 2]>, S> {
    let (low, high) = AMBIENT_RANGE;
    let mut inside = (present, excess(present)?);
    if inside.1 > 0.0 {
        let mut nearest = None;
        for sense in [-1.0, 1.0] {
            let mut outside = inside;
            while nearest.is_none() && (low..=high).contains(&(outside.0 + sense * AMBIENT_STEP)) {
                let kelvin = outside.0 + sense * AMBIENT_STEP;
                let here = (kelvin, excess(kelvin)?);
                if here.1 <= 0.0 { nearest = Some(here) } else { outside = here }
            }
        }
        let Some(found) = nearest else { return Ok(None) };
        inside = found;
    }
    let mut ends = [None; 2];
    for (sense, end) in [-1.0, 1.0].into_iter().zip(&mut ends) {
        let mut last = inside;
        while (low..=high).contains(&last.0) {
            let kelvin = last.0 + sense * AMBIENT_STEP;
            let here = (kelvin, excess(kelvin)?);
            if here.1 > 0.0 {
                *end = Some(border(&mut excess, last, here, narrow)?);
                break;
            }
            last = here;
        }
    }
    Ok(Some(ends))
}
