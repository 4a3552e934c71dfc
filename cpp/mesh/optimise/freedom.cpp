#include "freedom.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace certet::optimising {
namespace {

/// A triangle of a surface at the vertex.
struct Triangle {
  const Sheet* sheet;    ///< as seen from within
  std::int32_t beyond;   ///< the label there
  bool outer;

  [[nodiscard]] bool border() const { return outer && sheet->border; }
  [[nodiscard]] bool on_surface_of(const Triangle& other) const {
    return border() == other.border() &&
           (border() || (outer == other.outer && sheet->label == other.sheet->label &&
                         beyond == other.beyond));
  }
};

/// An edge from the vertex, as a triangle has it.
struct Spine {
  std::uint64_t end;
  Vector edge;
  std::size_t triangle;
};

std::pair<std::uint64_t, std::uint64_t> key_of(const Sheet& sheet) {
  return std::minmax(sheet.others[0], sheet.others[1]);
}

/// Those that one tetrahedron has alone, and those between two labels, as the lesser has them.
std::vector<Triangle> triangles_of(std::vector<Sheet>& sheets) {
  std::ranges::sort(sheets, [](const Sheet& s, const Sheet& t) {
    return std::pair(key_of(s), s.label) < std::pair(key_of(t), t.label);
  });
  std::vector<Triangle> triangles;
  for (auto sheet = sheets.begin(); sheet != sheets.end();) {
    const auto next = sheet + 1;
    if (next == sheets.end() || key_of(*next) != key_of(*sheet)) {
      triangles.push_back({&*sheet, 0, true});
      sheet = next;
    } else {
      if (next->label != sheet->label) triangles.push_back({&*sheet, next->label, false});
      sheet = next + 1;
    }
  }
  return triangles;
}

/// The axis that is normal to a face where the shape is cut off, if one is.  Bisection leaves
/// its points a few steps off that face.
std::optional<std::size_t> axis_of(const Vector& normal) {
  constexpr double flat = 1 << 10;
  for (std::size_t a = 0; a < 3; ++a) {
    const double aside = std::max(std::fabs(normal[(a + 1) % 3]), std::fabs(normal[(a + 2) % 3]));
    if (flat * aside < std::fabs(normal[a])) return a;
  }
  return std::nullopt;
}

/// The surfaces around a vertex.
class View {
 public:
  explicit View(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < 2; ++i) {
        const Sheet& sheet = *triangles_[t].sheet;
        spines_.push_back({sheet.others[i], sheet.edges[i], t});
      }
    std::ranges::sort(spines_, [](const Spine& s, const Spine& t) {
      return std::pair(s.end, s.triangle) < std::pair(t.end, t.triangle);
    });
  }

  [[nodiscard]] Freedom freedom(bool labelled) const {
    Freedom freedom;
    const Triangle* first = nullptr;
    bool several = false;
    Vector normal{};
    for (const Triangle& triangle : triangles_) {
      const Vector own = cross(triangle.sheet->edges[0], triangle.sheet->edges[1]);
      if (triangle.border()) {
        if (!hold(freedom, own)) return {Place::corner};
        continue;
      }
      if (first == nullptr) first = &triangle;
      several = several || !first->on_surface_of(triangle);
      normal = normal + own;
    }
    if (several) return on_seam(freedom);
    if (!is_manifold()) return {Place::corner};
    if (first == nullptr) return freedom;
    freedom.outer = first->outer;
    freedom.labelled = labelled;
    freedom.within = first->sheet->label;
    freedom.beyond = first->beyond;
    return on_surface(freedom, normal);
  }

 private:
  /// In a face where the shape is cut off.
  static bool hold(Freedom& freedom, const Vector& normal) {
    // What bisection found may be a step beyond the face, where all is outside.
    constexpr std::int32_t within = 4;
    const auto axis = axis_of(normal);
    if (!axis) return false;
    freedom.held[*axis] = true;
    const std::int32_t by = normal[*axis] > 0 ? -within : within;
    (*axis == 0 ? freedom.inward.x : *axis == 1 ? freedom.inward.y : freedom.inward.z) = by;
    return true;
  }

  static Freedom on_surface(Freedom freedom, const Vector& normal) {
    freedom.place = Place::surface;
    for (std::size_t a = 0; a < 3; ++a) freedom.along[a] = freedom.held[a] ? 0 : normal[a];
    const double size = length(freedom.along);
    if (!(size > 0.01 * length(normal))) return {Place::corner};
    freedom.along = (1 / size) * freedom.along;
    return freedom;
  }

  /// Along the line between its two neighbours on the seam, if it has two.
  [[nodiscard]] Freedom on_seam(const Freedom& freedom) const {
    if (freedom.held != std::array<bool, 3>{}) return {Place::corner};
    std::vector<Vector> edges;
    visit_edges([&](std::span<const Spine> edge) {
      if (edge.size() != 2 ||
          !triangles_[edge[0].triangle].on_surface_of(triangles_[edge[1].triangle]))
        edges.push_back((1 / length(edge[0].edge)) * edge[0].edge);
    });
    if (edges.size() != 2) return {Place::corner};
    const Vector along = edges[0] - edges[1];
    const double size = length(along);
    if (!(size > 1)) return {Place::corner};  // it turns by 120 degrees or more
    return {Place::seam, (1 / size) * along};
  }

  /// Calls visit(triangles at the edge) for each edge from the vertex.
  template <class Visit>
  void visit_edges(const Visit& visit) const {
    for (std::size_t begin = 0, end = 0; begin < spines_.size(); begin = end) {
      while (end < spines_.size() && spines_[end].end == spines_[begin].end) ++end;
      visit(std::span<const Spine>(spines_).subspan(begin, end - begin));
    }
  }

  [[nodiscard]] bool is_manifold() const {
    bool so = true;
    visit_edges([&](std::span<const Spine> edge) { so = so && edge.size() == 2; });
    return so;
  }

  std::vector<Triangle> triangles_;
  std::vector<Spine> spines_;
};

}  // namespace

Vector Freedom::part_of(Vector direction) const {
  for (std::size_t a = 0; a < 3; ++a)
    if (held[a]) direction[a] = 0;
  switch (place) {
    case Place::inside: return direction;
    case Place::surface: return direction - dot(direction, along) * along;
    case Place::seam: return dot(direction, along) * along;
    case Place::corner: break;
  }
  return {0, 0, 0};
}

Freedom freedom_of(std::vector<Sheet>& sheets, bool labelled) {
  std::vector<Triangle> triangles = triangles_of(sheets);
  return triangles.empty() ? Freedom{} : View(std::move(triangles)).freedom(labelled);
}

}  // namespace certet::optimising
