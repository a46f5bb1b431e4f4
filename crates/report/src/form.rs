//! Form fields in a finished PDF: the places marked by the template become tick boxes and text lines.
//!
//! The typesetting engine knows no fields. The template marks each place with a link to `field:NAME`; here the link
//! becomes the widget of that field, and its tag a form element. The file of the engine stays as it is, and what
//! changes is appended to it, as the incremental update of ISO 32000-1, 7.5.6
//! (docs/decisions/0016-form-fields-appended.md).

use crate::Fault;
use hayro_syntax::Pdf;
use hayro_syntax::object::{Array, Dict, ObjRef, Rect as Area};
use pdf_writer::types::{AnnotationFlags, CheckBoxState, FieldType, StructRole};
use pdf_writer::{Chunk, Content, Finish, Name, Rect, Ref, Str, TextStr};
use std::collections::BTreeMap;
use std::fmt::Write as _;

/// Prefix of the address of a link that marks a field.
const MARK: &[u8] = b"field:";

/// Font of entered text: one of the fourteen standard fonts that every reader has.
const FONT: &[u8] = b"Helv";

/// Appearance of entered text: nine points, in the ink of the template.
const TYPED: &[u8] = b"/Helv 9 Tf 0.094 0.133 0.173 rg";

/// Kind of input of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FieldKind {
    /// A tick.
    Tick,
    /// A line of text.
    Text,
}

/// A field of the form.
#[derive(Clone, Debug)]
pub(crate) struct FormField {
    /// Name of the field, by which programs read it; the template marks its places with it. A full stop would split it.
    pub(crate) name: String,
    /// Kind of input.
    pub(crate) kind: FieldKind,
    /// Purpose of the field in words: shown by readers, read out by screen readers.
    pub(crate) tooltip: String,
}

/// Returns the file with its fields.
///
/// A field that is marked at several places is one field: text entered at one of them appears at all.
///
/// # Errors
/// [`Fault::Export`] when the file is not built as the engine builds it or a field is marked nowhere, which is a
/// defect.
pub(crate) fn with_fields(file: Vec<u8>, fields: &[FormField]) -> Result<Vec<u8>, Fault> {
    let fault = |what: &str| Fault::Export { message: format!("form: {what}") };
    let pdf = Pdf::new(file.clone()).map_err(|_| fault("not read"))?;
    let mut places = marked(&pdf);
    let tail = Tail::read(&file).ok_or_else(|| fault("no trailer"))?;
    let mut update = Update { next: tail.size, objects: BTreeMap::new() };
    let looks = Looks { empty: update.new_id(), ticked: update.new_id(), font: update.new_id() };
    looks.write(&mut update);

    let mut ids = Vec::new();
    for field in fields {
        let widgets = places.remove(field.name.as_str()).ok_or_else(|| fault(&field.name))?;
        ids.push(update.field(field, &widgets, &looks));
        for widget in &widgets {
            update.tag(&pdf, widget);
        }
    }
    if let Some(name) = places.keys().next() {
        return Err(fault(name));
    }

    let root = pdf.xref().root_id();
    let catalog: Dict<'_> = pdf.xref().get(root).ok_or_else(|| fault("no catalog"))?;
    let catalog = catalog.data().strip_suffix(b">>").ok_or_else(|| fault("no catalog"))?;
    update.catalog(Ref::new(root.obj_number), catalog, &ids, looks.font);
    Ok(update.append(file, &tail))
}

/// A place that the template has marked.
struct Widget {
    /// The annotation.
    id: Ref,
    /// Page of the place.
    page: Ref,
    /// Position on the page, in points from the lower edge.
    place: Area,
    /// Number in the parent tree of the tags, if the place is tagged.
    parent: Option<i32>,
}

/// Returns the marked places by the names of their fields, page by page.
fn marked(pdf: &Pdf) -> BTreeMap<String, Vec<Widget>> {
    let mut places: BTreeMap<String, Vec<Widget>> = BTreeMap::new();
    for page in pdf.pages().iter() {
        let Some(page_id) = page.raw().obj_id() else { continue };
        let Some(annotations) = page.raw().get::<Array<'_>>("Annots") else { continue };
        for id in annotations.raw_iter().filter_map(|each| each.as_obj_ref()) {
            let found = || {
                let link: Dict<'_> = pdf.xref().get(id.into())?;
                let action: Dict<'_> = link.get("A")?;
                let address: hayro_syntax::object::String<'_> = action.get("URI")?;
                let name = address.as_bytes().strip_prefix(MARK)?;
                let widget = Widget {
                    id: Ref::new(id.obj_number),
                    page: Ref::new(page_id.obj_number),
                    place: link.get("Rect")?,
                    parent: link.get("StructParent"),
                };
                Some((String::from_utf8_lossy(name).into_owned(), widget))
            };
            if let Some((name, widget)) = found() {
                places.entry(name).or_default().push(widget);
            }
        }
    }
    places
}

/// Objects shared by all fields.
struct Looks {
    /// A box without tick.
    empty: Ref,
    ticked: Ref,
    font: Ref,
}

/// Edge length of the box of a tick, in points; a reader scales the box to the widget.
const BOX: f32 = 9.0;

impl Looks {
    fn write(&self, update: &mut Update) {
        update.object(self.empty, |chunk| {
            chunk.form_xobject(self.empty, b"").bbox(Rect::new(0.0, 0.0, BOX, BOX));
        });
        let mut tick = Content::new();
        tick.set_stroke_rgb(0.094, 0.133, 0.173).set_line_width(1.4);
        tick.move_to(1.8, 4.6).line_to(3.8, 2.2).line_to(7.4, 7.2).stroke();
        let tick = tick.finish();
        update.object(self.ticked, |chunk| {
            chunk.form_xobject(self.ticked, &tick).bbox(Rect::new(0.0, 0.0, BOX, BOX));
        });
        update.object(self.font, |chunk| {
            chunk.type1_font(self.font).base_font(Name(b"Helvetica")).encoding_predefined(Name(b"WinAnsiEncoding"));
        });
    }
}

/// New objects of the file, and new versions of existing ones.
struct Update {
    next: i32,
    objects: BTreeMap<Ref, Vec<u8>>,
}

impl Update {
    fn new_id(&mut self) -> Ref {
        let id = Ref::new(self.next);
        self.next += 1;
        id
    }

    fn object(&mut self, id: Ref, write: impl FnOnce(&mut Chunk)) {
        let mut chunk = Chunk::new();
        write(&mut chunk);
        self.objects.insert(id, chunk.as_bytes().to_vec());
    }

    /// Writes a field with its widgets and returns its number: that of the widget if there is only one.
    fn field(&mut self, field: &FormField, widgets: &[Widget], looks: &Looks) -> Ref {
        let about = |writer: &mut pdf_writer::writers::Field<'_>| {
            writer.partial_name(TextStr(&field.name)).alternate_name(TextStr(&field.tooltip));
            match field.kind {
                FieldKind::Tick => writer.field_type(FieldType::Button).checkbox_value(CheckBoxState::Off),
                FieldKind::Text => writer.field_type(FieldType::Text).vartext_default_appearance(Str(TYPED)),
            };
        };
        if let [widget] = widgets {
            let look = self.appearances(field.kind, widget, looks);
            self.object(widget.id, |chunk| {
                let mut writer = chunk.form_field(widget.id);
                about(&mut writer);
                shown(writer, widget, field.kind, look);
            });
            return widget.id;
        }
        let parent = self.new_id();
        self.object(parent, |chunk| {
            let mut writer = chunk.form_field(parent);
            about(&mut writer);
            writer.children(widgets.iter().map(|widget| widget.id));
        });
        for widget in widgets {
            let look = self.appearances(field.kind, widget, looks);
            self.object(widget.id, |chunk| {
                let mut writer = chunk.form_field(widget.id);
                writer.parent(parent);
                shown(writer, widget, field.kind, look);
            });
        }
        parent
    }

    /// Returns the appearances of a widget: off and on of a tick; a line has one of its own, since programs write the
    /// entered text there.
    fn appearances(&mut self, kind: FieldKind, widget: &Widget, looks: &Looks) -> (Ref, Ref) {
        if kind == FieldKind::Tick {
            return (looks.empty, looks.ticked);
        }
        let id = self.new_id();
        let place = &widget.place;
        self.object(id, |chunk| {
            chunk.form_xobject(id, b"").bbox(Rect::new(0.0, 0.0, points(place.width()), points(place.height())));
        });
        (id, id)
    }

    /// Changes the tag of a link to that of a form element.
    fn tag(&mut self, pdf: &Pdf, widget: &Widget) {
        let found = || {
            let number = widget.parent?;
            let catalog: Dict<'_> = pdf.xref().get(pdf.xref().root_id())?;
            let tree: Dict<'_> = catalog.get::<Dict<'_>>("StructTreeRoot")?.get("ParentTree")?;
            let id = in_number_tree(&tree, number, 0)?;
            let element: Dict<'_> = pdf.xref().get(id.into())?;
            Some((Ref::new(id.obj_number), Ref::new(element.get_ref("P")?.obj_number)))
        };
        let Some((id, parent)) = found() else { return };
        self.object(id, |chunk| {
            let mut element = chunk.struct_element(id);
            element.kind(StructRole::Form).parent(parent);
            element.object_child().page(widget.page).object(widget.id);
        });
    }

    fn catalog(&mut self, root: Ref, entries: &[u8], fields: &[Ref], font: Ref) {
        let form = self.new_id();
        self.object(form, |chunk| {
            let mut form = chunk.indirect(form).start::<pdf_writer::writers::Form<'_>>();
            form.fields(fields.iter().copied());
            form.default_resources().fonts().pair(Name(FONT), font);
            form.default_appearance(Str(TYPED));
        });
        let mut catalog = format!("{} 0 obj\n", root.get()).into_bytes();
        catalog.extend_from_slice(entries);
        catalog.extend_from_slice(format!("/AcroForm {} 0 R>>\nendobj\n", form.get()).as_bytes());
        self.objects.insert(root, catalog);
    }

    /// Returns the file followed by the objects, the cross-reference table and the trailer.
    fn append(self, mut file: Vec<u8>, tail: &Tail) -> Vec<u8> {
        if file.last() != Some(&b'\n') {
            file.push(b'\n');
        }
        let mut table = String::from("xref\n0 1\n0000000000 65535 f\r\n");
        for (id, object) in &self.objects {
            // Writing into a text cannot fail.
            let _ = write!(table, "{} 1\n{:010} 00000 n\r\n", id.get(), file.len());
            file.extend_from_slice(object);
        }
        let start = file.len();
        let _ = write!(table, "trailer\n<</Size {}/Prev {}", self.next, tail.table);
        file.extend_from_slice(table.as_bytes());
        file.extend_from_slice(&tail.rest);
        file.extend_from_slice(format!("\nstartxref\n{start}\n%%EOF\n").as_bytes());
        file
    }
}

#[allow(clippy::cast_possible_truncation, reason = "points on a page")]
const fn points(value: f64) -> f32 {
    value as f32
}

/// Writes appearance and place of a widget.
fn shown(field: pdf_writer::writers::Field<'_>, widget: &Widget, kind: FieldKind, (off, on): (Ref, Ref)) {
    let mut annotation = field.into_annotation();
    let Area { x0, y0, x1, y1 } = widget.place;
    annotation.rect(Rect::new(points(x0), points(y0), points(x1), points(y1)));
    annotation.flags(AnnotationFlags::PRINT).page(widget.page);
    if let Some(parent) = widget.parent {
        annotation.struct_parent(parent);
    }
    match kind {
        FieldKind::Tick => {
            annotation.appearance_state(Name(b"Off"));
            let mut looked = annotation.appearance();
            looked.normal().streams().pair(Name(b"Yes"), on).pair(Name(b"Off"), off);
            looked.finish();
        }
        FieldKind::Text => annotation.appearance().normal().stream(off),
    }
    annotation.finish();
}

/// Returns the reference at a number in a number tree; `None` if the entry is no reference.
fn in_number_tree(node: &Dict<'_>, number: i32, depth: u8) -> Option<ObjRef> {
    if let Some(leaves) = node.get::<Array<'_>>("Nums") {
        let mut leaves = leaves.raw_iter();
        while let (Some(key), Some(value)) = (leaves.next(), leaves.next()) {
            let key = match key {
                hayro_syntax::object::MaybeRef::NotRef(key) => key.into_i32(),
                hayro_syntax::object::MaybeRef::Ref(_) => None,
            };
            if key == Some(number) {
                return value.as_obj_ref();
            }
        }
    }
    // Files of the engine are not as deep, and a damaged one must not cause endless recursion.
    let nodes: Array<'_> = node.get("Kids").filter(|_| depth < 8)?;
    nodes.iter::<Dict<'_>>().find_map(|node| in_number_tree(&node, number, depth + 1))
}

/// End of the file: the next object number, the position of the cross-reference table and the rest of the trailer.
struct Tail {
    size: i32,
    table: usize,
    /// The trailer from behind its size on.
    rest: Vec<u8>,
}

impl Tail {
    fn read(file: &[u8]) -> Option<Self> {
        let last = |what: &[u8]| file.windows(what.len()).rposition(|window| window == what);
        let (trailer, end) = (last(b"trailer")?, last(b"startxref")?);
        let dictionary = file.get(trailer + b"trailer".len()..end)?.trim_ascii().strip_prefix(b"<</Size ")?;
        let digits = dictionary.iter().take_while(|byte| byte.is_ascii_digit()).count();
        let number = |bytes: &[u8]| std::str::from_utf8(bytes).ok()?.trim().parse::<usize>().ok();
        let after = file.get(end + b"startxref".len()..)?;
        let after = after.strip_suffix(b"\n").unwrap_or(after).strip_suffix(b"%%EOF")?;
        Some(Self {
            size: i32::try_from(number(dictionary.get(..digits)?)?).ok()?,
            table: number(after)?,
            rest: dictionary.get(digits..)?.to_vec(),
        })
    }
}
