//! Signals and telegrams of position encoders, bit for bit: encoders and decoders.
//!
//! An [`Encoder`] with plain parameters represents a [`Shaft`], at rest or turning, as tracks, edges and words;
//! decoders read them back: [`SineDecoder`], [`Quadrature`], [`TrackingLoop`], [`endat::Frame`], [`ssi::Position`]. A
//! [`Deviation`] shifts the angle measured by the encoder within its accuracy. A [`Reader`] is a drive reading a failed
//! encoder until it detects the failure. The crate knows no catalogue, no pin and no language.

mod bits;
mod deviation;
mod encoder;
pub mod endat;
mod failure;
mod quadrature;
mod resolver;
mod shaft;
mod sine;
mod square;
pub mod ssi;
mod trace;

pub use bits::{BitsFault, Word};
pub use deviation::Deviation;
pub use encoder::{Absolute, Encoder, Interface, Protocol, Signal, Value};
pub use failure::{Failure, Finding, Reader};
pub use quadrature::{MissedEdge, Quadrature};
pub use resolver::{Resolver, Tracked, TrackingLoop, Windings};
pub use shaft::Shaft;
pub use sine::{Correction, MissedPeriod, SineDecoder, SinePair, Span};
pub use square::{CommutationPhases, NoSector, SquareTracks, Window, commutation_sector};
pub use trace::{EDGES_MOST, Edge, Line, TooManyEdges, Trace};
