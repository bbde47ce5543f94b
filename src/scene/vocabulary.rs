//! The macro that turns an entry of the vocabulary into a struct and its description.

/// Joins the lines of a doc comment.
pub(super) const fn joined(doc: &'static str) -> &'static str {
    // `concat!` has put a blank before each line; only the first is in the way.
    match doc.as_bytes() {
        [b' ', ..] => doc.split_at(1).1,
        _ => doc,
    }
}

/// Declares part of the vocabulary: variants, a record, or plain words. In a field, the type is
/// followed by `= "default"` in the scene language and by `, Range` where one is due.
macro_rules! vocabulary {
    // Variants: each a word with fields.
    (
        $(#[doc = $doc:literal])+
        pub enum $Name:ident: $name:literal {$(
            $(#[doc = $vdoc:literal])+
            $word:literal => $Variant:ident {$(
                $(#[doc = $fdoc:literal])+
                $field:ident: $ty:ty $(= $default:literal)? $(, $range:expr)?;
            )*}
        )+}
    ) => {
        $(#[doc = $doc])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        #[serde(rename_all = "snake_case")]
        #[allow(clippy::large_enum_variant, reason = "scenes have few of each")]
        pub enum $Name {$(
            $(#[doc = $vdoc])+
            $Variant($Variant),
        )+}

        $($crate::scene::vocabulary::fields! {
            $(#[doc = $vdoc])+
            $Variant { $($(#[doc = $fdoc])+ $field: $ty;)* }
        })+

        impl $crate::scene::schema::Vocabulary for $Name {
            const TYPE: $crate::scene::schema::Type =
                $crate::scene::schema::Type::OneOf(&$crate::scene::schema::Variants {
                    name: $name,
                    doc: $crate::scene::vocabulary::joined(concat!($($doc, "\n"),+)),
                    all: &[$($crate::scene::schema::Record {
                        word: $word,
                        doc: $crate::scene::vocabulary::joined(concat!($($vdoc, "\n"),+)),
                        fields: $crate::scene::vocabulary::described!($(
                            $(#[doc = $fdoc])+ $field: $ty $(= $default)? $(, $range)?;
                        )*),
                    }),+],
                });

            fn lower(checked: &$crate::scene::schema::Checked) -> Self {
                let $crate::scene::schema::Checked::Variant(which, fields) = checked else {
                    $crate::scene::schema::unchecked($name, checked)
                };
                let words = [$($word),+];
                $(if words[*which] == $word {
                    return Self::$Variant($Variant::from_fields(fields));
                })+
                $crate::scene::schema::unchecked($name, checked)
            }
        }
    };

    // A record of its own.
    (
        $(#[doc = $doc:literal])+
        pub struct $Name:ident {$(
            $(#[doc = $fdoc:literal])+
            $field:ident: $ty:ty $(= $default:literal)? $(, $range:expr)?;
        )*}
    ) => {
        $crate::scene::vocabulary::fields! {
            $(#[doc = $doc])+
            $Name { $($(#[doc = $fdoc])+ $field: $ty;)* }
        }

        impl $crate::scene::schema::Vocabulary for $Name {
            const TYPE: $crate::scene::schema::Type =
                $crate::scene::schema::Type::Record(&$crate::scene::schema::Record {
                    word: "",
                    doc: $crate::scene::vocabulary::joined(concat!($($doc, "\n"),+)),
                    fields: $crate::scene::vocabulary::described!($(
                        $(#[doc = $fdoc])+ $field: $ty $(= $default)? $(, $range)?;
                    )*),
                });

            fn lower(checked: &$crate::scene::schema::Checked) -> Self {
                match checked {
                    $crate::scene::schema::Checked::Record(fields) => Self::from_fields(fields),
                    other => $crate::scene::schema::unchecked(stringify!($Name), other),
                }
            }
        }
    };

    // Words alone.
    (
        $(#[doc = $doc:literal])+
        pub words $Name:ident: $name:literal {$(
            $(#[doc = $wdoc:literal])+
            $word:literal => $Word:ident
        )+}
    ) => {
        $(#[doc = $doc])+
        #[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $Name {$(
            $(#[doc = $wdoc])+
            $Word,
        )+}

        impl $crate::scene::schema::Vocabulary for $Name {
            const TYPE: $crate::scene::schema::Type =
                $crate::scene::schema::Type::Words(&$crate::scene::schema::Words {
                    name: $name,
                    doc: $crate::scene::vocabulary::joined(concat!($($doc, "\n"),+)),
                    all: &[$((
                        $word,
                        $crate::scene::vocabulary::joined(concat!($($wdoc, "\n"),+)),
                    )),+],
                });

            fn lower(checked: &$crate::scene::schema::Checked) -> Self {
                match checked {
                    $crate::scene::schema::Checked::Word(which) => [$(Self::$Word),+][*which],
                    other => $crate::scene::schema::unchecked($name, other),
                }
            }
        }
    };
}

/// The struct of a record, and how it is filled.
macro_rules! fields {
    (
        $(#[doc = $doc:literal])+
        $Name:ident {$(
            $(#[doc = $fdoc:literal])+
            $field:ident: $ty:ty;
        )*}
    ) => {
        $(#[doc = $doc])+
        #[derive(Clone, Debug, PartialEq, serde::Serialize)]
        pub struct $Name {$(
            $(#[doc = $fdoc])+
            #[serde(skip_serializing_if = "crate::scene::At::is_usual")]
            pub $field: $crate::scene::At<$ty>,
        )*}

        impl $Name {
            fn from_fields(fields: &[$crate::scene::At<$crate::scene::schema::Checked>]) -> Self {
                #[allow(unused_mut, unused_variables)]
                let mut fields = fields.iter();
                Self {$(
                    $field: {
                        let field = fields.next().expect("checked: every field of the schema");
                        let value = $crate::scene::schema::Vocabulary::lower(&field.value);
                        $crate::scene::At { value, span: field.span, usual: field.usual }
                    },
                )*}
            }
        }
    };
}

/// The description of a record's fields.
macro_rules! described {
    (@default) => { None };
    (@default $default:literal) => { Some($default) };
    (@range) => { $crate::scene::schema::Range::ANY };
    (@range $range:expr) => { $range };
    ($(
        $(#[doc = $fdoc:literal])+
        $field:ident: $ty:ty $(= $default:literal)? $(, $range:expr)?;
    )*) => {
        &[$($crate::scene::schema::Field {
            word: stringify!($field),
            doc: $crate::scene::vocabulary::joined(concat!($($fdoc, "\n"),+)),
            ty: <$ty as $crate::scene::schema::Vocabulary>::TYPE,
            range: $crate::scene::vocabulary::described!(@range $($range)?),
            default: $crate::scene::vocabulary::described!(@default $($default)?),
            optional: <$ty as $crate::scene::schema::Vocabulary>::OPTIONAL,
        }),*]
    };
}

pub(super) use {described, fields, vocabulary};
