//! What the semismooth Newton methods of [friction under known pressures](super::tangential) and of [pressures and
//! friction at once](super::monolithic) have in common.
//!
//! Both project augmented tractions on discs (P. Alart and A. Curnier, *Comput. Methods Appl. Mech. Engrg.* 92 (1991)
//! 353). An iterate says what the pairs do ([`StickSlip`]); the linear system of a step, with a border of given forces
//! ([`Schur`]), is solved to a tolerance that follows from what the last steps brought ([`Forcing`]); the step is
//! [shortened](shorten) until it lowers the residual. Nothing here knows how many directions are unknown or how the bodies
//! deform.

mod forcing;
mod line_search;
mod schur;
mod stick_slip;

pub(super) use forcing::Forcing;
pub(super) use line_search::shorten;
pub(super) use schur::Schur;
pub(super) use stick_slip::StickSlip;
