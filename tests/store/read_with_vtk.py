# SPDX-License-Identifier: MIT
"""Opens a bundle with VTK's own HDF reader, the one ParaView uses, and the exported VTU with its XML reader."""
import sys

try:
    import vtk
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)


def check_grid(grid, what):
    assert grid.GetNumberOfPoints() == 164 and grid.GetNumberOfCells() == 200, what
    assert all(grid.GetCellType(t) == vtk.VTK_TETRA for t in range(200)), what
    assert grid.GetBounds() == (0, 1, 0, 40, 0, 1), what
    size = vtk.vtkCellSizeFilter()
    size.SetInputData(grid)
    size.Update()
    measured = size.GetOutput().GetCellData().GetArray("Volume")
    stored = grid.GetCellData().GetArray("volume")
    assert all(abs(measured.GetValue(t) - stored.GetValue(t)) < 1e-6 for t in range(200)), what
    for name in ("material", "region", "stiffness_scale"):
        assert grid.GetCellData().GetArray(name).GetNumberOfTuples() == 200, name
    locked = grid.GetPointData().GetArray("locked")
    assert [locked.GetValue(n) for n in range(164)] == [1] * 8 + [0] * 156, what
    assert grid.GetPointData().GetArray("mass").GetNumberOfTuples() == 164, what


def check_fields(grid):
    angles = grid.GetCellData().GetArray("min_dihedral_deg")
    assert [angles.GetValue(t) for t in range(200)] == [0.5 * t for t in range(200)]
    assert grid.GetCellData().GetArray("shell_limit").GetValue(199) == 2
    assert grid.GetPointData().GetArray("component").GetValue(163) == 7
    places = grid.GetFieldData().GetArray("paint%2F1.position")
    assert [places.GetTuple(i) for i in range(places.GetNumberOfTuples())] == [(1, 2, 3), (4, 5, 6)]


def main(folder):
    for name in ("small.hdf", "contiguous.hdf", "fields.hdf"):
        reader = vtk.vtkHDFReader()
        assert reader.CanReadFile(folder + "/" + name), name
        reader.SetFileName(folder + "/" + name)
        reader.Update()
        check_grid(reader.GetOutput(), name)
        if name == "fields.hdf":
            check_fields(reader.GetOutput())
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(folder + "/small.vtu")
    reader.Update()
    check_grid(reader.GetOutput(), "small.vtu")
    reader = vtk.vtkOBJReader()
    reader.SetFileName(folder + "/small.obj")
    reader.Update()
    surface = reader.GetOutput()
    assert surface.GetNumberOfPolys() == 2 * (2 + 4 * 40), "two triangles a square of the tower's surface"
    print(vtk.vtkVersion().GetVTKSourceVersion(), "opens them")


main(sys.argv[1])
