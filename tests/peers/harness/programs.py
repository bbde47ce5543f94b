"""The programs compared, each asked for a picture in the same way."""

import json
import os
import re
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from . import pictures
from .memory import peak_memory

HERE = Path(__file__).resolve().parents[1]
SCENES = HERE / "scenes.scn"


@dataclass
class Picture:
    """A picture, the samples of each pixel, the seconds it took by the clock and of the processor,
    and bytes at the peak."""
    values: np.ndarray
    samples: int
    wall: float
    cpu: float
    peak: int | None


# Scn once more, with settings that are not its default: what they are called, and where they pay.
GUIDE, SHARE = "integrator.guide=photons", "integrator.reuse={}"
BALLS = ["two_spheres", "gold_and_glass"]
VARIANTS = {
    "scn sharing": ("scn, sharing light", [SHARE.format(32)], ["cornell_blocks"]),
    "scn guided": ("scn, guided by photons", [GUIDE], BALLS),
    "scn guided sharing": ("scn, guided, sharing light", [GUIDE, SHARE.format(16)], BALLS),
}
OURS = ["scn", *VARIANTS]


def settings(program):
    """Arguments that make scn this program."""
    _, sets, _ = VARIANTS.get(program, (None, [], None))
    return [word for given in sets for word in ("--set", given)]


# How often a program that runs is asked for its memory, in seconds.
WATCH = 0.002


def run(command):
    """Runs a program to its end: its stdout, seconds by the clock and of the processor, and bytes
    at the peak or None."""
    begun, peak, status = time.perf_counter(), None, None
    with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as errors:
        child = subprocess.Popen(command, stdout=out, stderr=errors)
        while status is None:
            # `ru_maxrss` of a child is never less than what its parent had.
            peak = peak_memory(child.pid) or peak
            done, ended, usage = os.wait4(child.pid, os.WNOHANG)
            if done:
                status = os.waitstatus_to_exitcode(ended)
            else:
                time.sleep(WATCH)
        wall, child.returncode = time.perf_counter() - begun, status
        out.seek(0)
        errors.seek(0)
        told = out.read()
        if status != 0:
            raise RuntimeError(f"{' '.join(map(str, command))}:\n{told}\n{errors.read()}")
    return told, wall, usage.ru_utime + usage.ru_stime, peak


class Scn:
    """scn itself: a process a picture."""

    def __init__(self, binary):
        self.binary = binary
        self.name = "scn"

    def version(self):
        out, *_ = run([self.binary, "--version"])
        return out.strip()

    def command(self, folder, name, samples, seed, size, *more):
        return [self.binary, "render", SCENES, "--only", name, "-o", folder, "--log", "json",
                "--seed", str(seed), "--samples", str(samples), "--scale", repr(size / 512), *more]

    def render(self, name, samples, seed, size, *more):
        """With more arguments; where photons are sent the seconds of that count."""
        counted = ("built", "rendered") if GUIDE in more else ("rendered",)
        with tempfile.TemporaryDirectory() as folder:
            out, _, cpu, peak = run(self.command(folder, name, samples, seed, size, *more))
            events = [json.loads(line) for line in out.splitlines()]
            wall = sum(e["seconds"] for e in events if e["event"] in counted)
            values = pictures.read(Path(folder) / f"{name}.exr")
        return Picture(values, samples, wall, cpu, peak)

    def pictures(self, names, samples):
        """Renders of scenes.scn by their names."""
        with tempfile.TemporaryDirectory() as folder:
            only = [word for name in names for word in ("--only", name)]
            run([self.binary, "render", SCENES, *only, "-o", folder, "-q",
                 "--samples", str(samples)])
            return {name: pictures.read(Path(folder) / f"{name}.exr") for name in names}

    def hash(self, name):
        """The scene's, with its files, whatever the samples."""
        with tempfile.TemporaryDirectory() as folder:
            out, *_ = run(self.command(folder, name, 1, 0, 8))
        return re.search(r'"hash":"(\w+)"', out)[1]


class Worker:
    """A peer that waits in a process of its own, one scene loaded."""

    def __init__(self, kind, scene, size, work):
        self.name, self.size = kind, size
        self.file = work / f"{kind.replace(' ', '_')}.npy"
        self.log = open(work / f"{kind.replace(' ', '_')}.log", "w")
        self.process = subprocess.Popen(
            [sys.executable, "-m", "harness.worker", kind, str(scene), str(size)], cwd=HERE,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.log, text=True)
        self.version = self.answer()["version"]

    def answer(self):
        line = self.process.stdout.readline()
        if not line:
            raise RuntimeError(f"{self.name} ended early; see {self.log.name}")
        return json.loads(line)

    def render(self, samples, seed):
        asked = {"samples": samples, "seed": seed, "file": str(self.file)}
        print(json.dumps(asked), file=self.process.stdin, flush=True)
        told = self.answer()
        return Picture(np.load(self.file), **told)

    def close(self):
        self.process.stdin.close()
        self.process.wait()
        self.log.close()
