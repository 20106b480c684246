//! Coefficients from tables of measured tests, made up by runs of published cases, and predictions of tests that were measured.

#[path = "../../../archard-case/tests/framed/mod.rs"]
mod framed;

mod found;
mod goes_on;
mod made;
mod refused;
mod surfaces;
mod together;
mod validated;
mod wheel;
