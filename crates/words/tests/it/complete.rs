//! Every identifier has its words in both languages, and they are not the same words.

use crate::marks::{FACTOR, WRONG, has_own_marks, x};
use actuator::{BatteryFault, CurveFault, CurveKind};
use axis::{Assumption, AxisFault, CycleFault};
use configurator::{BrokenRule, Rule, Unmet};
use mechanism::{BodyError, Geometry, TableFault};
use motion::{MoveFault, Needed, PointsFault, RecordedFault};
use order_code::{Brake, CodeError, Field};
use project::{BODY_SHAPES, Expected, Fault, FileTrouble, Hint, Range, SegmentLaw, Unopened};
use provenance::{Grade, Source};
use quantities::unit::{KILOGRAM, MILLIMETRE, NEWTON_METRE, SECOND};
use quantities::{Dimension, Language, Measure, QuantityError};
use recording::{Damage, FileRow, Limit};
use sizing::{Amount, BrakeStop, Budget, CheckId, Fit, Note, ResonanceSpeeds, TooManyInstants, Verdict};
use std::io::ErrorKind;

/// Both are there, German is not English, and figures have the mark of the language.
fn differ(what: &str, text: impl Fn(Language) -> String) {
    let (en, de) = (text(Language::En), text(Language::De));
    has_own_marks(what, &en, Language::En);
    has_own_marks(what, &de, Language::De);
    assert!(!en.trim().is_empty() && !de.trim().is_empty(), "{what}: \"{en}\", \"{de}\"");
    assert_ne!(en, de, "{what}");
}

fn q<Q: Measure>(si: f64) -> Q {
    Q::from_si(x(si))
}

/// Every text with values that have decimals, thousands or a power of ten.
#[test]
fn figures_have_the_decimal_mark_of_their_language() {
    for factor in [0.5, 1.2345, 1234.5, 1e-7, 3.3e5] {
        FACTOR.set(factor);
        checks_and_verdicts();
        assumptions_laws_shapes_and_fields();
        terms_of_the_glossary();
        rules_requirements_and_codes();
        notes();
        faults_and_hints();
    }
    let wrong = WRONG.take();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn checks_and_verdicts() {
    for id in CheckId::ALL {
        differ(id.id(), |language| words::check_title(*id, language));
    }
    for verdict in [Verdict::Pass, Verdict::Fail, Verdict::Advice, Verdict::NotChecked] {
        differ(verdict.id(), |language| words::verdict_word(verdict, language));
    }
    for grade in [Grade::Printed, Grade::Computed, Grade::Published, Grade::Estimated, Grade::Assumed] {
        differ(grade.id(), |language| words::grade_word(grade, language).to_owned());
        differ(grade.id(), |language| words::grade_about(grade, language).to_owned());
    }
    for kind in [CurveKind::Continuous, CurveKind::S3 { duty: q(0.5), cycle: q(60.0) }, CurveKind::ShortTime] {
        differ("curve", |language| words::curve_title(&kind, language));
    }
    for (fit, open) in [(Fit::Fits, 0), (Fit::Fits, 1), (Fit::FitsIfEstimate, 2), (Fit::DoesNotFit, 0)] {
        for (unheld, failed) in [(false, 0), (true, 0), (false, 1), (false, 2)] {
            let counts =
                words::Counts { failed, not_checked: open, requirements_open: open, ..words::Counts::default() };
            for (estimates, ratings) in [("T_rms 110 %", ""), ("", "T_av 112 %"), ("T_rms 110 %", "T_av 112 %")] {
                let provisos = words::Provisos { estimates: estimates.to_owned(), ratings: ratings.to_owned() };
                differ("standing", |language| words::standing_text(fit, &provisos, unheld, &counts, language));
            }
        }
    }
    differ("ranking", |language| words::ranking_rule(false, language) + &words::ranking_rule(true, language));
}

#[test]
fn assumptions_laws_shapes_and_fields() {
    for assumption in Assumption::ALL {
        differ(&format!("{assumption:?}"), |language| words::assumption_text(assumption, language));
    }
    for law in SegmentLaw::all() {
        differ(law.id(), |language| words::law_text(law, language).to_owned());
    }
    for shape in &BODY_SHAPES {
        differ(shape.name, |language| words::shape_title(shape, language).to_owned());
    }
    for field in Field::ALL.iter().copied() {
        differ(&format!("{field:?}"), |language| words::describe_field(field, language).to_owned());
    }
}

#[test]
fn terms_of_the_glossary() {
    for term in catalogue::glossary() {
        for language in [Language::En, Language::De] {
            let text = words::symbol_term(term.symbol, language);
            // Of a column that is a word itself the English term is that word.
            assert!(!text.is_empty() && (text != term.symbol || text == term.identifier), "{}: {text}", term.symbol);
        }
    }
}

#[test]
fn rules_requirements_and_codes() {
    let code = order_code::parse("CHA-20A-50-H-C1024-B-K").unwrap().code;
    let only_with = |longer| Rule::OnlyWith { feedback: code.feedback, longer };
    let rules = [Rule::NotForSize, Rule::PairNotListed, Rule::NotInOrderingTables, only_with(""), only_with("1")];
    for rule in rules {
        let broken = BrokenRule { field: Field::Option2, rule, table: "12.1" };
        differ(&format!("{rule:?}"), |language| words::describe_rule(&code, &broken, language));
    }
    let unmet = [
        Unmet::Feedback(code.feedback),
        Unmet::Brake(Brake::With),
        Unmet::Brake(Brake::Without),
        Unmet::HollowShaft { has: q(0.01), needs: q(0.02) },
        Unmet::Length { has: q(0.2), permits: q(0.1) },
        Unmet::Mass { has: q(2.0), permits: q(1.0) },
        Unmet::SupplyTooLow { needs: q(300.0), gives: q(200.0) },
        Unmet::NotKnown { symbol: "d_H", requires: 0.02 },
        Unmet::NotKnown { symbol: "m", requires: 1.0 },
        Unmet::NotKnown { symbol: "U_M", requires: 560.0 },
    ];
    for each in unmet {
        differ(&format!("{each:?}"), |language| words::unmet_text(&each, language));
    }
    let sources = [
        Source::Equation { number: "69.1" },
        Source::Model { name: "thermal" },
        Source::Project { key: "load.inertia".into() },
    ];
    for source in &sources {
        differ(&format!("{source:?}"), |language| words::source_text(source, language));
    }
}

#[test]
fn every_named_model_has_its_page() {
    let pages = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/theory");
    for (id, ..) in words::MODELS {
        assert!(pages.join(format!("{id}.md")).is_file(), "{id}");
        differ(id, |language| words::model_name(id, language).to_owned());
    }
}

#[test]
fn notes() {
    let figure = Amount { si: x(1.0), unit: &NEWTON_METRE };
    let errors = actuator::ErrorBudget::default();
    let speeds = [(q(1.0), q(2.0)); 3];
    let stop =
        |permitted| Note::BrakeStop(Box::new(BrakeStop { angle: q(1.0), time: q(1.0), energy: q(1.0), permitted }));
    let all = [
        Note::FrictionTemperatures { cold: q(293.0), settled: Some(q(333.0)) },
        Note::FrictionExtrapolated { low: x(0.5), high: x(2.0) },
        Note::UntilWarm,
        Note::LargestCurrentElsewhere { current: q(3.0), time: q(0.5) },
        Note::CurveAboveLargestCurrent { current: q(9.0) },
        Note::EstimatedUpTo(figure),
        Note::PermittedByCurve(figure),
        Note::InsideBand,
        Note::RiseAbove(q(313.0)),
        Note::CycleNotShort { cycle: q(100.0), time_constant: q(60.0) },
        Note::BrakingTorqueAssumed,
        Note::RecommendationForHighDynamics { factor: x(3.0) },
        Note::SwingTooSmall { swing: q(0.05), least: q(0.09) },
        Note::SmallSwings { count: 3, largest: q(0.05), share: x(0.5), least: q(0.09) },
        Note::RatingOfInterchangeableGear,
        Note::RatingByStrongerGear,
        Note::NotDeratedForAltitude,
        Note::DeratesThisCheckOnly,
        Note::Protection {
            required: actuator::Protection { solids: 5, water: 4 },
            printed: actuator::Protection { solids: 6, water: 5 },
        },
        Note::LoadsOneAtATime,
        Note::AtOneInstant(figure),
        Note::WarmUp(q(600.0)),
        Note::Housing(q(330.0)),
        Note::HangingLoad,
        Note::Sag(q(0.01)),
        stop(Some(x(10.0))),
        stop(None),
        Note::BrakeDoesNotStop,
        Note::NothingHolds,
        Note::NoBearingLoad,
        Note::NothingHoldsWithoutPower,
        Note::DwellTooShortForBrake { shortest: q(0.05), needed: q(0.1) },
        Note::BrakeTimesAssumed,
        Note::BrakingsLast { each_cycle: x(2.0), lasts: Some(q(3.6e6)) },
        Note::BrakingsLast { each_cycle: x(2.0), lasts: None },
        Note::DcLinkRises { to: q(700.0), free: q(100.0) },
        Note::TripsAtStallCurrent(q(2.1)),
        Note::AboveEndOfCurve { speed: q(30.0), end: q(25.0) },
        Note::NoChopperThreshold { supply: q(48.0), limit: q(48.0) },
        Note::Ratcheting { ratcheting: q(100.0), buckling: Some(q(200.0)) },
        Note::NoBrake,
        Note::EnergyPerCycle { motoring: q(10.0), regenerated: q(1.0), peak: q(5.0) },
        Note::CollisionsPermitted(x(100.0)),
        Note::Capacitor { energy: q(10.0), capacitance_f: x(1e-3) },
        Note::ReferenceLost { turns: x(4096.0) },
        Note::NeedsReferencing,
        Note::NoSpeedHeld,
        Note::WithAnyInertia,
        Note::BatteryExchange { recommended: q(1e8), latest: q(2e8) },
        Note::ApprovalNeeded,
        Note::RopeSlack(Box::new(sizing::RopeSlack { times: vec![(mechanism::Rope::Load, q(0.1), q(0.2)); 6] })),
        Note::ResonanceSpeeds(Box::new(ResonanceSpeeds { blocked: speeds, free: Some(speeds) })),
        Note::FreeRotor(q(10.0)),
        Note::Budget(Box::new(Budget { errors, deviation: Some(q(1e-4)), is_along_the_line: true })),
        Note::Erratum(catalogue::errata().first().map_or("", |erratum| erratum.id)),
    ];
    for note in &all {
        differ(&format!("{note:?}"), |language| words::note_text(note, language));
    }
}

fn move_faults() -> Vec<AxisFault> {
    let needed = [
        Needed::TwoOfFour,
        Needed::TwoOrThreeOfFour,
        Needed::DistanceAndLimits,
        Needed::DistanceAndTime,
        Needed::DistanceSpeedAcceleration,
        Needed::SpeedAndTimeOrDistance,
    ];
    let mut all: Vec<MoveFault> =
        needed.into_iter().map(|needed| MoveFault::NotDetermined { given: 1, needed }).collect();
    all.extend(needed.map(|needed| MoveFault::NotDetermined { given: needed.most() + 1, needed }));
    all.extend([
        MoveFault::NoSegment,
        MoveFault::NoDuration,
        MoveFault::NoTimeToChangeSpeed { braking: true },
        MoveFault::NoTimeToChangeSpeed { braking: false },
        MoveFault::OutOfRange,
        MoveFault::SpeedTooLow { above: q(1.0) },
        MoveFault::SpeedTooHigh { most: q(1.0) },
        MoveFault::AccelerationTooLow { least: q(1.0) },
        MoveFault::RestToRestOnly,
        MoveFault::EndSpeedAboveLimit,
        MoveFault::StillMoving { speed: q(1.0) },
        MoveFault::PointsSpeedJumps { first: q(1.0), before: q(2.0) },
        MoveFault::RecordingSpeedJumps { first: q(1.0), before: q(2.0) },
        MoveFault::RecordingPositionJumps { gap: q(1.0) },
        MoveFault::SpeedNotClosed { end: q(1.0), start: q(2.0) },
        MoveFault::PositionNotClosed { gap: q(1.0) },
    ]);
    let both =
        |fault: MoveFault| [None, Some(x(0.01))].map(|travel_m_per_rad| AxisFault::Move { fault, travel_m_per_rad });
    all.into_iter().flat_map(both).collect()
}

fn body_faults() -> Vec<AxisFault> {
    let word = || "word".to_owned();
    let all = [
        BodyError::DimensionOutOfRange { field: "length", value: q(0.0) },
        BodyError::DimensionMissing { field: "length" },
        BodyError::InnerNotBelowOuter { inner: q(2.0), outer: q(1.0) },
        BodyError::MassAndDensity { mass: q(1.0), density: q(1.0) },
        BodyError::NoVolume,
        BodyError::MassOutOfRange { mass: q(0.0) },
        BodyError::DensityOutOfRange { density: q(0.0) },
        BodyError::DistanceOutOfRange { distance: q(-1.0) },
        BodyError::AngleNotFinite,
        BodyError::NoPiece,
        BodyError::BeyondNumbers,
    ];
    let mut faults: Vec<AxisFault> = all.into_iter().chain([BodyError::NoMass]).map(AxisFault::Body).collect();
    faults.extend(
        [
            Fault::BodyMissing,
            Fault::ShapeMissing,
            Fault::NoShape { written: word() },
            Fault::NoKey { written: word() },
            Fault::KeyOfAnotherShape { key: word(), shape: "rod" },
            Fault::Twice { key: word() },
            Fault::Count { written: word() },
            Fault::BodyAxis { written: word() },
            Fault::BodiesTwice,
            Fault::InBody { path: word(), fault: Box::new(Fault::BodyMissing) },
        ]
        .map(AxisFault::Stated),
    );
    faults.push(AxisFault::BodyOfText { path: word(), error: BodyError::NoMass });
    faults
}

fn recording_faults() -> Vec<AxisFault> {
    let layout = recording::Layout::default();
    let files = [
        "",
        "t;q [deg]\n0;1\n1;x\n",
        "t [s];q [deg]\n0;1;2\n1;2\n",
        "q [deg]\n0\n1\n",
        "t [s]\n0\n1\n",
        "t [s];q [deg]\n0;1\n0;2\n-1;3\n",
        "t [s];q [deg]\n0;1,5\n1;2.5\n",
        "t [s];q [grad]\n0;1\n1;2\n",
        "t [s];q [Nm]\n0;1\n1;2\n",
        "t [s];q [deg]\n0;1\n",
        "t [s];q [deg]\n0;\"1\n1;2\n",
        "t [s];q [deg]\n0;1.234,5\n1;2\n2;3\n",
        "t [s];q [deg]\n0;x\n1;x\n2;x\n3;x\n4;x\n",
        "t [s];q [deg]\n0;998\n1;1.002\n2;1.003\n",
    ];
    let faults = files.iter().flat_map(|file| recording::read_csv(file.as_bytes(), &layout).err().unwrap_or_default());
    let mut all: Vec<AxisFault> =
        faults.map(|fault| AxisFault::Recording { name: "run.csv".to_owned(), fault }).collect();
    assert!(all.len() >= files.len(), "{all:?}");
    let name = || "name".to_owned();
    let damages = [
        Damage::NoParquet,
        Damage::Encrypted,
        Damage::Elsewhere,
        Damage::Footer,
        Damage::Page,
        Damage::Packed,
        Damage::Lengths,
        Damage::Compression { name: name() },
        Damage::Encoding { name: name() },
        Damage::Values { text: name() },
    ];
    let limits = [
        Limit::FileBytes,
        Limit::Memory,
        Limit::Rows,
        Limit::Columns,
        Limit::Nesting,
        Limit::PathBytes,
        Limit::RowGroups,
        Limit::PageRatio,
        Limit::UnpackedBytes,
        Limit::DeltaBlock,
        Limit::BlankBytes,
    ];
    let beyond = limits.map(|limit| recording::Fault::Beyond { limit, found: 2 << 20, most: 1 << 20 });
    let damaged = damages.map(|reason| recording::Fault::ParquetUnreadable { reason });
    let samples = [
        recording::Fault::ValueImplausible { at: FileRow::Line(3), column: name(), text: name() },
        recording::Fault::TooClose { at: FileRow::Row(3), length: q(1e-15) },
        recording::Fault::HeadingMissing { columns: 3 },
        recording::Fault::HeadingOfUnits { columns: vec![(recording::Role::Time, 1, &SECOND)] },
        recording::Fault::ClockUnknown { column: "t".into(), text: "T#12ms".into() },
        recording::Fault::TimesDiffer { at: FileRow::Line(3), column: name(), numbers: [1, 3] },
        recording::Fault::Ambiguous { role: recording::Role::Time, columns: vec![name(), name()], numbers: vec![1, 3] },
        recording::Fault::Stopped,
        recording::Fault::SpacesOnly,
        recording::Fault::NotText,
        recording::Fault::TurnBegun { at: FileRow::Line(3), jump: q(-6.2), has_speed: true },
        recording::Fault::TurnBegun { at: FileRow::Line(3), jump: q(-6.2), has_speed: false },
        recording::Fault::CommasTwice { line: 3, found: 4, expected: 2 },
    ];
    let foreign = recording::Foreign::ALL.map(|format| recording::Fault::Foreign { format });
    let made =
        beyond.into_iter().chain(damaged).chain(samples).chain(foreign).chain(crate::axes_of_recordings::of_axes());
    all.extend(made.map(|fault| AxisFault::Recording { name: "run.parquet".to_owned(), fault }));
    let recorded = [
        RecordedFault::TooFew { samples: 2 },
        RecordedFault::NoCourse,
        RecordedFault::Uneven,
        RecordedFault::NotFinite { index: 1 },
        RecordedFault::NotIncreasing { index: 1 },
        RecordedFault::WindowTooShort { least: Some(q(0.1)) },
        RecordedFault::WindowTooShort { least: None },
        RecordedFault::WindowOverMotion { window: q(2.0), duration: q(1.5) },
        RecordedFault::WindowTooLong { most: 10 },
        RecordedFault::StampsUneven { scatter: q(0.01), interval: q(0.002) },
        RecordedFault::Contradiction { share: x(0.1), factor: None },
        RecordedFault::Contradiction { share: x(0.2), factor: Some(x(0.8)) },
    ];
    all.extend(recorded.map(|fault| AxisFault::Recorded { name: "run.csv".to_owned(), fault }));
    all
}

fn other_faults() -> Vec<Fault> {
    let path = || "load.inertia".to_owned();
    let word = || "word".to_owned();
    let expected = [
        Expected::Quantity(Dimension::Torque),
        Expected::Along(Dimension::Angle, Dimension::Length),
        Expected::Number,
        Expected::Numbers,
        Expected::Integer,
        Expected::Bool,
        Expected::Text,
        Expected::OneOf(&["a", "b"]),
        Expected::ListOf(&["a", "b"]),
        Expected::Rows,
        Expected::Table,
        Expected::Bodies,
        Expected::Tables,
    ];
    let types = ["string", "integer", "float", "boolean", "datetime", "array", "table"];
    let mut all: Vec<Fault> = expected
        .into_iter()
        .flat_map(|expected| types.map(|found| Fault::WrongType { path: path(), expected, found }))
        .collect();
    all.extend([Range::Any, Range::NotNegative, Range::Positive].map(|range| Fault::ToleranceEnd {
        path: path(),
        end: x(-1.0),
        unit: &KILOGRAM,
        range,
    }));
    let kinds = [
        ErrorKind::NotFound,
        ErrorKind::PermissionDenied,
        ErrorKind::IsADirectory,
        ErrorKind::FileTooLarge,
        ErrorKind::Unsupported,
        ErrorKind::StorageFull,
        ErrorKind::QuotaExceeded,
        ErrorKind::ReadOnlyFilesystem,
        ErrorKind::InvalidFilename,
    ];
    let trouble = |unopened, code| Fault::File {
        name: word(),
        trouble: FileTrouble { kind: ErrorKind::Other, unopened, code, system: word() },
    };
    all.extend(kinds.map(|kind| Fault::File {
        name: word(),
        trouble: FileTrouble { kind, unopened: None, code: None, system: word() },
    }));
    all.extend([
        Fault::FileTooLarge { bytes: 2, most: 1 },
        Fault::FileTooLarge { bytes: 3, most: 1 },
        Fault::FileOutOfReach { name: word() },
        trouble(Some(Unopened::NoRegularFile), None),
        trouble(Some(Unopened::NoRecordingName), None),
        trouble(None, Some(24)),
        trouble(None, Some(40)),
        trouble(None, Some(9999)),
        Fault::NotUtf8 { byte: None },
        Fault::NotUtf8 { byte: Some(0xe4) },
        Fault::Syntax { message: word(), hides: false },
        Fault::Syntax { message: word(), hides: true },
        Fault::MissingKey { path: path(), list: false },
        Fault::MissingKey { path: path(), list: true },
        Fault::UnknownKey { path: path() },
        Fault::KeyOfAnotherKind { path: path(), by: "law", kind: word() },
        Fault::OutsideTheAxes { key: "load" },
        Fault::AxisNamedTwice { name: word(), first: path(), line: 3, is_alike: true },
        Fault::AxisNamedTwice { name: word(), first: path(), line: 3, is_alike: false },
        Fault::EmptyList { path: path() },
        Fault::OneAxisOnly,
        Fault::More { count: 1 },
        Fault::More { count: 2 },
        Fault::ReadingStopped { line: 101 },
        Fault::InvisibleCharacter { sign: '\u{200b}' },
        Fault::BareNumber { path: path(), dimension: Dimension::Torque },
        Fault::Quantity {
            path: path(),
            error: QuantityError::UnitMissing { span: 0..1, expected: Dimension::Torque },
            also: vec![Dimension::Angle],
        },
        Fault::NumberOutOfRange { path: path(), low: x(0.0), high: x(1.0) },
        Fault::NumberOutOfRange { path: path(), low: x(1.0), high: x(1.0) },
        Fault::RatioTooSmall { path: path(), magnitude: (1e-4, 1e4) },
        Fault::QuantityOutOfRange { path: path(), written: word(), positive: true },
        Fault::QuantityOutOfRange { path: path(), written: word(), positive: false },
        Fault::BelowAbsoluteZero { path: path(), written: word() },
        Fault::Implausible { path: path(), written: word(), low: x(1e-12), high: x(1e12) },
        Fault::TextTooLong { path: path(), most: 200 },
        Fault::ControlCharacter { path: path() },
        Fault::NotAChoice { path: path(), written: word() },
        Fault::TooManyEntries { path: path(), most: 10 },
        Fault::UnlikeFirstPoint,
        Fault::MasterOfTimes,
        Fault::SupplyAndMains,
        Fault::WrongOrder { lower: "current_continuous", upper: "current_peak" },
        Fault::OnlyBeside { key: "deviation_max", needs: "lever_arm" },
        Fault::NotARow { path: path(), columns: &[&[Dimension::Angle], &[Dimension::Torque]] },
        Fault::RatioCount { most: 16 },
        Fault::RatioAndRatios,
        Fault::NoRatioInACoupling { key: "ratio" },
        Fault::TooManyTolerances { most: 64 },
        Fault::NoTolerance,
        Fault::Code(CodeError::Empty),
        Fault::NoSuchCode { written: word() },
        Fault::WithoutEffect { key: "payload" },
        Fault::MotorSide {
            name: word(),
            headings: vec![word()],
            ratios: vec![("position", Some(x(80.0))), ("speed", None)],
        },
        Fault::NoColumnWithRatio { path: path() },
        Fault::NoMechanism,
        Fault::TooManyMechanisms,
        Fault::NoLine { path: path() },
        Fault::StrokeBeyond { possible_m: [-0.1, 0.2] },
        Fault::StrokeFromUnknown,
        Fault::NoWeb,
        Fault::WebNotAlone,
        Fault::WebSpeed,
        Fault::WebTooShort { length_m: x(20.0), ramps_m: x(30.0) },
        Fault::RodTooShort,
        Fault::BeyondRange { position_rad: x(9.0), range_rad: (x(-1.0), x(8.0)) },
        Fault::NoFlangeLoads,
        Fault::FlangeLoadsUndecided { key: "radial_force", section: "bearing".into() },
        Fault::ReplacesEverything { key: "radial_force" },
        Fault::BeltOrTeeth,
        Fault::ToothAngle { key: "helix_angle", most_deg: x(60.0) },
        Fault::JointWithoutTorque { columns: vec!["gearbox out [Nm]".to_owned()] },
        Fault::UnknownUnit { written: word() },
    ]);
    all
}

fn built_faults() -> Vec<AxisFault> {
    let path = || "load.inertia".to_owned();
    let mut all = Vec::new();
    all.extend(
        [
            CurveFault::TooFewPoints,
            CurveFault::DoesNotStartAtZero,
            CurveFault::SpeedsNotAscending,
            CurveFault::TorqueOutOfRange,
        ]
        .map(AxisFault::Curve),
    );
    all.extend(
        [TableFault::TooFewPoints, TableFault::PositionsNotAscending, TableFault::NegativeInertia]
            .map(AxisFault::Table),
    );
    all.extend(Geometry::ALL.iter().map(|fault| AxisFault::Geometry(*fault)));
    all.extend([
        AxisFault::ImpossibleWithin {
            values: vec![(path(), x(1.0), &MILLIMETRE)],
            why: Some(Box::new(Fault::RodTooShort.into())),
        },
        AxisFault::Cycle(CycleFault::TooShort { others: q(3.0), cycle: q(2.0) }),
        AxisFault::Cycle(CycleFault::WithTime),
        AxisFault::Cycle(CycleFault::Twice),
        AxisFault::Points(PointsFault::TooFew { points: 1, least: 2 }),
        AxisFault::Points(PointsFault::NotFinite { index: 1 }),
        AxisFault::Points(PointsFault::NotIncreasing { index: 1 }),
        AxisFault::Points(PointsFault::Uneven),
        AxisFault::ImpossibleWithin { values: vec![(path(), x(1.0), &MILLIMETRE); 5], why: None },
        AxisFault::Battery(BatteryFault::OperationOutOfRange { per_day: q(1e6) }),
        AxisFault::Battery(BatteryFault::StorageOutOfRange { storage: q(1e9) }),
        AxisFault::Instants(TooManyInstants { segment: 0, instants: x(10.0), most: x(5.0) }),
    ]);
    all
}

#[test]
fn faults_and_hints() {
    let of_file = other_faults().into_iter().map(AxisFault::Stated).collect();
    let all = [move_faults(), body_faults(), recording_faults(), built_faults(), of_file].concat();
    let mut ids: Vec<&str> = Vec::new();
    for fault in &all {
        differ(&format!("{fault:?}"), |language| words::fault_text(fault, language));
        let id = fault.id();
        let snake = id.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'_');
        assert!(snake && !id.is_empty(), "{id}");
        ids.push(id);
    }
    ids.sort_unstable(); // One identifier, one kind of fault: a new variant is listed above.
    ids.dedup();
    assert!(ids.len() >= 100, "{}", ids.len());
    let hints = [
        Hint::Example("a = 1".to_owned()),
        Hint::DidYouMean("a".to_owned()),
        Hint::ValidAre(vec!["a".to_owned()]),
        Hint::WithUnit { written: "1".to_owned(), dimension: SECOND.dimension },
        Hint::MechanismsWithLoads,
        Hint::CloseTheRecording,
        Hint::TimeOfClock,
        Hint::KeysOfQuantity { dimension: Dimension::Length, keys: vec!["centre_distance", "payload_distance"] },
        Hint::KeyOfTable { key: "payload", table: "[[motion]]".to_owned() },
        Hint::WebOfWinder { web_m_s: Some(x(0.4)), start_m: x(0.4), core_m: x(0.076) },
        Hint::WebOfWinder { web_m_s: None, start_m: x(0.4), core_m: x(0.076) },
    ];
    for hint in &hints {
        differ(&format!("{hint:?}"), |language| words::hint_text(hint, language));
    }
}

/// A move with more quantities than determine it is overdetermined, and one with fewer is not determined.
#[test]
fn an_overdetermined_move_is_called_so() {
    for fault in move_faults() {
        let AxisFault::Move { fault: MoveFault::NotDetermined { given, needed }, .. } = &fault else { continue };
        let text = words::fault_text(&fault, Language::De);
        assert_eq!(text.contains("überbestimmt"), *given > needed.most(), "{text}");
        assert_eq!(text.contains("nicht bestimmt"), *given <= needed.most(), "{text}");
    }
}

/// The bounds of a number have the decimal sign of the language and all of their digits.
#[test]
fn bounds_are_written_in_the_language() {
    let path = || "stage.ratio".to_owned();
    let of = |low, high, language| words::fault_text(&Fault::NumberOutOfRange { path: path(), low, high }, language);
    for (low, high, en, de) in [
        (0.01, 1000.0, "from 0.01 to 1000", "von 0,01 bis 1000"),
        (-1e4, 1e4, "from −10000 to 10000", "von −10000 bis 10000"),
        (1e-6, 1e9, "from 0.000001 to 1000000000", "von 0,000001 bis 1000000000"),
    ] {
        assert!(of(low, high, Language::En).contains(en) && of(low, high, Language::De).contains(de), "{en}");
    }
}
