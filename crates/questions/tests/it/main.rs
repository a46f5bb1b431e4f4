//! Tests of the crate from outside, in one program: each file is linked once for all.

mod agree;
mod another_series;
mod answers_page;
mod begins_in_motion;
mod brake_times;
mod cam_table;
mod catalogue_check;
mod catalogue_files;
mod check_and_twin;
mod cited;
mod constants_in_tables;
mod course_and_check;
mod course_heat;
mod course_seen;
mod curves;
mod differential;
mod directions;
mod drive_current;
mod encoder;
mod environment;
mod errata_everywhere;
mod errata_in_documents;
mod errata_marked;
mod first_instant;
mod flange_behind_coupling;
mod flat_peak;
mod handed_catalogue;
mod identify;
mod instants;
mod limits;
mod limits_apart;
mod list;
mod mains;
mod manual_glossary;
mod named_everywhere;
mod neighbours;
mod no_limit;
mod not_stated;
mod notes_of_the_code;
mod open_law;
mod own_actuator;
mod payload_in_dwell;
mod physics;
mod printed_examples;
mod progress;
mod published_points;
mod recorded_energy;
mod recorded_noise;
mod recorded_side;
mod rejections;
mod segment_loads;
mod setpoints;
mod simulate;
mod simulated;
mod units_in_rows;
mod workings;
mod worst_instant;
mod written_product;

use actuator::Parameters;
use order_code::OrderCode;

/// Returns the products of the embedded catalogue by their ordering codes, with their data.
fn catalogue_actuators() -> impl Iterator<Item = (&'static OrderCode, &'static Parameters)> {
    let products = questions::embedded_catalogue().products(false).iter();
    products.filter_map(|product| Some((product.id.order_code()?, &product.parameters)))
}
