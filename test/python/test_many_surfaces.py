# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The example that runs a folder of surfaces: on two workers of this machine, and from the shell.

import csv
import importlib.util
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import threading
import time

import pytest

needs_dask = pytest.mark.skipif(importlib.util.find_spec("distributed") is None,
                                reason="skipped: there is no package distributed (on Debian: apt install python3-distributed)")
needs_parallel = pytest.mark.skipif(shutil.which("parallel") is None, reason="skipped: there is no GNU parallel (on Debian: apt install parallel)")

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


def write_surfaces(folder, number):
    # Seven vertices, as six eigenvalues are wanted.
    for k in range(number):
        text = OCTAHEDRON.format(height=1 + k).replace("6 8 0", "7 8 0").replace("0 0 -1\n", "0 0 -1  9 9 9\n")
        (folder / f"{k}.off").write_text(text)


@needs_dask
def test_each_surface_has_one_line(tmp_path):
    write_surfaces(tmp_path, 4)
    (tmp_path / "bad.off").write_text("OFF\n1\n")
    out, lines, number = run(tmp_path, "--table", str(tmp_path / "r.csv"))
    assert out == "5 surfaces\n" and number == 5
    with open(tmp_path / "r.csv", newline="") as file:
        rows = {row["file"]: row for row in csv.DictReader(file)}
    assert sorted(rows) == sorted(lines) and rows["bad.off"]["error"] == lines["bad.off"]["error"]
    assert [float(rows["1.off"][f"eigenvalues_{i}"]) for i in range(6)] == lines["1.off"]["eigenvalues"]
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


@needs_dask
def test_a_lost_worker(tmp_path):
    """Its task is done by the other one, and every surface has one line."""
    from distributed import Client, LocalCluster
    spec = importlib.util.spec_from_file_location("many_surfaces", PROGRAM)
    program = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(program)
    write_surfaces(tmp_path, 5)
    results = tmp_path / "r.jsonl"
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        pids = list(client.run(os.getpid).values())

        def kill_one():
            while not results.exists() or len(results.read_text().splitlines()) < 2:
                time.sleep(0.01)
            os.kill(pids[0], signal.SIGKILL)

        killer = threading.Thread(target=kill_one)
        killer.start()
        assert program.run(client, tmp_path, results, 60) == 5
        killer.join()
    lines = [json.loads(line) for line in results.read_text().splitlines()]
    assert sorted(line["file"] for line in lines) == [f"{k}.off" for k in range(5)]
    assert not any("error" in line for line in lines)


def test_tables(tmp_path):
    results = tmp_path / "r.jsonl"
    results.write_text('{"file": "b.off", "x": [1, 2.5]}\n{"file": "a.off", "error": "no, \\"none\\""}\n')
    write = [sys.executable, str(PROGRAM), "--table", str(results)]
    assert subprocess.run([*write, str(tmp_path / "r.csv")]).returncode == 0
    with open(tmp_path / "r.csv", newline="") as file:
        assert list(csv.reader(file)) == [["file", "error", "x_0", "x_1"], ["a.off", 'no, "none"', "", ""], ["b.off", "", "1", "2.5"]]
    parquet = subprocess.run([*write, str(tmp_path / "r.parquet")], capture_output=True, text=True)
    if importlib.util.find_spec("pyarrow") is None:
        assert parquet.returncode == 1 and "pyarrow" in parquet.stderr and not (tmp_path / "r.parquet").exists()
    else:
        import pyarrow.parquet
        assert pyarrow.parquet.read_table(tmp_path / "r.parquet").to_pylist()[1] == {"file": "b.off", "error": None, "x_0": 1, "x_1": 2.5}


@needs_parallel
def test_parallel(tmp_path):
    """The command of the manual: a run goes on where it ended."""
    write_surfaces(tmp_path, 3)
    files = sorted(map(str, tmp_path.glob("*.off")))
    command = ["parallel", "-0", "--joblog", str(tmp_path / "log.txt"), "--resume", "--timeout", "60", sys.executable, str(PROGRAM), "--one", "{}",
               ":::"]
    first = subprocess.run(command + files[:2], capture_output=True, text=True)
    again = subprocess.run(command + files, capture_output=True, text=True)
    for done, names in ((first, ["0.off", "1.off"]), (again, ["2.off"])):
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        assert sorted(line["file"] for line in lines) == names and all(len(line["eigenvalues"]) == 6 for line in lines), done.stderr


def run_array_task(folder, task, count, **variables):
    environment = {**os.environ, "SLURM_ARRAY_TASK_ID": task, "SLURM_ARRAY_TASK_COUNT": count, "SLURM_ARRAY_TASK_MIN": "1",
                   "MANY_SURFACES": str(PROGRAM), "PYTHON": sys.executable, **variables}
    done = subprocess.run(["bash", str(PROGRAM.with_suffix(".sbatch")), str(folder), str(folder / "parts")], env=environment,
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def lines_of_parts(folder):
    return [json.loads(line) for part in (folder / "parts").glob("*.jsonl") for line in part.read_text().splitlines()]


def write_odd_names(folder):
    """surfaces whose names need to be quoted, in a shell or in JSON; and how a line names them."""
    names = {b"a b.off": "a b.off", b'q"u\'o.off': 'q"u\'o.off', b"back\\slash.off": "back\\slash.off", b"new\nline.off": "new\nline.off",
             b"$(touch x).off": "$(touch x).off", b"\xff.off": "\\xff.off", "ö\u2028.off".encode(): "ö\u2028.off", b"-one.off": "-one.off"}
    write_surfaces(folder, 1)
    surface = (folder / "0.off").read_bytes()
    (folder / "0.off").unlink()
    for name in names:
        with open(os.path.join(os.fsencode(folder), name), "wb") as file:
            file.write(surface)
    return sorted(names.values())


def test_slurm_array_of_odd_names(tmp_path):
    """Lines are JSON, also those of surfaces whose time is up or whose process fails; none is done twice."""
    names = write_odd_names(tmp_path)
    for _ in range(2):
        run_array_task(tmp_path, "1", "1")
        lines = lines_of_parts(tmp_path)
        assert sorted(line["file"] for line in lines) == names and all(len(line["eigenvalues"]) == 6 for line in lines)
    broken = tmp_path / "broken.sh"
    broken.write_text(f'#!/bin/sh\ncase "$*" in *--one*) exit 3;; esac\nexec "{sys.executable}" "$@"\n')
    broken.chmod(0o755)
    for variables, error in (({"LIMIT": "0.001"}, "more than 0.001 seconds"), ({"PYTHON": str(broken)}, "exit status 3")):
        shutil.rmtree(tmp_path / "parts")
        run_array_task(tmp_path, "1", "1", **variables)
        lines = lines_of_parts(tmp_path)
        assert sorted(line["file"] for line in lines) == names and all(line["error"] == error for line in lines)


def test_slurm_array_without_surfaces(tmp_path):
    run_array_task(tmp_path, "1", "1")
    assert lines_of_parts(tmp_path) == []


@needs_dask
def test_odd_names(tmp_path):
    names = write_odd_names(tmp_path)
    out, lines, number = run(tmp_path, "--table", str(tmp_path / "r.csv"))
    assert sorted(lines) == names and number == len(names) and not any("error" in line for line in lines.values())
    with open(tmp_path / "r.csv", newline="", encoding="utf-8") as file:
        assert sorted(row["file"] for row in csv.DictReader(file)) == names
    assert run(tmp_path)[0] == "0 surfaces\n"


@needs_parallel
def test_parallel_with_odd_names(tmp_path):
    names = write_odd_names(tmp_path)
    files = [os.path.join(os.fsencode(tmp_path), name) for name in os.listdir(os.fsencode(tmp_path))]
    command = ["parallel", "-0", "--joblog", str(tmp_path / "log.txt"), "--resume", "--timeout", "60", sys.executable, str(PROGRAM), "--one", "{}",
               ":::"]
    for expected in (names, []):
        done = subprocess.run([*map(os.fsencode, command), *sorted(files)], capture_output=True, text=True)
        assert sorted(json.loads(line)["file"] for line in done.stdout.splitlines()) == expected, done.stderr


def test_slurm_array(tmp_path):
    """The script, as Slurm would call it for three tasks; one of them twice."""
    write_surfaces(tmp_path, 4)
    (tmp_path / "bad.off").write_text("OFF\n1\n")
    for task in ("1", "2", "3", "2"):
        run_array_task(tmp_path, task, "3")
    assert sorted(line["file"] for line in lines_of_parts(tmp_path)) == ["0.off", "1.off", "2.off", "3.off", "bad.off"]
    assert len(list((tmp_path / "parts").glob("*.jsonl"))) == 3
