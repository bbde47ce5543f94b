//! Expressions → values. Pure; names are looked up where an expression was written.

use std::cell::{Cell, RefCell};
use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::Arc;

use super::arithmetic;
use super::ast::{Expr, ExprKind, Let, Name, Piece, Record, Word};
use super::data_file::DataFiles;
use super::errors::{name as names, render, types};
use super::report::Reports;
use super::value::{Binding, Bound, Env, FieldValue, Frame, RecordValue, Thunk, Value, ValueKind};
use super::{functions, limits, ranges, shelves, spectra};
use crate::diag::{FileId, Span};
use crate::math::units::{self, Dimension};

/// What the evaluator knows of a file.
#[derive(Clone, Debug, Default)]
pub struct FileFacts {
    /// Its folder: names of files are relative to it.
    pub folder: PathBuf,
    /// What it says.
    pub text: Arc<str>,
    /// Metres of a bare coordinate.
    pub unit: Option<f64>,
    /// The place of its first line, to tell about a missing unit.
    pub first_line: Option<Span>,
}

/// Computes values and counts what that costs.
#[derive(Default)]
pub struct Evaluator<'l> {
    /// Where faults are told.
    pub reports: Reports,
    /// The files that values are taken from.
    pub data: DataFiles<'l>,
    files: HashMap<FileId, FileFacts>,
    /// Files whose missing unit was told.
    unitless: RefCell<HashSet<FileId>>,
    frames: RefCell<Vec<Rc<Frame>>>,
    items: Cell<usize>,
    depth: Cell<usize>,
}

impl Drop for Evaluator<'_> {
    /// Frames hold lets that hold frames; this parts them.
    fn drop(&mut self) {
        self.frames.borrow().iter().for_each(|frame| frame.names.borrow_mut().clear());
    }
}

/// Expressions inside each other, names and calls included, before an error is told: deep enough
/// for [`limits::DEPTH`] brackets, shallow enough for the stack.
const NESTING: usize = 6 * limits::DEPTH;

impl Evaluator<'_> {
    /// Makes a file known.
    pub fn add_file(&mut self, file: FileId, facts: FileFacts) {
        self.files.insert(file, facts);
    }

    /// The folder names of files in a text are relative to.
    pub fn folder(&self, file: FileId) -> &Path {
        self.files.get(&file).map_or(Path::new(""), |facts| &facts.folder)
    }

    /// The words at a place.
    pub fn written(&self, span: Span) -> Option<&str> {
        self.files.get(&span.file)?.text.get(span.range())
    }

    /// Metres of a bare coordinate in a file; tells if its first line does not say.
    pub fn unit(&self, file: FileId, span: Span) -> Option<f64> {
        let facts = self.files.get(&file)?;
        // Once a file; a first line that is not there was told.
        if facts.unit.is_none()
            && facts.first_line.is_some()
            && self.unitless.borrow_mut().insert(file)
        {
            self.reports.tell(types::no_file_unit(span, facts.first_line));
        }
        facts.unit
    }

    /// New names inside `outer`.
    pub fn frame(&self, outer: Option<&Env>) -> Env {
        let frame = Rc::new(Frame { names: RefCell::default(), outer: outer.cloned() });
        self.frames.borrow_mut().push(frame.clone());
        Env(frame)
    }

    /// Everything that was defined and may be used, loops' variables and lets of bodies included.
    pub fn bindings(&self) -> Vec<Rc<Binding>> {
        let frames = self.frames.borrow();
        frames
            .iter()
            .flat_map(|frame| frame.names.borrow().values().cloned().collect::<Vec<_>>())
            .collect()
    }

    /// Defines a name; tells if it is taken.
    pub fn define(&self, env: &Env, name: &Word, what: Bound) {
        let what = match reserved(&name.text) {
            Some(reserved) => {
                self.reports.tell(names::taken(name, reserved));
                Bound::Broken
            }
            None => what,
        };
        if let Some(other) = env.find(&name.text) {
            return self.reports.tell(names::defined_twice("name", name, other.name.span));
        }
        let binding = Rc::new(Binding { name: name.clone(), what });
        env.0.names.borrow_mut().insert(name.text.clone(), binding);
    }

    /// Whether the limit of work is reached: nothing is worth going on for.
    pub fn spent(&self) -> bool {
        self.items.get() >= limits::ITEMS
    }

    /// Counts a piece of work; false once the limit is reached.
    pub fn spend(&self, span: Span) -> bool {
        self.spend_many(1, span)
    }

    /// Counts a piece of work that costs as much as so many values.
    pub fn spend_many(&self, values: usize, span: Span) -> bool {
        let before = self.items.get();
        self.items.set(before.saturating_add(values));
        if before < limits::ITEMS && self.items.get() >= limits::ITEMS {
            self.reports.tell(render::too_many_items(span));
        }
        self.items.get() < limits::ITEMS
    }

    /// The value of an expression.
    pub fn eval(&self, expr: &Expr, env: &Env) -> Value {
        if !self.spend(expr.span) {
            return Value::broken(expr.span);
        }
        self.depth.set(self.depth.get() + 1);
        let value = if self.depth.get() > NESTING {
            self.reports.tell(types::too_deep(expr.span));
            Value::broken(expr.span)
        } else {
            self.eval_kind(expr, env)
        };
        self.depth.set(self.depth.get() - 1);
        value
    }

    fn eval_kind(&self, expr: &Expr, env: &Env) -> Value {
        let span = expr.span;
        let kind = match &expr.kind {
            ExprKind::Number { value, unit: None } => {
                ValueKind::Number { value: *value, dimension: Dimension::NONE, unit: None }
            }
            ExprKind::Number { value, unit: Some((unit, exponent)) } => {
                let value = value * unit.scale.powi(i32::from(*exponent));
                let dimension = unit.dimension.power(*exponent);
                let number = ValueKind::Number { value, dimension, unit: Some(unit) };
                return self.finite(Value { kind: number, span });
            }
            ExprKind::Text(pieces) => match self.text(pieces, env) {
                Some(text) => ValueKind::Text { text: text.into(), file: span.file },
                None => ValueKind::Broken,
            },
            ExprKind::Vector(all) if all.len() > 3 => {
                self.reports.tell(types::long_vector(all.len(), span));
                ValueKind::Broken
            }
            ExprKind::Vector(all) => {
                let components: Rc<[_]> = all.iter().map(|e| self.eval(e, env)).collect();
                ValueKind::Vector { components, file: span.file }
            }
            ExprKind::List(all) if all.len() > limits::ELEMENTS => {
                self.reports.tell(render::too_many_elements(span));
                ValueKind::Broken
            }
            ExprKind::List(all) => ValueKind::List(all.iter().map(|e| self.eval(e, env)).collect()),
            ExprKind::Call { function, arguments } => {
                return self.call(function, arguments, env, span);
            }
            ExprKind::Record(record) => ValueKind::Record(Rc::new(fields(record, env))),
            ExprKind::Name(path) => return self.named(path, env, span),
            ExprKind::Negated(inner) => {
                return arithmetic::negated(self, self.eval(inner, env), span);
            }
            ExprKind::Chain { first, rest } => {
                let mut value = self.operand(first, env);
                for (operator, place, right) in rest.iter() {
                    let right = self.operand(right, env);
                    let span = expr.span;
                    value = arithmetic::binary(self, value, *operator, *place, right, span);
                }
                return value;
            }
            ExprKind::Power(base, exponent) => {
                return arithmetic::power(self, self.eval(base, env), *exponent, span);
            }
            ExprKind::With { base, changes } => {
                let base = self.eval(base, env);
                return self.with(base, changes, env, span);
            }
            ExprKind::Range { from, to, step } => {
                let step = step.as_ref().map(|step| self.eval(step, env));
                return ranges::range(self, self.eval(from, env), self.eval(to, env), step, span);
            }
            ExprKind::Broken => ValueKind::Broken,
        };
        Value { kind, span }
    }

    /// The value of an expression that no place gives a meaning: a word written in it must be
    /// known here, while one that comes from a let or a loop stays the word it is.
    fn operand(&self, expr: &Expr, env: &Env) -> Value {
        let value = self.eval(expr, env);
        let (ExprKind::Name(path), ValueKind::Word(word)) = (&expr.kind, &value.kind) else {
            return value;
        };
        if matches!(path.as_slice(), [word] if env.find(&word.text).is_some()) {
            return value;
        }
        arithmetic::known(&word.text, expr.span).unwrap_or_else(|| {
            self.reports.tell_unknown_with(&word.text, expr.span, || {
                names::unknown_value(&word.text, expr.span, &env.all())
            });
            Value::broken(expr.span)
        })
    }

    /// The value, told if it is infinite or no number.
    pub fn finite(&self, value: Value) -> Value {
        let finite = match &value.kind {
            ValueKind::Number { value, .. } => value.is_finite(),
            ValueKind::Colour(components, _) => components.iter().all(|c| c.is_finite()),
            ValueKind::Spectrum(spectrum, _) => spectra::is_finite(spectrum),
            _ => true,
        };
        if finite {
            return value;
        }
        self.reports.tell(types::not_finite(value.span));
        Value::broken(value.span)
    }

    /// The value of a field.
    pub fn force(&self, thunk: &Thunk) -> Value {
        match thunk {
            Thunk::Lazy(expr, env) => self.eval(expr, env),
            Thunk::Ready(value) => value.clone(),
        }
    }

    /// A string with its values; None if one is broken.
    pub fn text(&self, pieces: &[Piece], env: &Env) -> Option<String> {
        let mut text = String::new();
        for piece in pieces {
            match piece {
                Piece::Words(words) => text.push_str(words),
                Piece::Value(expr) => {
                    let value = self.operand(expr, env);
                    match &value.kind {
                        ValueKind::Number { value, dimension, unit } => {
                            text.push_str(&super::value::shown(*value, *dimension, *unit));
                        }
                        ValueKind::Text { text: inner, .. } => text.push_str(inner),
                        ValueKind::Word(word) => text.push_str(&word.text),
                        ValueKind::Broken => return None,
                        _ => {
                            let found = value.described();
                            self.reports.tell(types::mismatch(
                                "a text",
                                "a number, a word or a text",
                                &found,
                                expr.span,
                            ));
                            return None;
                        }
                    }
                }
            }
            if text.len() > limits::FILE_BYTES {
                self.reports.tell(render::too_many_items(self.frames_span(pieces)?));
                return None;
            }
        }
        Some(text)
    }

    fn frames_span(&self, pieces: &[Piece]) -> Option<Span> {
        pieces.iter().find_map(|piece| match piece {
            Piece::Value(expr) => Some(expr.span),
            Piece::Words(_) => None,
        })
    }

    /// A name as it is meant: pieces in quotes are a text, a word alone may be a let.
    pub fn name(&self, name: &Name, env: &Env) -> Option<Word> {
        let text = self.text(&name.pieces, env)?;
        Some(Word { text: text.into(), span: name.span })
    }

    fn named(&self, path: &[Word], env: &Env, span: Span) -> Value {
        let word = match path {
            [word] => match env.find(&word.text) {
                Some(binding) => return self.bound(&binding, word),
                None => word.clone(),
            },
            _ => return shelves::named(self, path, env, span),
        };
        Value { kind: ValueKind::Word(word), span }
    }

    fn bound(&self, binding: &Binding, used: &Word) -> Value {
        match &binding.what {
            Bound::Value(value) => value.clone(),
            Bound::Broken => Value::broken(used.span),
            Bound::Let(definition, _, _) if definition.params.is_some() => {
                self.reports.tell(types::function_as_value(used, &definition.name));
                Value::broken(used.span)
            }
            Bound::Let(definition, env, known) => {
                if let Some(value) = &*known.borrow() {
                    return value.clone();
                }
                let value = self.eval(&definition.value, env);
                *known.borrow_mut() = Some(value.clone());
                value
            }
        }
    }

    fn call(&self, function: &[Word], arguments: &[Expr], env: &Env, span: Span) -> Value {
        let [word] = function else {
            let place = function.first().map_or(span, |w| w.span);
            let text: Vec<_> = function.iter().map(|word| &*word.text).collect();
            self.reports.tell(names::unknown_function(&text.join("."), place, &[]));
            return Value::broken(span);
        };
        let values: Vec<_> = arguments.iter().map(|argument| self.eval(argument, env)).collect();
        match env.find(&word.text).as_deref() {
            Some(Binding { what: Bound::Let(definition, env, _), .. })
                if definition.params.is_some() =>
            {
                self.apply(definition, env, values, word, span)
            }
            Some(Binding { what: Bound::Broken, .. }) => Value::broken(span),
            Some(binding) => {
                self.reports.tell(types::not_a_function(word, binding.name.span));
                Value::broken(span)
            }
            None => functions::call(self, word, values, span).unwrap_or_else(|| {
                self.reports.tell_unknown_with(&word.text, word.span, || {
                    let all: Vec<_> = env.functions();
                    let all: Vec<&str> = all.iter().map(|name| &**name).collect();
                    names::unknown_function(&word.text, word.span, &all)
                });
                Value::broken(span)
            }),
        }
    }

    fn apply(&self, f: &Arc<Let>, env: &Env, values: Vec<Value>, used: &Word, span: Span) -> Value {
        let params = f.params.as_deref().unwrap_or_default();
        if params.len() != values.len() {
            let names: Vec<_> = params.iter().map(|p| &*p.text).collect();
            self.reports.tell(types::arguments(&used.text, &[&names], values.len(), span));
            return Value::broken(span);
        }
        let inner = Env(Rc::new(Frame { names: RefCell::default(), outer: Some(env.clone()) }));
        for (param, value) in params.iter().zip(values) {
            let what = Bound::Value(value);
            let binding = Rc::new(Binding { name: param.clone(), what });
            inner.0.names.borrow_mut().insert(param.text.clone(), binding);
        }
        let value = self.eval(&f.value, &inner);
        Value { span: if value.is_broken() { span } else { value.span }, ..value }
    }

    fn with(&self, base: Value, changes: &[Record], env: &Env, span: Span) -> Value {
        let mut record = match &base.kind {
            ValueKind::Record(record) => RecordValue { shelved: None, ..(**record).clone() },
            ValueKind::Word(word) => RecordValue {
                word: None,
                base: Some(word.clone()),
                fields: Vec::new(),
                braces: span,
                partial: false,
                shelved: None,
            },
            ValueKind::Broken => return base,
            _ => {
                let found = base.described();
                self.reports.tell(types::mismatch(
                    "the value before `with`",
                    "a record",
                    &found,
                    base.span,
                ));
                return Value::broken(span);
            }
        };
        for change in changes {
            let change = fields(change, env);
            record.partial |= change.partial;
            for field in change.fields {
                record.fields.retain(|other| other.key.text != field.key.text);
                record.fields.push(field);
            }
        }
        Value { kind: ValueKind::Record(Rc::new(record)), span }
    }
}

fn fields(record: &Record, env: &Env) -> RecordValue {
    let field = |entry: &super::ast::Entry| FieldValue {
        key: entry.key.clone(),
        quantity: entry.quantity,
        value: Thunk::Lazy(entry.value.clone(), env.clone()),
    };
    RecordValue {
        word: record.word.clone(),
        base: None,
        fields: record.entries.iter().map(field).collect(),
        braces: record.braces,
        partial: record.partial,
        shelved: None,
    }
}

/// What a word is to the language itself, if it is anything.
fn reserved(word: &str) -> Option<&'static str> {
    if units::find(word).is_some() {
        return Some("a unit");
    }
    if functions::ALL.contains(&word) {
        return Some("a function of the language");
    }
    match word {
        "pi" => Some("the number 3.14159…"),
        _ => None,
    }
}
