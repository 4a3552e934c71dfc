#pragma once
/// \file
/// Patches and interfaces of a format that numbers them and has no names.

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "certet/formats.hpp"

namespace certet::formats {

/// The numbers of a mesh's triangles are those that our writers give them, as `Sheets` says.  A
/// file in which they are not means something else by them, and none of its faces is taken.
class NumberedPatches {
 public:
  void add(const std::array<std::uint64_t, 3>& face, std::int64_t number);

  /// Gives the mesh, all of which has been read, its surfaces and the faces of patches.
  void give(FileMesh& mesh);

 private:
  using Face = std::array<std::uint64_t, 3>;
  using Faces = std::vector<Face>;

  [[nodiscard]] bool is_side(const FileMesh& mesh, std::int64_t number, const Faces& faces) const;
  [[nodiscard]] bool may_have_sides(const FileMesh& mesh) const;
  bool give_all_patches(FileMesh& mesh) const;
  void give_border(FileMesh& mesh) const;

  std::map<std::int64_t, Faces> faces_;
};

}  // namespace certet::formats
