//! Memory that code may run in.
//!
//! In: the bytes of code and its numbers. Out: pages that hold them, which can be read and run.
//! They are writable before that, never both at once, and go back to the system when they are
//! dropped. A system that gives no such memory answers with an error.
//!
//! Processors of 64-bit Arm fetch instructions through a cache of their own, which is told of them.

#[cfg(all(target_arch = "aarch64", feature = "pages"))]
mod cache;

use std::io;

#[cfg(feature = "pages")]
type Memory = memmap2::Mmap;
/// Without the feature `pages` there is none.
#[cfg(not(feature = "pages"))]
type Memory = &'static [u8; 0];

/// Code where it may run.
#[derive(Debug)]
pub(crate) struct Pages(Memory);

impl Pages {
    /// Copies code into pages of its own.
    ///
    /// # Errors
    /// That of the system: it has no memory left, or forbids code that is made at run time.
    #[cfg(feature = "pages")]
    pub(crate) fn new(bytes: &[u8]) -> io::Result<Self> {
        let mut pages = memmap2::MmapMut::map_anon(bytes.len())?;
        pages.copy_from_slice(bytes);
        let pages = pages.make_exec()?;
        #[cfg(target_arch = "aarch64")]
        cache::publish(&pages);
        Ok(Pages(pages))
    }

    /// There are no pages.
    #[cfg(not(feature = "pages"))]
    pub(crate) fn new(_: &[u8]) -> io::Result<Self> {
        Err(io::ErrorKind::Unsupported.into())
    }

    /// The address of the first byte, for a thread that is about to run it; another one may have
    /// made the pages.
    #[inline]
    pub(crate) fn entry(&self) -> *const u8 {
        #[cfg(all(target_arch = "aarch64", feature = "pages"))]
        cache::discard_fetched();
        self.start()
    }

    /// The address of the first byte, which begins a page.
    pub(crate) fn start(&self) -> *const u8 {
        self.0.as_ptr()
    }
}

#[cfg(all(test, feature = "pages"))]
mod tests;
