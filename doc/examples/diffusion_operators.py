# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The operators that a network which learns by diffusion on surfaces needs of each mesh or point cloud: mass, Laplacian, eigenfunctions,
# and the gradient in a frame at each vertex. (N. Sharp, S. Attaiki, K. Crane, M. Ovsjanikov, "DiffusionNet", 2022.)
#
#   python3 diffusion_operators.py MESH.off OPERATORS.npz
#
# Written as for robust_laplacian and potpourri3d: only the imports are others.

import sys

import numpy as np
import scipy.sparse
import scipy.sparse.linalg as sla
import scipy.spatial

import intrinsic_triangulations as robust_laplacian
import intrinsic_triangulations as pp3d
from many_surfaces import read_off  # beside this file


def vertex_normals(verts, faces, number_of_neighbors=30):
    """unit normals: sums over the triangles, or of the planes through the nearest points."""
    if len(faces) == 0:
        near = scipy.spatial.cKDTree(verts).query(verts, number_of_neighbors + 1)[1]
        return np.linalg.svd(verts[near] - verts[:, None])[2][:, 2]
    a, b, c = (verts[faces[:, i]] for i in range(3))
    normals = np.zeros_like(verts)
    for i in range(3):
        np.add.at(normals, faces[:, i], np.cross(b - a, c - a))
    return normals / np.linalg.norm(normals, axis=1, keepdims=True)


def tangent_frames(normals):
    """for each vertex two axes and the normal, as rows."""
    x = np.where(np.abs(normals[:, :1]) < 0.9, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    x = x - normals * (x * normals).sum(axis=1, keepdims=True)
    x /= np.linalg.norm(x, axis=1, keepdims=True)
    return np.stack([x, np.cross(normals, x), normals], axis=1)


def gradient(verts, frames, tails, tips, regularization=1e-5):
    """two matrices that take values to the coordinates of their gradient: what fits the differences along the edges best."""
    tails, tips = tails[tails != tips], tips[tails != tips]
    n = len(verts)
    edge = verts[tips] - verts[tails]
    vectors = np.stack([(edge * frames[tails, i]).sum(axis=1) for i in (0, 1)], axis=1)
    squares = np.zeros((n, 2, 2))
    np.add.at(squares, tails, vectors[:, :, None] * vectors[:, None, :])
    weights = np.linalg.solve(squares + regularization * np.eye(2), np.eye(2)[None].repeat(n, axis=0))
    weights = (weights[tails] @ vectors[:, :, None])[:, :, 0]
    sums = [scipy.sparse.coo_matrix((weights[:, i], (tails, tips)), shape=(n, n)).tocsc() for i in (0, 1)]
    return [g - scipy.sparse.diags(np.asarray(g.sum(axis=1)).ravel()) for g in sums]


def compute_operators(verts, faces, k_eig=32):
    """frames, mass, Laplacian, eigenvalues, eigenfunctions, and the two coordinates of the gradient."""
    small = 1e-8
    frames = tangent_frames(vertex_normals(verts, faces))
    if len(faces) == 0:
        L, M = robust_laplacian.point_cloud_laplacian(verts)
        mass = M.diagonal()
        near = scipy.spatial.cKDTree(verts).query(verts, 31)[1]
        tails, tips = np.repeat(np.arange(len(verts)), 30), near[:, 1:].ravel()
    else:
        L = pp3d.cotan_laplacian(verts, faces, denom_eps=1e-10)
        mass = pp3d.vertex_areas(verts, faces)
        mass = mass + small * mass.mean()
        pattern = L.tocoo()
        tails, tips = pattern.row, pattern.col
    evals, evecs = sla.eigsh((L + scipy.sparse.identity(len(verts)) * small).tocsc(), k=k_eig, M=scipy.sparse.diags(mass), sigma=small)
    grad_x, grad_y = gradient(verts, frames, tails, tips)
    return frames, mass, L, np.clip(evals, 0, None), evecs, grad_x, grad_y


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: python3 diffusion_operators.py MESH.off OPERATORS.npz")
    frames, mass, L, evals, evecs, grad_x, grad_y = compute_operators(*read_off(sys.argv[1]))
    np.savez(sys.argv[2], frames=frames, mass=mass, L=L.toarray(), evals=evals, evecs_squared=evecs**2, grad_x=grad_x.toarray(),
             grad_y=grad_y.toarray())
    print(np.round(evals[:6], 3))
