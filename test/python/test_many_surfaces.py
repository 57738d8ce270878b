# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The example that runs a folder of surfaces, on two workers of this machine.

import json
import pathlib
import subprocess
import sys

import pytest

pytest.importorskip("distributed", reason="skipped: there is no package distributed (on Debian: apt install python3-distributed)")

PROGRAM = pathlib.Path(__file__).parents[2] / "doc/examples/many_surfaces.py"
OCTAHEDRON = """OFF
6 8 0
1 0 0  0 1 0  -1 0 0  0 -1 0  0 0 {height}  0 0 -1
3 0 1 4  3 1 2 4  3 2 3 4  3 3 0 4  3 1 0 5  3 2 1 5  3 3 2 5  3 0 3 5
"""


def run(folder, *options):
    result = subprocess.run([sys.executable, str(PROGRAM), str(folder), str(folder / "r.jsonl"), "--workers", "2", *options],
                            capture_output=True, text=True, timeout=120)
    assert result.returncode == 0, result.stderr
    lines = (folder / "r.jsonl").read_text().splitlines()
    return result.stdout, {line["file"]: line for line in map(json.loads, lines)}, len(lines)


def test_each_surface_has_one_line(tmp_path):
    # Seven vertices, as six eigenvalues are wanted.
    for k in range(4):
        text = OCTAHEDRON.format(height=1 + k).replace("6 8 0", "7 8 0").replace("0 0 -1\n", "0 0 -1  9 9 9\n")
        (tmp_path / f"{k}.off").write_text(text)
    (tmp_path / "bad.off").write_text("OFF\n1\n")
    out, lines, number = run(tmp_path)
    assert out == "5 surfaces\n" and number == 5
    assert sorted(lines) == ["0.off", "1.off", "2.off", "3.off", "bad.off"]
    assert "IndexError" in lines["bad.off"]["error"]
    assert all(lines[f"{k}.off"]["faces"] == 8 for k in range(4))
    assert abs(lines["0.off"]["area"] - 4 * 3 ** 0.5) < 2e-3  # mesh_laplacian() makes edges a little longer

    # What is there is not done again, and a line that was cut off is.
    results = tmp_path / "r.jsonl"
    results.write_text(results.read_text() + '{"file": "4.o')
    (tmp_path / "4.off").write_text((tmp_path / "0.off").read_text())
    out, lines, number = run(tmp_path)
    assert out == "1 surfaces\n" and number == 6
    assert lines["4.off"]["eigenvalues"] == lines["0.off"]["eigenvalues"]

    # Time is bounded.
    (tmp_path / "5.off").write_text((tmp_path / "0.off").read_text())
    out, lines, number = run(tmp_path, "--limit", "0.001")
    assert lines["5.off"]["error"] == "more than 0.001 seconds" and number == 7
