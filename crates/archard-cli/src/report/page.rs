//! Pieces of a page in HTML.

use std::fmt::Write;

/// A table: what it shows, the heads of its columns, and its rows; the first cell of a row names it.
pub(super) struct Table {
    pub(super) caption: String,
    pub(super) heads: Vec<&'static str>,
    pub(super) rows: Vec<Vec<String>>,
}

/// Text as it may stand in HTML.
pub(super) fn escape(text: &str) -> String {
    [("&", "&amp;"), ("<", "&lt;"), (">", "&gt;"), ("\"", "&quot;")]
        .iter()
        .fold(text.to_owned(), |text, (plain, escaped)| text.replace(plain, escaped))
}

/// A section under its heading, or nothing where there is nothing in it.
pub(super) fn section(id: &str, heading: &str, body: &str) -> String {
    if body.is_empty() {
        return String::new();
    }
    let heading = escape(heading);
    format!(
        "<section id=\"{id}\" aria-labelledby=\"{id}-h\"><h2 id=\"{id}-h\">{heading}</h2>\n{body}</section>\n"
    )
}

impl Table {
    /// The table in HTML; cells are text. Nothing where it has no rows.
    pub(super) fn html(&self) -> String {
        if self.rows.is_empty() {
            return String::new();
        }
        let mut html =
            String::from("<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"");
        let _ = write!(
            html,
            "{}\"><table><caption>{}</caption><thead><tr>",
            escape(&self.caption),
            escape(&self.caption)
        );
        for head in &self.heads {
            let _ = write!(html, "<th scope=\"col\">{}</th>", escape(head));
        }
        html.push_str("</tr></thead><tbody>\n");
        for row in &self.rows {
            html.push_str("<tr>");
            for (place, cell) in row.iter().enumerate() {
                let cell = escape(cell);
                let _ = match place {
                    0 => write!(html, "<th scope=\"row\">{cell}</th>"),
                    _ => write!(html, "<td>{cell}</td>"),
                };
            }
            html.push_str("</tr>\n");
        }
        html + "</tbody></table></div>\n"
    }
}

/// A list of paragraphs of text.
pub(super) fn list(items: &[String]) -> String {
    if items.is_empty() {
        return String::new();
    }
    let items: String = items.iter().map(|item| format!("<li>{}</li>\n", escape(item))).collect();
    format!("<ul>\n{items}</ul>\n")
}

#[cfg(test)]
mod tests {
    use super::{Table, escape};

    #[test]
    fn names_cannot_leave_their_cells() {
        assert_eq!(escape("<b>\"a\" & c"), "&lt;b&gt;&quot;a&quot; &amp; c");
        let table = Table {
            caption: "a < b".to_owned(),
            heads: vec!["what"],
            rows: vec![vec!["</td><script>".to_owned()]],
        };
        let html = table.html();
        assert!(html.contains("<caption>a &lt; b</caption>"), "{html}");
        assert!(html.contains("<th scope=\"row\">&lt;/td&gt;&lt;script&gt;</th>"), "{html}");
        assert_eq!(Table { rows: vec![], ..table }.html(), "");
    }
}
