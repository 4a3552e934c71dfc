"""Programs that read meshes by code of their own; of one that is not installed all is None."""

import numpy as np

try:
    import meshio
except ImportError:
    meshio = None
try:
    import h5py
except ImportError:
    h5py = None
try:
    import gmsh
except ImportError:
    gmsh = None
try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOHDF import vtkHDFReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
except ImportError:
    vtk_to_numpy = vtkHDFReader = vtkXMLPolyDataReader = vtkXMLUnstructuredGridReader = None


def read_by_vtk(reader, file):
    """What a reader of VTK finds in a file."""
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def arrays_of(grid):
    """Points, shape (n, 3), and cells, one after the other, of an unstructured grid of VTK."""
    return (vtk_to_numpy(grid.GetPoints().GetData()),
            vtk_to_numpy(grid.GetCells().GetConnectivityArray()))


def open_in_gmsh(file, test):
    """Opens a file until a test ends.  Points, shape (n, 3), in the order of their tags."""
    gmsh.initialize()
    test.addCleanup(gmsh.finalize)
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(file)
    tags, places, _ = gmsh.model.mesh.getNodes()
    points = np.empty((int(max(tags)), 3))
    points[np.asarray(tags, np.int64) - 1] = np.reshape(places, (-1, 3))
    return points
