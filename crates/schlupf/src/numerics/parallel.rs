//! Independent work items: on all threads with the feature `rayon`, otherwise on one. The results
//! are the same.
//!
//! The partition of the work does not depend on the number of threads, and sums run in a fixed
//! order, so results are identical bit for bit. Parts are whole solutions with solvers of their own
//! (members of a family, loads of a fit); a single solution runs on one thread, because splitting
//! its transforms gains less than 10 %.

use std::sync::atomic::{AtomicUsize, Ordering};

/// The results of all items, in their order.
///
/// ```
/// use schlupf::numerics::parallel;
///
/// assert_eq!(parallel::map(vec![1, 2, 3], |number| number * number), [1, 4, 9]);
/// ```
#[cfg(feature = "rayon")]
pub fn map<I: Send, R: Send>(items: Vec<I>, work: impl Fn(I) -> R + Sync + Send) -> Vec<R> {
    use rayon::iter::{IntoParallelIterator, ParallelIterator};
    items.into_par_iter().map(work).collect()
}

/// The results of all items, in their order.
#[cfg(not(feature = "rayon"))]
pub fn map<I: Send, R: Send>(items: Vec<I>, work: impl Fn(I) -> R + Sync + Send) -> Vec<R> {
    items.into_iter().map(work).collect()
}

/// The same for items that may fail: returns the first error in the order of the items.
///
/// ```
/// use schlupf::numerics::parallel;
/// use schlupf::Problem;
///
/// let problems =
///     parallel::try_map(vec![10.0, 20.0], |speed| Problem::builder().speed(speed).build())?;
/// assert_eq!(problems[1].kinematics.speed, 20.0);
/// # Ok::<(), schlupf::Error>(())
/// ```
pub fn try_map<I: Send, R: Send, E: Send>(
    items: Vec<I>,
    work: impl Fn(I) -> Result<R, E> + Sync + Send,
) -> Result<Vec<R>, E> {
    let first_failed = AtomicUsize::new(usize::MAX);
    let work = |(k, item)| {
        if k > first_failed.load(Ordering::Relaxed) {
            return None;
        }
        let result = work(item);
        if result.is_err() {
            first_failed.fetch_min(k, Ordering::Relaxed);
        }
        Some(result)
    };
    // What stands behind the first error is left out.
    map(items.into_iter().enumerate().collect(), work).into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_error_in_the_order_of_the_items_ends_the_work() {
        let done = AtomicUsize::new(0);
        let work = |k: usize| {
            done.fetch_add(1, Ordering::Relaxed);
            if k % 10 == 7 { Err(k) } else { Ok(k) }
        };
        assert_eq!(try_map((0..1000).collect(), work), Err(7));
        assert!(done.load(Ordering::Relaxed) < 1000);
        assert_eq!(try_map(vec![1, 2, 3], work), Ok(vec![1, 2, 3]));
    }
}
