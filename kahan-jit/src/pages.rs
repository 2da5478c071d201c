//! Memory that code may run in.
//!
//! In: the bytes of code and its numbers. Out: pages that hold them, which can be read and run.
//! They are writable before that, never both at once, and go back to the system when they are
//! dropped. A system that gives no such memory answers with an error.

use std::io;

use memmap2::{Mmap, MmapMut};

/// Code where it may run.
#[derive(Debug)]
pub(crate) struct Pages(Mmap);

impl Pages {
    /// Copies code into pages of its own.
    ///
    /// # Errors
    /// That of the system: it has no memory left, or forbids code that is made at run time.
    pub(crate) fn new(bytes: &[u8]) -> io::Result<Self> {
        let mut pages = MmapMut::map_anon(bytes.len())?;
        pages.copy_from_slice(bytes);
        Ok(Pages(pages.make_exec()?))
    }

    /// The address of the first byte, which begins a page.
    pub(crate) fn start(&self) -> *const u8 {
        self.0.as_ptr()
    }
}

#[cfg(test)]
mod tests;
