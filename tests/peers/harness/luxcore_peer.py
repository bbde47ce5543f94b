"""LuxCore, by pyluxcore, on scenes of diffuse triangles and lamps."""

import time

import numpy as np
import pyluxcore

from . import scenes

# Scn's paths have no end but roulette.
DEPTH = 1024
# How often it is asked how far it is, in seconds.
WAIT = 0.005


class Peer:
    def __init__(self, scene, size):
        pyluxcore.Init()
        self.version = f"LuxCore {pyluxcore.Version()}"
        self.size = size
        shown = scenes.scene(scene)
        if shown.spheres or shown.ground or shown.sky or shown.constant or shown.sun:
            raise ValueError(f"{scene} has more than triangles")
        self.scene = pyluxcore.Scene()
        said = pyluxcore.Properties()
        self.camera(said, shown)
        for mesh in shown.meshes:
            put(self.scene, said, mesh)
        self.scene.Parse(said)
        self.render(1, 0)

    def camera(self, said, shown):
        eye, target, fov = shown.camera
        # Its picture is a pixel lower than its frame.
        pixel = 2 / self.size
        said.SetFromString(f"""
            scene.camera.type = perspective
            scene.camera.lookat.orig = {numbers(eye)}
            scene.camera.lookat.target = {numbers(target)}
            scene.camera.up = 0 1 0
            scene.camera.fieldofview = {fov}
            scene.camera.autofocus.enable = 0
            scene.camera.cliphither = 1
            scene.camera.clipyon = 100000
            scene.camera.screenwindow = -1 1 {-1 - pixel} {1 - pixel}
        """)

    def render(self, samples, seed):
        said = pyluxcore.Properties()
        said.SetFromString(f"""
            renderengine.type = PATHCPU
            renderengine.seed = {seed + 1}
            sampler.type = SOBOL
            sampler.sobol.adaptive.strength = 0
            path.pathdepth.total = {DEPTH}
            path.pathdepth.diffuse = {DEPTH}
            path.russianroulette.depth = 5
            path.clamping.variance.maxvalue = 0
            film.width = {self.size}
            film.height = {self.size}
            film.filter.type = NONE
            film.outputs.0.type = RGB
            film.outputs.0.filename = unused.exr
            batch.haltspp = {samples}
        """)
        session = pyluxcore.RenderSession(pyluxcore.RenderConfig(said, self.scene))
        # It stops when it sees that all samples are taken: a small picture may have some more.
        session.Start()
        while not session.HasDone():
            time.sleep(WAIT)
            session.UpdateStats()
        taken = session.GetStats().Get("stats.renderengine.pass").GetInt()
        session.Stop()
        values = np.empty(self.size * self.size * 3, dtype=np.float32)
        session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, values, 0)
        # Its rows begin at the bottom.
        return values.reshape(self.size, self.size, 3)[::-1], taken


def numbers(values):
    return " ".join(repr(float(value)) for value in values)


def put(scene, said, mesh):
    kind, albedo = mesh.material
    if kind != "diffuse":
        raise ValueError(kind)
    points, faces = (list(map(tuple, some.tolist())) for some in (mesh.points, mesh.faces))
    scene.DefineMesh(mesh.name, points, faces, None, None, None, None)
    said.SetFromString(f"""
        scene.materials.{mesh.name}.type = matte
        scene.materials.{mesh.name}.kd = {numbers(albedo)}
        scene.objects.{mesh.name}.shape = {mesh.name}
        scene.objects.{mesh.name}.material = {mesh.name}
    """)
    if mesh.radiance is not None:
        said.SetFromString(f"""
            scene.materials.{mesh.name}.emission = {numbers(mesh.radiance)}
        """)
