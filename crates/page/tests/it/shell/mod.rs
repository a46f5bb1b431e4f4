//! Shared code of the page tests: shells without resources or with a folder in memory, requests, and checks of a whole
//! page.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "a test fails loudly")]
#![allow(dead_code, unreachable_pub, reason = "each test takes what it needs")]

use axis::{Catalogue, Files, NoFiles};
use page::{Call, FileEntry, Folder, Method, Reply, SaveFault, Shell, respond};
use quantities::Language;
use questions::Progress;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::sync::Arc;
#[allow(unused_imports, reason = "each test takes what it needs")]
pub use testkit::html::whole;

/// A shell without resources.
pub struct Alone;

impl Shell for Alone {
    fn files(&self) -> &dyn Files {
        &NoFiles
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn version(&self, bytes: &[u8]) -> String {
        bytes.len().to_string()
    }
}

pub fn form(fields: &[(&str, &str)]) -> String {
    let one = |(key, value): &(&str, &str)| {
        let code = |text: &str| text.bytes().map(|byte| format!("%{byte:02x}")).collect::<String>();
        format!("{}={}", code(key), code(value))
    };
    fields.iter().map(one).collect::<Vec<_>>().join("&")
}

pub fn post(path: &str, fields: &[(&str, &str)]) -> Reply {
    let body = form(fields);
    let media = Some("application/x-www-form-urlencoded");
    let call = Call { method: Method::Post, path, query: "", media, body: body.as_bytes(), language: Language::En };
    respond(&call, &Alone, &Progress::endless())
}

pub fn get(path: &str, query: &str) -> Reply {
    let call = Call { method: Method::Get, path, query, media: None, body: &[], language: Language::En };
    respond(&call, &Alone, &Progress::endless())
}

pub fn page(reply: &Reply) -> String {
    assert_eq!(reply.status, 200);
    String::from_utf8(reply.body.clone()).unwrap()
}

/// A folder in memory that keeps the promises of a working folder.
#[derive(Default)]
pub struct InMemory(pub RefCell<BTreeMap<String, Vec<u8>>>);

impl Folder for InMemory {
    fn list(&self) -> std::io::Result<Vec<FileEntry>> {
        let named = |name: &&String| name.ends_with(".toml");
        let entry = |name: &String| FileEntry { name: name.clone(), modified_s: 1_772_323_200 };
        Ok(self.0.borrow().keys().filter(named).map(entry).collect())
    }

    fn read(&self, name: &str) -> std::io::Result<Vec<u8>> {
        self.0.borrow().get(name).cloned().ok_or_else(|| std::io::ErrorKind::NotFound.into())
    }

    fn save(&self, name: &str, text: &[u8], known: Option<&str>) -> Result<(), SaveFault> {
        let there = self.0.borrow().get(name).map(|bytes| self.version(bytes));
        if there.as_deref() != known {
            return Err(SaveFault::Changed);
        }
        let _ = self.0.borrow_mut().insert(name.to_owned(), text.to_vec());
        Ok(())
    }

    fn keep(&self, name: &str, bytes: &[u8]) -> Result<String, SaveFault> {
        let name = if self.0.borrow().contains_key(name) { format!("2-{name}") } else { name.to_owned() };
        let _ = self.0.borrow_mut().insert(name.clone(), bytes.to_vec());
        Ok(name)
    }
}

impl Files for InMemory {
    fn open(&self, name: &str) -> std::io::Result<Box<dyn std::io::Read>> {
        let bytes = self.0.borrow().get(name).cloned().ok_or(std::io::ErrorKind::NotFound)?;
        Ok(Box::new(std::io::Cursor::new(bytes)))
    }
}

impl Shell for InMemory {
    fn files(&self) -> &dyn Files {
        self
    }

    fn catalogue(&self) -> &Arc<dyn Catalogue> {
        questions::embedded_catalogue()
    }

    fn folder(&self) -> Option<&dyn Folder> {
        Some(self)
    }

    fn version(&self, bytes: &[u8]) -> String {
        format!("{bytes:x?}").replace(' ', "")
    }
}

impl InMemory {
    /// Returns the reply to a form.
    pub fn post(&self, path: &str, fields: &[(&str, &str)]) -> Reply {
        let body = form(fields);
        let media = Some("application/x-www-form-urlencoded");
        let call = Call { method: Method::Post, path, query: "", media, body: body.as_bytes(), language: Language::En };
        respond(&call, self, &Progress::endless())
    }

    /// Returns the reply to a line of fields with a file behind it.
    pub fn post_file(&self, path: &str, fields: &[(&str, &str)], file: &[u8]) -> Reply {
        let body = [form(fields).as_bytes(), b"\n", file].concat();
        let media = Some("application/octet-stream");
        let call = Call { method: Method::Post, path, query: "", media, body: &body, language: Language::En };
        respond(&call, self, &Progress::endless())
    }

    /// Returns the reply to a query.
    pub fn get(&self, path: &str, query: &str) -> Reply {
        let call = Call { method: Method::Get, path, query, media: None, body: &[], language: Language::En };
        respond(&call, self, &Progress::endless())
    }
}
