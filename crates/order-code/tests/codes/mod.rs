//! Every code of the grammar, for the tests.

use order_code::{Brake, Feedback, Option1, Option2, OrderCode, Ratio, Size, Winding};

/// 8 sizes × 6 ratios × 4 windings × 5 feedbacks × 2 × 2 × 4 × 2 = 30 720 codes.
pub(crate) fn every_code() -> Vec<OrderCode> {
    let mut codes = Vec::new();
    for &size in Size::ALL {
        for &ratio in Ratio::ALL {
            for &winding in Winding::ALL {
                for &feedback in Feedback::ALL {
                    for &brake in Brake::ALL {
                        for option_1 in [None, Some(Option1::EC)] {
                            for option_2 in [None, Some(Option2::K), Some(Option2::R), Some(Option2::S)] {
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
