#include "seen_surface.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "certet/survey.hpp"

namespace certet::features {
namespace {

/// Those at whose edges triangles turn by more than so many degrees, and their neighbours.
std::vector<std::uint8_t> doubtful_ones(const SeenSurface& surface, double least) {
  struct Side {
    std::uint32_t low, high, triangle;
  };
  std::vector<Side> sides;
  std::vector<Vector> normals;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    normals.push_back(
        cross(surface.places[b] - surface.places[a], surface.places[c] - surface.places[a]));
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      sides.push_back({std::min(from, to), std::max(from, to), t});
  }
  std::ranges::sort(sides, [](const Side& s, const Side& t) {
    return std::tie(s.low, s.high, s.triangle) < std::tie(t.low, t.high, t.triangle);
  });
  std::vector<std::uint8_t> at_turn(surface.places.size());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &own = sides[i], &next = sides[i + 1];
    if (own.low == next.low && own.high == next.high &&
        angle_between(normals[own.triangle], normals[next.triangle]) > least)
      at_turn[own.low] = at_turn[own.high] = 1;
  }
  std::vector<std::uint8_t> doubtful = at_turn;
  for (const auto& [a, b, c] : surface.triangles)
    if ((at_turn[a] | at_turn[b] | at_turn[c]) != 0) doubtful[a] = doubtful[b] = doubtful[c] = 1;
  return doubtful;
}

/// Doubtful ones that were not seen, each with the normals of neighbours that were, by growing numbers
/// of these.
std::map<std::uint32_t, std::vector<Vector>> hidden_ones(const SeenSurface& surface) {
  std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t v : triangle)
      if (surface.doubtful[v] != 0 && surface.known[v] == 0)
        for (const std::uint32_t w : triangle)
          if (surface.known[w] != 0) neighbours[v].insert(w);
  std::map<std::uint32_t, std::vector<Vector>> hidden;
  for (const auto& [v, others] : neighbours)
    for (const std::uint32_t w : others) hidden[v].push_back(surface.normals[w]);
  return hidden;
}

void look_at_doubtful(SeenSurface& surface, const Domain& domain, Context& context) {
  std::vector<Look> looks;
  std::vector<std::uint32_t> looked_at;
  const auto look = [&] {
    const auto seen = facing(domain, looks, context);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const std::uint32_t v = looked_at[i];
      if (!seen[i] || surface.known[v] != 0) continue;
      surface.known[v] = 1;
      surface.normals[v] = seen[i]->normal;
    }
    looks.clear();
    looked_at.clear();
  };
  const auto put = [&](std::uint32_t v, const Vector& axis) {
    looks.push_back({surface.places[v], axis});
    looked_at.push_back(v);
  };
  for (std::uint32_t v = 0; v < surface.places.size(); ++v)
    if (surface.doubtful[v] != 0) put(v, surface.normals[v]);
  look();
  // Beside an acute edge the triangles may face past both of its faces.
  for (const auto& [v, axes] : hidden_ones(surface))
    for (const Vector& axis : axes) put(v, axis);
  look();
}

}  // namespace

std::uint32_t SeenSurface::number_of(std::uint64_t in_mesh) const {
  const auto found = std::ranges::lower_bound(numbers, in_mesh);
  return found != numbers.end() && *found == in_mesh
             ? static_cast<std::uint32_t>(found - numbers.begin())
             : none;
}

SeenSurface see_surface(const Mesh& mesh, const Domain& domain, double angle, Context& context) {
  SeenSurface surface;
  const std::vector<BoundaryFace> faces = survey(mesh, context).boundary;
  for (const BoundaryFace& face : faces)
    surface.numbers.insert(surface.numbers.end(), face.points.begin(), face.points.end());
  std::ranges::sort(surface.numbers);
  surface.numbers.erase(std::unique(surface.numbers.begin(), surface.numbers.end()),
                        surface.numbers.end());
  for (const std::uint64_t number : surface.numbers)
    surface.places.push_back(in_doubles(mesh.points[number]));
  surface.normals.assign(surface.places.size(), {0, 0, 0});
  for (const BoundaryFace& face : faces) {
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = surface.number_of(face.points[i]);
    surface.triangles.push_back(triangle);
    const auto& [a, b, c] = triangle;
    const Vector normal =
        cross(surface.places[b] - surface.places[a], surface.places[c] - surface.places[a]);
    for (const std::uint32_t v : triangle) surface.normals[v] = surface.normals[v] + normal;
  }
  for (Vector& normal : surface.normals) normal = unit(normal);
  surface.doubtful = doubtful_ones(surface, angle / 4);
  surface.known.assign(surface.places.size(), 0);
  look_at_doubtful(surface, domain, context);
  return surface;
}

}  // namespace certet::features
