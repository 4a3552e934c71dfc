// The tree of a grid: first all masks, and the values of inner nodes, from the root to
// the leaves; then the values of the leaves, in the order of their nodes.

#include <openvdb/openvdb.h>

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "vdb_parts.hpp"

namespace certet {
namespace {

using openvdb::io::COMPRESS_ACTIVE_MASK;
using openvdb::io::COMPRESS_BLOSC;
using openvdb::io::COMPRESS_ZIP;

constexpr std::uint64_t leaf_voxels = 512, upper_nodes = 32 * 32 * 32, lower_nodes = 16 * 16 * 16;
/// Voxels beyond are farther out than a lattice reaches, whatever its size.
constexpr std::int32_t farthest = 1 << 30, root_child = 4096;

using Origin = std::array<std::int32_t, 3>;

class VdbTree {
 public:
  VdbTree(const VdbPlace& at, const VdbGrid& grid)
      : at_(at), packing_(grid.packing),
        bytes_(grid.type == openvdb::DoubleGrid::gridType() ? 8 : 4),
        stored_bytes_(grid.half ? 2 : bytes_) {}

  void skip();

 private:
  /// A child of the root, and where its leaves are among all.
  struct Child {
    Origin origin;
    std::size_t begin, end;
  };

  void skip_root();
  Origin read_origin();
  template <std::size_t nodes>
  std::array<std::uint64_t, nodes / 64> read_mask();
  void skip_upper();
  void skip_lower();
  void skip_values(std::uint64_t count, std::uint64_t active);
  void skip_numbers(std::uint64_t count);

  const VdbPlace& at_;
  std::uint32_t packing_;
  std::uint64_t bytes_, stored_bytes_;  ///< of a number, in memory and in the file
  std::vector<Child> children_;
  std::vector<std::uint16_t> active_;  ///< voxels of each leaf
};

template <std::size_t count>
std::uint64_t ones(const std::array<std::uint64_t, count>& mask) {
  std::uint64_t result = 0;
  for (const std::uint64_t word : mask) result += static_cast<std::uint64_t>(std::popcount(word));
  return result;
}

Origin VdbTree::read_origin() {
  Origin origin;
  for (std::int32_t& number : origin) {
    number = at_.number<std::int32_t>();
    if (number % root_child != 0 || number < -farthest || number > farthest)
      at_.fail("a node of a tree is not where one can be");
  }
  return origin;
}

template <std::size_t nodes>
std::array<std::uint64_t, nodes / 64> VdbTree::read_mask() {
  std::array<std::uint64_t, nodes / 64> mask;
  at_.cursor.bytes(std::as_writable_bytes(std::span(mask)));
  return mask;
}

void VdbTree::skip_numbers(std::uint64_t count) {
  const std::uint64_t bytes = count * stored_bytes_;
  if (bytes == 0 && stored_bytes_ != bytes_) return;  // of halves, where there are none
  if ((packing_ & (COMPRESS_BLOSC | COMPRESS_ZIP)) == 0) return at_.cursor.skip(bytes);
  const auto packed = at_.number<std::int64_t>();
  if (packed <= 0) {  // as they are, since they did not become smaller
    if (static_cast<std::uint64_t>(-(packed + 1)) + 1 != bytes && !(packed == 0 && bytes == 0))
      at_.fail("packed numbers have a size that cannot be");
    return at_.cursor.skip(bytes);
  }
  if (packing_ & COMPRESS_BLOSC)
    return skip_blosc(at_, static_cast<std::uint64_t>(packed), bytes);
  at_.cursor.skip(static_cast<std::uint64_t>(packed));
}

/// Those of a node, of which some are active: where the others have two values at most,
/// these are before the active ones.
void VdbTree::skip_values(std::uint64_t count, std::uint64_t active) {
  enum : std::uint8_t { one_value = 2, mask_alone = 3, mask_and_one = 4, mask_and_two = 5, all = 6 };
  const auto form = at_.number<std::uint8_t>();
  if (form > all) at_.fail("a node has values of no known form");
  if (form == one_value || form == mask_and_one) at_.cursor.skip(bytes_);
  if (form == mask_and_two) at_.cursor.skip(2 * bytes_);
  if (form >= mask_alone && form <= mask_and_two) at_.cursor.skip(count / 8);
  skip_numbers((packing_ & COMPRESS_ACTIVE_MASK) != 0 && form != all ? active : count);
}

void VdbTree::skip_lower() {
  const auto children = read_mask<lower_nodes>();
  const auto active = read_mask<lower_nodes>();
  skip_values(lower_nodes, ones(active));
  for (std::uint64_t left = ones(children); left > 0; --left)
    active_.push_back(static_cast<std::uint16_t>(ones(read_mask<leaf_voxels>())));
}

void VdbTree::skip_upper() {
  const auto children = read_mask<upper_nodes>();
  const auto active = read_mask<upper_nodes>();
  skip_values(upper_nodes, ones(active));
  for (std::uint64_t left = ones(children); left > 0; --left) skip_lower();
}

void VdbTree::skip_root() {
  if (at_.number<std::int32_t>() != 1) at_.fail("a tree has several buffers");
  at_.cursor.skip(bytes_);  // the background
  const std::uint64_t announced_tiles = at_.number<std::uint32_t>();
  const std::uint64_t announced = at_.number<std::uint32_t>();
  const auto tiles = at_.cursor.checked(announced_tiles, 3 * 4 + bytes_ + 1, "tiles");
  std::vector<Origin> origins;
  for (std::uint64_t n = 0; n < tiles; ++n) {
    origins.push_back(read_origin());
    at_.cursor.skip(bytes_);
    static_cast<void>(at_.flag());
  }
  const auto children =
      at_.cursor.checked(announced, 3 * 4 + 2 * upper_nodes / 8, "nodes");
  for (std::uint64_t n = 0; n < children; ++n) {
    origins.push_back(read_origin());
    const std::size_t begin = active_.size();
    skip_upper();
    children_.push_back({origins.back(), begin, active_.size()});
  }
  std::ranges::sort(origins);
  if (std::ranges::adjacent_find(origins) != origins.end())
    at_.fail("two nodes of a tree are at one place");
}

void VdbTree::skip() {
  skip_root();
  std::ranges::sort(children_, {}, &Child::origin);  // as the leaves' values come
  for (const Child& child : children_)
    for (std::size_t leaf = child.begin; leaf < child.end; ++leaf) {
      if (ones(read_mask<leaf_voxels>()) != active_[leaf])
        at_.fail("a leaf of a tree has two masks");
      skip_values(leaf_voxels, active_[leaf]);
    }
}

}  // namespace

void skip_tree(const VdbPlace& at, const VdbGrid& grid) { VdbTree(at, grid).skip(); }

}  // namespace certet
