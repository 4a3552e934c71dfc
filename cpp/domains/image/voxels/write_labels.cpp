// Label images to files, through ITK.

#include <itkImageIOBase.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>
#include <unistd.h>

#include <algorithm>
#include <limits>
#include <string>
#include <system_error>
#include <type_traits>
#include <variant>

#include "certet/error.hpp"
#include "certet/voxelise.hpp"
#include "label_set.hpp"
#include "labels_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_output(const fs::path& file, const std::string& reason) {
  throw Error(ErrorCode::write_failed, "'" + file.string() + "' cannot be written: " + reason);
}

itk::ImageIOBase::Pointer writer_of(const fs::path& file) {
  switch (labels_file_kind(file)) {
    case LabelsFile::nrrd: return itk::NrrdImageIO::New().GetPointer();
    case LabelsFile::meta: return itk::MetaImageIO::New().GetPointer();
    default: return itk::NiftiImageIO::New().GetPointer();
  }
}

template <class T>
constexpr itk::IOComponentEnum component() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return itk::IOComponentEnum::UCHAR;
  if constexpr (std::is_same_v<T, std::int16_t>) return itk::IOComponentEnum::SHORT;
  return itk::IOComponentEnum::INT;
}

template <class T>
Voxels narrowed_to(const Buffer<std::int32_t>& labels) {
  Buffer<T> result(labels.size());
  std::ranges::transform(labels, result.begin(), [](std::int32_t l) { return static_cast<T>(l); });
  return result;
}

/// In the narrowest type that holds them all.
Voxels narrowed(const Buffer<std::int32_t>& labels) {
  const auto [least, greatest] = std::minmax_element(labels.begin(), labels.end());
  const auto fit = [least = *least, greatest = *greatest]<class T>(T) {
    return std::in_range<T>(least) && std::in_range<T>(greatest);
  };
  if (fit(std::uint8_t{})) return narrowed_to<std::uint8_t>(labels);
  if (fit(std::int16_t{})) return narrowed_to<std::int16_t>(labels);
  return narrowed_to<std::int32_t>(labels);
}

Buffer<std::int32_t> labels_of(const Image& image) {
  return std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        if constexpr (std::is_floating_point_v<T>)
          refuse_levels(image);
        else
          refuse_wide_labels(image, voxels, LabelSet({{0, std::int64_t{1} << 32}}));
        Buffer<std::int32_t> labels(voxels.size());
        std::ranges::transform(voxels, labels.begin(),
                               [](T voxel) { return static_cast<std::int32_t>(voxel); });
        return labels;
      },
      image.voxels);
}

/// Where the voxels lie, for ITK: LPS, as it is here.
void place(itk::ImageIOBase& writer, const Image& image) {
  writer.SetNumberOfDimensions(3);
  for (unsigned a = 0; a < 3; ++a) {
    writer.SetDimensions(a, static_cast<itk::SizeValueType>(image.size[a]));
    writer.SetSpacing(a, image.spacing[a]);
    writer.SetOrigin(a, image.origin[a]);
    writer.SetDirection(a, {image.axes[0][a], image.axes[1][a], image.axes[2][a]});
  }
}

void write_to(const fs::path& file, const Image& image, const Voxels& narrow) {
  const itk::ImageIOBase::Pointer writer = writer_of(file);
  place(*writer, image);
  writer->SetNumberOfComponents(1);
  writer->SetPixelType(itk::IOPixelEnum::SCALAR);
  writer->SetFileName(file.string());
  itk::ImageIORegion region(3);
  for (unsigned a = 0; a < 3; ++a) region.SetSize(a, static_cast<itk::SizeValueType>(image.size[a]));
  writer->SetIORegion(region);
  writer->SetUseCompression(labels_file_kind(file) != LabelsFile::nifti);
  std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        writer->SetComponentType(component<T>());
        writer->WriteImageInformation();
        writer->Write(voxels.data());
      },
      narrow);
}

/// Not every write that fails is told by ITK.
bool reads_back(const fs::path& file, const Image& image, const Voxels& narrow) {
  const Image found = read_image(file);
  return found.size == image.size && std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        const auto* const same = std::get_if<Buffer<T>>(&found.voxels);
        return same != nullptr && std::equal(voxels.begin(), voxels.end(), same->begin(), same->end());
      },
      narrow);
}

/// A file that goes again unless it is kept.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& target)
      : file_(target.parent_path() / (".part" + std::to_string(getpid()) + "-" +
                                      target.filename().string())) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    std::error_code failure;
    fs::remove(file_, failure);
  }
  [[nodiscard]] const fs::path& name() const { return file_; }

 private:
  fs::path file_;
};

}  // namespace

void write_labels(const Image& image, const fs::path& file) {
  check_labels_file(file);
  const Voxels narrow = narrowed(labels_of(image));
  std::error_code failure;
  const fs::path target = fs::is_symlink(file, failure) ? fs::canonical(file, failure) : file;
  const TemporaryFile temporary(target);
  bool written = false;
  try {
    write_to(temporary.name(), image, narrow);
    written = reads_back(temporary.name(), image, narrow);
  } catch (const itk::ExceptionObject&) {
    written = false;
  } catch (const Error&) {  // of reading
    written = false;
  }
  if (!written) refuse_output(file, "the disk may be full");
  fs::rename(temporary.name(), target, failure);
  if (failure) refuse_output(file, failure.message());
}

}  // namespace certet
