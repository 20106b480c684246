//! A browser without a window, driven over the DevTools protocol.
//!
//! Chromium is looked for under its usual names. Where none exists, tests say so and end, unless
//! `ARCHARD_BROWSER=required`.

use std::io::{BufRead, BufReader};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tempfile::TempDir;
use tungstenite::WebSocket;

/// Names of the browser.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];
/// What it is started with: no window, no network of its own.
const OPTIONS: [&str; 12] = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--enable-unsafe-swiftshader",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--host-resolver-rules=MAP * ~NOTFOUND , EXCLUDE 127.0.0.1",
    "--remote-debugging-port=0",
    "about:blank",
];
/// The longest wait for an answer.
const PATIENCE: Duration = Duration::from_secs(120);

/// A page in a browser.
pub struct Page {
    process: Child,
    socket: WebSocket<TcpStream>,
    asked: u64,
    attached: Option<String>,
    /// What the page complained of: errors, warnings of the console and requests that failed.
    pub complaints: Vec<String>,
    _profile: TempDir,
}

impl Drop for Page {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

impl Page {
    /// Starts a browser; `None`, said on standard error, where none is installed.
    pub fn open() -> Option<Self> {
        let profile = TempDir::new().unwrap();
        let started = NAMES.iter().find_map(|name| {
            let mut command = Command::new(name);
            command.args(OPTIONS).arg(format!("--user-data-dir={}", profile.path().display()));
            command.stderr(Stdio::piped()).stdout(Stdio::null()).spawn().ok()
        });
        let Some(mut process) = started else {
            let required = std::env::var("ARCHARD_BROWSER").is_ok_and(|word| word == "required");
            assert!(!required, "ARCHARD_BROWSER=required, and none of {NAMES:?} starts");
            eprintln!("skipped: none of {NAMES:?} is installed");
            return None;
        };
        let mut lines = BufReader::new(process.stderr.take().unwrap()).lines();
        let browser = lines
            .find_map(|line| {
                Some(line.ok()?.split_once("DevTools listening on ws://")?.1.to_owned())
            })
            .expect("the browser says where it listens");
        // What it says from now on is read, so that it never waits for that.
        std::thread::spawn(move || lines.for_each(drop));
        let host = browser.split('/').next().unwrap().to_owned();
        let stream = TcpStream::connect(&host).unwrap();
        stream.set_read_timeout(Some(PATIENCE)).unwrap();
        let (socket, _) = tungstenite::client(format!("ws://{browser}"), stream).unwrap();
        let mut page = Self {
            process,
            socket,
            asked: 0,
            attached: None,
            complaints: vec![],
            _profile: profile,
        };
        let target = page.ask(None, "Target.createTarget", json!({ "url": "about:blank" }));
        let target = target["targetId"].as_str().unwrap().to_owned();
        let path = json!({ "targetId": target, "flatten": true });
        let session = page.ask(None, "Target.attachToTarget", path);
        let session = session["sessionId"].as_str().unwrap().to_owned();
        page.attached = Some(session);
        for domain in ["Page", "Runtime", "Log", "Network"] {
            page.tell(&format!("{domain}.enable"), json!({}));
        }
        Some(page)
    }

    /// Sends a command to the page and waits for its answer.
    fn tell(&mut self, method: &str, parameters: Value) -> Value {
        let session = self.attached.clone();
        self.ask(session.as_deref(), method, parameters)
    }

    fn ask(&mut self, session: Option<&str>, method: &str, parameters: Value) -> Value {
        self.asked += 1;
        let mut message = json!({ "id": self.asked, "method": method, "params": parameters });
        if let Some(session) = session {
            message["sessionId"] = json!(session);
        }
        self.socket.send(tungstenite::Message::text(message.to_string())).unwrap();
        loop {
            let text = self.socket.read().unwrap();
            let Ok(answer) = serde_json::from_str::<Value>(text.to_text().unwrap_or("")) else {
                continue;
            };
            if answer["id"] == self.asked {
                assert!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                return answer["result"].clone();
            }
            self.complaints.extend(complaint(&answer));
        }
    }

    /// Makes the page that wide (px).
    pub fn resize(&mut self, width: u32) {
        let metrics =
            json!({ "width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 600 });
        self.tell("Emulation.setDeviceMetricsOverride", metrics);
    }

    /// Opens a file.
    pub fn visit(&mut self, file: &Path) {
        self.tell("Page.navigate", json!({ "url": format!("file://{}", file.display()) }));
        let ready = "new Promise((done) => { const look = () => document.body && \
            ['done', 'trouble'].includes(document.body.dataset.state) ? done(document.body.dataset.state) : setTimeout(look, 50); look(); })";
        assert_eq!(self.value(ready), "done");
    }

    /// Opens a file with its scripts switched off, or on again.
    pub fn visit_plain(&mut self, file: &Path, plain: bool) {
        self.tell("Emulation.setScriptExecutionDisabled", json!({ "value": plain }));
        if plain {
            self.tell("Page.navigate", json!({ "url": format!("file://{}", file.display()) }));
            // Nothing on the page can wait for its end.
            let start = Instant::now();
            while self.value("document.readyState") != "complete" {
                assert!(start.elapsed() < PATIENCE, "{} does not load", file.display());
                std::thread::sleep(Duration::from_millis(30));
            }
        }
    }

    /// Shows the page as in print, or as on a screen.
    pub fn in_print(&mut self, print: bool) {
        let media = if print { "print" } else { "screen" };
        self.tell("Emulation.setEmulatedMedia", json!({ "media": media }));
    }

    /// The value of an expression, of a promise what it promised.
    pub fn value(&mut self, expression: &str) -> Value {
        let evaluate =
            json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let answer = self.tell("Runtime.evaluate", evaluate);
        assert!(answer["exceptionDetails"].is_null(), "{expression}: {answer}");
        answer["result"]["value"].clone()
    }

    /// Keeps a picture of the whole page as `ARCHARD_SCREENSHOTS/NAME.png`, if that folder is named.
    pub fn picture(&mut self, name: &str) {
        let Some(dir) = std::env::var_os("ARCHARD_SCREENSHOTS") else { return };
        let picture = json!({ "format": "png", "captureBeyondViewport": true });
        let picture = self.tell("Page.captureScreenshot", picture);
        use base64::Engine;
        let bytes =
            base64::engine::general_purpose::STANDARD.decode(picture["data"].as_str().unwrap());
        std::fs::write(Path::new(&dir).join(format!("{name}.png")), bytes.unwrap()).unwrap();
    }

    /// The page as it is printed.
    pub fn printed(&mut self) -> Vec<u8> {
        let paper = json!({ "printBackground": true, "paperWidth": 8.27, "paperHeight": 11.69 });
        let pdf = self.tell("Page.printToPDF", paper);
        use base64::Engine;
        base64::engine::general_purpose::STANDARD.decode(pdf["data"].as_str().unwrap()).unwrap()
    }
}

/// What an event complains of.
fn complaint(event: &Value) -> Option<String> {
    let parameters = &event["params"];
    match event["method"].as_str()? {
        "Runtime.exceptionThrown" => Some(parameters["exceptionDetails"].to_string()),
        "Runtime.consoleAPICalled" if parameters["type"] == "error" => {
            Some(parameters["args"].to_string())
        }
        "Log.entryAdded" if parameters["entry"]["level"] == "error" => {
            Some(parameters["entry"].to_string())
        }
        "Network.requestWillBeSent" => {
            let url = parameters["request"]["url"].as_str()?;
            let local =
                ["file:", "blob:", "data:", "about:"].iter().any(|start| url.starts_with(start));
            (!local).then(|| format!("it asked for {url}"))
        }
        _ => None,
    }
}
