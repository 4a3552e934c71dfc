#!/usr/bin/env python3
"""Writes inputs that other programs make: a seed for each reader, beside the corpus.

    others.py FOLDER [WRITE_SMALL_VOLUMES]

meshio, Gmsh and VTK write meshes and surfaces, NiBabel, pydicom and tifffile images, and
OpenVDB (by the program that is named) volumes.  What is not installed is left out, and
said.  The first bytes of an input are those of corpus/: they choose the format.
"""
import io
import pathlib
import subprocess
import sys
import tempfile

folder = pathlib.Path(sys.argv[1])
MESH = {".vtu": 0, ".mesh": 1, ".meshb": 2, ".msh": 3}
SURFACE = {".stl": 0, ".obj": 1, ".ply": 2, ".off": 3}


def put(target, name, content):
    (folder / target).mkdir(parents=True, exist_ok=True)
    (folder / target / name).write_bytes(content)


def put_mesh(name, file):
    """For all that is done with a mesh; the format that it is converted to varies."""
    content = bytes([MESH[file.suffix]]) + file.read_bytes()
    for target in ("mesh_file", "picture"):
        put(target, name, content)
    put("convert", name, bytes([sum(name.encode()) % 11]) + content)


def of_meshio(place):
    import logging
    import meshio
    import numpy
    logging.disable()
    points = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1.5)])
    tets = numpy.array([(0, 1, 2, 3), (1, 2, 3, 4)])
    faces = numpy.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4)])
    mesh = meshio.Mesh(points, {"tetra": tets}, cell_data={"medit:ref": [numpy.array([1, 2])]})
    mixed = meshio.Mesh(points, {"triangle": faces, "tetra": tets},
                        cell_data={"gmsh:physical": [numpy.arange(6), numpy.array([1, 2])],
                                   "gmsh:geometrical": [numpy.arange(6), numpy.array([1, 2])]})
    for which, name in ((mesh, "plain"), (mixed, "mixed")):
        for form, suffix, options in (
                ("vtu", ".vtu", {"binary": False}), ("vtu", ".vtu", {"compression": None}),
                ("vtu", ".vtu", {"compression": "zlib"}), ("medit", ".mesh", {}),
                ("medit", ".meshb", {}), ("gmsh22", ".msh", {"binary": False}),
                ("gmsh22", ".msh", {"binary": True})):
            file = place / ("a" + suffix)
            meshio.write(file, which, file_format=form, **options)
            words = "-".join(str(v) for v in options.values()) or "only"
            put_mesh(f"meshio-{name}-{form}-{words}{suffix}", file)
    surface = meshio.Mesh(points, {"triangle": faces})
    for suffix, options in ((".stl", {"binary": True}), (".stl", {"binary": False}), (".obj", {}),
                            (".ply", {"binary": True}), (".ply", {"binary": False}), (".off", {})):
        file = place / ("s" + suffix)
        meshio.write(file, surface, **options)
        words = "".join("-binary" for v in options.values() if v)
        put("surface", f"meshio{words}{suffix}", bytes([SURFACE[suffix]]) + file.read_bytes())


def of_gmsh(place):
    import gmsh
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.option.setNumber("Mesh.MeshSizeMin", 1)
    box = gmsh.model.occ.addBox(0, 0, 0, 1, 1, 1)
    gmsh.model.occ.synchronize()
    gmsh.model.addPhysicalGroup(3, [box], 7)
    gmsh.model.setPhysicalName(3, 7, "bone")
    gmsh.model.mesh.generate(3)
    for version, binary in ((2.2, 0), (2.2, 1), (4.1, 0), (4.1, 1)):
        gmsh.option.setNumber("Mesh.MshFileVersion", version)
        gmsh.option.setNumber("Mesh.Binary", binary)
        gmsh.write(str(place / "g.msh"))
        put_mesh(f"gmsh-{version}-{binary}.msh", place / "g.msh")
    gmsh.option.setNumber("Mesh.Binary", 0)
    gmsh.write(str(place / "g.mesh"))
    put_mesh("gmsh.mesh", place / "g.mesh")
    gmsh.finalize()


def of_vtk(place):
    import vtk
    points, grid = vtk.vtkPoints(), vtk.vtkUnstructuredGrid()
    for p in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)):
        points.InsertNextPoint(p)
    grid.SetPoints(points)
    for kind, corners in ((vtk.VTK_TETRA, (0, 1, 2, 3)), (vtk.VTK_TRIANGLE, (0, 2, 1)),
                          (vtk.VTK_TETRA, (1, 2, 3, 4))):
        grid.InsertNextCell(kind, len(corners), corners)
    label = vtk.vtkIntArray()
    label.SetName("label")
    for n in range(3):
        label.InsertNextValue(n)
    grid.GetCellData().AddArray(label)
    for form in ("Ascii", "Binary", "Appended"):
        for packing in ("None", "ZLib"):
            writer = vtk.vtkXMLUnstructuredGridWriter()
            getattr(writer, f"SetDataModeTo{form}")()
            getattr(writer, f"SetCompressorTypeTo{packing}")()
            writer.SetFileName(str(place / "v.vtu"))
            writer.SetInputData(grid)
            writer.Write()
            put_mesh(f"vtk-{form}-{packing}.vtu", place / "v.vtu")


def of_nibabel(place):
    import nibabel
    import numpy
    voxels = numpy.arange(24).reshape(2, 3, 4)
    for kind, suffix, choice in ((nibabel.Nifti1Image, "nii", 0), (nibabel.Nifti2Image, "nii", 0),
                                 (nibabel.Nifti1Image, "nii.gz", 1)):
        for number in ("uint8", "int16", "float32", "float64"):
            image = kind(voxels.astype(number), numpy.diag((1, 2, 3, 1)))
            image.header.set_slope_inter(0.5, -3) if number == "int16" else None
            nibabel.save(image, str(place / f"n.{suffix}"))
            put("image", f"nibabel-{kind.__name__}-{number}.{suffix}",
                bytes([choice]) + (place / f"n.{suffix}").read_bytes())
    nibabel.save(nibabel.Nifti1Pair(voxels.astype("int16"), numpy.eye(4)), str(place / "p.img"))
    put_parts("nibabel.hdr", 2, (place / "p.hdr").read_bytes(), (place / "p.img").read_bytes())


def put_parts(name, choice, header, voxels):
    put("image_parts", name, bytes([choice]) + len(header).to_bytes(2, "little") + header + voxels)


def of_headers(_):
    """Headers of MetaImage and NRRD whose voxels are elsewhere, as ITK writes them."""
    import gzip
    import zlib
    voxels = bytes(range(24))
    meta = (b"ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
            b"CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\n"
            b"CenterOfRotation = 0 0 0\nAnatomicalOrientation = RAI\nElementSpacing = 1 1 1\n"
            b"DimSize = 3 4 2\nElementType = MET_UCHAR\nElementDataFile = ")
    for name, place in (("one", b"a.raw"), ("list", b"LIST\n1.raw\n2.raw"),
                        ("numbers", b"%d.raw 1 2 1")):
        put_parts(name + ".mhd", 0, meta + place + b"\n", voxels)
    put_parts("packed.mhd", 0, meta.replace(b"CompressedData = False", b"CompressedData = True")
              + b"a.raw\n", zlib.compress(voxels))
    nrrd = (b"NRRD0005\n# Complete NRRD file format specification at:\ntype: unsigned char\n"
            b"dimension: 3\nspace: left-posterior-superior\nsizes: 3 4 2\n"
            b"space directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\n"
            b"encoding: raw\nspace origin: (0,0,0)\ndata file: ")
    for name, place in (("one", b"a.raw"), ("list", b"LIST\n1.raw\n2.raw"),
                        ("numbers", b"%d.raw 1 2 1"), ("skip", b"a.raw\nbyte skip: 0")):
        put_parts(name + ".nhdr", 1, nrrd + place + b"\n", voxels)
    put_parts("packed.nhdr", 1, nrrd.replace(b"raw\nspace", b"gzip\nspace") + b"a.raw\n",
              gzip.compress(voxels, mtime=0))


def of_pydicom(_):
    import numpy
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
    from frames_test import dataset, describe, segmentation
    stack = numpy.arange(24, dtype="int16").reshape(2, 3, 4)
    for name, data in (("frames", describe(dataset("a", stack), [0.0, 2.0])),
                       ("segments", segmentation("a", [stack[0] > 3, stack[1] > 15, stack[1] > 3],
                                                 [0.0, 2.0, 2.0], [1, 1, 2], ["a", "b"]))):
        file = io.BytesIO()
        data.save_as(file, write_like_original=False)
        put("image", f"pydicom-{name}.dcm", b"\5" + file.getvalue())


def of_pydicom_series(place):
    import numpy
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
    from scans import write_series
    write_series(place / "series", numpy.arange(24, dtype="int16").reshape(2, 3, 4))
    slices = [file.read_bytes() for file in sorted((place / "series").iterdir())]
    longest = max(map(len, slices))
    put("dicom", "pydicom", b"".join(s + bytes(longest - len(s)) for s in slices))


def of_tifffile(place):
    import numpy
    import tifffile
    stack = numpy.arange(192).reshape(2, 12, 8)
    for name, number, options in (
            ("plain", "uint8", {}), ("wide", "uint16", {"byteorder": ">"}), ("real", "float32", {}),
            ("imagej", "uint8", {"imagej": True, "resolution": (2, 2), "metadata": {"spacing": 3}}),
            ("zlib", "uint16", {"compression": "zlib"}), ("big", "uint8", {"bigtiff": True}),
            ("tiles", "uint8", {"tile": (16, 16)}), ("strips", "uint16", {"rowsperstrip": 5}),
            ("bits", "bool", {"photometric": "minisblack"})):
        tifffile.imwrite(str(place / "t.tif"), stack.astype(number), **options)
        put("image", f"tifffile-{name}.tif", b"\4" + (place / "t.tif").read_bytes())


def of_mricron(_):
    """The tables of labels of its atlases."""
    for file in sorted(pathlib.Path("/usr/share/mricron/templates").glob("*.txt")):
        put("label_names", "mricron-" + file.name, file.read_bytes()[:4000])


def with_zeros_packed(content):
    """A zero is followed by how many more there are."""
    packed, at = bytearray(), 0
    while at < len(content):
        packed.append(content[at])
        at += 1
        if packed[-1] == 0:
            more = 0
            while more < 255 and at < len(content) and content[at] == 0:
                more, at = more + 1, at + 1
            packed.append(more)
    return bytes(packed)


def of_openvdb(place):
    if len(sys.argv) < 3:
        raise ImportError("no program that writes volumes")
    subprocess.run([sys.argv[2], place], check=True)
    for file in sorted(place.glob("*.vdb")):
        put("volume", file.name, with_zeros_packed(file.read_bytes()))


for write in (of_meshio, of_gmsh, of_vtk, of_nibabel, of_headers, of_pydicom, of_pydicom_series,
              of_tifffile, of_mricron, of_openvdb):
    with tempfile.TemporaryDirectory() as name:
        try:
            write(pathlib.Path(name))
        except ImportError as missing:
            print(f"{write.__name__[3:]} is left out: {missing}")
