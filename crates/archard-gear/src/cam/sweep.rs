//! The contact swept over a cam and its follower.

use std::f64::consts::{PI, TAU};

use archard::numerics::quadrature::gauss_legendre;

use super::{Cam, Station, angles};

/// Of the half-width: turning points nearer than that are one. A choice; what the contact does between them is no motion.
const SAME: f64 = 1e-3;

/// What a place goes through in a turn.
#[derive(Debug, Clone, Default)]
pub(super) struct Passage {
    /// Pressure (Pa) and slip (m), part by part.
    pub parts: Vec<[f64; 2]>,
    /// The angles (rad) between which it is in contact.
    pub during: Vec<[f64; 2]>,
}

impl Passage {
    /// The integral (Pa m) of the pressure over the slip.
    pub fn work(&self) -> f64 {
        self.parts.iter().map(|[pressure, slip]| pressure * slip).sum()
    }

    /// The mean pressure (Pa) over the slip, and the slip (m).
    pub fn whole(&self) -> [f64; 2] {
        let slip: f64 = self.parts.iter().map(|[_, slip]| slip).sum();
        [if slip > 0.0 { self.work() / slip } else { 0.0 }, slip]
    }
}

/// A turn of a cam.
pub(super) struct Sweep<'a> {
    cam: &'a Cam,
    /// From zero to a turn; where the contact turns round on the follower is among them.
    pub stations: Vec<Station>,
    /// Whether the contact turns round there.
    turning: Vec<bool>,
    /// How far (m) the cam has slid on the follower until then.
    slid: Vec<f64>,
    /// The points of a passage and their weights.
    rule: Vec<(f64, f64)>,
}

impl<'a> Sweep<'a> {
    /// So many angles, and so many points of a passage.
    pub fn new(cam: &'a Cam, [count, points]: [usize; 2]) -> Self {
        let mut stations: Vec<(Station, bool)> = vec![];
        let mut turned = f64::NAN;
        for angle in angles(count).chain([TAU]) {
            let mut next = (cam.station(angle), false);
            if let Some(last) = stations.last_mut()
                && forward(&last.0) != forward(&next.0)
            {
                let between = turning(cam, &last.0, &next.0);
                let apart = (between.touch.place - turned).abs();
                // It may be at one of the angles itself.
                if apart <= SAME * between.half_width {
                } else if between.angle <= last.0.angle {
                    last.1 = true;
                } else if between.angle >= next.0.angle {
                    next.1 = true;
                } else {
                    stations.push((between, true));
                }
                turned = between.touch.place;
            }
            stations.push(next);
        }
        let (stations, turning): (Vec<_>, Vec<_>) = stations.into_iter().unzip();
        let mut slid = vec![0.0];
        for (at, pair) in stations.windows(2).enumerate() {
            slid.push(slid[at] + slides(cam, pair[0].angle, pair[1].angle));
        }
        Self { cam, stations, turning, slid, rule: gauss_legendre(points) }
    }

    /// The way (m) around the cam: what it slides in a turn, since the contact comes back on the follower.
    pub fn perimeter(&self) -> f64 {
        self.slid[self.slid.len() - 1]
    }

    /// The place (m) of the contact along a body: the arc of the cam, or the face of the follower.
    pub fn place(&self, body: usize, station: &Station) -> f64 {
        if body == 1 {
            return station.touch.place;
        }
        let after = self.stations.partition_point(|known| known.angle <= station.angle);
        let known = after.saturating_sub(1);
        let slid = self.slid[known] + slides(self.cam, self.stations[known].angle, station.angle);
        slid + station.touch.place - self.stations[0].touch.place
    }

    /// The places (m) of the stations.
    pub fn places(&self, body: usize) -> Vec<f64> {
        let start = self.stations[0].touch.place;
        let of = |(station, slid): (&Station, &f64)| match body {
            0 => slid + station.touch.place - start,
            _ => station.touch.place,
        };
        self.stations.iter().zip(&self.slid).map(of).collect()
    }

    /// Stations where the contact turns round on the follower, or rests on it: it moves by less than half of its half-width to the next.
    pub fn slow(&self) -> impl Iterator<Item = &Station> {
        let rests = |at: usize| {
            let [here, next] = [at, at + 1].map(|at| self.stations.get(at));
            here.zip(next).is_some_and(|(here, next)| {
                (next.touch.place - here.touch.place).abs() < 0.5 * here.half_width
            })
        };
        let slow = move |at: &usize| self.turning[*at] || rests(*at);
        (0..self.stations.len()).filter(slow).map(|at| &self.stations[at])
    }

    /// What a place (m) of a body goes through.
    pub fn passage(&self, body: usize, places: &[f64], place: f64) -> Passage {
        let mut passage = Passage::default();
        let around = if body == 0 { self.perimeter() } else { f64::INFINITY };
        // How far off the middle of the contact a place lies, around the cam the shorter way.
        let off = |at: f64| {
            let off = place - at;
            if around.is_finite() { off - around * (off / around).round() } else { off }
        };
        let (mut begun, mut until): (Option<f64>, f64) = (None, 0.0);
        let mut close = |begun: &mut Option<f64>, until: f64| {
            if let Some(from) = begun.take()
                && until > from
            {
                self.passes(body, &off, [from, until], &mut passage);
            }
        };
        for (at, pair) in self.stations.windows(2).enumerate() {
            let offs = [at, at + 1].map(|at| off(places[at]));
            let [here, next] = [0, 1].map(|end| offs[end] / pair[end].half_width);
            let apart = offs.iter().all(|off| off.abs() > 0.25 * around);
            if here.abs().min(next.abs()) >= 1.0 && here * next > 0.0 || apart {
                close(&mut begun, until);
                continue;
            }
            let edge = |inside: f64| self.edge(body, &off, inside, [pair[0].angle, pair[1].angle]);
            let enters = here.abs() >= 1.0;
            if enters || self.turning[at] {
                close(&mut begun, until);
            }
            let start = if enters { edge(here.signum()) } else { pair[0].angle };
            begun.get_or_insert(start);
            let leaves = next.abs() >= 1.0;
            until = if leaves { edge(next.signum()) } else { pair[1].angle };
            if leaves {
                close(&mut begun, until);
            }
        }
        close(&mut begun, until);
        passage
    }

    /// The angle (rad) between two at which a place lies at an edge of the contact, on that side.
    fn edge(
        &self,
        body: usize,
        off: &dyn Fn(f64) -> f64,
        side: f64,
        [mut from, mut to]: [f64; 2],
    ) -> f64 {
        let beyond = |angle: f64| {
            let station = self.cam.station(angle);
            side * off(self.place(body, &station)) - station.half_width
        };
        let first = beyond(from) >= 0.0;
        loop {
            let middle = 0.5 * (from + to);
            if middle <= from || middle >= to {
                return middle;
            }
            if (beyond(middle) >= 0.0) == first { from = middle } else { to = middle }
        }
    }

    /// Adds what a place goes through between two angles (rad), by Gauss's rule over an angle whose sine goes from one to the other:
    /// pressures end with a root there, or do not, and sums converge fast.
    fn passes(
        &self,
        body: usize,
        off: &dyn Fn(f64) -> f64,
        [from, to]: [f64; 2],
        passage: &mut Passage,
    ) {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        for &(at, weight) in &self.rule {
            let (sine, cosine) = (0.5 * PI * at).sin_cos();
            let station = self.cam.station(middle + half * sine);
            let off = off(self.place(body, &station)) / station.half_width;
            let pressure = station.peak_pressure * (1.0 - off * off).max(0.0).sqrt();
            passage
                .parts
                .push([pressure, station.touch.sliding * half * cosine * 0.5 * PI * weight]);
        }
        passage.during.push([from, to]);
    }
}

/// How far (m) the cam slides between two angles (rad), by Gauss's rule of three points.
fn slides(cam: &Cam, from: f64, to: f64) -> f64 {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let sliding =
        |at: f64| super::Touch::new(&cam.profile, cam.follower, middle + half * at).sliding;
    let outer = 0.6f64.sqrt();
    half * (8.0 * sliding(0.0) + 5.0 * (sliding(-outer) + sliding(outer))) / 9.0
}

/// Whether the contact moves forward on the follower.
fn forward(station: &Station) -> bool {
    station.touch.speeds[1] > 0.0
}

/// Where the contact turns round between two stations.
fn turning(cam: &Cam, before: &Station, after: &Station) -> Station {
    let (mut from, mut to) = (before.angle, after.angle);
    loop {
        let middle = cam.station(0.5 * (from + to));
        if middle.angle <= from || middle.angle >= to {
            return middle;
        }
        if forward(&middle) == forward(before) { from = middle.angle } else { to = middle.angle }
    }
}
