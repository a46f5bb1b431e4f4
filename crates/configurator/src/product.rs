//! Products: an actuator of any source with its identity and its data.

use crate::offer::Offer;
use crate::rules::{Availability, BrokenRule, availability};
use actuator::Parameters;
use catalogue::SeriesData;
use order_code::{Brake, Feedback, Option1, Option2, OrderCode, Pattern};
use quantities::Measure;
use std::borrow::Cow;
use std::fmt;
use std::sync::Arc;

/// An actuator with its data, whatever names it: an ordering code, or a name in a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Product {
    /// Identity of the product.
    pub id: ProductId,
    /// Origin of the data.
    pub source: ProductSource,
    /// Manufacturer; `None` if the source does not name one.
    pub manufacturer: Option<Cow<'static, str>>,
    /// Series of the manufacturer; `None` if the source does not name one.
    pub series: Option<Cow<'static, str>>,
    /// Data that the checks use.
    pub parameters: Parameters,
    /// Frame size; `None` if the source does not name one.
    pub frame_size: Option<FrameSize>,
    /// Motor feedback system; `None` if it is not named.
    pub feedback: Option<Feedback>,
    /// Holding brake; `None` if the source does not state whether there is one.
    pub brake: Option<Brake>,
    /// Price and time of delivery, as a catalogue file states them.
    pub offer: Offer,
}

/// Frame size of a product.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct FrameSize {
    /// Name, such as `20A`.
    pub name: Cow<'static, str>,
    /// Number, such as 20: between otherwise equal candidates the smaller one is preferred.
    pub number: u16,
}

/// Origin of the data of a product.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductSource {
    /// The manual of a series, embedded in the program.
    Manual,
    /// The project that uses the actuator.
    Project,
    /// A catalogue file of the user.
    File,
}

/// Identity of a product, opaque except to the questions about ordering codes.
///
/// Displayed as the code or the name. Codes are sorted before names, each among themselves as usual.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ProductId(Identity);

#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Identity {
    Code(OrderCode),
    Name(Arc<str>),
}

impl Product {
    /// Creates the product of an ordering code with its data.
    pub(crate) fn of_code(code: OrderCode, parameters: Parameters) -> Self {
        let manual = catalogue::document(SeriesData::of(code.series()).manual);
        let publisher = manual.map(|manual| manual.publisher).filter(|publisher| !publisher.is_empty());
        Self {
            id: code.into(),
            source: ProductSource::Manual,
            manufacturer: publisher.map(Cow::Borrowed),
            series: Some(Cow::Borrowed(code.series().as_str())),
            parameters,
            frame_size: Some(FrameSize { name: Cow::Borrowed(code.size.as_str()), number: code.size.number() }),
            feedback: Some(code.feedback),
            brake: Some(code.brake),
            offer: Offer::default(),
        }
    }

    /// Creates the product that a project describes.
    #[must_use]
    pub fn of_project(name: &str, parameters: Parameters) -> Self {
        Self {
            id: ProductId::named(name),
            source: ProductSource::Project,
            manufacturer: None,
            series: None,
            parameters,
            frame_size: None,
            feedback: None,
            brake: None,
            offer: Offer::default(),
        }
    }

    /// Creates the product that a catalogue file describes.
    #[must_use]
    pub fn of_file(
        name: &str,
        (manufacturer, series): (Option<&str>, Option<&str>),
        parameters: Parameters,
        offer: Offer,
    ) -> Self {
        let owned = |text: &str| Cow::Owned(text.to_owned());
        Self {
            source: ProductSource::File,
            manufacturer: manufacturer.map(owned),
            series: series.map(owned),
            offer,
            ..Self::of_project(name, parameters)
        }
    }

    /// Returns the name of the frame size; empty if the source does not name one.
    #[must_use]
    pub fn size_name(&self) -> &str {
        self.frame_size.as_ref().map_or("", |size| &size.name)
    }

    /// Returns the number by which candidates are ranked: that of the frame size, or zero.
    #[must_use]
    pub fn size_number(&self) -> u16 {
        self.frame_size.as_ref().map_or(0, |size| size.number)
    }

    /// Returns `true` if largest torque, largest speed and continuous torque are stated, without which a verdict says little.
    #[must_use]
    pub fn states_its_limits(&self) -> bool {
        let Parameters { drivetrain, .. } = &self.parameters;
        !self.is_described()
            || drivetrain.torque_max.known().is_some()
                && drivetrain.speed_max.known().is_some()
                && drivetrain.continuous_curve.known().is_some()
    }

    /// Returns the size by which candidates are ranked, the smaller first: the number of the frame size, or, where products
    /// without frame sizes compete, the mass in whole grams, with those that do not state their limits behind all others and
    /// those of unknown mass behind those.
    #[must_use]
    pub fn rank_size(&self, by_mass: bool) -> u32 {
        /// Above every mass in grams.
        const WITHOUT_LIMITS: u32 = 1 << 31;
        if !by_mass {
            return u32::from(self.size_number());
        }
        let behind = if self.states_its_limits() { 0 } else { WITHOUT_LIMITS };
        let grams = self.parameters.mass.known().map(|mass| (1000.0 * mass.value.si()).round());
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "positive, and cut off at the largest"
        )]
        let grams = grams.map_or(u32::MAX, |grams| grams as u32);
        behind + grams.min(WITHOUT_LIMITS - 1)
    }

    /// Returns `true` if the project that uses the actuator describes it.
    #[must_use]
    pub const fn is_of_project(&self) -> bool {
        matches!(self.source, ProductSource::Project)
    }

    /// Returns `true` if a file of the user describes the actuator: what it leaves open is unknown, not absent.
    #[must_use]
    pub const fn is_described(&self) -> bool {
        matches!(self.source, ProductSource::Project | ProductSource::File)
    }

    /// Returns the identity of the product with options; `None` if it is not offered with them.
    #[must_use]
    pub fn with_options(&self, option_1: Option<Option1>, option_2: Option<Option2>) -> Option<ProductId> {
        let Some(code) = self.id.order_code() else {
            return (option_1.is_none() && option_2.is_none()).then(|| self.id.clone());
        };
        let series = code.series();
        let own_1 = option_1.and_then(|option| Option1::of(series, option.as_str()));
        let own_2 = option_2.and_then(|option| Option2::of(series, option.as_str()));
        let has_both = (own_1.is_none(), own_2.is_none()) == (option_1.is_none(), option_2.is_none());
        has_both.then(|| OrderCode { option_1: own_1, option_2: own_2, ..*code }.into())
    }
}

impl ProductId {
    /// Creates the identity of a product with a name.
    #[must_use]
    pub fn named(name: &str) -> Self {
        Self(Identity::Name(name.into()))
    }

    /// Returns the ordering code, if the product is named by one.
    #[must_use]
    pub const fn order_code(&self) -> Option<&OrderCode> {
        match &self.0 {
            Identity::Code(code) => Some(code),
            Identity::Name(_) => None,
        }
    }

    /// Returns `true` if a partial code allows the ordering code of the product; a product with a name has none.
    #[must_use]
    pub fn is_allowed_by(&self, pattern: &Pattern) -> bool {
        self.order_code().is_some_and(|code| pattern.matches(code))
    }

    /// Returns `true` if the product is ordered with options, or as a special design.
    #[must_use]
    pub fn has_options(&self) -> bool {
        let with = |code: &OrderCode| code.option_1.is_some() || code.option_2.is_some() || code.special;
        self.order_code().is_some_and(with)
    }

    /// Returns the fields on request; a product with a name has no ordering tables and is available.
    ///
    /// # Errors
    /// The rules of the ordering tables that the product breaks.
    pub fn availability(&self) -> Result<Availability, Vec<BrokenRule>> {
        self.order_code().map_or_else(|| Ok(Availability { on_request: Vec::new() }), availability)
    }
}

impl fmt::Display for ProductId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Identity::Code(code) => fmt::Display::fmt(code, f),
            Identity::Name(name) => f.pad(name),
        }
    }
}

impl From<OrderCode> for ProductId {
    fn from(code: OrderCode) -> Self {
        Self(Identity::Code(code))
    }
}

impl From<&OrderCode> for ProductId {
    fn from(code: &OrderCode) -> Self {
        (*code).into()
    }
}

impl From<&Self> for ProductId {
    fn from(id: &Self) -> Self {
        id.clone()
    }
}
