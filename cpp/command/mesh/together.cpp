#include "together.hpp"

#include <algorithm>
#include <ctime>
#include <limits>
#include <string>
#include <thread>
#include <utility>

#include "refusal.hpp"

namespace certet::command {
namespace {

bool looks_at_whole(const MeshOptions& options) {
  return options.grade.any() || options.keep.has_value();
}

MeshPart part_of(const Stuffing& stuffing) {
  const auto [begin, end] = std::pair(stuffing.own_begin(), stuffing.own_end());
  return {stuffing.first_point(begin), stuffing.first_point(end) - stuffing.first_point(begin),
          stuffing.first_tet(begin), stuffing.first_tet(end) - stuffing.first_tet(begin),
          stuffing.ranks()->rank() == 0};
}

}  // namespace

void refuse_alone(const MeshOptions& options) {
  const auto refuse_option = [](bool wanted, const std::string& option) {
    if (wanted)
      refuse("several processes do not do " + option + " yet; certet mesh does");
  };
  refuse_option(options.format != Format::vtu, "any format but .vtu, not compressed,");
  refuse_option(options.order.order != 1, "--order 2");
  refuse_option(options.optimise.wanted, "--optimise");
  refuse_option(options.distance, "--distance");
  refuse_option(options.label_pieces, "--label-pieces");
}

Stuffing stuffed(const MeshOptions& options, const PlacedSource& placed, Context& context) {
  if (options.together == nullptr || looks_at_whole(options))
    return Stuffing(*placed.domain, placed.lattice, options.method, context);
  return Stuffing(*placed.domain, placed.lattice, options.method, options.together->ranks, context);
}

void share_out(const MeshOptions& options, Stuffing& stuffing) {
  if (options.together != nullptr && stuffing.ranks() == nullptr)
    stuffing.divide(options.together->ranks);
}

std::unique_ptr<MeshWriter> open_mesh(const MeshOptions& options, const Stuffing& stuffing,
                                      const MeshSize& size) {
  if (options.together == nullptr) return open_writer(options.output, options.format, size);
  return open_part_writer(
      options.together->create(options.output, file_bytes(options.format, size)), size,
      part_of(stuffing));
}

std::uint64_t lattice_limit(const MeshOptions& options, std::uint64_t limit) {
  if (options.together == nullptr || looks_at_whole(options)) return limit;
  const auto ranks = static_cast<std::uint64_t>(options.together->ranks.count());
  return std::min(limit, std::numeric_limits<std::uint64_t>::max() / ranks) * ranks;
}

std::uint64_t shared_memory_limit(const Together& together, std::uint64_t limit, bool was_asked) {
  if (!was_asked) limit /= static_cast<std::uint64_t>(together.on_this_machine);
  return std::ranges::min(gather_each(together.ranks, limit));
}

int threads_of(const Together& together, int asked) {
  if (asked != 0) return asked;
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return std::max(1, processors / together.on_this_machine);
}

std::vector<RankReport> rank_reports(const Together& together, const Stuffing& stuffing,
                                     std::uint64_t memory_peak) {
  const MeshPart part = part_of(stuffing);
  return gather_each(together.ranks,
                     RankReport{stuffing.own_end() - stuffing.own_begin(), part.points, part.tets,
                                memory_peak,
                                static_cast<double>(std::clock()) / CLOCKS_PER_SEC});
}

}  // namespace certet::command
