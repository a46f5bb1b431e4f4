//! Yanked crates: a version withdrawn by its author must not stay in the lock file.
//!
//! `cargo deny` finds them in cargo's copy of the registry index, and checks them together with security advisories,
//! whose database is not used here (`deny.toml` states why). It requires a database, so one is created here with an
//! entry for a crate that does not exist.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use cargo_metadata::MetadataCommand;

use crate::Error;
use crate::cargo::{Workspace, cargo, must_succeed, spelled};
use crate::tools::DENY;

/// A yanked version of a crate that the lock file has in another version: the check must find it to be valid.
const PROOF: (&str, &str) = ("log", "0.4.23");

/// Address under which git finds the database created here; no such host exists (RFC 2606).
const ADDRESS: &str = "https://advisories.invalid/none";

/// Fails if the lock file of `root` has a yanked crate. If the registry is unreachable, the last known state is used,
/// with a message.
///
/// # Errors
/// A yanked crate, named by the tool; a check that does not find the one planted.
pub(crate) fn check(root: &Path) -> Result<(), Error> {
    let folder = Workspace::ask(root)?.target.join("yanked");
    let base = Base::make(&folder)?;
    let fresh = refresh(root);
    if !fresh {
        eprintln!("deny: the registry cannot be asked: yanked crates are those that cargo knew of when it asked last");
    }
    if let Err(error) = base.proven(root) {
        if fresh {
            return Err(error);
        }
        eprintln!("deny: {error}; without the registry this is no proof of anything: yanked crates are not checked");
        return Ok(());
    }
    must_succeed(&mut base.command(root, None)?)
}

/// Makes cargo query the registry about every crate of the lock file, which stays unchanged.
fn refresh(root: &Path) -> bool {
    let mut update = cargo(root, &["update", "--dry-run", "--quiet"]);
    update.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
}

/// The database without advisories, and the settings that name it.
struct Base {
    folder: PathBuf,
    repository: PathBuf,
}

impl Base {
    fn make(folder: &Path) -> Result<Self, Error> {
        let repository = folder.join("advisories");
        if folder.exists() {
            fs::remove_dir_all(folder).map_err(|source| Error::File { path: folder.to_owned(), source })?;
        }
        write(
            &repository.join("crates/nobody/RUSTSEC-2000-0001.md"),
            "```toml\n[advisory]\nid = \"RUSTSEC-2000-0001\"\npackage = \"nobody\"\ndate = \"2000-01-01\"\n\n[versions]\npatched = [\">= 0.0.0\"]\n```\n\n# None\n\nNone.\n",
        )?;
        let path = folder.join("database").to_string_lossy().replace('\\', "/");
        write(
            &folder.join("deny.toml"),
            &format!(
                "[advisories]\ndb-path = \"{path}\"\ndb-urls = [\"{ADDRESS}\"]\ngit-fetch-with-cli = true\nyanked = \"deny\"\n"
            ),
        )?;
        let git = |words: &[&str]| {
            let mut command = Command::new("git");
            let nobody =
                ["-c", "user.name=antrieb", "-c", "user.email=antrieb@example.invalid", "-c", "commit.gpgsign=false"];
            command.arg("-C").arg(&repository).args(nobody).args(words);
            must_succeed(&mut command)
        };
        git(&["init", "--quiet", "--initial-branch=main"])?;
        git(&["add", "--all"])?;
        git(&["commit", "--quiet", "--no-verify", "--message=none"])?;
        Ok(Self { folder: folder.to_owned(), repository })
    }

    /// Returns the check of `root`, or of metadata in a file.
    fn command(&self, root: &Path, listing: Option<&Path>) -> Result<Command, Error> {
        let mut command = DENY.command(root)?;
        command.args(["--color", "never", "--locked", "--workspace", "--config"]).arg(self.folder.join("deny.toml"));
        if let Some(listing) = listing {
            command.arg("--metadata-path").arg(listing);
        }
        command.args(["check", "--hide-inclusion-graph", "advisories"]);
        command.env("GIT_CONFIG_COUNT", "1").env("GIT_CONFIG_VALUE_0", ADDRESS);
        command.env("GIT_CONFIG_KEY_0", format!("url.file://{}.insteadOf", self.repository.display()));
        Ok(command)
    }

    /// Returns an error unless the check finds the yanked version of [`PROOF`] in a lock file.
    fn proven(&self, root: &Path) -> Result<(), Error> {
        let listing = self.drafted()?;
        let mut command = self.command(root, Some(&listing))?;
        let found: Output =
            command.output().map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
        let said = String::from_utf8_lossy(&found.stderr);
        if !found.status.success() && said.contains("error[yanked]") && said.contains(PROOF.1) {
            return Ok(());
        }
        Err(Error::BlindToYanked { name: PROOF.0, version: PROOF.1 })
    }

    /// Writes cargo's metadata for a package that uses the crate of [`PROOF`], with its yanked version in place of the
    /// present one. No crate is fetched.
    fn drafted(&self) -> Result<PathBuf, Error> {
        let (name, version) = PROOF;
        let package = self.folder.join("proof");
        write(
            &package.join("Cargo.toml"),
            &format!(
                "[package]\nname = \"proof\"\nversion = \"0.0.0\"\n[dependencies]\n{name} = \"0.4\"\n[workspace]\n"
            ),
        )?;
        write(&package.join("src/lib.rs"), "")?;
        let mut command = cargo(&package, &["metadata", "--format-version", "1", "--offline"]);
        let listing = command.output().map_err(|source| Error::NotStarted { command: spelled(&command), source })?;
        let text = String::from_utf8_lossy(&listing.stdout).into_owned();
        let all = MetadataCommand::parse(&text).map_err(|source| Error::Metadata { source: Box::new(source) })?;
        let known = all.packages.iter().find(|package| package.name == name);
        let known = known.map(|package| package.version.to_string()).ok_or(Error::NoPackage { name })?;
        let named = |version: &str| format!("#{name}@{version}\"");
        let entry = |version: &str| format!("\"name\":\"{name}\",\"version\":\"{version}\"");
        let text = text.replace(&named(&known), &named(version)).replace(&entry(&known), &entry(version));
        let path = self.folder.join("proof.json");
        write(&path, &text)?;
        Ok(path)
    }
}

fn write(path: &Path, text: &str) -> Result<(), Error> {
    let folder = path.parent().unwrap_or(path);
    let done = fs::create_dir_all(folder).and_then(|()| fs::write(path, text));
    done.map_err(|source| Error::File { path: path.to_owned(), source })
}
