#pragma once
/// \file
/// What a mesh keeps of its shape, its volume and its pieces, and a size at which it keeps
/// them.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "certet/context.hpp"
#include "certet/frame.hpp"
#include "certet/pieces.hpp"
#include "certet/placed_domain.hpp"
#include "certet/stuffing.hpp"

namespace certet {

/// The volume of a shape.
struct ShapeVolume {
  double volume = 0;  ///< world units cubed
  double doubt = 0;   ///< how far it may be off; 0 where there is a formula
  bool exact = false;

  /// Whether it may be the volume of the mesh, but for a fiftieth, which is not told.
  [[nodiscard]] bool may_be(double mesh_volume) const;
  /// Whether it is, as far as one can know.
  [[nodiscard]] bool surely_is(double mesh_volume) const;
};

/// The volume of a counted mesh, in world units cubed; no tetrahedron is kept.
/// \throws Error `cancelled`, `too_large`.
double volume_of(const Stuffing& stuffing, const Frame& frame, Context& context);

/// How many pieces a shape has by itself; nothing where that is not known.
using KnownPieces = std::function<std::optional<PieceBounds>(Context&)>;

/// A shape that can be put on lattices of several sizes, one after the other.
struct SizedShape {
  std::string name;  ///< what sentences call it
  /// `size` is the long edge in world units.  \throws Error, `too_large` where memory
  /// does not allow its lattice.
  std::function<std::shared_ptr<const PlacedDomain>(double size)> place;
  std::optional<double> volume = {};  ///< world units cubed, where it is known exactly
  double thin = 0;                    ///< how thick its thin parts are; 0: not known
  /// Where it is empty, pieces are not compared.  Where it gives nothing, they are with
  /// those that a lattice of a quarter of the size finds, or of half of it, where that is not
  /// too much to sample beside the mesh; where it is, `Losses::uncompared` says so.
  KnownPieces pieces = {};
  double cost = 1;  ///< of asking about a point; 1: as much as of a formula
};

/// Its own volume, or estimated by asking it on a lattice, at less cost than a mesh.
/// \throws Error `cancelled`; what the shape throws.
ShapeVolume volume_of(const SizedShape& shape, const PlacedDomain& domain,
                      const Context& context);

/// Its mesh.
struct MeshedShape {
  const PlacedDomain& domain;
  Method method = default_method;  ///< that was asked for
  std::uint64_t tets = 0;
  double volume = 0;                     ///< world units cubed
  std::optional<PieceCount> pieces = {}; ///< where they are to be compared
};

/// A shape on the lattice of one size, and its mesh, counted but not made.
struct CountedShape {
  std::shared_ptr<const PlacedDomain> domain;
  Stuffing stuffing;
};

/// A size that was tried.
struct TriedSize {
  double size = 0;
  std::uint64_t tets = 0;
  double share = 0;          ///< of the shape's volume
  std::uint64_t pieces = 0;  ///< of the mesh, by faces
};

/// A size, and how large the mesh is.
struct MeshedSize {
  double size = 0;
  std::uint64_t tets = 0;
};

/// What was found at the end of a search: the largest size tried that does, and the smallest
/// one tried, of size 0 if there was none.
struct KeepingSizes {
  std::optional<TriedSize> kept;
  TriedSize finest;
};

/// Counts meshes of a shape at smaller and smaller sizes than that of one, each of four
/// digits, until `keeps` says so of one; it may fill in the share and the pieces.  Gives up
/// where meshes have more than ten million tetrahedra, or their lattices, all together, more
/// than some hundred million cells.
/// \throws Error `cancelled`; what the shape throws, but for `too_large`.
KeepingSizes find_keeping_size(const SizedShape& shape, const MeshedSize& coarse, Method method,
                               const std::function<bool(const CountedShape&, TriedSize&)>& keeps,
                               Context& context);

/// A mesh with other pieces than its shape.
struct OtherPieces {
  PieceCount mesh;
  PieceBounds shape;
  double finer_size = 0;  ///< of the lattice that has the shape's; 0: they are known by itself
};

/// A mesh with another volume than its shape.
struct OtherVolume {
  double mesh = 0;
  ShapeVolume shape;
};

/// Pieces that were not compared, since finer samples would take longer than the mesh.
struct UncomparedPieces {
  double size = 0;   ///< of the finer lattice
  double cells = 0;  ///< of it, that would have to be looked at
};

/// What a mesh has not kept, and a size that keeps it.
struct Losses {
  std::optional<OtherVolume> volume;
  std::optional<OtherPieces> pieces;
  std::optional<UncomparedPieces> uncompared = {};  ///< which is no loss that is known
  KeepingSizes sizes;  ///< that keep both, if one of them is not kept

  [[nodiscard]] bool any() const { return volume || pieces; }
};

/// Compares the volume, to a fiftieth, and the pieces of a mesh with its shape's.  Only where
/// one of them is another is a size looked for.
/// \throws Error as `find_keeping_size`.
Losses find_losses(const SizedShape& shape, const MeshedShape& mesh, Context& context);

/// A sentence for each loss; `size` is what the user writes before a size: "--size ".
std::vector<std::string> sentences_on(const Losses& losses, const SizedShape& shape,
                                      std::string_view size);

/// That losses of pieces were not looked for, and what it would take.
std::string sentence_on(const UncomparedPieces& uncompared);

/// Of a shape that has no mesh at a size: a smaller one at which its mesh has its volume.
/// \throws Error as `find_keeping_size`.
KeepingSizes find_volume_size(const SizedShape& shape, double size, Method method,
                              Context& context);

/// What was found, as the end of a sentence.
std::string advice_on_volume(const KeepingSizes& sizes, const SizedShape& shape,
                             std::string_view size);
std::string advice_on_pieces(const KeepingSizes& sizes, std::string_view size);

}  // namespace certet
