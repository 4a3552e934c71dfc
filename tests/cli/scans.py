"""Small scans as DICOM series and TIFF stacks, written by libraries that share no
code with the program's readers."""

import struct

import numpy
import pydicom
import tifffile
from pydicom.dataset import FileDataset, FileMetaDataset
from pydicom.uid import (CTImageStorage, ExplicitVRLittleEndian, ImplicitVRLittleEndian,
                         RLELossless)

AXIAL = (1, 0, 0, 0, 1, 0)


def volume(size, value):
    """An array by [k, j, i]."""
    return numpy.array([[[value(i, j, k) for i in range(size[0])] for j in range(size[1])]
                        for k in range(size[2])])


def slice_position(origin, orientation, along):
    normal = numpy.cross(orientation[:3], orientation[3:])
    return [float(o + along * n) for o, n in zip(origin, normal)]


def write_slice(path, pixels, position, series="1.2.3", spacing=(1, 1), thickness=1,
                orientation=AXIAL, number=1, samples=1, syntax=ExplicitVRLittleEndian):
    """`spacing` is along i and j; DICOM has it the other way round."""
    meta = FileMetaDataset()
    meta.MediaStorageSOPClassUID = CTImageStorage
    meta.MediaStorageSOPInstanceUID = f"{series}.{number}"
    implicit = syntax == ImplicitVRLittleEndian
    meta.TransferSyntaxUID = syntax if implicit else ExplicitVRLittleEndian
    data = FileDataset(str(path), {}, file_meta=meta, preamble=b"\0" * 128)
    data.is_little_endian, data.is_implicit_VR = True, implicit
    data.SOPClassUID = CTImageStorage
    data.SOPInstanceUID = meta.MediaStorageSOPInstanceUID
    data.StudyInstanceUID, data.SeriesInstanceUID = "1.2", series
    data.Modality, data.InstanceNumber = "CT", number
    data.Rows, data.Columns = pixels.shape[:2]
    data.PixelSpacing = [spacing[1], spacing[0]]
    data.SliceThickness = thickness
    data.ImagePositionPatient = [round(float(p), 6) for p in position]
    data.ImageOrientationPatient = list(orientation)
    data.SamplesPerPixel = samples
    data.PhotometricInterpretation = "MONOCHROME2" if samples == 1 else "RGB"
    if samples == 3:
        data.PlanarConfiguration = 0
    data.BitsAllocated = data.BitsStored = 8 * pixels.itemsize
    data.HighBit = data.BitsStored - 1
    data.PixelRepresentation = int(pixels.dtype.kind == "i")
    if samples == 1:
        data.RescaleSlope, data.RescaleIntercept = 1, 0
    data.PixelData = pixels.tobytes()
    if syntax == RLELossless:
        data.compress(RLELossless)
    data.save_as(str(path), write_like_original=False)


def write_series(folder, voxels, spacing=(1, 1, 1), origin=(0, 0, 0), orientation=AXIAL,
                 series="1.2.3", positions=None, skip=(), syntax=ExplicitVRLittleEndian):
    """Names and instance numbers run against the slices' positions."""
    folder.mkdir(exist_ok=True)
    count = len(voxels)
    for k, pixels in enumerate(voxels):
        if k in skip:
            continue
        along = positions[k] if positions else k * spacing[2]
        write_slice(folder / f"{series}-{5 * k % count:03}.dcm", pixels.astype("int16"),
                    slice_position(origin, orientation, along), series, spacing,
                    spacing[2], orientation, number=count - k, syntax=syntax)


def write_tiff(path, voxels, **settings):
    tifffile.imwrite(str(path), voxels, photometric="minisblack", **settings)


def write_packed_tiff(path, voxels, bits):
    """Voxels of 2 or 4 bits, rows filled up to whole bytes; one strip a page."""
    depth, rows, columns = voxels.shape
    pages, at = b"", 8
    for n, page in enumerate(voxels.astype("uint8")):
        lines = [numpy.unpackbits(row[:, None], axis=1)[:, 8 - bits:].flatten() for row in page]
        data = b"".join(numpy.packbits(line).tobytes() for line in lines)
        data += b"\0" * (len(data) % 2)
        tags = ((256, 3, columns), (257, 3, rows), (258, 3, bits), (259, 3, 1), (262, 3, 1),
                (273, 4, at), (277, 3, 1), (278, 3, rows), (279, 4, len(data)))
        directory = at + len(data)
        following = directory + 2 + 12 * len(tags) + 4
        pages += data + struct.pack("<H", len(tags)) + b"".join(
            struct.pack("<HHII", tag, kind, 1, value) for tag, kind, value in tags)
        pages += struct.pack("<I", 0 if n + 1 == depth else following + len(data))
        at = following
    first = 8 + len(data)
    path.write_bytes(b"II*\0" + struct.pack("<I", first) + pages)


def write_imagej(path, voxels, spacing, unit="mm"):
    tifffile.imwrite(str(path), voxels, imagej=True,
                     resolution=(1 / spacing[0], 1 / spacing[1]),
                     metadata={"spacing": spacing[2], "unit": unit, "axes": "ZYX"})


__all__ = ["AXIAL", "ImplicitVRLittleEndian", "RLELossless", "pydicom", "volume", "write_imagej", "write_packed_tiff", "write_series", "write_slice",
           "write_tiff"]
