#include "shared_faces.hpp"

#include <algorithm>

#include "cell_word.hpp"
#include "row_ranks.hpp"
#include "stencil_choice.hpp"

namespace certet::core {
namespace {

/// Which tetrahedra of a stencil have the triangles of the mesh on a face of the structured
/// one: none, one, or, where the face has two plus corners and a minus one, two, of which
/// the first has both plus corners.  So the two sides of a face name them alike.
using FaceOwners = std::array<std::int8_t, 2>;

/// Whether a vertex of a stencil lies on the face across from a corner.
constexpr bool is_on_face(StencilVertex v, std::size_t opposite) {
  return v.a != opposite && v.b != opposite;
}

constexpr FaceOwners owners_of(const Stencil& stencil, std::size_t opposite) {
  FaceOwners owners{-1, -1};
  int corners_of_first = -1;
  for (std::int8_t n = 0; n < static_cast<std::int8_t>(stencil.count); ++n) {
    int on_face = 0;
    int corners = 0;
    for (const StencilVertex& v : stencil.tets[static_cast<std::size_t>(n)]) {
      if (!is_on_face(v, opposite)) continue;
      ++on_face;
      if (!v.is_cut()) ++corners;
    }
    if (on_face != 3) continue;
    if (corners > corners_of_first) {
      owners = {n, owners[0]};
      corners_of_first = corners;
    } else {
      owners[1] = n;
    }
  }
  return owners;
}

constexpr auto face_owners = [] {
  std::array<std::array<FaceOwners, 4>, stencils.size()> table{};
  for (std::size_t s = 0; s < stencils.size(); ++s)
    for (std::size_t face = 0; face < 4; ++face) table[s][face] = owners_of(stencils[s], face);
  return table;
}();

/// Whether two tetrahedra of a stencil have three vertices in common.
constexpr bool share_face(const UnstructuredTet& a, const UnstructuredTet& b) {
  int common = 0;
  for (const StencilVertex& v : a)
    for (const StencilVertex& w : b) common += v == w ? 1 : 0;
  return common == 3;
}

/// A face between two structured tetrahedra.
struct StructuredFace {
  std::uint8_t own_case, own_face, other_case, other_face;
  Shift shift;  ///< from the index of the one to that of the other
};

/// All faces, each seen from one side: the other is further on.
constexpr auto structured_faces = [] {
  std::array<StructuredFace, 2 * cell_tet_count> list{};
  std::size_t count = 0;
  for (std::size_t c = 0; c < cell_tet_count; ++c)
    for (std::size_t face = 0; face < 4; ++face) {
      const auto& [id, order] = tiling.tets[c].neighbors[face];
      const Shift s{static_cast<std::int8_t>(id.anchor.x / 2),
                    static_cast<std::int8_t>(id.anchor.y / 2),
                    static_cast<std::int8_t>(id.anchor.z / 2)};
      const auto other = static_cast<std::size_t>(id.orientation);
      const int further = s.z != 0 ? s.z : s.y != 0 ? s.y : s.x;
      if (further < 0 || (further == 0 && other < c)) continue;
      list[count++] = {static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(face),
                       static_cast<std::uint8_t>(other), order[face], s};
    }
  return list;
}();

/// Hands pairs on in batches.
class Batches {
 public:
  explicit Batches(const VisitTetPairs& visit) : visit_(visit) {}
  void add(std::uint32_t a, std::uint32_t b) {
    pairs_[count_++] = {a, b};
    if (count_ == pairs_.size()) hand_on();
  }
  void hand_on() {
    if (count_ > 0) visit_(std::span<const TetPair>(pairs_).first(count_));
    count_ = 0;
  }

 private:
  const VisitTetPairs& visit_;
  std::array<TetPair, 1024> pairs_;
  std::size_t count_ = 0;
};

constexpr std::uint8_t whole_stencil = orders_of_cuts[pattern_count - 1].stencil[0];

}  // namespace

LayerTets::LayerTets(const WarpedLattice& warped, int k)
    : columns_(warped.planes.cells()[0]), rows_(warped.planes.cells()[1]),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
  RowWindow rows(warped.planes, 0, k);
  const StencilChoice stencil_of(warped, rows);
  for (int j = 0; j < rows_; ++j, rows.next()) add_row(warped.planes, stencil_of, j, k);
}

LayerTets::SurfaceCell LayerTets::surface_cell(
    const std::array<Sign, cell_vertex_count>& sign, const StencilChoice& stencil_of, int w,
    int b) {
  SurfaceCell found;
  std::uint8_t tets = 0;
  for (std::size_t c = 0; c < cell_tet_count; ++c) {
    const auto& corner = cell.corner[c];
    const auto pattern = static_cast<std::size_t>(
        pattern_index(sign[corner[0]], sign[corner[1]], sign[corner[2]], sign[corner[3]]));
    const std::size_t stencil = stencil_of(pattern, c, w, b);
    found.stencil[c] = static_cast<std::uint8_t>(stencil);
    found.begin[c] = tets;
    tets = static_cast<std::uint8_t>(tets + stencils[stencil].count);
  }
  next_ += tets;
  return found;
}

void LayerTets::add_row(const SignPlanes& planes, const StencilChoice& stencil_of, int j,
                        int k) {
  const SignRows signs(planes, j, k);
  Cell* const row = &cells_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_)];
  for (int w = 0; w < planes.words(); ++w) {
    const CellWord word(signs, w);
    for_each_bit(word.any_plus, [&](int b) {
      Cell& own = row[64 * w + b];
      own.begin = next_;
      if ((word.all_plus >> b & 1) != 0) {
        own.surface = inside;
        next_ += cell_tet_count;
        return;
      }
      own.surface = static_cast<std::uint32_t>(surface_.size());
      surface_.push_back(surface_cell(word.signs(b), stencil_of, w, b));
    });
  }
}

LayerTets::CaseTets LayerTets::at(const Cell& cell, std::size_t c) const {
  if (cell.surface == inside)
    return {cell.begin + static_cast<std::uint32_t>(c), whole_stencil};
  const SurfaceCell& surface = surface_[cell.surface];
  return {cell.begin + surface.begin[c], surface.stencil[c]};
}

void LayerTets::visit(const LayerTets& other, std::int8_t layers,
                      const VisitTetPairs& visit) const {
  Batches batches(visit);
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      const Cell& own = cell_at(i, j);
      if (own.surface == none) continue;
      for (const StructuredFace& face : structured_faces) {
        if (face.shift.z != layers) continue;
        const int x = i + face.shift.x;
        const int y = j + face.shift.y;
        if (x < 0 || x >= columns_ || y < 0 || y >= rows_) continue;
        const Cell& next = other.cell_at(x, y);
        if (next.surface == none) continue;
        if (own.surface == inside && next.surface == inside) {
          batches.add(own.begin + face.own_case, next.begin + face.other_case);
          continue;
        }
        const CaseTets a = at(own, face.own_case);
        const CaseTets b = other.at(next, face.other_case);
        const FaceOwners& of_a = face_owners[a.stencil][face.own_face];
        const FaceOwners& of_b = face_owners[b.stencil][face.other_face];
        for (std::size_t n = 0; n < 2; ++n)
          if (of_a[n] >= 0 && of_b[n] >= 0)
            batches.add(a.begin + static_cast<std::uint32_t>(of_a[n]),
                        b.begin + static_cast<std::uint32_t>(of_b[n]));
      }
    }
  batches.hand_on();
}

void LayerTets::visit_within(const VisitTetPairs& visit) const {
  Batches batches(visit);
  for (const Cell& own : cells_) {
    if (own.surface == none || own.surface == inside) continue;
    for (std::size_t c = 0; c < cell_tet_count; ++c) {
      const CaseTets tets = at(own, c);
      const Stencil& stencil = stencils[tets.stencil];
      for (std::uint32_t n = 1; n < stencil.count; ++n)
        for (std::uint32_t m = 0; m < n; ++m)
          if (share_face(stencil.tets[m], stencil.tets[n]))
            batches.add(tets.begin + m, tets.begin + n);
    }
  }
  batches.hand_on();
  this->visit(*this, 0, visit);
}

void LayerTets::visit_between(const LayerTets& next, const VisitTetPairs& visit) const {
  this->visit(next, 1, visit);
}

}  // namespace certet::core
