//! Independent work items: on all threads with the feature `rayon`, otherwise on one. The results
//! are the same.

/// The results of all items, in their order.
///
/// ```
/// use schlupf::parallel;
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
/// use schlupf::{Problem, parallel};
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
    map(items, work).into_iter().collect()
}
