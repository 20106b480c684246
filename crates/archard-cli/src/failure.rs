//! Why the command failed, and the exit code that says so.

use archard_case::told;

use crate::say::tell;

/// The exit code of a run that was stopped, by whichever signal.
pub const INTERRUPTED: u8 = 3;

/// A failure.
#[derive(Debug)]
pub enum Failure {
    /// A solve or a step did not converge, or what came out cannot be right.
    NotConverged(String),
    /// The case, the command line or a folder is not as it has to be.
    Wrong(String),
    /// The same, and what is wrong was shown already.
    Shown,
    /// The user stopped the run.
    Interrupted(String),
}

impl Failure {
    /// Something wrong, in words.
    pub fn wrong(message: impl Into<String>) -> Self {
        Self::Wrong(message.into())
    }

    /// Something wrong with its causes, as far as the words before have not told them.
    pub fn because(error: &anyhow::Error) -> Self {
        let mut message = String::new();
        for cause in error.chain().map(ToString::to_string) {
            match (message.is_empty(), message.contains(&cause)) {
                (true, _) => message = cause,
                (false, true) => {}
                (false, false) => message += &format!(": {cause}"),
            }
        }
        Self::Wrong(message)
    }

    /// Why, in one line.
    pub fn cause(&self) -> String {
        match self {
            Failure::NotConverged(message)
            | Failure::Wrong(message)
            | Failure::Interrupted(message) => {
                message.lines().next().unwrap_or_default().to_owned()
            }
            Failure::Shown => String::new(),
        }
    }

    /// The same with something else that failed on the way out.
    pub fn and(self, error: &dyn std::error::Error) -> Self {
        let error = error.to_string();
        let more = |message: String| match message.contains(&error) {
            true => message,
            false => format!("{message}\n{error}"),
        };
        match self {
            Failure::NotConverged(message) => Failure::NotConverged(more(message)),
            Failure::Wrong(message) => Failure::Wrong(more(message)),
            Failure::Interrupted(message) => Failure::Interrupted(more(message)),
            Failure::Shown => Failure::Shown,
        }
    }

    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Failure::NotConverged(_) => 1,
            Failure::Wrong(_) | Failure::Shown => 2,
            Failure::Interrupted(_) => INTERRUPTED,
        }
    }

    /// Says what happened.
    pub fn report(&self) {
        match self {
            Failure::NotConverged(message)
            | Failure::Wrong(message)
            | Failure::Interrupted(message) => tell(&told(format!("error: {message}"))),
            Failure::Shown => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io;

    use super::Failure;

    /// An error that gives its cause.
    #[derive(Debug, thiserror::Error)]
    #[error("cannot read `file`: {0}")]
    struct Told(#[source] io::Error);

    #[test]
    fn a_cause_is_told_once() {
        let told = Told(io::Error::other("it is a pipe"));
        let outer = anyhow::Error::new(told).context("no picture");
        assert_eq!(
            Failure::because(&outer).cause(),
            "no picture: cannot read `file`: it is a pipe"
        );
    }
}
