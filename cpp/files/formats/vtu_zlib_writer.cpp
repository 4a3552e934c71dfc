// A .vtu file whose arrays are packed block by block.

#include <optional>

#include "files/compression/blocks.hpp"
#include "certet/error.hpp"
#include "element_nodes.hpp"
#include "registry.hpp"
#include "section.hpp"
#include "streamed_writer.hpp"
#include "vtu_layout.hpp"

namespace certet::formats {
namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 18;

/// An array of which the length is known, but not how small it will be: a header
/// with the number of blocks, their bytes, those of the last one if it is not
/// full, and the packed bytes of each; then the blocks.
class PackedArray {
 public:
  PackedArray(OutputFile& file, std::uint64_t place, std::uint64_t bytes)
      : file_(file), place_(place) {
    const std::uint64_t blocks = (bytes + block_bytes - 1) / block_bytes;
    header_ = {blocks, block_bytes, bytes % block_bytes};
    header_.reserve(3 + blocks);
    out_.emplace(file, place + (3 + blocks) * sizeof(std::uint64_t));
    block_.reserve(std::min<std::uint64_t>(bytes, block_bytes));
  }

  void append(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const std::size_t count = std::min(bytes.size(), block_bytes - block_.size());
      block_.insert(block_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
      bytes = bytes.subspan(count);
      if (block_.size() == block_bytes) pack();
    }
  }
  template <class T>
  void append_number(T number) {
    append(std::as_bytes(std::span<const T>(&number, 1)));
  }

  /// After the last number.  \returns the place behind the array.
  std::uint64_t finish() {
    if (!block_.empty()) pack();
    out_->flush();
    file_.write_at(place_, std::as_bytes(std::span(header_)));
    return out_->end();
  }

 private:
  void pack() {
    const std::vector<std::byte> packed = compression::pack(block_);
    header_.push_back(packed.size());
    out_->append(packed);
    block_.clear();
  }

  OutputFile& file_;
  std::uint64_t place_;
  std::vector<std::uint64_t> header_;
  std::optional<Section> out_;
  std::vector<std::byte> block_;
};

class VtuZlibWriter final : public StreamedWriter {
 public:
  VtuZlibWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, size), layout_(size), begin_(longest_header()),
        points_(file_, begin_, layout_.points.bytes) {
    if (!size.labels) return;
    // The labels come together with the corners, but one array ends before the
    // next begins: they wait in a file that will never have a name.
    scratch_.emplace(file);
    labels_.emplace(*scratch_, 0, layout_.label.bytes);
  }

 private:
  /// Room for the XML, whatever the offsets in it will be.
  [[nodiscard]] std::uint64_t longest_header() const {
    VtuLayout layout = layout_;
    for (VtuArray* array : {&layout.points, &layout.connectivity, &layout.offsets,
                            &layout.types, &layout.label})
      array->offset = ~std::uint64_t{0};
    return vtu_header_of(layout, size_, true).size();
  }

  void put_points(std::uint64_t, std::span<const Point3> points) override {
    points_.append(std::as_bytes(points));
  }

  void open_tets() override {
    layout_.points.offset = 0;
    const std::uint64_t end = points_.finish();
    layout_.connectivity.offset = end - begin_;
    connectivity_.emplace(file_, end, layout_.connectivity.bytes);
  }

  void put_tets(std::uint64_t, std::span<const Tet<std::uint64_t>> tets,
                std::span<const std::int32_t> labels) override {
    ElementNodes nodes(size_);
    for (const auto& tet : tets) {
      const std::span<const std::uint64_t> own = nodes.tet(tet);
      if (layout_.connectivity.is_64_bit())
        connectivity_->append(std::as_bytes(own));
      else
        for (const std::uint64_t point : own)
          connectivity_->append_number(static_cast<std::int32_t>(point));
    }
    if (labels_) labels_->append(std::as_bytes(labels));
  }

  void close() override;
  std::uint64_t put_offsets(std::uint64_t place);
  std::uint64_t put_types(std::uint64_t place);
  std::uint64_t put_labels(std::uint64_t place);

  VtuLayout layout_;
  std::uint64_t begin_;  ///< of the data
  PackedArray points_;
  std::optional<PackedArray> connectivity_, labels_;
  std::optional<OutputFile> scratch_;
};

/// Where each tetrahedron ends in the connectivity.
std::uint64_t VtuZlibWriter::put_offsets(std::uint64_t place) {
  PackedArray array(file_, place, layout_.offsets.bytes);
  for (std::uint64_t i = 1; i <= size_.tets; ++i) {
    if (layout_.offsets.is_64_bit())
      array.append_number(static_cast<std::int64_t>(layout_.per_tet * i));
    else
      array.append_number(static_cast<std::int32_t>(layout_.per_tet * i));
  }
  return array.finish();
}

std::uint64_t VtuZlibWriter::put_types(std::uint64_t place) {
  PackedArray array(file_, place, layout_.types.bytes);
  for (std::uint64_t i = 0; i < size_.tets; ++i) array.append_number(layout_.cell_type);
  return array.finish();
}

/// Copies the labels from where they were packed.
std::uint64_t VtuZlibWriter::put_labels(std::uint64_t place) {
  const std::uint64_t bytes = labels_->finish();
  std::vector<std::byte> piece(block_bytes);
  for (std::uint64_t at = 0; at < bytes; at += piece.size()) {
    piece.resize(std::min<std::uint64_t>(piece.size(), bytes - at));
    scratch_->read_at(at, piece);
    file_.write_at(place + at, piece);
  }
  return place + bytes;
}

void VtuZlibWriter::close() {
  std::uint64_t end = connectivity_->finish();
  const auto place_next = [&](VtuArray& array, auto put) {
    array.offset = end - begin_;
    end = (this->*put)(end);
  };
  place_next(layout_.offsets, &VtuZlibWriter::put_offsets);
  place_next(layout_.types, &VtuZlibWriter::put_types);
  if (labels_) place_next(layout_.label, &VtuZlibWriter::put_labels);
  file_.write_at(end, std::as_bytes(std::span(layout_.footer)));
  // Blanks fill what the offsets left over, before the last line.
  std::string header = vtu_header_of(layout_, size_, true);
  header.insert(header.rfind('\n'), begin_ - header.size(), ' ');
  file_.write_at(0, std::as_bytes(std::span(header)));
}

}  // namespace

std::unique_ptr<MeshWriter> open_vtu_zlib(const std::filesystem::path& file,
                                          const MeshSize& size) {
  if (!can_compress()) throw Error(ErrorCode::bad_option, "compression was not built in");
  return std::make_unique<VtuZlibWriter>(file, size);
}

std::uint64_t vtu_zlib_bytes(const MeshSize& size) {
  // What is usual; it depends on the mesh.
  return VtuLayout(size).file_bytes / 4;
}

}  // namespace certet::formats
