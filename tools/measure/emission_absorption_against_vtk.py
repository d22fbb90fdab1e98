#!/usr/bin/env python3
"""Emission and absorption beside VTK's ray caster: time per frame, and distance from the converged picture.

    xvfb-run -a python3 tools/measure/emission_absorption_against_vtk.py [--threads 2] [--frames 9] [--rounds 3] [--size 512]

Needs ./bootstrap build, build/example/matrix.dat (./bootstrap test unpacks it) and python3-vtk9, which nothing else does.
The same camera, the same curve: the opacity of VTK's curve is 1 - exp(-extinction * 1 mm), its colours are the albedos.
Distances are in levels: 255 times the linear radiance, which is what VTK's picture holds; mean and largest over pixels
and colours. Both renderers are held against their own finest setting along the same rays, so that neither the pixel
filter nor the volume's border (VTK's ends at the outermost voxel centres, ours half a voxel further out) counts:
  VTK   against VTK in steps of 0.02 mm, both of 8 bits
  ours  one sample a pixel against the same at a tolerance of 1e-3 levels: the same seed, hence the same rays
The last column is the distance from our picture at 1e-3 levels and 64 samples a pixel, filter and border included.
"""
import argparse
import array
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SIZE, SPACING = (256, 256, 108), (0.9570312, 0.9570312, 1.5)
CAMERA = {"type": "perspective", "eyeMm": [122.4999936, -420, 121], "targetMm": [122.4999936, 122.4999936, 81],
          "up": [0, 0, 1], "fovDegrees": 35}


def scene(function, film, tolerance):
    return {"format": "pdrender-scene", "version": 1,
            "volume": {"raw": os.path.join(ROOT, "build/example/matrix.dat"), "size": SIZE, "spacingMm": SPACING},
            "transferFunction": function, "model": "emissionAbsorption", "toleranceLevels": tolerance,
            "camera": CAMERA, "film": {"width": film, "height": film}}


class Ours:
    def __init__(self, bench, function, film, threads, folder):
        self.bench, self.function, self.film, self.threads, self.folder = bench, function, film, threads, folder

    def frames(self, count, tolerance):
        """(ms per frame, ms on all cores per frame, picture of all frames)."""
        path, colours = os.path.join(self.folder, "scene.json"), os.path.join(self.folder, "ours.pfm")
        with open(path, "w") as file:
            json.dump(scene(self.function, self.film, tolerance), file)
        out = subprocess.run([self.bench, "frames", path, "--frames", str(count), "--threads", str(self.threads),
                              "--colours", colours], check=True, capture_output=True, text=True).stdout
        figures = json.loads(out)
        return figures["medianMs"], figures["medianCpuMs"], self.read(colours)

    def read(self, path):
        with open(path, "rb") as file:
            for _ in range(3):
                file.readline()
            values = array.array("f", file.read())
        return [255 * value for value in values]


class Vtk:
    """The same picture by vtkFixedPointVolumeRayCastMapper."""

    def __init__(self, function, film, threads):
        import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401: registers the window's back end
        from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
        from vtkmodules.vtkIOImage import vtkImageReader
        from vtkmodules.vtkRenderingCore import (vtkColorTransferFunction, vtkRenderWindow, vtkRenderer, vtkVolume,
                                                 vtkVolumeProperty)
        from vtkmodules.vtkRenderingVolume import vtkFixedPointVolumeRayCastMapper
        reader = vtkImageReader()
        reader.SetFileName(os.path.join(ROOT, "build/example/matrix.dat"))
        reader.SetDataScalarTypeToShort()
        reader.SetDataByteOrderToLittleEndian()
        reader.SetFileDimensionality(3)
        reader.SetDataExtent(0, SIZE[0] - 1, 0, SIZE[1] - 1, 0, SIZE[2] - 1)
        reader.SetDataSpacing(*SPACING)
        reader.SetDataOrigin(*[step / 2 for step in SPACING])
        reader.FileLowerLeftOn()
        reader.Update()
        opacity, colour = vtkPiecewiseFunction(), vtkColorTransferFunction()
        nodes = function["nodes"]
        for node in nodes:
            colour.AddRGBPoint(node["hu"], *node["albedo"])
        for left, right in zip(nodes, nodes[1:]):
            parts = max(1, int(right["hu"] - left["hu"]))
            for part in range(parts + 1):
                share = part / parts
                extinction = function["extinctionPerMm"] * (left["opacity"] + share * (right["opacity"] - left["opacity"]))
                opacity.AddPoint(left["hu"] + share * (right["hu"] - left["hu"]), 1 - math.exp(-extinction))
        properties = vtkVolumeProperty()
        properties.SetColor(colour)
        properties.SetScalarOpacity(opacity)
        properties.SetScalarOpacityUnitDistance(1)
        properties.SetInterpolationTypeToLinear()
        properties.ShadeOff()
        self.mapper = vtkFixedPointVolumeRayCastMapper()
        self.mapper.SetInputConnection(reader.GetOutputPort())
        self.mapper.SetNumberOfThreads(threads)
        self.mapper.AutoAdjustSampleDistancesOff()
        self.mapper.InteractiveAdjustSampleDistances = 0
        self.mapper.SetImageSampleDistance(1)
        volume = vtkVolume()
        volume.SetMapper(self.mapper)
        volume.SetProperty(properties)
        renderer = vtkRenderer()
        renderer.SetBackground(0, 0, 0)
        renderer.AddVolume(volume)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(*CAMERA["eyeMm"])
        camera.SetFocalPoint(*CAMERA["targetMm"])
        camera.SetViewUp(*CAMERA["up"])
        camera.SetViewAngle(CAMERA["fovDegrees"])
        renderer.ResetCameraClippingRange()
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(film, film)
        self.window.AddRenderer(renderer)
        self.window.Render()

    def frames(self, count, step):
        from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
        self.mapper.SetSampleDistance(step)
        self.window.Render()  # tables that are made once per setting
        wall, cpu = [], []
        for _ in range(count):
            self.mapper.Modified()
            start, cores = time.perf_counter(), time.process_time()
            self.window.Render()
            wall.append(1e3 * (time.perf_counter() - start))
            cpu.append(1e3 * (time.process_time() - cores))
        pixels = vtkUnsignedCharArray()
        width, height = self.window.GetSize()
        self.window.GetPixelData(0, 0, width - 1, height - 1, 0, pixels, 0)
        return statistics.median(wall), statistics.median(cpu), list(bytes(memoryview(pixels)))


def distance(a, b):
    """(mean, largest) over all values."""
    off = [abs(x - y) for x, y in zip(a, b)]
    return sum(off) / len(off), max(off)


def cpu_model():
    with open("/proc/cpuinfo") as file:
        return next(line.split(":")[1].strip() for line in file if line.startswith("model name"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--bench", default=os.path.join(ROOT, "build/release/bin/pdrender-bench"))
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--frames", type=int, default=9)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--size", type=int, default=512)
    options = parser.parse_args()
    with open(os.path.join(ROOT, "app/bench/paper/bone_look.json")) as file:
        function = json.load(file)["transferFunction"]
    try:
        from vtkmodules.vtkCommonCore import vtkVersion
        vtk = Vtk(function, options.size, options.threads)
    except ImportError as missing:
        sys.exit(f"VTK is not installed ({missing}); on Debian: apt install python3-vtk9. Nothing was measured.")
    with tempfile.TemporaryDirectory() as folder:
        ours = Ours(options.bench, function, options.size, options.threads, folder)
        settings = [("ours, 0.25 levels", ours, 0.25), ("ours, 1 level", ours, 1), ("VTK, 0.25 mm", vtk, 0.25),
                    ("VTK, 0.5 mm", vtk, 0.5), ("VTK, 1 mm", vtk, 1)]
        wall, cpu, pictures = {}, {}, {}
        for _ in range(options.rounds):  # in turn, so that neighbours on the machine disturb all alike
            for name, renderer, setting in settings:
                milliseconds, cores, pictures[name] = renderer.frames(options.frames, setting)
                wall.setdefault(name, []).append(milliseconds)
                cpu.setdefault(name, []).append(cores)
        first = {setting: ours.frames(1, setting)[2] for setting in (0.25, 1, 1e-3)}
        finest_vtk = vtk.frames(1, 0.02)[2]
        converged = ours.frames(64, 1e-3)[2]
    print(f"{cpu_model()}, {options.threads} threads, VTK {vtkVersion.GetVTKVersion()}, cranium 256 x 256 x 108, "
          f"{options.size} x {options.size} pixels, curve CT bone, {options.rounds} rounds of {options.frames} frames")
    print(f"{'':20} {'ms':>8} {'ms on':>9}  {'off its own finest':>21}  {'off ours':>8}")
    print(f"{'':20} {'':>8} {'all cores':>9}  {'mean levels':>11} {'largest':>9}  {'mean':>8}")
    for name, renderer, setting in settings:
        own = distance(first[setting], first[1e-3]) if renderer is ours else distance(pictures[name], finest_vtk)
        print(f"{name:20} {statistics.median(wall[name]):8.1f} {statistics.median(cpu[name]):9.1f}  "
              f"{own[0]:11.4f} {own[1]:9.2f}  {distance(pictures[name], converged)[0]:8.3f}")
    print(f"{'VTK, 0.02 mm':20} {'':8} {'':9}  {'':11} {'':9}  {distance(finest_vtk, converged)[0]:8.3f}")


if __name__ == "__main__":
    main()
