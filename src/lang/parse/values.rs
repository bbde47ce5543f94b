//! pest's pairs → values.

use std::sync::Arc;

use super::build::{Builder, code};
use super::{Pair, Rule, explain};
use crate::diag::Span;
use crate::lang::ast::{Entry, Expr, ExprKind, Operator, Quantity, Record, Word};
use crate::lang::errors::{name, syntax};
use crate::math::units;

impl Builder<'_> {
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
    pub(super) fn head(&mut self, pair: Pair) -> Expr {
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
            self.tell(syntax::exponent(text, span));
            1
        })
    }

    fn atom(&mut self, pair: Pair) -> Expr {
        let span = self.span(&pair);
        let kind = match pair.as_rule() {
            Rule::malformed => {
                let text = pair.as_str().trim_end();
                self.tell(syntax::number_form(text, span));
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
            self.tell(syntax::clock(text, span));
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
        if matches!(unit.as_rule(), Rule::unknown_unit | Rule::strange_unit) {
            self.tell(name::unknown_unit(unit.as_str(), self.span(&unit)));
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

    pub(super) fn number(&mut self, pair: &Pair) -> f64 {
        let text = pair.as_str().trim_end();
        let value: f64 = text.replace('_', "").parse().unwrap_or(f64::INFINITY);
        if value.is_finite() {
            return value;
        }
        self.tell(syntax::number_too_large(text, self.span(pair)));
        1.0
    }

    pub(super) fn record(&mut self, word: Option<Word>, pair: Pair) -> Record {
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
                        self.tell(syntax::missing_separator(last, span, "field"));
                    }
                    last = Some((span, end));
                    record.partial |= !self.entry(part, &mut record.entries);
                }
                Rule::entry_valueless => {
                    let text = code(part.as_str()).trim_end_matches([':', '=']).trim_end();
                    self.tell(syntax::missing_value(text, span));
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
                            self.tell(told);
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
        let (key, quantity) = match key.as_rule() {
            Rule::wavelength => {
                let span = self.span(&key);
                let text = Arc::from(code(key.as_str()));
                let ExprKind::Number { value, unit } = self.quantity(key) else { return false };
                (Word { text, span }, Some(Quantity { value, unit }))
            }
            _ => (self.word(key), None),
        };
        for part in inner {
            match part.as_rule() {
                Rule::name => {
                    let span = self.span(&part);
                    self.tell(syntax::path_in_record(&key.text, part.as_str(), span));
                    return false;
                }
                Rule::equals => {
                    self.wrong_equals('=', &part);
                }
                Rule::value => {
                    let value = Arc::new(self.value(part));
                    entries.push(Entry { key, quantity, value });
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
