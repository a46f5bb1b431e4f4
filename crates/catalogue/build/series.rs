//! Tables and words of each series, as Rust source.

use series_files::{Code, Mark, Winding, variant_of};
use std::fmt::Write as _;

pub(crate) fn records(codes: &[Code]) -> String {
    let mut out = String::from("pub(crate) static SERIES: &[SeriesData] = &[\n");
    for (series, code) in codes.iter().enumerate() {
        let write = Writer { series, code };
        let tables = &code.tables;
        let _ = writeln!(
            out,
            "SeriesData {{ manual: {:?}, family: {:?}, matrix: {:?}, pairs: {:?}, thresholds: {:?}, preselection: {:?}, output_encoder: {:?}, \
             output_wiring: &{:?}, cables: &{:?}, by_size: &{:?}, feedback: &{:?}, ordering: &{:?}, of_all: &{:?}, curves: &{:?}, gear_life: {:?}, \
             gear_series: {:?}, marks: &[{}], windings: &[{}], \
             feedback_tables: &{:?}, drives: &[{}], wirings: &[{}] }},",
            code.manual,
            tables.family,
            tables.matrix,
            tables.pairs,
            tables.thresholds,
            tables.preselection,
            tables.output_encoder,
            tables.output_wiring,
            tables.cables,
            tables.by_size,
            tables.feedback,
            tables.ordering,
            tables.of_all,
            tables.curves,
            tables.gear_life,
            tables.gear_series,
            joined(&code.marks, |mark| write.mark(mark)),
            joined(code.words("winding"), |word| write.winding(word)),
            write.feedback_tables(),
            write.drives(),
            write.wirings(),
        );
    }
    out.push_str("];\n");
    out
}

fn joined<T>(all: &[T], text: impl Fn(&T) -> String) -> String {
    all.iter().map(text).collect::<Vec<_>>().join(", ")
}

struct Writer<'a> {
    series: usize,
    code: &'a Code,
}

impl Writer<'_> {
    fn value(&self, field: &str, kind: &str, word: &str) -> String {
        let place = self.code.place(field, word).unwrap_or_default();
        format!("order_code::{kind}::at(order_code::Series::at({}), {place})", self.series)
    }

    fn values(&self, field: &str, kind: &str, words: &[String]) -> String {
        joined(words, |word| self.value(field, kind, word))
    }

    fn mark(&self, mark: &Mark) -> String {
        let entry = variant_of(&mark.entry);
        let feedback = mark.feedback.as_ref().map(|word| self.value("feedback", "Feedback", word));
        let feedback = feedback.map_or("None".to_owned(), |value| format!("Some({value})"));
        format!(
            "Mark {{ begins: {:?}, entry: MarkEntry::{entry}, feedback: {feedback}, longer: {:?} }}",
            mark.begins, mark.longer
        )
    }

    fn winding(&self, word: &String) -> String {
        let of = |winding: &&Winding| winding.words.contains(word);
        let Some(found) = self.code.windings.iter().find(of) else { return String::new() };
        format!(
            "WindingData {{ general: {:?}, general_head: {:?}, starting_current: {:?}, \
             stall_current_includes_friction: {}, ptc: {}, without_kty: &{:?} }}",
            found.general,
            found.general_head,
            found.starting_current,
            found.stall_current_includes_friction,
            found.ptc,
            found.without_kty
        )
    }

    fn feedback_tables(&self) -> Vec<&str> {
        let of = |word: &String| self.code.feedbacks.iter().find(|feedback| feedback.word == *word);
        self.code.words("feedback").iter().map(|word| of(word).map_or("", |found| found.table.as_str())).collect()
    }

    fn drives(&self) -> String {
        let heads = self.code.drives.iter().flat_map(|drive| drive.heads.iter().map(move |head| (drive, head)));
        let record = heads.map(|(drive, head)| {
            format!(
                "DriveHead {{ name: {head:?}, size: {}, windings: &[{}], feedbacks: &[{}] }}",
                self.value("size", "Size", self.code.size_of(head).unwrap_or_default()),
                self.values("winding", "Winding", &drive.windings),
                self.values("feedback", "Feedback", &drive.feedbacks),
            )
        });
        record.collect::<Vec<_>>().join(", ")
    }

    fn wirings(&self) -> String {
        joined(&self.code.wirings, |wiring| {
            format!(
                "WiringTables {{ windings: &[{}], feedbacks: &[{}], tables: {:?} }}",
                self.values("winding", "Winding", &wiring.windings),
                self.values("feedback", "Feedback", &wiring.feedbacks),
                wiring.tables,
            )
        })
    }
}
