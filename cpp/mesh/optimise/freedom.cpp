#include "freedom.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace certet::optimising {
namespace {

/// An edge from the vertex, as a sheet has it.
struct Spine {
  std::uint64_t end;
  Vector edge;
  std::size_t sheet;
};

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
  explicit View(std::span<const Sheet> sheets) : sheets_(sheets) {
    spines_.reserve(2 * sheets.size());
    for (std::size_t t = 0; t < sheets.size(); ++t)
      for (std::size_t i = 0; i < 2; ++i)
        spines_.push_back({sheets[t].face.others[i], sheets[t].edges[i], t});
    std::ranges::sort(spines_, [](const Spine& s, const Spine& t) {
      return std::pair(s.end, s.sheet) < std::pair(t.end, t.sheet);
    });
  }

  [[nodiscard]] Freedom freedom(bool labelled) const {
    Freedom freedom;
    const Sheet* first = nullptr;
    bool several = false;
    Vector normal{};
    for (const Sheet& sheet : sheets_) {
      const Vector own = cross(sheet.edges[0], sheet.edges[1]);
      if (sheet.border) {
        if (!hold(freedom, own)) return {Place::corner};
        continue;
      }
      if (first == nullptr) first = &sheet;
      several = several || !first->on_surface_of(sheet);
      normal = normal + own;
    }
    if (several) return on_seam(freedom);
    if (!is_manifold()) return {Place::corner};
    if (first == nullptr) return freedom;
    freedom.outer = first->face.outer;
    freedom.labelled = labelled;
    freedom.within = first->face.label;
    freedom.beyond = first->face.beyond;
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
          !sheets_[edge[0].sheet].on_surface_of(sheets_[edge[1].sheet]))
        edges.push_back((1 / length(edge[0].edge)) * edge[0].edge);
    });
    if (edges.size() != 2) return {Place::corner};
    const Vector along = edges[0] - edges[1];
    const double size = length(along);
    if (!(size > 1)) return {Place::corner};  // it turns by 120 degrees or more
    return {Place::seam, (1 / size) * along};
  }

  /// Calls visit(spines of the edge) for each edge from the vertex.
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

  std::span<const Sheet> sheets_;
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

Freedom freedom_of(std::span<const Sheet> sheets, bool labelled) {
  return sheets.empty() ? Freedom{} : View(sheets).freedom(labelled);
}

}  // namespace certet::optimising
