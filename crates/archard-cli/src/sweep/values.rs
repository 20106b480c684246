//! What a study puts at a key: a list of values, a range of them, or a distribution to draw them from.

use statrs::distribution::{ContinuousCDF, Normal};

/// A distribution of a value, in the unit that it is given in.
#[derive(Debug, Clone, PartialEq)]
pub struct Distribution {
    kind: Kind,
    unit: String,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// Mean and standard deviation.
    Normal(f64, f64),
    /// Median, and standard deviation of the natural logarithm.
    LogNormal(f64, f64),
    /// From the one to the other.
    Uniform(f64, f64),
    /// Median, scale of the natural logarithm and degrees of freedom: what the next test is like, seen from a few.
    LogStudent(f64, f64, f64),
}

/// A number and its unit, which may be empty.
pub type Number<'a> = (f64, &'a str);

/// Most rows of a study.
const MOST_ROWS: usize = 100_000;

/// Whether that many rows can be run.
///
/// # Errors
/// In words, if there are more.
pub fn few(rows: usize) -> Result<(), String> {
    if rows <= MOST_ROWS {
        return Ok(());
    }
    let rows = if rows == usize::MAX {
        "more rows than can be counted".into()
    } else {
        format!("{rows} rows")
    };
    Err(format!("a study of {rows}; {MOST_ROWS} at most can be run"))
}

/// The values, each as a case takes it, of `a,b,c`, of `a;b;c` or of a range `first:last:number`.
///
/// # Errors
/// In words, if the text is neither, or a range of fewer than two values, or of more than a study has rows.
pub fn list(text: &str) -> Result<Vec<String>, String> {
    let parts = split(text, ':');
    match parts[..] {
        [first, last, count] => range(first, last, count),
        [_] => {
            let apart = split(text, ';');
            let apart = if apart.len() > 1 { apart } else { split(text, ',') };
            let values: Vec<String> = apart.into_iter().map(str::to_owned).collect();
            match values.iter().any(String::is_empty) {
                true => Err(format!("`{text}`: a value is missing")),
                false => Ok(values),
            }
        }
        _ => Err(format!("`{text}`: write a range like 5 N:20 N:4, from, to and how many values")),
    }
}

/// Values at equal distances, both ends among them.
fn range(first: &str, last: &str, count: &str) -> Result<Vec<String>, String> {
    let ((from, unit), (to, other)) = (number(first)?, number(last)?);
    if unit != other {
        return Err(format!("`{first}` and `{last}`: write both ends of a range in one unit"));
    }
    let count: usize = count
        .parse()
        .map_err(|_| format!("`{count}` is not a number of values, like the 4 of 5 N:20 N:4"))?;
    few(count)?;
    if count < 2 {
        return Err(format!("{count}: a range has two values at least, {first} and {last}"));
    }
    if from == to {
        return Err(format!("a range from {first} to {last} has one value: write {first} alone"));
    }
    let step = (to - from) / (count - 1) as f64;
    Ok((0..count).map(|i| written(from + i as f64 * step, unit)).collect())
}

/// The distribution of `normal(mean, deviation)`, `lognormal(median, deviation of the logarithm)` or `uniform(from, to)`.
///
/// # Errors
/// In words, if the text is not one of these or its values do not make one.
pub fn distribution(text: &str) -> Result<Distribution, String> {
    let known = "normal(10 N, 1 N), lognormal(10 N, 0.2) or uniform(5 N, 20 N)";
    let malformed = || format!("`{text}`: write a distribution like {known}");
    let (name, inside) = text.trim().split_once('(').ok_or_else(malformed)?;
    let inside = inside.strip_suffix(')').ok_or_else(malformed)?;
    let parts = split(inside, ',');
    if let ("logstudent", [one, other, degrees]) = (name.trim(), &parts[..]) {
        return log_student(text, [one, other, degrees]);
    }
    let [one, other] = parts[..] else { return Err(malformed()) };
    let ((first, unit), (second, second_unit)) = (number(one)?, number(other)?);
    let kind = match name.trim() {
        "normal" => Kind::Normal(first, second),
        "lognormal" => Kind::LogNormal(first, second),
        "uniform" => Kind::Uniform(first, second),
        _ => return Err(malformed()),
    };
    let wrong = match kind {
        Kind::LogNormal(..) if !second_unit.is_empty() => {
            Some("the deviation of a logarithm has no unit")
        }
        Kind::Normal(..) | Kind::Uniform(..) if unit != second_unit => {
            Some("write both values in one unit")
        }
        Kind::Normal(_, deviation) | Kind::LogNormal(_, deviation) if deviation <= 0.0 => {
            Some("a deviation is greater than zero")
        }
        Kind::LogNormal(median, _) if median <= 0.0 => Some("a median is greater than zero"),
        Kind::Uniform(from, to) if from >= to => Some("an empty range"),
        _ => None,
    };
    match wrong {
        Some(why) => Err(format!("`{text}`: {why}")),
        None => Ok(Distribution { kind, unit: unit.to_owned() }),
    }
}

/// The distribution of `logstudent(median, scale of the logarithm, degrees of freedom)`.
fn log_student(text: &str, [one, other, degrees]: [&str; 3]) -> Result<Distribution, String> {
    let ((median, unit), (scale, none), (degrees, also)) =
        (number(one)?, number(other)?, number(degrees)?);
    if !none.is_empty() || !also.is_empty() {
        return Err(format!("`{text}`: scale and degrees of freedom have no unit"));
    }
    if median <= 0.0 || scale <= 0.0 || degrees < 1.0 {
        return Err(format!(
            "`{text}`: median and scale are greater than zero, degrees of freedom one at least"
        ));
    }
    Ok(Distribution { kind: Kind::LogStudent(median, scale, degrees), unit: unit.to_owned() })
}

impl Distribution {
    /// The value, as a case takes it, below which that share of all is, between zero and one.
    pub fn quantile(&self, share: f64) -> String {
        let deviate = Normal::standard().inverse_cdf(share);
        let value = match self.kind {
            Kind::Normal(mean, deviation) => mean + deviation * deviate,
            Kind::LogNormal(median, deviation) => median * (deviation * deviate).exp(),
            Kind::Uniform(from, to) => from + share * (to - from),
            Kind::LogStudent(median, scale, degrees) => {
                archard_lab::next_test([median, scale, degrees], share)
            }
        };
        written(value, &self.unit)
    }
}

/// The parts of a text between those of its marks that stand in no brackets and no quotes.
fn split(text: &str, mark: char) -> Vec<&str> {
    let (mut depth, mut quote, mut start, mut parts) = (0_i32, None, 0, vec![]);
    for (place, letter) in text.char_indices() {
        match (quote, letter) {
            (Some(open), _) => quote = Some(open).filter(|open| *open != letter),
            (None, '"' | '\'') => quote = Some(letter),
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')' | ']' | '}') => depth -= 1,
            (None, _) if letter == mark && depth == 0 => {
                parts.push(text[start..place].trim());
                start = place + mark.len_utf8();
            }
            (None, _) => {}
        }
    }
    parts.push(text[start..].trim());
    parts
}

/// The number a text begins with, and the unit behind it.
pub fn number(text: &str) -> Result<Number<'_>, String> {
    let ends = text.char_indices().map(|(place, _)| place).chain([text.len()]);
    let mut numbers = ends.filter_map(|end| Some((text[..end].parse::<f64>().ok()?, &text[end..])));
    let longest = numbers.rfind(|(value, _)| value.is_finite());
    let (value, unit) = longest.ok_or_else(|| format!("`{text}` is not a number, like 5 N"))?;
    Ok((value, unit.trim()))
}

/// A value with fifteen digits, which leaves out what rounding made of it, and its unit.
fn written(value: f64, unit: &str) -> String {
    let value: f64 = format!("{value:.14e}").parse().unwrap_or(value);
    let plain = value == 0.0 || (1e-4..1e15).contains(&value.abs());
    let number = if plain { value.to_string() } else { format!("{value:e}") };
    format!("{number} {unit}").trim_end().to_owned()
}

#[cfg(test)]
mod tests {
    use super::{distribution, list};

    #[test]
    fn lists_and_ranges() {
        assert_eq!(list("5 N, 10 N,20 N").unwrap(), ["5 N", "10 N", "20 N"]);
        assert_eq!(list("0.1:0.6:6").unwrap(), ["0.1", "0.2", "0.3", "0.4", "0.5", "0.6"]);
        assert_eq!(list("2e-5 1/MPa:1e-5 1/MPa:2").unwrap(), ["2e-5 1/MPa", "1e-5 1/MPa"]);
        assert_eq!(list("8:32:4").unwrap(), ["8", "16", "24", "32"]);
    }

    /// A list is one value, and so is a table; marks in brackets and quotes part nothing.
    #[test]
    fn values_may_be_lists() {
        let lists = [r#"["1 um", "0 um"]"#, r#"["2 um", "0 um"]"#];
        assert_eq!(list(&lists.join(";")).unwrap(), lists);
        assert_eq!(list(&lists.join(", ")).unwrap(), lists);
        assert_eq!(list("[1 um, 0 um]").unwrap(), ["[1 um, 0 um]"]);
        let tables = ["{ coulomb = { coefficient = 0.3 } }", "{}"];
        assert_eq!(list(&tables.join(" ; ")).unwrap(), tables);
        assert_eq!(list(r#""a:b, c";"d""#).unwrap(), [r#""a:b, c""#, r#""d""#]);
    }

    /// Nothing of that size is made.
    #[test]
    fn counts_are_bounded_before_lists_are_made() {
        for text in ["5 N:20 N:1000000000", "5 N:20 N:18446744073709551615"] {
            let error = list(text).unwrap_err();
            assert!(error.contains("100000 at most can be run"), "{error}");
        }
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (text, said) in [
            ("5 N:20 N:1", "1: a range has two values at least, 5 N and 20 N"),
            ("5 N:5 N:3", "from 5 N to 5 N has one value"),
            ("5 N:20 kN:3", "in one unit"),
            ("5 N:20 N:x", "`x` is not a number of values"),
            ("a:b:3", "`a` is not a number"),
            ("5 N:20 N", "write a range like"),
            ("5 N,,6 N", "a value is missing"),
        ] {
            let error = list(text).unwrap_err();
            assert!(error.contains(said), "{error}");
        }
        for (text, said) in [
            ("gauss(1, 2)", "write a distribution like"),
            ("normal(1 N)", "write a distribution like"),
            ("normal(1 N, 0 N)", "greater than zero"),
            ("lognormal(1 N, 0.2 N)", "has no unit"),
            ("lognormal(-1 N, 0.2)", "a median is greater than zero"),
            ("logstudent(2 N, 0.1, 0.5)", "one at least"),
            ("logstudent(2 N, 0.1 N, 3)", "have no unit"),
            ("uniform(2 N, 1 N)", "an empty range"),
            ("uniform(1 N, 2 kN)", "in one unit"),
        ] {
            let error = distribution(text).unwrap_err();
            assert!(error.contains(said), "{error}");
        }
    }

    /// 1.959963984540054 standard deviations hold 95 %; units may have brackets.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        let value = |text: &str, share| {
            let text = distribution(text).unwrap().quantile(share);
            text.split(' ').next().unwrap().parse::<f64>().unwrap()
        };
        assert_eq!(value("uniform(5 N, 20 N)", 0.2), 8.0);
        assert_eq!(value("normal(10 N, 1 N)", 0.5), 10.0);
        assert!((value("normal(10 N, 1 N)", 0.975) - 11.959963984540054).abs() < 1e-9);
        let k = value("lognormal(1.42e-4 mm^3/(N m), 0.4)", 0.025);
        assert!((k / (1.42e-4 * (-0.4 * 1.959963984540054_f64).exp()) - 1.0).abs() < 1e-9);
        // Student's t of two degrees of freedom: 4.303.
        let k = value("logstudent(2 1/Pa, 0.1, 2)", 0.975);
        assert!((k / (2.0 * 0.430_265_f64.exp()) - 1.0).abs() < 1e-5, "{k}");
        let median = distribution("lognormal(1.42e-4 mm^3/(N m), 0.4)").unwrap().quantile(0.5);
        assert_eq!(median, "0.000142 mm^3/(N m)");
    }
}
