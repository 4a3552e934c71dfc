#pragma once
/// \file
/// Mesh files.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "certet/mesh.hpp"

namespace certet {

enum class Format {
  vtu,    ///< VTK XML unstructured grid, raw appended binary (.vtu)
  medit,  ///< MEDIT, ASCII (.mesh)
};

/// The format that a file name's extension stands for.
std::optional<Format> format_of(const std::filesystem::path& file);

/// All that a file says about its size, known before the first number is written.
struct MeshSize {
  std::uint64_t points = 0;
  std::uint64_t tets = 0;
  bool labels = false;  ///< whether there is a cell field `label`
};

/// Writes a mesh piece by piece, so that it never needs to be in memory whole:
/// first all points in order, then all tetrahedra in order, then `finish`.
/// The file grows under a temporary name beside its target and takes the
/// target's name in `finish`; a writer destroyed before that leaves nothing.
/// The bytes do not depend on how the mesh is cut in pieces.
/// All members throw Error `write_failed`; also where more or fewer points or
/// tetrahedra come than were announced, or an index without a point.
class MeshWriter {
 public:
  virtual ~MeshWriter() = default;
  virtual void points(std::span<const Point3> points) = 0;
  /// `labels` is empty or as long as `tets`.
  virtual void tets(std::span<const Tet<std::uint32_t>> tets,
                    std::span<const std::int32_t> labels) = 0;
  virtual void tets(std::span<const Tet<std::uint64_t>> tets,
                    std::span<const std::int32_t> labels) = 0;
  virtual void finish() = 0;
};

/// \throws Error `write_failed` if the file cannot be made: its folder is not
/// there or full, or the name is taken by a folder or by a read-only file.
std::unique_ptr<MeshWriter> open_writer(const std::filesystem::path& file, Format format,
                                        const MeshSize& size);

/// The exact size in bytes of a .vtu file, or an estimate for text formats.
std::uint64_t file_bytes(Format format, const MeshSize& size);

/// A mesh as a file holds it.
struct FileMesh {
  std::vector<Point3> points;
  std::vector<Tet<std::uint64_t>> tets;
  std::vector<std::int32_t> labels;  ///< empty, or one for each tetrahedron; a
                                     ///< MEDIT file of zeros alone has none
};

/// Reads what `open_writer` wrote, and looks at everything but whether the
/// indices are those of points: that is the task of `check`.
/// \throws Error `bad_input` with one sentence that names the file.
FileMesh read_mesh(const std::filesystem::path& file);

}  // namespace certet
