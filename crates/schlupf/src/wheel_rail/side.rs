//! Left and right.

use std::sync::Arc;

/// A side of the track.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum Side {
    /// That of positive y.
    Left,
    /// That of negative y.
    Right,
}

impl Side {
    /// Sign of y on this side, dimensionless.
    pub fn outwards(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }

    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::Left => Self::Right,
            Self::Right => Self::Left,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// What both sides have, each its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sides<T> {
    /// On the left.
    pub left: T,
    /// On the right.
    pub right: T,
}

impl<T> Sides<T> {
    /// That of one side.
    pub fn of(&self, side: Side) -> &T {
        match side {
            Side::Left => &self.left,
            Side::Right => &self.right,
        }
    }
}

impl<T> Sides<Arc<T>> {
    /// Whether both sides have one and the same, so that one is the mirror image of the other.
    pub fn are_one(&self) -> bool {
        Arc::ptr_eq(&self.left, &self.right)
    }
}

impl<T: Clone> Sides<T> {
    /// The same on both sides.
    pub fn both(one: T) -> Self {
        Self { left: one.clone(), right: one }
    }
}
