"""Cycles, by Blender's Python module, on scenes of diffuse triangles and lamps."""

import math
import tempfile
from pathlib import Path

import bpy
import numpy as np

from . import pictures, scenes

# Scn's paths have no end but roulette.
DEPTH = 1024
# Blender's cameras are clumsy beyond some kilometres, and its rays leave surfaces by a fixed step.
METRES = 1e-3


class Peer:
    def __init__(self, scene, size):
        self.version = f"Cycles {bpy.app.version_string}"
        bpy.ops.wm.read_factory_settings(use_empty=True)
        shown = scenes.scene(scene)
        if shown.spheres or shown.ground or shown.sky or shown.constant or shown.sun:
            raise ValueError(f"{scene} has more than triangles")
        for mesh in shown.meshes:
            put(mesh)
        camera(shown, size)
        self.settings()
        self.size = size
        # Kernels are loaded when they are first needed.
        self.render(1, 0)

    def settings(self):
        """Nothing that would change the mean; unlimited depth; a sample is a sample."""
        scene = bpy.context.scene
        scene.render.engine = "CYCLES"
        cycles = scene.cycles
        cycles.device = "CPU"
        cycles.use_adaptive_sampling = False
        cycles.use_denoising = False
        cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
        cycles.light_sampling_threshold = 0
        cycles.blur_glossy = 0
        cycles.pixel_filter_type = "BOX"
        cycles.filter_width = 1
        cycles.max_bounces = cycles.diffuse_bounces = DEPTH
        cycles.min_light_bounces = 0
        scene.render.use_persistent_data = True
        scene.render.image_settings.file_format = "OPEN_EXR"
        scene.render.image_settings.color_depth = "32"
        scene.world = bpy.data.worlds.new("black")
        scene.world.use_nodes = True
        for node in scene.world.node_tree.nodes:
            if node.type == "BACKGROUND":
                node.inputs["Strength"].default_value = 0

    def render(self, samples, seed):
        scene = bpy.context.scene
        scene.cycles.samples, scene.cycles.seed = samples, seed
        with tempfile.TemporaryDirectory() as folder:
            scene.render.filepath = str(Path(folder) / "a.exr")
            bpy.ops.render.render(write_still=True)
            return pictures.read(scene.render.filepath), samples


def put(mesh):
    """A mesh with its material; z is up in Blender, and nothing hangs on that."""
    of = bpy.data.meshes.new(mesh.name)
    of.from_pydata((METRES * mesh.points).tolist(), [], mesh.faces.tolist())
    material = bpy.data.materials.new(mesh.name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    end = nodes.new("ShaderNodeOutputMaterial")
    kind, albedo = mesh.material
    if kind != "diffuse":
        raise ValueError(kind)
    if mesh.radiance is None:
        surface = nodes.new("ShaderNodeBsdfDiffuse")
        surface.inputs["Color"].default_value = (*albedo, 1)
        surface.inputs["Roughness"].default_value = 0
        links.new(surface.outputs[0], end.inputs["Surface"])
    else:
        # From its front alone.
        shines = nodes.new("ShaderNodeEmission")
        strength = max(mesh.radiance)
        shines.inputs["Color"].default_value = (*(c / strength for c in mesh.radiance), 1)
        shines.inputs["Strength"].default_value = strength
        side, dark = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeBsdfDiffuse")
        dark.inputs["Color"].default_value = (0, 0, 0, 1)
        mix = nodes.new("ShaderNodeMixShader")
        links.new(side.outputs["Backfacing"], mix.inputs["Fac"])
        links.new(shines.outputs[0], mix.inputs[1])
        links.new(dark.outputs[0], mix.inputs[2])
        links.new(mix.outputs[0], end.inputs["Surface"])
        material.cycles.emission_sampling = "FRONT"
    of.materials.append(material)
    bpy.context.scene.collection.objects.link(bpy.data.objects.new(mesh.name, of))


def camera(shown, size):
    eye, target, fov = shown.camera
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, [0, 1, 0])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    of = bpy.data.cameras.new("camera")
    of.sensor_fit, of.angle = "VERTICAL", math.radians(fov)
    of.clip_start, of.clip_end = 1e-3, 1e5
    placed = bpy.data.objects.new("camera", of)
    # Its camera looks along its -z.
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2] = right, up, -forward
    matrix[:3, 3] = METRES * np.array(eye)
    placed.matrix_world = matrix.T.tolist()
    scene = bpy.context.scene
    scene.collection.objects.link(placed)
    scene.camera = placed
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100
