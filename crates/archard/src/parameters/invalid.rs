//! What is wrong with values.

use std::borrow::Cow;
use std::ops::Range;

/// Values that do not fit together, named by the parameter to change.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{parameter}`: {message}")]
pub struct Invalid {
    /// The parameter to point at; one of a table inside the table is written `table.parameter`.
    pub parameter: Cow<'static, str>,
    /// The bytes of the text of that parameter that it is about; `None` for all of it.
    pub within: Option<Range<usize>>,
    /// What is wrong and what to do.
    pub message: String,
    /// What to do, where the message leaves it open.
    pub help: Option<Box<str>>,
    /// Parameters besides it that the error is about, too: any of them may be the one to change.
    pub beside: Vec<&'static str>,
    /// Whether only one of them and it may be given.
    pub exclusive: bool,
}

impl Invalid {
    /// An error at that parameter.
    pub fn new(parameter: impl Into<Cow<'static, str>>, message: impl Into<String>) -> Self {
        Self {
            parameter: parameter.into(),
            within: None,
            message: message.into(),
            help: None,
            beside: vec![],
            exclusive: false,
        }
    }

    /// The same error, about some bytes of the text of the parameter.
    #[must_use]
    pub fn within(self, bytes: Range<usize>) -> Self {
        Self { within: Some(bytes), ..self }
    }

    /// The same error with what to do about it.
    #[must_use]
    pub fn help(self, help: impl Into<Box<str>>) -> Self {
        Self { help: Some(help.into()), ..self }
    }

    /// The same error, about another parameter too.
    #[must_use]
    pub fn beside(mut self, parameter: &'static str) -> Self {
        self.beside.push(parameter);
        self
    }

    /// Two parameters, only one of them to be given, and what to do about it.
    pub fn exclusive(parameter: &'static str, other: &'static str, advice: &str) -> Self {
        let message = format!("`{other}` and `{parameter}` exclude each other: {advice}");
        Self { exclusive: true, ..Self::new(parameter, message).beside(other) }
    }
}
