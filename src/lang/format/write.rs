//! Brackets and parts → lines.

use super::tokens::{Comment, Kind, Token, is_operator, spaced};
use super::tree::{Group, Part, Piece};

/// Columns of a line.
const WIDTH: usize = 100;
/// Columns of a level.
const STEP: usize = 4;
/// A list whose elements are all this short fills its lines.
const SHORT: usize = 12;

/// The text of a file.
pub fn file(tokens: &[Token], file: &Group) -> String {
    let mut writer = Writer { tokens, out: String::new(), column: 0, indent: 0 };
    writer.lines(file, 0);
    writer.out.push('\n');
    writer.out
}

struct Writer<'w, 't> {
    tokens: &'w [Token<'t>],
    out: String,
    /// Characters of the line so far.
    column: usize,
    /// Blanks the line begins with.
    indent: usize,
}

impl<'t> Writer<'_, 't> {
    fn push(&mut self, text: &str) {
        self.out.push_str(text);
        self.column += text.chars().count();
    }

    fn newline(&mut self, indent: usize) {
        if !self.out.is_empty() {
            self.out.push('\n');
        }
        self.out.extend(std::iter::repeat_n(' ', indent));
        (self.column, self.indent) = (indent, indent);
    }

    /// An empty line; its end is written by what follows.
    fn blank(&mut self) {
        self.out.push('\n');
    }

    /// Comments: the first where the line ends, if it stood so; the others on their own.
    fn comments(&mut self, comments: &[Comment<'t>], indent: usize, keep_blanks: &mut bool) {
        for comment in comments {
            if comment.own_line {
                if comment.blank && *keep_blanks {
                    self.blank();
                }
                self.newline(indent);
            } else {
                self.push(" ");
            }
            self.push(comment.text);
            *keep_blanks |= comment.own_line;
        }
    }

    /// Each part on a line of its own, and the comments at the end.
    fn lines(&mut self, group: &Group<'t>, indent: usize) {
        let commas = !group.braces;
        // Not directly after a bracket.
        let mut keep_blanks = false;
        for (i, part) in group.parts.iter().enumerate() {
            self.comments(&part.comments, indent, &mut keep_blanks);
            if part.blank && keep_blanks {
                self.blank();
            }
            keep_blanks = true;
            self.newline(indent);
            // One value in parentheses takes no comma: it is no list.
            let last = i + 1 == group.parts.len();
            let list = self.tokens[group.open].kind == Kind::Sign(b'[');
            let comma = commas && (!last || list || i > 0);
            self.pieces(part, usize::from(comma));
            if comma {
                self.push(",");
            }
        }
        self.comments(&group.comments, indent, &mut keep_blanks);
    }

    /// What a part consists of. `after`: characters that follow it on its line.
    fn pieces(&mut self, part: &Part<'t>, after: usize) {
        let hanging = self.indent + STEP;
        for (i, piece) in part.pieces.iter().enumerate() {
            let first = piece.first();
            let comments = &self.tokens[first].comments;
            if i > 0 && !comments.is_empty() {
                self.comments(comments, hanging, &mut false);
                self.newline(hanging);
            } else if i > 0 && spaced(self.tokens, first - 1) {
                let far = self.column + 1 + self.head(&part.pieces[i..], after) > WIDTH;
                match far && is_operator(self.tokens, first) {
                    true => self.newline(hanging),
                    false => self.push(" "),
                }
            }
            match piece {
                Piece::Token(at) => self.push(self.tokens[*at].text),
                Piece::Group(group) => {
                    let rest = self.rest(&part.pieces, i + 1, after);
                    self.group(group, rest);
                }
            }
        }
    }

    /// Characters from `pieces[from]` to where the line may end next.
    fn rest(&self, pieces: &[Piece], from: usize, after: usize) -> usize {
        match pieces.get(from) {
            None => after,
            Some(next) => {
                let first = next.first();
                let space = usize::from(spaced(self.tokens, first - 1));
                match space == 1 && is_operator(self.tokens, first) {
                    true => 0,
                    false => space + self.head(&pieces[from..], after),
                }
            }
        }
    }

    /// Characters of pieces up to where their line may end: after an opening bracket, before an
    /// operator, or at their end.
    fn head(&self, pieces: &[Piece], after: usize) -> usize {
        let mut width = 0;
        for (i, piece) in pieces.iter().enumerate() {
            let first = piece.first();
            if i > 0 {
                let space = spaced(self.tokens, first - 1);
                let commented = !self.tokens[first].comments.is_empty();
                if commented || (space && is_operator(self.tokens, first)) {
                    return width;
                }
                width += usize::from(space);
            }
            match piece {
                Piece::Group(group) if !group.parts.is_empty() => return width + 1,
                _ => width += piece.width(self.tokens),
            }
        }
        width + after
    }

    /// Brackets. `rest`: characters after them up to where the line may end.
    fn group(&mut self, group: &Group<'t>, rest: usize) {
        let (open, close) = (self.tokens[group.open].text, self.tokens[group.close].text);
        let fits = !group.tall && self.column + group.width + rest <= WIDTH;
        if fits || self.can_hold(group) {
            let edge = if group.braces && !group.parts.is_empty() { " " } else { "" };
            self.push(open);
            self.push(edge);
            for (i, part) in group.parts.iter().enumerate() {
                if i > 0 {
                    self.push(", ");
                }
                self.pieces(part, if i + 1 == group.parts.len() { 1 + rest } else { 1 });
            }
            self.push(edge);
            return self.push(close);
        }
        let outer = self.indent;
        self.push(open);
        match self.fills(group) {
            true => self.fill(group, outer + STEP),
            false => self.lines(group, outer + STEP),
        }
        self.newline(outer);
        self.push(close);
    }

    /// Whether brackets may stay on their line although what they end with, a record or a list,
    /// takes several.
    fn can_hold(&self, group: &Group) -> bool {
        let Some((last, before)) = group.parts.split_last() else { return false };
        let list = |group: &Group| self.tokens[group.open].kind != Kind::Sign(b'(');
        let ends =
            matches!(last.pieces.last(), Some(Piece::Group(g)) if list(g) && !g.parts.is_empty());
        let flat = before.iter().all(|part| !part.tall);
        let width: usize = before.iter().map(|part| part.width + 2).sum();
        let fits = || self.column + 1 + width + self.head(&last.pieces, 1) <= WIDTH;
        !group.braces && !group.broken && ends && flat && fits()
    }

    /// Whether a list's elements are short enough to share lines.
    fn fills(&self, group: &Group) -> bool {
        let list = self.tokens[group.open].kind == Kind::Sign(b'[');
        let plain = |part: &Part| !part.tall && part.comments.is_empty() && part.width <= SHORT;
        list && group.comments.is_empty() && group.parts.iter().all(plain)
    }

    fn fill(&mut self, group: &Group<'t>, indent: usize) {
        self.newline(indent);
        for part in &group.parts {
            if self.column > indent {
                match self.column + 1 + part.width + 1 > WIDTH {
                    true => self.newline(indent),
                    false => self.push(" "),
                }
            }
            self.pieces(part, 1);
            self.push(",");
        }
    }
}
