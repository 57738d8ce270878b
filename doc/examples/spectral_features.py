# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Spectral features of a mesh: eigenvalues, and the heat and wave kernel signatures of its vertices.
#
#   python3 spectral_features.py MESH.off FEATURES.npz
#
# Written as for robust_laplacian: only the import is another one.

import sys

import numpy as np
import scipy.sparse.linalg as sla

import intrinsic_triangulations as robust_laplacian
from many_surfaces import read_off  # beside this file


def eigenpairs(verts, faces, number=40):
    """the smallest eigenvalues of -Δ, and functions of norm 1; without triangles, of the surface through the points."""
    if len(faces) > 0:
        L, M = robust_laplacian.mesh_laplacian(np.asarray(verts), np.asarray(faces), mollify_factor=1e-5)
    else:
        L, M = robust_laplacian.point_cloud_laplacian(np.asarray(verts), mollify_factor=1e-5)
    evals, evecs = sla.eigsh(L, number, M, sigma=-1e-8)
    return np.clip(evals, 0, None), evecs, M.diagonal()


def heat_kernel_signature(evals, evecs, times):
    """how much heat is left at each vertex after each time. (J. Sun, M. Ovsjanikov, L. Guibas, 2009)"""
    return evecs**2 @ np.exp(-np.outer(evals, times))


def wave_kernel_signature(evals, evecs, number=16):
    """how probable it is to find a particle of each energy at each vertex. (M. Aubry, U. Schlickewei, D. Cremers, 2011)"""
    logs = np.log(np.maximum(evals, 1e-6 * evals[-1]))[1:]
    energies = np.linspace(logs[0], logs[-1], number)
    width = 7 * (energies[1] - energies[0])
    filters = np.exp(-(energies - logs[:, None])**2 / (2 * width**2))
    return evecs[:, 1:]**2 @ filters / filters.sum(axis=0)


def features(verts, faces, number=40):
    """all of them, in a dictionary. Lengths are relative to the square root of the area."""
    evals, evecs, mass = eigenpairs(verts, faces, number)
    area = mass.sum()
    times = np.geomspace(0.01, 1, 16) * area / (4 * np.pi)
    return {"evals": evals * area, "mass": mass, "hks": heat_kernel_signature(evals, evecs, times) * area,
            "wks": wave_kernel_signature(evals, evecs) * area}


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python3 spectral_features.py MESH.off FEATURES.npz")
    result = features(*read_off(sys.argv[1]))
    np.savez(sys.argv[2], **result)
    print(np.round(result["evals"][:6], 3))
