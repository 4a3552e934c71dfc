// The only translation unit that includes ITK.

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

namespace certet {
namespace {

namespace fs = std::filesystem;
using Reader = itk::ImageIOBase;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
  throw Error(ErrorCode::bad_input, "'" + file.string() + "' " + reason);
}

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
  refuse(file, "is not a NIfTI, NRRD or MetaImage file");
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
  if (bytes > max_bytes)
    throw Error(ErrorCode::too_large, "the voxels of '" + file.string() + "' need " +
                                          std::to_string(bytes) +
                                          " bytes, more than the " +
                                          std::to_string(max_bytes) + " allowed");
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

template <class T>
Buffer<T> load(Reader& reader, std::uint64_t bytes) {
  Buffer<T> voxels(bytes / sizeof(T));
  reader.Read(voxels.data());
  return voxels;
}

/// 64-bit labels are kept where they fit 32 bits.
template <class T>
Buffer<std::int32_t> load_narrow(const fs::path& file, Reader& reader, std::uint64_t bytes) {
  const Buffer<T> wide = load<T>(reader, bytes);
  Buffer<std::int32_t> voxels(wide.size());
  for (std::size_t i = 0; i < wide.size(); ++i) {
    if (!std::in_range<std::int32_t>(wide[i]))
      refuse(file, "has label " + std::to_string(wide[i]) +
                       ", which does not fit 32 bits with a sign");
    voxels[i] = static_cast<std::int32_t>(wide[i]);
  }
  return voxels;
}

template <class T>
Voxels load_whole(const fs::path& file, Reader& reader, std::uint64_t bytes) {
  if constexpr (sizeof(T) > 4)
    return load_narrow<T>(file, reader, bytes);
  else if constexpr (std::is_signed_v<T>)
    return load<std::conditional_t<sizeof(T) == 1, std::int8_t,
                std::conditional_t<sizeof(T) == 2, std::int16_t, std::int32_t>>>(reader, bytes);
  else
    return load<std::conditional_t<sizeof(T) == 1, std::uint8_t,
                std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint32_t>>>(reader, bytes);
}

Voxels load_voxels(const fs::path& file, Reader& reader, std::uint64_t bytes) {
  switch (reader.GetComponentType()) {
    case itk::IOComponentEnum::UCHAR: return load_whole<unsigned char>(file, reader, bytes);
    case itk::IOComponentEnum::CHAR: return load_whole<signed char>(file, reader, bytes);
    case itk::IOComponentEnum::USHORT: return load_whole<unsigned short>(file, reader, bytes);
    case itk::IOComponentEnum::SHORT: return load_whole<short>(file, reader, bytes);
    case itk::IOComponentEnum::UINT: return load_whole<unsigned>(file, reader, bytes);
    case itk::IOComponentEnum::INT: return load_whole<int>(file, reader, bytes);
    case itk::IOComponentEnum::ULONG: return load_whole<unsigned long>(file, reader, bytes);
    case itk::IOComponentEnum::LONG: return load_whole<long>(file, reader, bytes);
    case itk::IOComponentEnum::ULONGLONG:
      return load_whole<unsigned long long>(file, reader, bytes);
    case itk::IOComponentEnum::LONGLONG: return load_whole<long long>(file, reader, bytes);
    case itk::IOComponentEnum::FLOAT: return load<float>(reader, bytes);
    case itk::IOComponentEnum::DOUBLE: return load<double>(reader, bytes);
    default: refuse(file, "has voxels of a type that is not supported");
  }
}

Image read(const fs::path& file, std::uint64_t max_bytes) {
  itk::Object::SetGlobalWarningDisplay(false);
  const Reader::Pointer reader = reader_for(file);
  reader->ReadImageInformation();
  judge_shape(file, *reader);
  const std::uint64_t bytes = judge_bytes(file, *reader, max_bytes);
  // At the same time as the voxels are read, for unpacking is what takes long.
  auto complete = std::async(std::launch::async, is_complete, file, bytes);
  Image image;
  image.name = file.string();
  read_geometry(*reader, image);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned d = 0; d < reader->GetNumberOfDimensions(); ++d)
    region.SetSize(d, reader->GetDimensions(d));
  reader->SetIORegion(region);
  image.voxels = load_voxels(file, *reader, bytes);
  if (!complete.get()) refuse(file, "is truncated or damaged");
  return image;
}

}  // namespace

bool can_read_images() { return true; }

Image read_image(const fs::path& file, std::uint64_t max_bytes) {
  std::error_code failure;
  if (!fs::exists(file, failure)) refuse(file, "does not exist");
  if (!fs::is_regular_file(file, failure)) refuse(file, "is not a regular file");
  try {
    return read(file, max_bytes);
  } catch (const itk::ExceptionObject&) {
    // ITK's own text has many lines, source files and addresses.
    refuse(file, "is truncated or damaged");
  }
}

}  // namespace certet
