//! `scn paths`, and layers in files.

use scn::files;

use crate::bench::Bench;

/// A caustic of a mirror on the floor, and light from the wall.
const MIRROR: &str = "\
scn 1 in m
film: { size: (24, 18) }
camera: perspective { eye: (0, 2, 5), look_at: (0, 0.7, 0), fov_y: 40 deg }
integrator: path
stop: { samples: 128 }
sampler: independent {}
medium crown: homogeneous { ior: 1.5 }
material white: diffuse { albedo: 0.7 }
material bright: diffuse { albedo: 0, emission: 20 W/m^2/sr }
object floor: disk { center: (0, 0, 0), normal: y, radius: 3 m, material: white }
object wall: quad { corner: (-3, 0, -1), u: (6, 0, 0), v: (0, 3, 0), material: white }
object silver: sphere { center: (-0.9, 0.6, 0), radius: 0.6 m, material: mirror {} }
object ball: sphere { center: (0.9, 0.7, 0), radius: 0.6 m, material: dielectric { inside: crown } }
object lamp: disk { center: (1, 3, 1), normal: (-1, -3, -1), radius: 0.9 m, material: bright }
layer direct: paths { only: \"L D E\" }
layer caustics: paths { only: \"L S+ D E\" }
layer rest: paths { only: others }
";

fn bench() -> Bench {
    let bench = Bench::new();
    bench.put("mirror.scn", MIRROR);
    bench
}

#[test]
fn what_is_listed_of_a_pixel_is_the_pixel() {
    let bench = bench();
    bench.run("render mirror.scn -q").well();
    let (layers, _) = files::exr::read(&bench.path("out/mirror/mirror.exr")).unwrap();
    for (x, y) in [(12, 14), (6, 12), (17, 10)] {
        let arguments = format!("paths mirror.scn --pixel {x},{y} --samples 128 --format json");
        let run = bench.run(&arguments).well();
        let told: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        let channels = |value: &serde_json::Value| -> [f64; 3] {
            [0, 1, 2].map(|channel| value[channel].as_f64().unwrap())
        };
        let mut sum = [0.0; 3];
        let (mut paths, mut part) = (0, 0.0);
        for class in told["classes"].as_array().unwrap() {
            let radiance = channels(&class["radiance"]);
            (0..3).for_each(|i| sum[i] += radiance[i]);
            paths += class["paths"].as_u64().unwrap();
            part += class["part"].as_f64().unwrap();
        }
        assert_eq!(told["paths"], paths);
        assert!((part - 1.0).abs() < 1e-9);
        let pixel = layers.main.at(x, y).to_array().map(f64::from);
        for i in 0..3 {
            assert!((sum[i] / pixel[i] - 1.0).abs() < 1e-5, "{x},{y}: {sum:?} {pixel:?}");
            assert!((channels(&told["radiance"])[i] / sum[i] - 1.0).abs() < 1e-9);
        }
        // A class is what its layer is.
        let direct = layers.named.iter().find(|(name, _)| name == "direct").unwrap();
        let of_layer = f64::from(direct.1.at(x, y).g);
        let class = told["classes"].as_array().unwrap().iter().find(|it| it["class"] == "L D E");
        let of_class = class.map_or(0.0, |class| channels(&class["radiance"])[1]);
        assert!((of_class - of_layer).abs() <= 1e-5 * of_layer, "{of_class} {of_layer}");
    }
}

#[test]
fn drawings_are_written_and_paths_listed() {
    let bench = bench();
    let run = bench.run("paths mirror.scn --pixel 12,14 --top 2").well();
    for words in [
        "mirror.scn, mirror: pixel 12,14 of 24 × 18, 1,024 samples\n",
        "\n  L D E  ",
        "\n  all  ",
        " 100.0 % ",
        "\n  1. L ",
        "\n  2. L ",
        "  pink\n",
        "\n  wrote  out/mirror/mirror.paths.png\n         out/mirror/mirror.paths.svg\n",
    ] {
        assert!(run.stdout.contains(words), "{words:?} is not in:\n{}", run.stdout);
    }
    assert!(run.stdout.lines().all(|line| line.chars().count() <= 80), "{}", run.stdout);
    let (drawn, words) = files::png::read(&bench.path("out/mirror/mirror.paths.png")).unwrap();
    assert_eq!([drawn.width, drawn.height], [24, 18]);
    let word = |key: &str| words.iter().find(|(name, _)| name == key).map(|(_, word)| &**word);
    for (key, value) in [
        ("scn:paths", "mirror, pixel 12,14"),
        ("scn:scene", "mirror.scn"),
        ("scn:render", "mirror"),
        ("scn:seed", "0"),
        ("scn:samples", "1024"),
    ] {
        assert_eq!(word(key), Some(value), "{key}");
    }
    let of_render = {
        bench.run("render mirror.scn -q --samples 2 -o render.png").well();
        files::png::read_metadata(&bench.path("render.png")).unwrap()
    };
    let hash = of_render.iter().find(|(name, _)| name == "scn:hash").unwrap();
    assert!(words.contains(hash), "{words:?}");
    bench
        .run("render mirror.scn --replay out/mirror/mirror.paths.png -o again.png")
        .ends(2)
        .says("`out/mirror/mirror.paths.png` is a drawing of paths of light, and no render");
    // Pink is drawn somewhere.
    assert!(drawn.pixels.iter().any(|pixel| pixel.r > 0.5 && pixel.r > 2.0 * pixel.g));
    let svg = std::fs::read_to_string(bench.path("out/mirror/mirror.paths.svg")).unwrap();
    assert!(svg.contains("#ff69b4") && svg.contains("<title>L S_r D E: "), "{svg:.300}");

    bench.run("render mirror.scn -q --samples 2 -o rough.png").well();
    let run = bench.run("paths mirror.scn --pixel 12,14 --over rough.png --by class -o x.svg");
    assert!(run.well().stdout.ends_with("wrote  x.svg\n"));
    // The same run, the same drawing.
    let before = std::fs::read(bench.path("x.svg")).unwrap();
    bench.run("paths mirror.scn --pixel 12,14 --over rough.png --by class -o x.svg").well();
    assert_eq!(std::fs::read(bench.path("x.svg")).unwrap(), before);
}

#[test]
fn what_cannot_be_drawn_is_told() {
    let bench = bench();
    bench.put("kept", "a note");
    for (arguments, words) in [
        ("paths mirror.scn --pixel 24,0", "there is no pixel 24,0 in a picture of 24 × 18"),
        ("paths mirror.scn --pixel 24", "write two whole numbers, column and row"),
        ("paths mirror.scn --pixel -1,3", "write two whole numbers, column and row"),
        ("paths mirror.scn", "--pixel <x,y>"),
        ("paths ball.scn --pixel 1,1", "`ball.scn` has 2 renders\n  write which one"),
        ("paths ball.scn lft --pixel 1,1", "did you mean `left`?"),
        ("paths mirror.scn --pixel 1,1 -o a.exr", "drawings are written as .png and .svg"),
        ("paths mirror.scn --pixel 1,1 -o mirror.scn", "as .png and .svg, not as .scn"),
        ("paths mirror.scn --pixel 1,1 -o .svg", "needs a name before .svg"),
        ("paths mirror.scn --pixel 1,1 -o kept", "something of this name that is no folder"),
        ("paths mirror.scn --pixel 1,1 -o /dev/null", "something of this name that is no folder"),
        ("paths mirror.scn --pixel 1,1 --over none.png", "the picture `none.png`"),
        ("paths mirror.scn --pixel 1,1 --over mirror.scn", "is neither .exr nor .png"),
        ("paths mirror.scn --pixel 1,1 --samples 0", "write a whole number from 1 to 16777216"),
        ("paths mirror.scn --pixel 1,1 --set integrator=preview", "follows no light"),
    ] {
        bench.run(arguments).ends(2).says(words);
    }
    bench.run("paths mirror.scn --pixel 1,1 --set camera=none").ends(1).says("`none`");
    bench.run("paths ball.scn left --pixel 1,1 --samples 4 --lines 0 --top 0").well();
    bench.run("render mirror.scn -q --samples 1 --scale 0.5 -o half.exr").well();
    let run = bench.run("paths mirror.scn --pixel 1,1 --over half.exr").ends(2);
    run.says("is of 12 × 9, and the film of 24 × 18");
}

#[test]
fn layers_go_through_checkpoints_parts_and_comparisons() {
    let bench = bench();
    let layers = |name: &str| files::exr::read(&bench.path(name)).unwrap().0.named;
    bench.run("render mirror.scn -q --samples 150 -o whole.exr").well();
    let whole = layers("whole.exr");
    let names: Vec<&str> = whole.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["caustics", "direct", "error", "rest"]);

    bench.run("render mirror.scn -q --samples 64 --checkpoint -o kept.exr").well();
    bench.run("render mirror.scn -q --samples 150 --resume -o kept.exr").well();
    assert!(layers("kept.exr") == whole);
    for shard in ["1/2", "2/2"] {
        bench.run(&format!("render mirror.scn -q --samples 150 --shard {shard} -o p.exr")).well();
    }
    bench.run("merge p.1-of-2.part p.2-of-2.part -q -o merged.exr").well();
    assert!(layers("merged.exr") == whole);
    let run = bench.run("compare kept.exr merged.exr").well();
    let words = run.stdout.split_whitespace().collect::<Vec<_>>().join(" ");
    let layers = "--layer NAME compares a layer: `caustics`, `direct` and `rest`.";
    assert!(words.contains(layers), "{}", run.stdout);
    let run = bench.run("compare kept.exr merged.exr --layer caustics --format json").well();
    let told: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(told["settings"]["layer"], "caustics");
    let run = bench.run("compare kept.exr merged.exr --layer caustic").ends(2);
    run.says("has no layer `caustic`\n  it has `caustics`, `direct`, `error` and `rest`");
    // A layer is less light than all.
    bench.run("compare whole.exr whole.exr --layer direct --fail-if relmse>0").well();

    // A layer more is another picture to go on with.
    bench.put(
        "more.scn",
        MIRROR.replace("layer rest", "layer mirrored: paths { only: \"L .* S E\" }\nlayer rest"),
    );
    std::fs::rename(bench.path("kept.checkpoint"), bench.path("more.checkpoint")).unwrap();
    let run = bench.run("render more.scn -q --samples 200 --resume -o more.exr").ends(2);
    run.says("is of another render");
}

#[test]
fn layers_have_names_that_channels_can_have() {
    let bench = bench();
    for (names, words) in [
        (["error", "b"], "a layer cannot be called `error`"),
        (["error.R", "b"], "a layer cannot be called `error.R`"),
        (["samples.Y", "b"], "a layer cannot be called `samples.Y`"),
        (["R", "b"], "a layer cannot be called `R`"),
        (["a.g", "b"], "a layer cannot be called `a.g`"),
        (["a..b", "b"], "`a..b` cannot be the name of a layer"),
        (["all", "All"], "the layers `all` and `All` differ by case alone"),
    ] {
        let [a, b] = names;
        let layers = format!(
            "layer \"{a}\": paths {{ only: \"L D E\" }}\nlayer \"{b}\": paths {{ only: others }}\n"
        );
        let without = MIRROR.lines().filter(|line| !line.starts_with("layer"));
        let text = without.chain(layers.lines()).collect::<Vec<_>>().join("\n");
        bench.put("named.scn", format!("{text}\n"));
        let told = bench.run("lint named.scn --select paths").ends(1).stdout;
        assert!(told.contains(words), "no {words:?} in:\n{told}");
    }
}

#[test]
fn a_picture_of_all_paths_that_there_are_is_not_biased() {
    let bench = bench();
    let run = |paths: &str| {
        let set = format!("integrator.paths=\"{paths}\"");
        let mut command = bench.command("render mirror.scn -q --samples 1 --unbiased --set");
        command.arg(set).output().unwrap().status.code()
    };
    assert_eq!(run("L .* E"), Some(0));
    // There is nothing glossy.
    assert_eq!(run("L (D | S)* E"), Some(0));
    assert_eq!(run("L S* D E"), Some(1));
}

#[test]
fn all_that_makes_caustics_of_a_light_without_extent_is_named() {
    let bench = bench();
    let sun = "light sun: directional { direction: -y, irradiance: 1 W/m^2 }\n";
    bench.put("sun.scn", format!("{MIRROR}{sun}"));
    let run = bench.run("render sun.scn -q --samples 1 --unbiased").ends(1);
    let words = run.stderr.split_whitespace().filter(|word| *word != "│").collect::<Vec<_>>();
    let told = "`light sun`, `object ball.material` and `object silver.material` under `path` make \
                the picture systematically wrong";
    assert!(words.join(" ").contains(told), "{}", run.stderr);
}
