//! `scn list`: the words of the language, from the schema alone.

mod entries;
mod own;
mod reference;
mod spectra;
mod types;

use super::options::{List, Page};
use super::{End, terminal};
use crate::diag::near;
use crate::diag::print::Look;
use crate::diag::words::did_you_mean;
use crate::scene::schema::{Kind, Record, Type};
use crate::scene::{self, KINDS};
use entries::{Entry, entries};

/// Columns of the margin before the text on a field.
const FIELD_MARGIN: usize = 6;

pub fn run(options: &List) -> End {
    let look = terminal::stdout_look();
    let words: Vec<&str> = options.words.iter().flat_map(|words| words.split([' ', '.'])).collect();
    let text = match words.as_slice() {
        [] if options.format == Page::Markdown => reference::page(),
        [] => kinds(look),
        ["units" | "unit"] => own::units(look),
        ["keywords" | "keyword"] => own::keywords(look),
        ["functions" | "function"] => own::functions(look),
        ["lints" | "lint"] => super::lint::list(),
        ["shelves" | "shelf"] => spectra::shelves(look),
        ["types" | "type"] => spectra::quantities(look),
        [places @ .., word] => match word_page(word, places, look) {
            Some(page) => page,
            None => {
                let all: Vec<_> = entries().into_iter().map(|entry| entry.word()).collect();
                let fault = if !places.is_empty() && word_page(word, &[], look).is_some() {
                    format!(
                        "there is no `{word}` in `{}`; `scn list {word}` tells where it stands",
                        places.join(" ")
                    )
                } else {
                    let hint = elsewhere(word).unwrap_or_else(|| {
                        match near(
                            word,
                            all.into_iter().chain(own::words()).chain(spectra::further_words()),
                        )
                        .as_slice()
                        {
                            [] => "`scn list` shows the words it has".to_string(),
                            words => did_you_mean(words.iter().copied()),
                        }
                    });
                    format!("the language has no word `{word}`; {hint}")
                };
                terminal::fail(&fault);
                return End::NotDone;
            }
        },
    };
    terminal::say(&text);
    End::Well
}

/// What a word of other programs, or of everyday speech, is called here.
fn elsewhere(word: &str) -> Option<String> {
    let (choices, advice) = scene::elsewhere::anywhere(word);
    let kind = scene::elsewhere::kind(word).map(|kind| format!("the kind `{kind}`"));
    let choices = choices.into_iter().map(|(of, meant)| format!("the {of} `{meant}`"));
    let fields = scene::elsewhere::fields(word).map(|field| format!("the field `{field}`"));
    let mut all: Vec<String> = kind.into_iter().chain(choices).chain(fields).collect();
    let what = match all.pop() {
        None => return advice.first().map(|advice| advice.to_string()),
        Some(last) if all.is_empty() => last,
        Some(last) => format!("{} or {last}", all.join(", ")),
    };
    Some(format!("what is meant may be {what}"))
}

/// Every kind with its variants.
fn kinds(look: Look) -> String {
    let mut text = String::from(
        "Kinds of items. `scn list KIND` shows one whole; any word will do, such as `scn list \
         diffuse`.\n",
    );
    let name =
        |kind: &Kind| if kind.named { format!("{} NAME", kind.word) } else { kind.word.into() };
    let width = KINDS.iter().map(|kind| name(kind).len()).max().unwrap_or(0);
    for named in [false, true] {
        text.push_str(if named {
            "\nMany, each with a name:\n"
        } else {
            "\nOne for each picture:\n"
        });
        for kind in KINDS.iter().filter(|kind| kind.named == named) {
            text.push_str(&format!("  {}  {}\n", strong(&name(kind), width, look), flow(kind.doc)));
            let margin = " ".repeat(width + 4);
            if let Type::OneOf(variants) = kind.ty {
                let words: Vec<_> = variants.all.iter().map(|variant| variant.word).collect();
                let choices = format!("variants: {}", words.join(", "));
                text.push_str(&block(&choices, &margin, look));
            }
            match kind.default.map(types::tidy).as_deref() {
                Some("{}") => {}
                Some(default) => text.push_str(&format!("{margin}default: {default}\n")),
                None if !kind.optional => text.push_str(&format!("{margin}must be given\n")),
                None => {}
            }
        }
    }
    text + &own::overview(look)
}

/// Everything the word means in these places, from the outermost in; None if it means nothing.
fn word_page(word: &str, places: &[&str], look: Look) -> Option<String> {
    let inside = |entry: &Entry| {
        let path = entry.path();
        let mut steps = path.split([' ', '.', ':']);
        places.iter().all(|place| steps.any(|step| step == *place))
    };
    let mut found: Vec<Entry> =
        entries().into_iter().filter(|e| e.word() == word && inside(e)).collect();
    // A kind tells everything; below it, whole records say more than single fields.
    if let Some(at) = found.iter().position(|entry| matches!(entry, Entry::Kind(_))) {
        found.swap(0, at);
    }
    // A set of variants tells what the field of its name is.
    if found.iter().any(|entry| matches!(entry, Entry::Choice { .. })) {
        found.retain(|entry| !matches!(entry, Entry::Field { .. }));
    }
    let mut pages: Vec<String> = found.iter().map(|entry| page(entry, look)).collect();
    if places.is_empty() {
        pages.extend(own::page(word, look));
    }
    pages.extend(spectra::page(word, places, look));
    (!pages.is_empty()).then(|| pages.join("\n"))
}

fn page(entry: &Entry, look: Look) -> String {
    let heading = |what: &str, doc: &str| {
        format!("{}\n{}", strong(what, 0, look), block(&flow(doc), "  ", look))
    };
    match entry {
        Entry::Kind(kind) => {
            let mut text = heading(&item_form(kind), kind.doc);
            if let Some(default) = kind.default.map(types::tidy).filter(|d| d != "{}") {
                text.push_str(&format!("  default: {default}\n"));
            }
            text + &inside(kind.ty, look)
        }
        Entry::Choice { variants, path } => {
            let mut text = heading(&format!("{}: VARIANT {{ … }}", variants.name), variants.doc);
            text.push_str(&format!("  stands in {path}\n"));
            text + &inside(Type::OneOf(variants), look)
        }
        Entry::Variant { record, path } => heading(path, record.doc) + "\n" + &fields(record, look),
        Entry::Field { field, path } => {
            let mut text = format!("{path}\n");
            text.push_str(&types::field(field, field.word.len(), look));
            if let Type::OneOf(_) | Type::Record(_) = field.ty {
                text.push_str(&inside(field.ty, look));
            }
            text
        }
        Entry::Word { doc, path, .. } => {
            format!("{path}\n{}", block(&flow(doc), "  ", look))
        }
    }
}

/// How an item of a kind is written.
fn item_form(kind: &Kind) -> String {
    let form = match kind.ty {
        Type::OneOf(_) => "VARIANT { … }".to_string(),
        Type::Record(_) => "{ … }".to_string(),
        other => types::form(other),
    };
    let name = if kind.named { " NAME" } else { "" };
    format!("{}{name}: {form}", kind.word)
}

/// The variants or fields of a type.
fn inside(ty: Type, look: Look) -> String {
    match ty {
        Type::OneOf(variants) => {
            variants.all.iter().map(|record| format!("\n{}", variant(record, look))).collect()
        }
        Type::Record(record) => format!("\n{}", fields(record, look)),
        _ => String::new(),
    }
}

fn variant(record: &Record, look: Look) -> String {
    let doc = block(&flow(record.doc), "    ", look);
    format!("  {}\n{doc}{}", strong(record.word, 0, look), fields(record, look))
}

fn fields(record: &Record, look: Look) -> String {
    let width = record.fields.iter().map(|field| field.word.len()).max().unwrap_or(0);
    record.fields.iter().map(|field| types::field(field, width, look)).collect()
}

/// A doc comment as one paragraph.
fn flow(doc: &str) -> String {
    doc.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A paragraph in lines that fit, behind a margin.
fn block(paragraph: &str, margin: &str, look: Look) -> String {
    let width = look.width.clamp(40, 100) - margin.len();
    let lines = crate::diag::print::wrapped(paragraph, width);
    lines.iter().map(|line| format!("{margin}{line}\n")).collect()
}

/// A word that stands out on a terminal, filled up to `width`.
fn strong(word: &str, width: usize, look: Look) -> String {
    let padding = " ".repeat(width.saturating_sub(word.chars().count()));
    if look.colour { format!("\x1b[1m{word}\x1b[0m{padding}") } else { format!("{word}{padding}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_of_the_schema_has_a_page() {
        let all = entries();
        assert!(all.len() > 60, "{}", all.len());
        for entry in all {
            let page = word_page(entry.word(), &[], Look::PLAIN).unwrap();
            assert!(page.contains(entry.word()), "{page}");
            assert!(page.lines().all(|line| line.chars().count() <= 100), "{page}");
        }
        assert_eq!(word_page("glowing", &[], Look::PLAIN), None);
    }

    #[test]
    fn a_page_tells_type_unit_range_and_default() {
        let page = word_page("diffuse", &[], Look::PLAIN).unwrap();
        for part in ["reflectance: number, colour or", "0 or more", "must be given", "W/m^2/sr"] {
            assert!(page.contains(part), "{part} is not in\n{page}");
        }
        let page = word_page("fov_y", &[], Look::PLAIN).unwrap();
        assert!(page.contains("1e-9 deg or more, below 180 deg"), "{page}");
        let page = word_page("center", &[], Look::PLAIN).unwrap();
        assert!(page.contains("integrator direct.area_lights"), "{page}");
        assert!(page.contains("object sphere.center"), "{page}");
    }

    #[test]
    fn every_word_of_the_language_itself_has_a_page() {
        let overview = kinds(Look::PLAIN) + &own::units(Look::PLAIN);
        for word in own::words() {
            let page = word_page(word, &[], Look::PLAIN).unwrap();
            assert!(page.contains(word) && page.lines().count() >= 2, "{page}");
            assert!(overview.split_whitespace().any(|shown| shown == word), "{word}\n{overview}");
        }
        let page = word_page("rotate", &[], Look::PLAIN).unwrap();
        assert!(page.starts_with("rotate(axis, angle)\n"), "{page}");
        let page = word_page("gold", &["metal"], Look::PLAIN).unwrap();
        assert!(page.contains("metal.gold") && page.contains("[Johnson72]"), "{page}");
        assert!(word_page("gold", &["glass"], Look::PLAIN).is_none());
        assert!(spectra::shelves(Look::PLAIN).lines().all(|line| line.chars().count() <= 100));
        for word in spectra::further_words() {
            assert!(word_page(word, &[], Look::PLAIN).is_some(), "{word}");
        }
        let page = word_page("cm", &[], Look::PLAIN).unwrap();
        assert!(page.contains("a length. 1 cm is 0.01 m."), "{page}");
    }

    #[test]
    fn words_of_elsewhere_are_known() {
        let told = |word| elsewhere(word).unwrap();
        assert_eq!(told("Lambert"), "what is meant may be the material `diffuse`");
        assert_eq!(
            told("brdf"),
            "what is meant may be the kind `material` or the field `material`"
        );
        assert!(told("cylinder").starts_with("use a `mesh`"));
        assert!(told("rough").contains("smooth as yet"));
        assert_eq!(elsewhere("glowing"), None);
    }

    #[test]
    fn words_before_a_word_say_where_it_stands() {
        let page = word_page("radius", &["object", "sphere"], Look::PLAIN).unwrap();
        assert!(page.contains("object sphere.radius") && !page.contains("disk"), "{page}");
        assert!(word_page("sphere", &["object"], Look::PLAIN).is_some());
        assert_eq!(word_page("sphere", &["camera"], Look::PLAIN), None);
    }

    #[test]
    fn defaults_are_shown_with_six_digits() {
        let page = word_page("fov_y", &["overview"], Look::PLAIN).unwrap();
        assert!(page.contains("default 53.1301 deg"), "{page}");
        assert_eq!(types::tidy("(512, 0.25) m"), "(512, 0.25) m");
    }
}
