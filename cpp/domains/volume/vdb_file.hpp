#pragma once
/// \file
/// What a .vdb file says of itself, looked at before OpenVDB reads it: OpenVDB believes
/// every count and size, and goes on with numbers that it could not read where the file
/// ends.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "files/formats/cursor.hpp"
#include "files/formats/input_file.hpp"

namespace certet {

/// A grid as the file announces it.
struct VdbGrid {
  std::string unique_name;  ///< with a number behind a separator where names are equal
  std::string type;         ///< without what says that its numbers are halves
  std::string parent;       ///< whose tree it has, or none
  bool half = false;
  std::uint64_t begin = 0, end = 0;  ///< in the file
  std::uint64_t tree = 0;            ///< where its tree begins
  std::uint32_t packing = 0;         ///< openvdb::io's flags of compression

  [[nodiscard]] std::string name() const;
  [[nodiscard]] bool is_real() const;  ///< whether it is a grid that can be read
};

/// All members throw Error `bad_input` where the file is not as OpenVDB writes it.
class VdbFile {
 public:
  /// Looks at all that OpenVDB reads when it opens the file, and for the metadata of all
  /// grids: headers, names, metadata, transforms; in files that are streams, where OpenVDB
  /// reads all then, the trees too.  OpenVDB must be initialised.
  explicit VdbFile(const std::filesystem::path& file);

  /// Looks at the trees that OpenVDB may read for a grid of this name; a number in
  /// brackets may be behind the name.
  void check_trees(const std::string& name);

 private:
  void read_head();
  void read_grids();
  VdbGrid read_descriptor();
  void read_grid_head(VdbGrid& grid);
  void check_tree(const VdbGrid& grid);

  formats::InputFile file_;
  formats::Cursor cursor_;
  bool has_offsets_ = true;
  std::vector<VdbGrid> grids_;
};

}  // namespace certet
