//! Work on other threads, while Python goes on and listens for Ctrl-C.

use std::any::Any;
use std::num::NonZero;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// How often signals are looked at.
const PERIOD: Duration = Duration::from_millis(50);
/// Time that work has to come to its end in after a signal; then it is left alone.
const GRACE: Duration = Duration::from_secs(2);
/// Threads a processor may be given at most.
const MOST_THREADS: usize = 8;

/// What became of some work.
pub enum Outcome<T> {
    /// It is done, and a signal may have come in meanwhile.
    Done(T, Option<PyErr>),
    /// A signal came in, and the work goes on by itself.
    Left(PyErr),
}

impl<T> Outcome<T> {
    /// What came out, unless there was a signal.
    pub fn unless_interrupted(self) -> PyResult<T> {
        match self {
            Outcome::Done(value, None) => Ok(value),
            Outcome::Done(_, Some(signal)) | Outcome::Left(signal) => Err(signal),
        }
    }
}

/// A pool of that many threads; as many as there are processors if not given.
pub fn pool(threads: Option<usize>) -> PyResult<ThreadPool> {
    let processors = std::thread::available_parallelism().map_or(1, NonZero::get);
    let threads = threads.unwrap_or(processors);
    if threads == 0 || threads > MOST_THREADS * processors {
        let message = format!(
            "threads = {threads}: take 1 to {}; this machine has {processors} processors",
            MOST_THREADS * processors
        );
        return Err(PyValueError::new_err(message));
    }
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|error| {
        PyRuntimeError::new_err(format!("cannot start {threads} threads: {error}"))
    })
}

/// Does some work in a pool. What panics there panics here.
pub fn away<T: Send + 'static>(
    py: Python<'_>,
    pool: &ThreadPool,
    work: impl FnOnce() -> T + Send + 'static,
) -> Outcome<T> {
    let (sender, mut receiver) = channel();
    pool.spawn(move || {
        let outcome = catch_unwind(AssertUnwindSafe(work));
        // Nobody waits for work that was left.
        let _ = sender.send(outcome);
    });
    let mut signal: Option<(PyErr, Instant)> = None;
    loop {
        let received = py.detach(move || {
            let received = receiver.recv_timeout(PERIOD);
            (received, receiver)
        });
        receiver = received.1;
        match received.0 {
            Ok(Ok(value)) => return Outcome::Done(value, signal.map(|(error, _)| error)),
            Ok(Err(panic)) => resume_unwind(panic),
            Err(RecvTimeoutError::Disconnected) => resume_unwind(lost()),
            Err(RecvTimeoutError::Timeout) => {}
        }
        match signal {
            Some((error, since)) if since.elapsed() > GRACE => return Outcome::Left(error),
            Some(_) => {}
            None => signal = py.check_signals().err().map(|error| (error, Instant::now())),
        }
    }
}

fn lost() -> Box<dyn Any + Send> {
    Box::new("a thread ended without a result")
}
