#include "mesh_memory.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <string>

#include "certet/error.hpp"
#include "memory.hpp"

namespace certet::command {
namespace {

/// For two slabs, one of them on its way to the file.  Larger ones are no
/// faster: they leave the processor's cache.
constexpr std::uint64_t slab_bytes = 24 << 20;

[[noreturn]] void refuse_memory(const std::string& what, std::uint64_t needed,
                                std::uint64_t limit) {
  throw Error(ErrorCode::too_large, what + " needs " + std::to_string(needed) +
                                        " bytes of memory, more than the " +
                                        std::to_string(limit) +
                                        " allowed; choose a larger --size or fewer --target-tets");
}

}  // namespace

std::uint64_t memory_limit(const MeshOptions& options) {
  if (options.max_memory != 0) return options.max_memory;
  const std::uint64_t available = available_memory();
  return available == 0 ? std::numeric_limits<std::uint64_t>::max() / 2 : available / 4 * 3;
}

/// A cell of the lattice has twelve tetrahedra and takes more than a byte.
void check_target(const MeshOptions& options, std::uint64_t limit) {
  if (options.target_tets / 12 > limit)
    refuse_memory("a mesh of " + std::to_string(options.target_tets) + " tetrahedra",
                  options.target_tets / 12, limit);
}

/// The engine holds a sign in two bits for two points in each cell, twice while it warps, and,
/// where it cuts materials apart, their numbers, once as digits and once as bytes, and the
/// numbers of every row.
void check_lattice(const PlacedSource& source, Method method, std::uint64_t limit) {
  const auto& cells = source.lattice.cells;
  const double rows = static_cast<double>(cells[1]) * cells[2];
  const std::size_t labels = source.domain->labels().size();
  const double digits = facts(method).interfaces && labels > 1
                            ? static_cast<double>(std::bit_width(labels))
                            : 0;
  const double needed = rows * (static_cast<double>(cells[0]) * (1 + digits / 2) + 32) +
                        static_cast<double>(source.bytes);
  if (needed > static_cast<double>(limit))
    refuse_memory("a lattice of " + std::to_string(cells[0]) + " x " +
                      std::to_string(cells[1]) + " x " + std::to_string(cells[2]) + " cells",
                  static_cast<std::uint64_t>(needed), limit);
}

namespace {

std::uint64_t bytes_to_move(const Counted& counted) {
  return counted.source.bytes + counted.stuffing.bytes() + bytes_to_optimise(counted.stuffing);
}

}  // namespace

bool can_move(const Counted& counted, const MeshReport& report) {
  return bytes_to_move(counted) <= report.memory_limit;
}

void check_moving_memory(const Counted& counted, const std::string& what,
                         const MeshReport& report) {
  if (!can_move(counted, report)) refuse_memory(what, bytes_to_move(counted), report.memory_limit);
}

Slabs plan(const Counted& counted, const MeshSize& size, Format format, MeshReport& report) {
  const auto& [source, stuffing] = counted;
  std::uint64_t held = source.bytes + stuffing.bytes() + held_bytes(format, size);
  if (size.survey != nullptr)
    held += face_count(*size.survey) * sizeof(BoundaryFace) + size.survey->materials.bytes();
  if (report.moved()) held += stuffing.point_count() * sizeof(Coord3);
  // Middle nodes, of which a slab has as many for a tetrahedron as the whole.
  double for_each_tet = 0;
  if (size.middles != nullptr) {
    held += size.middles->bytes();
    for_each_tet = static_cast<double>(size.middles->count() * sizeof(Point3)) /
                   static_cast<double>(size.tets);
  }
  const auto middle_bytes = [&](const Slabs& slabs) {
    return static_cast<std::uint64_t>(for_each_tet * static_cast<double>(slabs.tets));
  };
  report.memory_least = held + cut_slabs(stuffing, 0).bytes + middle_bytes(cut_slabs(stuffing, 0));
  if (report.memory_least > report.memory_limit)
    refuse_memory("the mesh", report.memory_least, report.memory_limit);
  Slabs slabs = cut_slabs(stuffing, std::min(slab_bytes, report.memory_limit - held));
  report.memory_needed = held + slabs.bytes + middle_bytes(slabs);
  return slabs;
}

}  // namespace certet::command
