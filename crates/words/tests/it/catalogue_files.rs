//! Every fault of a catalogue file has a sentence in both languages, and names its place.
#![allow(clippy::unwrap_used, reason = "a test fails loudly")]

use axis::{AxisDiagnostic, AxisFault};
use quantities::Language;

#[test]
fn faults_of_catalogue_files_have_their_sentences() {
    let id = || "XD-20".to_owned();
    let all = [
        AxisFault::NoPrice,
        AxisFault::UnknownMaker { name: "Drives".to_owned(), makers: vec!["Example Drives".to_owned()] },
        AxisFault::NoProducts,
        AxisFault::ProductNamedTwice { id: id(), line: 7 },
        AxisFault::ProductOfTwoFiles { id: id() },
        AxisFault::ProductNamedAsCode { id: id() },
        AxisFault::NothingOffered,
    ];
    for fault in all {
        let found = Box::new(AxisDiagnostic::at("\n ab", 2..3, fault.clone(), None));
        let within = AxisFault::InCatalogue { name: "stock.csv".to_owned(), found };
        assert_eq!(within.id(), fault.id());
        let told = |language| {
            let faults = [fault.clone(), within.clone()].map(|fault| AxisDiagnostic::at("", 0..0, fault, None));
            words::worded(&faults, language)
        };
        let [en, de] = [Language::En, Language::De].map(told);
        for (en, de) in en.iter().zip(&de) {
            assert!(en.message != de.message && !de.message.is_empty(), "{en:?}");
            assert_eq!(en.hint.is_some(), de.hint.is_some(), "{en:?}");
        }
        let (alone, placed) = (&en.first().unwrap().message, &en.last().unwrap().message);
        assert_eq!(*placed, format!("stock.csv, line 2, column 2: {alone}"));
    }
}
