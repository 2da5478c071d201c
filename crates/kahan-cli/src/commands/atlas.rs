//! The command `kahan atlas`, which writes the paper as one page.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use clap::Args;
use kahan_atlas::{AtlasContent, PageCreation, page};
use kahan_paper::Paper;

use crate::printing::{Answer, OutputStream, ProgressDisplay, UsageError};

/// Writes an HTML page about the paper: its tables, solutions, figures and claims.
///
/// The page is DIR/index.html.
///
/// Everything on the page is computed anew, in about half a minute: every claim is proved and every
/// orbit computed. The page needs neither a network nor scripts. It replaces an older page once it
/// is complete. If a claim does not hold, the page is still written and names it, and the exit
/// status is 1.
#[derive(Args, Debug)]
#[command(after_help = "\
Examples:
  kahan atlas --out atlas
  kahan atlas --out . && xdg-open index.html")]
pub(crate) struct Atlas {
    /// The folder for index.html, created if missing.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

impl Atlas {
    pub(crate) fn run(&self) -> Result<Answer, UsageError> {
        let index = IndexFile::begin(&self.out)?;
        let paper = Paper::new();
        let prompt = ProgressDisplay::new(AtlasContent::steps(&paper) as u64, "claims and orbits");
        let found = AtlasContent::compute(&paper, || prompt.show_steps(1));
        drop(prompt);
        let text = page(&found, &index.creation());
        let answer = index.put(&text, &format!("{} claims, ", found.claims.len()), 1)?;
        Ok(answer.with_complaint(match found.failed() {
            0 => None,
            1 => Some("1 claim failed; the page says which".to_owned()),
            failed => Some(format!("{failed} claims failed; the page says which")),
        }))
    }
}

/// The unfinished file DIR/index.html. The file appears only when it is complete.
pub(super) struct IndexFile {
    path: PathBuf,
    since: Instant,
}

impl IndexFile {
    /// Creates a missing folder, and checks that the file can be written.
    pub(super) fn begin(folder: &Path) -> Result<Self, UsageError> {
        let since = Instant::now();
        let shown = folder.display();
        let refused = |reason: &str| {
            UsageError::new(format!("--out: cannot use the folder {shown}: {reason}; name another one"))
        };
        if folder.as_os_str().is_empty() {
            return Err(UsageError::new("--out: the name of the folder is empty; write `.` for this one"));
        }
        if folder.exists() && !folder.is_dir() {
            return Err(refused("it is a file"));
        }
        fs::create_dir_all(folder).map_err(|error| refused(&error.to_string()))?;
        let path = folder.join("index.html");
        // Opening the file now reports errors early. Dropping it removes its temporary file.
        drop(OutputStream::file(&path, "--out")?);
        Ok(IndexFile { path, since })
    }

    /// Returns today's date, and the seconds since [`Self::begin`].
    pub(super) fn creation(&self) -> PageCreation {
        let now = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
        let date = now.split('T').next().unwrap_or_default().to_owned();
        PageCreation { date, seconds: self.since.elapsed().as_secs_f64() }
    }

    /// Writes the page. The answer has the path, the contents `holds`, and the size in MB.
    pub(super) fn put(self, text: &str, holds: &str, decimals: usize) -> Result<Answer, UsageError> {
        OutputStream::file(&self.path, "--out")?.put(text)?;
        let (path, size) = (self.path.display(), text.len() as f64 / 1e6);
        let seconds = self.since.elapsed().as_secs_f64();
        Ok(Answer::text(format!("{path} written: {holds}{size:.decimals$} MB, {seconds:.1} s\n")))
    }
}
