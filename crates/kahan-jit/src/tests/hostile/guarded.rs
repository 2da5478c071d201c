//! Slices next to inaccessible pages: an access outside a slice kills the process.
#![expect(unsafe_code, reason = "only the system can forbid memory, and knows nothing of slices")]

use std::ffi::c_void;
use std::marker::PhantomData;
use std::ops::{Deref, DerefMut};
use std::ptr::{self, NonNull};
use std::slice;

use rustix::mm::{MapFlags, MprotectFlags, ProtFlags, mmap_anonymous, mprotect, munmap};

const PAGE: usize = 4096;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Edge {
    Begin,
    End,
}

/// Numbers between two inaccessible pages, initially 0.
pub(crate) struct Guarded<T> {
    pages: NonNull<c_void>,
    bytes: usize,
    start: NonNull<T>,
    len: usize,
    numbers: PhantomData<T>,
}

impl<T: num_traits::Float> Guarded<T> {
    pub(crate) fn zeros(len: usize, edge: Edge) -> Self {
        let used = len * size_of::<T>();
        let inner = used.next_multiple_of(PAGE);
        let bytes = inner + 2 * PAGE;
        // SAFETY: the system chooses unused addresses, and fills the pages with zero bytes, which
        // are valid numbers. The slice starts or ends at a page boundary, so it is aligned.
        unsafe {
            let flags = MapFlags::PRIVATE | MapFlags::NORESERVE;
            let pages = mmap_anonymous(ptr::null_mut(), bytes, ProtFlags::empty(), flags);
            let pages = NonNull::new(pages.expect("there is room")).expect("the first page is nobody's");
            let inner_pages = pages.byte_add(PAGE);
            if inner > 0 {
                mprotect(inner_pages.as_ptr(), inner, MprotectFlags::READ | MprotectFlags::WRITE)
                    .expect("own pages");
            }
            let before = if edge == Edge::Begin { 0 } else { inner - used };
            let start = inner_pages.byte_add(before).cast();
            Guarded { pages, bytes, start, len, numbers: PhantomData }
        }
    }
}

impl<T> Deref for Guarded<T> {
    type Target = [T];

    fn deref(&self) -> &[T] {
        // SAFETY: `len` numbers begin at `start`, and they live as long as `self`.
        unsafe { slice::from_raw_parts(self.start.as_ptr(), self.len) }
    }
}

impl<T> DerefMut for Guarded<T> {
    fn deref_mut(&mut self) -> &mut [T] {
        // SAFETY: `len` numbers begin at `start`, live as long as `self`, and are borrowed
        // exclusively.
        unsafe { slice::from_raw_parts_mut(self.start.as_ptr(), self.len) }
    }
}

impl<T> AsMut<[T]> for Guarded<T> {
    fn as_mut(&mut self) -> &mut [T] {
        self
    }
}

impl<T> Drop for Guarded<T> {
    fn drop(&mut self) {
        // SAFETY: `self` owns the pages, and no slice borrows them any more.
        unsafe { munmap(self.pages.as_ptr(), self.bytes) }.expect("own pages");
    }
}
