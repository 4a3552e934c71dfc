// The surface of one region, or the interface of two.

#include <algorithm>
#include <string>
#include <utility>

#include "boundary.hpp"
#include "certet/error.hpp"

namespace certet {
namespace {

/// A face as the tetrahedron on its other side has it.
BoundaryFace turned(BoundaryFace face) {
  std::swap(face.points[1], face.points[2]);
  return face;
}

std::vector<BoundaryFace> surface_of(const Survey& survey, std::int32_t label) {
  std::vector<BoundaryFace> faces;
  for (const BoundaryFace& face : survey.boundary)
    if (face.label == label) faces.push_back(face);
  for (const Interface& interface : survey.interfaces) {
    if (interface.labels[0] == label)
      faces.insert(faces.end(), interface.faces.begin(), interface.faces.end());
    if (interface.labels[1] == label)
      std::ranges::transform(interface.faces, std::back_inserter(faces), turned);
  }
  std::ranges::sort(faces, core::comes_before);
  return faces;
}

std::vector<BoundaryFace> interface_of(const Survey& survey, std::int32_t a, std::int32_t b) {
  const std::array<std::int32_t, 2> labels{std::min(a, b), std::max(a, b)};
  const auto found = std::ranges::find(survey.interfaces, labels, &Interface::labels);
  if (found == survey.interfaces.end())
    throw Error(ErrorCode::bad_option, "the regions " + std::to_string(a) + " and " +
                                           std::to_string(b) + " do not touch each other");
  return found->faces;
}

}  // namespace

void keep_surface(Survey& survey, std::span<const std::int32_t> labels) {
  for (const std::int32_t label : labels)
    if (std::ranges::find(survey.regions, label, &Region::label) == survey.regions.end())
      throw Error(ErrorCode::bad_option,
                  "there is no region " + std::to_string(label) + " in the mesh");
  survey.boundary = labels.size() == 1 ? surface_of(survey, labels[0])
                                       : interface_of(survey, labels[0], labels[1]);
  survey.interfaces.clear();
}

void keep_interfaces(Survey& survey) {
  if (survey.interfaces.empty())
    throw Error(ErrorCode::bad_option, "no two regions of the mesh touch each other");
  survey.boundary.clear();
  for (const Interface& interface : survey.interfaces)
    survey.boundary.insert(survey.boundary.end(), interface.faces.begin(), interface.faces.end());
  std::ranges::sort(survey.boundary, core::comes_before);
  survey.interfaces.clear();
}

}  // namespace certet
