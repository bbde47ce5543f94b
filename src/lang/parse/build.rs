//! pest's pairs → the tree. Tells the faults that the grammar accepts only to have them told.

use std::sync::Arc;

use super::{Pair, Rule, explain, strings};
use crate::diag::{Diagnostic, FileId, Span};
use crate::lang::ast::{
    Entry, Expr, ExprKind, File, For, Item, Let, Name, Operator, Piece, Record, Render, Set, Setup,
    Without, Word,
};
use crate::lang::errors::{name, syntax};
use crate::lang::scan::Scanned;
use crate::math::units;

/// Builds trees of one text.
pub struct Builder<'t> {
    file: FileId,
    source: &'t str,
    scanned: &'t Scanned,
    /// Where the text that is being built begins in the source.
    offset: usize,
    semicolon_told: bool,
    broken_words: Vec<String>,
    /// What is wrong.
    pub diagnostics: Vec<Diagnostic>,
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
            broken_words: Vec::new(),
            diagnostics: Vec::new(),
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
    fn span(&self, pair: &Pair) -> Span {
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
            None => self.diagnostics.push(syntax::first_line(top)),
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
            Some((other, span)) => self.diagnostics.push(syntax::edition(other, span)),
            None => self.diagnostics.push(syntax::first_line_number(span)),
        }
        let unit = number.into_iter().chain(pairs).find(|p| p.as_rule() == Rule::file_unit);
        let Some(unit) = unit else {
            if has_in {
                self.diagnostics.push(syntax::file_unit("", span));
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
            self.diagnostics.push(syntax::file_unit(&text, span));
        }
        metres
    }

    fn items<'p>(&mut self, pairs: impl Iterator<Item = Pair<'p>>) -> Vec<Item> {
        let mut items = Vec::new();
        let mut last: Option<Span> = None;
        let mut last_end = 0;
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
                self.diagnostics.push(syntax::missing_separator(last, span, "item"));
            }
            (last, last_end) = (Some(span), end);
            items.extend(self.item(pair, parted));
        }
        items
    }

    fn semicolon(&mut self, pair: &Pair) {
        if !self.semicolon_told {
            self.diagnostics.push(syntax::semicolon(self.span(pair)));
            self.semicolon_told = true;
        }
    }

    fn item(&mut self, pair: Pair, parted: bool) -> Option<Item> {
        let span = self.span(&pair);
        Some(match pair.as_rule() {
            Rule::broken => {
                let text = pair.as_str();
                self.poison(text);
                if parted {
                    let start = self.offset + pair.as_span().start();
                    let told = explain::item(self, code(text), start);
                    self.diagnostics.push(told);
                }
                return None;
            }
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
                self.diagnostics.push(syntax::missing_value(text, span));
                self.poison(text);
                return None;
            }
            Rule::colonless => return self.colonless(pair),
            Rule::bodiless => {
                self.diagnostics.push(syntax::missing_body(code(pair.as_str()), span));
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
                Rule::colon => self.diagnostics.push(syntax::wrong_equals(':', self.span(&part))),
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
            self.diagnostics.push(syntax::wrong_equals('=', self.span(&colon)));
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
        self.diagnostics.push(syntax::missing_colon(&kind.text, at.after()));
        let record = self.record(word, entries);
        let span = next_span.to(record.braces);
        let value = Arc::new(Expr { kind: ExprKind::Record(Arc::new(record)), span });
        Some(Item::Set(Arc::new(Set { kind, name, parts, value, path: at })))
    }

    /// A word, or a string that stands for one.
    fn word(&mut self, pair: Pair) -> Word {
        let name = self.name(pair);
        self.plain(name)
    }

    /// A name that holds no values.
    fn plain(&mut self, name: Name) -> Word {
        let text = match &*name.pieces {
            [Piece::Words(words)] => Arc::from(words.as_str()),
            _ => {
                self.diagnostics.push(syntax::fixed_name(name.span));
                Arc::from("")
            }
        };
        Word { text, span: name.span }
    }

    fn name(&mut self, pair: Pair) -> Name {
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

    fn string(&mut self, pair: &Pair) -> Vec<Piece> {
        let text = pair.as_str();
        let start = self.offset + pair.as_span().start();
        strings::pieces(self, &text[1..text.len() - 1], start + 1)
    }

    /// A value.
    pub fn value(&mut self, pair: Pair) -> Expr {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let first = self.sum(inner.next().expect("a sum"));
        let mut changes = Vec::new();
        let mut sums = Vec::new();
        for part in inner {
            match part.as_rule() {
                Rule::entries => changes.push(self.record(None, part)),
                Rule::sum => sums.push(Arc::new(self.sum(part))),
                _ => {}
            }
        }
        if !changes.is_empty() {
            let kind = ExprKind::With { base: Arc::new(first), changes: changes.into() };
            return Expr { kind, span };
        }
        range(first, sums, span)
    }

    /// What a loop runs over.
    fn head(&mut self, pair: Pair) -> Expr {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let first = inner.next().expect("a head");
        let first = match first.as_rule() {
            Rule::list => self.atom(first),
            _ => self.sum(first),
        };
        let sums = inner.filter(|p| p.as_rule() == Rule::sum_of_head).collect::<Vec<_>>();
        let sums = sums.into_iter().map(|sum| Arc::new(self.sum(sum))).collect();
        range(first, sums, span)
    }

    /// A sum or a product.
    fn sum(&mut self, pair: Pair) -> Expr {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let first = self.operand(inner.next().expect("an operand"));
        let mut rest = Vec::new();
        while let (Some(operator), Some(operand)) = (inner.next(), inner.next()) {
            let place = self.span(&operator);
            let operator = match operator.as_str().trim() {
                "+" => Operator::Add,
                "-" => Operator::Subtract,
                "*" => Operator::Multiply,
                _ => Operator::Divide,
            };
            rest.push((operator, place, self.operand(operand)));
        }
        if rest.is_empty() {
            return first;
        }
        Expr { kind: ExprKind::Chain { first: Arc::new(first), rest: rest.into() }, span }
    }

    fn operand(&mut self, pair: Pair) -> Expr {
        match pair.as_rule() {
            Rule::product | Rule::product_of_head => self.sum(pair),
            _ => self.unary(pair),
        }
    }

    fn unary(&mut self, pair: Pair) -> Expr {
        let span = self.span(&pair);
        let mut negative = false;
        let mut value = None;
        for part in pair.into_inner() {
            match part.as_rule() {
                Rule::sign => negative ^= part.as_str().trim() == "-",
                Rule::power => {
                    let base: Expr = value.take().expect("an atom before its power");
                    let text = part.as_str().trim_start_matches('^').trim();
                    let exponent = self.exponent(text, self.span(&part));
                    let span = base.span.to(self.span(&part));
                    value = Some(Expr { kind: ExprKind::Power(Arc::new(base), exponent), span });
                }
                _ => value = Some(self.atom(part)),
            }
        }
        let value = value.expect("an atom");
        match (negative, &value.kind) {
            (false, _) => value,
            (true, ExprKind::Number { value: x, unit }) => {
                Expr { kind: ExprKind::Number { value: -x, unit: *unit }, span }
            }
            _ => Expr { kind: ExprKind::Negated(Arc::new(value)), span },
        }
    }

    fn exponent(&mut self, text: &str, span: Span) -> i8 {
        let exponent = text.replace('_', "").parse().ok().filter(|e: &i8| e.abs() <= 16);
        exponent.unwrap_or_else(|| {
            self.diagnostics.push(syntax::exponent(text, span));
            1
        })
    }

    fn atom(&mut self, pair: Pair) -> Expr {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::malformed => {
                let text = pair.as_str().trim_end();
                self.diagnostics.push(syntax::number_form(text, span));
                ExprKind::Broken
            }
            Rule::clock => self.clock(pair.as_str().trim_end(), span),
            Rule::quantity => self.quantity(pair),
            Rule::string => ExprKind::Text(self.string(&pair).into()),
            Rule::group => {
                let mut all: Vec<_> = pair.into_inner().map(|value| self.value(value)).collect();
                match all.len() {
                    1 => return Expr { span, ..all.remove(0) },
                    _ => ExprKind::Vector(all.into()),
                }
            }
            Rule::list => {
                ExprKind::List(pair.into_inner().map(|value| self.value(value)).collect())
            }
            Rule::call => {
                let mut inner = pair.into_inner();
                let function = self.dotted(inner.next().expect("a function"));
                let arguments = inner.map(|value| self.value(value)).collect();
                ExprKind::Call { function, arguments }
            }
            Rule::record => {
                let mut inner = pair.into_inner();
                let word = self.word(inner.next().expect("a word"));
                let entries = inner.next().expect("entries");
                ExprKind::Record(Arc::new(self.record(Some(word), entries)))
            }
            Rule::entries => ExprKind::Record(Arc::new(self.record(None, pair))),
            _ => ExprKind::Name(self.dotted(pair)),
        };
        Expr { kind, span }
    }

    fn dotted(&mut self, pair: Pair) -> Vec<Word> {
        pair.into_inner().map(|word| self.word(word)).collect()
    }

    fn clock(&mut self, text: &str, span: Span) -> ExprKind {
        let (hours, minutes) = text.split_once(':').expect("a clock value has a colon");
        let (hours, minutes): (f64, f64) =
            (hours.parse().unwrap_or(f64::NAN), minutes.parse().unwrap_or(f64::NAN));
        if !(hours <= 24.0 && minutes < 60.0) {
            self.diagnostics.push(syntax::clock(text, span));
            return ExprKind::Broken;
        }
        ExprKind::Number { value: hours + minutes / 60.0, unit: units::find("h").map(|h| (h, 1)) }
    }

    fn quantity(&mut self, pair: Pair) -> ExprKind {
        let mut inner = pair.into_inner();
        let value = self.number(&inner.next().expect("a number"));
        let Some(unit) = inner.next() else {
            return ExprKind::Number { value, unit: None };
        };
        if unit.as_rule() == Rule::unknown_unit {
            self.diagnostics.push(name::unknown_unit(unit.as_str(), self.span(&unit)));
            return ExprKind::Broken;
        }
        let mut parts = unit.into_inner();
        let word = parts.next().expect("a unit");
        let exponent = match parts.next() {
            Some(exponent) => self.exponent(exponent.as_str(), self.span(&exponent)),
            None => 1,
        };
        let unit = units::find(word.as_str().trim_end()).map(|unit| (unit, exponent));
        ExprKind::Number { value, unit }
    }

    fn number(&mut self, pair: &Pair) -> f64 {
        let text = pair.as_str().trim_end();
        let value: f64 = text.replace('_', "").parse().unwrap_or(f64::INFINITY);
        if value.is_finite() {
            return value;
        }
        self.diagnostics.push(syntax::number_too_large(text, self.span(pair)));
        1.0
    }

    fn record(&mut self, word: Option<Word>, pair: Pair) -> Record {
        let braces = self.span(&pair);
        let mut record = Record { word, entries: Vec::new(), braces, partial: false };
        let mut last: Option<(Span, usize)> = None;
        for part in pair.into_inner() {
            let span = self.span(&part);
            let start = self.offset + part.as_span().start();
            let end = start + code(part.as_str()).len();
            match part.as_rule() {
                Rule::sep => last = None,
                Rule::semicolon => {
                    self.semicolon(&part);
                    last = None;
                }
                Rule::entry => {
                    if let Some((last, last_end)) = last
                        && !self.source[last_end..start].contains('\n')
                    {
                        self.diagnostics.push(syntax::missing_separator(last, span, "field"));
                    }
                    last = Some((span, end));
                    record.partial |= !self.entry(part, &mut record.entries);
                }
                Rule::entry_valueless => {
                    let text = code(part.as_str()).trim_end_matches([':', '=']).trim_end();
                    self.diagnostics.push(syntax::missing_value(text, span));
                    record.partial = true;
                    last = None;
                }
                _ => {
                    // It may only stand before something broken.
                    let outer = self.shift(start);
                    let text = code(part.as_str());
                    let whole = match explain::entry_alone(text) {
                        Some(entry) => self.entry(entry, &mut record.entries),
                        None => {
                            let told = explain::entry(self, text, start);
                            self.diagnostics.push(told);
                            false
                        }
                    };
                    self.unshift(outer);
                    record.partial |= !whole;
                    last = None;
                }
            }
        }
        record
    }

    /// A field; false if it cannot be one.
    fn entry(&mut self, pair: Pair, entries: &mut Vec<Entry>) -> bool {
        let mut inner = pair.into_inner();
        let key = inner.next().expect("a key");
        if key.as_rule() == Rule::quantity {
            let span = self.span(&key);
            self.diagnostics.push(syntax::number_key(key.as_str().trim_end(), span));
            return false;
        }
        let key = self.word(key);
        for part in inner {
            match part.as_rule() {
                Rule::name => {
                    let span = self.span(&part);
                    self.diagnostics.push(syntax::path_in_record(&key.text, part.as_str(), span));
                    return false;
                }
                Rule::equals => {
                    self.diagnostics.push(syntax::wrong_equals('=', self.span(&part)));
                }
                Rule::value => {
                    let value = Arc::new(self.value(part));
                    entries.push(Entry { key, value });
                    return true;
                }
                _ => {}
            }
        }
        false
    }
}

/// `from`, or `from to … step …`.
fn range(from: Expr, sums: Vec<Arc<Expr>>, span: Span) -> Expr {
    let mut sums = sums.into_iter();
    match sums.next() {
        None => from,
        Some(to) => {
            let kind = ExprKind::Range { from: Arc::new(from), to, step: sums.next() };
            Expr { kind, span }
        }
    }
}

/// A text without the blanks and comments that end it.
fn code(text: &str) -> &str {
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
