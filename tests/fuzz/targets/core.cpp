// The engine on a small lattice whose every sign and cut is given by the bytes;
// the judge is that of the soak test.

#include "domains.hpp"
#include "soak/verify.hpp"
#include "targets.hpp"

namespace fuzz {
namespace {

using certet::Coord3;
using certet::Sign;

/// Numbers of the bytes, over and over.
class Endless {
 public:
  explicit Endless(Bytes bytes) : bytes_(bytes) {}
  [[nodiscard]] std::uint8_t at(std::uint64_t place) const {
    return bytes_[place % bytes_.size()];
  }
  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

 private:
  Bytes bytes_;
};

constexpr std::int32_t most_cells = 5;

/// The place of a lattice point in the order of points.
std::uint64_t number_of(Coord3 v) {
  constexpr std::uint64_t side = 2 * most_cells + 2;
  return (static_cast<std::uint64_t>(v.z) * side + static_cast<std::uint64_t>(v.y)) * side +
         static_cast<std::uint64_t>(v.x);
}

/// Half of all bytes are cuts spread evenly; the others are at a threshold of
/// warping from either end, or up to two steps before or behind it.
std::int32_t cut_of(std::uint8_t byte) {
  constexpr std::int32_t part = certet::steps / 256;
  if (byte < 128) return 2 * part * byte;
  constexpr std::array<std::int32_t, 8> thresholds{64, 73, 102, 105, 256 - 64, 256 - 73,
                                                   256 - 102, 256 - 105};
  const std::int32_t beside = (byte >> 3) % 5 - 2;
  return part * thresholds[byte & 7] + beside;
}

domains::Positional field(Endless bytes) {
  const auto corner = [bytes](Coord3 v) {
    switch (bytes.at(number_of(v)) & 3) {
      case 0: return Sign::minus;
      case 1: return Sign::on_surface;
      default: return Sign::plus;
    }
  };
  return domains::Positional([=](Coord3 p) {
    const auto [a, b, t] = domains::edge_of(p);
    if (t == 0) return corner(a);
    const std::int32_t from_plus = corner(a) == Sign::plus ? t : certet::steps - t;
    const std::uint64_t edge = mixed(0, a.x, a.y, a.z, b.x, b.y, b.z);
    return from_plus <= cut_of(bytes.at(edge)) ? Sign::plus : Sign::minus;
  });
}

/// The first byte has the options, the second the cells: 3 to 5 along each axis,
/// of which the outermost points are outside.
soak::Trial trial_of(Bytes bytes) {
  soak::Trial trial;
  trial.kind = soak::Kind::thresholds;
  trial.seed = bytes[0] >> 2;
  if (bytes[0] & 2)
    trial.method = bytes[1] & 64 ? certet::Method::angles : certet::Method::embedding;
  if (bytes[0] & 1) trial.method = certet::Method::midpoint;
  trial.lattice.origin = {0, 0, 0};
  for (std::size_t axis = 0; axis < 3; ++axis)
    trial.lattice.cells[axis] = std::array{3, 4, 4, 5}[bytes[1] >> (2 * axis) & 3];
  trial.domain = std::make_unique<domains::Positional>(field(Endless(bytes.subspan(2))));
  return trial;
}

void examine(Bytes bytes, soak::Plant plant) {
  if (bytes.size() < 3) return;
  const soak::Verdict verdict = soak::verify(trial_of(bytes), plant);
  if (!verdict.faults.empty()) throw Finding(verdict.faults.front());
}

}  // namespace

void core(Bytes bytes) { examine(bytes, soak::Plant::nothing); }

void planted_core(Bytes bytes) {
  if (bytes.size() < 3) return;
  examine(bytes, static_cast<soak::Plant>(1 + bytes[2] % 4));
}

}  // namespace fuzz
