#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws meshes and cooked bundles into a PNG, without a display.

    scripts/render_mesh.py samples/car/car_shell.glb -o shell.png --wire
    scripts/render_mesh.py car.hdf -o inside.png --cut 'x>0.2'
    scripts/render_mesh.py car.hdf -o quality.png --field min_dihedral_deg --range 0,40
    scripts/render_mesh.py car_visual.glb car_shell.glb -o both.png --ghost car_shell

Needs python3-vtk9, python3-numpy, and xvfb where no display is set.
"""
import argparse
import math
import os
import re
import shutil
import sys

import numpy

import mesh_files

VIEWS = {"quarter": (-1.3, 0.8, 1.6), "rear": (1.3, 0.8, -1.6), "side": (-1, 0, 0), "front": (0, 0, 1), "top": (0, 1, 0.001),
         "below": (-1, -0.8, 1.2)}


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", "--out", required=True, help="the PNG to write")
    parser.add_argument("--view", default="quarter", help="one or more, side by side: " + ",".join(VIEWS))
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--zoom", type=float, default=1.0)
    parser.add_argument("--wire", action="store_true", help="draw triangle edges")
    parser.add_argument("--smooth", action="store_true", help="shade curved surfaces smoothly")
    parser.add_argument("--locks", action="store_true", help="mark locked vertices with red balls")
    parser.add_argument("--ghost", action="append", default=[], metavar="NAME", help="see-through part (or file stem); repeatable")
    parser.add_argument("--hide", action="append", default=[], metavar="NAME", help="leave a part out; repeatable")
    parser.add_argument("--cut", metavar="x<0.2", help="keep only elements whose middle lies there; also x>0.2")
    parser.add_argument("--cut-part", metavar="NAME", help="cut this part only, for example region_0 of a bundle")
    parser.add_argument("--field", help="colour the tets of a bundle by this field of them, red to blue")
    parser.add_argument("--range", default="0,1", metavar="BAD,GOOD", help="values of red and blue")
    parser.add_argument("--below", type=float, help="draw only the tets whose field is below this")
    args = parser.parse_args()
    args.range = [float(value) for value in args.range.split(",")]
    if len(args.range) != 2 or args.range[0] == args.range[1]:
        parser.error("--range wants two numbers that differ, such as 0,40")
    unknown = [view for view in args.view.split(",") if view not in VIEWS]
    if args.cut and not re.fullmatch(r"[xyz][<>]-?[0-9.]+", args.cut):
        parser.error(f"--cut {args.cut}: write it like 'x<0.2'")
    if unknown:
        parser.error(f"no view is called {unknown[0]}; there are: {', '.join(VIEWS)}")
    return args


def middles_kept(part, cut):
    axis, side, limit = "xyz".index(cut[0]), cut[1], float(cut[2:])
    middle = part.points[part.triangles].mean(axis=1)[:, axis]
    return middle < limit if side == "<" else middle > limit


def boundary(part):
    """Faces of tets that no other tet shares, with the tet each belongs to."""
    corners = [(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)]
    faces = numpy.concatenate([part.triangles[:, c] for c in corners])
    owner = numpy.tile(numpy.arange(len(part.triangles)), 4)
    _, first, count = numpy.unique(numpy.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
    alone = first[count == 1]
    return faces[alone], owner[alone]


def poly_data(part, args):
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    cell_colors = len(part.colors) == len(part.triangles) and part.triangles.shape[1] == 4
    if args.cut and args.cut_part in (None, part.name):
        kept = middles_kept(part, args.cut)
        part.triangles = part.triangles[kept]
        if cell_colors:
            part.colors = part.colors[kept]
    faces, colors = part.triangles, part.colors
    if faces.shape[1] == 4:
        faces, owner = boundary(part)
        colors = part.colors[owner]
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(part.points), deep=True))
    cells = vtk.vtkCellArray()
    cells.SetCells(len(faces), numpy_to_vtkIdTypeArray(
        numpy.hstack([numpy.full((len(faces), 1), 3), faces]).astype(numpy.int64).ravel(), deep=True))
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(cells)
    if len(colors):
        scalars = numpy_to_vtk(numpy.ascontiguousarray(display(colors)), deep=True)
        (mesh.GetCellData() if cell_colors else mesh.GetPointData()).SetScalars(scalars)
    return mesh


def display(linear):
    """Vertex colours are linear light, a screen wants sRGB."""
    return (255 * (numpy.clip(linear, 0, 255) / 255) ** (1 / 2.2)).astype(numpy.uint8)


def smoothed(mesh):
    import vtk
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SetFeatureAngle(35)
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


def actor_of(part, args, ghost):
    import vtk
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(smoothed(poly_data(part, args)) if args.smooth else poly_data(part, args))
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    if args.smooth:
        look.SetInterpolationToPhong()
    else:
        look.SetInterpolationToFlat()
    look.SetAmbient(0.25)
    look.SetDiffuse(0.8)
    look.SetSpecular(0.15)
    look.SetSpecularPower(30)
    if ghost:
        mapper.ScalarVisibilityOff()
        look.SetRepresentationToWireframe()
        look.LightingOff()
        look.SetColor(0.3, 0.33, 0.38)
        look.SetOpacity(0.3)
    elif args.wire:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.1, 0.1, 0.12)
        look.SetLineWidth(1.2)
    return actor


def locks_of(part, size):
    import vtk
    from vtk.util.numpy_support import numpy_to_vtk
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(part.points[part.locked]), deep=True))
    cloud = vtk.vtkPolyData()
    cloud.SetPoints(points)
    ball = vtk.vtkSphereSource()
    ball.SetRadius(size * 0.004)
    balls = vtk.vtkGlyph3D()
    balls.SetInputData(cloud)
    balls.SetSourceConnection(ball.GetOutputPort())
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(balls.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.85, 0.1, 0.1)
    return actor


def legend(args):
    import vtk
    table = vtk.vtkLookupTable()
    table.SetNumberOfTableValues(64)
    table.SetRange(*args.range)
    for i in range(64):
        table.SetTableValue(i, *(display(mesh_files.scale_color(numpy.array(i / 63))) / 255))
    bar = vtk.vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(args.field)
    bar.SetNumberOfLabels(5)
    bar.SetLabelFormat("%.3g")
    bar.SetOrientationToHorizontal()
    bar.SetPosition(0.3, 0.88)
    bar.SetWidth(0.4)
    bar.SetHeight(0.1)
    bar.UnconstrainedFontSizeOn()
    for style, size in ((bar.GetTitleTextProperty(), 15), (bar.GetLabelTextProperty(), 13)):
        style.SetColor(0.15, 0.15, 0.2)
        style.SetFontSize(size)
        style.ItalicOff()
        style.ShadowOff()
    return bar


def scene(args, view, aspect):
    import vtk
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(0.93, 0.94, 0.96)
    renderer.SetBackground2(0.74, 0.78, 0.84)
    renderer.GradientBackgroundOn()
    low, high = numpy.full(3, numpy.inf), numpy.full(3, -numpy.inf)
    for path in args.files:
        stem = os.path.splitext(os.path.basename(path))[0]
        for part in mesh_files.read(path, field=args.field, limits=args.range, below=args.below):
            low, high = numpy.minimum(low, part.points.min(axis=0)), numpy.maximum(high, part.points.max(axis=0))
            if part.name in args.hide or stem in args.hide:
                continue
            renderer.AddActor(actor_of(part, args, part.name in args.ghost or stem in args.ghost))
            if args.locks and part.locked.any():
                renderer.AddActor(locks_of(part, numpy.linalg.norm(high - low)))
    if args.field:
        renderer.AddActor2D(legend(args))
    aim(renderer, (low + high) / 2, numpy.linalg.norm(high - low), view, args.zoom * min(1, aspect / 1.5))
    return renderer


def aim(renderer, centre, size, view, zoom):
    import vtk
    direction = numpy.array(VIEWS[view], float)
    eye = centre + direction / numpy.linalg.norm(direction) * size * 2
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(centre)
    camera.SetPosition(eye)
    camera.SetViewUp(0, 1, 0)
    camera.SetViewAngle(20 / zoom)
    renderer.ResetCameraClippingRange()
    for place, strength in [((-1, 2, 1.5), 0.75), ((2, 1, 0.5), 0.4), ((-2, 0.5, -1), 0.35)]:
        light = vtk.vtkLight()
        light.SetPosition(centre + numpy.array(place) * size)
        light.SetFocalPoint(centre)
        light.SetIntensity(strength)
        renderer.AddLight(light)


def draw(args):
    import vtk
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    width, height = [int(n) for n in args.size.split("x")]
    window.SetSize(width, height)
    views = args.view.split(",")
    columns = math.ceil(math.sqrt(len(views)))
    rows = math.ceil(len(views) / columns)
    for number, view in enumerate(views):
        renderer = scene(args, view, (width / columns) / (height / rows))
        column, row = number % columns, rows - 1 - number // columns
        renderer.SetViewport(column / columns, row / rows, (column + 1) / columns, (row + 1) / rows)
        window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(args.out)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    args = options()
    if "DISPLAY" not in os.environ:
        if not shutil.which("xvfb-run"):
            sys.exit("no display and no xvfb-run: install the packages xvfb and xauth")
        os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1920x1200x24", sys.executable] + sys.argv)
    draw(args)


main()
