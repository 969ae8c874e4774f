//! Input files of CONTACT as cases.

mod support;
mod contact;
mod elements;
mod layers;
mod placing;
mod results;
mod wheels;
