"""Scenes written for Mitsuba: scene.xml, meshes as .ply, the sky as an .exr."""

import xml.etree.ElementTree as xml

import numpy as np

# Half the side of the square that stands for a plane without end, in mm. From the height of the
# eye it ends a fiftieth of a pixel before the horizon.
FAR = 5e6


def numbers(values):
    return ", ".join(repr(float(value)) for value in values)


def put(parent, kind, name=None, **attributes):
    if name is not None:
        attributes["name"] = name
    text = {key: value if isinstance(value, str) else repr(value)
            for key, value in attributes.items()}
    return xml.SubElement(parent, kind, text)


def rgb(parent, name, values):
    put(parent, "rgb", name, value=numbers(values))


def material(parent, said):
    kind, *rest = said
    if kind == "diffuse":
        # Scn's surfaces have the same colour on both sides.
        both = put(parent, "bsdf", type="twosided")
        rgb(put(both, "bsdf", type="diffuse"), "reflectance", rest[0])
    elif kind == "mirror":
        both = put(parent, "bsdf", type="twosided")
        put(put(both, "bsdf", type="conductor"), "string", "material", value="none")
    elif kind == "conductor":
        both = put(parent, "bsdf", type="twosided")
        metal = put(both, "bsdf", type="conductor")
        rgb(metal, "eta", rest[0])
        rgb(metal, "k", rest[1])
    elif kind == "dielectric":
        glass = put(parent, "bsdf", type="dielectric")
        put(glass, "float", "int_ior", value=rest[0])
        put(glass, "float", "ext_ior", value=1.0)
    else:
        raise ValueError(kind)


def write_ply(path, mesh):
    used, faces = np.unique(mesh.faces, return_inverse=True)
    columns = [mesh.points[used]]
    fields = ["x", "y", "z"]
    if mesh.normals is not None:
        columns.append(mesh.normals[used])
        fields += ["nx", "ny", "nz"]
    corners = np.concatenate(columns, axis=1).astype("<f4")
    faces = faces.reshape(-1, 3)
    packed = np.empty(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    packed["count"], packed["corners"] = 3, faces
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(corners)}"]
    head += [f"property float {name}" for name in fields]
    head += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    with open(path, "wb") as file:
        file.write(("\n".join(head) + "\n").encode())
        file.write(corners.tobytes())
        file.write(packed.tobytes())


def mitsuba(scene, folder, sky):
    """Writes a scene into a folder; `sky` is the file of its sky's image."""
    folder.mkdir(parents=True, exist_ok=True)
    root = xml.Element("scene", version="3.0.0")
    for name, value in [("size", "512"), ("spp", "1")]:
        put(root, "default", name, value=value)
    integrator = put(root, "integrator", type="path")
    # Mitsuba counts the segments of a path, scn its scatterings.
    depth = -1 if scene.depth is None else scene.depth + 1
    put(integrator, "integer", "max_depth", value=str(depth))
    put(integrator, "integer", "rr_depth", value="5")
    camera(root, scene)
    for mesh in scene.meshes:
        write_ply(folder / f"{mesh.name}.ply", mesh)
        shape = put(root, "shape", type="ply")
        put(shape, "string", "filename", value=f"{mesh.name}.ply")
        # Without it Mitsuba makes normals up where a file has none.
        put(shape, "boolean", "face_normals", value=str(mesh.normals is None).lower())
        material(shape, mesh.material)
        if mesh.radiance is not None:
            rgb(put(shape, "emitter", type="area"), "radiance", mesh.radiance)
    for ball in scene.spheres:
        shape = put(root, "shape", type="sphere")
        put(shape, "point", "center", value=numbers(ball.centre))
        put(shape, "float", "radius", value=ball.radius)
        material(shape, ball.material)
    if scene.ground is not None:
        height, said = scene.ground
        shape = put(root, "shape", type="rectangle")
        to_world = put(shape, "transform", "to_world")
        put(to_world, "scale", value=FAR)
        put(to_world, "rotate", x="1", angle="-90")
        put(to_world, "translate", y=height)
        material(shape, said)
    lights(root, scene, sky)
    xml.indent(root)
    path = folder / "scene.xml"
    xml.ElementTree(root).write(path)
    return path


def camera(root, scene):
    eye, target, fov = scene.camera
    sensor = put(root, "sensor", type="perspective")
    put(sensor, "float", "fov", value=fov)
    put(sensor, "string", "fov_axis", value="y")
    put(sensor, "float", "near_clip", value=1.0)
    put(sensor, "float", "far_clip", value=1e8)
    to_world = put(sensor, "transform", "to_world")
    put(to_world, "lookat", origin=numbers(eye), target=numbers(target), up="0, 1, 0")
    film = put(sensor, "film", type="hdrfilm")
    for side in ("width", "height"):
        put(film, "integer", side, value="$size")
    put(film, "rfilter", type="box")
    put(film, "string", "pixel_format", value="rgb")
    put(film, "string", "component_format", value="float32")
    put(put(sensor, "sampler", type="independent"), "integer", "sample_count", value="$spp")


def lights(root, scene, sky):
    if scene.constant is not None:
        rgb(put(root, "emitter", type="constant"), "radiance", scene.constant)
    if scene.sky:
        put(put(root, "emitter", type="envmap"), "string", "filename", value=str(sky))
    if scene.sun is not None:
        direction, irradiance = scene.sun
        sun = put(root, "emitter", type="directional")
        put(sun, "vector", "direction", value=numbers(direction))
        rgb(sun, "irradiance", irradiance)
