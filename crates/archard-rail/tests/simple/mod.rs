//! Wheels and rails of simple shapes, of steel.

// Each test takes what it needs of them.
#![allow(dead_code)]

use std::sync::Arc;

use archard::Material;
use archard::friction::Coulomb;
use archard_rail::Profile;
use archard_rail::contact::{Bodies, Operation};
use archard_rail::curve::{Curve, Smoothing};
use archard_rail::setup::{Attitude, Setup, Track, Velocity, Wheelset};

/// Radii (m) of the wheel and of the head of the rail, and where the rail stands (m).
pub const WHEEL: f64 = 0.46;
pub const HEAD: f64 = 0.3;
pub const ARM: f64 = 0.75;

pub fn curve(points: impl Iterator<Item = [f64; 2]>) -> Curve {
    Profile::new(points.collect()).unwrap().curve(Smoothing::NONE).unwrap()
}

pub fn wheelset() -> Wheelset {
    Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: WHEEL }
}

/// A straight wheel of that slope that is so wide to both sides of its middle (m), on an arc of 0.2 rad to both sides.
pub fn cone(slope: f64, half: f64) -> Setup {
    let angles = (-400..=400).map(|at| f64::from(at) * 5e-4);
    let head = curve(angles.map(|angle| [HEAD * angle.sin(), HEAD - HEAD * angle.cos()]));
    let places = (-60..=60).rev().map(|at| f64::from(at) / 60.0 * half);
    let wheel = curve(places.map(|y| [y, -slope * y]));
    let gauge = 2.0 * (ARM - HEAD * 0.2f64.sin());
    let track = Track { gauge, gauge_height: 1.0, cant: 0.0 };
    Setup::new(track, &head, wheelset(), &wheel).unwrap()
}

pub fn steel() -> Material {
    Material::new(210e9, 0.3).unwrap()
}

/// Of steel with a coefficient of friction.
pub fn bodies(coefficient: f64) -> Bodies {
    Bodies {
        wheel: steel(),
        rail: steel(),
        thermal: [None, None],
        friction: Arc::new(Coulomb::new(coefficient).unwrap()),
        flange: None,
        wear: [None, None],
        flange_wear: None,
        shear_yield: 800e6,
    }
}

/// A wheelset of some speed (m/s), driven by a share of it, that carries a load (N) on the wheel.
pub fn operation(attitude: Attitude, (speed, driven): (f64, f64), load: f64) -> Operation {
    let pitch = -speed * (1.0 + driven) / WHEEL;
    Operation {
        attitude,
        velocity: Velocity { forward: speed, pitch, ..Velocity::default() },
        load,
        transfer: 0.0,
        creepages: Default::default(),
    }
}
