#include "itk_header.hpp"

#include <limits>

#include "geometry.hpp"
#include "image_file.hpp"
#include "volumes.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

NumberType whole(bool has_sign, std::size_t bytes) {
  switch (bytes) {
    case 1: return has_sign ? NumberType::i8 : NumberType::u8;
    case 2: return has_sign ? NumberType::i16 : NumberType::u16;
    case 4: return has_sign ? NumberType::i32 : NumberType::u32;
    default: return has_sign ? NumberType::i64 : NumberType::u64;
  }
}

}  // namespace

NumberType number_type(const fs::path& file, itk::IOComponentEnum type) {
  switch (type) {
    case itk::IOComponentEnum::UCHAR: return whole(false, 1);
    case itk::IOComponentEnum::CHAR: return whole(true, 1);
    case itk::IOComponentEnum::USHORT: return whole(false, sizeof(unsigned short));
    case itk::IOComponentEnum::SHORT: return whole(true, sizeof(short));
    case itk::IOComponentEnum::UINT: return whole(false, sizeof(unsigned));
    case itk::IOComponentEnum::INT: return whole(true, sizeof(int));
    case itk::IOComponentEnum::ULONG: return whole(false, sizeof(unsigned long));
    case itk::IOComponentEnum::LONG: return whole(true, sizeof(long));
    case itk::IOComponentEnum::ULONGLONG: return whole(false, sizeof(unsigned long long));
    case itk::IOComponentEnum::LONGLONG: return whole(true, sizeof(long long));
    case itk::IOComponentEnum::FLOAT: return NumberType::f32;
    case itk::IOComponentEnum::DOUBLE: return NumberType::f64;
    default: refuse(file, "has voxels of a type that is not supported");
  }
}

GridForm form_of(const fs::path& file, const itk::ImageIOBase& header) {
  const unsigned dimensions = header.GetNumberOfDimensions();
  if (dimensions < 3)
    refuse(file, "has " + std::to_string(dimensions) + " dimensions, not 3");
  GridForm form;
  form.type = number_type(file, header.GetComponentType());
  form.components = header.GetNumberOfComponents();
  for (unsigned a = 0; a < 3; ++a) {
    if (header.GetDimensions(a) > std::uint64_t{1} << 31) refuse(file, "has impossible dimensions");
    form.size[a] = static_cast<std::int64_t>(header.GetDimensions(a));
  }
  form.voxels = check_count(file, form.size, bytes_of(form.type));
  const std::uint64_t most = std::numeric_limits<std::int64_t>::max() / 16 / form.voxels;
  if (form.components < 1 || form.components > most) refuse(file, "has impossible dimensions");
  for (unsigned d = 3; d < dimensions; ++d) {
    const std::uint64_t along = header.GetDimensions(d);
    if (along < 1) refuse(file, "has no voxels");
    if (along > most / form.components / form.volumes) refuse(file, "has impossible dimensions");
    form.volumes *= along;
  }
  return form;
}

void read_geometry(const itk::ImageIOBase& header, Image& image) {
  for (unsigned a = 0; a < 3; ++a) {
    image.size[a] = static_cast<std::int64_t>(header.GetDimensions(a));
    image.spacing[a] = header.GetSpacing(a);
    image.origin[a] = header.GetOrigin(a);
    const std::vector<double> direction = header.GetDirection(a);
    for (std::size_t r = 0; r < 3; ++r) image.axes[r][a] = direction[r];
  }
  check_geometry(image);
  orthonormalise(image);
}

std::uint64_t choose_volume(const fs::path& file, const GridForm& form,
                            const ImageChoice& choice) {
  if (form.components > 1 && form.volumes > 1)
    refuse(file, "has " + std::to_string(form.volumes) + " volumes with " +
                     std::to_string(form.components) + " numbers per voxel, which is not supported");
  if (form.components > 1)
    return chosen_volume(file, form.components,
                         std::to_string(form.components) + " numbers per voxel, not 1",
                         choice.volume);
  return chosen_volume(file, form.volumes,
                       std::to_string(form.volumes) + " volumes (4 dimensions, not 3)",
                       choice.volume);
}

Voxels load_volume(const fs::path& file, const GridForm& form, std::uint64_t volume,
                   const std::function<void(char*)>& fill) {
  Voxels all = load_voxels(file, form.type, form.numbers(), fill);
  if (form.components > 1) return every(all, volume, form.components, form.voxels);
  return form.volumes > 1 ? every(all, volume * form.voxels, 1, form.voxels) : std::move(all);
}

}  // namespace certet
