//! Memory that code may run in.
use memmap2::{Mmap, MmapMut};
use std::io;
#[derive(Debug)]
pub(crate) struct Pages(Mmap);
impl Pages {
    pub(crate) fn new(bytes: &[u8]) -> io::Result<Self> {
        let mut pages = MmapMut::map_anon(bytes.len())?;
        pages.copy_from_slice(bytes);
        Ok(Pages(pages.make_exec()?))
    }
    pub(crate) fn start(&self) -> *const u8 {
        self.0.as_ptr()
    }
}
