//! `kahan atlas`: the paper as one page.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Instant, SystemTime};

use clap::Args;
use kahan_atlas::{Found, Making, page};
use kahan_paper::Paper;

use crate::printing::{Answer, Prompt, Refusal, Sink};

/// Writes one page on the paper: its tables, solutions, figures and claims.
///
/// The page is DIR/index.html.
///
/// Everything on the page is computed when it is written, in about half a minute: every claim is
/// established and every orbit followed. The page needs no network and no script. It appears whole
/// or not at all, in place of an older one. The exit status is 1 if a claim does not hold; the page
/// is written all the same, and says which.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Atlas {
    /// The folder for index.html; it is made if it is not there.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

const EXAMPLES: &str = "\
Examples:
  kahan atlas --out atlas
  kahan atlas --out . && xdg-open index.html";

impl Atlas {
    /// Where the page is; a complaint if a claim failed.
    pub(crate) fn run(&self) -> Result<Answer, Refusal> {
        let clock = Instant::now();
        let path = index_in(&self.out)?;
        // Whether the file can be written shows before half a minute is spent; no trace is left if
        // the work is interrupted.
        drop(Sink::file(&path, "--out")?);
        let paper = Paper::new();
        let progress = Prompt::new(Found::steps(&paper) as u64, "claims and orbits");
        let found = Found::compute(&paper, || progress.advance(1));
        progress.finish();
        let sink = Sink::file(&path, "--out")?;
        let text = page(&found, &Making { date: today(), seconds: clock.elapsed().as_secs_f64() });
        sink.put(&text)?;
        let written = Answer::text(format!(
            "{} written: {} claims, {:.1} MB, {:.1} s\n",
            path.display(),
            found.claims.len(),
            text.len() as f64 / 1e6,
            clock.elapsed().as_secs_f64()
        ));
        let complaint = match found.failed() {
            0 => None,
            1 => Some("1 claim failed; the page says which".to_owned()),
            failed => Some(format!("{failed} claims failed; the page says which")),
        };
        Ok(Answer { complaint, ..written })
    }
}

/// The date alone: the time of day says nothing to a reader.
pub(super) fn today() -> String {
    let now = humantime::format_rfc3339_seconds(SystemTime::now()).to_string();
    now.split('T').next().unwrap_or_default().to_owned()
}

/// DIR/index.html, in a folder that is there now.
pub(super) fn index_in(folder: &Path) -> Result<PathBuf, Refusal> {
    let refused = |reason: &str| {
        Refusal::new(format!("--out: cannot use the folder {}: {reason}; name another one", folder.display()))
    };
    if folder.as_os_str().is_empty() {
        return Err(Refusal::new("--out: the name of the folder is empty; write `.` for this one"));
    }
    if folder.exists() && !folder.is_dir() {
        return Err(refused("it is a file"));
    }
    fs::create_dir_all(folder).map_err(|error| refused(&error.to_string()))?;
    Ok(folder.join("index.html"))
}
