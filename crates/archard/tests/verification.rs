//! The program against closed forms and independent solutions.

mod common;

mod verification {
    mod cattaneo_mindlin;
    mod compliance;
    mod hertz;
    mod own_wear_law;
    mod pin_on_disc;
    mod rolling;
    mod rough;
    mod similarity;
    mod step_by_error;
}
