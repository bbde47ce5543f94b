//! Tokens → what can be laid out: brackets and the parts between them.

use std::collections::HashSet;

use super::tokens::{Comment, Kind, Token, spaced};

/// Brackets with what they hold; or the whole file, without brackets.
#[derive(Debug, Default)]
pub struct Group<'t> {
    /// The token that opens it, and the one that closes it or ends the file.
    pub open: usize,
    pub close: usize,
    /// Braces: their parts end with a line or a comma. Other brackets: with a comma.
    pub braces: bool,
    pub parts: Vec<Part<'t>>,
    /// Comments after the last part.
    pub comments: Vec<Comment<'t>>,
    /// Whether each part must have a line of its own, as written.
    pub broken: bool,
    /// Whether it cannot stand on one line, for itself or for something in it.
    pub tall: bool,
    /// Characters it takes on one line.
    pub width: usize,
}

/// An item, a field, an element of a list.
#[derive(Debug, Default)]
pub struct Part<'t> {
    /// Comments before it; the first may stand on the line of what is before.
    pub comments: Vec<Comment<'t>>,
    /// Whether a blank line stands before it, after the comments.
    pub blank: bool,
    pub pieces: Vec<Piece<'t>>,
    /// Whether it cannot stand on one line.
    pub tall: bool,
    /// Characters it takes on one line.
    pub width: usize,
}

/// A token, or brackets.
#[derive(Debug)]
pub enum Piece<'t> {
    Token(usize),
    Group(Group<'t>),
}

impl Piece<'_> {
    /// Its first token.
    pub fn first(&self) -> usize {
        match self {
            Piece::Token(at) => *at,
            Piece::Group(group) => group.open,
        }
    }

    /// Characters it takes on one line.
    pub fn width(&self, tokens: &[Token]) -> usize {
        match self {
            Piece::Token(at) => tokens[*at].text.chars().count(),
            Piece::Group(group) => group.width,
        }
    }
}

/// The file. `starts`: where items and fields begin.
pub fn build<'t>(tokens: &[Token<'t>], starts: &[usize]) -> Group<'t> {
    let starts = starts.iter().copied().collect();
    let mut reader = Reader { tokens, starts, at: 0 };
    let mut file = Group { braces: true, broken: true, tall: true, ..Group::default() };
    reader.parts(&mut file);
    file
}

struct Reader<'r, 't> {
    tokens: &'r [Token<'t>],
    starts: HashSet<usize>,
    at: usize,
}

impl<'t> Reader<'_, 't> {
    /// The parts of a group, up to what closes it.
    fn parts(&mut self, group: &mut Group<'t>) {
        let mut comments = Vec::new();
        let mut blank = false;
        let mut inside = false;
        loop {
            let token = &self.tokens[self.at];
            let closes = matches!(token.kind, Kind::Sign(b')' | b']' | b'}') | Kind::End);
            let comma = token.kind == Kind::Sign(b',');
            let begins = if group.braces { self.starts.contains(&token.start) } else { !inside };
            if closes || comma || begins {
                // Vectors and arguments are joined where they fit; records and lists are not.
                let kept = self.tokens[group.open].kind != Kind::Sign(b'(') && token.newline;
                group.broken |= kept || !token.comments.is_empty();
                for comment in &token.comments {
                    // The line it ended may have ended with a comma, which goes away.
                    let own_line = comment.own_line || !comments.is_empty();
                    comments.push(Comment { own_line, ..*comment });
                }
                blank = token.blank || (blank && token.comments.is_empty());
                inside = begins && !comma && !closes;
            }
            if closes {
                group.close = self.at;
                group.comments = comments;
                return self.measure(group);
            }
            if comma {
                self.at += 1;
                continue;
            }
            if begins {
                let comments = std::mem::take(&mut comments);
                group.parts.push(Part { comments, blank, ..Part::default() });
                blank = false;
            }
            let first = begins;
            let piece = self.piece();
            let Some(part) = group.parts.last_mut() else { continue };
            part.tall |= !first && !self.tokens[piece.first()].comments.is_empty();
            part.tall |= matches!(&piece, Piece::Group(group) if group.tall);
            // A record on several lines has a field a line, wherever its lines end.
            group.broken |= group.braces && !first && self.tokens[piece.first()].newline;
            part.pieces.push(piece);
        }
    }

    fn piece(&mut self) -> Piece<'t> {
        let open = self.at;
        self.at += 1;
        if !matches!(self.tokens[open].kind, Kind::Sign(b'(' | b'[' | b'{')) {
            return Piece::Token(open);
        }
        let braces = self.tokens[open].kind == Kind::Sign(b'{');
        let mut group = Group { open, braces, ..Group::default() };
        self.parts(&mut group);
        self.at += 1;
        Piece::Group(group)
    }

    fn measure(&self, group: &mut Group<'t>) {
        for part in &mut group.parts {
            part.width = width(self.tokens, &part.pieces);
        }
        let tall = group.parts.iter().any(|part| part.tall);
        group.broken |= group.braces && tall;
        group.tall = tall || group.broken;
        // What is empty has no lines to stand on.
        if group.parts.is_empty() && group.comments.is_empty() {
            (group.broken, group.tall) = (false, false);
        }
        let edges = if group.braces && !group.parts.is_empty() { 4 } else { 2 };
        let commas = 2 * group.parts.len().saturating_sub(1);
        group.width = edges + commas + group.parts.iter().map(|part| part.width).sum::<usize>();
    }
}

/// Characters of pieces on one line.
fn width(tokens: &[Token], pieces: &[Piece]) -> usize {
    let words: usize = pieces.iter().map(|piece| piece.width(tokens)).sum();
    let blanks = pieces[1..].iter().filter(|piece| spaced(tokens, piece.first() - 1)).count();
    words + blanks
}
