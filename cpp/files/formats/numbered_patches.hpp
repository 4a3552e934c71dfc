#pragma once
/// \file
/// Patches and interfaces of a format that numbers them and has no names.

#include <array>
#include <cstdint>
#include <vector>

#include "certet/formats.hpp"

namespace certet::formats {

/// The numbers of a mesh's triangles are those that our writers give them, `Sheets::number_of`
/// and on.  A file in which they are not means something else by them, and none of its
/// faces is taken.
class NumberedPatches {
 public:
  void add(const std::array<std::uint64_t, 3>& face, std::int64_t number);

  /// The faces of `border` of the mesh, all of which has been read.
  std::vector<std::array<std::uint64_t, 3>> take(const FileMesh& mesh);

 private:
  using Faces = std::vector<std::array<std::uint64_t, 3>>;
  bool are_ours_ = true;
  Faces border_, inner_;
};

}  // namespace certet::formats
