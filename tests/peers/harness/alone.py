"""What of scn's speed needs no peer: its threads, what a scene does not require, its previews."""

import json
import tempfile

from . import scenes
from .programs import run

SCENE = "cornell_blocks"

# The ways a scene is rendered, each against the plain one.
WAYS = {"two threads": ("--threads", "2"), "one thread": ("--threads", "1"),
        "all forced": ("--threads", "2", "--force", "all")}


def ways(bench, size, samples, turns, kept, step, save):
    """Renders the blocks in each way, in turn: seconds by the clock and of the processor."""
    for turn in range(turns):
        for way, options in WAYS.items():
            found = kept.setdefault(way, [])
            if len(found) > turn:
                continue
            step(f"{SCENE}: {way}, turn {turn + 1} of {turns}")
            picture = bench.scn.render(SCENE, samples, turn, size, *options)
            found.append({"wall": picture.wall, "cpu": picture.cpu})
            save()


def previews(bench, kept, step, save):
    """A whole process for the preview of each render of the worksheets, full frame: seconds."""
    for path in sorted((scenes.ROOT / "scenes").glob("w*.scn")):
        if path.stem in kept:
            continue
        step(f"{path.name}: previews")
        kept[path.stem] = {
            name: preview(bench, path, "--only", name)[1] for name in names(bench, path)}
        save()


def names(bench, path):
    """The renders of a file, by a small preview of each."""
    out, *_ = preview(bench, path, "--scale", "0.01", "--log", "json")
    events = map(json.loads, out.splitlines())
    return next(event["renders"] for event in events if event["event"] == "loaded")


def preview(bench, path, *options):
    with tempfile.TemporaryDirectory() as folder:
        return run([bench.scn.binary, "render", path, "-o", folder, "--samples", "1",
                    "--set", "integrator=preview", *options])
