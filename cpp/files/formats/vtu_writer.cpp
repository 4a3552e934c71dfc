#include <algorithm>
#include <array>
#include <limits>

#include "announced.hpp"
#include "element_nodes.hpp"
#include "output_file.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "vtu_layout.hpp"

namespace certet::formats {
namespace {

/// Numbers that are made, or made narrower or wider, on their way to the file.
constexpr std::size_t values_at_once = 4096;

/// The bytes of an array, after its size.
class ArraySection {
 public:
  ArraySection(OutputFile& file, const VtuLayout& layout, const VtuArray& array)
      : section_(file, layout.place(array)) {
    section_.append_all(std::span<const std::uint64_t>(&array.bytes, 1));
  }

  template <class T>
  void append(std::span<const T> values) {
    section_.append_all(values);
  }

  /// Appends value(0), value(1), … value(count - 1).
  template <class T, class Value>
  void generate(std::uint64_t count, Value value) {
    std::array<T, values_at_once> values;
    for (std::uint64_t begin = 0; begin < count; begin += values_at_once) {
      const std::size_t size = std::min<std::uint64_t>(values_at_once, count - begin);
      for (std::size_t i = 0; i < size; ++i) values[i] = static_cast<T>(value(begin + i));
      append(std::span<const T>(values).first(size));
    }
  }

  void flush() { section_.flush(); }

 private:
  Section section_;
};

class VtuWriter final : public MeshWriter {
 public:
  VtuWriter(const std::filesystem::path& file, const MeshSize& size)
      : size_(size), layout_(size), file_(file), announced_(size, file_),
        points_(file_, layout_, layout_.points),
        connectivity_(file_, layout_, layout_.connectivity),
        offsets_(file_, layout_, layout_.offsets), types_(file_, layout_, layout_.types) {
    file_.reserve(layout_.file_bytes);
    file_.write_at(0, std::as_bytes(std::span(layout_.header)));
    if (size.labels) label_.emplace(file_, layout_, layout_.label);
  }

  void points(std::span<const Point3> points) override {
    announced_.points(points.size());
    points_.append(points);
  }
  void tets(std::span<const Tet<std::uint32_t>> tets,
            std::span<const std::int32_t> labels) override {
    append(tets, labels);
  }
  void tets(std::span<const Tet<std::uint64_t>> tets,
            std::span<const std::int32_t> labels) override {
    append(tets, labels);
  }
  void finish() override;

 private:
  template <class Index>
  void append(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels);
  template <class Index>
  void append_indices(std::span<const Tet<Index>> tets);
  template <class Stored, class Index>
  void append_nodes(std::span<const Tet<Index>> tets);
  void append_shapes(std::uint64_t tets);

  MeshSize size_;
  VtuLayout layout_;
  OutputFile file_;
  Announced announced_;
  ArraySection points_, connectivity_, offsets_, types_;
  std::optional<ArraySection> label_;
  std::uint64_t tets_ = 0;  ///< written so far
};

template <class Index>
void VtuWriter::append(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels) {
  announced_.tets(tets, labels);
  append_indices(tets);
  append_shapes(tets.size());
  if (label_) label_->append(labels);
}

template <class Index>
void VtuWriter::append_indices(std::span<const Tet<Index>> tets) {
  const bool wide = layout_.connectivity.is_64_bit();
  if (size_.middles != nullptr)
    return wide ? append_nodes<std::int64_t>(tets) : append_nodes<std::int32_t>(tets);
  if (wide == (sizeof(Index) == 8)) {
    connectivity_.append(tets);
    return;
  }
  const auto index = [tets](std::uint64_t i) { return tets[i / 4][i % 4]; };
  if (wide)
    connectivity_.generate<std::int64_t>(4 * tets.size(), index);
  else
    connectivity_.generate<std::int32_t>(4 * tets.size(), index);
}

template <class Stored, class Index>
void VtuWriter::append_nodes(std::span<const Tet<Index>> tets) {
  ElementNodes nodes(size_);
  for (const Tet<Index>& tet : tets) {
    std::array<Stored, 10> stored;
    std::ranges::transform(nodes.tet(tet), stored.begin(),
                           [](std::uint64_t node) { return static_cast<Stored>(node); });
    connectivity_.append(std::span<const Stored>(stored));
  }
}

/// Where each tetrahedron ends, and that it is one.
void VtuWriter::append_shapes(std::uint64_t tets) {
  const auto offset = [this](std::uint64_t i) { return layout_.per_tet * (tets_ + i + 1); };
  if (layout_.offsets.is_64_bit())
    offsets_.generate<std::int64_t>(tets, offset);
  else
    offsets_.generate<std::int32_t>(tets, offset);
  types_.generate<std::uint8_t>(tets, [this](std::uint64_t) { return layout_.cell_type; });
  tets_ += tets;
}

void VtuWriter::finish() {
  announced_.finish();
  for (ArraySection* section : {&points_, &connectivity_, &offsets_, &types_}) section->flush();
  if (label_) label_->flush();
  file_.write_at(layout_.file_bytes - layout_.footer.size(),
                 std::as_bytes(std::span(layout_.footer)));
  file_.commit();
}

}  // namespace

std::unique_ptr<MeshWriter> open_vtu(const std::filesystem::path& file, const MeshSize& size) {
  return std::make_unique<VtuWriter>(file, size);
}

std::uint64_t vtu_bytes(const MeshSize& size) { return VtuLayout(size).file_bytes; }

}  // namespace certet::formats
