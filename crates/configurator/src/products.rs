//! The catalogue as a value: the products that are offered, and the data common to them.

use crate::actuators::{actuators, alone};
use crate::family;
use crate::product::{Product, ProductId};
use actuator::{Battery, Parameters};
use order_code::OrderCode;
use provenance::Datum;
use quantities::Time;
use std::sync::{Arc, OnceLock};

/// Products that are offered for an axis, with the data that hold for all of them; made by the caller and handed to
/// whatever selects or judges.
///
/// A list is created when it is first used. Until then a product is looked up alone, since the list costs a hundred
/// times as much.
#[derive(Debug, Default)]
pub struct Catalogue {
    /// Products without and with the encoder at the output.
    lists: [OnceLock<Vec<Product>>; 2],
    alone: Kept,
    brake_times: OnceLock<Option<(Time, Time)>>,
}

impl Catalogue {
    /// Creates the catalogue of the series that are embedded in the program.
    #[must_use]
    pub fn cha() -> Arc<Self> {
        Arc::new(Self::default())
    }

    /// Returns the products without options, or those with the encoder at the output: the identity without the option,
    /// the data with it.
    ///
    /// These are all actuators with data in the manual that are available without request: each size, ratio, winding,
    /// feedback and brake. Neighbours with equal drivetrains share one.
    #[must_use]
    pub fn products(&self, output_encoder: bool) -> &[Product] {
        self.list(output_encoder).get_or_init(|| actuators(output_encoder))
    }

    fn list(&self, output_encoder: bool) -> &OnceLock<Vec<Product>> {
        let [without, with] = &self.lists;
        if output_encoder { with } else { without }
    }

    /// Returns a product by its identity, with any options: its data are those of the product without options, or with
    /// the encoder at the output if it has one.
    #[must_use]
    pub fn product(&self, id: &ProductId) -> Option<&Product> {
        let code = id.order_code()?;
        let bare = OrderCode { option_1: None, option_2: None, special: false, ..*code };
        let with_encoder = code.has_output_encoder();
        let is_it = |product: &&Product| product.id.order_code() == Some(&bare);
        match self.list(with_encoder).get() {
            Some(all) => all.iter().find(is_it),
            None => self.alone.find_or_insert(&bare, with_encoder),
        }
    }

    /// Returns t_c and t_o, the longest closing and opening times of all brakes: the demand is computed once for all
    /// candidates, and no brake is slower.
    #[must_use]
    pub fn brake_times(&self) -> Option<(Time, Time)> {
        *self.brake_times.get_or_init(family::brake_times)
    }

    /// Returns the battery of the encoders.
    #[must_use]
    pub fn battery(&self) -> Datum<Battery> {
        family::battery()
    }

    /// Returns the data of an actuator that a project describes without any value.
    #[must_use]
    pub fn own_actuator(&self) -> Parameters {
        family::own_actuator()
    }
}

/// Products that were looked up alone, kept as long as the catalogue. Links are only added, so that a reference to a
/// product stays valid while other threads look up others.
#[derive(Debug, Default)]
struct Kept(OnceLock<Box<Link>>);

#[derive(Debug)]
struct Link {
    product: Product,
    with_encoder: bool,
    next: Kept,
}

impl Kept {
    fn find_or_insert(&self, bare: &OrderCode, with_encoder: bool) -> Option<&Product> {
        let mut at = self;
        loop {
            let link = match at.0.get() {
                Some(link) => link,
                None => {
                    let product = alone(bare, with_encoder)?;
                    // Another thread may have been faster: then its product is here, and the search goes on.
                    at.0.get_or_init(|| Box::new(Link { product, with_encoder, next: Self::default() }))
                }
            };
            if link.with_encoder == with_encoder && link.product.id.order_code() == Some(bare) {
                return Some(&link.product);
            }
            at = &link.next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::codes::plain;
    use crate::parameters;

    /// The list has the data that [`parameters`] returns for each code. Products that share a drivetrain have the same
    /// size and ratio; one whose drivetrain differs in a single value, as it may with the feedback, has its own.
    #[test]
    fn neighbours_share_their_drivetrain_and_nothing_else() {
        let mut drivetrains = 0;
        let mut before: Option<&Product> = None;
        let catalogue = Catalogue::cha();
        for here in catalogue.products(false) {
            let (code, own) = (here.id.order_code().unwrap(), &here.parameters);
            assert_eq!(parameters(code).as_ref(), Some(own), "{code}");
            let other = before.map(|other| (other.id.order_code().unwrap(), &other.parameters));
            let shares = other.is_some_and(|(_, other)| Arc::ptr_eq(&other.drivetrain, &own.drivetrain));
            let equal = other.is_some_and(|(_, other)| *other.drivetrain == *own.drivetrain);
            let of_one_gear = other.is_some_and(|(other, _)| (other.size, other.ratio) == (code.size, code.ratio));
            assert_eq!((shares, shares && of_one_gear), (equal, shares), "{code}");
            drivetrains += usize::from(!shares);
            before = Some(here);
        }
        assert_eq!(drivetrains, 84);
    }

    /// A product that is looked up alone is that of the list, also from several threads at once and with options; one
    /// that is not in the list is not found, before and after the list is made.
    #[test]
    fn a_product_alone_is_that_of_the_list() {
        let (alone, listed) = (Catalogue::cha(), Catalogue::cha());
        let codes: Vec<OrderCode> = crate::all().iter().map(|(code, _)| *code).step_by(7).chain(plain()).collect();
        let expected = |code: &OrderCode| {
            let bare = OrderCode { option_1: None, option_2: None, special: false, ..*code };
            listed.products(code.has_output_encoder()).iter().find(|known| known.id == bare.into())
        };
        let compare = |codes: &[OrderCode]| {
            for code in codes {
                assert_eq!(alone.product(&code.into()), expected(code), "{code}");
                let special = OrderCode { special: true, ..*code };
                assert_eq!(alone.product(&special.into()), expected(code), "{code}");
            }
        };
        let half = codes.len() / 2;
        std::thread::scope(|scope| {
            for part in [&codes[..], &codes[half..], &codes[..half]] {
                scope.spawn(move || compare(part));
            }
        });
        assert!(alone.lists.iter().all(|list| list.get().is_none()));
        for with_encoder in [false, true] {
            assert_eq!(alone.products(with_encoder).len(), listed.products(with_encoder).len());
        }
        compare(&codes);
        assert_eq!(alone.product(&ProductId::named("own")), None);
    }

    /// A code has a product if the manual states data for it, and the data of the product are those of the code.
    #[test]
    fn every_code_with_data_is_a_product() {
        let catalogue = Catalogue::cha();
        for (code, _) in crate::all() {
            let found = catalogue.product(&code.into()).map(|product| &product.parameters);
            assert_eq!(found, parameters(code).as_ref(), "{code}");
        }
    }

    /// Changing one datum gives the product a drivetrain of its own.
    #[test]
    fn a_datum_that_is_written_changes_no_neighbour() {
        let catalogue = Catalogue::cha();
        let shared = catalogue.products(false).windows(2).find_map(|pair| match pair {
            [a, b] if Arc::ptr_eq(&a.parameters.drivetrain, &b.parameters.drivetrain) => Some((a.clone(), b)),
            _ => None,
        });
        let (mut own, other) = shared.expect("neighbours that share");
        own.parameters.torque_max = provenance::Datum::NotPrinted;
        assert!(other.parameters.torque_max.known().is_some());
        assert!(!Arc::ptr_eq(&own.parameters.drivetrain, &other.parameters.drivetrain));
    }
}
