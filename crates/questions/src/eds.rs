//! Sections of an electronic data sheet (CiA 306).

use quantities::Language;
use std::fmt::Write as _;
use words::commission;

/// Objects that every device of `CiA 301` has.
pub(crate) const MANDATORY: [u16; 3] = [0x1000, 0x1001, 0x1018];

/// Writes the head of a sheet: without a date, so that the same call gives the same bytes.
pub(crate) fn file_info(out: &mut String, name: &str, description: &str) {
    let _ = write!(
        out,
        "[FileInfo]\nFileName={name}.eds\nFileVersion=1\nFileRevision=0\nEDSVersion=4.0\nDescription={description}\n\
        CreatedBy=antrieb\n\n"
    );
}

/// Longest line of a remark, within the 255 characters that `CiA 306` permits.
const LINE: usize = 120;

/// Writes a remark, which no reader of the sheet evaluates, on as many lines as it needs.
pub(crate) fn remark(out: &mut String, text: &str) {
    let mut length = 0;
    for word in text.split_whitespace() {
        let wide = word.chars().count() + 1;
        if length == 0 || length + wide > LINE {
            out.push_str(if length == 0 { ";" } else { "\n;" });
            length = 1;
        }
        let _ = write!(out, " {word}");
        length += wide;
    }
    out.push('\n');
}

/// Content of the section of an object.
pub(crate) struct Variable<'a> {
    pub(crate) name: &'a str,
    pub(crate) data_type: u16,
    pub(crate) access: &'a str,
    /// Default value, if the sheet states one.
    pub(crate) usual: Option<String>,
    /// Smallest and largest value, if they differ from those of the type.
    pub(crate) range: Option<[i64; 2]>,
    pub(crate) mappable: bool,
}

/// Writes the section of an object.
pub(crate) fn variable(out: &mut String, head: &str, object: &Variable<'_>) {
    let Variable { name, data_type, access, .. } = object;
    let _ = write!(
        out,
        "\n[{head}]\nParameterName={name}\nObjectType=0x7\nDataType=0x{data_type:04X}\nAccessType={access}\n"
    );
    if let Some([least, most]) = object.range {
        let _ = write!(out, "LowLimit={least}\nHighLimit={most}\n");
    }
    if let Some(usual) = &object.usual {
        let _ = writeln!(out, "DefaultValue={usual}");
    }
    let _ = writeln!(out, "PDOMapping={}", u8::from(object.mappable));
}

/// Writes the head of an index with several sub-objects.
pub(crate) fn group(out: &mut String, index: u16, name: &str, object_type: u8, count: usize) {
    let _ = write!(out, "\n[{index:04X}]\nParameterName={name}\nObjectType=0x{object_type}\nSubNumber={count}\n");
}

/// Writes sub-object 0: the highest sub-index.
pub(crate) fn highest(out: &mut String, index: u16, highest: u8, language: Language) {
    let object = Variable {
        name: commission::highest_sub_index(language),
        data_type: installation::commission::cia402::DataType::Unsigned8.number(),
        access: "const",
        usual: Some(highest.to_string()),
        range: None,
        mappable: false,
    };
    variable(out, &format!("{index:04X}sub0"), &object);
}

/// Writes a list of indices under a heading.
pub(crate) fn list(out: &mut String, heading: &str, indices: &[u16]) {
    let _ = writeln!(out, "\n[{heading}]\nSupportedObjects={}", indices.len());
    for (number, index) in (1..).zip(indices) {
        let _ = writeln!(out, "{number}=0x{index:04X}");
    }
}
