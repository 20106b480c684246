//! HTML in which text cannot become markup: whatever is put into a template is escaped on its way.
//!
//! Everything that a folder holds may be forged. [`Html`] is therefore made of templates of this program, of escaped text
//! and of packed bytes; there is no way to make it of any other string.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// Markup.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Html(String);

/// What can be put into a template.
pub(super) trait Piece {
    /// Adds it to markup, text escaped.
    fn put(&self, markup: &mut String);
}

/// A template with pieces in place of its `{}`, in their order.
pub(super) fn fill(template: &'static str, pieces: &[&dyn Piece]) -> Html {
    let mut markup = String::new();
    let mut pieces = pieces.iter();
    for (place, part) in template.split("{}").enumerate() {
        if place > 0 {
            pieces.next().into_iter().for_each(|piece| piece.put(&mut markup));
        }
        markup += part;
    }
    Html(markup)
}

impl Html {
    /// A text of this program, as it stands.
    pub(super) fn constant(text: &'static str) -> Self {
        Self(text.to_owned())
    }

    /// Bytes in base 64, which has no letters of markup.
    pub(super) fn packed(bytes: &[u8]) -> Self {
        Self(STANDARD.encode(bytes))
    }

    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    pub(super) fn as_str(&self) -> &str {
        &self.0
    }
}

impl Piece for str {
    fn put(&self, markup: &mut String) {
        for letter in self.chars() {
            match letter {
                '&' => *markup += "&amp;",
                '<' => *markup += "&lt;",
                '>' => *markup += "&gt;",
                '"' => *markup += "&quot;",
                '\'' => *markup += "&#39;",
                plain => markup.push(plain),
            }
        }
    }
}

impl Piece for String {
    fn put(&self, markup: &mut String) {
        self.as_str().put(markup);
    }
}

impl Piece for Html {
    fn put(&self, markup: &mut String) {
        *markup += &self.0;
    }
}

impl Piece for usize {
    fn put(&self, markup: &mut String) {
        *markup += &self.to_string();
    }
}

impl<T: Piece + ?Sized> Piece for &T {
    fn put(&self, markup: &mut String) {
        (**self).put(markup);
    }
}

impl std::ops::AddAssign for Html {
    fn add_assign(&mut self, other: Self) {
        self.0 += &other.0;
    }
}

impl std::ops::Add for Html {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl FromIterator<Html> for Html {
    fn from_iter<I: IntoIterator<Item = Html>>(all: I) -> Self {
        Self(all.into_iter().map(|one| one.0).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::{Html, fill};

    #[test]
    fn text_stays_text_and_markup_stays_markup() {
        let hostile = "\"><img src=x onerror='a()'> & {}";
        let inner = fill("<b title=\"{}\">{}</b>", &[&hostile, &7_usize]);
        assert_eq!(
            inner.as_str(),
            "<b title=\"&quot;&gt;&lt;img src=x onerror=&#39;a()&#39;&gt; &amp; {}\">7</b>"
        );
        let outer = fill("<p>{}</p>", &[&inner]);
        assert_eq!(outer.as_str(), format!("<p>{}</p>", inner.as_str()));
        let all: Html = [outer.clone(), Html::constant("<hr>")].into_iter().collect();
        assert_eq!(all, outer + Html::constant("<hr>"));
    }
}
