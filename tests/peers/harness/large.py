"""Scenes larger than those of the worksheets: 10 million triangles, and a thousand dragons that are
instances of one. What memory they take, and what `scn plan` said of it before."""

import json
import math
import subprocess
import tempfile
from pathlib import Path

from . import rays
from .programs import run

# Cells along a side of the sheet of waves, two triangles each: 10,008,338.
CELLS = 2237

# What a scene takes, with the writing of its files, about.
SECONDS = 50

WHITE = """scn 1 in m

integrator: path
stop: { samples: 4 }
light sky: constant { radiance: 1 W/m^2/sr }
material white: diffuse { albedo: 0.5 }
"""
SHEET = WHITE + """film: { size: (256, 256) }
camera: perspective { eye: (0.5, 0.6, -0.6), look_at: (0.5, 0, 0.5), fov_y: 60 deg }
object sheet: mesh { file: "waves.obj", unit: m, material: white }
render waves { caption: "A sheet of waves." }
"""
ROWS = WHITE + """film: { size: (480, 270) }
camera: perspective { eye: (0, 4, -6), look_at: (0, 0, 10), fov_y: 40 deg }
object ground: plane { point: (0, 0, 0), normal: y, material: white }
for i in 0 to 24 {
    for j in 0 to 39 {
        object "dragon_{i}_{j}": mesh {
            file: "dragon.obj"
            unit: m
            material: white
            place: [scale(4), rotate(y, (i * 7 + j * 3) * 1 deg), move(i - 12, -0.21, j)]
        }
    }
}
render dragons { caption: "A thousand dragons." }
"""


def waves(folder, cells):
    """A sheet of waves with ripples on them."""
    (folder / "waves.scn").write_text(SHEET)
    with open(folder / "waves.obj", "w") as out:
        for j in range(cells + 1):
            y = j / cells
            for i in range(cells + 1):
                x = i / cells
                height = 0.05 * math.sin(40 * x) * math.cos(31 * y)
                height += 0.0004 * math.sin(900 * x + 700 * y)
                out.write(f"v {x:.6f} {height:.6f} {y:.6f}\n")
        for j in range(cells):
            for i in range(cells):
                a = j * (cells + 1) + i + 1
                b = a + cells + 1
                out.write(f"f {a} {b} {a + 1}\nf {a + 1} {b} {b + 1}\n")


def dragons(folder, _):
    """Dragons in rows; each file of one is read once."""
    (folder / "dragons.scn").write_text(ROWS)
    points, faces = rays.fetched_dragon()
    with open(folder / "dragon.obj", "w") as out:
        out.writelines(f"v {x} {y} {z}\n" for x, y, z in points)
        out.writelines(f"f {a} {b} {c}\n" for a, b, c in faces + 1)


# What is made, and how it is called.
SCENES = {"waves": (waves, "a sheet of waves"), "dragons": (dragons, "1,000 dragons, instances")}


def measure(bench, work, tiny, kept, progress, save):
    """Plans each scene, and then renders it: bytes as stated and as taken, seconds."""
    for name, (make, title) in SCENES.items():
        if name in kept:
            progress.skip(SECONDS)
            continue
        progress.step(SECONDS, f"large: {title}")
        with tempfile.TemporaryDirectory(dir=work) as folder:
            folder = Path(folder)
            try:
                make(folder, 40 if tiny else CELLS)
            except (OSError, subprocess.CalledProcessError) as error:
                print(f"large: without {title}: {error}", flush=True)
                continue
            scene = folder / f"{name}.scn"
            out, *_ = run([bench.scn.binary, "plan", scene, "--format", "json"])
            [planned] = json.loads(out)["renders"]
            out, wall, cpu, peak = run(
                [bench.scn.binary, "render", scene, "-o", folder, "--log", "json"])
        events = {event["event"]: event for event in map(json.loads, out.splitlines())}
        [file] = events["loaded"]["files"]
        kept[name] = {
            "triangles": file["triangles"], "shown": events["built"]["triangles"],
            "stated": planned["memory"]["peak"], "geometry": events["built"]["bytes"],
            "peak": events["rendered"]["peak_memory"] or peak, "wall": wall, "cpu": cpu,
        }
        save()


def table(found):
    yield ("| scene | triangles of the file | in the picture | geometry | a triangle of the file "
           "| peak, as `scn plan` said | peak | a triangle of the file | seconds | CPU seconds |")
    yield "|" + " --- |" * 10
    for name, one in found.items():
        of = one["triangles"]
        yield (f"| {SCENES[name][1]} | {of:,} | {one['shown']:,} | {one['geometry'] / 1e6:.0f} MB "
               f"| {one['geometry'] / of:.0f} B | {one['stated'] / 1e6:.0f} MB "
               f"| {one['peak'] / 1e6:.0f} MB | {one['peak'] / of:.0f} B "
               f"| {one['wall']:.1f} | {one['cpu']:.1f} |")
