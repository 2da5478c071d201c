//! Executable memory.
//!
//! In: the bytes of code and its constants. Out: pages that can be read and run, or the system's
//! error. Pages are writable first and executable later, never both, and are unmapped when they are
//! dropped. 64-bit Arm fetches instructions through a separate cache, which is synchronised here.

#[cfg(all(target_arch = "aarch64", feature = "pages"))]
mod cache;

use std::io;

#[cfg(feature = "pages")]
type Memory = memmap2::Mmap;
/// The empty memory without the feature `pages`.
#[cfg(not(feature = "pages"))]
type Memory = &'static [u8; 0];

#[derive(Debug)]
pub(crate) struct Pages(Memory);

impl Pages {
    /// Copies code into pages of its own.
    ///
    /// # Errors
    /// The system's error, if it has no memory left or forbids code made at run time.
    #[cfg(feature = "pages")]
    pub(crate) fn new(bytes: &[u8]) -> io::Result<Self> {
        let mut pages = memmap2::MmapMut::map_anon(bytes.len())?;
        pages.copy_from_slice(bytes);
        let pages = pages.make_exec()?;
        #[cfg(target_arch = "aarch64")]
        cache::publish(&pages);
        Ok(Pages(pages))
    }

    /// Returns an error: without the feature `pages` code cannot run.
    #[cfg(not(feature = "pages"))]
    pub(crate) fn new(_: &[u8]) -> io::Result<Self> {
        Err(io::ErrorKind::Unsupported.into())
    }

    /// Returns the address of the first byte, for a thread that is about to run the code. Another
    /// thread may have made the pages.
    #[inline]
    pub(crate) fn entry(&self) -> *const u8 {
        #[cfg(all(target_arch = "aarch64", feature = "pages"))]
        cache::discard_fetched();
        self.start()
    }

    pub(crate) fn start(&self) -> *const u8 {
        self.0.as_ptr()
    }
}

#[cfg(all(test, feature = "pages"))]
mod tests;
