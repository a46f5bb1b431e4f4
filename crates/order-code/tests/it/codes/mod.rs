//! Every code of the grammar, for the tests.

use order_code::{Brake, Feedback, Option1, Option2, OrderCode, Ratio, Series, Size, Winding};

/// 8 sizes × 6 ratios × 4 windings × 5 feedbacks × 2 × 2 × 4 × 2 = 30 720 codes.
pub(crate) fn every_code() -> Vec<OrderCode> {
    let mut codes = Vec::new();
    let series = Series::default();
    let options_1 = || std::iter::once(None).chain(Option1::all(series).map(Some));
    let options_2 = || std::iter::once(None).chain(Option2::all(series).map(Some));
    for size in Size::all(series) {
        for ratio in Ratio::all(series) {
            for winding in Winding::all(series) {
                for feedback in Feedback::all(series) {
                    for &brake in Brake::ALL {
                        for option_1 in options_1() {
                            for option_2 in options_2() {
                                for special in [false, true] {
                                    codes.push(OrderCode {
                                        size,
                                        ratio,
                                        winding,
                                        feedback,
                                        brake,
                                        option_1,
                                        option_2,
                                        special,
                                    });
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    assert_eq!(codes.len(), 30_720);
    codes
}
