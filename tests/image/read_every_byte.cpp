// Reads images and looks at every voxel, so that valgrind sees a branch on each that
// was never written:
//
//     read_every_byte [--leave-one-out] IMAGE...
//
// A line for each: `read` or `refused`, and why; status 77 where no reader is built in.
// With the option the last voxel of
// each image is one that nobody wrote, which must be reported.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <variant>

#include "certet/error.hpp"
#include "certet/image.hpp"

namespace {

constexpr std::uint64_t most_bytes = 64 << 20;

/// One branch for each voxel.
template <class T>
std::uint64_t count_others(const certet::Buffer<T>& voxels) {
  std::uint64_t count = 0;
  for (const T voxel : voxels)
    if (voxel != T{}) ++count;
  return count;
}

template <class T>
void leave_one_out(certet::Buffer<T>& voxels) {
  if (voxels.empty()) return;
  const auto nobody = std::make_unique_for_overwrite<T[]>(1);
  std::memcpy(voxels.end() - 1, nobody.get(), sizeof(T));
}

void read(const std::string& file, bool spoiled) {
  try {
    certet::Image image = certet::read_image(file, most_bytes);
    if (spoiled) std::visit([](auto& voxels) { leave_one_out(voxels); }, image.voxels);
    const auto count = std::visit([](const auto& v) { return count_others(v); }, image.voxels);
    std::printf("read %s: %llu\n", file.c_str(), static_cast<unsigned long long>(count));
  } catch (const certet::Error& error) {
    std::printf("refused %s\n", error.what());
  }
}

}  // namespace

int main(int count, char** words) {
  if (!certet::can_read_images()) return 77;
  const bool spoiled = count > 1 && std::strcmp(words[1], "--leave-one-out") == 0;
  for (int i = spoiled ? 2 : 1; i < count; ++i) read(words[i], spoiled);
}
