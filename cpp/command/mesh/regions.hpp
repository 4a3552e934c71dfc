#pragma once
/// \file
/// Whether the labels of an image arrive in the mesh, and in one piece.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "source.hpp"

namespace certet::command {

/// A region, and what the mesh has of it.
struct MeshedRegion {
  ImageRegion region;
  std::uint64_t tets = 0;
  double volume = 0;        ///< of the mesh, in world units
  double voxel_volume = 0;  ///< of its voxels
  std::optional<double> change = {};  ///< by how much of that one `volume` differs, where all
                                      ///< of a label was to be meshed
  std::optional<PieceCount> pieces = {};  ///< of the mesh, if they were counted
};

/// Whether a mesh of the image has the pieces of some regions: of a level by the whole mesh,
/// of labels by the lattice points that have them, which their tetrahedra are around.
/// \throws Error `cancelled`.
bool keeps_pieces(const SolidVoxels& voxels, std::span<const ImageRegion> regions,
                  const PlacedDomain& domain, const Pieces& mesh, const Context& context);

/// Watches a run from the counted lattice to the written mesh.
class RegionWatch {
 public:
  /// Counts pieces where the lattice is coarse enough to lose some.
  /// \throws Error `cancelled`.
  RegionWatch(const Source& source, const PlacedSource& placed, const Context& context);

  /// The regions of the mesh that was written; without this there are none.
  void see(std::span<const Region> written);

  /// The pieces of the mesh, and those of each label that were counted; `dropped` tells that some were dropped from it.
  void see(const Pieces& pieces, std::span<const RegionPieces> regions, bool dropped);

  /// Of a mesh of `all_tets`; 0 tetrahedra everywhere if it was not written.
  [[nodiscard]] std::vector<MeshedRegion> regions(std::uint64_t all_tets) const;
  [[nodiscard]] bool counted_pieces() const { return counted_pieces_; }

  /// In the place of the last one where the pieces of the mesh are not known.
  void see_no_pieces();

  /// Sentences about what is lost, split or joined; `written` tells whether there
  /// are tetrahedra to go by, or lattice points alone.  `size_for` looks for a size that
  /// keeps the pieces of some regions, and is asked once at most.
  using SizeFor = std::function<KeepingSizes(std::span<const ImageRegion>)>;
  [[nodiscard]] std::vector<std::string> warnings(bool written, const SizeFor& size_for);

 private:
  [[nodiscard]] bool is_lost(std::size_t which, bool written) const;
  [[nodiscard]] std::string lost(std::size_t which);
  [[nodiscard]] bool keeps(std::size_t which) const;
  [[nodiscard]] std::string other_pieces(std::size_t which) const;
  [[nodiscard]] std::vector<std::string> other_volumes() const;
  [[nodiscard]] std::string size_for_pieces(const std::vector<ImageRegion>& changed,
                                            const SizeFor& size_for) const;

  const Source& source_;
  double size_, finest_ = 0;
  std::vector<ImageRegion> regions_;
  std::vector<std::uint64_t> tets_;  ///< of each region
  std::vector<double> volumes_;      ///< in world units
  std::vector<std::optional<PieceCount>> pieces_;  ///< of each region, in the mesh
  PieceCount whole_;                 ///< of the mesh
  bool counted_pieces_ = false, dropped_ = false;
};

}  // namespace certet::command
