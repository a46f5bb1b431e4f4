//! A long recording whose load is edited: the shell keeps what was read, and every answer is the one without it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]

use crate::shell;

use axis::{Catalogue, Files, KeptRecordings};
use page::{Call, Method, Reply, Shell, respond};
use quantities::Language;
use questions::Progress;
use shell::{form, page};
use std::cell::RefCell;
use std::sync::Arc;
use testkit::cost::processor_time;

/// A shell with one recording, which it may keep.
struct OneFile {
    content: RefCell<Vec<u8>>,
    kept: Option<KeptRecordings>,
}

impl OneFile {
    fn of(content: String, keeps: bool) -> Self {
        Self { content: RefCell::new(content.into_bytes()), kept: keeps.then(KeptRecordings::default) }
    }

    fn post(&self, text: &str) -> Reply {
        self.asked("/work", &[("text", text), ("good", text), ("unfolded", "true")], &Progress::endless())
    }

    fn asked(&self, path: &str, fields: &[(&str, &str)], progress: &Progress) -> Reply {
        let body = form(fields);
        let media = Some("application/x-www-form-urlencoded");
        let call = Call { method: Method::Post, path, query: "", media, body: body.as_bytes(), language: Language::En };
        respond(&call, self, progress)
    }
}

impl Files for OneFile {
    fn open(&self, _: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        Ok(Box::new(std::io::Cursor::new(self.content.borrow().clone())))
    }

    fn size(&self, _: &str) -> Option<u64> {
        Some(self.content.borrow().len() as u64)
    }

    fn kept(&self) -> Option<&KeptRecordings> {
        self.kept.as_ref()
    }
}

impl Shell for OneFile {
    fn files(&self) -> &dyn Files {
        self
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.len().to_string()
    }
}

fn swing(rows: u32, amplitude: f64) -> String {
    let row = |at: u32| {
        let time = f64::from(at) * 1e-4;
        let angle = amplitude * (1.0 - (0.2 * std::f64::consts::PI * time).cos()) + 0.01 * (60.0 * time).sin();
        format!("{time:.4};{angle:.6};{:.4}\n", 2.0 * (3.0 * time).cos())
    };
    std::iter::once(String::from("time_s;position_deg;torque_nm\n")).chain((0..=rows).map(row)).collect()
}

fn project(load: &str, keys: &str) -> String {
    format!(
        "format = 1\n[axis]\nsingle_move = true\n{load}\n[[motion]]\nlaw = \"recorded\"\nfile = \"run.csv\"\n{keys}"
    )
}

/// Every answer of a shell that keeps recordings is the one of a shell that keeps none, to the last byte: another load, another
/// use of the recording, another content of the file.
#[test]
fn what_is_kept_changes_no_answer() {
    let keeping = OneFile::of(swing(20_000, 45.0), true);
    let mut steps = vec![
        (project("[load]\ninertia = \"1.3 kg m^2\"", ""), None),
        (project("[load]\ninertia = \"1.4 kg m^2\"", ""), None),
        (project("[load]\ninertia = \"1.4 kg m^2\"\nfriction_torque = \"2 N m\"", ""), None),
        (project("[mechanism.arm]\nshape = \"rod\"\nlength = \"300 mm\"\nmass = \"3 kg\"", ""), None),
        (project("[mechanism.arm]\nshape = \"rod\"\nlength = \"300 mm\"\nmass = \"4 kg\"", ""), None),
        (project("[load]\ninertia = \"1.4 kg m^2\"", "smoothing = \"5 ms\"\n"), None),
        (project("[load]\ninertia = \"1.4 kg m^2\"", "columns = { torque = \"none\" }\n"), None),
        (project("[load]\ninertia = \"1.4 kg m^2\"", ""), Some(swing(20_000, 46.0))),
    ];
    steps.push((steps[0].0.clone(), Some(swing(20_000, 45.0))));
    for (text, content) in steps {
        if let Some(content) = content {
            *keeping.content.borrow_mut() = content.into_bytes();
        }
        let fresh = OneFile { content: keeping.content.clone(), kept: None };
        let (kept, fresh) = (page(&keeping.post(&text)), page(&fresh.post(&text)));
        assert!(fresh.contains("CHA-"), "no answer for {text}");
        assert!(kept == fresh, "another answer for {text}");
    }
}

/// A recording is neither read nor evaluated again for a key in the load.
#[test]
fn a_key_in_the_load_costs_no_recording() {
    let of = |number: u32| project(&format!("[load]\ninertia = \"1.{number} kg m^2\""), "");
    let cost = |shell: &OneFile| {
        let _ = shell.post(&of(1));
        processor_time(1, || drop(shell.post(&of(2))))
    };
    let recording = || swing(100_000, 45.0);
    let (fresh, kept) = (cost(&OneFile::of(recording(), false)), cost(&OneFile::of(recording(), true)));
    assert!(kept < 0.75 * fresh, "{kept} s with the recording kept, {fresh} s without");
}

/// The cards say that a smaller load is not searched because of the length of the recording; a button searches it if the answer
/// has a time limit.
#[test]
fn a_load_that_was_not_searched_is_said() {
    let heavy = project(
        "[mechanism.arm]\nshape = \"rod\"\nlength = \"2 m\"\nmass = \"900 kg\"\nexternal_torque = \"5 N m\"",
        "columns = { torque = \"none\" }\n",
    );
    let shell = OneFile::of(swing(60_000, 45.0), true);
    let html = page(&shell.asked("/would-fit", &[("text", &heavy)], &Progress::limited()));
    assert!(html.contains("id=\"not-sought\"") && html.contains("thorough"), "{html}");
}
