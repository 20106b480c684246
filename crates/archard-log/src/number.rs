//! What stands in a cell: a number with a decimal point or comma, or a time of day; and how numbers are printed.

/// Seconds of a day.
pub const DAY: f64 = 86_400.0;

/// A number with that decimal sign; the other sign separates thousands. `3600,` is a number without decimals.
pub fn number(cell: &str, decimal: char) -> Option<f64> {
    let cell = cell.trim().replace('\u{2212}', "-");
    if !cell.ends_with(|last: char| last.is_ascii_digit() || last == decimal)
        || !cell.contains(|letter: char| letter.is_ascii_digit())
    {
        return None;
    }
    let grouping = if decimal == ',' { '.' } else { ',' };
    let (whole, rest) = cell.split_once(decimal).unwrap_or((&cell, ""));
    if rest.contains(grouping) || !is_grouped(whole, grouping) {
        return None;
    }
    let whole: String = whole.chars().filter(|letter| *letter != grouping).collect();
    let value: f64 =
        if rest.is_empty() { whole } else { format!("{whole}.{rest}") }.parse().ok()?;
    value.is_finite().then_some(value)
}

/// Whether each separator of thousands has three digits behind it.
fn is_grouped(whole: &str, grouping: char) -> bool {
    let mut groups = whole.split(grouping);
    let first = groups.next().unwrap_or_default().trim_start_matches(['+', '-']);
    let mut others = groups.peekable();
    others.peek().is_none()
        || ((1..=3).contains(&first.len())
            && others.all(|group| group.len() == 3 && group.bytes().all(|b| b.is_ascii_digit())))
}

/// The decimal sign of most numbers with one; a point where there are as many.
pub fn decimal<'a>(cells: impl Iterator<Item = &'a str>) -> char {
    let (mut points, mut commas) = (0usize, 0usize);
    for cell in cells {
        match cell.rfind(['.', ',']) {
            Some(at) if cell.as_bytes()[at] == b',' => {
                commas += usize::from(number(cell, ',').is_some());
            }
            Some(_) => points += usize::from(number(cell, '.').is_some()),
            None => {}
        }
    }
    if commas > points { ',' } else { '.' }
}

/// Seconds of `14:08:16`, `2:08:16.5 PM` or `2019-04-11 14:08:16`, and whether a date stands before it: from midnight without one, from
/// the first of January of the year 1 with one.
pub fn clock(cell: &str) -> Option<(f64, bool)> {
    if !cell.contains(':') {
        return None;
    }
    let cell = cell.trim().trim_end_matches('Z');
    let upper = cell.to_ascii_uppercase();
    let (cell, noon) = match (upper.strip_suffix("PM"), upper.strip_suffix("AM")) {
        (Some(rest), _) => (rest.trim().to_owned(), Some(12.0)),
        (_, Some(rest)) => (rest.trim().to_owned(), Some(0.0)),
        _ => (upper, None),
    };
    let (date, time) = match cell.rsplit_once([' ', 'T']) {
        Some((date, time)) => (Some(days(date)?), time),
        None => (None, &*cell),
    };
    let parts: Vec<&str> = time.split(':').collect();
    let [hours, minutes, seconds] = parts[..] else { return None };
    let (hours, minutes): (u32, u32) = (hours.parse().ok()?, minutes.parse().ok()?);
    let seconds: f64 = seconds.replace(',', ".").parse().ok()?;
    if minutes > 59 || !(0.0..61.0).contains(&seconds) || (date.is_some() && hours > 24) {
        return None;
    }
    let hours = noon.map_or(f64::from(hours), |noon| f64::from(hours % 12) + noon);
    let of_day = hours * 3600.0 + f64::from(minutes) * 60.0 + seconds;
    Some((date.unwrap_or(0.0) * DAY + of_day, date.is_some()))
}

/// Days of a date, of the proleptic Gregorian calendar: `2019-04-11`, `11.04.2019` or `04/11/2019`.
fn days(date: &str) -> Option<f64> {
    let parts: Vec<&str> = date.split(['-', '.', '/']).collect();
    let [first, second, third] = parts[..] else { return None };
    let [first, second, third]: [i64; 3] =
        [first.parse().ok()?, second.parse().ok()?, third.parse().ok()?];
    let (year, month, day) = match (first > 31, date.contains('/')) {
        (true, _) => (first, second, third),
        (false, true) => (third, first, second),
        (false, false) => (third, second, first),
    };
    if !(1..=12).contains(&month) || !(1..=31).contains(&day) || !(0..=9999).contains(&year) {
        return None;
    }
    // Years begin in March, so that the day of a leap year stands at the end.
    let (year, month) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    Some((365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + day) as f64)
}

/// A number with four significant digits.
pub fn four(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e5).contains(&size) => {
            let digits = (3 - size.log10().floor() as i32).max(0) as usize;
            format!("{value:.digits$}")
        }
        _ => format!("{value:.3e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::{DAY, clock, decimal, number};

    #[test]
    fn numbers_have_a_point_or_a_comma() {
        for (cell, sign, value) in [
            ("0,100", ',', Some(0.1)),
            ("3600,", ',', Some(3600.0)),
            ("1.234,5", ',', Some(1234.5)),
            ("1,234.5", '.', Some(1234.5)),
            ("-1e-3", '.', Some(-1e-3)),
            ("1,2,3", ',', None),
            ("1.23", ',', None),
            ("12a", '.', None),
            ("", '.', None),
            ("nan", '.', None),
        ] {
            assert_eq!(number(cell, sign), value, "{cell}");
        }
        assert_eq!(decimal(["1,5", "2", "3,"].into_iter()), ',');
        assert_eq!(decimal(["1,234.5", "2"].into_iter()), '.');
    }

    #[test]
    fn times_of_day_are_seconds() {
        assert_eq!(clock("14:08:16"), Some((50_896.0, false)));
        assert_eq!(clock("2:08:16,5 pm"), Some((50_896.5, false)));
        let [one, next] = ["2020-02-28 23:59:59", "01.03.2020 00:00:00"].map(clock);
        let passed = next.map(|at| at.0).zip(one.map(|at| at.0)).map(|(next, one)| next - one);
        assert_eq!(passed, Some(DAY + 1.0), "2020 has a 29th of February");
        assert_eq!(clock("14:08"), None);
    }
}
