//! What a command leaves behind that is told to stop: no unfinished file.
//!
//! SIGINT and SIGTERM remove the files that are not finished yet and end the process with status
//! 130 or 143. A signal is sent to the process as a whole, so the list of these files is the
//! process's, too.

use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use tempfile::NamedTempFile;

static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// A file that goes when the process is told to stop, for as long as this value lives.
pub(super) struct Unfinished(PathBuf);

/// Makes a file that no signal leaves behind.
pub(super) fn unfinished(
    make: impl FnOnce() -> io::Result<NamedTempFile>,
) -> io::Result<(NamedTempFile, Unfinished)> {
    listen()?;
    // Who holds the list keeps the signals waiting: no file is made and not yet listed.
    let mut list = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
    let file = make()?;
    list.push(file.path().to_path_buf());
    let path = file.path().to_path_buf();
    Ok((file, Unfinished(path)))
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.0);
    }
}

/// Waits for a signal on a thread of its own, from the first unfinished file to the end of the
/// process.
#[cfg(unix)]
fn listen() -> io::Result<()> {
    use std::sync::atomic::{AtomicBool, Ordering};

    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    static LISTENS: AtomicBool = AtomicBool::new(false);
    if LISTENS.swap(true, Ordering::SeqCst) {
        return Ok(());
    }
    let mut signals = Signals::new([SIGINT, SIGTERM])?;
    std::thread::Builder::new().name("signals".to_owned()).spawn(move || {
        if let Some(signal) = signals.forever().next() {
            // Held to the end, so that no further file is made.
            let list = UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner);
            for path in list.iter() {
                // A file that has just got its name is not there any more under this one.
                let _ = std::fs::remove_file(path);
            }
            std::process::exit(128 + signal);
        }
    })?;
    Ok(())
}

/// Elsewhere an interrupted process ends as the system has it.
#[cfg(not(unix))]
fn listen() -> io::Result<()> {
    Ok(())
}
