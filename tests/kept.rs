//! What was taken of a render, kept as bytes: it comes back as it was, and bytes that were changed are
//! refused or make another picture, never a panic.

mod by_hand;

use scn::prepare::Prepared;
use scn::render::film::Taken;
use scn::run::{self, Begin, Settings, Stopped};

use by_hand::{Patient, render, still_life};

#[test]
fn it_comes_back_as_it_was() {
    let prepared = still_life().size(20, 17).grid(2).prepared();
    for samples in [1, 3, 64, 150] {
        let taken = render(&prepared, 1, samples, &Patient).taken;
        let bytes = postcard::to_stdvec(&taken).unwrap();
        assert_eq!(postcard::from_bytes::<Taken>(&bytes).unwrap(), taken);
        for end in (0..bytes.len()).step_by(97) {
            assert!(postcard::from_bytes::<Taken>(&bytes[..end]).is_err(), "{end}");
        }
    }
}

#[test]
fn changed_bytes_make_no_panic() {
    let prepared = still_life().size(2, 1).prepared();
    let (window, rhythm) = (prepared.world.film.window, prepared.world.sampler.rhythm());
    let whole = render(&prepared, 1, 64 * 3 + 5, &Patient);
    let bytes = postcard::to_stdvec(&whole.taken).unwrap();
    let mut believed = 0;
    let mut look = |bytes: &[u8]| {
        let Ok(taken) = postcard::from_bytes::<Taken>(bytes) else { return };
        let fits = taken.fits(&window, 0, rhythm);
        assert!(!fits || taken.is_sound(&window, 0));
        if !taken.is_sound(&window, 0) {
            return;
        }
        believed += 1;
        run::outcome(&window, 1.0, taken.clone(), Stopped::Samples, 1.0);
        if fits && taken.ends().all(|end| end <= 300) && taken.first() == 0 {
            let begin = Begin { taken, seconds: 0.0 };
            let Prepared { world, integrator, .. } = &prepared;
            run::render(world, integrator, &Settings::samples(1, 300), begin, &Patient);
        }
    };
    for at in 0..bytes.len() {
        for pattern in [0x01, 0x80, 0x7f, 0xff] {
            let mut changed = bytes.clone();
            changed[at] ^= pattern;
            look(&changed);
        }
    }
    // Most of it are sums, which may be anything.
    assert!(believed > bytes.len(), "{believed} of {}", bytes.len());
}
