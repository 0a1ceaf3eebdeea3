#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Reads every #include in lib/ and apps/ and holds them to the layers of docs/architecture.md.

Usage: scripts/check_layers.py [root of the project]. Prints each violation; exit status 1 if any.
"""

import re
import sys
from pathlib import Path

# What each folder of lib/ may include besides itself, in the order in which data flows. A folder
# only ever names folders above its own row, so folders cannot form a circle.
MAY_INCLUDE = {
    "core": "",
    "sizes": "core",
    "cell": "core",
    "particles": "core",
    "packing": "core cell particles",
    "grids": "core sizes cell particles",
    "placement": "core sizes cell particles grids",
    "neighbors": "core sizes cell particles grids",
    "contacts": "core sizes cell particles grids neighbors",
    "analysis": "core sizes cell particles packing grids neighbors contacts",
    "report": "core sizes cell particles packing analysis",
    "jamming": "core sizes cell particles packing grids placement neighbors contacts analysis",
    "sweep": "core packing analysis report jamming",
    "handoff": "core particles packing neighbors jamming",
}
TBB = re.compile(r"(oneapi/)?tbb[/.]")
TBB_DOOR = ("core/parallel.h", "core/parallel.cpp")
TBB_RULE = "only core/parallel.* may include oneTBB"
HEADERS_MAY_SHOW = ("Eigen/", "fmt/", "immintrin.h")  # what whoever builds on us has too
INCLUDE = re.compile(r'^\s*#\s*include\s+(<[^>]+>|"[^"]+")')


def includes(path):
    """(line number, text between the quotes or brackets, is it quoted) of each #include."""
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        if match := INCLUDE.match(line):
            yield number, match[1][1:-1], match[1][0] == '"'


def library_include_problem(file, target, known):
    """What is wrong with one of lib/'s files including another, or None."""
    own, other = file.split("/")[0], target.split("/")[0]
    if target not in known:
        return f'"{target}" is no file of lib/: include as "folder/file.h"'
    if other != own and other not in MAY_INCLUDE[own].split():
        return f"{own} may not include {other} (it sees: {MAY_INCLUDE[own] or 'nothing'})"
    return None


def system_include_problem(file, target):
    """What is wrong with a file of lib/ including something from outside, or None."""
    if TBB.match(target):
        return None if file in TBB_DOOR else TBB_RULE
    foreign = "/" in target or target.endswith(".h")
    if file.endswith(".h") and foreign and not target.startswith(HEADERS_MAY_SHOW):
        return f"<{target}> in a header reaches whoever includes it: keep it in a .cpp"
    return None


def app_include_problem(file, target, known, apps):
    """What is wrong with a program including `target`, or None."""
    own, other = file.split("/")[0], target.split("/")[0]
    if target in known or (target in apps and other in (own, "shared")):
        return None
    if target in apps:
        return f"{own} may not include {other}: what both need belongs in apps/shared or lib/"
    return f'"{target}" is no file of lib/ or apps/: include as "folder/file.h"'


def circle(graph):
    """The files of one circle of includes, or None."""
    state = {}

    def visit(file, trail):
        if state.get(file) == "done":
            return None
        if file in trail:
            return trail[trail.index(file):] + [file]
        for target in graph.get(file, []):
            if found := visit(target, trail + [file]):
                return found
        state[file] = "done"
        return None

    return next((found for file in graph if (found := visit(file, []))), None)


def sources(folder):
    files = sorted(p for p in folder.rglob("*") if p.suffix in (".h", ".cpp"))
    return {p.relative_to(folder).as_posix(): p for p in files}


def library_problems(library, generated):
    known, graph = set(library) | generated, {}
    for file, path in library.items():
        if file.split("/")[0] not in MAY_INCLUDE:
            yield f"lib/{file}: its folder has no row in scripts/check_layers.py"
            continue
        graph[file] = []
        for number, target, quoted in includes(path):
            if quoted:
                problem = library_include_problem(file, target, known)
                graph[file].append(target)
            else:
                problem = system_include_problem(file, target)
            if problem:
                yield f"lib/{file}:{number}: {problem}"
    if found := circle(graph):
        yield "lib: these include each other in a circle: " + " -> ".join(found)


def program_problems(apps, known):
    for file, path in apps.items():
        for number, target, quoted in includes(path):
            problem = TBB_RULE if TBB.match(target) else None
            if quoted:
                problem = app_include_problem(file, target, known, apps)
            if problem:
                yield f"apps/{file}:{number}: {problem}"


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    library, apps = sources(root / "lib"), sources(root / "apps")
    if not library:
        sys.exit(f"no sources under {root / 'lib'}: give the root of the project")
    templates = (root / "lib").rglob("*.h.in")
    generated = {p.relative_to(root / "lib").with_suffix("").as_posix() for p in templates}
    problems = list(library_problems(library, generated))
    problems += program_problems(apps, set(library) | generated)
    for problem in problems:
        print(problem)
    print(f"{len(library)} files of lib/ and {len(apps)} of apps/: {len(problems)} layer violation(s)")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
