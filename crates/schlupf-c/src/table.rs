//! All elements, by handles: the place in the table, and how often it was taken and left.
//!
//! The table grows in parts that never move, so that finding an element takes no lock but its own.
//! A place is taken again under another number, so that an old handle is not found.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError, TryLockError};

use crate::Status;
use crate::held::Held;

/// A place for an element, apart from others: threads do not share lines of the cache.
#[derive(Debug)]
#[repr(align(128))]
struct Place {
    /// How often the place was taken and left; odd while it is taken.
    times: AtomicU32,
    held: Mutex<Option<Held>>,
}

/// Places of the first part; each further part has twice as many as the one before it.
const FIRST: u64 = 64;
const PARTS: usize = 27;

static TABLE: [OnceLock<Box<[Place]>>; PARTS] = [const { OnceLock::new() }; PARTS];

/// Places that were never taken begin at `next`.
#[derive(Debug)]
struct Free {
    left: Vec<u32>,
    next: u32,
}

static FREE: Mutex<Free> = Mutex::new(Free { left: Vec::new(), next: 0 });

fn free() -> MutexGuard<'static, Free> {
    FREE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Part of the table, its size, and the place in it.
fn position(index: u32) -> (usize, u64, usize) {
    let number = u64::from(index) + FIRST;
    let size = 1 << number.ilog2();
    ((number / FIRST).ilog2() as usize, size, (number - size) as usize)
}

fn place(index: u32) -> Option<&'static Place> {
    let (part, _, at) = position(index);
    TABLE.get(part)?.get()?.get(at)
}

/// Puts an element into the table; its handle. `None` if the table is full.
pub fn insert(held: Held) -> Option<u64> {
    let index = {
        let mut free = free();
        let next = free.next;
        free.left.pop().or_else(|| {
            free.next = next.checked_add(1)?;
            Some(next)
        })?
    };
    let (part, size, at) = position(index);
    let empty = |_| Place { times: AtomicU32::new(0), held: Mutex::new(None) };
    let places = TABLE.get(part)?.get_or_init(|| (0..size).map(empty).collect());
    let place = &places[at];
    *place.held.lock().unwrap_or_else(PoisonError::into_inner) = Some(held);
    let times = place.times.fetch_add(1, Ordering::Release) + 1;
    Some(u64::from(times) << 32 | u64::from(index))
}

/// Takes an element out of the table.
pub fn remove(handle: u64) -> Result<(), Status> {
    let (place, mut guard) = locked(handle)?;
    let held = guard.take();
    let times = place.times.fetch_add(1, Ordering::Release) + 1;
    drop(guard);
    // A place whose numbers are used up stays empty.
    if times < u32::MAX - 1 {
        free().left.push(handle as u32);
    }
    drop(held);
    Ok(())
}

/// Does something with an element.
pub fn with<T>(handle: u64, work: impl FnOnce(&mut Held) -> T) -> Result<T, Status> {
    locked(handle)?.1.as_mut().map(work).ok_or(Status::InvalidElement)
}

/// The place of an element that is there. Another handle does not keep its owner from it.
fn locked(handle: u64) -> Result<(&'static Place, MutexGuard<'static, Option<Held>>), Status> {
    let is_there = |place: &Place| {
        let times = place.times.load(Ordering::Acquire);
        times % 2 == 1 && u64::from(times) == handle >> 32
    };
    let place = place(handle as u32).filter(|place| is_there(place));
    let place = place.ok_or(Status::InvalidElement)?;
    let guard = match place.held.try_lock() {
        Ok(guard) => guard,
        Err(TryLockError::Poisoned(guard)) => guard.into_inner(),
        Err(TryLockError::WouldBlock) => return Err(Status::Busy),
    };
    if is_there(place) { Ok((place, guard)) } else { Err(Status::InvalidElement) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::held::Origin;

    fn held() -> Held {
        Held::new(&Origin::Text("nothing", ""), &[])
    }

    /// Places of all parts, each once.
    #[test]
    fn parts_follow_each_other() {
        assert_eq!(position(0), (0, 64, 0));
        assert_eq!(position(63), (0, 64, 63));
        assert_eq!(position(64), (1, 128, 0));
        assert_eq!(position(191), (1, 128, 127));
        assert_eq!(position(192), (2, 256, 0));
        let (part, size, at) = position(u32::MAX);
        assert!(part < PARTS && (at as u64) < size);
    }

    /// A handle is never that of another element, and what is none is not found.
    #[test]
    fn handles_are_found_until_they_are_removed() {
        let handles: Vec<u64> = (0..300).map(|_| insert(held()).unwrap()).collect();
        for handle in &handles {
            assert!(with(*handle, |_| ()).is_ok());
            assert_eq!(remove(*handle), Ok(()));
            assert_eq!(remove(*handle), Err(Status::InvalidElement));
        }
        let again = insert(held()).unwrap();
        assert!(!handles.contains(&again));
        for handle in [0, 1, u64::MAX, 1 << 32 | 0xffff, again + (1 << 32), again + (2 << 32)] {
            assert_eq!(with(handle, |_| ()), Err(Status::InvalidElement));
        }
        let inside = |_: &mut Held| (remove(again), remove(again - (2 << 32)));
        assert_eq!(with(again, inside), Ok((Err(Status::Busy), Err(Status::InvalidElement))));
        assert_eq!(remove(again), Ok(()));
    }
}
