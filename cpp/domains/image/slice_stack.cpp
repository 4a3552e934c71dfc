#include "slice_stack.hpp"

#include <algorithm>
#include <cmath>

#include "geometry.hpp"
#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// The distance of most neighbours.
double usual_gap(const std::vector<Slice>& slices) {
  std::vector<double> gaps;
  for (std::size_t k = 1; k < slices.size(); ++k)
    gaps.push_back(slices[k].along - slices[k - 1].along);
  const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
  std::nth_element(gaps.begin(), middle, gaps.end());
  return *middle;
}

/// Positions are decimal numbers: what projecting them adds is not to be seen.
double rounded(double length) {
  const double unit = std::pow(10, std::floor(std::log10(length)) - 9);
  return std::round(length / unit) * unit;
}

}  // namespace

bool is_near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

void sort_slices(const fs::path& input, std::vector<Slice>& slices, const SliceForm& form) {
  for (Slice& slice : slices) {
    slice.along = dot(slice.origin, form.axes[2]);
    if (!std::isfinite(slice.along))
      refuse(input, "has a slice that lies nowhere: the position of " + slice.name +
                        " is not finite");
  }
  std::sort(slices.begin(), slices.end(), [](const Slice& a, const Slice& b) {
    return a.along != b.along ? a.along < b.along : a.number < b.number;
  });
}

void check_straight(const fs::path& input, const std::vector<Slice>& slices,
                    const SliceForm& form) {
  for (const Slice& slice : slices)
    for (std::size_t a = 0; a < 2; ++a) {
      const double aside =
          dot(slice.origin, form.axes[a]) - dot(slices.front().origin, form.axes[a]);
      if (!is_near(aside, 0, 0.1 * form.spacing[a]))
        refuse(input, "has slices that do not lie straight above each other (a tilted "
                      "gantry): " + slice.name + " is " + std::to_string(aside) + " aside");
    }
}

/// Positions are rounded when they are written, so a tenth of a gap is let pass.
double slice_distance(const fs::path& input, const std::vector<Slice>& slices) {
  const double usual = usual_gap(slices);
  for (std::size_t k = 1; k < slices.size(); ++k) {
    const double gap = slices[k].along - slices[k - 1].along;
    const std::string where = slices[k - 1].name + " and " + slices[k].name;
    if (!(gap > 1e-4 * usual) || !(gap > 0))
      refuse(input, "has two slices at one position, " + where);
    if (is_near(gap, usual, 0.1 * usual)) continue;
    if (gap > 1.5 * usual)
      refuse(input, "has a gap of " + std::to_string(gap) + " between " + where +
                        ", where slices are " + std::to_string(usual) +
                        " apart: slices are missing");
    refuse(input, "has slices that are not equally spaced: " + std::to_string(gap) +
                      " between " + where + ", elsewhere " + std::to_string(usual));
  }
  return rounded((slices.back().along - slices.front().along) /
                 static_cast<double>(slices.size() - 1));
}

Image slice_grid(const fs::path& input, const SliceForm& form, const Point3& origin,
                 std::size_t count, double distance) {
  Image image;
  image.name = input.string();
  image.size = {form.size[0], form.size[1], static_cast<std::int64_t>(count)};
  image.spacing = {form.spacing[0], form.spacing[1], distance};
  image.origin = origin;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t a = 0; a < 3; ++a) image.axes[r][a] = form.axes[a][r];
  check_geometry(image);
  orthonormalise(image);
  return image;
}

}  // namespace certet
