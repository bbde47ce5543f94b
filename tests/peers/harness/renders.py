"""Pictures by all programs in turn: samples a second, and the time to a relMSE of 0.01; how long a
program takes to begin; whether the pictures agree."""

import hashlib
import os
import sys
import sysconfig
import tempfile
from pathlib import Path

import numpy as np

from . import export, scenes, sky, statistics
from .programs import OURS, VARIANTS, Scn, Worker, run, settings
from .reference import Reference, improve

GOAL = 0.01
# Samples of a pixel in the render that says how many are worth measuring.
PILOT = 16
MITSUBAS = {"mitsuba llvm": "llvm_ad_rgb", "mitsuba scalar": "scalar_rgb"}
# Only on this scene: what they call glass and sky is not held to ours.
OTHERS, OTHERS_ON = ["cycles", "luxcore"], "cornell_blocks"


class Bench:
    """The binary, the folder of all that is written, and the programs there are."""

    def __init__(self, binary, work, programs):
        self.scn, self.work, self.programs = Scn(binary), work, programs

    def key(self, name):
        """What a scene is kept by: its name, its hash, and how it is written for peers."""
        sources = b"".join(Path(part.__file__).read_bytes() for part in (scenes, export, sky))
        return f"{name}-{self.scn.hash(name)[:16]}-{hashlib.sha256(sources).hexdigest()[:8]}"

    def export(self, name):
        """The file of a scene for Mitsuba; written if it is not there."""
        folder = self.work / "scenes" / self.key(name)
        if not (folder / "scene.xml").exists():
            shown, image = scenes.scene(name), None
            if shown.sky:
                folder.mkdir(parents=True, exist_ok=True)
                image = folder / "sky.exr"
                sky.image(self.scn, image)
            export.mitsuba(shown, folder, image)
        return folder / "scene.xml"

    def open(self, name, size, programs):
        """Functions of samples and seed, by the names of programs; and what closes them."""
        opened, renderers = [], {}
        for program in programs:
            if program in OURS:
                more = settings(program)
                renderers[program] = lambda samples, seed, more=more: self.scn.render(
                    name, samples, seed, size, *more)
                continue
            scene = self.export(name) if program in MITSUBAS else name
            worker = Worker(program, scene, size, self.work)
            opened.append(worker)
            renderers[program] = worker.render
        versions = {worker.name: worker.version for worker in opened}
        return renderers, versions, lambda: [worker.close() for worker in opened]

    def of(self, name):
        """The programs that render this scene."""
        others = OTHERS if name == OTHERS_ON else []
        ours = [program for program, (_, _, on) in VARIANTS.items() if name in on]
        return ["scn"] + ours + [p for p in self.programs if p in MITSUBAS or p in others]


def agree(bench, name, size, side, seeds, samples, found):
    """Compares scn with every peer that renders the scene; scalar Mitsuba is the same code."""
    programs = [p for p in bench.of(name) if p != "mitsuba scalar" or "mitsuba llvm" not in
                bench.programs]
    renderers, _, close = bench.open(name, size, programs)
    means = {program: [] for program in programs}
    for seed in range(1, seeds + 1):
        for program in programs:
            values = renderers[program](samples, seed).values.astype(np.float64)
            means[program].append(statistics.blocks(values, side))
    close()
    for program in programs[1:]:
        found[program] = statistics.agreement(means["scn"], means[program])


def start(bench, name, size, program):
    """A whole process that renders one sample a pixel and writes the picture: seconds by the clock
    and of the processor, and bytes at the peak."""
    with tempfile.TemporaryDirectory() as folder:
        if program in OURS:
            command = bench.scn.command(folder, name, 1, 1, size, *settings(program))
        else:
            script = Path(sysconfig.get_path("scripts")) / "mitsuba"
            command = [sys.executable, script, "-m", MITSUBAS[program], "-Dspp=1", f"-Dsize={size}",
                       "-o", os.path.join(folder, "a.exr"), bench.export(name)]
        _, wall, cpu, peak = run(command)
    return {"wall": wall, "cpu": cpu, "peak": peak}


def reference(bench, name, size, wanted, say):
    """The reference of a scene, as good as wanted; made or gone on with if it is not."""
    folder = bench.work / "references"
    folder.mkdir(parents=True, exist_ok=True)
    kept = Reference(folder / f"{bench.key(name)}-{size}.npz")
    if kept.error > wanted:
        programs = [p for p in ("scn", "mitsuba llvm", "mitsuba scalar")
                    if p == "scn" or p in bench.programs][:2]
        renderers, _, close = bench.open(name, size, programs)
        batch = {program: lambda seed, render=render: render(64, seed).values
                 for program, render in renderers.items()}
        improve(kept, batch, wanted, say)
        close()
    return kept


def measure(bench, name, size, turns, budget, against, found, step, save):
    """Renders by all programs in turn, each with about as many samples as reach the goal, or as
    many as the budget of seconds allows."""
    programs = bench.of(name)
    renderers, versions, close = bench.open(name, size, programs)
    found.setdefault("versions", {}).update(versions)
    runs, plan = found.setdefault("runs", {}), found.setdefault("samples", {})
    truth, own = against.mean, against.error
    for program in programs:
        if program not in plan:
            picture = renderers[program](PILOT, 1)
            needed = PILOT * (statistics.relmse(picture.values, truth) - own) / GOAL
            allowed = PILOT * budget / picture.wall
            plan[program] = whole(program, min(needed, allowed))
    for turn in range(turns):
        # Who begins changes: what the machine does meanwhile falls on all.
        for program in programs[turn % len(programs):] + programs[:turn % len(programs)]:
            kept = runs.setdefault(program, [])
            if len(kept) > turn:
                continue
            step(f"{name}: {program}, {plan[program]} samples, turn {turn + 1} of {turns}")
            picture = renderers[program](plan[program], turn + 2)
            kept.append({
                "samples": picture.samples, "wall": picture.wall, "cpu": picture.cpu,
                "peak": picture.peak, "mean": float(picture.values.mean()),
                "relmse": statistics.relmse(picture.values, truth) - own})
            save()
    close()


def whole(program, samples):
    """A number of samples that suits the program: powers of two, and rounds, for scn's points."""
    samples = max(1, round(samples))
    if program not in OURS:
        return samples
    return samples // 64 * 64 if samples >= 64 else 1 << (samples.bit_length() - 1)
