#include "nifti_header.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

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
    swapped_ = !is_rank(number<std::int16_t>(rank)) && is_rank(number<std::int16_t>(rank, true));
  }

  /// Whether it is one of NIfTI, and not of ANALYZE, which knows of no matrix.  The
  /// reader takes every version's for one of version 1, so we do too.
  [[nodiscard]] bool is_nifti() const {
    const std::string_view word(reinterpret_cast<const char*>(bytes_.data()) + magic, 4);
    return complete_ && word[0] == 'n' && (word[1] == '+' || word[1] == 'i') &&
           word[2] >= '1' && word[2] <= '9' && word[3] == '\0';
  }
  /// Whether its own length is right, in the byte order of the rest.
  [[nodiscard]] bool has_length() const {
    return complete_ && number<std::int32_t>(0, swapped_) == size;
  }
  [[nodiscard]] std::int16_t whole(std::size_t at) const {
    return number<std::int16_t>(at, swapped_);
  }
  [[nodiscard]] double real(std::size_t at) const { return number<float>(at, swapped_); }

 private:
  static constexpr std::int32_t size = 348;
  static constexpr std::size_t rank = 40, magic = 344;

  /// By the number of dimensions the reader tells the byte order, so we do too.
  static bool is_rank(std::int16_t number) { return number >= 1 && number <= 7; }

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
  const bool is_nifti = header.is_nifti();
  if (!is_nifti && !header.has_length()) return;
  if (!header.has_length()) refuse(file, "has a header of two byte orders");
  // What has no code is not looked at by anybody.
  const auto has = [&](std::size_t code) { return is_nifti && header.whole(code) != 0; };
  if (!are_possible(header, pixdim, 4) ||
      (has(qform_code) && !are_possible(header, quaternion, 6)) ||
      (has(sform_code) && !are_possible(header, matrix, 12)))
    refuse(file, "has a header with impossible coordinates");
}

}  // namespace certet
