//! What the states of a case file have in common, made once.

use std::any::Any;
use std::sync::{Arc, Mutex};

/// From what something was made.
type Key = Vec<Vec<u8>>;

/// What was made, and from what.
type Made = (Key, Arc<dyn Any + Send + Sync>);

/// The last things that were made.
#[derive(Debug, Clone, Default)]
pub struct Kept(Arc<Mutex<Vec<Made>>>);

/// How many of them: profiles of both wheels and both rails, and their pairs.
const MOST: usize = 5;

impl Kept {
    /// What was made from the same.
    pub fn known<T: Clone + 'static>(&self, key: &Key) -> Option<T> {
        let last = self.0.lock().ok()?;
        let (_, thing) = last.iter().find(|(other, _)| other == key)?;
        thing.downcast_ref::<T>().cloned()
    }

    /// Keeps it.
    pub fn keep<T: Clone + Send + Sync + 'static>(&self, key: Key, thing: &T) {
        if let Ok(mut last) = self.0.lock() {
            last.retain(|(other, _)| *other != key);
            last.insert(0, (key, Arc::new(thing.clone())));
            last.truncate(MOST);
        }
    }
}
