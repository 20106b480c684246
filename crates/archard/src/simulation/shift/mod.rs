//! Bodies that are shifted against each other: pressures and friction of an increment, and what it rubs.

mod rubbing;
mod shifted;
mod solve;
mod unlike;

pub(super) use solve::WarmStart;
