#pragma once
/// \file
/// Lines of text files.

#include <algorithm>
#include <array>
#include <charconv>
#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace certet::formats {

/// A whole number that takes up a fixed number of characters.
struct Padded {
  std::uint64_t number;
  std::size_t width;
};

/// Several of them, one after the other.
struct PaddedAll {
  std::span<const std::uint64_t> numbers;
  std::size_t width;
};

/// A number in a field that programs read no more of than so many characters: where its shortest
/// form is longer, it has as many digits as fit.  At least 8.
struct Field {
  double number;
  std::size_t width;
};

/// How many characters a whole number has.
inline std::size_t digits_of(std::integral auto number) { return std::to_string(number).size(); }

/// One line, or a few short ones.  Numbers are in the shortest form that reads
/// back the same.  Holds up to 8 numbers and the few words around them.
class Line {
 public:
  Line& operator<<(std::string_view words) {
    end_ = std::copy(words.begin(), words.end(), end_);
    return *this;
  }
  Line& operator<<(char c) {
    *end_++ = c;
    return *this;
  }
  Line& operator<<(Padded padded) {
    std::array<char, 24> digits;
    const auto stop =
        std::to_chars(digits.data(), digits.data() + digits.size(), padded.number).ptr;
    const auto count = static_cast<std::size_t>(stop - digits.data());
    for (std::size_t i = count; i < padded.width; ++i) *end_++ = ' ';
    end_ = std::copy_n(digits.data(), count, end_);
    return *this;
  }
  Line& operator<<(PaddedAll fields) {
    for (const std::uint64_t number : fields.numbers) *this << Padded{number, fields.width};
    return *this;
  }
  Line& operator<<(Field field) {
    char* const begin = end_;
    *this << field.number;
    for (int digits = 17; static_cast<std::size_t>(end_ - begin) > field.width; --digits)
      end_ = std::to_chars(begin, text_.data() + text_.size(), field.number,
                           std::chars_format::general, digits)
                 .ptr;
    return *this;
  }
  template <class Number>
    requires std::is_arithmetic_v<Number>
  Line& operator<<(Number number) {
    end_ = std::to_chars(end_, text_.data() + text_.size(), number).ptr;
    return *this;
  }

  [[nodiscard]] std::span<const char> text() const { return {text_.data(), end_}; }

 private:
  std::array<char, 512> text_;
  char* end_ = text_.data();
};

}  // namespace certet::formats
