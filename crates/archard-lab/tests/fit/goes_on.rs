//! Fits that are interrupted, and folders of others.

use archard_case::output::Claim;
use archard_lab::Error;

use super::made::{Until, fitted, fitted_in, published};

/// What a fit that was ended has run is not run again, and what comes out is the same.
#[test]
fn a_fit_goes_on_where_it_was_ended() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let text =
        "test,distance_m,volume_mm3\nA,0.2,2.6e-4\nA,0.4,5.6e-4\nB,0.2,3.3e-4\nB,0.4,6.4e-4\n";
    let (dir, whole) = (tempfile::tempdir().unwrap(), fitted(&file, text, None).unwrap());
    assert!(whole.runs >= 3, "{}", whole.runs);
    let mut ended = Until(Some(3), vec![]);
    let error = fitted_in(dir.path(), &file, (text, None), &mut ended).unwrap_err();
    assert_eq!(
        error.to_string(),
        "interrupted after 2 runs, which are kept: the same call goes on behind them"
    );
    let mut again = Until(None, vec![]);
    let found = fitted_in(dir.path(), &file, (text, None), &mut again).unwrap();
    let before = again.1.iter().filter(|seconds| seconds.is_none()).count();
    assert_eq!((before, again.1.len()), (2, whole.runs));
    assert_eq!(found.json(), whole.json());
    assert!(!dir.path().join("kept").exists());
}

/// Two fits in one folder would write over each other: the folder is wrong, and nothing failed to converge.
#[test]
fn a_folder_in_use_is_refused() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let dir = tempfile::tempdir().unwrap();
    let _held = Claim::take(&dir.path().join("run")).unwrap();
    let text = "test,distance_m,volume_mm3\nA,0.4,5e-4\n";
    let error = fitted_in(dir.path(), &file, (text, None), &mut Until(None, vec![])).unwrap_err();
    assert!(matches!(error, Error::Folder(_)) && !error.is_of_convergence(), "{error}");
}

/// Runs that were kept are of the density they were made with, which no step depends on.
#[test]
fn runs_of_another_density_are_not_gone_on_with() {
    let file = published("pin_on_disc", &["motion.sliding.step=\"25 mm\""]);
    let of = |density: &str| file.clone().set(format!("body.pin.density=\"{density}\""));
    let text = "test,distance_m,mass_mg\nA,0.2,0.002\nA,0.4,0.0043\n";
    let dir = tempfile::tempdir().unwrap();
    let mut ended = Until(Some(3), vec![]);
    fitted_in(dir.path(), &of("7800 kg/m3"), (text, None), &mut ended).unwrap_err();
    let mut again = Until(None, vec![]);
    let found = fitted_in(dir.path(), &of("3900 kg/m3"), (text, None), &mut again).unwrap();
    assert!(again.1.iter().all(Option::is_some), "{:?}", again.1);
    assert_eq!(found.json(), fitted(&of("3900 kg/m3"), text, None).unwrap().json());
}
