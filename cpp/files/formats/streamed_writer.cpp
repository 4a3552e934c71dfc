#include "streamed_writer.hpp"

#include <array>

namespace certet::formats {
namespace {

constexpr std::size_t tets_at_once = 1024;

constexpr std::array<std::int32_t, tets_at_once> only_labels = [] {
  std::array<std::int32_t, tets_at_once> labels{};
  labels.fill(only_label);
  return labels;
}();

}  // namespace

void StreamedWriter::points(std::span<const Point3> points) {
  announced_.points(points.size());
  put_points(points_, points);
  points_ += points.size();
}

void StreamedWriter::tets(std::span<const Tet<std::uint32_t>> tets,
                          std::span<const std::int32_t> labels) {
  take(tets, labels);
}

void StreamedWriter::tets(std::span<const Tet<std::uint64_t>> tets,
                          std::span<const std::int32_t> labels) {
  take(tets, labels);
}

template <class Index>
void StreamedWriter::take(std::span<const Tet<Index>> tets,
                          std::span<const std::int32_t> labels) {
  announced_.tets(tets, labels);
  open_tets_once();
  std::array<Tet<std::uint64_t>, tets_at_once> wide;
  for (std::size_t begin = 0; begin < tets.size(); begin += tets_at_once) {
    const std::size_t count = std::min(tets_at_once, tets.size() - begin);
    for (std::size_t i = 0; i < count; ++i)
      std::ranges::copy(tets[begin + i], wide[i].begin());
    put_tets(tets_, std::span(wide).first(count),
             labels.empty() ? std::span(only_labels).first(count)
                            : labels.subspan(begin, count));
    tets_ += count;
  }
}

void StreamedWriter::open_tets_once() {
  if (!tets_opened_) open_tets();
  tets_opened_ = true;
}

void StreamedWriter::finish() {
  announced_.finish();
  open_tets_once();
  close();
  commit();
}

}  // namespace certet::formats
