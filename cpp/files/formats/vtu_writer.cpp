#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "certet/error.hpp"
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
  /// Behind so many of its `all` numbers, or things of equally many, that others write; the size is
  /// written by the first.
  ArraySection(WritableFile& file, const VtuLayout& layout, const VtuArray& array,
               std::uint64_t before, std::uint64_t all, bool is_first)
      : section_(file, layout.place(array) +
                           (is_first ? 0 : sizeof(std::uint64_t) + array.bytes / std::max<std::uint64_t>(all, 1) * before)) {
    if (is_first) section_.append_all(std::span<const std::uint64_t>(&array.bytes, 1));
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

/// What one of several writes of the arrays, or one alone.
class VtuArrays {
 public:
  VtuArrays(WritableFile& file, const MeshSize& size, const MeshPart& part)
      : file_(file), size_(size), part_(part), layout_(size), announced_(size, part, file),
        points_(of_points(layout_.points)), connectivity_(of_tets(layout_.connectivity)),
        offsets_(of_tets(layout_.offsets)), types_(of_tets(layout_.types)), tets_(part.first_tet) {
    if (part.is_first) file.write_at(0, std::as_bytes(std::span(layout_.header)));
    if (size.labels) label_.emplace(of_tets(layout_.label));
  }

  void points(std::span<const Point3> points) {
    announced_.points(points.size());
    points_.append(points);
  }
  template <class Index>
  void tets(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels);
  void finish();

 private:
  [[nodiscard]] ArraySection of_points(const VtuArray& array) const {
    return {file_, layout_, array, part_.first_point, size_.points, part_.is_first};
  }
  [[nodiscard]] ArraySection of_tets(const VtuArray& array) const {
    return {file_, layout_, array, part_.first_tet, size_.tets, part_.is_first};
  }
  template <class Index>
  void append_indices(std::span<const Tet<Index>> tets);
  template <class Stored, class Index>
  void append_nodes(std::span<const Tet<Index>> tets);
  void append_shapes(std::uint64_t tets);

  WritableFile& file_;
  MeshSize size_;
  MeshPart part_;
  VtuLayout layout_;
  Announced announced_;
  ArraySection points_, connectivity_, offsets_, types_;
  std::optional<ArraySection> label_;
  std::uint64_t tets_;  ///< the number of the next one
};

template <class Index>
void VtuArrays::tets(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels) {
  announced_.tets(tets, labels);
  append_indices(tets);
  append_shapes(tets.size());
  if (label_) label_->append(labels);
}

template <class Index>
void VtuArrays::append_indices(std::span<const Tet<Index>> tets) {
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
void VtuArrays::append_nodes(std::span<const Tet<Index>> tets) {
  ElementNodes nodes(size_);
  for (const Tet<Index>& tet : tets) {
    std::array<Stored, 10> stored;
    std::ranges::transform(nodes.tet(tet), stored.begin(),
                           [](std::uint64_t node) { return static_cast<Stored>(node); });
    connectivity_.append(std::span<const Stored>(stored));
  }
}

/// Where each tetrahedron ends, and that it is one.
void VtuArrays::append_shapes(std::uint64_t tets) {
  const auto offset = [this](std::uint64_t i) { return layout_.per_tet * (tets_ + i + 1); };
  if (layout_.offsets.is_64_bit())
    offsets_.generate<std::int64_t>(tets, offset);
  else
    offsets_.generate<std::int32_t>(tets, offset);
  types_.generate<std::uint8_t>(tets, [this](std::uint64_t) { return layout_.cell_type; });
  tets_ += tets;
}

void VtuArrays::finish() {
  announced_.finish();
  for (ArraySection* section : {&points_, &connectivity_, &offsets_, &types_}) section->flush();
  if (label_) label_->flush();
  if (part_.is_first)
    file_.write_at(layout_.file_bytes - layout_.footer.size(),
                   std::as_bytes(std::span(layout_.footer)));
}

/// `File` is what they are written to.
template <class File>
class VtuWriter final : public MeshWriter {
 public:
  VtuWriter(std::unique_ptr<File> file, const MeshSize& size, const MeshPart& part)
      : file_(std::move(file)), arrays_(*file_, size, part) {}

  void points(std::span<const Point3> points) override { arrays_.points(points); }
  void tets(std::span<const Tet<std::uint32_t>> tets,
            std::span<const std::int32_t> labels) override {
    arrays_.tets(tets, labels);
  }
  void tets(std::span<const Tet<std::uint64_t>> tets,
            std::span<const std::int32_t> labels) override {
    arrays_.tets(tets, labels);
  }
  void finish() override {
    arrays_.finish();
    file_->commit();
  }

 private:
  std::unique_ptr<File> file_;
  VtuArrays arrays_;
};

}  // namespace

std::unique_ptr<MeshWriter> open_vtu(const std::filesystem::path& file, const MeshSize& size) {
  auto whole = std::make_unique<OutputFile>(file);
  whole->reserve(vtu_bytes(size));
  return std::make_unique<VtuWriter<OutputFile>>(
      std::move(whole), size, MeshPart{0, size.points, 0, size.tets, true});
}

std::uint64_t vtu_bytes(const MeshSize& size) { return VtuLayout(size).file_bytes; }

}  // namespace certet::formats

namespace certet {

std::unique_ptr<MeshWriter> open_part_writer(std::unique_ptr<SharedFile> file,
                                             const MeshSize& size, const MeshPart& part) {
  if (size.middles != nullptr)
    throw Error(ErrorCode::bad_option, "several ranks write no tetrahedra of ten nodes");
  return std::make_unique<formats::VtuWriter<SharedFile>>(std::move(file), size, part);
}

}  // namespace certet
