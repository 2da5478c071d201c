//! Memory that code may run in.
use std::io;
use memmap2::{Mmap, MmapMut};
#[derive(Debug)]
pub(crate) struct Pages(Mmap);
impl Pages {
    pub(crate) fn new(bytes: &[u8]) -> io::Result<Self> {
        let mut pages = MmapMut::map_anon(bytes.len())?;
        pages.copy_from_slice(bytes);
        Ok(Pages(pages.make_exec()?))
    }
    pub(crate) fn start(&self) -> *const u8 { self.0.as_ptr() }
}
