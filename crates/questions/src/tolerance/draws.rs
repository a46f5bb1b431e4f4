//! Samples: one stream of numbers from a seed, of which sample i uses the draws i k to i k + k − 1.

use project::Tolerance;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

/// Increment of the generator, any fixed number: only the seed distinguishes the streams.
const STREAM: u128 = 0x0a02_bdbf_7bb3_c0a7_ac28_fa16_a64a_bf96;

/// Steps that separate seeds differing by one, so that their streams begin differently.
const MIX: u128 = 0x9e37_79b9_7f4a_7c15_f39c_c060_5ced_c835;

/// Generator settings of the samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Draws {
    pub(super) seed: u64,
    /// Number of draws of each sample.
    pub(super) quantities: usize,
}

/// Stream of numbers from one sample on.
#[derive(Clone, Debug)]
pub(super) struct Stream(Pcg64);

impl Draws {
    /// Returns the stream from the first number of a sample on.
    pub(super) fn from(self, sample: usize) -> Stream {
        Stream(self.generator(sample as u128 * self.quantities as u128))
    }

    fn generator(self, skipped: u128) -> Pcg64 {
        let mut generator = Pcg64::new(u128::from(self.seed).wrapping_mul(MIX), STREAM);
        generator.advance(skipped);
        generator
    }

    /// Returns the values of one sample in SI.
    pub(super) fn sample(self, sample: usize, tolerances: &[Tolerance]) -> Vec<f64> {
        let mut values = vec![0.0; self.quantities];
        self.from(sample).next_into(tolerances, &mut values);
        values
    }

    /// Iterates over the draws of one quantity in the order of the samples; they increase with the values.
    pub(super) fn column(self, quantity: usize, samples: usize) -> impl Iterator<Item = u64> {
        let mut generator = self.generator(quantity as u128);
        let others = self.quantities.saturating_sub(1) as u128;
        (0..samples).map(move |_| {
            let drawn = drawn(&mut generator);
            generator.advance(others);
            drawn
        })
    }
}

impl Stream {
    /// Writes the values of the next sample in SI: uniform within each band.
    pub(super) fn next_into(&mut self, tolerances: &[Tolerance], values: &mut [f64]) {
        for (value, tolerance) in values.iter_mut().zip(tolerances) {
            // 53 bits are the fraction of a double: 0 to 1 − 2⁻⁵³.
            #[allow(clippy::cast_precision_loss, reason = "53 bits are exact")]
            let share = drawn(&mut self.0) as f64 / (1_u64 << 53) as f64;
            *value = tolerance.at(2.0 * share - 1.0);
        }
    }
}

/// Returns 53 random bits.
fn drawn(generator: &mut Pcg64) -> u64 {
    generator.next_u64() >> 11
}
