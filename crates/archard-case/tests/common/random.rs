//! Numbers that are random and yet the same on every machine, and a watch over what is tried with them.

#![allow(dead_code, reason = "every test binary uses a part of it")]

use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// A source of random numbers: SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, OOPSLA 2014, 453).
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// The source of that seed.
    pub fn new(seed: u64) -> Self {
        let mut random = Self(seed);
        random.bits();
        random
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number from 0 to 1.
    pub fn share(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number between two.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.share()
    }

    /// A positive number between two, every decade as likely.
    pub fn decade(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// A number below a count.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count.max(1) as u64) as usize
    }

    /// One of some.
    pub fn one<'a, T: ?Sized>(&mut self, of: &[&'a T]) -> &'a T {
        of[self.below(of.len())]
    }

    /// Whether something of that chance happens.
    pub fn chance(&mut self, share: f64) -> bool {
        self.share() < share
    }
}

/// Does something that may take so long at most. A hang ends the tests, with the name of what hangs: a thread cannot be
/// stopped.
pub fn within<T>(longest: Duration, name: &str, done: impl FnOnce() -> T) -> T {
    let (ended, watched) = channel::<()>();
    let name = name.to_owned();
    let watch = std::thread::spawn(move || {
        if watched.recv_timeout(longest) == Err(RecvTimeoutError::Timeout) {
            eprintln!("{name} has not ended within {longest:?}");
            std::process::exit(101);
        }
    });
    let result = done();
    drop(ended);
    let _ = watch.join();
    result
}

/// How often to try: as the environment says, or so often.
pub fn runs(variable: &str, otherwise: u64) -> std::ops::Range<u64> {
    let number = |name: &str| std::env::var(name).ok()?.parse::<u64>().ok();
    match number("ARCHARD_SEED") {
        Some(seed) => seed..seed + 1,
        None => 0..number(variable).unwrap_or(otherwise),
    }
}
