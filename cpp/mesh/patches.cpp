#include "certet/patches.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "certet/buffer.hpp"
#include "certet/error.hpp"
#include "certet/examine.hpp"
#include "engine/parallel.hpp"

namespace certet {
namespace {

constexpr std::string_view axis_names = "xyz";

[[noreturn]] void refuse(const std::string& sentence) {
  throw Error(ErrorCode::bad_option, sentence);
}

std::string number(double value) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.begin(), text.end(), value).ptr};
}

constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool is_in_names(char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; }

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

void check_name(std::string_view name) {
  constexpr std::size_t longest = 60;
  if (name.empty() || name.size() > longest || !is_letter(name.front()) ||
      !std::ranges::all_of(name, is_in_names))
    refuse("the name of a patch is a letter and up to 59 letters, digits and underscores, not '" +
           std::string(name) + "'");
  if (std::ranges::find(patch_names, lower_case(name)) != patch_names.end())
    refuse("a patch cannot be named '" + std::string(name) + "', as others are by themselves");
}

/// "12.5" and nothing else.
bool read_number(std::string_view text, double& value) {
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end && std::isfinite(value);
}

using Triangle = std::array<Point3, 3>;

/// Whether a triangle lies at a plane, as `name_patches` says.
bool lies_at(const Triangle& corners, const PatchPlane& plane, double tolerance) {
  constexpr double least_cosine = 0.5;
  for (const Point3& corner : corners)
    if (!(std::fabs(corner[plane.axis] - plane.at) <= tolerance)) return false;
  Point3 u, v;
  for (std::size_t a = 0; a < 3; ++a) {
    u[a] = corners[1][a] - corners[0][a];
    v[a] = corners[2][a] - corners[0][a];
  }
  Point3 normal;
  for (std::size_t a = 0; a < 3; ++a)
    normal[a] = u[(a + 1) % 3] * v[(a + 2) % 3] - u[(a + 2) % 3] * v[(a + 1) % 3];
  const double square = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
  const double along = normal[plane.axis];
  return along * along >= least_cosine * least_cosine * square;
}

class NamingPatches {
 public:
  NamingPatches(Survey& survey, double size, const PlaceOf& place)
      : survey_(survey), tolerance_(size / 2), place_(place) {
    for (const BoundaryFace& face : survey.boundary) before_.push_back(face.patch);
  }

  void name(const PatchChoice& choice) {
    check_name(choice.name);
    for (const std::string& other : survey_.named_patches)
      if (lower_case(other) == lower_case(choice.name))
        refuse("two patches are named '" + choice.name + "'");
    const auto patch = static_cast<Patch>(patch_names.size() + survey_.named_patches.size());
    if (survey_.named_patches.size() > std::numeric_limits<std::uint16_t>::max() / 2)
      refuse("there are too many patches");
    survey_.named_patches.push_back(choice.name);
    const std::uint64_t taken = std::holds_alternative<Patch>(choice.where)
                                    ? take(std::get<Patch>(choice.where), patch)
                                    : take(std::get<PatchPlane>(choice.where), patch);
    if (taken == 0) refuse_empty(choice);
  }

  /// After the last: none of so many new ones may have lost all that it had.
  void finish(std::span<const PatchChoice> choices) const {
    std::vector<bool> has_faces(patch_names.size() + survey_.named_patches.size());
    for (const BoundaryFace& face : survey_.boundary)
      has_faces[static_cast<std::size_t>(face.patch)] = true;
    const std::size_t first = has_faces.size() - choices.size();
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (!has_faces[first + i])
        refuse("all triangles of the patch '" + choices[i].name + "' are in others named after it");
  }

 private:
  std::uint64_t take(Patch from, Patch patch) {
    std::uint64_t taken = 0;
    for (std::size_t i = 0; i < before_.size(); ++i)
      if (before_[i] == from) survey_.boundary[i].patch = patch, ++taken;
    return taken;
  }

  std::uint64_t take(const PatchPlane& plane, Patch patch) {
    std::uint64_t taken = 0;
    for (BoundaryFace& face : survey_.boundary) {
      const auto& [a, b, c] = face.points;
      if (lies_at({place_(a), place_(b), place_(c)}, plane, tolerance_)) face.patch = patch, ++taken;
    }
    return taken;
  }

  [[noreturn]] void refuse_empty(const PatchChoice& choice) const {
    const std::string whose = "the patch '" + choice.name + "' has no triangles: ";
    if (std::holds_alternative<Patch>(choice.where))
      refuse(whose + "the mesh has no patch '" + text_of(choice.where) + "'");
    const std::size_t axis = std::get<PatchPlane>(choice.where).axis;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const BoundaryFace& face : survey_.boundary)
      for (const std::uint64_t point : face.points) {
        low = std::min(low, place_(point)[axis]);
        high = std::max(high, place_(point)[axis]);
      }
    refuse(whose + "none of the boundary, which goes from " + axis_names[axis] + " = " +
           number(low) + " to " + number(high) + ", lies within " + number(tolerance_) + " of " +
           text_of(choice.where));
  }

  Survey& survey_;
  double tolerance_;
  const PlaceOf& place_;
  std::vector<Patch> before_;  ///< of each face of the boundary
};

/// The points that faces of the boundary have, each once.
std::vector<std::uint64_t> points_of(const Survey& survey) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(3 * survey.boundary.size());
  for (const BoundaryFace& face : survey.boundary)
    numbers.insert(numbers.end(), face.points.begin(), face.points.end());
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  numbers.shrink_to_fit();
  return numbers;
}

}  // namespace

PatchChoice patch_choice(std::string_view name, std::string_view where) {
  check_name(name);
  const auto known = std::ranges::find(patch_names, where);
  if (known != patch_names.end())
    return {std::string(name), static_cast<Patch>(known - patch_names.begin())};
  PatchPlane plane;
  if (where.size() > 2 && where[1] == ':' && axis_names.find(where[0]) != axis_names.npos &&
      read_number(where.substr(2), plane.at)) {
    plane.axis = axis_names.find(where[0]);
    return {std::string(name), plane};
  }
  std::string names;
  for (const std::string_view one : patch_names) names.append(names.empty() ? "" : ", ").append(one);
  refuse("the patch '" + std::string(name) + "' is one of " + names +
         ", or an axis and a coordinate, like z:12.5, not '" + std::string(where) + "'");
}

std::string text_of(const std::variant<Patch, PatchPlane>& where) {
  if (const auto* patch = std::get_if<Patch>(&where))
    return std::string(patch_names.at(static_cast<std::size_t>(*patch)));
  const auto& [axis, at] = std::get<PatchPlane>(where);
  return std::string(1, axis_names[axis]) + ":" + number(at);
}

BoundaryPoints::BoundaryPoints(const Survey& survey, const Stuffing& stuffing, const Frame& frame,
                               std::span<const Coord3> moved, Context& context)
    : numbers_(points_of(survey)), places_(numbers_.size()) {
  if (!moved.empty()) {
    for (std::size_t i = 0; i < numbers_.size(); ++i) places_[i] = frame.world(moved[numbers_[i]]);
    return;
  }
  core::parallel_for(context, Stage::emit, stuffing.layers(), [&](std::int64_t task) {
    const auto layer = static_cast<std::int32_t>(task);
    const std::uint64_t first = stuffing.first_point(layer), end = stuffing.first_point(layer + 1);
    const auto begin = std::ranges::lower_bound(numbers_, first);
    if (begin == numbers_.end() || *begin >= end) return;
    Buffer<Coord3> points(end - first);
    core::OneThread own;
    stuffing.emit_points(layer, layer + 1, points, own);
    for (auto at = begin; at != numbers_.end() && *at < end; ++at)
      places_[static_cast<std::size_t>(at - numbers_.begin())] = frame.world(points[*at - first]);
  });
}

Point3 BoundaryPoints::at(std::uint64_t point) const {
  const auto found = std::ranges::lower_bound(numbers_, point);
  return places_[static_cast<std::size_t>(found - numbers_.begin())];
}

void name_patches(Survey& survey, std::span<const PatchChoice> choices, double size,
                  const PlaceOf& place) {
  if (choices.empty()) return;
  NamingPatches naming(survey, size, place);
  for (const PatchChoice& choice : choices) naming.name(choice);
  naming.finish(choices);
}

std::string name_of(Patch patch, const Survey& survey) {
  const auto number = static_cast<std::size_t>(patch);
  return number < patch_names.size() ? std::string(patch_names[number])
                                     : survey.named_patches.at(number - patch_names.size());
}

std::vector<PatchFigures> patch_figures(const Survey& survey, const PlaceOf& place) {
  std::vector<PatchFigures> all(patch_names.size() + survey.named_patches.size());
  for (std::size_t patch = 0; patch < all.size(); ++patch)
    all[patch].name = name_of(static_cast<Patch>(patch), survey);
  for (const BoundaryFace& face : survey.boundary) {
    PatchFigures& patch = all[static_cast<std::size_t>(face.patch)];
    const auto& [a, b, c] = face.points;
    ++patch.triangles;
    patch.area += area_of(place(a), place(b), place(c));
  }
  std::erase_if(all, [](const PatchFigures& patch) { return patch.triangles == 0; });
  return all;
}

}  // namespace certet
