//! Catalogue files: products of any manufacturer, read from TOML or CSV and offered beside the series in the program.

use crate::catalogue::Catalogue;
use crate::catalogue_csv::{self, CsvText};
use crate::fault::{AxisDiagnostic, AxisFault, AxisReport};
use crate::files::Files;
use crate::own::stated;
use crate::sourced::Origin;
use actuator::{Battery, Parameters};
use configurator::{Offer, Price, Product, ProductId};
use project::sections::{ActuatorEntry, CatalogueHead, CatalogueSection, Section, Stated, StatedField};
use project::{CATALOGUE_MAX_BYTES, Diagnostic, Fault, ReadCatalogue, decoded, offset, place, read_catalogue};
use provenance::Datum;
use sizing::BrakeTimes;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::io::Read;
use std::sync::{Arc, OnceLock};

/// Products of catalogue files beside those of another catalogue, or instead of them.
#[derive(Debug)]
pub struct FileCatalogue {
    base: Arc<dyn Catalogue>,
    offers_base: bool,
    own: Vec<Product>,
    /// Products without and with the encoder at the output, put together on first use.
    lists: [OnceLock<Vec<Product>>; 2],
}

impl FileCatalogue {
    /// Creates the catalogue; without `offers_base` the products of `base` are known, but not offered.
    #[must_use]
    pub fn new(base: &Arc<dyn Catalogue>, offers_base: bool, own: Vec<Product>) -> Self {
        Self { base: Arc::clone(base), offers_base, own, lists: [const { OnceLock::new() }; 2] }
    }
}

impl Catalogue for FileCatalogue {
    fn products(&self, output_encoder: bool) -> &[Product] {
        let [without, with] = &self.lists;
        let list = if output_encoder { with } else { without };
        list.get_or_init(|| {
            let base = if self.offers_base { self.base.products(output_encoder) } else { &[] };
            base.iter().chain(&self.own).cloned().collect()
        })
    }

    fn product(&self, id: &ProductId) -> Option<&Product> {
        self.own.iter().find(|product| product.id == *id).or_else(|| self.base.product(id))
    }

    fn brake_times(&self) -> Option<BrakeTimes> {
        self.base.brake_times()
    }

    fn battery(&self) -> Datum<Battery> {
        self.base.battery()
    }

    fn own_actuator(&self) -> Parameters {
        self.base.own_actuator()
    }

    fn offers_series(&self) -> bool {
        self.offers_base && self.base.offers_series()
    }

    fn has_files(&self) -> bool {
        true
    }

    fn names(&self) -> Vec<String> {
        let own = self.own.iter().map(|product| product.id.to_string());
        self.base.names().into_iter().chain(own).collect()
    }
}

/// Returns the names of products that a project knows beside the ordering codes: those of its catalogue files and of the
/// catalogue, and those of the actuators that it describes. A file with faults has none.
#[must_use]
pub fn product_names(text: &str, files: &dyn Files, catalogue: &Arc<dyn Catalogue>) -> Vec<String> {
    let Ok(project::ReadProject { project, .. }) = project::read(text) else { return catalogue.names() };
    let with_files = read(project.shared.catalogue.as_ref(), files, catalogue, &mut AxisReport::new(text));
    let own = project.axes.iter().filter_map(|axis| axis.parts.actuator.get()?.name.get().cloned());
    with_files.as_ref().unwrap_or(catalogue).names().into_iter().chain(own).collect()
}

/// Returns the products of a catalogue file, in TOML or CSV by its ending, else by its content; `parameters` are those of an
/// actuator whose file states no value.
///
/// # Errors
/// Every fault of the file, each with its place.
pub fn read_products(name: &str, bytes: &[u8], parameters: &Parameters) -> Result<Vec<Product>, Vec<AxisDiagnostic>> {
    if bytes.len() > CATALOGUE_MAX_BYTES {
        let fault = Fault::FileTooLarge { bytes: bytes.len(), most: CATALOGUE_MAX_BYTES };
        return Err(vec![Diagnostic::at("", 0..0, fault.into(), None)]);
    }
    if is_csv(name, bytes) {
        let CsvText { toml, places, faults, .. } = catalogue_csv::as_toml(name, bytes);
        let (products, mut found) = of_toml(name, &toml, &|at| places.line_of(at), parameters);
        found = found.into_iter().map(|fault| places.moved(fault)).collect();
        let mut all = faults;
        all.append(&mut found);
        all.sort_by_key(|fault| (fault.line, fault.column));
        if all.is_empty() {
            return Ok(products);
        }
        // A face shows the line of each fault.
        let (text, _) = decoded(bytes);
        for fault in &mut all {
            let start = offset(&text, fault.line, fault.column);
            fault.span = start
                ..text.get(start..).and_then(|rest| rest.chars().next()).map_or(start, |sign| start + sign.len_utf8());
        }
        return Err(all);
    }
    let (text, encoding) = decoded(bytes);
    let line_of = |at: usize| place(&text, at).0;
    let (products, mut faults) = of_toml(name, &text, &line_of, parameters);
    if let Some(fault) = encoding {
        let before = faults.partition_point(|each| each.span.start <= fault.span.start);
        faults.insert(before, fault.into_other());
    }
    if faults.is_empty() { Ok(products) } else { Err(faults) }
}

/// Returns `true` if a catalogue file is a table: by its ending, else if no line opens a table of TOML.
pub(crate) fn is_csv(name: &str, bytes: &[u8]) -> bool {
    let name = name.to_ascii_lowercase();
    if name.ends_with(".csv") || name.ends_with(".toml") {
        return name.ends_with(".csv");
    }
    !bytes.split(|byte| *byte == b'\n').any(|line| line.trim_ascii_start().starts_with(b"["))
}

/// Returns the products of a text in TOML, and its faults.
fn of_toml(
    name: &str,
    text: &str,
    line_of: &dyn Fn(usize) -> usize,
    parameters: &Parameters,
) -> (Vec<Product>, Vec<AxisDiagnostic>) {
    let ReadCatalogue { head, actuators, report } = match read_catalogue(text) {
        Ok(read) => read,
        Err(faults) => return (Vec::new(), faults.into_iter().map(Diagnostic::into_other).collect()),
    };
    let mut report: AxisReport<'_> = report.into_other();
    if actuators.is_empty() && report.fault_count() == 0 {
        report.fault(0..0, AxisFault::NoProducts, None);
    }
    let mut lines: BTreeMap<&str, usize> = BTreeMap::new();
    let mut products = Vec::with_capacity(actuators.len());
    for entry in &actuators {
        let line = line_of(entry.id.span().start);
        if let Some(id) = entry.id.get() {
            let span = entry.id.span();
            match lines.entry(id) {
                Entry::Vacant(free) => drop(free.insert(line)),
                Entry::Occupied(first) => {
                    let fault = AxisFault::ProductNamedTwice { id: id.clone(), line: *first.get() };
                    report.fault(span.clone(), fault, None);
                }
            }
            if order_code::parse(id).is_ok() {
                report.fault(span, AxisFault::ProductNamedAsCode { id: id.clone() }, None);
            }
        }
        products.extend(product(name, (entry, head.as_ref(), line), parameters.clone(), &mut report));
    }
    let faults = report.into_faults();
    (products, faults)
}

/// Returns the product of an entry; `None` without its name.
fn product(
    name: &str,
    (entry, head, line): (&ActuatorEntry, Option<&CatalogueHead>, usize),
    parameters: Parameters,
    report: &mut AxisReport<'_>,
) -> Option<Product> {
    let of = |own: &Stated<String>, common: fn(&CatalogueHead) -> &Stated<String>| {
        own.get().cloned().or_else(|| head.and_then(|head| common(head).get().cloned()))
    };
    let document = of(&entry.source, |head| &head.source).unwrap_or_default();
    let origin = Origin::File { name, line, document: &document };
    crate::order::check_actuator(&entry.values, report);
    let parameters = stated(&entry.values, parameters, &origin, report);
    let maker = of(&entry.maker, |head| &head.maker);
    let series = of(&entry.series, |head| &head.series);
    // A text without digits states no amount: `on request`.
    let is_amount = |price: &String| price.contains(|sign: char| sign.is_ascii_digit());
    if entry.price.get().is_some_and(|price| is_amount(price) && Price::read(price).is_none()) {
        report.fault(entry.price.span(), AxisFault::NoPrice, None);
    }
    let offer =
        Offer { price: entry.price.get().map(|price| price.as_str().into()), lead_time: entry.lead_time.value() };
    Some(Product::of_file(entry.id.get()?, (maker.as_deref(), series.as_deref()), parameters, offer))
}

/// Reads the catalogue of a project with its catalogue files, if it names any; faults are reported at the names.
pub(crate) fn read(
    section: Option<&CatalogueSection>,
    files: &dyn Files,
    catalogue: &Arc<dyn Catalogue>,
    report: &mut AxisReport<'_>,
) -> Option<Arc<dyn Catalogue>> {
    let section = section.filter(|section| section.is_whole())?;
    let named = section.files.get().map(|texts| texts.0.as_slice()).unwrap_or_default();
    if named.is_empty() {
        if !section.cha() {
            report.fault(section.cha.span(), AxisFault::NothingOffered, None);
        }
        return None;
    }
    let parameters = catalogue.own_actuator();
    let mut own: Vec<Product> = Vec::new();
    for (name, span) in named {
        match file(name, files, &parameters) {
            Ok(products) => {
                for product in products {
                    if own.iter().any(|other| other.id == product.id) {
                        let fault = AxisFault::ProductOfTwoFiles { id: product.id.to_string() };
                        report.fault(span.clone(), fault, None);
                    } else {
                        own.push(product);
                    }
                }
            }
            Err(faults) => faults.into_iter().for_each(|fault| report.fault(span.clone(), fault, None)),
        }
    }
    Some(Arc::new(FileCatalogue::new(catalogue, section.cha(), own)))
}

/// Reads one catalogue file of a project.
fn file(name: &str, files: &dyn Files, parameters: &Parameters) -> Result<Vec<Product>, Vec<AxisFault>> {
    if !files.grant().reach.admits(name) {
        return Err(vec![Fault::FileOutOfReach { name: name.to_owned() }.into()]);
    }
    let unopened = |error: std::io::Error| vec![Fault::File { name: name.to_owned(), trouble: (&error).into() }.into()];
    let bytes = files.size(name).and_then(|size| usize::try_from(size).ok()).unwrap_or_default();
    if bytes > CATALOGUE_MAX_BYTES {
        return Err(vec![Fault::FileTooLarge { bytes, most: CATALOGUE_MAX_BYTES }.into()]);
    }
    let mut bytes = Vec::new();
    let most = CATALOGUE_MAX_BYTES as u64 + 1;
    files.open(name).and_then(|source| source.take(most).read_to_end(&mut bytes)).map_err(unopened)?;
    let within = |found: AxisDiagnostic| AxisFault::InCatalogue { name: name.to_owned(), found: Box::new(found) };
    read_products(name, &bytes, parameters).map_err(|faults| faults.into_iter().map(within).collect())
}
