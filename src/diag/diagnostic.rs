//! A fault as a value: what, where, why, and how to mend it.

use super::{Code, Span};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// Worth knowing; the picture is made all the same.
    Warning,
    /// There is no right picture.
    Error,
}

/// Words on a place in the user's text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// The place.
    pub span: Span,
    /// What is to be seen there.
    pub text: String,
}

/// One replacement in a text; an empty span inserts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// What is replaced.
    pub span: Span,
    /// What stands there afterwards.
    pub text: String,
}

/// A change that would mend the fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mend {
    /// The change in words, an imperative: "write `albedo`".
    pub title: String,
    /// The change itself.
    pub edits: Vec<Edit>,
    /// Whether it can be applied without a look: it keeps what was meant.
    pub safe: bool,
}

/// A fault. The headline stands alone; labels speak on the user's own text; `why` tells the
/// cause where the headline does not; `help` tells the mend.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Which fault it is; `scn explain CODE` tells more.
    pub code: Code,
    /// How bad.
    pub level: Level,
    /// The fault in one sentence, without a full stop.
    pub headline: String,
    /// Places, the one to look at first in front. None: the fault has no place in a text.
    pub labels: Vec<Label>,
    /// The cause.
    pub why: Option<String>,
    /// What to do.
    pub help: Option<String>,
    /// Changes a tool can make, the likeliest first.
    pub mends: Vec<Mend>,
}

impl Diagnostic {
    /// An error.
    pub fn error(code: Code, headline: impl Into<String>) -> Self {
        Self {
            code,
            level: Level::Error,
            headline: headline.into(),
            labels: Vec::new(),
            why: None,
            help: None,
            mends: Vec::new(),
        }
    }

    /// A warning.
    pub fn warning(code: Code, headline: impl Into<String>) -> Self {
        Self { level: Level::Warning, ..Self::error(code, headline) }
    }

    /// Adds a place; the first one added is where the fault is.
    pub fn label(mut self, span: Span, text: impl Into<String>) -> Self {
        self.labels.push(Label { span, text: text.into() });
        self
    }

    /// Tells the cause.
    pub fn why(mut self, text: impl Into<String>) -> Self {
        self.why = Some(text.into());
        self
    }

    /// Tells the mend.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Adds a change a tool can make: `span` replaced by `text`.
    pub fn mend(mut self, title: impl Into<String>, span: Span, text: impl Into<String>) -> Self {
        let edits = vec![Edit { span, text: text.into() }];
        self.mends.push(Mend { title: title.into(), edits, safe: false });
        self
    }

    /// Adds a change a tool can make without asking: it keeps what was meant, and every picture.
    pub fn safe_mend(self, title: impl Into<String>, span: Span, text: impl Into<String>) -> Self {
        let mut mended = self.mend(title, span, text);
        if let Some(mend) = mended.mends.last_mut() {
            mend.safe = true;
        }
        mended
    }

    /// Where the fault is.
    pub fn place(&self) -> Option<Span> {
        self.labels.first().map(|label| label.span)
    }
}
