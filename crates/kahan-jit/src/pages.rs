//! Executable memory.
//!
//! Pages are never writable and executable at once, and are unmapped when dropped.

#[cfg(all(target_arch = "aarch64", feature = "pages"))]
mod cache;

use std::io;

#[cfg(feature = "pages")]
type Memory = memmap2::Mmap;
/// A stand-in for the type of executable memory, which only the feature `pages` provides.
#[cfg(not(feature = "pages"))]
type Memory = &'static [u8; 0];

#[derive(Debug)]
pub(crate) struct Pages(Memory);

impl Pages {
    /// Copies code into newly allocated pages. Fails if memory is exhausted, or if the system
    /// forbids run-time code.
    #[cfg(feature = "pages")]
    pub(crate) fn new(bytes: &[u8]) -> io::Result<Self> {
        let mut pages = memmap2::MmapMut::map_anon(bytes.len())?;
        pages.copy_from_slice(bytes);
        let pages = pages.make_exec()?;
        #[cfg(target_arch = "aarch64")]
        cache::publish(&pages);
        Ok(Pages(pages))
    }

    /// Fails, because code cannot run without the feature `pages`.
    #[cfg(not(feature = "pages"))]
    pub(crate) fn new(_: &[u8]) -> io::Result<Self> {
        Err(io::ErrorKind::Unsupported.into())
    }

    /// Returns the address of the first byte. On 64-bit Arm, discards prefetched instructions.
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
