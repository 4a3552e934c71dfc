#include <algorithm>
#include <utility>

#include "certet/kept.hpp"
#include "finer_pieces.hpp"

namespace certet {
namespace {

/// Where a size is looked for.
constexpr double most_searched_cells = 1.6e7;

class Comparison {
 public:
  Comparison(const SizedShape& shape, const MeshedShape& mesh, Context& context)
      : shape_(shape), mesh_(mesh), context_(context) {
    const ShapeVolume volume = volume_of(shape, mesh.domain, context);
    if (volume.volume > 0 && !volume.may_be(mesh.volume))
      losses_.volume = OtherVolume{mesh.volume, volume};
    compares_pieces_ = shape.pieces && mesh.pieces;
    if (compares_pieces_) compare_pieces();
  }

  Losses find() && {
    if (losses_.any())
      losses_.sizes = find_keeping_size(
          shape_, {mesh_.domain.frame().size, mesh_.tets}, mesh_.method,
          [this](const CountedShape& counted, TriedSize& tried) { return keeps(counted, tried); },
          context_);
    return std::move(losses_);
  }

 private:
  void compare_pieces() {
    known_ = shape_.pieces(context_);
    if (known_) {
      if (!may_be(*known_, *mesh_.pieces)) losses_.pieces = OtherPieces{*mesh_.pieces, *known_};
      return;
    }
    const auto finer = core::finer_pieces(shape_, mesh_, context_);
    compares_pieces_ = std::holds_alternative<core::FinerPieces>(finer);
    if (!compares_pieces_) {
      losses_.uncompared = std::get<UncomparedPieces>(finer);
      return;
    }
    finer_ = std::get<core::FinerPieces>(finer);
    const PieceBounds sampled{finer_->pieces, finer_->pieces};
    if (!may_be(sampled, *mesh_.pieces))
      losses_.pieces = OtherPieces{*mesh_.pieces, sampled, finer_->size};
  }

  bool keeps(const CountedShape& counted, TriedSize& tried) {
    return keeps_volume(counted, tried) && keeps_pieces(counted, tried);
  }

  bool keeps_volume(const CountedShape& counted, TriedSize& tried) {
    const ShapeVolume solid = volume_of(shape_, *counted.domain, context_);
    const double mesh = volume_of(counted.stuffing, counted.domain->frame(), context_);
    if (!(solid.volume > 0)) return !losses_.volume;
    tried.share = mesh / solid.volume;
    return losses_.volume ? solid.surely_is(mesh) : solid.may_be(mesh);
  }

  bool keeps_pieces(const CountedShape& counted, TriedSize& tried) {
    if (!compares_pieces_) return true;
    const Frame& frame = counted.domain->frame();
    const PieceCount mesh = counted.stuffing.pieces(frame, context_).whole;
    tried.pieces = mesh.by_faces;
    if (known_) return may_be(*known_, mesh);
    // Where finer samples had others, a size below theirs may have others again.
    if (mesh.by_faces != finer_->pieces && frame.size > finer_->size) return false;
    return core::pieces_at(shape_, frame.size / 2, mesh_.method, most_searched_cells, context_) ==
           mesh.by_faces;
  }

  const SizedShape& shape_;
  const MeshedShape& mesh_;
  Context& context_;
  bool compares_pieces_ = false;
  std::optional<PieceBounds> known_;
  std::optional<core::FinerPieces> finer_;  ///< where they are not known
  Losses losses_;
};

}  // namespace

Losses find_losses(const SizedShape& shape, const MeshedShape& mesh, Context& context) {
  return Comparison(shape, mesh, context).find();
}

KeepingSizes find_volume_size(const SizedShape& shape, double size, Method method,
                              Context& context) {
  const auto keeps = [&](const CountedShape& counted, TriedSize& tried) {
    const ShapeVolume solid = volume_of(shape, *counted.domain, context);
    const double mesh = volume_of(counted.stuffing, counted.domain->frame(), context);
    if (solid.volume > 0) tried.share = mesh / solid.volume;
    return solid.surely_is(mesh);
  };
  return find_keeping_size(shape, {size, 0}, method, keeps, context);
}

}  // namespace certet
