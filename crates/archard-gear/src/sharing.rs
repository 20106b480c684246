//! How the pairs of teeth that touch at once share the load.

use archard::parameters::Invalid;

/// How pairs of teeth share the load.
#[derive(Debug, Clone, PartialEq)]
pub enum Sharing {
    /// A third where a pair begins to touch, two thirds where the pair before it lets go, in proportion to the way between, and the other
    /// way round at the end (ISO/TS 6336-22, profiles without relief).
    Thirds,
    /// Springs of so much stiffness (N/m^2, over the width) along the path; one that has worn more bears less.
    Springs(f64),
    /// Shares over places of the path (m), straight between them.
    Table(Vec<[f64; 2]>),
}

impl Sharing {
    /// Shares in the order of their places.
    ///
    /// # Errors
    /// If there are fewer than two, places do not rise, or a share is not one.
    pub fn table(rows: Vec<[f64; 2]>) -> Result<Self, Invalid> {
        let wrong = |message: String| Err(Invalid::new("share", message));
        if rows.len() < 2 {
            return wrong("two places at least".to_owned());
        }
        for (line, pair) in rows.windows(2).enumerate() {
            // A share that jumps has two rows at its place.
            if pair[1][0] < pair[0][0] {
                return wrong(format!("row {}: places along the path must rise", line + 2));
            }
        }
        match rows.iter().position(|[_, share]| !(0.0..=1.0).contains(share)) {
            Some(line) => wrong(format!("row {}: a share lies between 0 and 1", line + 1)),
            None => Ok(Self::Table(rows)),
        }
    }

    /// Loads of springs that share a load, over it in N/m; `worn` (m) has how far each has worn.
    pub(crate) fn by_springs(stiffness: f64, load: f64, worn: &[f64]) -> Vec<f64> {
        // Those that have worn least bear; one after the other joins in until the approach does not reach the next.
        let mut order: Vec<usize> = (0..worn.len()).collect();
        order.sort_by(|&one, &other| worn[one].total_cmp(&worn[other]));
        let mut approach = f64::INFINITY;
        let mut sum = 0.0;
        for (count, &pair) in order.iter().enumerate() {
            if worn[pair] >= approach {
                break;
            }
            sum += worn[pair];
            approach = (load / stiffness + sum) / (count + 1) as f64;
        }
        worn.iter().map(|worn| stiffness * (approach - worn).max(0.0)).collect()
    }

    /// The share at a place (m) of a table; where it jumps, the value before the jump if that is wanted.
    pub(crate) fn at(rows: &[[f64; 2]], place: f64, from_below: bool) -> f64 {
        let after = |row: &[f64; 2]| if from_below { row[0] >= place } else { row[0] > place };
        let next = rows.iter().position(after).unwrap_or(rows.len());
        match (next.checked_sub(1).map(|before| &rows[before]), rows.get(next)) {
            (Some([start, low]), Some([end, high])) if *end > *start => {
                low + (high - low) * (place - start) / (end - start)
            }
            (_, Some([_, share])) | (Some([_, share]), None) => *share,
            (None, None) => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::Sharing;

    #[test]
    fn springs_bear_what_they_share() {
        // Two of one length, one that is worn by less than the other is pressed, and one that touches nothing.
        assert_eq!(Sharing::by_springs(2.0, 10.0, &[0.0, 0.0]), [5.0, 5.0]);
        assert_eq!(Sharing::by_springs(2.0, 10.0, &[1.0, 0.0]), [4.0, 6.0]);
        assert_eq!(Sharing::by_springs(2.0, 10.0, &[7.0, 0.0]), [0.0, 10.0]);
        let three = Sharing::by_springs(3.0, 9.0, &[0.5, 0.0, 4.0]);
        assert_relative_eq!(three.iter().sum::<f64>(), 9.0, max_relative = 1e-14);
        assert_relative_eq!(three[1] - three[0], 1.5, max_relative = 1e-14);
        assert_eq!(three[2], 0.0);
    }

    #[test]
    fn shares_of_a_table_may_jump() {
        let rows = [[0.0, 0.2], [1.0, 0.4], [1.0, 1.0], [2.0, 1.0]];
        assert_relative_eq!(Sharing::at(&rows, 0.5, true), 0.3);
        assert_relative_eq!(Sharing::at(&rows, 1.0, true), 0.4);
        assert_relative_eq!(Sharing::at(&rows, 1.0, false), 1.0);
        assert_relative_eq!(Sharing::at(&rows, 5.0, false), 1.0);
        assert!(Sharing::table(vec![[0.0, 0.5], [1.0, 1.5]]).is_err());
        assert!(Sharing::table(vec![[1.0, 0.5], [0.0, 0.5]]).is_err());
    }
}
