//! The name someone meant.

/// The known name nearest to what was written, if any is near enough to be worth a suggestion.
pub fn nearest<'a>(written: &str, known: &[&'a str]) -> Option<&'a str> {
    let lower = written.to_lowercase();
    let letters = lower.chars().count();
    let near = |name: &&str| {
        let own = name.chars().count();
        let most = 1 + own / 3;
        // No fewer letters change than one name has more than the other.
        let distance = (letters.abs_diff(own) <= most).then(|| distance(&lower, name))?;
        (distance <= most).then_some(distance)
    };
    known
        .iter()
        .filter_map(|name| Some((near(name)?, *name)))
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, name)| name)
}

/// Number of letters to insert, remove, replace or swap with their neighbour.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut rows: Vec<Vec<usize>> = vec![(0..=b.len()).collect()];
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = rows[i - 1][j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut least = replaced.min(rows[i - 1][j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                least = least.min(rows[i - 2][j - 2] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::{distance, nearest};

    #[test]
    fn letters_missing_doubled_and_swapped() {
        assert_eq!(
            ["raduis", "radius", "radus", "rradius"].map(|w| distance(w, "radius")),
            [1, 0, 1, 1]
        );
        let known = ["material", "profile", "wear", "rigid"];
        assert_eq!(nearest("materials", &known), Some("material"));
        assert_eq!(nearest("Rigid", &known), Some("rigid"));
        assert_eq!(nearest("temperature", &known), None);
    }
}
