#!/usr/bin/python3
# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of README and of the manual: solutions, those of the paper redone, refinement, and number types compared.

Those of the paper are its figures 1, 2, 6, 7, 8, 9 and 10. The comparison takes some minutes.

Needs the Debian packages python3-vtk9, python3-matplotlib and, without a display, xvfb.
"""

import argparse
import os
import shutil
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--idt", help="the command (default: on the path, or in build/release/bin)")
    parser.add_argument("--output", type=Path, help="a folder for the pictures (default: doc/images)")
    parser.add_argument("--data", type=Path,
                        help="a folder with the meshes of the paper's Table 1 (cathead.off and so on), "
                             "to be drawn in place of the built-in samples; needs --output")
    parser.add_argument("--only", help="draw this picture alone, by its name without .png")
    options = parser.parse_args()
    if options.data and not options.output:
        parser.error("--data needs --output: only pictures of our own samples belong in the manual")
    return options


def find_command(wanted):
    """The path of idt, or the end of the program."""
    build = HERE.parent.parent / "build" / "release" / "bin" / "idt"
    found = shutil.which(wanted) if wanted else shutil.which("idt") or shutil.which(build)
    if not found:
        sys.exit(f"draw_figures: there is no {wanted or 'idt'}: build it, and name it with --idt")
    return str(Path(found).resolve())


def require_packages():
    """Ends the program if a library is absent."""
    for module, package in [("vtk", "python3-vtk9"), ("matplotlib", "python3-matplotlib"),
                            ("numpy", "python3-numpy"), ("PIL", "python3-pil")]:
        try:
            __import__(module)
        except ImportError as error:
            sys.exit(f"draw_figures: {error}: install the Debian package {package}, and start this "
                     "program with the Python that it is for")


def require_display():
    """VTK draws through an X server. Where there is none, starts again under a virtual one."""
    if os.environ.get("DISPLAY"):
        return
    if not shutil.which("xvfb-run"):
        sys.exit("draw_figures: there is no display: install the Debian packages xvfb and xauth")
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1024x768x24", sys.executable, *sys.argv])


def main():
    options = arguments()
    command = find_command(options.idt)
    require_packages()
    require_display()
    sys.dont_write_bytecode = True  # nothing beside the sources
    import idt_files
    import manual
    output = options.output or HERE.parent / "images"
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        idt = idt_files.Idt(command, folder)
        try:
            subjects = manual.table_1(options.data.resolve()) if options.data else manual.SAMPLES
            manual.draw(idt, subjects, output, options.only)
        except idt_files.Files_error as error:
            sys.exit(f"draw_figures: {error}")


if __name__ == "__main__":
    main()
