#!/usr/bin/env python3
"""Counts what the kernels of the CUDA device cost on a GPU, without one.

    gpu_instructions.py BENCH [SCENE] [--arch sm_90] [--samples 1] [--processors 132] [--nvdisasm FILE]

BENCH is build/release/tests/ptx_bench, which runs the PTX that nvcc has embedded on the CPU. Without a scene: of each
kernel its registers, the warps that a multiprocessor holds of it, its stack, its spills and the size of its machine
code. With one: how many instructions a sample of the scene's image costs, by kernel and by pipe, and how many of a
warp's 32 lanes are busy in each instruction; behind it, what uploading the scene and showing its image cost.

ptxas translates the PTX for ARCH with the PTX line of every machine instruction in its debug information, so each is
known to be issued as often as its line. The slow ways of divisions and roots are left out: about one a sample of the
bone look, some 40 instructions each. All warps that the GPU would hold are under way at a time. Needs ptxas, and for a
scene nvdisasm.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

LANES, WARPS, REGISTERS, WARPS_A_BLOCK = 32, 64, 65536, 4  # of a multiprocessor; tests/ptx/runtime/kernels.cpp
PIPES = {  # the first that fits; NVIDIA documents which pipe an instruction takes in part only
    "branch": r"BRA|BSSY|BSYNC|EXIT|CALL|RET|WARPSYNC|BREAK|BMOV|BPT|NOP|YIELD|BRX|JMP",
    "fp64": r"DADD|DMUL|DFMA|DSETP|DMNMX",
    "xu": r"MUFU|F2F|F2I|I2F(?!P)|FRND|POPC|FLO|BREV",
    "fma": r"FADD|FMUL|FFMA|IMAD|HFMA|HADD|HMUL",
    "memory": r"LD|ST|ATOM|RED|TEX",
    "uniform": r"U[A-Z]|R2UR|S2UR|VOTE|S2R|CS2R|R2P|P2R|SHFL",
    "alu": r"",
}
MACHINE_INSTRUCTION = re.compile(r"\s+/\*[0-9a-f]{4,5}\*/\s+(?:@!?U?P\w+\s+)?([A-Z][A-Z0-9_.]*)")

SAMPLING = ("Camera", "Shadow", "Shade", "AddLight", "Onward", "Accumulate", "Trace")  # kernels that run for each sample

Block = collections.namedtuple("Block", "first last statements warps lanes")
Resources = collections.namedtuple("Resources", "registers stack spills")


class Row(collections.namedtuple("Row", "name pipes ptx lanes rest")):
    def busy(self):
        return self.lanes / max(self.pipes.total(), 1)

    def with_other(self, other):
        return self._replace(pipes=self.pipes + other.pipes, ptx=self.ptx + other.ptx, lanes=self.lanes + other.lanes)


class Kernel:
    def __init__(self):
        self.blocks, self.resources, self.machine = [], None, []

    def warps(self):
        registers = (self.resources.registers + 7) // 8 * 8 * LANES
        return min(WARPS, REGISTERS // registers // WARPS_A_BLOCK * WARPS_A_BLOCK)


def fail(text):
    sys.exit(f"gpu_instructions: {text}")


def run(command, **settings):
    try:
        return subprocess.run(command, check=True, capture_output=True, text=True, **settings)
    except FileNotFoundError:
        fail(f"{command[0]} was not found; put it on the PATH")
    except subprocess.CalledProcessError as error:
        fail(f"{command[0]} failed:\n{error.stderr}")


def counted(options, folder):
    """Runs the program, which leaves its modules and counts in the folder, and returns its kernels by module and name.

    Several modules may hold a kernel of the same name, each with lines of its own."""
    together = options.processors * WARPS
    environment = dict(os.environ, PDR_PTX_COUNTS=str(folder), PDR_PTX_TOGETHER=str(together),
                       PDR_PTX_PROCESSORS=str(options.processors))
    command = [options.bench, "--help"]
    if options.scene:
        command = [options.bench, "picture", options.scene, "--device", "cuda", "--samples", str(options.samples)]
    run(command, env=environment)
    kernels = {}
    for line in (folder / "counts.txt").read_text().splitlines():
        kind, *words = line.split()
        if kind == "kernel":
            last = kernels[words[1], words[0]] = Kernel()
        else:
            last.blocks.append(Block(*map(int, words)))
    return kernels


def with_lines(ptx):
    """Returns the PTX with the number of each line as that of its source."""
    lines, inside = [], False
    for number, line in enumerate(ptx.split("\n"), 1):
        text = line.strip()
        inside = text == "{" or (inside and text != "}")
        if inside and text and text[0] not in "./${" and not text.endswith(":"):
            lines.append(f".loc 1 {number} 1")
        lines.append(line)
        if text.startswith(".address_size"):
            lines.append('.file 1 "module.ptx"')
    return "\n".join(lines) + "\n"


def translate(module, kernels, options):
    """Adds resources and machine code to the kernels of a module."""
    source, code = module.with_suffix(".lines.ptx"), module.with_suffix(".cubin")
    source.write_text(with_lines(module.read_text()))
    told = run(["ptxas", f"-arch={options.arch}", "-v", "-lineinfo", source, "-o", code]).stderr
    for part in re.split(r"Compiling entry function '", told)[1:]:
        number = lambda pattern: int(re.search(pattern, part).group(1))
        kernels[module.stem, part.split("'")[0]].resources = Resources(
            number(r"Used (\d+) registers"), number(r"(\d+) bytes stack"), number(r"(\d+) bytes spill stores"))
    kernel, line, slow = None, 0, False
    for text in run([options.nvdisasm, "-g", "-c", code]).stdout.splitlines():
        if begin := re.match(r"//-+ \.text\.(\w+) -+", text):
            kernel, line, slow = kernels[module.stem, begin.group(1)], 0, False
        elif place := re.search(r'//## File ".*", line (\d+)', text):
            line = int(place.group(1))
        elif text.startswith("$"):
            slow = True
        elif (found := MACHINE_INSTRUCTION.match(text)) and kernel:
            kernel.machine.append((0 if slow else line, found.group(1)))


def short(name):
    plain = run(["c++filt", name]).stdout.strip()
    inner = re.search(r"(?:walkQueued|forEachIndex)<(.*)>\(", plain)
    return re.sub(r"pdr::|\(anonymous namespace\)::|, CudaGpu|CudaGpu, ", "", inner.group(1) if inner else plain)


def print_resources(kernels):
    print(f"{'kernel':52} registers warps stack spills instructions")
    named = [(short(name), kernel) for (_, name), kernel in kernels.items()]
    for name, kernel in sorted(named, key=lambda one: one[0]):
        print(f"{name[:52]:52} {kernel.resources.registers:9} {kernel.warps():5} {kernel.resources.stack:5} "
              f"{kernel.resources.spills:6} {len(kernel.machine):12}")


def cost(kernel):
    """Returns instructions by pipe, and the sum of busy lanes."""
    at = {line: block for block in kernel.blocks for line in range(block.first, block.last + 1)}
    pipes, lanes = collections.Counter(), 0
    for line, operation in kernel.machine:
        if block := at.get(line):
            pipes[next(pipe for pipe, pattern in PIPES.items() if re.match(pattern, operation))] += block.warps
            lanes += block.lanes
    return pipes, lanes


def print_costs(kernels, samples):
    print(f"{'a sample':32} {'machine':>8} {'PTX':>8} lanes " + " ".join(f"{pipe:>7}" for pipe in PIPES)
          + " registers warps")
    rows = {}
    for (_, mangled), kernel in kernels.items():
        if not kernel.blocks:
            continue
        pipes, lanes = cost(kernel)
        row = Row(short(mangled), pipes, sum(block.statements * block.warps for block in kernel.blocks), lanes,
                  f"{kernel.resources.registers:10} {kernel.warps():5}")
        rows[row.name] = rows[row.name].with_other(row) if row.name in rows else row
    rows = sorted(rows.values(), reverse=True, key=lambda row: row.pipes.total())
    sampling = [row for row in rows if row.name.startswith(SAMPLING)]
    for row in sampling + [Row("sum", sum((row.pipes for row in sampling), collections.Counter()),
                               sum(row.ptx for row in sampling), sum(row.lanes for row in sampling), "")]:
        print(f"{row.name[:32]:32} {row.pipes.total() / samples:8.1f} {row.ptx / samples:8.1f} {row.busy():5.1f} "
              + " ".join(f"{row.pipes[pipe] / samples:7.1f}" for pipe in PIPES) + row.rest)
    print(f"\n{'an edit and an image, millions':32} {'machine':>8} {'PTX':>8} lanes")
    for row in rows:
        if row not in sampling:
            print(f"{row.name[:32]:32} {row.pipes.total() / 1e6:8.2f} {row.ptx / 1e6:8.2f} {row.busy():5.1f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench")
    parser.add_argument("scene", nargs="?")
    parser.add_argument("--arch", default="sm_90")
    parser.add_argument("--samples", type=int, default=1, help="per pixel")
    parser.add_argument("--processors", type=int, default=132, help="multiprocessors of the GPU")
    parser.add_argument("--nvdisasm", default="nvdisasm")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        kernels = counted(options, folder)
        needed = {module for (module, _), kernel in kernels.items() if kernel.blocks or not options.scene}
        for module in needed:
            translate(folder / f"{module}.ptx", kernels, options)
    if not options.scene:
        return print_resources(kernels)
    film = json.loads(pathlib.Path(options.scene).read_text())["film"]
    print(f"{options.scene}, {film['width']} x {film['height']}, {options.samples} a pixel, {options.arch}, "
          f"{options.processors} multiprocessors: warp instructions a sample, and busy lanes of {LANES} in each")
    print_costs(kernels, options.samples * film["width"] * film["height"])


if __name__ == "__main__":
    main()
