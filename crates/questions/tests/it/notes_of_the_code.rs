//! The answers about a code name no other encoder in their notes, and no value as stated that the checks correct.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use quantities::Language;
use questions::{CheckId, ProductId};
use std::collections::BTreeSet;

#[test]
fn notes_of_the_wiring_name_no_other_encoder() {
    let products = questions::embedded_catalogue().products(false);
    let tokens: BTreeSet<&str> =
        products.iter().filter_map(|each| each.feedback.as_ref().map(|each| each.as_str())).collect();
    let mut seen = 0;
    for product in products.iter().step_by(7) {
        let (Some(code), Some(own)) = (product.id.order_code(), product.feedback) else { continue };
        let Some(wiring) = installation::wiring::wiring(code) else { continue };
        for note in questions::answer::wiring(&wiring, None, Language::En).notes {
            let head = note.text.split(':').next().unwrap_or_default();
            assert!(head == own.as_str() || !tokens.contains(head), "{code}: {}", note.text);
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

/// Mean speed and mean input speed are one figure by two limits of the same share.
#[test]
fn of_equal_shares_the_limit_of_the_actuator_governs() {
    let text = include_str!("../../../../examples/two-axes.toml");
    let mut ties = 0;
    for project in questions::read_all(text, &axis::NoFiles).unwrap() {
        for product in questions::embedded_catalogue().products(false).iter().step_by(5) {
            let id: ProductId = product.id.clone();
            let Ok(found) = questions::check(&project, &id) else { continue };
            let share =
                |of| found.judgement.checks.iter().find(|check| check.id == of).and_then(|check| check.utilisation);
            let (Some(own), Some(other)) = (share(CheckId::MeanSpeed), share(CheckId::GearMeanInputSpeed)) else {
                continue;
            };
            let Some(governing) = found.judgement.governing() else { continue };
            if governing.is_of_another_gear() {
                assert!(other > own * (1.0 + 1e-9), "{id}: {own} {other}");
            }
            ties += usize::from((other / own - 1.0).abs() < 1e-9);
        }
    }
    assert!(ties > 0);
}
