//! A case of a cam and its follower.

use super::super::cam::{CAM, CAMS, CamCase, CamShape, FOLLOWERS};
use super::super::problem::Problem;
use super::super::reader::{Reader, Section};
use super::super::tree::{Entry, Item};
use super::gear::TABLES;
use archard_gear::cam::Follower;

impl Reader<'_> {
    /// Whether a case is about a cam.
    pub fn is_cam(root: &Section<'_>) -> bool {
        let Some((_, motion)) = root.get("motion") else { return false };
        matches!(&motion.node.item, Item::Table(motion) if motion.get("cam").is_some())
    }

    /// The case, if nothing is wrong with it.
    pub fn cam(&mut self, root: &Section<'_>) -> Option<CamCase> {
        self.unknown(root, "key", TABLES);
        let title = self.title(root);
        let bodies = self.table(root, "body", "a cam and its follower, `[body.NAME]` each")?;
        let turns = |entry: &&Entry| match &entry.node.item {
            Item::Table(body) => match body.get("profile").map(|profile| &profile.node.item) {
                Some(Item::Table(profile)) => {
                    CAMS.iter().any(|cam| profile.get(cam.name).is_some())
                }
                _ => false,
            },
            _ => false,
        };
        let (cams, others): (Vec<&Entry>, Vec<&Entry>) =
            bodies.table.0.iter().partition(|entry| turns(entry));
        let ([cam], [follower]) = (&cams[..], &others[..]) else {
            let message = format!(
                "one cam, with `profile.cam` or `profile.eccentric`, turns on one follower; here are {} and {}",
                cams.len(),
                others.len()
            );
            self.push(Problem::error(bodies.key.clone(), message));
            return None;
        };
        let until = self.worn_depths(root, [&cam.name, &follower.name]);
        let cam = self.rolling_body::<CamShape>(&bodies, cam, CAMS);
        let follower = self.rolling_body::<Follower>(&bodies, follower, FOLLOWERS);
        let motion = self.table(root, "motion", "how the cam runs")?;
        let motion = self.choice(&motion, "motion", CAM).map(|(chosen, _)| chosen);
        let friction = self.friction(root);
        Some(CamCase {
            title: title?,
            cam: cam?,
            follower: follower?,
            friction: friction?,
            motion: motion?,
            until: until?,
        })
    }
}
