#include "boundary.hpp"

#include <tuple>

#include "faces.hpp"
#include "quality/extremes.hpp"

namespace certet {
namespace core {
namespace {

auto key(const BoundaryFace& face) {
  const auto& [lowest, a, b] = face.points;
  return std::tuple(lowest, std::min(a, b), std::max(a, b));
}

/// The faces in one tetrahedron, by their points alone.
template <class Index, class Valid>
std::vector<Face> single_faces(std::uint64_t points, std::span<const Tet<Index>> tets,
                               Valid valid, Context& context) {
  return points <= NarrowFace::point_limit
             ? find_faces<NarrowFace>(points, tets, valid, context).boundary
             : find_faces<WideFace>(points, tets, valid, context).boundary;
}

/// Tells which tetrahedra name four different points that are there.
template <class Index>
auto validity(std::uint64_t points, std::span<const Tet<Index>> tets) {
  return [=](std::size_t i) {
    std::array<Index, 4> p = tets[i];
    std::ranges::sort(p);
    return p[3] < points && std::ranges::adjacent_find(p) == p.end();
  };
}

/// The points where tetrahedra of different labels meet.
template <class Index>
std::vector<bool> points_between(std::uint64_t points, std::span<const Tet<Index>> tets,
                                 std::span<const std::int32_t> labels) {
  const auto valid = validity(points, tets);
  std::vector<std::int32_t> first(points);
  std::vector<bool> seen(points), between(points);
  for (std::size_t i = 0; i < tets.size(); ++i) {
    if (!valid(i)) continue;
    for (const Index point : tets[i]) {
      if (seen[point] && first[point] != labels[i]) between[point] = true;
      seen[point] = true;
      first[point] = labels[i];
    }
  }
  return between;
}

template <class Index>
std::vector<Interface> interfaces(std::uint64_t points, std::span<const Tet<Index>> tets,
                                  std::span<const std::int32_t> labels, Context& context) {
  const auto valid = validity(points, tets);
  const std::vector<bool> between = points_between(points, tets, labels);
  std::vector<BoundaryFace> faces;
  for (std::size_t i = 0; i < tets.size(); ++i) {
    stop_now_and_then(i, context);
    if (!valid(i)) continue;
    for (std::uint8_t opposite = 0; opposite < 4; ++opposite) {
      const BoundaryFace face = face_of(tets[i], i, opposite, labels[i]);
      if (std::ranges::all_of(face.points, [&](std::uint64_t p) { return between[p]; }))
        faces.push_back(face);
    }
  }
  std::vector<InnerFace> inner;
  keep_single_faces(faces, inner);
  return interfaces_of(std::move(inner));
}

template <class Index>
std::vector<BoundaryFace> boundary(std::uint64_t points, std::span<const Tet<Index>> tets,
                                   std::span<const std::int32_t> labels, Context& context) {
  const auto valid = validity(points, tets);
  const std::vector<Face> single = single_faces(points, tets, valid, context);
  std::vector<bool> used(points);
  for (const Face& face : single)
    for (const std::uint64_t point : face.points) used[point] = true;
  std::vector<BoundaryFace> faces;
  faces.reserve(single.size());
  for (std::size_t i = 0; i < tets.size(); ++i) {
    stop_now_and_then(i, context);
    if (!valid(i)) continue;
    for (std::uint8_t opposite = 0; opposite < 4; ++opposite) {
      const BoundaryFace face =
          face_of(tets[i], i, opposite, labels.empty() ? only_label : labels[i]);
      if (!std::ranges::all_of(face.points, [&](std::uint64_t p) { return used[p]; })) continue;
      const auto [a, b, c] = key(face);
      const std::array<std::uint64_t, 3> sorted{a, b, c};
      if (std::ranges::binary_search(single, sorted, {}, &Face::points)) faces.push_back(face);
    }
  }
  std::ranges::sort(faces, comes_before);
  return faces;
}

template <class Index>
Survey survey_of(std::uint64_t points, std::span<const Tet<Index>> tets,
                 std::span<const std::int32_t> labels, Context& context) {
  RegionCounts counts;
  counts.add(labels);
  if (labels.empty() && !tets.empty()) counts.add(only_label, tets.size());
  Survey found{counts.regions(), boundary(points, tets, labels, context)};
  if (found.regions.size() > 1) found.interfaces = interfaces(points, tets, labels, context);
  return found;
}

}  // namespace

bool comes_before(const BoundaryFace& a, const BoundaryFace& b) { return key(a) < key(b); }
bool same_points(const BoundaryFace& a, const BoundaryFace& b) { return key(a) == key(b); }

void keep_single_faces(std::vector<BoundaryFace>& faces, std::vector<InnerFace>& inner) {
  std::ranges::sort(faces, comes_before);
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < faces.size();) {
    std::size_t end = begin + 1;
    while (end < faces.size() && same_points(faces[begin], faces[end])) ++end;
    if (end == begin + 1) faces[kept++] = faces[begin];
    if (end == begin + 2 && faces[begin].label != faces[begin + 1].label) {
      const auto [lesser, greater] = std::minmax(
          faces[begin], faces[begin + 1],
          [](const BoundaryFace& a, const BoundaryFace& b) { return a.label < b.label; });
      inner.push_back({lesser, greater.label});
    }
    begin = end;
  }
  faces.resize(kept);
}

void put_on_border(Survey& survey, std::span<const DoubtfulFace> faces) {
  if (survey.interfaces.empty()) return;
  std::vector<std::uint64_t> between;
  for (const Interface& interface : survey.interfaces)
    for (const BoundaryFace& face : interface.faces)
      between.insert(between.end(), face.points.begin(), face.points.end());
  std::ranges::sort(between);
  std::vector<PatchFace> found;
  for (const auto& [points, third, patch] : faces)
    if (std::ranges::binary_search(between, third)) found.push_back({points, patch});
  set_patches(survey, std::move(found));
}

std::vector<Interface> interfaces_of(std::vector<InnerFace> faces) {
  std::ranges::sort(faces, [](const InnerFace& a, const InnerFace& b) {
    return std::tuple(a.face.label, a.behind, key(a.face)) <
           std::tuple(b.face.label, b.behind, key(b.face));
  });
  std::vector<Interface> interfaces;
  for (const auto& [face, behind] : faces) {
    const std::array labels{face.label, behind};
    if (interfaces.empty() || interfaces.back().labels != labels)
      interfaces.push_back({labels, {}});
    interfaces.back().faces.push_back(face);
  }
  return interfaces;
}

/// Labels come in runs.
void RegionCounts::add(std::span<const std::int32_t> labels) {
  for (std::size_t begin = 0; begin < labels.size();) {
    std::size_t end = begin + 1;
    while (end < labels.size() && labels[end] == labels[begin]) ++end;
    add(labels[begin], end - begin);
    begin = end;
  }
}

RegionCounts& RegionCounts::operator+=(const RegionCounts& other) {
  for (const auto& [label, count] : other.counts_) add(label, count.tets, count.six_volumes);
  return *this;
}

std::vector<Region> RegionCounts::regions() const {
  std::vector<Region> regions;
  for (const auto& [label, count] : counts_)
    regions.push_back({label, {}, count.tets, long_edges_cubed(count.six_volumes)});
  return regions;
}

}  // namespace core

Survey survey(std::uint64_t points, std::span<const Tet<std::uint32_t>> tets,
              std::span<const std::int32_t> labels, Context& context) {
  return core::survey_of(points, tets, labels, context);
}

Survey survey(std::uint64_t points, std::span<const Tet<std::uint64_t>> tets,
              std::span<const std::int32_t> labels, Context& context) {
  return core::survey_of(points, tets, labels, context);
}

std::uint64_t face_count(const Survey& survey) {
  std::uint64_t faces = survey.boundary.size();
  for (const Interface& interface : survey.interfaces) faces += interface.faces.size();
  return faces;
}

void set_patches(Survey& survey, std::vector<PatchFace> faces) {
  for (PatchFace& face : faces) std::ranges::sort(face.points);
  std::ranges::stable_sort(faces, {}, &PatchFace::points);
  for (BoundaryFace& face : survey.boundary) {
    std::array<std::uint64_t, 3> points = face.points;
    std::ranges::sort(points);
    const auto found = std::ranges::lower_bound(faces, points, {}, &PatchFace::points);
    if (found == faces.end() || found->points != points) continue;
    face.patch = found->patch;
    face.is_cut_off = is_border(face.patch);
  }
}

void name_regions(Survey& survey, const LabelNames& names) {
  for (Region& region : survey.regions) {
    const auto named = names.find(region.label);
    if (named != names.end()) region.name = named->second;
  }
}

}  // namespace certet
