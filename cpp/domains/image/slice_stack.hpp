#pragma once
/// \file
/// Slices that lie anywhere, as one regular grid: checked by their positions alone.

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "certet/image.hpp"

namespace certet {

/// Where a slice lies.
struct Slice {
  std::string name;  ///< for sentences
  std::size_t number = 0;  ///< its place in the input
  Point3 origin{};
  double along = 0;  ///< of the origin, along the normal
};

/// What all slices share.
struct SliceForm {
  std::array<std::int64_t, 2> size{};
  std::array<double, 2> spacing{};  ///< in the slice, along its rows and columns
  std::array<Point3, 3> axes{};     ///< directions of rows, columns and normal
};

/// Sets `along`, and sorts by it; where that is equal, by `number`.
/// \throws Error `bad_input` for a position that is not finite.
void sort_slices(const std::filesystem::path& input, std::vector<Slice>& slices,
                 const SliceForm& form);

/// \throws Error `bad_input` where slices slide sideways, as those of a tilted gantry do.
void check_straight(const std::filesystem::path& input, const std::vector<Slice>& slices,
                    const SliceForm& form);

/// The distance of neighbours; there are at least two slices.
/// \throws Error `bad_input` where it is not the same everywhere.
double slice_distance(const std::filesystem::path& input, const std::vector<Slice>& slices);

/// Size, spacing, origin and axes of a grid of `count` slices, checked.
Image slice_grid(const std::filesystem::path& input, const SliceForm& form, const Point3& origin,
                 std::size_t count, double distance);

bool is_near(double a, double b, double tolerance);

}  // namespace certet
