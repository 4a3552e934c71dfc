#pragma once
/// \file
/// Numbers in few bytes, and bytes in text.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace certet::view {

/// A sequence of whole numbers: seven bits in a byte, the low ones first, the
/// eighth bit telling that more follow.
class Packing {
 public:
  void byte(std::uint8_t value) { bytes_.push_back(value); }
  void natural(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) byte(static_cast<std::uint8_t>(value | 0x80));
    byte(static_cast<std::uint8_t>(value));
  }
  /// 0, -1, 1, -2, … as 0, 1, 2, 3, …
  void integer(std::int64_t value) {
    natural(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
  }
  void append(const Packing& other) {
    bytes_.insert(bytes_.end(), other.bytes_.begin(), other.bytes_.end());
  }
  /// RFC 4648.
  [[nodiscard]] std::string base64() const;

 private:
  std::vector<std::uint8_t> bytes_;
};

/// Text as HTML shows it: the five characters with a meaning are escaped.
std::string escaped(std::string_view text);

/// Digits in groups of three, by a narrow no-break space.
std::string grouped_digits(std::uint64_t number);

/// In so many significant digits, without zeros at the end.
std::string shortened(double number, int digits = 6);

}  // namespace certet::view
