#pragma once
/// \file
/// Tetrahedra of ten nodes on their way from a file.

#include <cstdint>

#include "certet/formats.hpp"
#include "element_nodes.hpp"
#include "input_file.hpp"

namespace certet::formats {

/// Puts the node number `place` of a tetrahedron, counted from 0, where it belongs: in `tets`, which
/// grows by the first, or in `middles`, which grows by the fifth.
inline void take_node(FileMesh& mesh, std::size_t place, std::uint64_t point) {
  if (place == 0) mesh.tets.emplace_back();
  if (place < 4) {
    mesh.tets.back()[place] = point;
    return;
  }
  if (place == 4) mesh.middles.emplace_back();
  mesh.middles.back()[place - 4] = point;
}

/// After all of a file was read, with middle nodes among the points and in the order of the
/// format: makes them what `FileMesh` says, and numbers all anew.  Does nothing where there are
/// none.  Fails, by the file, where some tetrahedra have no middle nodes, or a node is one
/// and a corner too.
void part_middle_nodes(FileMesh& mesh, const EdgeOrder& order, const InputFile& file);

}  // namespace certet::formats
