//! Access to the catalogue, provided by the caller.

use actuator::{Battery, Parameters};
use configurator::{Product, ProductId};
use provenance::Datum;
use sizing::BrakeTimes;
use std::fmt::Debug;
use std::sync::Arc;

/// Values of the catalogue that complete the statements of a project.
pub trait Catalogue: Debug + Send + Sync {
    /// Returns the products, with or without the encoder at the output.
    fn products(&self, output_encoder: bool) -> &[Product];

    /// Returns a product by its identity, with any options.
    fn product(&self, id: &ProductId) -> Option<&Product>;

    /// Returns the switching times of the slowest brake; without them the motor holds in every dwell.
    fn brake_times(&self) -> Option<BrakeTimes>;

    /// Returns the battery of the encoders.
    fn battery(&self) -> Datum<Battery>;

    /// Returns the parameters of an actuator of the user whose file states no value.
    fn own_actuator(&self) -> Parameters;

    /// Returns `true` if it offers the series in the program.
    fn offers_series(&self) -> bool {
        true
    }

    /// Returns `true` if it offers products of catalogue files.
    fn has_files(&self) -> bool {
        false
    }

    /// Returns the names of the products of catalogue files.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

impl Catalogue for configurator::Catalogue {
    fn products(&self, output_encoder: bool) -> &[Product] {
        self.products(output_encoder)
    }

    fn product(&self, id: &ProductId) -> Option<&Product> {
        self.product(id)
    }

    fn brake_times(&self) -> Option<BrakeTimes> {
        self.brake_times().map(|(closing, opening)| BrakeTimes { closing, opening })
    }

    fn battery(&self) -> Datum<Battery> {
        self.battery()
    }

    fn own_actuator(&self) -> Parameters {
        self.own_actuator()
    }
}

/// A catalogue without values.
#[derive(Clone, Copy, Debug)]
pub struct NoCatalogue;

impl NoCatalogue {
    /// Returns it as it is handed to a reader.
    #[must_use]
    pub fn shared() -> Arc<dyn Catalogue> {
        Arc::new(Self)
    }
}

impl Catalogue for NoCatalogue {
    fn products(&self, _: bool) -> &[Product] {
        &[]
    }

    fn product(&self, _: &ProductId) -> Option<&Product> {
        None
    }

    fn brake_times(&self) -> Option<BrakeTimes> {
        None
    }

    fn battery(&self) -> Datum<Battery> {
        Datum::NotPrinted
    }

    fn own_actuator(&self) -> Parameters {
        Parameters::unknown()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::AxisProject;
    use quantities::{Measure, Time};

    #[derive(Debug)]
    struct Closing(Option<f64>);

    impl Catalogue for Closing {
        fn products(&self, _: bool) -> &[Product] {
            &[]
        }

        fn product(&self, _: &ProductId) -> Option<&Product> {
            None
        }

        fn brake_times(&self) -> Option<BrakeTimes> {
            self.0.map(Time::from_si).map(|time| BrakeTimes { closing: time, opening: time })
        }

        fn battery(&self) -> Datum<Battery> {
            Datum::NotPrinted
        }

        fn own_actuator(&self) -> Parameters {
            Parameters { without_kty: true, ..Parameters::unknown() }
        }
    }

    /// The dwell of 2 s in a cycle of 4 s: the coil is without current until the brake opens, also where the axis is
    /// built again with another value.
    #[test]
    fn a_project_is_completed_by_the_catalogue_of_its_caller() {
        let text = "format = 1\n[axis]\nname = \"x\"\n[load]\ninertia = \"1 kg m^2\"\n[actuator]\nname = \"own\"\n\
                    [[motion]]\nlaw = \"trapezoid\"\ndistance = \"90 deg\"\ntime = \"1 s\"\n\
                    [[motion]]\nlaw = \"trapezoid\"\ndistance = \"-90 deg\"\ntime = \"1 s\"\n\
                    [[motion]]\nlaw = \"dwell\"\ntime = \"2 s\"\nhold = \"brake\"\n";
        for (seconds, open) in [(None, 1.0), (Some(0.1), 1.0 - 1.9 / 4.0), (Some(0.4), 1.0 - 1.6 / 4.0)] {
            let catalogue: Arc<dyn Catalogue> = Arc::new(Closing(seconds));
            let project = AxisProject::read(text, &catalogue, &|_, _| None).unwrap();
            let geared = project.with_stage(2.0).unwrap();
            for axis in [&project.axis, &geared.axis] {
                assert!((axis.brake_open_share().si() - open).abs() < 1e-12, "{seconds:?}");
            }
            assert!(project.actuator.unwrap().parameters.without_kty);
        }
    }
}
