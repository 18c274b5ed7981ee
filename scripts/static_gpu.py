#!/usr/bin/env python3
"""Compiles all kernels for GPUs without a GPU: do they compile and link, and what do they need of registers and stack?

    scripts/static_gpu.py [--program build/release/pencil] [--targets sm_90,gfx1030,gfx90a] [--jobs N] [--quick] [--markdown]

Needs clang with the targets and libclc (Debian 12: clang-19 libclc-19-dev lld-19); for NVIDIA's registers and spills ptxas, from
$PTXAS or the path. Ends with 77, "skipped", where clang lacks what is needed, and with 1 where a kernel does not compile or link,
spills registers, or takes more stack than its bound below.
"""
import argparse
import concurrent.futures
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

# Private memory of one work-item [bytes] that a kernel may take: what exceeds the first has its reason here.
STACK = 256
CHAIN = "a chain's vertex with all its lobes, and the stack of the hierarchy (204 bytes)"
STACK_OF = {
    "project_pencils": (2560, "cells of weights: the nearest pencil or ray of each of the sampled directions, and radii"),
    "project_rays": (320, "the stack of the hierarchy, and a place"),
    "film_surfels": (320, "a point of a surface with relief, beside calls that other kernels of the program share"),
    "trace_hemispheres": (512, "the stack of the hierarchy, and calls that other kernels of the program share"),
    "sample_lights": (2304, "16 surfels draw their samples together at any width"),
    "trace_checks": (1152, CHAIN),
    "follow_surfels": (960, CHAIN),
    "light_lobes": (832, CHAIN),
    "guide_hemispheres": (832, "the spots of a pencil beside the stack of the hierarchy"),
    "share_hemispheres": (832, "the spots of a pencil and their rings"),
    "light_surfels": (320, "the stack of the hierarchy, surfel and sample"),
    "link_surfels": (1024, "rays of the eight pencils that may stand in"),
    "project_surface_pencils": (1024, "rays of the eight pencils that may stand in"),
    "test_visibility": (320, "the stack of the hierarchy, surfel and map"),
}
CLC = "/usr/lib/clc"
SKIPPED = 77
FORMS = ("dpdf", "voronoi", "analytic", "thesis", "power")  # PENCIL_WEIGHTS_*


class Target:
    def __init__(self, name, triple, clc, flags):
        self.name, self.triple, self.clc, self.flags = name, triple, os.path.join(CLC, clc), flags

    def is_amd(self):
        return self.triple.startswith("amdgcn")


def targets():
    nvidia = ["-mllvm", "-nvptx-prec-divf32=1", "-mllvm", "-nvptx-prec-sqrtf32=0"]
    return {t.name: t for t in (
        Target("sm_90", "nvptx64--nvidiacl", "nvptx64--nvidiacl.bc", ["-Xclang", "-target-cpu", "-Xclang", "sm_90"] + nvidia),
        Target("gfx1030", "amdgcn--amdhsa", "amdgcn--amdhsa.bc", ["-mcpu=gfx1030"]),
        Target("gfx90a", "amdgcn--amdhsa", "amdgcn--amdhsa.bc", ["-mcpu=gfx90a"]))}


def run(command, **rest):
    return subprocess.run(command, capture_output=True, text=True, **rest)


def find_clang():
    for name in [os.environ.get("CLANG", ""), "clang-19", "clang-18", "clang-17", "clang"]:
        if name and shutil.which(name):
            return name
    return None


def variants(listing, quick):
    """Programs with the defines of scenes that need nothing and everything, and of each form of weights; quick: of scenes that need all."""
    for file, text in listing["programs"].items():
        for scene, defines in listing["defines"].items():
            if quick and scene != "whole":
                continue
            forms = {"": {}}
            if "PENCIL_WEIGHTS" in text:
                forms = {name: {"PENCIL_WEIGHTS": str(number), "PENCIL_CELL_GRID": "16" if name in ("voronoi", "power") else "0"}
                         for number, name in enumerate(FORMS)}
            for form, more in forms.items():
                for bvh in ("0", "1") if "PENCIL_BVH" in text and not quick else ("1",):
                    name = " ".join(filter(None, (scene, form, "rays" if bvh == "1" else "")))
                    yield file, name, text, {**defines, **more, "PENCIL_BVH": bvh, "SELF_TEST_GROUP": "64"}


def amd_kernels(assembly):
    """Name -> numbers, from the metadata that the loader reads."""
    found = {}
    for entry in re.split(r"\n  - \.", assembly.split("amdhsa.kernels:")[-1])[1:]:
        fields = dict(re.findall(r"\.?(\w+): +(\S+)", entry))
        if "private_segment_fixed_size" in fields:
            found[fields["name"]] = {"stack": int(fields["private_segment_fixed_size"]), "registers": int(fields["vgpr_count"]),
                                     # Scalar registers spill to lanes of vector registers, not to memory.
                                     "spills": int(fields["vgpr_spill_count"]),
                                     "local": int(fields["group_segment_fixed_size"])}
    return found


def nvidia_kernels(assembly, report):
    """From ptxas' report; without one, stack only."""
    found = {}
    for name, body in re.findall(r"\.entry (\w+)\((.*?)\n}", assembly, re.S):
        found[name] = {"stack": sum(int(n) for n in re.findall(r"__local_depot\d+\[(\d+)\]", body)), "registers": None, "spills": None,
                       "local": None}
    for name, body in re.findall(r"Compiling entry function '(\w+)'(.*?)(?=Compiling entry|\Z)", report, re.S):
        stack, stores, loads = map(int, re.search(r"(\d+) bytes stack frame, (\d+) bytes spill stores, (\d+) bytes spill loads", body).groups())
        local = re.search(r"(\d+) bytes smem", body)
        found[name] = {"stack": stack, "registers": int(re.search(r"Used (\d+) registers", body).group(1)), "spills": stores + loads,
                       "local": int(local.group(1)) if local else 0}
    return found


def compile_one(clang, target, file, variant, text, defines):
    with tempfile.TemporaryDirectory() as folder:
        source, assembly, binary = (os.path.join(folder, name) for name in ("a.cl", "a.s", "a.o"))
        with open(source, "w", encoding="utf-8") as out:
            out.write(text)
        command = [clang, "-x", "cl", "-cl-std=CL1.2", "-Xclang", "-finclude-default-header", "-nogpulib", "-O3", "-Werror",
                   "-target", target.triple, *target.flags, "-Xclang", "-mlink-builtin-bitcode", "-Xclang", target.clc,
                   *(f"-D{name}={value}" for name, value in defines.items()), "-S", source, "-o", assembly]
        steps = run(command)
        if steps.returncode:
            return file, variant, target, {}, steps.stderr
        with open(assembly, encoding="utf-8") as read:
            made = read.read()
        if target.is_amd():
            steps = run([clang, "-target", target.triple, *target.flags, "-c", assembly, "-o", binary])
            if steps.returncode == 0:
                steps = run([shutil.which("ld.lld-19") or "ld.lld", "-shared", "--no-undefined", binary, "-o", binary + ".so"])
            return file, variant, target, amd_kernels(made), steps.stderr if steps.returncode else ""
        undefined = re.findall(r"\.extern \.func.*?(\w+)\s*\n?\(", made)
        if undefined:
            return file, variant, target, {}, "undefined: " + " ".join(undefined)
        report = ""
        if PTXAS:
            steps = run([PTXAS, "-v", "-arch=" + target.name, assembly, "-o", binary])
            if steps.returncode:
                return file, variant, target, {}, steps.stderr
            report = steps.stderr
        return file, variant, target, nvidia_kernels(made, report), ""


def faults_of(file, variant, target, kernels, trouble):
    place = f"{target.name} {file} ({variant})"
    if trouble:
        return [f"{place}: {trouble.strip()[:2000]}"]
    faults = [] if kernels else [f"{place}: no kernel found"]
    for name, need in kernels.items():
        bound = STACK_OF.get(name, (STACK, ""))[0]
        if need["stack"] > bound:
            faults.append(f"{place}: {name} takes {need['stack']} bytes of stack, bound {bound}")
        if need["spills"]:
            faults.append(f"{place}: {name} spills {need['spills']}")
    return faults


def most(results):
    """Kernel -> target -> the most that any variant takes."""
    table = {}
    for _, _, target, kernels, _ in results:
        for name, need in kernels.items():
            row = table.setdefault(name, {}).setdefault(target.name, dict.fromkeys(need))
            for key, value in need.items():
                if value is not None:
                    row[key] = max(row[key] or 0, value)
    return table


def print_markdown(table, names):
    print("| kernel | " + " | ".join(f"{n} registers | stack [B]" for n in names) + " | local [B] |\n|---" * 1 + "|---" * (2 * len(names)) + "|---|")
    for kernel, row in sorted(table.items()):
        cells = []
        for n in names:
            need = row.get(n, {})
            cells += ["" if need.get(key) is None else str(need[key]) for key in ("registers", "stack")]
        print(f"| `{kernel}` | " + " | ".join(cells) + f" | {max((r['local'] or 0) for r in row.values())} |")


def main():
    parse = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parse.add_argument("--program", default="build/release/pencil")
    parse.add_argument("--targets", default="sm_90,gfx1030,gfx90a")
    parse.add_argument("--jobs", type=int, default=os.cpu_count())
    parse.add_argument("--only", default="", help="programs whose file has this in its name")
    parse.add_argument("--quick", action="store_true", help="only the kernels of scenes that need all features")
    parse.add_argument("--markdown", action="store_true")
    given = parse.parse_args()
    clang = find_clang()
    chosen = [targets()[name] for name in given.targets.split(",")]
    have = run([clang, "--print-targets"]).stdout if clang else ""
    linker = shutil.which("ld.lld-19") or shutil.which("ld.lld")
    missing = [t.name for t in chosen if not os.path.exists(t.clc) or t.triple.split("-")[0] not in have or (t.is_amd() and not linker)]
    if not clang or missing:
        print(f"skipped: no clang with targets and libclc for {' '.join(missing) or given.targets} (Debian: clang-19 libclc-19-dev lld-19)")
        return SKIPPED
    listing = json.loads(run([given.program, "document", "programs"], check=True).stdout)
    work = [(t, *v) for v in variants(listing, given.quick) for t in chosen if given.only in v[0]]
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        results = list(pool.map(lambda w: compile_one(clang, *w), work))
    faults = [fault for result in results for fault in faults_of(*result)]
    if given.markdown:
        print_markdown(most(results), [t.name for t in chosen])
    print(f"{len(results)} compilations of {len(listing['programs'])} programs for {', '.join(t.name for t in chosen)}"
          f"{'' if PTXAS else ' (no ptxas: NVIDIA registers and spills unknown)'}: {len(faults)} faults", file=sys.stderr)
    print("\n".join(faults), file=sys.stderr)
    return 1 if faults else 0


PTXAS = os.environ.get("PTXAS") or shutil.which("ptxas")
if __name__ == "__main__":
    sys.exit(main())
