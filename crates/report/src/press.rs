//! The typesetting engine: a world of embedded files and fonts, and nothing else.
//!
//! The only file that knows the engine's interface, which changes with its every minor version.

use crate::document::axis::figure_file;
use crate::document::checklist::CheckListDocument;
use crate::document::laid_out;
use crate::glyphs::Glyphs;
use crate::{Content, Fault, Settings, form, template};
use answers::Commissioning;
use quantities::Language;
use std::collections::BTreeMap;
use std::sync::OnceLock;
use typst::diag::{FileError, FileResult, SourceDiagnostic};
use typst::foundations::{Bytes, Datetime, Duration, Smart};
use typst::layout::{Frame, FrameItem};
use typst::syntax::{FileId, RootedPath, Source, VirtualPath, VirtualRoot};
use typst::text::{Font, FontBook};
use typst::utils::LazyHash;
use typst::{Library, LibraryExt, World, WorldExt};
use typst_kit::fonts::FontStore;
use typst_layout::PagedDocument;
use typst_pdf::{PdfOptions, PdfStandard, PdfStandards};

/// Typesets the report as PDF, tagged, with every font embedded.
///
/// # Errors
/// [`Fault::NoAxis`] and [`Fault::NoDate`] for invalid content; the others when the engine refuses, which is a defect.
pub fn pdf(content: &Content, settings: &Settings) -> Result<Vec<u8>, Fault> {
    if settings.pdf_a && settings.date.is_none() {
        return Err(Fault::NoDate);
    }
    let document = typeset(content, settings)?;
    let standard = if settings.pdf_a { PdfStandard::A_2a } else { PdfStandard::V_1_7 };
    // A constant: the hashes in the text identify the document, and time must not enter.
    export(&document, format!("antrieb report {} {}", settings.number, settings.revision), standard)
}

/// Typesets the checklists of a commissioning as PDF, tagged, with tick boxes and text lines: form fields that are also
/// drawn, for paper.
///
/// The file is no archive file: entered text is set in a font of the reader, which PDF/A does not permit.
///
/// # Errors
/// [`Fault::Typesetting`] and [`Fault::Export`] when the engine refuses, which is a defect.
pub fn checklist_pdf(sheet: &Commissioning, language: Language) -> Result<Vec<u8>, Fault> {
    let lists = CheckListDocument::build(sheet, language);
    let document = typeset_checklist(&lists)?;
    let file = export(&document, format!("antrieb commission {}", sheet.code), PdfStandard::V_1_7)?;
    form::with_fields(file, &lists.fields(language))
}

/// Returns the text of every page of the checklists, as typeset.
///
/// # Errors
/// As [`checklist_pdf`].
pub fn checklist_texts(sheet: &Commissioning, language: Language) -> Result<Vec<String>, Fault> {
    Ok(texts(&typeset_checklist(&CheckListDocument::build(sheet, language))?))
}

fn typeset_checklist(lists: &CheckListDocument) -> Result<PagedDocument, Fault> {
    static TEMPLATE: OnceLock<Template> = OnceLock::new();
    let template = Template::once(&TEMPLATE, template::CHECKLIST, "checklist.typ")?;
    let document = serde_json::to_value(lists).map_err(|fault| Fault::Typesetting { message: fault.to_string() })?;
    let document = fonts().glyphs.printable(document);
    let files = BTreeMap::from([("data.json".to_owned(), document.to_string().into_bytes())]);
    compile(Press { template, files })
}

fn export(document: &PagedDocument, ident: String, standard: PdfStandard) -> Result<Vec<u8>, Fault> {
    let standards =
        PdfStandards::new(&[standard]).map_err(|fault| Fault::Export { message: fault.message().to_string() })?;
    let options = PdfOptions {
        ident: Smart::Custom(ident),
        creator: Smart::Custom(Some(concat!("antrieb ", env!("CARGO_PKG_VERSION")).to_owned())),
        timestamp: None,
        page_ranges: None,
        standards,
        tagged: true,
        pretty: false,
    };
    let bytes = typst_pdf::pdf(document, &options).map_err(|faults| Fault::Export { message: messages(&faults, None) });
    forget();
    bytes
}

/// Renders the pages as PNG with `scale` pixels per point.
///
/// # Errors
/// As [`pdf`].
#[cfg(feature = "png")]
pub fn pages_png(content: &Content, settings: &Settings, scale: f64) -> Result<Vec<Vec<u8>>, Fault> {
    let document = typeset(content, settings)?;
    let options = typst_render::RenderOptions {
        pixel_per_pt: typst::utils::Scalar::new(scale.clamp(0.1, 8.0)),
        ..Default::default()
    };
    let pages = document
        .pages()
        .iter()
        .enumerate()
        .map(|(index, page)| {
            typst_render::render(page, &options).encode_png().map_err(|_| Fault::Picture { page: index + 1 })
        })
        .collect();
    forget();
    pages
}

/// Returns the text of every page, as typeset: for tests and for search.
///
/// # Errors
/// As [`pdf`].
pub fn page_texts(content: &Content, settings: &Settings) -> Result<Vec<String>, Fault> {
    Ok(texts(&typeset(content, settings)?))
}

fn texts(document: &PagedDocument) -> Vec<String> {
    let texts = document.pages().iter().map(|page| runs(&page.frame).into_iter().map(|run| run.text + " ").collect());
    let texts = texts.collect();
    forget();
    texts
}

/// Returns the right edge of the text of every page, in points: an A4 page ends at 595.3.
///
/// # Errors
/// As [`pdf`].
#[doc(hidden)]
pub fn right_edges(content: &Content, settings: &Settings) -> Result<Vec<f64>, Fault> {
    let document = typeset(content, settings)?;
    let edges = document.pages().iter().map(|page| runs(&page.frame).iter().map(|run| run.to).fold(0.0, f64::max));
    let edges = edges.collect();
    forget();
    Ok(edges)
}

/// Returns the lower end of the content of every page, head and foot lines left out, in points: the text ends at 785.
///
/// # Errors
/// As [`pdf`].
#[doc(hidden)]
pub fn page_fills(content: &Content, settings: &Settings) -> Result<Vec<f64>, Fault> {
    let document = typeset(content, settings)?;
    let fills = document.pages().iter().map(|page| lowest(&page.frame, 0.0, 784.0)).collect();
    forget();
    Ok(fills)
}

fn lowest(frame: &Frame, top: f64, end: f64) -> f64 {
    let ends = frame.items().map(|(place, item)| {
        let top = top + place.y.to_pt();
        let bottom = match item {
            FrameItem::Group(group) => lowest(&group.frame, top + group.transform.ty.to_pt(), end),
            FrameItem::Image(_, size, _) => top + size.y.to_pt(),
            _ => top,
        };
        // Content beyond the end belongs to the foot line.
        if bottom > end { 0.0 } else { bottom }
    });
    ends.fold(0.0, f64::max)
}

/// Returns overlapping texts as `one | other`: there should be none.
///
/// # Errors
/// As [`pdf`].
#[doc(hidden)]
pub fn overlaps(content: &Content, settings: &Settings) -> Result<Vec<String>, Fault> {
    let document = typeset(content, settings)?;
    let mut found = Vec::new();
    for page in document.pages() {
        let mut runs = runs(&page.frame);
        runs.sort_by(|a, b| a.line.total_cmp(&b.line));
        for (index, a) in runs.iter().enumerate() {
            let beside = runs.iter().skip(index + 1).take_while(|b| b.line - a.line < 0.5);
            let upon = beside.filter(|b| a.to.min(b.to) - a.from.max(b.from) > 0.5);
            found.extend(upon.map(|b| format!("{} | {}", a.text, b.text)));
        }
    }
    forget();
    Ok(found)
}

/// A run of text on its base line, in points.
struct Run {
    line: f64,
    from: f64,
    to: f64,
    text: String,
}

/// Returns the runs of a page, in the order of typesetting.
fn runs(page: &Frame) -> Vec<Run> {
    let mut runs = Vec::new();
    collect_runs(page, (0.0, 0.0), &mut runs);
    runs
}

fn collect_runs(frame: &Frame, (left, top): (f64, f64), runs: &mut Vec<Run>) {
    for (place, item) in frame.items() {
        let (left, top) = (left + place.x.to_pt(), top + place.y.to_pt());
        match item {
            FrameItem::Group(group) => {
                let moved = (left + group.transform.tx.to_pt(), top + group.transform.ty.to_pt());
                collect_runs(&group.frame, moved, runs);
            }
            FrameItem::Text(run) => {
                runs.push(Run { line: top, from: left, to: left + run.width().to_pt(), text: run.text.to_string() });
            }
            _ => {}
        }
    }
}

/// Evicts cached layouts of the engine, so that the memory of a server does not grow with them.
pub(crate) fn forget() {
    typst::comemo::evict(2);
}

/// Returns the warnings of the engine; one of a layout that does not settle means page numbers of different passes.
///
/// # Errors
/// As [`pdf`].
#[doc(hidden)]
pub fn warnings(content: &Content, settings: &Settings) -> Result<Vec<String>, Fault> {
    let found = typst::compile::<PagedDocument>(&pressed(content, settings)?).warnings;
    forget();
    Ok(found.iter().map(|warning| warning.message.to_string()).collect())
}

pub(crate) fn typeset(content: &Content, settings: &Settings) -> Result<PagedDocument, Fault> {
    compile(pressed(content, settings)?)
}

/// Returns the template with the data and the files of a report.
fn pressed(content: &Content, settings: &Settings) -> Result<Press, Fault> {
    let fonts = fonts();
    let document = fonts.glyphs.printable(crate::document(content, settings)?);
    let mut files: BTreeMap<String, Vec<u8>> = BTreeMap::new();
    files.insert("data.json".to_owned(), document.to_string().into_bytes());
    files.insert("logo.svg".to_owned(), plot::LOGO.as_bytes().to_vec());
    for (axis, of_axis) in content.axes.iter().enumerate() {
        for (index, figure) in of_axis.figures.iter().enumerate() {
            for (size, svg) in figure.svgs.iter().enumerate() {
                files.insert(figure_file(axis, index, size), svg.clone().into_bytes());
            }
        }
        for (index, picture) in laid_out::pictures(&of_axis.chapters).enumerate() {
            files.insert(laid_out::picture_file(axis, index), picture.svg.clone().into_bytes());
        }
    }
    Ok(Press { template: template()?, files })
}

fn compile(press: Press) -> Result<PagedDocument, Fault> {
    typst::compile::<PagedDocument>(&press)
        .output
        .map_err(|faults| Fault::Typesetting { message: messages(&faults, Some(&press)) })
}

fn messages(faults: &[SourceDiagnostic], press: Option<&Press>) -> String {
    let lines: Vec<String> = faults
        .iter()
        .map(|fault| {
            let place = press.and_then(|press| press.place(fault)).unwrap_or_default();
            let hints: String = fault.hints.iter().map(|hint| format!(" ({})", hint.v)).collect();
            format!("{place}{}{hints}", fault.message)
        })
        .collect();
    lines.join("; ")
}

struct Fonts {
    store: FontStore,
    glyphs: Glyphs,
}

/// Returns the fonts, loaded once for all reports: first the family of the diagrams, so that text in them and around
/// them looks equal, then those of the engine for characters it lacks.
fn fonts() -> &'static Fonts {
    static FONTS: OnceLock<Fonts> = OnceLock::new();
    FONTS.get_or_init(|| {
        let mut store = FontStore::new();
        let mut count = 0;
        let own = plot::font_files().into_iter().flat_map(|bytes| Font::iter(Bytes::new(bytes)));
        for font in own {
            let info = font.info().clone();
            store.push((font, info));
            count += 1;
        }
        for entry in typst_kit::fonts::embedded() {
            store.push(entry);
            count += 1;
        }
        let glyphs = Glyphs::of(store.book(), count);
        Fonts { store, glyphs }
    })
}

/// The parsed template and the library of the engine, shared by all reports.
struct Template {
    library: LazyHash<Library>,
    main: FileId,
    sources: BTreeMap<&'static str, Source>,
}

impl Template {
    /// Returns the template that was already read, else reads it.
    fn once(
        read: &'static OnceLock<Self>,
        files: &'static [(&'static str, &'static str)],
        main: &str,
    ) -> Result<&'static Self, Fault> {
        match read.get() {
            Some(template) => Ok(template),
            None => Self::read(files, main).map(|template| read.get_or_init(|| template)),
        }
    }

    fn read(files: &'static [(&'static str, &'static str)], main: &str) -> Result<Self, Fault> {
        let mut sources = BTreeMap::new();
        for (name, text) in files {
            sources.insert(*name, Source::new(file_id(name)?, (*text).to_owned()));
        }
        Ok(Self { library: LazyHash::new(Library::builder().build()), main: file_id(main)?, sources })
    }
}

fn template() -> Result<&'static Template, Fault> {
    static TEMPLATE: OnceLock<Template> = OnceLock::new();
    Template::once(&TEMPLATE, template::FILES, "main.typ")
}

/// Loads fonts and template in advance, for example during the computation; otherwise [`pdf`] loads them.
pub fn prepare() {
    fonts();
    // The report returns a fault of the template.
    let _ = template();
}

struct Press {
    template: &'static Template,
    files: BTreeMap<String, Vec<u8>>,
}

fn file_id(name: &str) -> Result<FileId, Fault> {
    let path = VirtualPath::new(name).map_err(|fault| Fault::Typesetting { message: fault.to_string() })?;
    Ok(RootedPath::new(VirtualRoot::Project, path).intern())
}

fn name_of(id: FileId) -> &'static str {
    id.get().vpath().get_without_slash()
}

impl Press {
    /// Returns file and line of a fault, for developers of the template.
    fn place(&self, fault: &SourceDiagnostic) -> Option<String> {
        let id = fault.span.id()?;
        let source = self.source(id).ok()?;
        let line = source.lines().byte_to_line(self.range(fault.span)?.start)?;
        Some(format!("{}:{}: ", name_of(id), line + 1))
    }
}

impl World for Press {
    fn library(&self) -> &LazyHash<Library> {
        &self.template.library
    }

    fn book(&self) -> &LazyHash<FontBook> {
        fonts().store.book()
    }

    fn main(&self) -> FileId {
        self.template.main
    }

    fn source(&self, id: FileId) -> FileResult<Source> {
        let name = name_of(id);
        self.template.sources.get(name).cloned().ok_or_else(|| FileError::NotFound(name.into()))
    }

    fn file(&self, id: FileId) -> FileResult<Bytes> {
        let name = name_of(id);
        self.files.get(name).map(|bytes| Bytes::new(bytes.clone())).ok_or_else(|| FileError::NotFound(name.into()))
    }

    fn font(&self, index: usize) -> Option<Font> {
        fonts().store.font(index)
    }

    /// Returns `None`: this crate reads no clock.
    fn today(&self, _offset: Option<Duration>) -> Option<Datetime> {
        None
    }
}
