//! Files that are damaged at random, and what is done with them: no panic, no hang, no memory without bound.

#![allow(dead_code, reason = "every test binary uses a part of it")]

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use super::random::{Random, within};

/// What reading and checking any file may take.
const LONG: Duration = Duration::from_secs(10);
/// What all that is read may take of memory at once (bytes).
const LARGE: usize = 2 << 30;
/// Words that stand for numbers which nothing good comes of.
const WORDS: [&str; 22] = [
    "0",
    "-0",
    "-1",
    "1",
    "2",
    "255",
    "65536",
    "2147483648",
    "4294967296",
    "18446744073709551615",
    "9223372036854775808",
    "1e-320",
    "1e-15",
    "1e15",
    "1e300",
    "1e999",
    "nan",
    "inf",
    "-inf",
    "0.5",
    "x",
    "",
];

/// The bytes with some damage: bits and numbers changed, parts left out, twice there or taken from other files.
pub fn damaged(whole: &[u8], others: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    let mut bytes = whole.to_vec();
    for _ in 0..1 + random.below(4) {
        damage(&mut bytes, others, random);
    }
    bytes
}

fn damage(bytes: &mut Vec<u8>, others: &[Vec<u8>], random: &mut Random) {
    let at = random.below(bytes.len() + 1);
    let length = random.decade(1.0, 200.0) as usize;
    let end = (at + length).min(bytes.len());
    match random.below(10) {
        0 if at < bytes.len() => bytes[at] ^= 1 << random.below(8),
        1 if at < bytes.len() => bytes[at] = random.bits() as u8,
        2 => drop(bytes.drain(at..end)),
        3 => {
            let part = bytes[at..end].to_vec();
            let place = random.below(bytes.len() + 1);
            bytes.splice(place..place, part);
        }
        4 => bytes.truncate(at),
        5 if !others.is_empty() => {
            let other = &others[random.below(others.len())];
            let from = random.below(other.len() + 1);
            let part = other[from..(from + length).min(other.len())].to_vec();
            bytes.splice(at..end, part);
        }
        6 => {
            // A line somewhere else.
            let mut lines: Vec<&[u8]> = bytes.split_inclusive(|&byte| byte == b'\n').collect();
            if !lines.is_empty() {
                let line = lines.remove(random.below(lines.len()));
                lines.insert(random.below(lines.len() + 1), line);
                *bytes = lines.concat();
            }
        }
        _ => {
            let words = numbers(bytes);
            if !words.is_empty() {
                let word = words[random.below(words.len())].clone();
                let new = WORDS[random.below(WORDS.len())].bytes();
                bytes.splice(word, new);
            }
        }
    }
    if bytes.is_empty() {
        bytes.push(b'\n');
    }
}

/// Where numbers stand in a text.
fn numbers(bytes: &[u8]) -> Vec<std::ops::Range<usize>> {
    let part = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+' | b'e');
    let (mut found, mut at) = (vec![], 0);
    while at < bytes.len() {
        let length = bytes[at..].iter().take_while(|&&byte| part(byte)).count();
        if bytes[at..at + length].iter().any(u8::is_ascii_digit) {
            found.push(at..at + length);
        }
        at += length.max(1);
    }
    found
}

/// Tries something with so many seeds, or for as many seconds as the environment says where it is done at length; names
/// the seeds with which it panics.
pub fn attempt(name: &str, quick: u64, long: bool, mut tried: impl FnMut(&mut Random)) {
    let number = |name: &str| std::env::var(name).ok()?.parse::<u64>().ok();
    let seconds = number("ARCHARD_SOAK_SECONDS").unwrap_or(600);
    let start = Instant::now();
    let only = number("ARCHARD_SEED");
    let (mut seed, mut panicked) = (only.unwrap_or(0), vec![]);
    loop {
        let seeded = format!("{name}, seed {seed}");
        let mut random = Random::new(seed);
        let result =
            within(LONG, &seeded, || catch_unwind(AssertUnwindSafe(|| tried(&mut random))));
        if result.is_err() {
            panicked.push(seed);
        }
        seed += 1;
        let done = if long { start.elapsed().as_secs() >= seconds } else { seed >= quick };
        if done || only.is_some() {
            break;
        }
    }
    let most = peak_memory();
    eprintln!("{name}: {seed} tried in {:.0?}, {} MB at most", start.elapsed(), most >> 20);
    assert!(panicked.is_empty(), "{name} panics with ARCHARD_SEED={panicked:?}");
    assert!(most < LARGE, "{name} took {most} bytes");
}

/// Most memory (bytes) that this process has held, where the system says.
fn peak_memory() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    let word = line.and_then(|line| line.split_whitespace().next());
    word.and_then(|word| word.parse::<usize>().ok()).map_or(0, |kilobytes| kilobytes << 10)
}
