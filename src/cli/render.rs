//! `scn render`: read, check everything, then render one scene at a time.

use std::collections::HashSet;
use std::path::PathBuf;

use super::about::{About, Frame};
use super::asked::Asked;
use super::bar::{Bar, Watcher};
use super::checkpoint::{self, Keeper};
use super::finish::Finish;
use super::log::{self, Event, Loaded, Log, shown};
use super::options::{Form, Render};
use super::output::Output;
use super::replay::{self, Replay};
use super::{End, bias, check, failed, scene_file, stop, terminal};
use crate::cli::words::{NAMES, typed, typed_word};
use crate::diag::words::few;
use crate::diag::{self, Diagnostic, Level, Sources, harmless_line};
use crate::files::hold::Held;
use crate::files::whole::Folders;
use crate::load::{Loader, Stage};
use crate::prepare::{self, Prepared};
use crate::render::tiles::Threads;
use crate::run::{self, Stopped};
use crate::{files, lang};

pub fn run(options: &Render) -> End {
    stop::listen(options.quiet);
    let replayed = options.replay.as_ref().map(|picture| replay::asked(options, picture));
    let (options, replay) = match &replayed {
        None => (options, None),
        Some(Ok((options, replay))) => (options, Some(replay)),
        Some(Err(why)) => return failed(why),
    };
    let all = || Session::new(options, replay).run();
    let ended = match options.threads {
        None => all(),
        Some(count) => match Threads::new(count as usize) {
            Some(threads) => threads.run(all),
            None => {
                terminal::fail(&format!("the system does not give {count} threads"));
                Err(End::NotDone)
            }
        },
    };
    ended.err().unwrap_or(End::Well)
}

/// One run of the command.
struct Session<'a> {
    options: &'a Render,
    replay: Option<&'a Replay>,
    log: Log,
    bar: Bar,
    sources: Sources,
    /// Faults that were told already.
    told: Vec<Diagnostic>,
}

/// A render whose scene is read and free of errors.
struct Ready {
    name: String,
    stage: Stage,
}

/// Where files are to be written, to be given up when all is done.
struct Places {
    /// Checkpoints, which nobody else writes meanwhile. Given up first: they lie in the folders.
    _held: Vec<Held>,
    /// Folders that were made for them and for pictures.
    _folders: Vec<Folders>,
}

impl<'a> Session<'a> {
    fn new(options: &'a Render, replay: Option<&'a Replay>) -> Self {
        let bar = !options.quiet && terminal::stderr_is_terminal();
        Self {
            options,
            replay,
            log: Log { form: options.log, quiet: options.quiet },
            bar: Bar::new(bar),
            sources: Sources::new(),
            told: Vec::new(),
        }
    }

    fn run(mut self) -> Result<(), End> {
        let options = self.options;
        let output =
            Output::new(options.output.as_deref(), &options.file).map_err(|text| failed(&text))?;
        let compiled =
            scene_file::compile(&options.file, &options.set, &options.only, &mut self.sources)
                .ok_or(End::NotDone)?;
        if stop::asked() {
            return Err(self.stopped(None));
        }
        if compiled.diagnostics.iter().any(|d| d.level == Level::Error) {
            self.tell(compiled.diagnostics);
            return Err(End::SceneErrors);
        }
        let chosen = self.chosen(compiled.renders, &compiled.setups, &output)?;
        let ready = self.load(compiled.diagnostics, chosen, &compiled.outline)?;
        let (asked, _places) = self.settings_fit(&ready, &output)?;
        self.tell_loaded(&ready);

        let mut pictures = 0;
        for (render, asked) in ready.iter().zip(&asked) {
            if stop::asked() {
                return Err(self.stopped(Some(&render.name)));
            }
            self.render(render, asked, &output)?;
            pictures += 1;
        }
        self.log.tell(&Event::Done { pictures, seconds: self.bar.seconds() });
        Ok(())
    }

    /// The renders asked for, in the order of the file.
    fn chosen(
        &self,
        renders: Vec<lang::Render>,
        setups: &[String],
        output: &Output,
    ) -> Result<Vec<lang::Render>, End> {
        let (only, file) = (&self.options.only, &self.options.file);
        let chosen =
            scene_file::chosen(renders, setups, only, file).map_err(|text| failed(&text))?;
        match output.single() {
            Some(path) if chosen.len() != 1 => Err(failed(&format!(
                "`{}` holds one picture, but {} renders were asked for\n  choose one with --only \
                 NAME, or give a folder: {}",
                shown(path),
                chosen.len(),
                few(chosen.iter().map(|r| r.name.value.as_str()), NAMES),
            ))),
            _ => Ok(chosen),
        }
    }

    /// Reads the files of all scenes and checks what can be checked before rendering, so that
    /// all errors are told in one run.
    fn load(
        &mut self,
        mut found: Vec<Diagnostic>,
        chosen: Vec<lang::Render>,
        outline: &lang::outline::Outline,
    ) -> Result<Vec<Ready>, End> {
        let settings = self.settings();
        let mut ready = Vec::new();
        let mut names = Vec::new();
        self.bar.begin("Loading");
        let mut loader = Loader::new(&self.bar);
        for render in chosen {
            let (stage, faults) = loader.stage(&render.scene, &mut self.sources);
            found.extend(faults);
            if stop::asked() {
                return Err(self.stopped(None));
            }
            if let Some(stage) = stage {
                let mut faults = prepare::check(&stage, &settings);
                if self.options.unbiased {
                    faults.extend(bias::refused(&stage));
                }
                names.push((render.name.clone(), faults));
                ready.push(Ready { name: render.name.value, stage });
            }
        }
        self.bar.end();
        // Preparing finds the same once more.
        let known: Vec<_> = names.iter().flat_map(|(_, faults)| faults).cloned().collect();
        let (part, changed) = (!self.options.only.is_empty(), !self.options.set.is_empty());
        let staged = names.iter().zip(&ready).map(|((name, faults), ready)| check::Staged {
            name,
            stage: &ready.stage,
            own_limits: !super::limits::given(self.options),
            faults: faults.clone(),
        });
        let found = check::judged(
            found,
            staged.collect(),
            outline,
            &self.sources,
            check::Asked { changed, part },
        );
        let faulty = found.iter().any(|diagnostic| diagnostic.level == Level::Error);
        if stop::asked() {
            return Err(self.stopped(None));
        }
        self.tell(found);
        self.told.extend(known);
        if faulty { Err(End::SceneErrors) } else { Ok(ready) }
    }

    /// Tells of a stop before the first ray: of one render, or while the scene is read.
    fn stopped(&self, render: Option<&str>) -> End {
        self.bar.end();
        let render = render.map(str::to_string);
        self.log.tell(&Event::Interrupted { render, samples: 0, of: None, tiles: None });
        End::Interrupted
    }

    fn settings(&self) -> prepare::Settings {
        prepare::Settings {
            scale: self.options.scale,
            crop: self.options.crop,
            portable: terminal::portable(),
        }
    }

    /// What is asked for, if --scale, --crop and --shard suit the scenes, checkpoints the renders,
    /// and the pictures can be written: found out before the work, not after it. With it come the
    /// places of their files.
    fn settings_fit(&self, ready: &[Ready], output: &Output) -> Result<(Vec<Asked>, Places), End> {
        let (mut all, mut folders) = (Vec::new(), Vec::new());
        for Ready { name, stage } in ready {
            if let Some(unfit) = self.settings().unfit(stage) {
                return Err(failed(&format!("render `{name}`: {unfit}")));
            }
            let asked = Asked::new(name, stage, self.options, self.replay);
            all.push(asked.map_err(|why| failed(&format!("render `{name}`: {why}")))?);
        }
        let _writing = stop::writing();
        let files = ready.iter().flat_map(|render| &render.stage.files).map(|file| &*file.path);
        let read: HashSet<PathBuf> =
            files.chain([&*self.options.file]).map(files::regular::identity).collect();
        let what = if self.options.shard.is_some() { "part" } else { "picture" };
        for path in ready.iter().flat_map(|render| self.files(&render.name, output)) {
            if read.contains(&files::regular::identity(&path)) {
                let why = "would replace a file that the scene is read from";
                return Err(failed(&format!("the {what} `{}` {why}", shown(&path))));
            }
            if self.options.replay.as_deref().map(files::regular::identity)
                == Some(files::regular::identity(&path))
            {
                let why = "is the one that is replayed, and would be replaced";
                let help = "name another file or folder with -o";
                return Err(failed(&format!("the {what} `{}` {why}\n  {help}", shown(&path))));
            }
            folders.push(
                files::whole::ready(&path).map_err(|failure| {
                    failed(&format!("the {what} `{}` {failure}", shown(&path)))
                })?,
            );
        }
        let held = all.iter().map(|asked| checkpoint::hold(self.options, output, asked));
        let held: Result<Vec<_>, _> = held.collect();
        let held = held.map_err(|why| failed(&why))?.into_iter().flatten().collect();
        Ok((all, Places { _held: held, _folders: folders }))
    }

    /// The files that a render is to become: its pictures, or its part.
    fn files(&self, name: &str, output: &Output) -> Vec<PathBuf> {
        match self.options.shard {
            None => output.paths(name).into_iter().collect(),
            Some(shard) => vec![output.beside(name, &shard.suffix("part"))],
        }
    }

    fn tell_loaded(&self, ready: &[Ready]) {
        let mut files: Vec<Loaded> = Vec::new();
        for file in ready.iter().flat_map(|render| &render.stage.files) {
            if files.iter().all(|seen| seen.name != file.name) {
                let (name, bytes) = (file.name.clone(), file.bytes);
                files.push(Loaded { name, bytes, triangles: file.triangles });
            }
        }
        self.log.tell(&Event::Loaded {
            scene: log::name(&self.options.file),
            renders: ready.iter().map(|render| render.name.clone()).collect(),
            files,
            seconds: self.bar.seconds(),
        });
    }

    /// Renders one scene and writes its pictures.
    fn render(&mut self, ready: &Ready, asked: &Asked, output: &Output) -> Result<(), End> {
        let (Ready { name, stage }, options) = (ready, self.options);
        let begun = self.bar.seconds();
        self.bar.begin(&format!("Building {name}"));
        let plan = bias::plan(stage, self.options.force);
        let settings = self.settings();
        let (prepared, found) = prepare::prepare_by(&plan, stage, &settings, &self.bar);
        self.bar.end();
        self.tell(found);
        let Some(mut prepared) = prepared else { return Err(End::SceneErrors) };
        self.log.tell(&Event::Built {
            render: name.clone(),
            hash: stage.hash.to_string(),
            triangles: prepared.summary.triangles,
            other_shapes: prepared.summary.other_shapes,
            materials: prepared.summary.materials,
            lights: prepared.summary.lights,
            slivers: prepared.summary.slivers,
            bytes: prepared.summary.bytes,
            seconds: self.bar.seconds() - begun,
        });
        if stop::asked() {
            return Err(self.stopped(Some(name)));
        }

        let Prepared { world, integrator, .. } = &prepared;
        let (rule, window) = (asked.limits, world.film.window);
        let settings = run::Settings { seed: options.seed, until: asked.until() };
        self.log.tell(&Event::Rendering {
            render: name.clone(),
            width: window.width(),
            height: window.height(),
            film: world.film.size,
            crop: options.crop,
            limits: rule,
            seed: settings.seed,
            shard: asked.slice,
        });
        let begin = checkpoint::begin(options, output, asked, world, self.log);
        let begin = begin.map_err(|why| failed(&why))?;
        if let Some(replay) = self.replay {
            replay.fits(begin.taken.tiles()).map_err(|why| failed(&why))?;
        }
        let frame = Frame::of(world);
        self.bar.begin(&format!("Rendering {name}"));
        let watcher = Watcher::new(&self.bar, self.log, name);
        let keeper = Keeper::new(options, output, asked, &frame, watcher, self.log);
        let outcome = run::render(world, integrator, &settings, begin, &keeper);
        self.bar.end();
        keeper.end(&outcome);

        // The same for a shard as for the whole, so that what is joined tells the same.
        let samples = asked.slice.map_or(outcome.samples, |slice| slice.samples);
        let samples = samples.saturating_mul(window.pixels()) / 50;
        let biases = bias::measured(stage, &mut prepared, samples, &self.sources, &keeper);
        let about = About { biases, ..asked.about.clone() };
        let finish = Finish { log: self.log, about: &about, frame: &frame, rule };
        let object = outcome.invalid.and_then(|invalid| invalid.first.object);
        let object = object.and_then(|number| prepared.objects.get(number as usize));
        let first = object.map(|object| bias::object(&self.sources, object));
        let first = first.as_deref();
        finish.tell(&outcome, first);
        let (tiles, interrupted) = match outcome.stopped {
            Stopped::Interrupted { tiles } => (tiles.map(|it| [it.done, it.of]), true),
            _ => (None, false),
        };
        if interrupted {
            self.log.tell(&Event::Interrupted {
                render: Some(name.clone()),
                samples: outcome.samples,
                of: asked.samples(),
                tiles,
            });
        }
        match asked.slice {
            Some(_) if interrupted && !keeper.keeps() => finish.remark(
                "a part holds all its samples, so none is written; with --checkpoint what is done \
                 is kept"
                    .to_string(),
            ),
            Some(_) if interrupted => {}
            Some(_) => finish.write_part(asked, &outcome, first, &self.files(name, output)[0])?,
            None if tiles.is_none_or(|[done, _]| done > 0) => {
                finish.write(outcome, output.paths(name))?;
            }
            None => {}
        }
        if interrupted { Err(End::Interrupted) } else { Ok(()) }
    }

    /// Tells faults, each once, to people on stderr and to machines in the log.
    fn tell(&mut self, found: Vec<Diagnostic>) {
        let new = found.into_iter().filter(|fault| !self.told.contains(fault)).collect();
        let new = diag::in_order(new, &self.sources);
        if new.is_empty() {
            return;
        }
        let subject = shown(&self.options.file);
        let severe: Vec<Diagnostic> = new
            .iter()
            .filter(|fault| fault.level == Level::Error || !self.options.quiet)
            .cloned()
            .collect();
        if severe.iter().any(|fault| fault.level == Level::Error) {
            let look = terminal::stderr_look();
            terminal::tell(&diag::print::report(&severe, &self.sources, &subject, look));
        } else if !severe.is_empty() {
            let brief = diag::short::lines(&severe, &self.sources);
            let mut more = format!("scn lint {}", typed(&self.options.file));
            for set in &self.options.set {
                more.push_str(&format!(" --set {}", typed_word(set)));
            }
            terminal::tell(&format!("{brief}`{}` tells more\n", harmless_line(&more)));
        }
        if self.options.log == Form::Json {
            let report = diag::json::report(&new, &self.sources);
            self.log.tell(&Event::Diagnostics { report });
        }
        self.told.extend(new);
    }
}
