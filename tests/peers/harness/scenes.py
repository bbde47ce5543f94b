"""What scenes.scn shows, as plain data for programs that do not read .scn.

Points are in millimetres, radiance in W/m^2/sr. `run.py agree` holds this file to scenes.scn: the
pictures of both have the same means.
"""

import math
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[3]

WHITE = ("diffuse", (0.9, 0.9, 0.9))
GRASS = ("diffuse", (0.1, 0.7, 0.1))
GLASS = ("dielectric", 1.5)
MIRROR = ("mirror",)
GOLD = ("conductor", (0.143, 0.375, 1.442), (3.983, 2.386, 1.603))

# The camera before the box: 2 atan 1/2.
FOV = math.degrees(2 * math.atan(0.5))


@dataclass
class Mesh:
    """Triangles of one material. A lamp has a radiance, and shines from its front."""
    name: str
    points: np.ndarray
    faces: np.ndarray
    normals: np.ndarray | None
    material: tuple
    radiance: tuple | None = None


@dataclass
class Sphere:
    name: str
    centre: tuple
    radius: float
    material: tuple


@dataclass
class Scene:
    """One render of scenes.scn."""
    name: str
    title: str
    meshes: list
    spheres: list = field(default_factory=list)
    ground: tuple | None = None  # height and material of a level plane
    camera: tuple = ()  # eye, target, vertical field of view in degrees
    constant: tuple | None = None  # radiance of a sky that is the same everywhere
    sky: bool = False  # whether the sky of `cube` shines
    sun: tuple | None = None  # direction of its light, irradiance
    depth: int | None = None  # scatterings; None: without end

    def bounds(self):
        """Lowest and highest corner of all that is bounded."""
        low = [mesh.points.min(axis=0) for mesh in self.meshes]
        high = [mesh.points.max(axis=0) for mesh in self.meshes]
        low += [np.array(ball.centre) - ball.radius for ball in self.spheres]
        high += [np.array(ball.centre) + ball.radius for ball in self.spheres]
        return np.min(low, axis=0), np.max(high, axis=0)


def read_mtl(path):
    """Kd and Ka of a file's materials."""
    found, of = {}, None
    for words in map(str.split, path.read_text().splitlines()):
        if words and words[0] == "newmtl":
            of = found.setdefault(words[1], {})
        elif words and words[0] in ("Kd", "Ka"):
            of[words[0]] = tuple(map(float, words[1:4]))
    return found


def read_obj(path):
    """Points, normals of the same numbers or None, and triangles by the name of their material."""
    points, normals, faces, material = [], [], {}, None
    for words in map(str.split, path.read_text().splitlines()):
        if not words:
            continue
        if words[0] == "v":
            points.append([float(word) for word in words[1:4]])
        elif words[0] == "vn":
            normals.append([float(word) for word in words[1:4]])
        elif words[0] == "usemtl":
            material = words[1]
        elif words[0] == "f":
            corners = [word.split("/") for word in words[1:]]
            if any(len(corner) == 3 and corner[0] != corner[2] for corner in corners):
                raise ValueError(f"{path}: a corner's normal has another number than its point")
            corners = [int(corner[0]) - 1 for corner in corners]
            for i in range(1, len(corners) - 1):
                faces.setdefault(material, []).append([corners[0], corners[i], corners[i + 1]])
    points = np.array(points)
    if normals and len(normals) != len(points):
        raise ValueError(f"{path}: {len(normals)} normals for {len(points)} points")
    faces = {name: np.array(some) for name, some in faces.items()}
    return points, np.array(normals) if normals else None, faces


def model(name, unit=1.0, turn=0.0, move=(0, 0, 0), material=None):
    """The meshes of a file of models/: scaled, turned about y by degrees, and moved."""
    points, normals, faces = read_obj(ROOT / "models" / f"{name}.obj")
    said = read_mtl(ROOT / "models" / f"{name}.mtl")
    cos, sin = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    rotate = np.array([[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]])
    points = unit * points @ rotate.T + np.array(move)
    if normals is not None:
        normals = normals @ rotate.T
    meshes = []
    for of, some in faces.items():
        radiance = said[of].get("Ka", (0, 0, 0))
        meshes.append(Mesh(
            name=f"{name}_{of}", points=points, faces=some, normals=normals,
            material=material or ("diffuse", said[of]["Kd"]),
            radiance=radiance if any(radiance) else None))
    return meshes


def in_box(name, title, meshes=(), **more):
    """The Cornell box with something in it, before the course's camera: 1.75 radii of the bounding
    sphere from the middle of the bounding box, along z."""
    scene = Scene(name, title, model("cornell_box") + list(meshes), **more)
    low, high = scene.bounds()
    middle, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    scene.camera = (middle - [0, 0, 1.75 * radius], middle, FOV)
    return scene


def balls():
    return [Sphere("left", (420.2, 91.6, 369.5), 90.0, MIRROR),
            Sphere("right", (130.9, 91.6, 249.6), 90.0, GLASS)]


def animals():
    return (model("bunny", 1400, 150, (150, -46, 170), GOLD)
            + model("elephant", 12.5, 155, (375, 0.5, 330), GLASS))


def lawn(name, title, **more):
    return Scene(name, title, model("bunny", 1000, material=WHITE), ground=(33.0, GRASS),
                 camera=(np.array([-20.0, 140, 700]), np.array([-20.0, 100, 0]), 25.0),
                 sky=True, **more)


SUN = ((0.7826, -0.6225, 0), (143.0, 117.0, 95.0))

# The timed ones first.
SCENES = {
    "cornell_blocks": lambda name: in_box(name, "Cornell's blocks", model("cornell_blocks")),
    "two_spheres": lambda name: in_box(name, "mirror and glass ball", spheres=balls()),
    "gold_and_glass": lambda name: in_box(name, "gold bunny, glass elephant", animals()),
    "sun_and_sky": lambda name: lawn(name, "bunny under sun and sky", sun=SUN),
    "blocks_direct": lambda name: in_box(
        name, "blocks, scattered once", model("cornell_blocks"), depth=1),
    "spheres_sky": lambda name: in_box(
        name, "balls and a constant sky", spheres=balls(), constant=(0.8, 0.9, 1)),
    "sky_alone": lambda name: lawn(name, "bunny under the sky"),
}
TIMED = list(SCENES)[:4]


def scene(name):
    return SCENES[name](name)
