//! Look-up tables of creep forces.

mod accuracy;
mod evaluation;
mod files;
