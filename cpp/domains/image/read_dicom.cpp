// A folder of DICOM slices as one image.  Each slice is read by ITK's reader; that
// the slices make a regular grid is checked here.

#include <gdcmImageHelper.h>
#include <itkGDCMImageIO.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "dicom_header.hpp"
#include "dicom_series.hpp"
#include "image_file.hpp"
#include "itk_header.hpp"
#include "slice_stack.hpp"
#include "volumes.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Reader = itk::GDCMImageIO;

/// Of one slice.
struct OneForm {
  SliceForm form;
  double thickness = 0;
  NumberType type{};            ///< of the values
  std::uint64_t bits = 0, is_signed = 0;  ///< of what is stored
  std::uint64_t voxels = 0;
};

std::string quoted(const fs::path& file) {
  std::string text = "'";
  text += file.filename().string();
  return text + '\'';
}

Reader::Pointer open(const fs::path& file) {
  const auto reader = Reader::New();
  reader->SetFileName(file.string());
  reader->ReadImageInformation();
  return reader;
}

/// Before ITK's reader sees it.
void check_single(const fs::path& file) {
  const auto header = read_dicom_header(file);
  if (!header || header->holds_frames())
    refuse(file, "is DICOM with several frames in one file, among other files of its series; "
                 "give that file alone");
  if (header->samples == 1 && !header->is_gray())
    refuse(file, "has colours for voxels ('" + header->photometric + "'), not 1 number each");
}

/// \throws Error for what is not one number per voxel.
OneForm form_of_slice(const fs::path& file, const Reader& header) {
  if (header.GetNumberOfComponents() != 1)
    refuse(file, "has " + std::to_string(header.GetNumberOfComponents()) +
                     " numbers per voxel, not 1");
  OneForm one;
  one.type = number_type(file, header.GetComponentType());
  one.voxels = 1;
  for (unsigned a = 0; a < 2; ++a) {
    one.form.size[a] = static_cast<std::int64_t>(header.GetDimensions(a));
    one.form.spacing[a] = header.GetSpacing(a);
    one.voxels *= header.GetDimensions(a);
  }
  one.thickness = header.GetSpacing(2);
  if (one.voxels == 0) refuse(file, "has no voxels");
  for (unsigned a = 0; a < 3; ++a) {
    const std::vector<double> direction = header.GetDirection(a);
    std::copy_n(direction.begin(), 3, one.form.axes[a].begin());
  }
  if (const auto own = read_dicom_header(file)) {
    one.bits = own->bits;
    one.is_signed = own->is_signed;
  }
  return one;
}

void check_same(const fs::path& file, const OneForm& one, const OneForm& first) {
  if (one.form.size != first.form.size)
    refuse(file, "has not the size of the series' other slices");
  if (one.bits != first.bits || one.is_signed != first.is_signed)
    refuse(file, "has voxels of another type than the series' other slices");
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t r = 0; r < 3; ++r)
      if (!is_near(one.form.axes[a][r], first.form.axes[a][r], 1e-3))
        refuse(file, "lies in another direction than the series' other slices");
  for (std::size_t a = 0; a < 2; ++a)
    if (!is_near(one.form.spacing[a], first.form.spacing[a], 1e-3 * first.form.spacing[a]))
      refuse(file, "has other spacings than the series' other slices");
}

/// A series, its slices in the order of their positions.
struct Stack {
  std::vector<fs::path> files;    ///< by `Slice::number`
  std::vector<NumberType> types;  ///< of the values of each file
  std::vector<Slice> slices;
  OneForm form;  ///< that of the first file

  /// Slices that are rescaled each by its own slope may have values of several types.
  [[nodiscard]] bool one_type() const {
    return std::ranges::all_of(types, [&](NumberType type) { return type == types[0]; });
  }
};

Stack read_headers(const fs::path& folder, const std::vector<fs::path>& files) {
  Stack stack;
  stack.files = files;
  for (const fs::path& file : files) {
    check_single(file);
    const auto header = open(file);
    const OneForm own = form_of_slice(file, *header);
    if (stack.slices.empty()) stack.form = own;
    check_same(file, own, stack.form);
    stack.types.push_back(own.type);
    stack.slices.push_back(
        {quoted(file), stack.slices.size(),
         {header->GetOrigin(0), header->GetOrigin(1), header->GetOrigin(2)}});
  }
  sort_slices(folder, stack.slices, stack.form.form);
  return stack;
}

Image grid(const fs::path& folder, const Stack& stack) {
  const bool single = stack.slices.size() == 1;
  const double distance =
      single ? stack.form.thickness : slice_distance(folder, stack.slices);
  check_straight(folder, stack.slices, stack.form.form);
  Image image = slice_grid(folder, stack.form.form, stack.slices.front().origin,
                           stack.slices.size(), distance);
  if (single)
    image.notes.push_back("the series is a single slice, as thick as its header says");
  return image;
}

void fill_slice(const fs::path& file, NumberType type, std::uint64_t voxels, char* to) {
  const auto reader = open(file);
  itk::ImageIORegion region(reader->GetNumberOfDimensions());
  for (unsigned d = 0; d < reader->GetNumberOfDimensions(); ++d)
    region.SetSize(d, reader->GetDimensions(d));
  reader->SetIORegion(region);
  // Its header is read again; the file may have changed meanwhile.
  const OneForm own = form_of_slice(file, *reader);
  if (own.voxels != voxels || own.type != type) refuse(file, "has changed");
  std::fill_n(to, voxels * bytes_of(type), '\0');
  try {
    reader->Read(to);
  } catch (const itk::ExceptionObject&) {
    refuse(file, "is truncated or damaged");
  }
}

Voxels load_same(const fs::path& folder, const Stack& stack) {
  const std::uint64_t voxels = stack.form.voxels;
  return load_voxels(folder, stack.types[0], voxels * stack.slices.size(), [&](char* to) {
    for (const Slice& slice : stack.slices) {
      fill_slice(stack.files[slice.number], stack.types[0], voxels, to);
      to += voxels * bytes_of(stack.types[0]);
    }
  });
}

Voxels load_mixed(const Stack& stack) {
  const std::uint64_t voxels = stack.form.voxels;
  Buffer<double> all(voxels * stack.slices.size());
  double* to = all.begin();
  for (const Slice& slice : stack.slices) {
    const fs::path& file = stack.files[slice.number];
    const NumberType type = stack.types[slice.number];
    const Voxels one = load_voxels(file, type, voxels, [&](char* raw) {
      fill_slice(file, type, voxels, raw);
    });
    to = std::visit([&](const auto& from) {
      return std::ranges::transform(from, to, [](auto v) { return static_cast<double>(v); }).out;
    }, one);
  }
  return all;
}

Image read_slices(const fs::path& folder, const std::vector<fs::path>& files,
                  std::uint64_t max_bytes, const ImageChoice& choice) {
  chosen_volume(folder, 1, "", choice.volume);
  const Stack stack = read_headers(folder, files);
  const std::size_t bytes = stack.one_type() ? bytes_of(stack.types[0]) : sizeof(double);
  const auto count = static_cast<std::int64_t>(files.size());
  const auto& size = stack.form.form.size;
  check_memory(folder, check_count(folder, {size[0], size[1], count}, bytes) * bytes, max_bytes);
  Image image = grid(folder, stack);
  image.voxels = stack.one_type() ? load_same(folder, stack) : load_mixed(stack);
  return image;
}

}  // namespace

Image read_dicom(const fs::path& folder, std::uint64_t max_bytes, const ImageChoice& choice) {
  // Slope and intercept count wherever they are written, in images of MR too.
  gdcm::ImageHelper::SetForceRescaleInterceptSlope(true);
  const std::vector<fs::path> files = series_files(folder, choice.series);
  if (files.size() == 1)
    if (const auto header = read_dicom_header(files[0]); header && header->holds_frames())
      return read_dicom_frames(files[0], max_bytes, choice);
  return read_slices(folder, files, max_bytes, choice);
}

Image read_dicom_file(const fs::path& file, std::uint64_t max_bytes, const ImageChoice& choice) {
  const auto header = read_dicom_header(file);
  if (!header || !header->holds_voxels()) refuse_dicom(file);
  if (!choice.series.empty() && header->series != choice.series)
    throw Error(ErrorCode::bad_option,
                "'" + file.string() + "' holds no DICOM series '" + choice.series + "'");
  if (header->rows == 0) refuse(file, "is DICOM without an image");
  if (!header->holds_frames())
    refuse(file, "is one file of DICOM; give the folder that holds its series");
  return read_dicom_frames(file, max_bytes, choice);
}

}  // namespace certet
