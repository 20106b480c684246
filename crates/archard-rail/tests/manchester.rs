//! Held against the field's reference program on the Manchester benchmark, if `ARCHARD_WHEEL_RAIL` names the folder with
//! its profiles and results.

use std::path::PathBuf;
use archard_rail::{Profile, setup::*, search::*, curve::*, creepage::*};

fn points(p: &PathBuf, mirror: f64, rev: bool) -> Profile {
    let text = std::fs::read_to_string(p).unwrap();
    let mut on = false;
    let mut pts = vec![];
    for l in text.lines() {
        let l = l.trim();
        if l == "point.begin" { on = true; continue }
        if l == "point.end" { break }
        if !on || l.starts_with('!') { continue }
        let v: Vec<f64> = l.split_whitespace().map(|x| x.parse().unwrap()).collect();
        pts.push([v[0] * mirror * 1e-3, v[1] * 1e-3]);
    }
    if rev { pts.reverse() }
    Profile::new(pts).unwrap()
}

#[test]
fn rows() {
    let Some(dir) = std::env::var_os("ARCHARD_WHEEL_RAIL").map(PathBuf::from) else { return };
    let rail = points(&dir.join("MBench_UIC60_v3.prr"), 1.0, false).curve(Smoothing::NONE).unwrap();
    let wheel = points(&dir.join("MBench_S1002_v3.prw"), -1.0, true).curve(Smoothing::NONE).unwrap();
    let track = Track { gauge: 1.435, gauge_height: 14e-3, cant: 0.0 };
    let ws = Wheelset { flange_back_distance: 1.36, flange_back_position: -0.07, nominal_radius: 0.46 };
    let setup = Setup::new(track, &rail, ws, &wheel).unwrap();
    println!("rail first {:?} last {:?}; wheel first {:?} last {:?}", setup.rail().point(0.0), setup.rail().point(setup.rail().length()), wheel.point(0.0), wheel.point(wheel.length()));
    let csv = std::fs::read_to_string(dir.join("manchester_right.csv")).unwrap();
    let head: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    for line in csv.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let get = |n: &str| cells[head.iter().position(|h| *h == n).unwrap()].parse::<f64>().unwrap();
        let att = Attitude { shift: get("Y_WS") * 1e-3, roll: get("ROLL_WS"), yaw: get("YAW_WS") };
        let vel = Velocity { forward: 2.0, pitch: get("VPITCH_WS"), ..Default::default() };
        let search = Search::new(&setup, att).unwrap();
        let onset = search.onset().unwrap();
        let t = std::time::Instant::now();
        let patches = search.patches(get("Z_WS") * 1e-3, &Joining::default()).unwrap();
        println!("y {} onset err {:.5} mm; patches {} ({:?})", get("Y_WS"), onset.height * 1e3 - get("Z_ONSET"), patches.len(), t.elapsed());
        for p in &patches {
            let r = p.reference * 1e3;
            let gap = search.gap(p).column(0.0, &[0.0])[0];
            let c = search.gap(p);
            let ss: Vec<f64> = (0..=400).map(|i| p.extent[0] + (p.extent[1]-p.extent[0]) * i as f64 / 400.0).collect();
            let deep = c.column(0.0, &ss).into_iter().fold(0.0, f64::min);
            println!("   dx {:.4} dy {:.4} dz {:.4} dangle {:.4} ({:.4}) extent {:?} depth {:.5} gap {:.5} deep {:.5} approach {}", r.x - get("XCP(TR)"), r.y - get("YCP(TR)"), r.z - get("ZCP(TR)"), p.angle - get("DELTCP(TR)"), p.angle, p.extent, p.depth*1e3*p.angle.cos(), gap*1e3, deep*1e3, get("APPROACH"));
            for a in [get("APPROACH")*1e-3, -gap, p.depth*p.angle.cos()] {
            let k = Creepage::new(&search, p, &vel, a);
            println!("   xi {:.4e} / {:.4e}  eta {:.4e} / {:.4e} phi {:.4e} / {:.4e} V {:.5}/{}", k.longitudinal, get("CKSI"), k.lateral, get("CETA"), k.spin*1e-3, get("CPHI"), k.speed, get("VELOC"));
            }
        }
    }
}
