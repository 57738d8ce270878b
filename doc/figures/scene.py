# Copyright (c) 2026 The Intrinsic_triangulations developers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of surfaces in space, drawn by VTK into arrays of pixels."""

from dataclasses import dataclass

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

SURFACE_COLOR = (0.46, 0.56, 0.69)


@dataclass
class Camera:
    """Where a surface is seen from; without a `height` all of it is seen."""
    direction: tuple  # from the surface to the camera
    up: tuple = (0, 0, 1)
    center: tuple = None  # of what the picture shows
    height: float = None  # of what the picture shows, in the unit of the surface
    size: tuple = (480, 440)


def _points(points):
    result = vtk.vtkPoints()
    result.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    return result


def _cells(lists):
    cells = vtk.vtkCellArray()
    for indices in lists:
        cells.InsertNextCell(len(indices))
        for i in indices:
            cells.InsertCellPoint(int(i))
    return cells


def _actor(data):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def _soften(actor):
    """Makes light and shade differ less."""
    actor.GetProperty().SetAmbient(0.65)
    actor.GetProperty().SetDiffuse(0.4)


def polygons(points, faces, colors=None):
    """A lit surface; `colors` are those of the faces, from 0 to 1."""
    data = vtk.vtkPolyData()
    data.SetPoints(_points(points))
    data.SetPolys(_cells(faces))
    if colors is not None:
        array = numpy_to_vtk(np.round(255 * np.asarray(colors)[:, :3]).astype(np.uint8), deep=True)
        data.GetCellData().SetScalars(array)
    actor = _actor(data)
    actor.GetProperty().SetColor(SURFACE_COLOR)
    if colors is not None:
        _soften(actor)  # colors that mean something must stay what they are
    actor.GetProperty().SetInterpolationToFlat()
    return actor


def bands(points, faces, values, limits, colors):
    """A lit surface in bands of equal width, one of each color, between two limits of the values at its points."""
    number = len(colors)
    data = vtk.vtkPolyData()
    data.SetPoints(_points(points))
    data.SetPolys(_cells(faces))
    data.GetPointData().SetScalars(numpy_to_vtk(np.clip(values, *limits), deep=True))
    contours = vtk.vtkBandedPolyDataContourFilter()
    contours.SetInputData(data)
    contours.GenerateValues(number + 1, *limits)
    contours.SetScalarModeToIndex()
    contours.Update()
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(number)
    for i, color in enumerate(colors):
        table.SetTableValue(i, *color[:3], 1)
    actor = _actor(contours.GetOutput())
    mapper = actor.GetMapper()
    mapper.SetScalarModeToUseCellData()
    mapper.SetScalarRange(0, number - 1)
    mapper.SetLookupTable(table)
    _soften(actor)
    return actor


def tubes(paths, color, radius):
    """Lines on a surface, each the list of its points, as thin tubes that light does not change."""
    data = vtk.vtkPolyData()
    data.SetPoints(_points(np.concatenate(paths)))
    starts = np.cumsum([0] + [len(path) for path in paths])
    data.SetLines(_cells([range(a, b) for a, b in zip(starts, starts[1:])]))
    tube = vtk.vtkTubeFilter()
    tube.SetInputData(data)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(8)
    tube.Update()
    actor = _actor(tube.GetOutput())
    actor.GetProperty().SetColor(color)
    actor.GetProperty().LightingOff()
    return actor


def textured(obj_path):
    """The surface of an OBJ file with the material and the image that it names."""
    importer = vtk.vtkOBJImporter()
    importer.SetFileName(str(obj_path))
    importer.SetFileNameMTL(str(obj_path.with_suffix(".mtl")))
    importer.SetTexturePath(str(obj_path.parent))
    importer.Update()
    actors = [actor for actor in importer.GetRenderer().GetActors()
              if actor.GetMapper().GetInput().GetNumberOfCells() > 0]
    if len(actors) != 1 or actors[0].GetTexture() is None:
        raise RuntimeError(f"{obj_path}: not one surface with a texture")
    actor = actors[0]
    actor.GetTexture().InterpolateOn()
    actor.GetTexture().MipmapOn()
    actor.GetProperty().SetInterpolationToFlat()
    actor.GetProperty().SetColor(1, 0.9, 0.65)
    actor.GetProperty().SetSpecular(0)
    _soften(actor)
    return actor


def render(actors, camera):
    """Draws what the camera sees; returns rows of pixels, each red, green and blue."""
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    lights = vtk.vtkLightKit()
    lights.SetKeyLightIntensity(0.95)
    lights.AddLightsToRenderer(renderer)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    factor = 3  # pixels in each direction that make one in the end
    window.SetSize(*(factor * n for n in camera.size))
    window.AddRenderer(renderer)
    _aim(renderer, actors, camera)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1, :, :3]
    blocks = pixels.reshape(height // factor, factor, width // factor, factor, 3)
    return np.round(blocks.mean(axis=(1, 3))).astype(np.uint8)


def _aim(renderer, actors, camera):
    """Points a camera without perspective at the middle of what there is."""
    back = np.array(camera.direction) / np.linalg.norm(camera.direction)
    right = np.cross(camera.up, back)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(back, right), back])
    points = np.concatenate([vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData())
                             for actor in actors]) @ axes.T
    center = axes.T @ (points.min(axis=0) + points.max(axis=0)) / 2
    extent = np.ptp(points, axis=0)
    height = 1.06 * max(extent[1], extent[0] * camera.size[1] / camera.size[0])
    if camera.height is not None:
        center, height = np.array(camera.center), camera.height
    view = renderer.GetActiveCamera()
    view.ParallelProjectionOn()
    view.SetFocalPoint(*center)
    view.SetPosition(*(center + 2 * np.linalg.norm(extent) * back))
    view.SetViewUp(*camera.up)
    view.SetParallelScale(height / 2)
    renderer.ResetCameraClippingRange()
