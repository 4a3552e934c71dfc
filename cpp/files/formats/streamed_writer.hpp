#pragma once
/// \file
/// What the writers of all formats but .vtu have in common.

#include "announced.hpp"
#include "output_file.hpp"

namespace certet::formats {

/// Holds the caller to what was announced, brings indices to one width, gives
/// every tetrahedron a label, and counts.
class StreamedWriter : public MeshWriter {
 public:
  void points(std::span<const Point3> points) final;
  void tets(std::span<const Tet<std::uint32_t>> tets,
            std::span<const std::int32_t> labels) final;
  void tets(std::span<const Tet<std::uint64_t>> tets,
            std::span<const std::int32_t> labels) final;
  void finish() final;

 protected:
  StreamedWriter(const std::filesystem::path& file, const MeshSize& size)
      : StreamedWriter(file, file, size) {}
  /// Sentences name `asked_for` in the place of the file.
  StreamedWriter(const std::filesystem::path& file, const std::filesystem::path& asked_for,
                 const MeshSize& size)
      : size_(size), file_(file, asked_for), announced_(size, file_) {}

  /// Some points; the first of them has the number `first`.
  virtual void put_points(std::uint64_t first, std::span<const Point3> points) = 0;
  /// Called once, between the points and the tetrahedra.
  virtual void open_tets() {}
  /// Some tetrahedra, and a label for each.
  virtual void put_tets(std::uint64_t first, std::span<const Tet<std::uint64_t>> tets,
                        std::span<const std::int32_t> labels) = 0;
  /// All that is still missing goes to the file.
  virtual void close() = 0;
  /// The file takes its name.
  virtual void commit() { file_.commit(); }

  /// Of the mesh that is written; fails where there is none.
  [[nodiscard]] const Survey& survey() const {
    if (size_.survey == nullptr) file_.fail("the survey of its mesh was not announced");
    return *size_.survey;
  }

  const MeshSize size_;
  OutputFile file_;

 private:
  template <class Index>
  void take(std::span<const Tet<Index>> tets, std::span<const std::int32_t> labels);
  void open_tets_once();

  Announced announced_;
  std::uint64_t points_ = 0, tets_ = 0;  ///< put so far
  bool tets_opened_ = false;
};

}  // namespace certet::formats
