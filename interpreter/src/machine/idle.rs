//! Memory that nobody uses now.

use std::ptr;
use std::sync::atomic::{AtomicPtr, Ordering};

/// A place for one piece of memory that is used again and again. Where several threads want it at once, all but one have to
/// make their own.
pub(super) struct Idle<T>(AtomicPtr<T>);

impl<T> Idle<T> {
    /// An empty place.
    pub const fn new() -> Self {
        Self(AtomicPtr::new(ptr::null_mut()))
    }

    /// Takes what is there.
    #[inline]
    pub fn take(&self) -> Option<Box<T>> {
        let taken = self.0.swap(ptr::null_mut(), Ordering::Acquire);
        // SAFETY: what is not null comes from a box, see `give`, and has been taken out of its only place.
        (!taken.is_null()).then(|| unsafe { Box::from_raw(taken) })
    }

    /// Puts something there, in the place of what is there.
    #[inline]
    pub fn give(&self, memory: Box<T>) {
        let before = self.0.swap(Box::into_raw(memory), Ordering::AcqRel);
        if !before.is_null() {
            // SAFETY: as above.
            drop(unsafe { Box::from_raw(before) });
        }
    }
}

impl<T> Drop for Idle<T> {
    fn drop(&mut self) {
        self.take();
    }
}

// SAFETY: it owns a box, which several threads may take, but only one of them gets.
unsafe impl<T: Send> Send for Idle<T> {}
// SAFETY: as above.
unsafe impl<T: Send> Sync for Idle<T> {}
