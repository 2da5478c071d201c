//! Parallel loops over independent pieces of work.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{available_parallelism, scope};

/// Returns the number of hardware threads, at least 1.
#[must_use]
#[expect(clippy::disallowed_methods, reason = "processors are counted here")]
pub fn available() -> usize {
    available_parallelism().map_or(1, usize::from)
}

/// Runs `work` for each index below `count`, roughly in order.
///
/// `threads` defaults to the number of hardware threads. With one thread or one index, the caller's
/// thread does the work, so that this function also works on machines without threads. A panic in
/// `work` is passed on.
#[expect(clippy::disallowed_methods, reason = "work is shared out here")]
pub fn for_each(count: usize, threads: Option<usize>, work: &(dyn Fn(usize) + Sync)) {
    let threads = threads.unwrap_or_else(available);
    if threads.min(count) <= 1 {
        return (0..count).for_each(work);
    }
    let next = AtomicUsize::new(0);
    scope(|scope| {
        for _ in 0..threads.min(count) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count {
                        break;
                    }
                    work(index);
                }
            });
        }
    });
}

/// Returns the results of `work` for each index below `count`, in order; see [`for_each`].
pub fn map<R: Send>(count: usize, threads: Option<usize>, work: impl Fn(usize) -> R + Sync) -> Vec<R> {
    let results = Mutex::new(Vec::with_capacity(count));
    for_each(count, threads, &|index| {
        let result = work(index);
        // A panic in `work` cannot poison the lock, because `work` runs outside of it.
        results.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push((index, result));
    });
    let mut results = results.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}

#[cfg(test)]
mod tests {
    use super::{for_each, map};
    use std::sync::atomic::{AtomicU64, Ordering};

    #[test]
    fn every_index_has_its_turn_once_on_any_number_of_threads() {
        for threads in [None, Some(0), Some(1), Some(3), Some(100)] {
            let (sum, squares) = (AtomicU64::new(0), AtomicU64::new(0));
            for_each(50, threads, &|index| {
                sum.fetch_add(index as u64, Ordering::Relaxed);
                squares.fetch_add((index * index) as u64, Ordering::Relaxed);
            });
            assert_eq!((sum.into_inner(), squares.into_inner()), (1225, 40425));
        }
        for_each(0, None, &|_| unreachable!("there is no work"));
    }

    #[test]
    fn results_come_in_the_order_of_their_indices() {
        for threads in [None, Some(1), Some(3)] {
            let doubled = map(300, threads, |index| 2 * index);
            assert_eq!(doubled, (0..300).map(|index| 2 * index).collect::<Vec<_>>());
        }
    }
}
