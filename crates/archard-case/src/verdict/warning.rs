//! What a user is warned of.

/// What was doubtful before anything was computed, or is where it was computed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// What is doubtful.
    pub text: String,
    /// The subject of the line that judges the same in results; `None` where no line does.
    pub judged: Option<&'static str>,
}

impl From<String> for Warning {
    fn from(text: String) -> Self {
        Self { text, judged: None }
    }
}
