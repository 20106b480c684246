//! The program `archard`.

use std::process::ExitCode;

fn main() -> ExitCode {
    archard_cli::main(std::env::args_os().skip(1).collect()).into()
}
