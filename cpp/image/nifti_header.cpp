#include "nifti_header.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

/// The header of NIfTI-1, in bytes as it is stored.
class Header {
 public:
  explicit Header(const fs::path& file) {
    // Reads files that are not packed as well.
    const std::unique_ptr<gzFile_s, decltype(&gzclose)> stream(gzopen(file.c_str(), "rb"),
                                                               &gzclose);
    if (!stream) return;
    const int got =
        gzread(stream.get(), bytes_.data(), static_cast<unsigned>(bytes_.size()));
    complete_ = got == static_cast<int>(bytes_.size());
    swapped_ = number<std::int32_t>(0) != size && number<std::int32_t>(0, true) == size;
  }

  [[nodiscard]] bool is_nifti() const {
    return complete_ && number<std::int32_t>(0, swapped_) == size;
  }
  [[nodiscard]] std::int16_t whole(std::size_t at) const {
    return number<std::int16_t>(at, swapped_);
  }
  [[nodiscard]] double real(std::size_t at) const { return number<float>(at, swapped_); }

 private:
  static constexpr std::int32_t size = 348;

  template <class Number>
  [[nodiscard]] Number number(std::size_t at, bool swapped = false) const {
    std::array<unsigned char, sizeof(Number)> copy;
    std::memcpy(copy.data(), bytes_.data() + at, copy.size());
    if (swapped) std::ranges::reverse(copy);
    return std::bit_cast<Number>(copy);
  }

  std::array<unsigned char, size> bytes_{};
  bool complete_ = false, swapped_ = false;
};

// Where in the header what lies.
constexpr std::size_t pixdim = 76, qform_code = 252, sform_code = 254,
                      quaternion = 256, matrix = 280;

/// Far from where a product of three of them leaves the range of a float.
constexpr double greatest = 1e12;

bool are_possible(const Header& header, std::size_t begin, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!(std::fabs(header.real(begin + 4 * i)) <= greatest)) return false;
  return true;
}

}  // namespace

void judge_nifti_header(const fs::path& file) {
  const bool detached = file.extension() == ".img";
  const Header header(detached ? fs::path(file).replace_extension(".hdr") : file);
  if (!header.is_nifti()) return;
  // What has no code is not looked at by anybody.
  if (!are_possible(header, pixdim, 4) ||
      (header.whole(qform_code) != 0 && !are_possible(header, quaternion, 6)) ||
      (header.whole(sform_code) != 0 && !are_possible(header, matrix, 12)))
    refuse(file, "has a header with impossible coordinates");
}

}  // namespace certet
