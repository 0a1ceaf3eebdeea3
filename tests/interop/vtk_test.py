# SPDX-License-Identifier: BSD-3-Clause
"""VTK's own HDF reader, which is ParaView's, opens packing.h5 and finds the spheres.  DUMP FOLDER"""

import os
import sys

from reference import Reference, check, need

need("vtkmodules")
hdf = need("vtkmodules.vtkIOHDF")
vtk_to_numpy = need("vtkmodules.util.numpy_support").vtk_to_numpy


def main():
    reference = Reference(sys.argv[1])
    path = os.path.join(sys.argv[2], "packing.h5")
    reader = hdf.vtkHDFReader()
    assert reader.CanReadFile(path)
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    check("points", vtk_to_numpy(grid.GetPoints().GetData()), reference.positions)
    point_data = grid.GetPointData()
    check("diameters", vtk_to_numpy(point_data.GetArray("diameter")), reference.diameters)
    check("ids", vtk_to_numpy(point_data.GetArray("id")), reference.ids)
    assert grid.GetNumberOfCells() == 1 and grid.GetCell(0).GetNumberOfPoints() == len(reference.ids)


if __name__ == "__main__":
    main()
