#include "dicom_runs.hpp"

namespace certet {
namespace {

using Bytes = std::span<const unsigned char>;

constexpr std::size_t head_bytes = 64;
constexpr std::uint64_t most_planes = 15;

std::uint64_t number(Bytes head, std::size_t index) {
  std::uint64_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | head[4 * index + i];
  return value;
}

/// A control byte below 128 is followed by that many bytes and one more, one
/// above 128 by a byte that is repeated; 128 stands for nothing.
bool whole_plane(Bytes runs, std::uint64_t voxels) {
  std::uint64_t unpacked = 0;
  std::size_t at = 0;
  while (unpacked < voxels) {
    if (at == runs.size()) return false;
    const unsigned control = runs[at++];
    if (control == 128) continue;
    const std::size_t stored = control < 128 ? control + 1 : 1;
    if (stored > runs.size() - at) return false;
    at += stored;
    unpacked += control < 128 ? control + 1 : 257 - control;
  }
  return unpacked == voxels && runs.size() - at <= 1;  // planes begin at even places
}

}  // namespace

bool whole_runs(Bytes packed, std::uint64_t planes, std::uint64_t voxels) {
  if (packed.size() < head_bytes || planes > most_planes || number(packed, 0) != planes)
    return false;
  std::uint64_t begin = head_bytes;
  for (std::size_t plane = 0; plane < planes; ++plane) {
    if (number(packed, plane + 1) != begin) return false;
    const bool last = plane + 1 == planes;
    const std::uint64_t end = last ? packed.size() : number(packed, plane + 2);
    if (end < begin || end > packed.size() ||
        !whole_plane(packed.subspan(begin, end - begin), voxels))
      return false;
    begin = end;
  }
  return true;
}

}  // namespace certet
