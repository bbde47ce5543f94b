//! Texts of .mtl files, good and bad.

use proptest::prelude::*;

use super::{Library, What, parse};

fn read(text: impl AsRef<[u8]>) -> Library {
    parse(text.as_ref()).unwrap()
}

/// The one fault of a material called `a`: how, in which line, on which words.
fn fault(statement: &str) -> (What, usize, String) {
    let library = read(format!("# comment\nnewmtl a\n{statement}\n"));
    assert_eq!(library.faults.len(), 1, "{:?}", library.faults);
    let fault = &library.faults[0];
    assert_eq!(fault.material.as_deref(), Some("a"));
    let line = 1 + library.text[..fault.at.start].matches('\n').count();
    (fault.what.clone(), line, library.text[fault.at.clone()].to_string())
}

#[test]
fn values_come_with_their_places() {
    let text = "# made by hand\r\nnewmtl white wall\r\n\tKa 0 0 0\r\nKd 0.1 .25 1e-3 # grey\r\n\
                Ks 0.5\r\nKe 36.8 31.2 16\nNs 90\nNi 1.5\nTr 0.25\nillum 2\nmap_Kd -o 1 1 a.png\n\
                Tf 1 1 1\nsharpness 60\nnewmtl b\nd 0.5\nPr 0.3\n";
    let library = read(text);
    assert_eq!((library.faults.as_slice(), library.unknown.as_slice()), (&[][..], &[][..]));
    let [a, b] = library.materials.as_slice() else { panic!("{:?}", library.materials) };
    assert_eq!(a.name.value, "white wall");
    let kd = a.diffuse.as_ref().unwrap();
    assert_eq!(kd.value, [0.1, 0.25, 1e-3]);
    assert_eq!(&library.text[kd.at.clone()], "Kd 0.1 .25 1e-3");
    assert_eq!(a.specular.as_ref().unwrap().value, [0.5; 3]);
    assert_eq!(a.emissive.as_ref().unwrap().value, [36.8, 31.2, 16.0]);
    assert_eq!(a.ambient.as_ref().unwrap().value, [0.0; 3]);
    assert_eq!((a.exponent.as_ref().unwrap().value, a.index.as_ref().unwrap().value), (90.0, 1.5));
    assert_eq!((a.dissolve.as_ref().unwrap().value, a.illum.as_ref().unwrap().value), (0.75, 2));
    assert_eq!(a.others.iter().map(|o| o.value.as_str()).collect::<Vec<_>>(), [""; 0]);
    assert_eq!(a.diffuse_map.as_ref().map(|map| map.value.file.as_str()), Some("a.png"));
    assert_eq!((b.dissolve.as_ref().unwrap().value, b.diffuse.is_none()), (0.5, true));
    assert_eq!(b.others[0].value, "Pr");
}

#[test]
fn a_single_number_is_a_grey() {
    assert!(
        std::panic::catch_unwind(|| {
            tobj::load_mtl_buf(&mut std::io::Cursor::new("newmtl a\nKd 1\n"))
        })
        .is_err()
    );
    assert_eq!(read("newmtl a\nKd 1\n").materials[0].diffuse.as_ref().unwrap().value, [1.0; 3]);
}

#[test]
fn names_that_are_not_utf8_and_joined_lines_are_read() {
    let library = read(b"newmtl caf\xe9\nKd 0.1 \\\n0.2 0.3\n");
    assert_eq!(library.materials[0].name.value, "café");
    assert_eq!(library.materials[0].diffuse.as_ref().unwrap().value, [0.1, 0.2, 0.3]);
}

#[test]
fn faults_are_found_in_their_lines() {
    let word = |w: &str| w.to_string();
    assert_eq!(fault("Kd 1 x 1"), (What::NotANumber(word("x")), 3, word("x")));
    assert_eq!(fault("Kd 0,5 0,5 0,5").0, What::NotANumber(word("0,5")));
    assert_eq!(fault("Ke 1 1e400 1").0, What::NotFinite(word("1e400")));
    assert_eq!(fault("Ke 1 1e39 1").0, What::NotFinite(word("1e39")));
    assert_eq!(fault("Ka nan").0, What::NotFinite(word("nan")));
    assert_eq!(fault("Kd 1 -0.5 1"), (What::Negative(word("-0.5")), 3, word("-0.5")));
    assert_eq!(fault("Ns -1").0, What::Negative(word("-1")));
    assert_eq!(fault("d 1.5").0, What::NoFraction(word("1.5")));
    assert_eq!(fault("illum 15").0, What::NotAnIllum(word("15")));
    assert_eq!(fault("illum -1").0, What::NotAnIllum(word("-1")));
    assert_eq!(fault("Kd spectral a.rfl 1").0, What::OtherColour(word("spectral")));
    assert_eq!(fault("Ks xyz 1 1 1").0, What::OtherColour(word("xyz")));
    let count = |statement: &str, found, wanted| What::WrongCount {
        statement: statement.into(),
        found,
        wanted,
    };
    assert_eq!(fault("Kd 1 1"), (count("Kd", 2, "1 or 3 numbers"), 3, word("Kd 1 1")));
    assert_eq!(fault("Kd").0, count("Kd", 0, "1 or 3 numbers"));
    assert_eq!(fault("Kd 1 1 1 1 1").0, count("Kd", 5, "1 or 3 numbers"));
    assert_eq!(fault("Ns").0, count("Ns", 0, "1 number"));
    assert_eq!(fault("illum").0, count("illum", 0, "1 number"));
    let again = read("newmtl a\nnewmtl b\nnewmtl a\n");
    assert_eq!(again.faults[0].what, What::SameName(0..8));
    assert_eq!(read("newmtl\nnewmtl a\n").faults[0].what, What::MissingName);
    assert_eq!(read("Kd 1 1 1\nnewmtl a\n").faults[0].what, What::NoMaterial);
}

#[test]
fn words_that_are_no_statements_are_told_once() {
    let library = read("newmtl a\nkd 1 1 1\nkd 2 2 2\nfoo\n");
    let words: Vec<_> = library.unknown.iter().map(|u| u.value.as_str()).collect();
    assert_eq!(words, ["kd", "foo"]);
}

#[test]
fn what_is_no_mtl_file_is_refused() {
    let refused = |bytes: &[u8]| parse(bytes).unwrap_err().to_string();
    assert_eq!(refused(b"\0"), "is no text: it holds zero bytes");
    assert_eq!(refused(b"Kd 1 1 1\n"), "is no .mtl file: it has no newmtl");
    assert_eq!(refused(b"<?xml version=\"1.0\"?>\n"), "is no .mtl file: it has no newmtl");
}

#[test]
fn absurdly_long_lines_are_clipped() {
    let library = read(format!("newmtl {}\nKd {}\n", "x".repeat(1_000_000), "1 ".repeat(500_000)));
    assert!(library.text.len() < 3000);
    assert_eq!(library.faults.len(), 1);
}

proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let _ = parse(&bytes);
    }

    #[test]
    fn no_change_of_a_valid_file_makes_the_reader_panic(
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let valid = "newmtl a\nKa 0 0 0\nKd 1 \\\n1 1\nNs 9\nd 1\nillum 2\nmap_Kd x.png\nnewmtl b\n";
        let mut bytes = valid.as_bytes().to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            if byte % 3 == 0 { bytes.insert(at, byte) } else { bytes[at] = byte }
        }
        if let Ok(library) = parse(&bytes) {
            let colours = library.materials.iter().filter_map(|m| m.diffuse.as_ref());
            for kd in colours {
                prop_assert!(kd.value.iter().all(|part| part.is_finite() && *part >= 0.0));
                prop_assert!(library.text.get(kd.at.clone()).is_some());
            }
        }
    }
}
