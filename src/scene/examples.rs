//! What is shown to one who asks how a field or a variant is written: values that can stand in a
//! scene as they are, neither wrong nor doubtful.

use super::schema::{Field, Record, Type, Variants};

/// A variant, a field of it that has no default or is shown without being asked for, and a value.
/// Other fields have their default, or what is usual for their type.
const EXAMPLES: &[(&str, &str, &str)] = &[
    ("checker", "a", "0.2"),
    ("checker", "b", "0.8"),
    ("conductor", "ior", "metal.gold"),
    ("directional", "direction", "(-1, -2, -1)"),
    ("homogeneous", "ior", "1.5"),
    ("mix", "second", "mirror"),
    ("perspective", "eye", "(0, 1, 5)"),
    ("point", "position", "(1, 3, 2)"),
    ("preetham", "day", "172"),
    ("preetham", "latitude", "50 deg"),
    ("preetham", "time", "12:00"),
    ("preetham", "turbidity", "3"),
    ("quad", "corner", "(-1, 0, 1)"),
    ("quad", "u", "(2, 0, 0)"),
    ("quad", "v", "(0, 0, -2)"),
    ("spot", "direction", "-y"),
    ("spot", "position", "(0, 3, 0)"),
    ("triangle", "b", "(1, 0, 0)"),
    ("triangle", "c", "(0, 1, 0)"),
];

/// How a field of a record may look; None: by its type.
pub fn of_field(record: &Record, field: &Field) -> Option<&'static str> {
    let known = EXAMPLES.iter().find(|(of, word, _)| *of == record.word && *word == field.word);
    known.map(|(.., example)| *example).or(field.default)
}

/// The fields of a record that are shown: those that it must have, or else its first one, unless
/// that may be left out without a default.
pub fn shown(record: &Record) -> Vec<&Field> {
    let needed = |field: &&Field| field.default.is_none() && !field.optional;
    let needed: Vec<_> = record.fields.iter().filter(needed).collect();
    match needed.is_empty() {
        true => record.fields.iter().take(1).filter(|field| !field.optional).collect(),
        false => needed,
    }
}

/// The variant that is shown where any would do: the first that asks for no index and no name.
pub fn simplest(variants: &Variants) -> Option<&Record> {
    let hard = |field: &&Field| matches!(field.ty, Type::Index | Type::Reference { .. });
    let simple = |record: &&Record| !shown(record).iter().any(hard);
    variants.all.iter().find(simple).or(variants.all.first())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::KINDS;

    #[test]
    fn examples_are_of_fields_that_there_are() {
        let variants = KINDS.iter().filter_map(|kind| match kind.ty {
            Type::OneOf(variants) => Some(variants),
            _ => None,
        });
        let records: Vec<_> = variants.flat_map(|variants| variants.all).collect();
        for (word, field, _) in EXAMPLES {
            let record = records.iter().find(|record| record.word == *word).expect(word);
            assert!(shown(record).iter().any(|shown| shown.word == *field), "{word}.{field}");
        }
        assert!(EXAMPLES.is_sorted());
    }
}
