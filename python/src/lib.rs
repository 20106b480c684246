//! The compiled part of the Python package `archard`: cases that are checked, runs that are stepped, fields that are read.
//!
//! All computing happens on threads of its own pool, while Python is let go of; none happens on the pool that a process
//! shares, which a forked process would not have.

mod away;
mod build;
mod case;
mod command;
mod contact;
mod elastic;
mod fields;
mod fit;
mod folders;
mod friction;
mod gears;
mod known;
mod law;
mod log;
mod rail;
mod run;
mod surface;
mod validate;

use pyo3::prelude::*;

/// The units that columns end in.
fn units() -> Vec<&'static str> {
    let columns = archard::simulation::history::COLUMNS.iter().map(|column| column.unit);
    let mut units: Vec<&str> = columns.filter(|unit| !unit.is_empty()).collect();
    units.sort_unstable_by_key(|unit| std::cmp::Reverse(unit.len()));
    units.dedup();
    units
}

/// The compiled part of `archard`.
#[pymodule]
mod _archard {
    #[pymodule_export]
    use super::case::{CaseFile, Checked};
    #[pymodule_export]
    use super::command::command;
    #[pymodule_export]
    use super::contact::{Inside, by_load, by_shape, solve_contact};
    #[pymodule_export]
    use super::elastic::solve_elastic;
    #[pymodule_export]
    use super::fields::read_fields;
    #[pymodule_export]
    use super::fit::{fit, next_tests};
    #[pymodule_export]
    use super::folders::{
        comparison, free_memory, knows_unit, numbers, page, pictures, quantity, verify,
    };
    #[pymodule_export]
    use super::gears::{wear_cam, wear_gears};
    #[pymodule_export]
    use super::known::{laws, materials};
    #[pymodule_export]
    use super::log::read_log;
    #[pymodule_export]
    use super::rail::WheelRail;
    #[pymodule_export]
    use super::run::Run;
    #[pymodule_export]
    use super::surface::{read_surface, scan_difference};
    #[pymodule_export]
    use super::validate::validate;

    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("UNITS", super::units())
    }
}
