#include "volumes.hpp"

#include <limits>

#include "certet/error.hpp"
#include "image_file.hpp"

namespace certet {

std::uint64_t check_count(const std::filesystem::path& file,
                          const std::array<std::int64_t, 3>& size, std::size_t bytes_of_one) {
  std::uint64_t count = 1;
  const std::uint64_t most = std::numeric_limits<std::int64_t>::max() / 16 / bytes_of_one;
  for (const std::int64_t along : size) {
    if (along < 1) refuse(file, "has no voxels");
    if (along > (std::int64_t{1} << 31) || count > most / static_cast<std::uint64_t>(along))
      refuse(file, "has impossible dimensions");
    count *= static_cast<std::uint64_t>(along);
  }
  return count;
}

std::uint64_t chosen_volume(const std::filesystem::path& file, std::uint64_t count,
                            const std::string& what, std::optional<std::uint64_t> chosen) {
  const std::string choice = "--volume N, from 0 to " + std::to_string(count - 1);
  if (!chosen && count > 1)
    refuse(file, "has " + what + "; choose one with " + choice);
  if (chosen.value_or(0) < count) return chosen.value_or(0);
  throw Error(ErrorCode::bad_option, "'" + file.string() + "' has no volume " +
                                         std::to_string(*chosen) + "; it has " +
                                         (count == 1 ? "one, number 0" : choice));
}

}  // namespace certet
