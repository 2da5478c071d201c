//! Destinations of long output: standard output, or a file that appears whole or not at all.
//!
//! A file gets its name when it is complete. Unfinished files are removed after errors and, on
//! Unix, after SIGINT and SIGTERM. Other signals leave a temporary file `.kahan-….tmp` behind.

use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Seek, SeekFrom, Stdout, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use tempfile::NamedTempFile;

use super::interrupt::{UnfinishedFile, unfinished};
use super::output::UsageError;

pub(crate) struct OutputStream(Destination);

enum Destination {
    Standard { writer: BufWriter<Stdout>, flushed: Instant },
    File { writer: BufWriter<NamedTempFile>, path: PathBuf, unfinished: UnfinishedFile },
}

#[derive(Debug)]
pub(crate) enum WriteError {
    /// The reader of standard output has closed the pipe, which is not an error.
    ReaderGone,
    /// An error, described by one sentence for the user.
    Failed(String),
}

impl From<WriteError> for UsageError {
    fn from(broken: WriteError) -> Self {
        match broken {
            WriteError::ReaderGone => UsageError::new("the reader of the output has gone away"),
            WriteError::Failed(reason) => UsageError::new(reason),
        }
    }
}

/// A write also flushes the output if this time has passed since the last flush.
const FLUSH_INTERVAL: Duration = Duration::from_millis(100);

impl OutputStream {
    pub(crate) fn standard() -> Self {
        OutputStream(Destination::Standard { writer: BufWriter::new(io::stdout()), flushed: Instant::now() })
    }

    /// Opens a file, which appears on [`finish`](Self::finish). Error messages name the option.
    pub(crate) fn file(path: &Path, option: &str) -> Result<Self, UsageError> {
        let refused = |reason: &str| {
            UsageError::new(format!("{option}: cannot write the file {}: {reason}", path.display()))
        };
        // A symbolic link stays, and its target is replaced. Devices and directories are refused.
        let path = match fs::canonicalize(path) {
            Ok(found) if found.is_file() => found,
            Ok(found) if found.is_dir() => return Err(refused("it is a directory; add a file name")),
            Ok(_) => return Err(refused("it is no ordinary file; name one")),
            Err(_) => path.to_path_buf(),
        };
        let folder = path.parent().filter(|parent| !parent.as_os_str().is_empty());
        let folder = folder.unwrap_or(Path::new("."));
        if path.file_name().is_none() {
            return Err(refused("it has no file name"));
        }
        // The error must not show the name of the temporary file.
        let (file, unfinished) = unfinished(|| temporary(folder)).map_err(|error| {
            refused(&match error.kind() {
                ErrorKind::NotFound => format!("the folder {} does not exist", folder.display()),
                kind => format!("no file can be made in {} ({kind})", folder.display()),
            })
        })?;
        Ok(OutputStream(Destination::File { writer: BufWriter::new(file), path, unfinished }))
    }

    /// Opens a file for a table. Refuses names with an extension other than `.csv`.
    pub(crate) fn table(path: &Path) -> Result<Self, UsageError> {
        if path.extension().is_none() || is_table(path) {
            return Self::file(path, "--out");
        }
        Err(UsageError::new(format!(
            "--out: the name of the file, {}, tells its format: a table is CSV, and ends in .csv",
            path.display()
        )))
    }

    pub(crate) fn is_standard(&self) -> bool {
        matches!(self.0, Destination::Standard { .. })
    }

    pub(crate) fn write(&mut self, content: impl AsRef<[u8]>) -> Result<(), WriteError> {
        let written = match &mut self.0 {
            Destination::File { writer, .. } => writer.write_all(content.as_ref()),
            Destination::Standard { writer, flushed } => writer.write_all(content.as_ref()).and_then(|()| {
                if flushed.elapsed() >= FLUSH_INTERVAL {
                    writer.flush()?;
                    *flushed = Instant::now();
                }
                Ok(())
            }),
        };
        written.map_err(|error| self.broken(&error))
    }

    pub(super) fn overwrite_beginning(&mut self, bytes: &[u8]) -> Result<(), WriteError> {
        let Destination::File { writer, .. } = &mut self.0 else { return Ok(()) };
        let written = writer.rewind().and_then(|()| {
            writer.write_all(bytes)?;
            writer.seek(SeekFrom::End(0)).map(|_| ())
        });
        written.map_err(|error| self.broken(&error))
    }

    pub(crate) fn put(mut self, content: impl AsRef<[u8]>) -> Result<(), UsageError> {
        self.write(content)?;
        Ok(self.finish()?)
    }

    /// Writes buffered output. An output file then gets its final name.
    pub(crate) fn finish(mut self) -> Result<(), WriteError> {
        let flushed =
            if let Destination::Standard { writer, .. } = &mut self.0 { writer.flush() } else { Ok(()) };
        flushed.map_err(|error| self.broken(&error))?;
        if let Destination::File { writer, path, unfinished } = self.0 {
            let kept = writer.into_inner().map_err(io::IntoInnerError::into_error).and_then(|file| {
                file.as_file().sync_all()?;
                file.persist(&path).map_err(|error| error.error)
            });
            drop(unfinished);
            kept.map(|_: File| ()).map_err(|error| cannot_write(&path.display().to_string(), &error))?;
        }
        Ok(())
    }

    fn broken(&self, error: &io::Error) -> WriteError {
        match &self.0 {
            Destination::Standard { .. } if error.kind() == ErrorKind::BrokenPipe => WriteError::ReaderGone,
            Destination::Standard { .. } => cannot_write("to standard output", error),
            Destination::File { path, .. } => cannot_write(&path.display().to_string(), error),
        }
    }
}

pub(crate) fn is_table(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"))
}

fn cannot_write(place: &str, error: &io::Error) -> WriteError {
    WriteError::Failed(format!("cannot write {place}: {error}"))
}

/// Makes a temporary file with the user's usual permissions. Those of `tempfile` are stricter.
fn temporary(folder: &Path) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".kahan-").suffix(".tmp");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    builder.tempfile_in(folder)
}
