#include "tread_faces.hpp"

#include "fields/field_tile.hpp"

namespace certet::fields {
namespace {

/// Shorter ones smoothing alone makes a slope of.
constexpr std::int64_t shortest = 4;
constexpr std::int64_t longest = 32;

}  // namespace

TreadFaces::TreadFaces(const Layers& layers, std::size_t normal)
    : layers_(layers),
      strides_{layers.stride((normal + 1) % 3), layers.stride((normal + 2) % 3)},
      face_at_(static_cast<std::size_t>(layers.layer_size())) {}

/// In the margin no labels meet.
void TreadFaces::find(std::int64_t below) {
  below_ = layers_.layer(below);
  faces_.clear();
  for (auto& treads : treads_) treads.clear();
  const Material* above = layers_.layer(below + 1);
  for (std::int64_t at = 0; at < layers_.layer_size(); ++at) {
    face_at_[static_cast<std::size_t>(at)] = none;
    if (below_[at] != above[at]) add(at);
  }
  for (std::size_t kind = 0; kind < treads_.size(); ++kind)
    for (std::size_t t = 0; t < treads_[kind].size(); ++t) end(t, kind);
}

/// To the treads of the faces before it, where these go on.
void TreadFaces::add(std::int64_t in_layer) {
  Face face{in_layer, {}};
  for (std::size_t kind = 0; kind < treads_.size(); ++kind) {
    const bool above = kind % 2 == 1;
    const std::int64_t before = in_layer - strides_[kind / 2];
    const std::uint32_t last = face_at_[static_cast<std::size_t>(before)];
    auto& treads = treads_[kind];
    if (last != none && at(above, before) == at(above, in_layer)) {
      face.treads[kind] = faces_[last].treads[kind];
      ++treads[face.treads[kind]].length;
    } else {
      face.treads[kind] = static_cast<std::uint32_t>(treads.size());
      treads.push_back({in_layer, 1, 0});
    }
  }
  face_at_[static_cast<std::size_t>(in_layer)] = static_cast<std::uint32_t>(faces_.size());
  faces_.push_back(face);
}

/// A step to another label there is none of a slope.  With one label below it is the
/// same, seen from the other side.
TreadFaces::Step TreadFaces::step(std::int64_t from, std::int64_t to, bool above) const {
  const auto seen = [&](std::int64_t height, std::int64_t in_layer) {
    return at(above ? height : 1 - height, in_layer);
  };
  const Material label = seen(1, from), rest = seen(0, from);
  if (seen(0, to) != label)
    return seen(1, to) == rest && seen(2, to) == label ? above ? Step::up : Step::down : Step::wall;
  return seen(1, to) == label && seen(-1, to) == rest ? above ? Step::down : Step::up : Step::wall;
}

void TreadFaces::end(std::size_t number, std::size_t kind) {
  Tread& tread = treads_[kind][number];
  if (tread.length < shortest || tread.length > longest) return;
  const bool above = kind % 2 == 1;
  const std::int64_t stride = strides_[kind / 2];
  const std::int64_t last = tread.first + (tread.length - 1) * stride;
  const Step before = step(tread.first, tread.first - stride, above);
  const Step after = step(last, last + stride, above);
  if (before == Step::wall || after == Step::wall || before == after) return;
  tread.rise = after == Step::up ? 1 : -1;
}

std::int32_t TreadFaces::depth_of(const Face& face, bool upwards) const {
  std::int64_t length = longest + 1;
  std::int64_t depth = 0;
  for (std::size_t axis = 0; axis < 2; ++axis)
    for (const bool ahead : {true, false}) {  // its label is that ahead
      const std::size_t kind = 2 * axis + (ahead == upwards ? 1 : 0);
      const Tread& tread = treads_[kind][face.treads[kind]];
      if (tread.rise == 0 || tread.length >= length) continue;
      length = tread.length;
      const std::int64_t column = (face.at - tread.first) / strides_[axis];
      depth = -tread.rise * (2 * column + 1 - length) * field_one / (2 * length);
    }
  return static_cast<std::int32_t>(upwards ? depth : -depth);
}

}  // namespace certet::fields
