//! Why the command failed, and the exit code that says so.

/// A failure.
#[derive(Debug)]
pub enum Failure {
    /// A solve or a step did not converge.
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

    /// The exit code.
    pub fn code(&self) -> u8 {
        match self {
            Failure::NotConverged(_) => 1,
            Failure::Wrong(_) | Failure::Shown => 2,
            Failure::Interrupted(_) => 3,
        }
    }

    /// Says what happened.
    pub fn report(&self) {
        match self {
            Failure::NotConverged(message)
            | Failure::Wrong(message)
            | Failure::Interrupted(message) => {
                eprintln!("error: {message}");
            }
            Failure::Shown => {}
        }
    }
}
