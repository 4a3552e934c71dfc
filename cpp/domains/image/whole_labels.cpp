// Labels that are kept as floating point numbers, and gray values that are not labels.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <type_traits>
#include <utility>
#include <unordered_map>

#include "certet/error.hpp"
#include "certet/image.hpp"
#include "voxel_place.hpp"

namespace certet {
namespace {

/// Voxels of a kind that are no labels.
struct Misfits {
  std::uint64_t count = 0, first = 0;
  void add(std::uint64_t at) {
    if (count++ == 0) first = at;
  }
};

std::string nine_digits(double value) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.9g", value);
  return digits;
}

[[noreturn]] void refuse_misfits(const Image& image, const Misfits& misfits,
                                 const std::string& what, const std::string& advice,
                                 ErrorCode code = ErrorCode::bad_input) {
  const bool one = misfits.count == 1;
  throw Error(code,
              "'" + image.name + "' has " + std::to_string(misfits.count) +
                  (one ? " voxel that is " : " voxels that are ") + what +
                  (one ? ", at " : ", the first at ") + voxel_place(image, misfits.first) + advice);
}

bool is_label(double value) {
  return value == std::floor(value) && std::fabs(value) <= 2147483647;
}

template <class T>
Buffer<std::int32_t> whole(const Image& image, const Buffer<T>& voxels,
                           std::optional<std::int32_t> nan) {
  Misfits nans, infinite, fractions, wide;
  Buffer<std::int32_t> labels(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const double value = voxels[i];
    labels[i] = nan.value_or(0);
    if (is_label(value)) labels[i] = static_cast<std::int32_t>(value);
    else if (std::isinf(value)) infinite.add(i);
    else if (!std::isnan(value)) (value == std::floor(value) ? wide : fractions).add(i);
    else if (!nan) nans.add(i);
  }
  if (fractions.count != 0)
    refuse_misfits(image, fractions, "no labels, for they are not whole numbers",
                   " (" + nine_digits(voxels[fractions.first]) + "): choose a level with --iso",
           ErrorCode::bad_option);
  if (nans.count != 0)
    refuse_misfits(image, nans, "NaN", ": --nan N reads them as label N, --nan 0 as outside");
  if (infinite.count != 0) refuse_misfits(image, infinite, "infinite, which no label is", "");
  if (wide.count != 0)
    refuse_misfits(image, wide, "labels that do not fit 32 bits with a sign", "");
  return labels;
}

/// Voxels of a value, and their runs along the first axis.
struct Shade {
  std::uint64_t voxels = 0, runs = 0;
};

template <class T>
std::unordered_map<std::int64_t, Shade> shades(const Image& image, const Buffer<T>& voxels) {
  std::unordered_map<std::int64_t, Shade> found;
  const auto row = static_cast<std::size_t>(image.size[0]);
  for (std::size_t begin = 0; begin < voxels.size(); begin += row)
    for (std::size_t x = begin; x < begin + row;) {
      std::size_t end = x + 1;
      while (end < begin + row && voxels[end] == voxels[x]) ++end;
      Shade& shade = found[static_cast<std::int64_t>(voxels[x])];
      shade.voxels += end - x;
      ++shade.runs;
      x = end;
    }
  return found;
}

/// In atlases of the brain runs have 3.4 to 14 voxels, in scans 1.0 to 1.3.
bool look_grayscale(const std::unordered_map<std::int64_t, Shade>& found) {
  if (found.size() <= 50) return false;
  const auto commonest = std::ranges::max_element(
      found, {}, [](const auto& entry) { return entry.second.voxels; });
  Shade others;
  for (const auto& [value, shade] : found)
    if (value != commonest->first && value != 0) {
      others.voxels += shade.voxels;
      others.runs += shade.runs;
    }
  const auto mean = static_cast<double>(others.voxels) / static_cast<double>(others.runs);
  return mean < (found.size() > 1000 ? 5 : 2.5);
}

}  // namespace

Image with_labels(Image image, std::optional<std::int32_t> nan) {
  if (image.integral()) return image;
  image.voxels = std::visit(
      [&]<class T>(const Buffer<T>& voxels) -> Voxels {
        if constexpr (std::is_floating_point_v<T>) return whole(image, voxels, nan);
        else return Voxels{};
      },
      image.voxels);
  return image;
}

std::uint64_t replace_nan(Image& image, double value) {
  return std::visit(
      [&]<class T>(Buffer<T>& voxels) -> std::uint64_t {
        std::uint64_t count = 0;
        if constexpr (std::is_floating_point_v<T>)
          for (T& voxel : voxels)
            if (std::isnan(voxel)) {
              voxel = static_cast<T>(value);
              ++count;
            }
        return count;
      },
      image.voxels);
}

bool looks_grayscale(const Image& image) {
  return std::visit(
      [&]<class T>(const Buffer<T>& voxels) {
        if constexpr (std::is_integral_v<T>) return look_grayscale(shades(image, voxels));
        else return false;
      },
      image.voxels);
}

}  // namespace certet
