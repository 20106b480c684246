//! A fit in words, as JSON and as a table.

use std::fmt::{self, Write};

use serde_json::{Value, json};

use super::estimate::UNTOLD as UNTOLD_BY;
use super::outcome::{Coefficient, Fit};
use super::{Estimate, Exponent, MeasuredFile};
use archard_case::output::verdict_json;
use archard_case::verdict::{self, Line, Verdict, Warning, Word, four};

/// What readings say of the law that tell no exponent.
const UNTOLD: &str = "the readings cannot tell whether the law's shape fits";

impl Coefficient {
    /// The factor from SI to the unit that people read, and that unit.
    pub fn shown(&self) -> (f64, &str) {
        match self.unit.as_str() {
            "1/Pa" => (1e9, "mm3/(N m)"),
            unit => (1.0, unit),
        }
    }

    /// Why the tests have no common coefficient, if they have none and it is not assumed.
    pub fn rejected(&self) -> Option<String> {
        self.broken().filter(|_| !self.assumed)
    }

    /// Why the tests do not wear by the law, if they do not.
    fn broken(&self) -> Option<String> {
        let Estimate { distance, loads, by_load, between, .. } = &self.estimate;
        if let Some(between) = between.filter(|between| *between > UNTOLD_BY) {
            return Some(format!(
                "tests of one kind differ {}-fold (one standard deviation): no coefficient tells the next one",
                two(between.exp())
            ));
        }
        if let Some(loads) = loads.filter(Exponent::rejects) {
            let ends = by_load
                .first()
                .zip(by_load.last())
                .map_or((1.0, 1.0), |(one, other)| (one.0, other.0));
            let times = (ends.1 / ends.0).powf(loads.value);
            return Some(format!(
                "one coefficient does not tell tests of all loads: from {} N to {} N it would have to grow {}-fold",
                four(ends.0),
                four(ends.1),
                two(times)
            ));
        }
        distance.filter(Exponent::rejects).map(|found| {
            format!(
                "the tests do not wear as the law says: the wear goes with the distance to the power {} in place of 1",
                two(found.value)
            )
        })
    }

    /// What a verdict says of it.
    fn lines(&self) -> Vec<Line> {
        let Estimate { distance, loads, next, between, .. } = &self.estimate;
        let broken = self.broken().unwrap_or_default();
        let rejected = if self.assumed { Word::Doubtful } else { Word::Wrong };
        let word = |own: &Exponent| match (own.rejects(), own.is_open()) {
            (true, _) => rejected,
            (false, true) => Word::Doubtful,
            (false, false) => Word::Good,
        };
        let why = |own: &Exponent, of: &str| {
            let why = if own.rejects() {
                format!("; {broken}{}", self.if_assumed())
            } else {
                String::new()
            };
            format!("{}: exponent of the {of} {}{why}", self.key, own.in_words())
        };
        let shape = match distance {
            Some(own) => verdict::shape(word(own), &why(own, "distance")),
            None => verdict::shape(Word::Doubtful, &format!("{}: {UNTOLD}", self.key)),
        };
        let constant = loads.as_ref().map(|own| verdict::constant(word(own), &why(own, "load")));
        let next = verdict::next_test(next.is_some(), &self.key);
        let scatters = between.filter(|between| *between > UNTOLD_BY);
        let scatter = scatters.map(|_| {
            verdict::constant(rejected, &format!("{}: {broken}{}", self.key, self.if_assumed()))
        });
        [shape].into_iter().chain(constant).chain(scatter).chain([next]).collect()
    }

    /// What may be done about a law that the tests do not wear by.
    fn if_assumed(&self) -> String {
        match self.assumed {
            true => " (assumed all the same)".to_owned(),
            false => format!(" (--assume {} gives a coefficient all the same)", self.key),
        }
    }

    fn json(&self, quantities: &[(String, f64, &'static str)]) -> Value {
        let own = &self.estimate;
        let exponent = |found: &Exponent| json!({ "exponent": found.value, "interval_95": found.interval, "p": found.p, "rejected": found.rejects(), "words": found.in_words() });
        let readings = own.readings.as_ref().map(|all| {
            let named =
                quantities.iter().zip(all).map(|((name, _, _), own)| (name.clone(), json!(own)));
            Value::Object(named.collect())
        });
        json!({
            "key": self.key,
            "unit": self.unit,
            "in_the_case": self.before,
            "median": own.median,
            "interval_95": own.interval,
            "next_test_95": own.next,
            "next_test_log_deviation": own.predictive.map(|[deviation, _]| deviation),
            "next_test_degrees_of_freedom": own.predictive.map(|[_, degrees]| degrees),
            "scatter_between_tests": own.between,
            "readings": readings,
            "readings_understated": own.understated,
            "correlation_of_readings": own.correlation,
            "distance": own.distance.as_ref().map(exponent),
            "load": own.loads.as_ref().map(exponent),
            "tests": own.tests.iter().zip(&self.tests).map(|((name, k, interval), test)| json!({
                "test": name, "load_N": test.load, "readings": test.readings.len(), "k": k, "interval_95": interval,
            })).collect::<Vec<_>>(),
            "by_load": own.by_load.iter().map(|(load, tests, k, interval)| json!({
                "load_N": load, "tests": tests, "median": k, "interval_95": interval,
            })).collect::<Vec<_>>(),
            "budget": own.budget.iter().map(|(source, relative)| json!({
                "source": source, "relative": relative,
            })).collect::<Vec<_>>(),
            "more_tests": own.more().map(|more| json!({
                "half_95_by_tests": more.halves, "tests_for_5_percent": more.wanted, "common_half_95": more.common,
            })),
            "rejected": self.rejected(),
        })
    }
}

impl Fit {
    /// Why the coefficients, or some of them, are none, if that is so.
    pub fn rejected(&self) -> Option<String> {
        self.not_settled().or_else(|| self.coefficients.iter().find_map(Coefficient::rejected))
    }

    /// Whether the fit can be believed: coefficients that settled, exponents, the next test, and all that is doubtful about the runs.
    pub fn verdict(&self) -> Verdict {
        let not_settled = self.not_settled();
        let word = if not_settled.is_some() { Word::Wrong } else { Word::Good };
        let settled = verdict::settled(word, &not_settled.unwrap_or_default());
        let coefficients = self.coefficients.iter().flat_map(Coefficient::lines);
        let doubts: Vec<Warning> = self.doubts.iter().cloned().map(Warning::from).collect();
        [settled].into_iter().chain(coefficients).collect::<Verdict>().warned_of(&doubts)
    }

    fn not_settled(&self) -> Option<String> {
        let percent = percent(self.unsettled?.exp_m1().abs());
        Some(format!(
            "the coefficients did not settle: the ratio of both in the runs and that of the readings differ by {percent}; \
             readings of both bodies, or more of them, may tell it"
        ))
    }

    /// The fit as JSON, in SI.
    pub fn json(&self) -> Value {
        json!({
            "program": "archard",
            "version": env!("CARGO_PKG_VERSION"),
            "progress": self.progress,
            "runs": self.runs,
            "only_k_s_counts": self.by_k_s,
            "coefficients": self.coefficients.iter().map(|own| own.json(&self.quantities)).collect::<Vec<_>>(),
            "correlation_of_coefficients": self.correlation().map(|(value, tests)| json!({ "value": value, "tests": tests })),
            "correlations": self.together,
            "surfaces": self.surfaces.iter().map(MeasuredFile::json).collect::<Vec<_>>(),
            "remarks": self.remarks,
            "verdict": verdict_json(&self.verdict()),
            "unsettled": self.not_settled(),
        })
    }

    /// The readings with what the fit of their test says, as CSV in SI.
    pub fn csv(&self) -> String {
        let mut table = csv::Writer::from_writer(vec![]);
        // Into memory, by rows of one length: nothing can fail.
        let head =
            ["key", "test", "load_N", "line", self.progress, "quantity", "measured", "fitted"];
        let _ = table.write_record(head);
        for own in &self.coefficients {
            for (test, fitted) in own.tests.iter().zip(&own.estimate.fitted) {
                for (reading, residual) in test.readings.iter().zip(&fitted.residuals) {
                    let load = test.load.map(|load| format!("{load:?}")).unwrap_or_default();
                    let _ = table.write_record([
                        &own.key,
                        &test.name,
                        &load,
                        &reading.line.to_string(),
                        &format!("{:?}", reading.progress),
                        &self.quantities[reading.quantity].0,
                        &format!("{:?}", reading.value),
                        &format!("{:?}", reading.value / residual.exp()),
                    ]);
                }
            }
        }
        String::from_utf8(table.into_inner().unwrap_or_default()).unwrap_or_default()
    }
}

/// The fit in words.
impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for own in &self.coefficients {
            f.write_str(&words(own, &self.quantities)?)?;
        }
        for (i, row) in self.together.iter().enumerate() {
            for (j, value) in row.iter().enumerate().take(i) {
                let [one, other] = [j, i].map(|place| &self.coefficients[place].key);
                let value = two(*value);
                writeln!(
                    f,
                    "together          errors of `{one}` and `{other}` correlate by {value}"
                )?;
            }
        }
        if let Some((value, tests)) = self.correlation().filter(|_| self.together.is_empty()) {
            writeln!(
                f,
                "together          the coefficients go with each other from test to test: correlation {} of {tests} tests",
                two(value)
            )?;
        }
        for surface in &self.surfaces {
            writeln!(f, "surface           {surface}")?;
        }
        for remark in &self.remarks {
            writeln!(f, "note              {remark}")?;
        }
        let verdict = self.verdict();
        writeln!(f, "verdict           {}", verdict.in_words())?;
        verdict.complaints().try_for_each(|line| writeln!(f, "  {}", line.in_words()))
    }
}

fn words(
    own: &Coefficient,
    quantities: &[(String, f64, &'static str)],
) -> Result<String, fmt::Error> {
    let mut text = String::new();
    let Estimate { median, interval, next, tests, by_load, .. } = &own.estimate;
    let (factor, unit) = own.shown();
    let number = |k: f64| format!("{:.3e}", k * factor);
    let range = |[low, high]: [f64; 2]| format!("{} .. {}", number(low), number(high));
    let many = match tests.len() {
        1 => "1 test".to_owned(),
        count => format!("{count} tests"),
    };
    writeln!(text, "{}", own.key)?;
    let Some(rejected) = own.rejected() else {
        let within = match interval {
            Some(interval) => format!(", 95 % interval {}", range(*interval)),
            None => ", without an interval: a single reading without its uncertainty (`u_` column) has none".to_owned(),
        };
        writeln!(text, "  k               {} {unit}{within} ({many})", number(*median))?;
        match next {
            Some(next) => writeln!(
                text,
                "  next test       {} {unit}: another test, read as these, lies there with 95 % probability",
                range(*next)
            )?,
            None => writeln!(
                text,
                "  next test       one test cannot tell how tests scatter, nor where the next will lie"
            )?,
        }
        explain(&mut text, own, quantities)?;
        return Ok(text);
    };
    writeln!(text, "  k               none: {rejected}")?;
    for (load, count, k, interval) in by_load.iter().filter(|_| by_load.len() > 1) {
        let within =
            interval.map_or(String::new(), |own| format!(", 95 % interval {}", range(own)));
        writeln!(
            text,
            "  at {:<12} {} {unit}{within} ({count} tests)",
            format!("{} N", four(*load)),
            number(*k)
        )?;
    }
    explain(&mut text, own, quantities)?;
    Ok(text)
}

fn explain(
    text: &mut String,
    own: &Coefficient,
    quantities: &[(String, f64, &'static str)],
) -> fmt::Result {
    let Estimate { between, readings, understated, correlation, distance, loads, budget, .. } =
        &own.estimate;
    let named = |all: &Vec<f64>| -> String {
        let used = |place: usize| {
            own.tests.iter().flat_map(|test| &test.readings).any(|r| r.quantity == place)
        };
        let one = |(_, ((name, _, _), own)): (usize, (&(String, f64, &'static str), &f64))| {
            format!("a reading of `{name}` {}", percent(*own))
        };
        let all = quantities.iter().zip(all).enumerate().filter(|(place, _)| used(*place));
        all.map(one).collect::<Vec<_>>().join(", ")
    };
    match (between, readings) {
        (Some(between), Some(all)) => {
            writeln!(
                text,
                "  scatter         {} between tests; {}",
                percent(*between),
                named(all)
            )?;
        }
        (Some(between), None) => writeln!(
            text,
            "  scatter         {} between tests, reading errors included: single readings do not tell them apart",
            percent(*between)
        )?,
        (None, Some(all)) => writeln!(text, "  scatter         {}", named(all))?,
        (None, None) => {}
    }
    if let Some(times) = understated {
        writeln!(
            text,
            "                  readings scatter {} times as much as their uncertainties say",
            two(*times)
        )?;
    }
    if *correlation > 0.0 {
        writeln!(
            text,
            "                  what one reading is off, the next is too (correlation {}): they count as fewer",
            two(*correlation)
        )?;
    }
    match distance {
        Some(found) => writeln!(
            text,
            "  law's shape     exponent of the distance, 1 by the law: {}",
            found.in_words()
        )?,
        None => writeln!(text, "  law's shape     {UNTOLD}")?,
    }
    if let Some(found) = loads {
        writeln!(
            text,
            "  constant k      exponent of the load that k depends on, 0 by the law: {}",
            found.in_words()
        )?;
    }
    if let Some(more) = own.estimate.more() {
        writeln!(text, "  more tests      {}", more.in_words())?;
    }
    let mut parts: Vec<_> = budget.iter().collect();
    parts.sort_by(|one, other| other.1.total_cmp(&one.1));
    let parts: Vec<String> =
        parts.iter().map(|(source, own)| format!("{source} {}", percent(*own))).collect();
    if !parts.is_empty() {
        writeln!(text, "  uncertain by    {}", parts.join(", "))?;
    }
    Ok(())
}

fn percent(share: f64) -> String {
    match 100.0 * share {
        small if small < 0.1 => "under 0.1 %".to_owned(),
        small if small < 10.0 => format!("{small:.1} %"),
        large => format!("{large:.0} %"),
    }
}

fn two(number: f64) -> String {
    if number.abs() < 10.0 { format!("{number:.2}") } else { format!("{number:.0}") }
}
