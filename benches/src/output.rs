//! Writes files atomically.

use std::io::Write;
use std::path::Path;

use anyhow::{Context, Result};
use tempfile::NamedTempFile;

/// Writes `text` to a temporary file and renames it to `path`.
pub(crate) fn write_whole(path: &Path, text: &str) -> Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let refused = || format!("cannot write the file {}; choose another place with --out", path.display());
    let mut file = NamedTempFile::new_in(folder).with_context(refused)?;
    file.write_all(text.as_bytes()).with_context(refused)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let readable = std::fs::Permissions::from_mode(0o644);
        file.as_file().set_permissions(readable).with_context(refused)?;
    }
    file.persist(path).with_context(refused)?;
    Ok(())
}
