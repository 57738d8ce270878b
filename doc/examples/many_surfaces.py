# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# A folder of meshes, over the processes of a machine or the machines of a cluster, by dask.distributed.
#
#   python3 many_surfaces.py FOLDER RESULTS.jsonl [--scheduler ADDRESS] [--workers N] [--limit SECONDS] [--table F.(csv|parquet)]
#   python3 many_surfaces.py --one FILE        # one line, for GNU parallel or an array of Slurm
#   python3 many_surfaces.py --failed FILE WHY # a line for a surface whose process was ended
#   python3 many_surfaces.py --has-line FILE RESULTS.jsonl    # exit status 0 if it has
#   python3 many_surfaces.py --table RESULTS.jsonl F.(csv|parquet)
#
# Each OFF file becomes a line of RESULTS.jsonl: its first eigenvalues, or what went wrong. A run that was stopped goes on where it
# ended. What a lost worker had to do is done by another one. A table has the same with a row for each surface; Parquet needs pyarrow.

import argparse
import csv
import json
import os
import pathlib
import subprocess
import sys
import time


def read_off(path):
    """the vertices and triangles of an OFF file."""
    import numpy
    words = pathlib.Path(path).read_text().split()
    if words[:1] != ["OFF"]:
        raise ValueError("this is no OFF file")
    n, m = int(words[1]), int(words[2])
    V = numpy.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    faces = numpy.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)
    if (faces[:, 0] != 3).any():
        raise ValueError("a face is no triangle")
    return V, faces[:, 1:]


def features(path):
    """what is computed for one surface: replace it by your own."""
    import numpy
    import scipy.sparse.linalg
    import intrinsic_triangulations as it
    V, F = read_off(path)
    L, M = it.mesh_laplacian(V, F)
    eigenvalues = scipy.sparse.linalg.eigsh(L, 6, M, sigma=-1e-6, v0=numpy.ones(len(V)))[0]
    return {"vertices": len(V), "faces": len(F), "area": M.sum(), "eigenvalues": eigenvalues.tolist()}


def name_of(path):
    """the name of a file as text: bytes that are no UTF-8 are shown as \\xff."""
    return os.fsencode(os.path.basename(path)).decode("utf-8", "backslashreplace")


def failure(path, why):
    """the line of a surface without features."""
    return {"file": name_of(path), "error": why.encode("utf-8", "backslashreplace").decode()}


def print_features(path):
    """what the process of one surface does."""
    try:
        text = json.dumps({"file": name_of(path), **features(path)}, allow_nan=False)
    except Exception as error:
        text = json.dumps(failure(path, f"{type(error).__name__}: {error}"))
    print(text)


def one_surface(path, program, limit):
    """the features of one surface, or why there are none: in a process of its own, which is ended when its time is up."""
    start = time.monotonic()
    try:
        run = subprocess.run([sys.executable, program, "--one", path], capture_output=True, text=True, errors="backslashreplace", timeout=limit)
        result = json.loads(run.stdout) if run.returncode == 0 else failure(path, f"exit status {run.returncode}: {run.stderr[-500:]}")
    except subprocess.TimeoutExpired:
        result = failure(path, f"more than {limit} seconds")
    result["seconds"] = round(time.monotonic() - start, 3)
    return result


def finished(results):
    """the files that need not be done again. A last line that is not complete is cut off."""
    if not results.exists():
        return set()
    lines = results.read_text().splitlines(keepends=True)
    if lines and not lines[-1].endswith("\n"):
        results.write_text("".join(lines[:-1]))
        lines.pop()
    return {json.loads(line)["file"] for line in lines}


def write_table(results, table):
    """writes the lines as rows of a table; lists become columns that are numbered."""
    rows = {}
    for text in results.read_text().splitlines():
        row = {}
        for key, value in json.loads(text).items():
            row.update({f"{key}_{i}": x for i, x in enumerate(value)} if isinstance(value, list) else {key: value})
        rows[row["file"]] = row
    rows = [rows[file] for file in sorted(rows)]
    names = list(dict.fromkeys(name for row in rows for name in row))
    if table.suffix == ".parquet":
        import pyarrow
        import pyarrow.parquet
        columns = {name: [row.get(name) for row in rows] for name in names}
        pyarrow.parquet.write_table(pyarrow.table(columns), table)
    else:
        with open(table, "w", newline="", encoding="utf-8") as file:
            writer = csv.DictWriter(file, names)
            writer.writeheader()
            writer.writerows(rows)


def check_table(table):
    """fails before anything is computed."""
    if table.suffix == ".parquet":
        try:
            import pyarrow.parquet  # noqa: F401
        except ImportError:
            sys.exit(f"{table}: Parquet needs the package pyarrow; write a .csv file, or install it")
    elif table.suffix != ".csv":
        sys.exit(f"{table}: a table is written as .csv or .parquet")


def run(client, folder, results, limit):
    """writes a line for each surface that has none; returns how many."""
    from distributed import as_completed
    done = finished(results)
    paths = [str(p.resolve()) for p in sorted(folder.glob("*.off")) if name_of(p) not in done]
    tasks = client.map(one_surface, paths, program=os.path.abspath(__file__), limit=limit, pure=False)
    path_of = {task.key: path for task, path in zip(tasks, paths)}
    with open(results, "a", encoding="utf-8") as file:
        for task in as_completed(tasks):
            try:
                line = task.result()
            except Exception as error:  # workers were lost with it again and again
                line = failure(path_of[task.key], f"{type(error).__name__}: {error}")
            file.write(json.dumps(line) + "\n")
            file.flush()
    return len(paths)


def main():
    parser = argparse.ArgumentParser(description="Features of a folder of meshes")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("results", type=pathlib.Path)
    parser.add_argument("--scheduler", help="the address of a scheduler; without, workers are started on this machine")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--limit", type=float, default=60, help="seconds for each surface")
    parser.add_argument("--table", type=pathlib.Path, help="also write all results as a table, .csv or .parquet")
    options = parser.parse_args()
    if options.table:
        check_table(options.table)
    from distributed import Client, LocalCluster
    cluster = options.scheduler or LocalCluster(n_workers=options.workers, threads_per_worker=1, dashboard_address=None)
    with Client(cluster) as client:
        print(run(client, options.folder, options.results, options.limit), "surfaces")
    if not options.scheduler:
        cluster.close()
    if options.table:
        write_table(options.results, options.table)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        print_features(sys.argv[2])
    elif sys.argv[1:2] == ["--failed"]:
        print(json.dumps(failure(sys.argv[2], sys.argv[3])))
    elif sys.argv[1:2] == ["--has-line"]:
        sys.exit(0 if name_of(sys.argv[2]) in finished(pathlib.Path(sys.argv[3])) else 1)
    elif sys.argv[1:2] == ["--table"]:
        check_table(pathlib.Path(sys.argv[3]))
        write_table(pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]))
    else:
        main()
