//! Spur gears: where teeth touch, how they share the load, how their flanks slide on each other and wear.
//!
//! Teeth touch along a line that moves over both flanks. Each place of a flank is passed by the whole width of the contact once a mesh,
//! so that the depth it loses follows from the load of the line and from the speeds at which the line moves over the flanks, whatever the
//! worn shape (A. Flodin & S. Andersson, *Wear* 207 (1997) 16). Places on the flanks are those of the path of contact: the distance
//! from T1, where the line of action touches the base circle of gear 1.

mod involute;
mod march;
mod mesh;
mod sharing;
mod station;

pub use involute::{Gear, Pair};
pub use march::{Limit, Moment, Worn};
pub use mesh::{GearError, Laws, Mesh};
pub use sharing::Sharing;
pub use station::Station;
