#!/usr/bin/env python3
"""Renders a scene file with Cycles, with the options of `pdrender-bench picture`, so that equal_error.py compares the two.

    tools/measure/equal_error.py build/release/bin/pdrender-bench tools/measure/cycles_picture.py SCENE.json

Takes raw volumes with a curve of two nodes and one albedo, one distant light or an environment of one radiance, and a
perspective camera: tests/scenes/yardstick.json and cranium_in_environment.json. Needs a Python that has bpy (PyPI, 4.2) as
python3, and Debian's python3-openvdb for /usr/bin/python3, which writes the volume: the two bring different OpenVDB, so that
they cannot share a process. Cycles marches: its mean differs from ours by the bias of its steps.
"""

import argparse
import array
import json
import pathlib
import subprocess
import sys
import tempfile

WRITE_GRID = """
import json, sys
import numpy, pyopenvdb
volume = json.loads(sys.argv[1])
values = numpy.fromfile(volume["raw"], "<i2").reshape(volume["size"][::-1]).transpose().astype("f4")
low, high = volume["clampHu"]
grid = pyopenvdb.FloatGrid()
grid.copyFromArray(numpy.ascontiguousarray((values.clip(low, high) - low) / (high - low)))
x, y, z = volume["spacingMm"]
grid.transform = pyopenvdb.createLinearTransform([[x, 0, 0, 0], [0, y, 0, 0], [0, 0, z, 0], [x / 2, y / 2, z / 2, 1]])
grid.name = "density"
pyopenvdb.write(sys.argv[2], grid)
"""


def add_volume(scene: dict, vdb: pathlib.Path) -> None:
    first, last = scene["transferFunction"]["nodes"]
    assert [first["hu"], last["hu"]] == scene["volume"]["clampHu"] and first["albedo"] == last["albedo"]
    data = bpy.data.volumes.new("volume")
    data.filepath = str(vdb)
    shown = bpy.data.objects.new("volume", data)
    bpy.context.collection.objects.link(shown)
    material = bpy.data.materials.new("medium")
    material.use_nodes = True
    material.cycles.volume_interpolation = "LINEAR"
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    density = nodes.new("ShaderNodeAttribute")
    density.attribute_name = "density"
    scaled = nodes.new("ShaderNodeMath")
    scaled.operation = "MULTIPLY"
    scaled.inputs[1].default_value = scene["transferFunction"]["extinctionPerMm"] * last["opacity"]
    links.new(density.outputs["Fac"], scaled.inputs[0])
    both = nodes.new("ShaderNodeAddShader")
    for socket, kind in enumerate(("ShaderNodeVolumeScatter", "ShaderNodeVolumeAbsorption")):
        shader = nodes.new(kind)
        shader.inputs["Color"].default_value = (last["albedo"],) * 3 + (1,)
        links.new(scaled.outputs[0], shader.inputs["Density"])
        links.new(shader.outputs[0], both.inputs[socket])
    output = nodes.new("ShaderNodeOutputMaterial")
    links.new(both.outputs[0], output.inputs["Volume"])
    data.materials.append(material)


def add_light(light: dict) -> None:
    world = bpy.data.worlds.new("world")
    world.use_nodes = True
    bpy.context.scene.world = world
    background = world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = light.get("radiance", 0)
    world.cycles_visibility.camera = False
    if light["type"] == "environment":
        return
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy, sun.angle = light["irradiance"], 0
    shown = bpy.data.objects.new("sun", sun)
    shown.rotation_mode = "QUATERNION"
    shown.rotation_quaternion = mathutils.Vector(light["direction"]).to_track_quat("-Z", "Y")
    bpy.context.collection.objects.link(shown)


def add_camera(camera: dict) -> None:
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle_y = camera["fovDegrees"] * 3.141592653589793 / 180
    data.clip_end = 10000
    shown = bpy.data.objects.new("camera", data)
    eye, target = mathutils.Vector(camera["eyeMm"]), mathutils.Vector(camera["targetMm"])
    shown.location = eye
    shown.rotation_mode = "QUATERNION"
    shown.rotation_quaternion = (target - eye).to_track_quat("-Z", "Y")
    bpy.context.collection.objects.link(shown)
    bpy.context.scene.camera = shown


def render(scene: dict, samples: int, threads: int, exr: pathlib.Path) -> None:
    target = bpy.context.scene
    target.render.engine = "CYCLES"
    target.render.resolution_x, target.render.resolution_y = scene["film"]["width"], scene["film"]["height"]
    target.render.resolution_percentage = 100
    target.render.film_transparent = False
    target.render.threads_mode, target.render.threads = "FIXED", threads
    target.render.image_settings.file_format = "OPEN_EXR"
    target.render.image_settings.color_depth = "32"
    target.render.filepath = str(exr)
    cycles = target.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", samples, scene["seed"]
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.max_bounces = cycles.volume_bounces = min(scene["maxBounces"] - 1, 1024)
    cycles.sample_clamp_indirect = 0
    cycles.volume_max_steps = 65536
    bpy.ops.render.render(write_still=True)


def write_pfm(exr: pathlib.Path, pfm: pathlib.Path) -> None:
    image = bpy.data.images.load(str(exr))
    width, height = image.size
    rgba = array.array("f", image.pixels[:])
    pfm.write_bytes(b"Pf\n%d %d\n-1\n" % (width, height) + rgba[0::4].tobytes())


parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("command", choices=["picture"])
parser.add_argument("scene", type=pathlib.Path)
parser.add_argument("--samples", type=int, default=64)
parser.add_argument("--threads", type=int, default=1)
parser.add_argument("--device", choices=["cpu"], default="cpu")
parser.add_argument("--pfm", type=pathlib.Path, required=True)
options = parser.parse_args()

try:
    import bpy
    import mathutils
except ImportError:
    sys.exit("cycles_picture.py: this Python has no bpy. Make an environment with `pip install bpy==4.2.0` and activate it.")

described = json.loads(options.scene.read_text())
described["volume"]["raw"] = str((options.scene.parent / described["volume"]["raw"]).resolve())
with tempfile.TemporaryDirectory() as folder:
    grid, exr = pathlib.Path(folder) / "density.vdb", pathlib.Path(folder) / "image.exr"
    subprocess.run(["/usr/bin/python3", "-c", WRITE_GRID, json.dumps(described["volume"]), str(grid)], check=True)
    bpy.ops.wm.read_factory_settings(use_empty=True)
    add_volume(described, grid)
    add_light(described["lights"][0])
    add_camera(described["camera"])
    render(described, options.samples, options.threads, exr)
    write_pfm(exr, options.pfm)
