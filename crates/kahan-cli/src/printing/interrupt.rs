//! Removes unfinished files on SIGINT and SIGTERM, and ends the process with status 130 or 143.
//!
//! This works on Unix only. On other systems, an interrupt leaves unfinished files behind.

use std::io;
use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use tempfile::NamedTempFile;

static UNFINISHED_FILES: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// An entry in the list of unfinished files. Dropping the entry removes it from the list.
pub(super) struct UnfinishedFile(PathBuf);

/// Creates a temporary file that SIGINT and SIGTERM remove on Unix.
pub(super) fn unfinished(
    make: impl FnOnce() -> io::Result<NamedTempFile>,
) -> io::Result<(NamedTempFile, UnfinishedFile)> {
    listen()?;
    // The handler of signals waits for this lock, so it finds the new file in the list.
    let mut list = UNFINISHED_FILES.lock().unwrap_or_else(PoisonError::into_inner);
    let file = make()?;
    list.push(file.path().to_path_buf());
    let path = file.path().to_path_buf();
    Ok((file, UnfinishedFile(path)))
}

impl Drop for UnfinishedFile {
    fn drop(&mut self) {
        UNFINISHED_FILES.lock().unwrap_or_else(PoisonError::into_inner).retain(|path| *path != self.0);
    }
}

/// Starts a thread that waits for a signal. Later calls do nothing.
#[cfg(unix)]
fn listen() -> io::Result<()> {
    use std::sync::atomic::{AtomicBool, Ordering};

    use signal_hook::consts::{SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;

    static IS_LISTENING: AtomicBool = AtomicBool::new(false);
    if IS_LISTENING.swap(true, Ordering::SeqCst) {
        return Ok(());
    }
    let mut signals = Signals::new([SIGINT, SIGTERM])?;
    std::thread::Builder::new().name("signals".to_owned()).spawn(move || {
        if let Some(signal) = signals.forever().next() {
            // The lock is never released, so no new file is made before the process ends.
            let list = UNFINISHED_FILES.lock().unwrap_or_else(PoisonError::into_inner);
            for path in list.iter() {
                // A finished file may have been renamed in the meantime, so errors are ignored.
                let _ = std::fs::remove_file(path);
            }
            std::process::exit(128 + signal);
        }
    })?;
    Ok(())
}

/// Does nothing. On other systems an interrupt ends the process, and unfinished files stay.
#[cfg(not(unix))]
fn listen() -> io::Result<()> {
    Ok(())
}
