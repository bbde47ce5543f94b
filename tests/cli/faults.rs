//! What goes wrong: exit codes, words, and files left alone.

use crate::bench::{BALL, Bench, Run};

#[test]
fn a_scene_file_that_cannot_be_read_is_no_scene() {
    let bench = Bench::new();
    let run = bench.run("render bell.scn").ends(2).says("the scene file `bell.scn` does not exist");
    run.says("looked for: ").says(&bench.path("bell.scn").display().to_string());
    bench.run("render ball").ends(2).says("did you mean `ball.scn`?");
    bench.run("render .").ends(2).says("is a folder");
    bench.put("bytes.scn", b"scn 1 in m\n\xff\xfe");
    bench.run("render bytes.scn").ends(2).says("is not UTF-8 text: line 2");
    bench.run("lint bell.scn ball.scn").ends(2).says("`bell.scn` does not exist");
}

#[cfg(target_os = "linux")]
#[test]
fn a_device_is_no_scene() {
    let bench = Bench::new();
    for device in ["/dev/zero", "/dev/null", "/dev/full"] {
        bench.run(&format!("render {device}")).ends(2).says("is a device");
    }
}

#[test]
fn with_errors_nothing_is_rendered_and_nothing_lost() {
    let bench = Bench::new();
    std::fs::create_dir_all(bench.path("out/bad")).unwrap();
    bench.put("out/bad/left.png", "old");
    // Two errors in two renders: both are told, and the render without a fault is not made.
    let bad = format!("{BALL}\nrender a {{ stop.samples: 0 }}\nrender b {{ film.size: (0, 9) }}\n");
    bench.put("bad.scn", bad);
    let run = bench.run("render bad.scn").ends(1);
    assert!(run.stderr.contains("2 errors in bad.scn"), "{}", run.stderr);
    assert_eq!(run.stdout, "");
    assert_eq!(bench.files(), ["bad.scn", "ball.scn", "out/bad/left.png"]);
    assert_eq!(std::fs::read(bench.path("out/bad/left.png")).unwrap(), b"old");
}

#[test]
fn faults_of_files_and_of_geometry_are_told_before_anything_is_rendered() {
    let bench = Bench::new();
    let bad = format!(
        "{BALL}\nrender mesh {{ object m: mesh {{ file: \"no.obj\", unit: m, material: white }} }}\n\
         render up {{ camera.up: z }}\n"
    );
    bench.put("bad.scn", bad);
    let run = bench.run("render bad.scn").ends(1).says("no.obj").says("2 errors in bad.scn");
    assert!(!run.stdout.contains("left"), "{}", run.stdout);
    assert_eq!(bench.files(), ["bad.scn", "ball.scn"]);
}

#[test]
fn a_folder_that_cannot_be_written_is_found_before_rendering() {
    let bench = Bench::new();
    bench.put("out", "a file in the way");
    let run = bench.run("render ball.scn --log json").ends(2);
    let run =
        run.says("the picture `out/ball/left.exr` needs the folder").says("a file is in its way");
    assert_eq!(run.stdout, "");
    bench.run("render ball.scn --only left -o ball.scn/a.png").ends(2).says("a file is in its way");
    assert_eq!(bench.files(), ["ball.scn", "out"]);
}

#[cfg(target_os = "linux")]
#[test]
fn devices_are_no_place_for_pictures() {
    let bench = Bench::new();
    bench.put("ball.scn", BALL);
    let link = bench.path("full.png");
    std::os::unix::fs::symlink("/dev/full", link).unwrap();
    bench.run("render ball.scn --only left -o full.png").ends(2).says("is a device");
}

#[test]
fn options_out_of_range_are_refused() {
    let bench = Bench::new();
    for (options, words) in [
        ("--threads 0", "--threads"),
        ("--samples 0", "--samples"),
        ("--scale -1", "-1"),
        ("--crop 1,2,3", "write four numbers"),
        ("--frobnicate", "--frobnicate"),
        ("ball.scn", "unexpected argument"),
    ] {
        bench.run(&format!("render ball.scn {options}")).ends(2).says(words);
    }
    assert_eq!(bench.files(), ["ball.scn"]);
}

#[test]
fn a_film_that_fills_the_memory_is_refused_and_a_long_one_rendered() {
    let bench = Bench::new();
    bench.put("wide.scn", BALL.replace("(32, 24)", "(65536, 65536)"));
    bench.run("render wide.scn").ends(1).says("error[scene/too-much-memory]");
    // A part of it is no trouble.
    bench.run("render wide.scn --only left --crop 0,0,9,9 --samples 1").well();
    bench.put("long.scn", BALL.replace("(32, 24)", "(1, 65535)"));
    bench.run("render long.scn --only left --samples 1").well();
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    let bench = Bench::new();
    for arguments in ["list mesh", "explain", "render ball.scn --only left", "lint ball.scn"] {
        let mut command = bench.command(arguments);
        let mut child = command.stdout(std::process::Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        assert_eq!(child.wait().unwrap().code(), Some(0), "{arguments}");
    }
    assert!(bench.path("out/ball/left.png").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text_work() {
    use std::os::unix::ffi::OsStrExt;
    let bench = Bench::new();
    let name = std::ffi::OsStr::from_bytes(b"caf\xe9.scn");
    std::fs::write(bench.path(name), BALL).unwrap();
    let done = bench.command("render --only left").arg(name).output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let folder = bench.path("out").join(std::ffi::OsStr::from_bytes(b"caf\xe9"));
    assert!(folder.join("left.png").exists());
    // A single render is named like the file, as far as that is text.
    let single = BALL.split("render left").next().unwrap();
    std::fs::write(bench.path(name), single).unwrap();
    let done = bench.command("render").arg(name).output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 4);
}

#[test]
fn lint_tells_all_faults_of_all_files() {
    let bench = Bench::new();
    assert_eq!(bench.run("lint ball.scn").well().stdout, "");
    bench.put("bad.scn", BALL.replace("albedo: 0.8", "albedo: -0.8"));
    let run = bench.run("lint ball.scn bad.scn").ends(1);
    assert!(run.stdout.contains("bad.scn:9:"), "{}", run.stdout);
    assert!(run.stdout.contains("1 error in bad.scn"), "{}", run.stdout);

    let run = bench.run("lint ball.scn bad.scn --format json").ends(1);
    let report: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!((&report["errors"], &report["warnings"]), (&1.into(), &0.into()));
    let fault = &report["diagnostics"][0];
    assert_eq!(fault["level"], "error");
    assert_eq!(fault["labels"][0]["file"], "bad.scn");
    assert_eq!(fault["labels"][0]["line"], 9);
    let code = fault["code"].as_str().unwrap();
    assert!(bench.run(&format!("explain {code}")).well().stdout.starts_with("# "));

    bench.run("lint bad.scn --set film.size=(0,0)").ends(1);
}

#[test]
fn a_fault_of_one_render_among_several_names_it() {
    let bench = Bench::new();
    let dark = format!(
        "{BALL}render dark {{ without light sun }}\nrender too: dark {{ film.exposure: 1 ev }}\n"
    );
    bench.put("dark.scn", &dark);
    let told = bench.run("lint dark.scn").well().stdout;
    assert!(told.contains("scene/nothing-shines"), "{told}");
    assert!(
        told.split_whitespace().collect::<Vec<_>>().join(" ").contains("renders `dark`"),
        "{told}"
    );
    // Told once by render too, though it looks twice.
    let run = bench.run("render dark.scn --log json").well();
    assert_eq!(run.stderr.matches("warning[").count(), 1, "{}", run.stderr);
    // Where all have it there is nothing to tell apart.
    let run = bench.run("render dark.scn --only dark").well();
    assert!(
        run.stderr.contains("nothing-shines") && !run.stderr.contains("(in "),
        "{}",
        run.stderr
    );
}

#[test]
fn a_file_that_only_defines_things_has_no_picture() {
    let bench = Bench::new();
    bench.put("lib.scn", "scn 1 in m\n\nsetup fine { stop.samples: 64 }\n");
    let run = bench.run("render lib.scn").ends(2);
    let run = run.says("`lib.scn` asks for no picture: it only defines things for others");
    assert_eq!(run.stdout, "");
    bench.run("lint lib.scn").well();
}

#[cfg(target_os = "linux")]
#[test]
fn what_was_asked_for_and_could_not_be_written_is_not_done() {
    let bench = Bench::new();
    bench.put("bad.scn", "scn 1 in m\nfilm.size: (0, 0)\n");
    for arguments in [
        "lint ball.scn --format json",
        "lint bad.scn",
        "list",
        "explain",
        "--help",
        "render ball.scn --log json",
    ] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let run = bench.command(arguments).stdout(full).output().unwrap();
        assert_eq!(run.status.code(), Some(2), "{arguments}");
        assert!(String::from_utf8_lossy(&run.stderr).contains("could not be written"));
    }
}

#[test]
fn control_characters_in_arguments_are_shown_not_obeyed() {
    let bench = Bench::new();
    let run = bench.command("render").arg("\u{1b}[31mred.scn").output().unwrap();
    let told = String::from_utf8_lossy(&run.stderr);
    assert!(!told.contains('\u{1b}') && told.contains("\u{241b}[31mred.scn"), "{told}");
}

#[cfg(unix)]
#[test]
fn a_file_is_used_where_the_disk_says_it_is_and_once() {
    let bench = Bench::new();
    std::fs::create_dir_all(bench.path("other/deep")).unwrap();
    std::os::unix::fs::symlink("other/deep", bench.path("link")).unwrap();
    bench.put("other/lib.scn", "scn 1 in m\nlet which = 5\n");
    bench.put("lib.scn", "scn 1 in m\nlet which = 7\n");
    bench.put(
        "same.scn",
        format!(
            "{BALL}\nuse \"link/../lib.scn\"\nuse \"other/lib.scn\"\nrender \"w_{{which}}\" {{}}\n"
        ),
    );
    bench.run("lint same.scn").ends(0);
    bench.run("render same.scn --only w_5 -o a.png").ends(0);
}

#[test]
fn a_setup_is_not_drawn_by_itself() {
    let bench = Bench::new();
    bench.put("fine.scn", format!("{BALL}setup fine {{ stop.samples: 9 }}\n"));
    let run = bench.run("render fine.scn --only fine").ends(2);
    run.says("`fine` is a setup, which is not drawn by itself").says("render fine_alone: fine {}");
}

#[test]
fn a_picture_never_replaces_what_the_scene_is_read_from() {
    let bench = Bench::new();
    let mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    bench.put("m.png", mesh);
    let scene = format!(
        "{BALL}\nrender mesh {{ object m: mesh {{ file: \"m.png\", unit: m, material: white }} }}\n"
    );
    bench.put("scene.exr", &scene);
    let why = "would replace a file that the scene is read from";
    bench.run("render scene.exr --only mesh -o ./m.png").ends(2).says(why);
    bench.run("render scene.exr --only left -o scene.exr").ends(2).says(why);
    assert_eq!(std::fs::read(bench.path("m.png")).unwrap(), mesh.as_bytes());
    assert_eq!(std::fs::read(bench.path("scene.exr")).unwrap(), scene.as_bytes());
    bench.run("render scene.exr --only mesh -o other.png").ends(0);
}

#[test]
fn light_and_albedo_of_any_size_are_rendered_or_refused() {
    let bench = Bench::new();
    let scene = |albedo: &str, emission: &str, irradiance: &str, radiance: &str| {
        format!(
            "scn 1 in m\nfilm: {{ size: (4, 4) }}\nstop: {{ samples: 1 }}\nintegrator: direct\n\
             camera: perspective {{ eye: (0, 0, 4), look_at: (0, 0, 0), fov_y: 40 deg }}\n\
             material m: diffuse {{ albedo: {albedo}, emission: {emission} * 1 W/m^2/sr }}\n\
             object ball: sphere {{ center: (0, 0, 0), radius: 1 m, material: m }}\n\
             light sun: directional {{ direction: -z, irradiance: {irradiance} * 1 W/m^2 }}\n\
             light sky: constant {{ radiance: {radiance} * 1 W/m^2/sr }}\n"
        )
    };
    for (size, refused) in [
        ("1e-300", false),
        ("1e-30", false),
        ("1", false),
        ("1e36", false),
        ("1e40", true),
        ("1e306", true),
        ("5e306", true),
        ("1e308", true),
    ] {
        for spectrum in [
            format!("spectrum {{ 500 nm: {size}, 600 nm: {size} }}"),
            format!("upsample(rgb({size}, {size}, {size}))"),
            format!("upsample(rgb({size}, 0, 0))"),
        ] {
            for field in 0..4 {
                let mut said = ["0.5"; 4];
                said[field] = &spectrum;
                let [albedo, emission, irradiance, radiance] = said;
                bench.put("size.scn", scene(albedo, emission, irradiance, radiance));
                let run = bench.run("render size.scn");
                let (first, second) = (&*run.stderr, said.join(" | "));
                assert_eq!(first.contains("scene/too-bright"), refused, "{second}: {first}");
                assert_eq!(first.matches("error[").count(), usize::from(refused), "{first}");
                assert!(!first.contains("NaN") && !first.contains("finite"), "{second}: {first}");
                run.ends(i32::from(refused));
            }
        }
    }
}

#[test]
fn data_that_cannot_be_read_comes_with_what_to_do() {
    let bench = Bench::new();
    bench.put("paint.csv", "nm, value\n400, 0.5 # measured, twice\n700, 0.6# and once\n");
    bench.put("large.csv", vec![b' '; 8_000_001]);
    bench.put("bytes.csv", b"# caf\xe9\n400, 0.5\n");
    std::fs::create_dir(bench.path("folder")).unwrap();
    let run = |data: &str| {
        let albedo = format!("albedo: {data}");
        bench.put("my.scn", crate::bench::BALL.replace("albedo: 0.8", &albedo));
        bench.run("lint my.scn")
    };
    run("data(\"paint.csv\")").ends(0);
    for (data, headline, help) in [
        ("data(\"missing.csv\")", "`missing.csv` does not exist", "correct the name"),
        ("data(\"large.csv\")", "`large.csv` is larger than 8 MB", "leave out rows"),
        ("data(\"bytes.csv\")", "`bytes.csv` is not UTF-8 text", "save the file as UTF-8"),
        ("data(\"folder\")", "`folder` is a folder", "name a file in that folder"),
        ("data(\"\")", "`data` names no file", "such as `data(\"paint.csv\")`"),
        ("data(\"x\", nm, 3)", "takes 1 or 2 arguments, and here stand 3", "`data(file, unit)`"),
    ] {
        let told = run(data).ends(1).stdout;
        assert!(told.contains(headline) && told.contains(help), "{data}: {told}");
    }
    let told = run("data(\"missing.csv\")").stdout;
    let place = bench.path("missing.csv");
    assert!(told.contains(&format!("looked for at {}:", place.display())), "{told}");
}

#[test]
fn one_set_says_one_thing() {
    let bench = Bench::new();
    for (said, right) in [
        (
            "integrator.light_samples=4, shadows=off",
            "write `--set 'integrator.light_samples=4' --set 'integrator.shadows=off'`",
        ),
        (
            "caption=\"a, b=c\", film.size=(3, 4), exposure=1 ev",
            "write `--set 'caption=\"a, b=c\"' --set 'film.size=(3, 4)' --set 'film.exposure=1 ev'`",
        ),
        ("integrator.light_samples=4, 5", "expected an operator, or the end, found `,`"),
    ] {
        let run = bench.command("lint ball.scn --format json").args(["--set", said]).output();
        let told = Run::new(run.unwrap()).ends(1).stdout.replace("\\\"", "\"");
        assert!(told.contains(right), "{said}\n{told}");
    }
}
