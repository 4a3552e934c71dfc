#include "itk_voxels.hpp"

#include <type_traits>
#include <utility>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Fill = std::function<void(void*)>;

template <class T>
Buffer<T> load(std::uint64_t bytes, const Fill& fill) {
  Buffer<T> voxels(bytes / sizeof(T));
  fill(voxels.data());
  return voxels;
}

template <class T>
Buffer<std::int32_t> load_narrow(const fs::path& file, std::uint64_t bytes, const Fill& fill) {
  const Buffer<T> wide = load<T>(bytes, fill);
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
Voxels load_whole(const fs::path& file, std::uint64_t bytes, const Fill& fill) {
  if constexpr (sizeof(T) > 4)
    return load_narrow<T>(file, bytes, fill);
  else if constexpr (std::is_signed_v<T>)
    return load<std::conditional_t<sizeof(T) == 1, std::int8_t,
                std::conditional_t<sizeof(T) == 2, std::int16_t, std::int32_t>>>(bytes, fill);
  else
    return load<std::conditional_t<sizeof(T) == 1, std::uint8_t,
                std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint32_t>>>(bytes, fill);
}

}  // namespace

Voxels load_voxels(const fs::path& file, itk::IOComponentEnum type, std::uint64_t bytes,
                   const Fill& fill) {
  switch (type) {
    case itk::IOComponentEnum::UCHAR: return load_whole<unsigned char>(file, bytes, fill);
    case itk::IOComponentEnum::CHAR: return load_whole<signed char>(file, bytes, fill);
    case itk::IOComponentEnum::USHORT: return load_whole<unsigned short>(file, bytes, fill);
    case itk::IOComponentEnum::SHORT: return load_whole<short>(file, bytes, fill);
    case itk::IOComponentEnum::UINT: return load_whole<unsigned>(file, bytes, fill);
    case itk::IOComponentEnum::INT: return load_whole<int>(file, bytes, fill);
    case itk::IOComponentEnum::ULONG: return load_whole<unsigned long>(file, bytes, fill);
    case itk::IOComponentEnum::LONG: return load_whole<long>(file, bytes, fill);
    case itk::IOComponentEnum::ULONGLONG:
      return load_whole<unsigned long long>(file, bytes, fill);
    case itk::IOComponentEnum::LONGLONG: return load_whole<long long>(file, bytes, fill);
    case itk::IOComponentEnum::FLOAT: return load<float>(bytes, fill);
    case itk::IOComponentEnum::DOUBLE: return load<double>(bytes, fill);
    default: refuse(file, "has voxels of a type that is not supported");
  }
}

}  // namespace certet
