//! Faults and departures: what is named, where, and with which hint.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "a test fails loudly"
)]

use order_code::{CodeError, Departure, Field, Pattern, Series, parse};
use std::ops::Range;

type Found = (String, Range<usize>, Option<&'static str>);

fn found(text: &str) -> Vec<Found> {
    let faults = parse(text).unwrap_err();
    faults.iter().map(|fault| (fault.to_string(), fault.span(), fault.nearest())).collect()
}

fn only(text: &str) -> CodeError {
    let faults = parse(text).unwrap_err();
    let all: Vec<&CodeError> = faults.iter().collect();
    assert_eq!(all.len(), 1, "{text}: {all:?}");
    all[0].clone()
}

fn say(message: &str, span: Range<usize>, nearest: Option<&'static str>) -> Found {
    (message.to_owned(), span, nearest)
}

const OPTIONS: [&str; 6] = ["B", "EC", "K", "R", "S", "SP"];

#[test]
fn every_fault_at_once_with_its_place() {
    assert_eq!(
        found("CHA-21A-101-H-C1025"),
        [
            say("\"21A\" is no size", 4..7, Some("20A")),
            say("\"101\" is no ratio", 8..11, Some("100")),
            say("\"C1025\" is no feedback", 14..19, Some("C1024")),
        ]
    );
    let all = parse("CHA-21A-101-H-C1025").unwrap_err().to_string();
    assert_eq!(all, "\"21A\" is no size; \"101\" is no ratio; \"C1025\" is no feedback");
}

#[test]
fn nothing_is_empty() {
    for text in ["", " ", " \t\n"] {
        assert_eq!(only(text), CodeError::Empty);
    }
    assert_eq!(CodeError::Empty.expected(), ["CHA"]);
}

#[test]
fn a_long_text_is_refused_from_the_first_character_too_many() {
    let fault = only(&"é".repeat(65));
    assert_eq!(fault.span(), 128..130);
    assert!(matches!(fault, CodeError::TooLong { most: 64, .. }));
    let padded = format!("{}CHA-20A-100-H-C1024-B-EC-K-SP", " ".repeat(35));
    assert_eq!(padded.len(), 64);
    assert!(parse(&padded).is_ok());
}

#[test]
fn a_hyphen_with_nothing_is_refused() {
    for (text, span) in [
        ("CHA--20A-100-H-C1024", 3..5),
        ("CHA - - 20A-100-H-C1024", 3..8),
        ("-CHA-20A-100-H-C1024", 0..1),
        ("-", 0..1),
        ("---", 0..3),
    ] {
        let fault = only(text);
        assert!(matches!(fault, CodeError::EmptyPart { .. }), "{text}: {fault:?}");
        assert_eq!((fault.span(), fault.expected().len()), (span, 0), "{text}");
    }
    let last = only("CHA-20A-100-H-C1024-");
    assert_eq!((last.span(), last.expected()), (19..20, OPTIONS.to_vec()));
    let last = only("CHA-20A-100-H-C1024-EC--");
    assert_eq!((last.span(), last.expected()), (22..24, vec!["K", "R", "S", "SP"]));
    let both = parse("CHA-20A-100-H-").unwrap_err();
    assert!(both.iter().any(|fault| fault.span() == (13..14) && fault.expected().contains(&"RES")));
    assert!(both.iter().any(|fault| matches!(fault, CodeError::Missing { field: Field::Feedback, at: 13, .. })));
}

#[test]
fn what_is_missing_is_named_with_its_place() {
    for (text, field, at) in [
        ("20A-100-H-C1024", Field::Series, 0),
        ("20A100HC1024B", Field::Series, 0),
        ("CHA-100-H-C1024", Field::Size, 4),
        ("CHA-20A-H-C1024", Field::Ratio, 8),
        ("CHA-20A-100-C1024", Field::Winding, 12),
        ("CHA-20A-100-H", Field::Feedback, 13),
        ("CHA-20A-100-H-B", Field::Feedback, 14),
        ("CHA20A100HBEC", Field::Feedback, 10),
    ] {
        let fault = only(text);
        assert_eq!(fault, CodeError::Missing { field, at, series: Series::default() }, "{text}");
        assert_eq!((fault.span(), fault.expected()), (at..at, Series::default().words(field).to_vec()));
    }
    assert_eq!(
        found("CHA-20A"),
        [
            say("ratio is missing", 7..7, None),
            say("winding is missing", 7..7, None),
            say("feedback is missing", 7..7, None),
        ]
    );
}

#[test]
fn an_unknown_word_has_the_nearest_as_hint() {
    for (text, field, nearest) in [
        ("CHA-20-100-H-C1024", Field::Size, Some("20A")),
        ("CHA-2A0-100-H-C1024", Field::Size, Some("20A")),
        ("CHA-A20-100-H-C1024", Field::Size, None),
        ("CHA-20AA-100-H-C1024", Field::Size, Some("20A")),
        ("CAH-20A-100-H-C1024", Field::Series, Some("CHA")),
        ("FHA-20A-100-H-C1024", Field::Series, Some("CHA")),
        ("CHA-20A-10-H-C1024", Field::Ratio, Some("100")),
        ("CHA-20A-100-X-C1024", Field::Winding, None),
        ("CHA-20A-100-H-C1O24", Field::Feedback, Some("C1024")),
        ("CHA-20A-100-H-RE", Field::Feedback, Some("RES")),
        ("CHA-20A-100-H-C1024-CE", Field::Option1, Some("EC")),
        ("CHA-20A-100-H-C1024-SQ", Field::Special, Some("SP")),
        ("CHA-20A-100-H-C1024-*", Field::Brake, None),
        ("CHA-*-100-H-C1024", Field::Size, None),
        ("CHA-20A-100-H-C1024-SP-SQ", Field::Special, None),
    ] {
        let fault = only(text);
        assert!(matches!(&fault, CodeError::UnknownToken { field: found, .. } if *found == field), "{text}: {fault:?}");
        assert_eq!(fault.nearest(), nearest, "{text}");
    }
    assert_eq!(only("CHA-20A-100-X-C1024").expected(), ["E", "H", "L", "N"]);
    assert_eq!(only("CHA-20A-100-H-C1024-X").expected(), OPTIONS);
    assert_eq!(only("CHA-20A-100-H-C1024-EC-X-SP").expected(), ["K", "R", "S", "SP"]);
    assert!(only("CHA-20A-100-H-C1024-SP-X").expected().is_empty());
}

#[test]
fn a_word_that_belongs_nowhere_hides_nothing_behind_it() {
    assert_eq!(found("CHA-X-20A-100-H-C1024"), [say("\"X\" is no size", 4..5, None)]);
    assert_eq!(found("CHA-20A-100-H-C1024-X-B"), [say("\"X\" is no brake", 20..21, None)]);
    assert_eq!(found("CHA_20A-100-H-C1024"), [say("\"_20A\" is no size", 3..7, Some("20A"))]);
}

#[test]
fn a_word_in_the_wrong_place_is_reported_from_a_missing_one() {
    for (text, field, span, expected) in [
        ("CHA-20A-100-C1024-H", Field::Feedback, 12..17, vec!["E", "H", "L", "N"]),
        ("CHA20A100C1024H", Field::Feedback, 9..14, vec!["E", "H", "L", "N"]),
        ("CHA-100-20A-H-C1024", Field::Ratio, 4..7, Series::default().words(Field::Size).to_vec()),
        ("20A-CHA-100-H-C1024", Field::Size, 0..3, vec!["CHA"]),
        ("CHA-20A-100-H-C1024-EC-B", Field::Brake, 23..24, vec!["K", "R", "S", "SP"]),
        ("CHA-20A-100-H-C1024-ECB", Field::Brake, 22..23, vec!["K", "R", "S", "SP"]),
        ("CHA-20A-100-H-B-C1024", Field::Brake, 14..15, Series::default().words(Field::Feedback).to_vec()),
        ("CHA-20A-100-H-C1024-SP-K", Field::Option2, 23..24, vec![]),
    ] {
        let fault = only(text);
        assert!(matches!(&fault, CodeError::OutOfOrder { field: found, .. } if *found == field), "{text}: {fault:?}");
        assert_eq!((fault.span(), fault.expected()), (span, expected), "{text}");
    }
}

#[test]
fn a_field_twice_is_reported_at_the_second() {
    for (text, field, span) in [
        ("CHA-20A-100-H-C1024-B-B", Field::Brake, 22..23),
        ("CHA-20A-100-H-C1024-B-EC-B", Field::Brake, 25..26),
        ("CHA-20A-25A-100-H-C1024", Field::Size, 8..11),
        ("CHA-20A-100100-H-C1024", Field::Ratio, 11..14),
        ("CHA-20A-100-H-C1024-RES", Field::Feedback, 20..23),
        ("CHA-20A-100-H-C1024-K-R", Field::Option2, 22..23),
    ] {
        let fault = only(text);
        assert!(matches!(&fault, CodeError::Repeated { field: found, .. } if *found == field), "{text}: {fault:?}");
        assert_eq!(fault.span(), span, "{text}");
    }
    // Single letters in a row are rather a typing error than words.
    assert_eq!(found("CHA-20A-100-HH-C1024"), [say("\"H\" is no feedback", 13..14, None)]);
}

#[test]
fn without_hyphens_the_fault_is_still_found() {
    assert_eq!(found("CHA21A100HC1024"), [say("\"21A\" is no size", 3..6, Some("20A"))]);
    assert_eq!(found("CHA20A100HC1025"), [say("\"C1025\" is no feedback", 10..15, Some("C1024"))]);
    assert_eq!(found("CHA-20A-101HC1024"), [say("\"101\" is no ratio", 8..11, Some("100"))]);
    // Two faults in one run: the first hides the rest, and nothing is called missing.
    assert_eq!(found("CHA21A101HC1025"), [say("\"21A101HC1025\" is no size", 3..15, None)]);
}

#[test]
fn strange_characters_are_shown_escaped_at_their_place() {
    assert_eq!(found("CHA-20A\u{7}-100-H-C1024"), [say("\"20A\\u{7}\" is no size", 4..8, Some("20A"))]);
    assert_eq!(found("CHA-20A-100-ſ-C1024"), [say("\"ſ\" is no winding", 12..14, None)]);
    assert_eq!(found("CHA-20A-100-H-C1024-ſP"), [say("\"ſP\" is no special design", 20..23, Some("SP"))]);
    assert_eq!(found("CHA-20A\t100-H-C1024"), [say("\"\\t100\" is no ratio", 7..11, Some("100"))]);
}

#[test]
fn departures_say_what_was_written() {
    let of = |text: &str| parse(text).unwrap().departures;
    assert_eq!(
        of("cha 20a100-H-C1024"),
        [
            Departure::LowerCase { span: 0..3 },
            Departure::Spaces { span: 3..4 },
            Departure::LowerCase { span: 4..7 },
            Departure::MissingHyphen { at: 7 },
        ]
    );
    assert_eq!(
        of(" CHA – 20A-100-H-C1024"),
        [Departure::SurroundingSpace, Departure::Spaces { span: 4..9 }, Departure::OtherDash { span: 5..8 }]
    );
    // cha-manual table 11.1 prints its example with spaces.
    let printed = parse("CHA - 20A - 100 - H - C1024 - B - EC - K - SP").unwrap();
    assert_eq!(printed.code.to_string(), "CHA-20A-100-H-C1024-B-EC-K-SP");
    assert_eq!(printed.departures.len(), 8);
}

#[test]
fn a_fault_of_a_pattern_has_its_place_too() {
    let fault = |text: &str| Pattern::parse(text).unwrap_err().iter().next().cloned().unwrap();
    assert_eq!((fault("CHA-2*").span(), fault("CHA-20A*").nearest()), (4..6, Some("20A")));
    assert_eq!(fault("CHA-20A-").expected(), Series::default().words(Field::Ratio));
    assert_eq!(fault("20A"), CodeError::Missing { field: Field::Series, at: 0, series: Series::default() });
}
