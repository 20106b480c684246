//! Machine parts that touch along a line which passes over both: spur gears and cams, how they slide on each other and wear.
//!
//! Each place of a body is passed by the whole width of the contact, so that the depth it loses follows from the load of the line and from
//! the speeds at which the line moves over the bodies, whatever the shape of the pressure (A. Flodin & S. Andersson, *Wear* 207 (1997) 16).
//!
//! Of gears, places on the flanks are those of the path of contact: the distance from T1, where the line of action touches the base circle
//! of gear 1. Of [cams](cam), they are the angle of the cam and the place on its follower; where the contact turns round on the follower,
//! its pressure is swept along its path.

pub mod cam;
mod flanks;
mod involute;
mod laws;
mod line;
mod march;
mod mesh;
mod sharing;
mod station;

pub use flanks::WornFlanks;
pub use involute::{Gear, Pair};
pub use laws::{Laws, Misfit};
pub use march::{Limit, Moment};
pub use mesh::Mesh;
pub use sharing::Sharing;
pub use station::Station;
