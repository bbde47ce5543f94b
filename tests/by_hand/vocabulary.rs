//! The words that the language has, so that a list in a test can be held to be complete.

use scn::scene::schema::{Type, Vocabulary};

/// The variants of a kind, or the words of a choice.
pub fn words<T: Vocabulary>() -> Vec<&'static str> {
    match T::TYPE {
        Type::OneOf(variants) => variants.all.iter().map(|variant| variant.word).collect(),
        Type::Words(words) => words.all.iter().map(|(word, _)| *word).collect(),
        other => panic!("no choice: {other:?}"),
    }
}

/// The fields of a variant of a kind.
pub fn fields<T: Vocabulary>(variant: &str) -> Vec<&'static str> {
    let Type::OneOf(variants) = T::TYPE else { panic!("no kind: {:?}", T::TYPE) };
    let variant = variants.all.iter().find(|it| it.word == variant).expect("a variant");
    variant.fields.iter().map(|field| field.word).collect()
}

/// Holds when each word of the language is in a list, and nothing else.
pub fn assert_complete(what: &str, mut list: Vec<&str>, mut words: Vec<&str>) {
    list.sort_unstable();
    list.dedup();
    words.sort_unstable();
    assert_eq!(list, words, "the {what} that are tested, and those that there are");
}
