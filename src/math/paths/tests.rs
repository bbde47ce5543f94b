//! Expressions against a matcher that tries everything, and texts that are none.

use proptest::prelude::*;

use super::expression::{Letters, Node, Sign};
use super::{Automaton, End, Event, Expression, MOST_STATES, TooLarge, Which, Wrong};

fn parsed(text: &str) -> Expression {
    Expression::parse(text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"))
}

/// The path of letters such as `L S_t S_t D_r E`, as events from the eye to the light.
fn path(text: &str) -> Vec<Event> {
    let inner = text.strip_prefix("L").unwrap().strip_suffix("E").unwrap();
    let event = |word| Event::ALL.into_iter().find(|event| event.letter() == word).unwrap();
    inner.split_whitespace().rev().map(event).collect()
}

/// Whether an expression takes a path.
fn takes(text: &str, path: &[Event]) -> bool {
    let expression = parsed(text);
    let made = Automaton::new(Some(&expression), &[]).unwrap();
    made.of(path.iter().copied()) == End::Picture
}

#[test]
fn the_classes_of_transport_are_what_they_are_called() {
    let paths = [
        "L E",
        "L D_r E",
        "L S_r E",
        "L S_r D_r E",
        "L S_t S_t D_r E",
        "L S_t D_r E",
        "L D_r S_t S_t D_r E",
        "L D_r D_r S_r E",
        "L G_r D_t E",
    ];
    let cases = [
        ("L D E", vec!["L D_r E"]),
        ("L (S_r | S_t S_t) D E", vec!["L S_r D_r E", "L S_t S_t D_r E"]),
        ("LS+DE", vec!["L S_r D_r E", "L S_t S_t D_r E", "L S_t D_r E"]),
        ("L (D|S)* D S+ D E", vec!["L D_r S_t S_t D_r E"]),
        ("L S? E", vec!["L E", "L S_r E"]),
        ("L . . E", vec!["L S_r D_r E", "L S_t D_r E", "L G_r D_t E"]),
        ("L G_r D_t E | L .* S E", vec!["L S_r E", "L D_r D_r S_r E", "L G_r D_t E"]),
    ];
    for (text, expected) in cases {
        let found: Vec<&str> = paths.into_iter().filter(|it| takes(text, &path(it))).collect();
        assert_eq!(found, expected, "{text}");
    }
}

#[test]
fn the_first_layer_takes_a_path_and_others_the_rest() {
    let (picture, caustics) = (parsed("L .* D E"), parsed("L S+ D E"));
    let direct = parsed("L S* D E");
    let layers = [Which::Others, Which::Only(&caustics), Which::Only(&direct)];
    let made = Automaton::new(Some(&picture), &layers).unwrap();
    let end = |text| made.of(path(text));
    assert_eq!(end("L S_r D_r E"), End::Layer(1));
    assert_eq!(end("L D_r E"), End::Layer(2));
    assert_eq!(end("L D_r D_r E"), End::Layer(0));
    assert_eq!(end("L S_r E"), End::Outside);
    let made = Automaton::new(None, &layers[1..]).unwrap();
    assert_eq!(made.of(path("L S_r E")), End::Picture);
}

#[test]
fn ends_are_those_of_paths_that_can_be() {
    use Event::*;
    let (layer, other) = (parsed("L G E"), parsed("L D S* E"));
    let made = Automaton::new(None, &[Which::Only(&layer), Which::Only(&other)]).unwrap();
    let all = Automaton::new(None, &[]).unwrap();
    let mut ends = made.ends(&Event::ALL, &all);
    ends.sort_by_key(|end| format!("{end:?}"));
    assert_eq!(ends, [End::Layer(0), End::Layer(1), End::Picture]);
    assert!(!made.ends(&[DiffuseReflection, SpecularTransmission], &all).contains(&End::Layer(0)));
    let straight = Automaton::new(Some(&parsed("L S* E")), &[]).unwrap();
    assert_eq!(made.ends(&Event::ALL, &straight), [End::Picture]);
    let shown = Automaton::new(Some(&parsed("L (D | S)* E")), &[]).unwrap();
    assert!(shown.ends(&Event::ALL, &all).contains(&End::Outside));
    assert_eq!(shown.ends(&[DiffuseReflection, SpecularReflection], &all), [End::Picture]);
}

#[test]
fn paths_that_nothing_can_take_are_dead_at_once() {
    let expression = parsed("L S* D E");
    let shown = Automaton::new(Some(&expression), &[]).unwrap();
    let step = |state, event| shown.after(state, event);
    let diffuse = step(Automaton::START, Event::DiffuseReflection);
    assert!(!shown.is_dead(Automaton::START) && !shown.is_dead(diffuse));
    assert!(shown.is_dead(step(diffuse, Event::DiffuseReflection)));
    assert!(shown.is_dead(step(Automaton::START, Event::SpecularReflection)));
    assert_eq!(shown.states(), 3);
    // A layer alone hides nothing of the picture.
    let layered = Automaton::new(None, &[Which::Only(&expression)]).unwrap();
    assert!((0..layered.states() as u16).all(|state| !layered.is_dead(state)));
}

#[test]
fn expressions_that_grow_beyond_all_bounds_are_refused() {
    let after = |count: usize| format!("L {} D .* E", ". ".repeat(count));
    let made = |text: &str| Automaton::new(Some(&parsed(text)), &[]);
    assert!(made(&after(8)).unwrap().states() > 100);
    assert_eq!(made(&after(40)), Err(TooLarge::States));
    let long = parsed(&format!("L {} E", "D".repeat(600)));
    assert!(made(&format!("L {} E", "D".repeat(600))).unwrap().states() > 600);
    let two = [Which::Only(&long), Which::Only(&long)];
    assert_eq!(Automaton::new(None, &two), Err(TooLarge::Letters));
    assert_eq!(Automaton::new(None, &[Which::Others; 65]), Err(TooLarge::Layers));
    const { assert!(MOST_STATES < u16::MAX as usize) }
}

#[test]
fn faults_point_at_their_bytes_and_offer_what_was_meant() {
    use Wrong::*;
    let cases = [
        ("", "", Empty, None),
        ("  ", "  ", Empty, None),
        ("L d E", "d", Unknown, Some("D")),
        ("L S+ D C", "C", Unknown, Some("E")),
        ("L Sr D E", "Sr", Side, Some("S_r")),
        ("L S_R D E", "S_R", Side, Some("S_r")),
        ("L s_t D E", "s_t", Unknown, Some("S_t")),
        ("L S_x D E", "S_x", Side, None),
        ("L_r D E", "L_r", Side, Some("L")),
        ("L æ D E", "æ", Unknown, None),
        ("L [DS]* E", "[DS]", Unknown, Some("(D|S)")),
        ("L (D|S E", "(", Unclosed, None),
        ("L D) E", ")", Unopened, None),
        ("L (D|) E", "|", Empty, None),
        ("L () E", "()", Empty, None),
        ("L (* D) E", "*", NothingRepeated, Some(".*")),
        ("L (+D) E", "+", NothingRepeated, None),
        ("L * D E", "*", EndRepeated, Some(" .*")),
        ("L D E?", "?", EndRepeated, None),
        ("L D+* E", "+*", TwoSigns, Some("*")),
        ("L D ?? E", "??", TwoSigns, Some("?")),
        ("S+ D", "S+ D", NoPath, Some("L S+ D E")),
        ("D | S", "D | S", NoPath, Some("L (D | S) E")),
        ("E D (S_r|S_t S_t) L", "E D (S_r|S_t S_t) L", NoPath, Some("L (S_r | S_t S_t) D E")),
        ("L D E D", "L D E D", NoPath, None),
        ("L | E", "L | E", NoPath, None),
        ("L D | S E", "L D | S E", NoPath, Some("L (D | S) E")),
        ("L D E | S", "S", Dead, None),
        ("L D E | S S_r | L S E", "S S_r", Dead, None),
        ("L (D E | S) S E", "D E", Dead, None),
        ("L (. | E) D E", "E", Dead, None),
        ("(L D)+ E", "+", EndRepeated, None),
        ("L (D E)* E", "*", EndRepeated, None),
    ];
    for (text, at, wrong, instead) in cases {
        let faults = Expression::parse(text).expect_err(text);
        assert_eq!(faults.len(), 1, "{text}: {faults:?}");
        let fault = &faults[0];
        assert_eq!((&text[fault.at.clone()], fault.wrong), (at, wrong), "{text}");
        assert_eq!(fault.instead.as_deref(), instead, "{text}");
        // What is offered is right in its place.
        if let Some(instead) = instead {
            let mut mended = text.to_string();
            mended.replace_range(fault.at.clone(), instead);
            parsed(&mended);
        }
    }
    let deep = format!("L {}D{} E", "(".repeat(40), ")".repeat(40));
    assert_eq!(Expression::parse(&deep).unwrap_err()[0].wrong, TooDeep);
    let long = "D".repeat(1001);
    assert_eq!(Expression::parse(&long).unwrap_err()[0].wrong, TooLong);
    let several: Vec<Wrong> =
        Expression::parse("L x (S++ | y) E").unwrap_err().iter().map(|f| f.wrong).collect();
    assert_eq!(several, [Unknown, TwoSigns, Unknown]);
}

/// Where matches of `node` that begin at `from` may end in the word.
fn ends(node: &Node, word: &[Letters], from: usize) -> Vec<usize> {
    let mut all = match node {
        Node::One(letters) => match word.get(from) {
            Some(there) if there.0 & letters.0 != 0 => vec![from + 1],
            _ => Vec::new(),
        },
        Node::Row(nodes) => nodes.iter().fold(vec![from], |begins, node| {
            begins.into_iter().flat_map(|begin| ends(node, word, begin)).collect()
        }),
        Node::Either(nodes) => nodes.iter().flat_map(|node| ends(node, word, from)).collect(),
        Node::Repeated(node, sign) => {
            let once = ends(node, word, from);
            let mut all = once.clone();
            let mut new = once;
            while *sign != Sign::Perhaps && !new.is_empty() {
                new = new.iter().flat_map(|begin| ends(node, word, *begin)).collect();
                new.retain(|end| !all.contains(end));
                new.sort();
                new.dedup();
                all.extend(&new);
            }
            if *sign != Sign::Once {
                all.push(from);
            }
            all
        }
    };
    all.sort();
    all.dedup();
    all
}

fn naively(expression: &Expression, events: &[Event]) -> bool {
    let scattered = events.iter().rev().map(|event| Letters(1 << *event as u8));
    let word: Vec<Letters> = std::iter::once(Letters::LIGHT)
        .chain(scattered)
        .chain(std::iter::once(Letters::EYE))
        .collect();
    ends(&expression.root, &word, 0).contains(&word.len())
}

fn inner() -> impl Strategy<Value = String> {
    const LETTERS: [&str; 8] = ["D", "S", "G", ".", "S_r", "S_t", "D_r", "D_t"];
    proptest::sample::select(&LETTERS[..]).prop_map(String::from).prop_recursive(4, 16, 4, |part| {
        prop_oneof![
            proptest::collection::vec(part.clone(), 1..4).prop_map(|all| all.join(" ")),
            proptest::collection::vec(part.clone(), 2..4)
                .prop_map(|all| format!("({})", all.join("|"))),
            (part, proptest::sample::select(&["*", "+", "?"][..]))
                .prop_map(|(part, sign)| format!("({part}){sign}")),
        ]
    })
}

fn events() -> impl Strategy<Value = Vec<Event>> {
    proptest::collection::vec(proptest::sample::select(&Event::ALL[..]), 0..7)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_automaton_is_right(
        picture in inner(), layers in proptest::collection::vec(inner(), 0..3),
        others in 0_usize..4, path in events(),
    ) {
        let picture = parsed(&format!("L {picture} E"));
        let layers: Vec<Expression> =
            layers.iter().map(|layer| parsed(&format!("L ({layer})? E"))).collect();
        let mut which: Vec<Which> = layers.iter().map(Which::Only).collect();
        if others <= which.len() {
            which.insert(others, Which::Others);
        }
        let made = Automaton::new(Some(&picture), &which).unwrap();
        let taken = |which: &Which| matches!(which, Which::Only(it) if naively(it, &path));
        let rest = which.iter().position(|which| *which == Which::Others);
        let expected = if !naively(&picture, &path) {
            End::Outside
        } else {
            let layer = which.iter().position(taken).or(rest);
            layer.map_or(End::Picture, |layer| End::Layer(layer as u8))
        };
        prop_assert_eq!(made.of(path.iter().copied()), expected);
        let mut state = Automaton::START;
        for event in path {
            state = made.after(state, event);
            prop_assert!(!made.is_dead(state) || expected == End::Outside);
        }
    }

    #[test]
    fn an_expression_is_what_it_prints(text in inner()) {
        let read = parsed(&format!("L {text} E"));
        let again = parsed(&read.root.to_string());
        prop_assert_eq!(read.root.to_string(), again.root.to_string());
        let both = [&read, &again].map(|it| Automaton::new(Some(it), &[]).unwrap());
        prop_assert_eq!(&both[0], &both[1]);
    }

    #[test]
    fn no_text_does_harm(text in "[LDSGE._rtx()|*+? \\[\\]é]{0,40}") {
        if let Err(faults) = Expression::parse(&text) {
            for fault in faults {
                prop_assert!(text.get(fault.at).is_some());
            }
        }
    }
}
