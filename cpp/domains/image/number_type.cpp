#include "number_type.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;
using Fill = std::function<void(char*)>;

template <class T>
Buffer<T> load(std::uint64_t count, const Fill& fill) {
  Buffer<T> voxels(count);
  fill(reinterpret_cast<char*>(voxels.data()));
  return voxels;
}

template <class T>
Buffer<std::int32_t> load_narrow(const fs::path& file, std::uint64_t count, const Fill& fill) {
  const Buffer<T> wide = load<T>(count, fill);
  Buffer<std::int32_t> voxels(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::in_range<std::int32_t>(wide[i]))
      refuse(file, "has label " + std::to_string(wide[i]) +
                       ", which does not fit 32 bits with a sign");
    voxels[i] = static_cast<std::int32_t>(wide[i]);
  }
  return voxels;
}

/// Whether slope * v + intercept is a whole number of 32 bits for every v of a type.
template <class T>
bool stays_whole(double slope, double intercept) {
  if constexpr (!std::is_integral_v<T>) return false;
  if (slope != std::floor(slope) || intercept != std::floor(intercept)) return false;
  const auto fits = [&](double v) { return std::fabs(slope * v + intercept) < 2147483647; };
  return fits(static_cast<double>(std::numeric_limits<T>::lowest())) &&
         fits(static_cast<double>(std::numeric_limits<T>::max()));
}

template <class To, class From>
Buffer<To> line(const Buffer<From>& from, double slope, double intercept) {
  Buffer<To> to(from.size());
  std::ranges::transform(from, to.begin(), [=](From v) {
    return static_cast<To>(slope * static_cast<double>(v) + intercept);
  });
  return to;
}

}  // namespace

std::size_t bytes_of(NumberType type) {
  switch (type) {
    case NumberType::u8: case NumberType::i8: return 1;
    case NumberType::u16: case NumberType::i16: return 2;
    case NumberType::u32: case NumberType::i32: case NumberType::f32: return 4;
    case NumberType::u64: case NumberType::i64: case NumberType::f64: break;
  }
  return 8;
}

Voxels load_voxels(const fs::path& file, NumberType type, std::uint64_t count,
                   const Fill& fill) {
  switch (type) {
    case NumberType::u8: return load<std::uint8_t>(count, fill);
    case NumberType::i8: return load<std::int8_t>(count, fill);
    case NumberType::u16: return load<std::uint16_t>(count, fill);
    case NumberType::i16: return load<std::int16_t>(count, fill);
    case NumberType::u32: return load<std::uint32_t>(count, fill);
    case NumberType::i32: return load<std::int32_t>(count, fill);
    case NumberType::u64: return load_narrow<std::uint64_t>(file, count, fill);
    case NumberType::i64: return load_narrow<std::int64_t>(file, count, fill);
    case NumberType::f32: return load<float>(count, fill);
    case NumberType::f64: break;
  }
  return load<double>(count, fill);
}

void swap_bytes(char* numbers, std::uint64_t count, std::size_t bytes_of_one) {
  for (std::uint64_t i = 0; i < count; ++i, numbers += bytes_of_one)
    std::reverse(numbers, numbers + bytes_of_one);
}

Voxels rescaled(const Voxels& voxels, double slope, double intercept) {
  return std::visit(
      [&]<class T>(const Buffer<T>& from) -> Voxels {
        if (stays_whole<T>(slope, intercept)) return line<std::int32_t>(from, slope, intercept);
        return line<double>(from, slope, intercept);
      },
      voxels);
}

Voxels every(const Voxels& all, std::uint64_t first, std::uint64_t step, std::uint64_t count) {
  return std::visit(
      [&]<class T>(const Buffer<T>& from) -> Voxels {
        Buffer<T> to(count);
        for (std::uint64_t i = 0; i < count; ++i) to[i] = from[first + step * i];
        return to;
      },
      all);
}

}  // namespace certet
