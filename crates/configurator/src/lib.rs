//! Products and the catalogue that offers them ([`Catalogue`]); combination of ordering code and manual: the parameters
//! of an actuator, or the rules that the code breaks.
//!
//! The rules are read from tables 11.2, 11.3 and 12.1 of the manual at first use; none is repeated in code.

mod actuators;
mod cells;
mod codes;
mod family;
mod matrix;
mod nearest;
mod offer;
mod parameters;
mod parts;
mod product;
mod products;
mod requirements;
mod rules;
mod sheet;

pub use codes::{Choice, all, broken_by_all, choices, complete, tokens_of_size};
pub use family::{battery, ptc_cell};
pub use nearest::{nearest, nearest_to};
pub use offer::{Currency, Offer, Price};
pub use parameters::{parameters, published_curve_points};
pub use product::{FrameSize, Product, ProductId, ProductSource};
pub use products::Catalogue;
pub use requirements::{OfferDatum, Requirements, Unmet, is_maker};
pub use rules::{Availability, BrokenRule, Rule, Uncovered, availability, uncovered};
pub use sheet::sheet_cells;
