#include "certet/stuffing.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "count.hpp"
#include "cuts.hpp"
#include "emit.hpp"
#include "parallel.hpp"
#include "sample.hpp"
#include "warped_lattice.hpp"

namespace certet {
namespace {

using namespace core;

/// Rows that one task emits.
constexpr int rows_per_task = 32;

/// The lattice is checked once, here; every coordinate that the engine computes
/// afterwards is in range: `DoorSuffices` of the certificate.
void check_range(const Lattice& lattice) {
  const Coord3& o = lattice.origin;
  if ((o.x | o.y | o.z) & 1) throw Error(ErrorCode::bad_option, "the lattice origin is not even");
  const std::array<std::int32_t, 3> low{o.x, o.y, o.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int64_t n = lattice.cells[axis];
    if (n < 2) throw Error(ErrorCode::bad_option, "the lattice has fewer than two cells along an axis");
    const std::int64_t high = low[axis] + 2 * n + 1;
    if (low[axis] < -anchor_limit || high > anchor_limit)
      throw Error(ErrorCode::too_large,
                  "the lattice needs " + std::to_string(n) +
                      " cells along an axis, which leaves the coordinate range of ±" +
                      std::to_string(anchor_limit / 2) + " cells");
  }
}

/// Runs `work`; running out of memory becomes an error of the library.
template <class Work>
auto within_memory(const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::too_large, "the mesh does not fit in memory");
  }
}

}  // namespace

struct Stuffing::State {
  Lattice lattice;
  WarpedLattice warped;
  RowNumbers numbers;
  Guarantee guarantee;
  std::uint64_t inverted_tets = 0;

  [[nodiscard]] std::size_t row(int j, int k) const {
    return static_cast<std::size_t>(k) * static_cast<std::size_t>(lattice.cells[1]) +
           static_cast<std::size_t>(j);
  }
};

namespace {

static_assert(no_warp_thresholds.long_edge == 0 && no_warp_thresholds.short_edge == 0,
              "with cuts in the middle no cut violates a vertex");

/// With cuts in the middle nothing is left to decide: no vertex is violated, and
/// none lies on the surface, for there it counts as inside.
WarpedLattice unwarped(SignPlanes planes, std::vector<CutLayer> cuts, const Lattice& lattice) {
  const auto rows = static_cast<std::size_t>(lattice.cells[1]);
  const ZeroLayer none{{}, std::vector<std::uint32_t>(rows, 0)};
  std::vector<ZeroLayer> zeros(static_cast<std::size_t>(lattice.cells[2]), none);
  return {std::move(planes), std::move(cuts), std::move(zeros)};
}

/// Warps with the thresholds asked for; falls back to those of `embedding` if a
/// tetrahedron that is dropped came out inverted, for it would cover others.
WarpedLattice warp_lattice(const SignPlanes& planes, const std::vector<CutLayer>& cuts,
                           const Lattice& lattice, Guarantee& guarantee, std::uint64_t& inverted,
                           Context& context) {
  if (guarantee == Guarantee::angles) {
    const Violations violations(planes, cuts, angle_thresholds, context);
    inverted = violations.inverted_tets(lattice, context);
    if (inverted == 0) return violations.apply(context);
  }
  guarantee = Guarantee::embedding;
  return Violations(planes, cuts, embedding_thresholds, context).apply(context);
}

}  // namespace

Stuffing::Stuffing(const Domain& domain, const Lattice& lattice, const StuffingOptions& options,
                   Context& context) {
  check_range(lattice);
  state_ = within_memory([&] {
    Guarantee guarantee = options.guarantee;
    std::uint64_t inverted = 0;
    SignPlanes planes = sample(domain, lattice, options.cuts, context);
    std::vector<CutLayer> cuts = find_cuts(planes, domain, lattice, options.cuts, context);
    WarpedLattice warped =
        options.cuts == Cuts::midpoint
            ? unwarped(std::move(planes), std::move(cuts), lattice)
            : warp_lattice(planes, cuts, lattice, guarantee, inverted, context);
    RowNumbers numbers = count_rows(warped.planes, context);
    return std::make_unique<State>(
        State{lattice, std::move(warped), std::move(numbers), guarantee, inverted});
  });
}

Stuffing::~Stuffing() = default;
Stuffing::Stuffing(Stuffing&&) noexcept = default;
Stuffing& Stuffing::operator=(Stuffing&&) noexcept = default;

std::uint64_t Stuffing::point_count() const { return state_->numbers.first_point.back(); }
std::uint64_t Stuffing::tet_count() const { return state_->numbers.first_tet.back(); }
const Lattice& Stuffing::lattice() const { return state_->lattice; }
Guarantee Stuffing::guarantee() const { return state_->guarantee; }
std::uint64_t Stuffing::inverted_tets() const { return state_->inverted_tets; }
std::int32_t Stuffing::layers() const { return state_->lattice.cells[2]; }

std::uint64_t Stuffing::first_point(std::int32_t layer) const {
  return state_->numbers.first_point[state_->row(0, layer)];
}
std::uint64_t Stuffing::first_tet(std::int32_t layer) const {
  return state_->numbers.first_tet[state_->row(0, layer)];
}

namespace {

/// Calls emit(j_begin, j_end, k) for pieces of the layers [begin, end).
template <class Emit>
void for_each_piece(const Lattice& lattice, std::int32_t begin, std::int32_t end,
                    Context& context, const Emit& emit) {
  const std::int32_t rows = lattice.cells[1];
  const std::int64_t pieces = (rows + rows_per_task - 1) / rows_per_task;
  parallel_for(context, Stage::emit, pieces * (end - begin), [&](std::int64_t task) {
    const int j = static_cast<int>(task % pieces) * rows_per_task;
    emit(j, std::min(j + rows_per_task, rows), begin + static_cast<int>(task / pieces));
  });
}

template <class Index>
void emit_all_tets(const RowNumbers& numbers, const SignPlanes& planes, const Lattice& lattice,
                   std::int32_t begin, std::int32_t end, std::uint64_t start,
                   std::span<Tet<Index>> out, Context& context) {
  for_each_piece(lattice, begin, end, context, [&](int j_begin, int j_end, int k) {
    const std::size_t row = static_cast<std::size_t>(k) * static_cast<std::size_t>(lattice.cells[1]) +
                            static_cast<std::size_t>(j_begin);
    emit_row_tets(planes, numbers, j_begin, j_end, k, out.data() + (numbers.first_tet[row] - start));
  });
}

}  // namespace

void Stuffing::emit_points(std::int32_t begin, std::int32_t end, std::span<Coord3> out,
                           Context& context) const {
  const State& s = *state_;
  const std::uint64_t start = first_point(begin);
  for_each_piece(s.lattice, begin, end, context, [&](int j_begin, int j_end, int k) {
    RowRanks row;
    for (int j = j_begin; j < j_end; ++j) {
      row.compute(s.warped.planes, j, k);
      emit_row_points(s.warped, s.lattice, row, j, k,
                      out.data() + (s.numbers.first_point[s.row(j, k)] - start));
    }
  });
}

void Stuffing::mark_surface(std::int32_t begin, std::int32_t end, std::span<std::uint8_t> out,
                            Context& context) const {
  const State& s = *state_;
  const std::uint64_t start = first_point(begin);
  for_each_piece(s.lattice, begin, end, context, [&](int j_begin, int j_end, int k) {
    RowRanks row;
    for (int j = j_begin; j < j_end; ++j) {
      row.compute(s.warped.planes, j, k);
      mark_row_points(s.warped.planes, row, j, k,
                      out.data() + (s.numbers.first_point[s.row(j, k)] - start));
    }
  });
}

void Stuffing::emit_tets(std::int32_t begin, std::int32_t end,
                         std::span<Tet<std::uint32_t>> out, Context& context) const {
  emit_all_tets(state_->numbers, state_->warped.planes, state_->lattice, begin, end,
                first_tet(begin), out, context);
}

void Stuffing::emit_tets(std::int32_t begin, std::int32_t end,
                         std::span<Tet<std::uint64_t>> out, Context& context) const {
  emit_all_tets(state_->numbers, state_->warped.planes, state_->lattice, begin, end,
                first_tet(begin), out, context);
}

std::uint64_t Stuffing::bytes() const {
  const State& s = *state_;
  std::uint64_t bytes = s.warped.planes.bytes() +
                        8 * (s.numbers.first_point.size() + s.numbers.first_tet.size());
  for (const CutLayer& layer : s.warped.cuts)
    bytes += 2 * layer.steps.size() + 8 * layer.row_begin.size();
  for (const ZeroLayer& layer : s.warped.zeros)
    bytes += sizeof(Displacement) * layer.displacements.size() + 4 * layer.row_begin.size();
  return bytes;
}

Mesh emit(const Stuffing& stuffing, const Frame& frame, Context& context) {
  checked_size(frame.size);
  return within_memory([&] {
    Mesh mesh;
    mesh.frame = frame;
    mesh.points = Buffer<Coord3>(stuffing.point_count());
    stuffing.emit_points(0, stuffing.layers(), mesh.points, context);
    const auto emit_tets = [&]<class Index>(Index) {
      Buffer<Tet<Index>> tets(stuffing.tet_count());
      stuffing.emit_tets(0, stuffing.layers(), std::span<Tet<Index>>(tets), context);
      mesh.tets = std::move(tets);
    };
    if (stuffing.point_count() <= std::numeric_limits<std::uint32_t>::max())
      emit_tets(std::uint32_t{});
    else
      emit_tets(std::uint64_t{});
    return mesh;
  });
}

Mesh stuff(const Domain& domain, const Lattice& lattice, const Frame& frame,
           const StuffingOptions& options, Context& context) {
  const Stuffing stuffing(domain, lattice, options, context);
  if (stuffing.tet_count() == 0)
    throw Error(ErrorCode::empty_domain, "no lattice point lies inside the domain");
  return emit(stuffing, frame, context);
}

}  // namespace certet
