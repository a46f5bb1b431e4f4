//! Output of antrieb as plain data: the record of every answer, and of every fault.
//!
//! `--json` is the serialisation of these records, their [JSON Schema](schema()) is generated from them, and report,
//! tables and figures use them unchanged. A word of a fixed set is an [`Id`], a number a [`Number`]; a `String` with
//! the name `title`, `name`, `meaning`, `message`, `hint`, `notes`, `source` … is a text in the requested language.
//! This crate computes nothing, and no record is created from JSON.

mod catalogue_check;
mod chapters;
mod check;
mod code;
mod commission;
mod comparison;
mod demand;
mod dossier;
mod encoder;
mod errata;
mod facts;
mod fault;
mod files;
mod glossary;
mod id;
mod judged;
mod laid_out;
mod licences;
mod motion;
mod mount;
mod number;
mod operation;
mod reference;
mod schema;
mod sheet;
mod simulation;
mod units;
mod upkeep;
mod wiring;

pub use catalogue_check::{
    CatalogueCheck, CatalogueFigure, CatalogueFinding, CatalogueProposal, CheckedCatalogue, OtherProduct,
};
pub use chapters::{
    Battery, BearingOfSize, Bearings, Body, Centre, Curve, CurveKind, Curves, Inertia, TorqueExceeded, Torsion,
};
pub use check::{AssumptionEntry, Check, CitedErratum, Derivation, Explained, Explanations, Node};
pub use code::{Choice, CodeFault, CodeFaults, CodeField, CodeReading, Completion, ListedCode, OpenField};
pub use commission::{
    CommissionAnswer, CommissionEntry, CommissionGap, CommissionList, CommissionParameter, CommissionWritten,
    Commissioning, DriveObject, DriveParameter, EncoderValue, OverloadSupervision, OverloadTrip, Recorded,
    RecordedValue, SensorThreshold,
};
pub use comparison::{CheckChange, CheckRow, Comparison, DatumChange, DatumRow, Difference, Head, InputChange};
pub use demand::{Demand, DemandFigures, DemandMode, IntegralDemand, MoveTorques};
pub use dossier::{
    CheckCounts, Document, Dossier, ErratumUsed, Fingerprints, Input, InputTable, Item, Mechanism, Missing,
    RejectionGroup, ScrewJoint, Sketch, SketchSymbol,
};
pub use encoder::{
    DecodedWord, Encoder, EncoderAssumption, EncoderCarrier, EncoderCurve, EncoderPin, EncoderShaft, EncoderSignal,
    EncoderState, EncoderWord, SignalForm, WordFault, WordField,
};
pub use errata::{Errata, Erratum, ErratumCell, ErratumKind, ErratumStatus};
pub use facts::{Fact, FactValue};
pub use fault::{Fault, Faults, Place};
pub use files::{
    AxisExported, AxisWritten, ColumnKind, ExportWritten, FilesWritten, PlotWritten, ReportWritten, Table, TableCell,
    TableColumn, TableRow, TableWritten,
};
pub use glossary::{Glossary, GlossaryCheck, GlossarySymbol, GlossaryTerm, GlossaryWord};
pub use id::{Availability, Fit, Id, Identified};
pub use judged::{
    Assessed, Candidate, Influence, Judgement, Make, NeededLimit, NotSought, Quantiles, Ranked, Rejection, Reserve,
    ReserveNotChecked, Sizing, Stage, StageRatio, Tolerance, ToleratedValue, WorstCorner, WouldFit, WouldFitAfter,
    WouldFitWithLaw,
};
pub use laid_out::{Block, Chapter, Column, Grid, Hazard, Picture, Task};
pub use licences::{LicenceText, Licences};
pub use motion::{ColumnRole, Motion, RecordedColumn, Recording, Segment, Setpoints, TextEncoding, UnitBy};
pub use mount::{Joint, JointCase, Mount, MountValue, Pilot};
pub use number::Number;
pub use operation::{DataLine, Duty, MotorSide, Operation, SegmentLoad};
pub use provenance::Grade;
pub use reference::reference;
pub use schema::{Answered, Axes, Record, VERSION, schema};
pub use sheet::{CatalogueCell, NoteBy, Sheet, SheetNote, SheetSection, SheetValue};
pub use simulation::{
    Compared, ControlLoop, DayOfOperation, EncoderFailure, EndOverrun, Figure, Figures, HourOfOperation,
    ModelParameter, SimulatedEvent, SimulatedVerdict, Simulation, WorstInstant, WorstOfDirection,
};
pub use sizing::derivation::Formula;
pub use sizing::{CheckId, Direction, Part, Shaft, Verdict};
pub use units::Units;
pub use upkeep::{Planned, Upkeep};
pub use wiring::{
    AmbiguousColour, Cable, Connector, ConnectorExit, ConnectorPin, NotAvailable, VoltageDrop, VoltageDrops, Wiring,
    WiringCheck, WiringFinding, WiringNote,
};
