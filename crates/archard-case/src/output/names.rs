//! The names that this program gives to files of its folders. Of a list that has others, these others are not believed.

/// All names: `*` stands for the name of a body, a section, a side or a number, `#` for the number of an output.
const GIVEN: &[&str] = &[
    // Of a run.
    "case.toml",
    "summary.json",
    "checkpoint",
    "history.csv",
    "profiles.csv",
    "worn_profiles.csv",
    "length_profiles.csv",
    "fretting_loop.csv",
    "distributions.csv",
    "worn_*.vti",
    "fields.pvd",
    "fields/#.vti",
    "fields/#.vtu",
    "points.csv",
    "surface.vtu",
    "surface_1.vtu",
    "surface_2.vtu",
    "sections/*.vtu",
    "stress_*.csv",
    "stress_*.vtr",
    "damage_*.csv",
    // Of a wheel on a rail.
    "contacts.csv",
    "patches/*.vti",
    "wear.csv",
    "dimensions.csv",
    "gathered.csv",
    "worn_wheel_*.*",
    "worn_rail_*.*",
    // Of two gears, and of a cam with its follower.
    "flanks.csv",
    "course.csv",
    "cam.csv",
    "follower.csv",
    // For ParaView.
    "open.py",
    "*_#.vtu",
    "*.pvd",
    "stress_*.vtu",
    "section_*.vtu",
    // Of two scans.
    "difference.json",
    "difference.vti",
    "section.csv",
    "tests.csv",
    // Of a fit.
    "fit.csv",
    "fit.json",
    // Of a study.
    "design.csv",
    "study.json",
    "sweep.csv",
];

/// The name of the file with all that is worn off the surface of a body.
pub(super) fn worn(body: &str) -> String {
    format!("worn_{body}.vti")
}

/// Whether this program gives a file that name in its folder.
pub(super) fn is_given(name: &str) -> bool {
    GIVEN.iter().any(|pattern| fits(pattern, name))
}

fn fits(pattern: &str, name: &str) -> bool {
    let Some(at) = pattern.find(['*', '#']) else { return pattern == name };
    let Some(rest) = name.strip_prefix(&pattern[..at]) else { return false };
    let digits = pattern[at..].starts_with('#');
    let stands = |part: &str| match digits {
        true => part.len() >= 4 && part.bytes().all(|byte| byte.is_ascii_digit()),
        false => !part.is_empty() && !part.contains('/'),
    };
    let ends = rest.char_indices().map(|(end, _)| end).chain([rest.len()]);
    ends.into_iter().any(|end| stands(&rest[..end]) && fits(&pattern[at + 1..], &rest[end..]))
}

#[cfg(test)]
mod tests {
    use super::is_given;

    #[test]
    fn names_are_those_of_the_list() {
        let given = [
            "case.toml",
            "fields/0000.vti",
            "fields/12345.vtu",
            "sections/pin_middle.vtu",
            "worn_wheel_left.prw",
            "worn_plate.vti",
            "disc_0003.vtu",
            "pin.pvd",
        ];
        assert!(given.iter().all(|name| is_given(name)));
        let others = [
            "thesis.docx",
            "sub/deep/data.csv",
            "sub/case.toml",
            "fields/1.vti",
            "fields/0000.csv",
            "fields/a/0000.vti",
            "sections/a/b.vtu",
            "sections/.vtu",
            ".pvd",
            "a/b.pvd",
            "case.toml.bak",
        ];
        let believed: Vec<&&str> = others.iter().filter(|name| is_given(name)).collect();
        assert!(believed.is_empty(), "{believed:?}");
    }
}
