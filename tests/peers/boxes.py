"""The same boxes by scn and by Mitsuba 3: do their pictures agree?

    pip install mitsuba==3.9.1 numpy
    cargo build --release
    python tests/peers/boxes.py [--seeds 16] [--samples 64] [--block 8] [RENDER ...]

Both render each scene of boxes.scn with several seeds, in turn. The means of square blocks of
pixels are compared by Welch's t, channel by channel; with so many comparisons one is expected to
be far off by chance, so the bound is Sidak's: 1 - (1 - 0.01)^(1/N). Exit status 1: they differ.

Not needed to build or to test. A scene for other programs is a function in SCENES below.
"""

import argparse
import math
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

import mitsuba as mi

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
SCN = os.environ.get("SCN", os.path.join(ROOT, "target", "release", "scn"))
SIZE = 128

mi.set_variant("llvm_ad_rgb" if os.environ.get("DRJIT_LIBLLVM_PATH") else "scalar_rgb")


def read_obj(name):
    """Triangles of a file of models/, by material."""
    points, faces, material = [], {}, None
    with open(os.path.join(ROOT, "models", name + ".obj")) as lines:
        for words in map(str.split, lines):
            if not words:
                continue
            if words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words[0] == "usemtl":
                material = words[1]
            elif words[0] == "f":
                corners = [int(word.split("/")[0]) - 1 for word in words[1:]]
                for i in range(1, len(corners) - 1):
                    faces.setdefault(material, []).append([corners[0], corners[i], corners[i + 1]])
    return np.array(points), faces


def read_mtl(name):
    """Kd and Ka of the materials of a file of models/."""
    found, of = {}, None
    with open(os.path.join(ROOT, "models", name + ".mtl")) as lines:
        for words in map(str.split, lines):
            if words and words[0] == "newmtl":
                of = found.setdefault(words[1], {})
            elif words and words[0] in ("Kd", "Ka"):
                of[words[0]] = [float(word) for word in words[1:4]]
    return found


def mesh(points, faces, bsdf, radiance):
    properties = mi.Properties()
    properties["bsdf"] = mi.load_dict(bsdf)
    if any(radiance):
        properties["emitter"] = mi.load_dict(
            {"type": "area", "radiance": {"type": "rgb", "value": radiance}})
    shape = mi.Mesh("mesh", len(points), len(faces), props=properties)
    parameters = mi.traverse(shape)
    parameters["vertex_positions"] = np.ravel(points).astype(np.float32)
    parameters["faces"] = np.ravel(faces).astype(np.uint32)
    parameters.update()
    return shape


def meshes(name):
    points, by_material = read_obj(name)
    materials = read_mtl(name)
    for number, (material, faces) in enumerate(by_material.items()):
        said = materials[material]
        # Scn's surfaces have the same colour on both sides.
        diffuse = {"type": "diffuse", "reflectance": {"type": "rgb", "value": said["Kd"]}}
        bsdf = {"type": "twosided", "bsdf": diffuse}
        yield f"{name}{number}", mesh(points, faces, bsdf, said.get("Ka", [0, 0, 0]))


def camera(*names):
    """The course's: 1.75 radii of the bounding sphere before the middle of the box, along z."""
    points = np.concatenate([read_obj(name)[0] for name in names])
    low, high = points.min(axis=0), points.max(axis=0)
    middle, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    eye = middle - [0, 0, 1.75 * radius]
    return {
        "type": "perspective",
        "fov": math.degrees(2 * math.atan(0.5)),
        "fov_axis": "y",
        "near_clip": 1.0,
        "far_clip": 1e5,
        "to_world": mi.ScalarTransform4f().look_at(
            origin=list(eye), target=list(middle), up=[0, 1, 0]),
        "film": {"type": "hdrfilm", "width": SIZE, "height": SIZE, "rfilter": {"type": "box"},
                 "pixel_format": "rgb", "component_format": "float32"},
        "sampler": {"type": "independent"},
    }


def blocks(depth):
    scene = {"type": "scene", "sensor": camera("cornell_box", "cornell_blocks")}
    scene["integrator"] = {"type": "path", "max_depth": depth, "rr_depth": 5}
    scene.update(meshes("cornell_box"))
    scene.update(meshes("cornell_blocks"))
    return scene


def balls(sky):
    scene = {"type": "scene", "sensor": camera("cornell_box")}
    scene["integrator"] = {"type": "path", "max_depth": -1, "rr_depth": 5}
    scene.update(meshes("cornell_box"))
    rgb = lambda *value: {"type": "rgb", "value": list(value)}
    metal = {"type": "conductor", "eta": rgb(0.2, 0.5, 1.4), "k": rgb(3.2, 2.4, 1.9)}
    glass = {"type": "dielectric", "int_ior": 1.5, "ext_ior": 1.0}
    for name, centre, bsdf in [
            ("left", [420.2, 91.6, 369.5], metal), ("right", [130.9, 91.6, 249.6], glass)]:
        scene[name] = {"type": "sphere", "center": centre, "radius": 90.0, "bsdf": bsdf}
    if sky:
        scene["sky"] = {"type": "constant", "radiance": rgb(0.8, 0.9, 1)}
    return scene


SCENES = {
    "blocks_path": lambda: blocks(-1),
    # Mitsuba counts the segments of a path, scn its surfaces.
    "blocks_direct": lambda: blocks(2),
    "balls_path": lambda: balls(False),
    "balls_sky": lambda: balls(True),
}


def cpu(who):
    usage = resource.getrusage(who)
    return usage.ru_utime + usage.ru_stime


def ours(name, seed, samples):
    with tempfile.TemporaryDirectory() as folder:
        begun, before = time.time(), cpu(resource.RUSAGE_CHILDREN)
        subprocess.run(
            [SCN, "render", os.path.join(HERE, "boxes.scn"), "--only", name, "-o", folder, "-q",
             "--seed", str(seed), "--samples", str(samples)], check=True)
        took = time.time() - begun, cpu(resource.RUSAGE_CHILDREN) - before
        bitmap = mi.Bitmap(os.path.join(folder, name + ".exr"))
        values = np.array(dict(bitmap.split())["<root>"])
        return values[..., :3], took


def theirs(scene, seed, samples):
    begun, before = time.time(), cpu(resource.RUSAGE_SELF)
    values = np.array(mi.render(scene, spp=samples, seed=seed))
    return values[..., :3], (time.time() - begun, cpu(resource.RUSAGE_SELF) - before)


def means(values, block):
    side = SIZE // block
    return values.reshape(side, block, side, block, 3).mean(axis=(1, 3))


def normal_quantile(p):
    """Upper quantile of the normal distribution, by bisection."""
    low, high = 0.0, 40.0
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if math.erfc(middle / math.sqrt(2)) / 2 > p else (low, middle)
    return low


def compare(name, options):
    scene = mi.load_dict(SCENES[name]())
    mine, peers, took = [], [], [[0.0, 0.0], [0.0, 0.0]]
    for seed in range(options.seeds):
        for kept, (values, times), total in [
                (mine, ours(name, seed, options.samples), took[0]),
                (peers, theirs(scene, seed, options.samples), took[1])]:
            kept.append(means(values, options.block))
            total[0] += times[0]
            total[1] += times[1]
    mine, peers = np.array(mine, dtype=np.float64), np.array(peers, dtype=np.float64)
    error_2 = (mine.var(axis=0, ddof=1) + peers.var(axis=0, ddof=1)) / options.seeds
    apart = mine.mean(axis=0) - peers.mean(axis=0)
    scores = np.abs(apart) / np.sqrt(np.maximum(error_2, 1e-20))
    # Few seeds have tails beyond the normal's: Student's by its Cornish-Fisher expansion.
    bound = normal_quantile((1 - 0.99 ** (1 / scores.size)) / 2)
    freedom = 2 * (options.seeds - 1)
    bound += (bound ** 3 + bound) / (4 * freedom) + (
        5 * bound ** 5 + 16 * bound ** 3 + 3 * bound) / (96 * freedom ** 2)
    whole = mine.mean(axis=(1, 2, 3)), peers.mean(axis=(1, 2, 3))
    relative = whole[0].mean() / whole[1].mean() - 1
    error = math.sqrt(sum(w.var(ddof=1) / options.seeds for w in whole)) / whole[1].mean()
    agree = scores.max() <= bound and abs(relative) <= 4 * error
    print(f"| {name} | {100 * relative:+.3f} +- {100 * error:.3f} % | {scores.max():.2f} "
          f"| {bound:.2f} | {'yes' if agree else 'NO'} | {took[0][0]:.1f} ({took[0][1]:.1f}) "
          f"| {took[1][0]:.1f} ({took[1][1]:.1f}) |", flush=True)
    return agree


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("renders", nargs="*", default=list(SCENES))
    parser.add_argument("--seeds", type=int, default=16)
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--block", type=int, default=8)
    options = parser.parse_args()
    print(f"Mitsuba {mi.__version__} {mi.variant()}, {SIZE} x {SIZE} pixels, {options.seeds} seeds "
          f"of {options.samples} samples, blocks of {options.block} x {options.block}\n")
    print("| scene | mean, ours over theirs | worst score | bound | agree | ours, s (CPU) "
          "| theirs, s (CPU) |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    return 0 if all([compare(name, options) for name in options.renders]) else 1


sys.exit(main())
