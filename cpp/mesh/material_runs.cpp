#include "certet/material_runs.hpp"

#include <algorithm>
#include <cstddef>

namespace certet {
namespace {

void append(std::uint64_t number, std::vector<std::uint8_t>& bytes) {
  for (; number > 0x7f; number >>= 7) bytes.push_back(static_cast<std::uint8_t>(number | 0x80));
  bytes.push_back(static_cast<std::uint8_t>(number));
}

std::uint64_t take(const std::uint8_t*& byte) {
  std::uint64_t number = 0;
  int shift = 0;
  for (; (*byte & 0x80) != 0; ++byte, shift += 7) number |= std::uint64_t{*byte & 0x7fU} << shift;
  return number | std::uint64_t{*byte++} << shift;
}

}  // namespace

void MaterialRuns::put(std::int32_t layer, std::span<const Material> materials) {
  std::vector<std::uint8_t> bytes;
  for (auto at = materials.begin(); at != materials.end();) {
    const auto end =
        std::find_if(at, materials.end(), [&](Material other) { return other != *at; });
    append(static_cast<std::uint64_t>(*at), bytes);
    append(static_cast<std::uint64_t>(end - at) - 1, bytes);
    at = end;
  }
  bytes.shrink_to_fit();
  layers_[static_cast<std::size_t>(layer)] = std::move(bytes);
}

void MaterialRuns::get(std::int32_t layer, std::span<Material> out) const {
  const std::uint8_t* byte = layers_[static_cast<std::size_t>(layer)].data();
  while (!out.empty()) {
    const auto material = static_cast<Material>(take(byte));
    const std::size_t length = take(byte) + 1;
    std::ranges::fill(out.first(length), material);
    out = out.subspan(length);
  }
}

std::uint64_t MaterialRuns::bytes() const {
  std::uint64_t bytes = layers_.size() * sizeof(layers_[0]);
  for (const std::vector<std::uint8_t>& layer : layers_) bytes += layer.size();
  return bytes;
}

}  // namespace certet
