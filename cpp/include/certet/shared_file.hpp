#pragma once
/// \file
/// One mesh file that several write, each what it has of the mesh.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "certet/formats.hpp"

namespace certet {

/// A file whose bytes come in any order.  Members throw Error `write_failed` with a sentence that
/// names it.
class WritableFile {
 public:
  virtual ~WritableFile() = default;
  virtual void write_at(std::uint64_t offset, std::span<const std::byte> bytes) = 0;
  [[noreturn]] virtual void fail(const std::string& reason) const = 0;
};

/// The same file, of one rank's own: ranks write bytes that no other one does.
class SharedFile : public WritableFile {
 public:
  /// Comes back when all ranks have called it and the file is there, whole.
  virtual void commit() = 0;
};

/// What a rank has of a mesh.
struct MeshPart {
  std::uint64_t first_point = 0, points = 0, first_tet = 0, tets = 0;
  bool is_first = false;  ///< whether it writes what comes but once, too
};

/// Writes a rank's part of a .vtu file, the bytes of which are those that one writer of the whole
/// mesh, which has `size`, would write.  Tetrahedra have four nodes.  `finish` is called by all.
/// \throws Error as `open_writer`.
std::unique_ptr<MeshWriter> open_part_writer(std::unique_ptr<SharedFile> file,
                                             const MeshSize& size, const MeshPart& part);

}  // namespace certet
