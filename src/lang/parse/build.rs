//! pest's pairs → the tree. Tells the faults that the grammar accepts only to have them told.

use std::collections::HashSet;
use std::sync::Arc;

use super::{Pair, Rule, explain, strings};
use crate::diag::{Diagnostic, FileId, Span};
use crate::lang::ast::{
    Expr, ExprKind, File, For, Item, Let, Name, Piece, Render, Set, Setup, Without, Word,
};
use crate::lang::errors::syntax;
use crate::lang::faults::Faults;
use crate::lang::scan::Scanned;
use crate::math::units;

/// Builds trees of one text.
pub struct Builder<'t> {
    file: FileId,
    pub(super) source: &'t str,
    scanned: &'t Scanned,
    /// Where the text that is being built begins in the source.
    pub(super) offset: usize,
    semicolon_told: bool,
    broken_words: HashSet<String>,
    /// What is wrong.
    pub faults: Faults,
    /// How much was found wrong, what is not told included.
    found: usize,
    /// Parts of what is wrong, of which nothing more is to be told.
    pub muted: Vec<Span>,
}

impl<'t> Builder<'t> {
    /// A builder for `source`, which is `scanned`'s repaired text.
    pub fn new(file: FileId, source: &'t str, scanned: &'t Scanned) -> Self {
        Self {
            file,
            source,
            scanned,
            offset: 0,
            semicolon_told: false,
            broken_words: HashSet::new(),
            faults: Faults::default(),
            found: 0,
            muted: Vec::new(),
        }
    }

    /// Tells a fault, unless it stands where the text was repaired.
    pub(super) fn tell(&mut self, fault: Diagnostic) {
        self.found += 1;
        if !self.scanned.is_muted(&fault) {
            self.faults.push(fault);
        }
    }

    /// A place of the source in the text as given.
    pub fn place(&self, start: usize, end: usize) -> Span {
        Span::new(self.file, self.scanned.original(start), self.scanned.original(end))
    }

    /// From here on, places count from `at`; gives what [`Self::unshift`] wants.
    pub fn shift(&mut self, at: usize) -> usize {
        std::mem::replace(&mut self.offset, at)
    }

    /// Undoes [`Self::shift`].
    pub fn unshift(&mut self, outer: usize) {
        self.offset = outer;
    }

    /// Where a pair stands, without the blanks after it.
    pub(super) fn span(&self, pair: &Pair) -> Span {
        let start = self.offset + pair.as_span().start();
        self.place(start, start + code(pair.as_str()).len())
    }

    /// A file.
    pub fn file(&mut self, pair: Pair) -> File {
        let mut pairs = pair.into_inner().peekable();
        let mut tree = File::default();
        let top = Span::new(self.file, 0, 0);
        match pairs.next_if(|pair| pair.as_rule() == Rule::edition) {
            Some(edition) => {
                tree.first_line = Some(self.span(&edition));
                tree.unit = self.edition(edition);
            }
            None => self.tell(syntax::first_line(top)),
        }
        tree.items = self.items(pairs);
        tree.broken_words = std::mem::take(&mut self.broken_words);
        tree
    }

    /// The first line: gives the length of one bare coordinate.
    fn edition(&mut self, pair: Pair) -> Option<f64> {
        let span = self.span(&pair);
        let has_in = pair.as_str().split_whitespace().any(|word| word == "in");
        let mut pairs = pair.into_inner();
        let number = pairs.next();
        let edition = number.as_ref().filter(|n| n.as_rule() == Rule::number);
        match edition.map(|n| (n.as_str(), self.span(n))) {
            Some(("1", _)) => {}
            Some((other, span)) => self.tell(syntax::edition(other, span)),
            None => self.tell(syntax::first_line_number(span)),
        }
        let unit = number.into_iter().chain(pairs).find(|p| p.as_rule() == Rule::file_unit);
        let Some(unit) = unit else {
            if has_in {
                self.tell(syntax::file_unit("", span));
            }
            return None;
        };
        let span = self.span(&unit);
        let text = unit.as_str().to_string();
        let (mut factor, mut scale) = (1.0, None);
        for part in unit.into_inner() {
            match part.as_rule() {
                Rule::number => factor = self.number(&part),
                _ => scale = units::find(part.as_str()),
            }
        }
        let length = scale.filter(|u| u.dimension == units::Dimension::LENGTH);
        let metres = length.map(|unit| factor * unit.scale).filter(|m| *m > 0.0 && m.is_finite());
        if metres.is_none() {
            self.tell(syntax::file_unit(&text, span));
        }
        metres
    }

    fn items<'p>(&mut self, pairs: impl Iterator<Item = Pair<'p>>) -> Vec<Item> {
        let mut items = Vec::new();
        let mut last: Option<Span> = None;
        let mut last_end = 0;
        // How many faults there were before the last item.
        let mut before_last = 0;
        for pair in pairs {
            let rule = pair.as_rule();
            if matches!(rule, Rule::sep | Rule::EOI) {
                last = None;
                continue;
            }
            if rule == Rule::semicolon {
                self.semicolon(&pair);
                last = None;
                continue;
            }
            let span = self.span(&pair);
            let start = self.offset + pair.as_span().start();
            let end = start + code(pair.as_str()).len();
            let parted = last.is_none() || self.source[last_end..start].contains('\n');
            if !parted && rule != Rule::broken {
                let last = last.expect("not parted from it");
                match explain::dangling(self, start, last) {
                    Some(told) => {
                        // What was read as an item has lost its first word.
                        self.muted.push(span);
                        self.poison(pair.as_str());
                        self.tell(told);
                    }
                    None => self.tell(syntax::missing_separator(last, span, "item")),
                }
            }
            let faultless = self.found == before_last;
            before_last = self.found;
            if rule == Rule::broken {
                // No byte is passed over in silence: what follows an item on its line is told,
                // unless it may be a consequence of a fault in that item.
                self.broken(&pair, last.filter(|_| !parted), parted || faultless);
            } else {
                items.extend(self.item(pair));
            }
            (last, last_end) = (Some(span), end);
        }
        items
    }

    pub(super) fn semicolon(&mut self, pair: &Pair) {
        if !self.semicolon_told {
            let span = self.span(pair);
            let rest = self.source[span.range().end..].lines().next().unwrap_or("").trim_start();
            let parted = rest.is_empty() || rest.starts_with("//") || rest.starts_with('}');
            self.tell(syntax::semicolon(span, parted));
            self.semicolon_told = true;
        }
    }

    /// `=` for `:`, or the other way round.
    pub(super) fn wrong_equals(&mut self, found: char, pair: &Pair) {
        let span = self.span(pair);
        let blank = [' ', '\t'];
        let (before, after) =
            (&self.source[..span.range().start], &self.source[span.range().end..]);
        let before = before.len() - before.trim_end_matches(blank).len();
        let after = after.len() - after.trim_start_matches(blank).len();
        let place =
            Span { start: span.start - before as u32, end: span.end + after as u32, ..span };
        self.tell(syntax::wrong_equals(found, span, place));
    }

    /// Text that is no item, or follows the item `last` on its line.
    fn broken(&mut self, pair: &Pair, last: Option<Span>, tell: bool) {
        let text = pair.as_str();
        self.poison(text);
        if tell {
            let start = self.offset + pair.as_span().start();
            let told = match last {
                None => explain::item(self, code(text), start),
                Some(last) => explain::leftover(self, code(text), start, last),
            };
            self.tell(told);
        }
    }

    fn item(&mut self, pair: Pair) -> Option<Item> {
        let span = self.span(&pair);
        Some(match pair.as_rule() {
            Rule::r#use => {
                let string = pair.into_inner().nth(1)?;
                Item::Use(self.word(string))
            }
            Rule::let_ => self.let_(pair),
            Rule::for_ => {
                let mut inner = pair.into_inner().skip(1);
                let variable = self.word(inner.next()?);
                let head = self.head(inner.nth(1)?);
                let head_end = head.span;
                let body = self.items(inner.next()?.into_inner());
                let span = span.to(head_end);
                let span = Span { end: head_end.end, ..span };
                Item::For(Arc::new(For { variable, head: Arc::new(head), body, span }))
            }
            Rule::setup => {
                let (name, bases, body) = self.block(pair)?;
                let name = self.plain(name);
                Item::Setup(Arc::new(Setup { name, bases, body }))
            }
            Rule::render => {
                let (name, bases, body) = self.block(pair)?;
                Item::Render(Arc::new(Render { name, bases, body }))
            }
            Rule::without => {
                let mut inner = pair.into_inner().skip(1);
                let kind = self.word(inner.next()?);
                let name = self.name(inner.next()?);
                Item::Without(Arc::new(Without { kind, name, span }))
            }
            Rule::set => Item::Set(Arc::new(self.set(pair))),
            Rule::valueless => {
                let text = code(pair.as_str()).trim_end_matches([':', '=']).trim_end();
                self.tell(syntax::missing_value(text, span));
                self.poison(text);
                return None;
            }
            Rule::colonless => return self.colonless(pair),
            Rule::bodiless => {
                self.tell(syntax::missing_body(code(pair.as_str()), span));
                let mut inner = pair.into_inner();
                let is_render = inner.next()?.as_rule() == Rule::kw_render;
                let name = self.name(inner.next()?);
                let bases = inner.next().map_or_else(Vec::new, |bases| self.bases(bases));
                let body = Vec::new();
                match is_render {
                    true => Item::Render(Arc::new(Render { name, bases, body })),
                    false => {
                        let name = self.plain(name);
                        Item::Setup(Arc::new(Setup { name, bases, body }))
                    }
                }
            }
            _ => return None,
        })
    }

    /// Remembers the words of what could not be read.
    fn poison(&mut self, text: &str) {
        let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
        self.broken_words.extend(words.filter(|w| !w.is_empty()).take(1000).map(str::to_string));
    }

    fn let_(&mut self, pair: Pair) -> Item {
        let mut params = None;
        let mut inner = pair.into_inner().skip(1);
        let name = inner.next().map(|word| self.word(word)).expect("a let has a name");
        let mut value = None;
        for part in inner {
            match part.as_rule() {
                Rule::params => params = Some(part.into_inner().map(|w| self.word(w)).collect()),
                Rule::colon => self.wrong_equals(':', &part),
                Rule::equals => {}
                _ => value = Some(Arc::new(self.value(part))),
            }
        }
        Item::Let(Arc::new(Let { name, params, value: value.expect("a let has a value") }))
    }

    fn block<'p>(&mut self, pair: Pair<'p>) -> Option<(Name, Vec<Name>, Vec<Item>)> {
        let mut inner = pair.into_inner().skip(1).peekable();
        let name = self.name(inner.next()?);
        let bases = inner.next_if(|p| p.as_rule() == Rule::bases);
        let bases = bases.map_or_else(Vec::new, |bases| self.bases(bases));
        let body = self.items(inner.next()?.into_inner());
        Some((name, bases, body))
    }

    fn bases(&mut self, pair: Pair) -> Vec<Name> {
        let names = pair.into_inner().filter_map(|base| base.into_inner().next());
        names.collect::<Vec<_>>().into_iter().map(|name| self.name(name)).collect()
    }

    /// `path: value`
    pub fn set(&mut self, pair: Pair) -> Set {
        let mut inner = pair.into_inner();
        let path = inner.next().expect("a path");
        let (span, kind, name, parts) = self.path(path);
        let colon = inner.next().expect("a colon");
        if colon.as_rule() == Rule::equals {
            self.wrong_equals('=', &colon);
        }
        let value = self.value(inner.next().expect("a value"));
        Set { kind, name, parts, value: Arc::new(value), path: span }
    }

    fn path(&mut self, pair: Pair) -> (Span, Word, Option<Name>, Vec<Word>) {
        let span = self.span(&pair);
        let text = pair.as_str();
        let start = pair.as_span().start();
        let mut inner = pair.into_inner().peekable();
        let kind = self.word(inner.next().expect("a kind"));
        // A name follows blanks, a part follows a dot.
        let mut name = None;
        let mut parts = Vec::new();
        let mut dotted = text.len();
        for part in inner {
            let at = part.as_span().start() - start;
            let after_dot = text[..at].trim_end().ends_with('.');
            if after_dot {
                dotted = dotted.min(at);
                parts.push(self.word(part));
            } else {
                name = Some(self.name(part));
            }
        }
        (span, kind, name, parts)
    }

    fn colonless(&mut self, pair: Pair) -> Option<Item> {
        let mut inner = pair.into_inner();
        let (span, kind, name, parts) = self.path(inner.next()?);
        let next = inner.next()?;
        let next_span = self.span(&next);
        let named =
            crate::scene::KINDS.iter().find(|k| k.word == &*kind.text).is_none_or(|k| k.named);
        let (word, name, entries, at) = match next.as_rule() {
            Rule::word => (Some(self.word(next)), name, inner.next()?, span),
            // `camera perspective { … }`: the name is the variant of a kind without names.
            _ => match name {
                Some(name) if !named => {
                    let word = self.plain(name);
                    (Some(word), None, next, kind.span)
                }
                name => (None, name, next, span),
            },
        };
        self.tell(syntax::missing_colon(&kind.text, at.after()));
        let record = self.record(word, entries);
        let span = next_span.to(record.braces);
        let value = Arc::new(Expr { kind: ExprKind::Record(Arc::new(record)), span });
        Some(Item::Set(Arc::new(Set { kind, name, parts, value, path: at })))
    }

    /// A word, or a string that stands for one.
    pub(super) fn word(&mut self, pair: Pair) -> Word {
        let name = self.name(pair);
        self.plain(name)
    }

    /// A name that holds no values.
    fn plain(&mut self, name: Name) -> Word {
        let text = match &*name.pieces {
            [Piece::Words(words)] => Arc::from(words.as_str()),
            _ => {
                self.tell(syntax::fixed_name(name.span));
                Arc::from("")
            }
        };
        Word { text, span: name.span }
    }

    pub(super) fn name(&mut self, pair: Pair) -> Name {
        let span = self.span(&pair);
        let pair = match pair.as_rule() {
            Rule::name => pair.into_inner().next().expect("a name"),
            _ => pair,
        };
        let pieces = match pair.as_rule() {
            Rule::string => self.string(&pair),
            _ => vec![Piece::Words(pair.as_str().trim_end().to_string())],
        };
        Name { pieces: pieces.into(), span }
    }

    pub(super) fn string(&mut self, pair: &Pair) -> Vec<Piece> {
        let text = pair.as_str();
        let start = self.offset + pair.as_span().start();
        strings::pieces(self, &text[1..text.len() - 1], start + 1)
    }
}

/// A text without the blanks and comments that end it.
pub(super) fn code(text: &str) -> &str {
    let text = text.trim_end();
    if !text.contains("//") {
        return text;
    }
    let (mut end, mut at, mut quoted) = (0, 0, false);
    let bytes = text.as_bytes();
    while at < bytes.len() {
        match bytes[at] {
            b'\\' if quoted => at += 1,
            b'"' => quoted = !quoted,
            b'\n' => quoted = false,
            b'/' if !quoted && bytes.get(at + 1) == Some(&b'/') => {
                at += bytes[at..].iter().position(|b| *b == b'\n').unwrap_or(bytes.len() - at);
                continue;
            }
            _ => {}
        }
        if !bytes[at.min(bytes.len() - 1)].is_ascii_whitespace() {
            end = at + 1;
        }
        at += 1;
    }
    // Only ASCII ends a form of the language; anything else ends where the text does.
    text.get(..end).unwrap_or(text)
}
