// One file by one of ITK's readers, and which reader an input is for.

#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <utility>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "completeness.hpp"
#include "geometry.hpp"
#include "image_file.hpp"
#include "itk_voxels.hpp"
#include "meta_header.hpp"
#include "nifti_header.hpp"
#include "nrrd_header.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Reader = itk::ImageIOBase;

/// Made by name and not through ITK's object factories, which would load every
/// format there is.
Reader::Pointer reader_for(const fs::path& file) {
  const std::array<Reader::Pointer, 3> readers{itk::NrrdImageIO::New().GetPointer(),
                                               itk::NiftiImageIO::New().GetPointer(),
                                               itk::MetaImageIO::New().GetPointer()};
  const std::string name = file.string();
  for (const Reader::Pointer& reader : readers) {
    if (!reader->CanReadFile(name.c_str())) continue;
    reader->SetFileName(name);
    return reader;
  }
  refuse(file, "is not a NIfTI, NRRD, MetaImage or TIFF file");
}

/// Trailing dimensions of one element do no harm.
void judge_shape(const fs::path& file, const Reader& header) {
  const unsigned dimensions = header.GetNumberOfDimensions();
  if (dimensions < 3)
    refuse(file, "has " + std::to_string(dimensions) + " dimensions, not 3");
  for (unsigned d = 3; d < dimensions; ++d)
    if (header.GetDimensions(d) != 1)
      refuse(file, "has " + std::to_string(dimensions) + " dimensions, not 3");
  if (header.GetNumberOfComponents() != 1)
    refuse(file, "has " + std::to_string(header.GetNumberOfComponents()) +
                     " numbers per voxel, not 1");
  for (unsigned d = 0; d < 3; ++d)
    if (header.GetDimensions(d) < 1) refuse(file, "has no voxels");
}

/// \returns the bytes of all voxels.
std::uint64_t judge_bytes(const fs::path& file, const Reader& header,
                          std::uint64_t max_bytes) {
  std::uint64_t bytes = header.GetComponentSize();
  if (bytes == 0) refuse(file, "has voxels of an unknown type");
  for (unsigned d = 0; d < 3; ++d) {
    const std::uint64_t count = header.GetDimensions(d);
    if (count > (std::uint64_t{1} << 31) ||
        bytes > std::numeric_limits<std::int64_t>::max() / count)
      refuse(file, "has impossible dimensions");
    bytes *= count;
  }
  // What is in one file cannot unpack to more than deflate's greatest ratio.
  const std::string extension = file.extension().string();
  const bool detached = extension == ".nhdr" || extension == ".mhd" ||
                        extension == ".hdr" || extension == ".img";
  const std::uint64_t greatest_ratio = 1040;
  if (!detached && bytes / greatest_ratio > fs::file_size(file))
    refuse(file, "is too short for the dimensions in its header");
  judge_memory(file, bytes, max_bytes);
  return bytes;
}

void read_geometry(const Reader& header, Image& image) {
  for (unsigned a = 0; a < 3; ++a) {
    image.size[a] = static_cast<std::int64_t>(header.GetDimensions(a));
    image.spacing[a] = header.GetSpacing(a);
    image.origin[a] = header.GetOrigin(a);
    const std::vector<double> direction = header.GetDirection(a);
    for (std::size_t r = 0; r < 3; ++r) image.axes[r][a] = direction[r];
  }
  judge_geometry(image);
  orthonormalise(image);
}

Image read(const fs::path& file, std::uint64_t max_bytes) {
  itk::Object::SetGlobalWarningDisplay(false);
  judge_meta_header(file);
  judge_nifti_header(file);
  judge_nrrd_header(file);
  const Reader::Pointer reader = reader_for(file);
  reader->ReadImageInformation();
  judge_shape(file, *reader);
  const std::uint64_t bytes = judge_bytes(file, *reader, max_bytes);
  judge_meta_packed_size(file, bytes);
  // At the same time as the voxels are read, for unpacking is what takes long.
  auto complete = std::async(std::launch::async, is_complete, file, bytes);
  Image image;
  image.name = file.string();
  read_geometry(*reader, image);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned d = 0; d < reader->GetNumberOfDimensions(); ++d)
    region.SetSize(d, reader->GetDimensions(d));
  reader->SetIORegion(region);
  image.voxels = load_voxels(file, reader->GetComponentType(), bytes,
                             [&](void* voxels) { reader->Read(voxels); });
  if (!complete.get()) refuse(file, "is truncated or damaged");
  return image;
}

Image read_any(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  std::error_code failure;
  if (fs::is_directory(file, failure)) return read_dicom(file, max_bytes, choice.series);
  if (!fs::is_regular_file(file, failure)) refuse(file, "is not a regular file");
  if (!choice.series.empty()) refuse(file, "is no folder, so that it holds no DICOM series");
  if (is_dicom(file))
    refuse(file, "is one file of DICOM; give the folder that holds its series");
  if (is_tiff(file)) return read_tiff(file, max_bytes, !choice.spacing);
  return read(file, max_bytes);
}

}  // namespace

bool can_read_images() { return true; }

Image read_image(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  std::error_code failure;
  if (!fs::exists(file, failure)) refuse(file, "does not exist");
  try {
    Image image = read_any(file, max_bytes, choice);
    if (choice.spacing) {
      image.spacing = *choice.spacing;
      judge_geometry(image);
    }
    return image;
  } catch (const itk::ExceptionObject&) {
    // ITK's own text has many lines, source files and addresses.
    refuse(file, "is truncated or damaged");
  }
}

}  // namespace certet
