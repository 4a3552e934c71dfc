#pragma once
/// \file
/// The faces that belong to one tetrahedron only.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "certet/quality.hpp"
#include "certet/survey.hpp"
#include "engine/border.hpp"

namespace certet::core {

/// The corners of the face opposite to each corner of a tetrahedron of positive
/// volume, counterclockwise as seen from outside.
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> outward_faces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

template <class Index>
BoundaryFace face_of(const Tet<Index>& tet, std::uint64_t number, std::uint8_t opposite,
                     std::int32_t label = only_label) {
  const auto [a, b, c] = outward_faces[opposite];
  BoundaryFace face{{tet[a], tet[b], tet[c]}, number, opposite, false, Patch::surface, label};
  std::rotate(face.points.begin(), std::ranges::min_element(face.points), face.points.end());
  return face;
}

/// Orders faces by their points, whichever way round they are seen.
bool comes_before(const BoundaryFace& a, const BoundaryFace& b);
bool same_points(const BoundaryFace& a, const BoundaryFace& b);

/// A face between two tetrahedra of different labels, as the one of the lesser has it.
struct InnerFace {
  BoundaryFace face;
  std::int32_t behind;  ///< the other one's label
};

/// Sorts faces and takes out all that are there more than once; of those that are there
/// twice, with different labels, it adds what they are to `inner`.
void keep_single_faces(std::vector<BoundaryFace>& faces, std::vector<InnerFace>& inner);

/// A face of the boundary of which two points lie where the domain is cut off.
struct DoubtfulFace {
  std::array<std::uint64_t, 3> points;
  std::uint64_t third;  ///< its other point
  Patch patch;          ///< where it belongs if it is on the border
};

/// Puts faces of the boundary into the patches of sides: those of which `sides_at` tells some
/// of three points.  \returns those of which it does of two.
template <class SidesAt>
std::vector<DoubtfulFace> put_on_border(std::span<BoundaryFace> faces, const SidesAt& sides_at) {
  std::vector<DoubtfulFace> doubtful;
  for (BoundaryFace& face : faces) {
    std::array<Sides, 3> sides{};
    std::size_t count = 0;
    std::uint64_t third = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      sides[i] = sides_at(face.points[i]);
      sides[i] != 0 ? static_cast<void>(++count) : static_cast<void>(third = face.points[i]);
    }
    if (count < 2) continue;
    const auto patch = static_cast<Patch>(static_cast<std::size_t>(Patch::xmin) + side_of_face(sides));
    if (count == 3) face.patch = patch, face.is_cut_off = true;
    if (count == 2) doubtful.push_back({face.points, third, patch});
  }
  return doubtful;
}

/// Where two materials and the outside meet, the boundary has a point between the two:
/// puts those faces on the border whose third point is such a one.
void put_on_border(Survey& survey, std::span<const DoubtfulFace> faces);

/// Faces between labels, brought together by the labels.
std::vector<Interface> interfaces_of(std::vector<InnerFace> faces);

/// How often there is each label, as regions without names.
class RegionCounts {
 public:
  /// So many tetrahedra, and six times their volume in steps cubed, where it was measured.
  void add(std::int32_t label, std::uint64_t tets, const WideSum& six_volumes = {}) {
    Count& count = counts_[label];
    count.tets += tets;
    count.six_volumes += six_volumes;
  }
  void add(std::span<const std::int32_t> labels);
  RegionCounts& operator+=(const RegionCounts& other);
  [[nodiscard]] std::vector<Region> regions() const;
  /// Calls visit(label, tets, six_volumes) for each label.
  template <class Visit>
  void visit(const Visit& visit) const {
    for (const auto& [label, count] : counts_) visit(label, count.tets, count.six_volumes);
  }

 private:
  struct Count {
    std::uint64_t tets = 0;
    WideSum six_volumes;
  };
  std::map<std::int32_t, Count> counts_;
};

}  // namespace certet::core
