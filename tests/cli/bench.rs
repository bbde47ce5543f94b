//! A folder to work in, with a scene, and the binary run there.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Two small pictures without any file beside.
pub const BALL: &str = "\
scn 1 in m
film: { size: (32, 24) }
camera: perspective { eye: (0, 0, 4), look_at: (0, 0, 0), fov_y: 40 deg }
integrator: direct
sampler: stratified {}
stop: { samples: 4 }
light sun: directional { direction: (-1, -1, -1), irradiance: pi * W/m^2 }
light sky: constant { radiance: rgb(0.8, 0.9, 1) * W/m^2/sr }
material white: diffuse { albedo: 0.8 }
object ball: sphere { center: (0, 0, 0), radius: 1 m, material: white }
object floor: plane { point: (0, -1, 0), normal: y, material: white }

render left { caption: \"Light from the right.\" }
render right { light sun.direction: (1, -1, -1) }
";

pub struct Bench {
    folder: tempfile::TempDir,
}

/// What a run of the binary came to.
pub struct Run {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Bench {
    /// A folder with `ball.scn`.
    pub fn new() -> Self {
        let bench = Self { folder: tempfile::tempdir().unwrap() };
        bench.put("ball.scn", BALL);
        bench
    }

    pub fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.folder.path().join(name)
    }

    pub fn put(&self, name: &str, content: impl AsRef<[u8]>) {
        std::fs::write(self.path(name), content).unwrap();
    }

    /// The binary with these arguments, to be run here.
    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_scn"));
        command.current_dir(self.folder.path()).args(arguments.split_whitespace());
        command
    }

    pub fn run(&self, arguments: &str) -> Run {
        Run::new(self.command(arguments).output().unwrap())
    }

    /// All files below the folder, as paths relative to it.
    pub fn files(&self) -> Vec<String> {
        fn walk(folder: &Path, found: &mut Vec<PathBuf>) {
            for entry in std::fs::read_dir(folder).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() { walk(&path, found) } else { found.push(path) }
            }
        }
        let mut found = Vec::new();
        walk(self.folder.path(), &mut found);
        let mut names: Vec<String> = found
            .iter()
            .map(|path| path.strip_prefix(self.folder.path()).unwrap())
            .map(|path| path.to_string_lossy().replace('\\', "/"))
            .collect();
        names.sort();
        names
    }
}

impl Run {
    pub fn new(output: Output) -> Self {
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        let run = Self {
            code: output.status.code().unwrap_or(-1),
            stdout: text(&output.stdout),
            stderr: text(&output.stderr),
        };
        assert!(!run.stderr.contains("panicked"), "{}", run.stderr);
        run
    }

    /// Ends well, or the test tells what was said.
    pub fn well(self) -> Self {
        self.ends(0)
    }

    pub fn ends(self, code: i32) -> Self {
        assert_eq!(self.code, code, "stdout:\n{}\nstderr:\n{}", self.stdout, self.stderr);
        self
    }

    /// stderr has these words.
    pub fn says(self, words: &str) -> Self {
        assert!(self.stderr.contains(words), "no {words:?} in:\n{}", self.stderr);
        self
    }

    /// The events of `--log json`.
    pub fn events(&self) -> Vec<serde_json::Value> {
        self.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
}

/// The light of an EXR file, without its words: the bits alone.
pub fn bits(path: PathBuf) -> Vec<[u32; 3]> {
    let (layers, _) = scn::files::exr::read(&path).unwrap();
    layers.main.pixels.iter().map(|pixel| pixel.to_array().map(f32::to_bits)).collect()
}

/// One of the words a PNG carries.
pub fn word(path: PathBuf, key: &str) -> Option<String> {
    let words = scn::files::png::read_metadata(&path).unwrap();
    words.into_iter().find(|(k, _)| k == key).map(|(_, value)| value)
}

/// Bits of the layers of a picture, and its words.
type Whole = (Vec<(String, Vec<u32>)>, Vec<(String, String)>);

/// All that an EXR file holds to the last bit, but for the seconds it took.
pub fn whole(path: PathBuf) -> Whole {
    let (layers, mut words) = scn::files::exr::read(&path).unwrap();
    words.retain(|(key, _)| key != "scn:time");
    let picture = |name: &str, picture: &scn::math::Picture| {
        let bits = picture.pixels.iter().flat_map(|pixel| pixel.to_array().map(f32::to_bits));
        (name.to_string(), bits.collect())
    };
    let mut all = vec![picture("", &layers.main)];
    all.extend(layers.named.iter().map(|(name, named)| picture(name, named)));
    let scalars = layers.scalars.iter();
    all.extend(scalars.map(|(name, values)| {
        (name.clone(), values.iter().map(|value| value.to_bits()).collect())
    }));
    (all, words)
}

/// Two EXR files hold the same to the last bit, but for the seconds they took.
pub fn assert_same(a: PathBuf, b: PathBuf) {
    let ((a, words), (b, others)) = (whole(a), whole(b));
    assert_eq!(words, others);
    let names = |all: &[(String, Vec<u32>)]| all.iter().map(|it| it.0.clone()).collect::<Vec<_>>();
    assert_eq!(names(&a), names(&b));
    for ((name, mine), (_, other)) in a.iter().zip(&b) {
        let first = mine.iter().zip(other).position(|(a, b)| a != b);
        assert!(mine.len() == other.len() && first.is_none(), "`{name}`, value {first:?}");
    }
}

/// Other words in a checkpoint or part, with a checksum that fits them.
pub fn forge(path: PathBuf, change: impl FnOnce(&mut serde_json::Value)) {
    use scn::files::checkpoint;
    let version = env!("CARGO_PKG_VERSION");
    let (mut words, taken): (serde_json::Value, scn::render::film::Taken) =
        checkpoint::read(&path, version).unwrap();
    change(&mut words);
    checkpoint::write(&path, version, &words, &taken).unwrap();
}
