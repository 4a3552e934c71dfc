#include "vdb_file.hpp"

#include <openvdb/openvdb.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "vdb_parts.hpp"

namespace certet {
namespace {

constexpr char separator = '\x1e';
constexpr std::string_view half_suffix = "_HalfFloat";

/// OpenVDB takes blanks before it for none of it.
bool is_identifier(const std::array<char, 36>& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool dash = i == 8 || i == 13 || i == 18 || i == 23;
    if (dash ? text[i] != '-' : std::isxdigit(static_cast<unsigned char>(text[i])) == 0)
      return false;
  }
  return true;
}

}  // namespace

std::string VdbGrid::name() const { return unique_name.substr(0, unique_name.find(separator)); }

bool VdbGrid::is_real() const {
  return type == openvdb::FloatGrid::gridType() || type == openvdb::DoubleGrid::gridType();
}

VdbFile::VdbFile(const std::filesystem::path& file) : file_(file), cursor_(file_) {
  read_head();
  read_grids();
}

void VdbFile::read_head() {
  const VdbPlace at{file_, cursor_};
  if (file_.size() < 8 || at.number<std::int64_t>() != openvdb::OPENVDB_MAGIC)
    file_.fail("it is not an OpenVDB file");
  const auto version = at.number<std::uint32_t>();
  if (version < openvdb::OPENVDB_FILE_VERSION_NODE_MASK_COMPRESSION)
    file_.fail("it has version " + std::to_string(version) +
               " of OpenVDB's format; read are those from 222 on, and OpenVDB up to 12 can write it anew");
  if (version > openvdb::OPENVDB_FILE_VERSION)
    file_.fail("it has version " + std::to_string(version) + " of OpenVDB's format, newer than " +
               std::to_string(openvdb::OPENVDB_FILE_VERSION) + ", which is the newest known here");
  cursor_.skip(8);  // the library's own version
  has_offsets_ = at.flag();
  std::array<char, 36> identifier;
  cursor_.bytes(std::as_writable_bytes(std::span(identifier)));
  if (!is_identifier(identifier)) at.fail("it has no identifier");
  skip_metadata(at);
}

void VdbFile::read_grids() {
  const VdbPlace at{file_, cursor_};
  const auto count = at.number<std::int32_t>();
  constexpr std::uint64_t least_bytes = 3 * 4 + 3 * 8;
  if (count < 0) at.fail("it has a negative number of grids");
  cursor_.checked(static_cast<std::uint64_t>(count), least_bytes, "grids");
  for (std::int32_t n = 0; n < count; ++n) {
    VdbGrid grid = read_descriptor();
    const auto same = std::ranges::find(grids_, grid.unique_name, &VdbGrid::unique_name);
    if (same != grids_.end()) at.fail("two of its grids have the same name");
    if (has_offsets_) {
      cursor_.go_to(grid.end);
    } else {
      read_grid_head(grid);
      if (grid.parent.empty() && !grid.is_real())
        file_.fail("it is a stream, in which a grid of another kind than real numbers comes before "
                   "the end; write it as a file");
      if (grid.parent.empty()) check_tree(grid);
    }
    grids_.push_back(std::move(grid));
  }
  if (!has_offsets_) return;
  for (VdbGrid& grid : grids_) {
    cursor_.go_to(grid.begin);
    read_grid_head(grid);
  }
}

VdbGrid VdbFile::read_descriptor() {
  const VdbPlace at{file_, cursor_};
  VdbGrid grid;
  grid.unique_name = at.text();
  grid.type = at.text();
  grid.parent = at.text();
  if (grid.type.ends_with(half_suffix)) {
    grid.half = true;
    grid.type.resize(grid.type.size() - half_suffix.size());
  }
  grid.begin = at.number<std::uint64_t>();
  cursor_.skip(8);  // where its numbers begin
  grid.end = at.number<std::uint64_t>();
  if (!has_offsets_) return grid;
  // The grid is behind its descriptor, and the next descriptor behind the grid.
  if (grid.begin < cursor_.position() || grid.end < grid.begin || grid.end > file_.size())
    at.fail("a grid is not where it should be");
  return grid;
}

void VdbFile::read_grid_head(VdbGrid& grid) {
  namespace io = openvdb::io;
  const VdbPlace at{file_, cursor_};
  grid.packing = at.number<std::uint32_t>();
  if (grid.packing > (io::COMPRESS_ZIP | io::COMPRESS_ACTIVE_MASK | io::COMPRESS_BLOSC))
    at.fail("a grid is packed in a way that is not known");
  if (skip_metadata(at) != grid.half) at.fail("it is not clear whether a grid's numbers are halves");
  skip_transform(at);
  grid.tree = cursor_.position();
}

void VdbFile::check_tree(const VdbGrid& grid) {
  const VdbPlace at{file_, cursor_};
  cursor_.go_to(grid.tree);
  skip_tree(at, grid);
  if (has_offsets_ && cursor_.position() > grid.end) at.fail("a grid is longer than it should be");
}

void VdbFile::check_trees(const std::string& name) {
  if (!has_offsets_) return;
  for (const VdbGrid& grid : grids_) {
    if (!name.starts_with(grid.name()) || !grid.is_real()) continue;
    if (grid.parent.empty()) {
      check_tree(grid);
      continue;
    }
    const auto parent = std::ranges::find(grids_, grid.parent, &VdbGrid::unique_name);
    if (parent == grids_.end() || parent->type != grid.type || !parent->parent.empty())
      VdbPlace{file_, cursor_}.fail("a grid has the tree of one that is not there");
    check_tree(*parent);
  }
}

}  // namespace certet
