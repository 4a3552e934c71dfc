#pragma once
/// \file
/// Reading a file from its beginning to its end: words, lines and binary numbers.

#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "input_file.hpp"

namespace certet::formats {

/// A word for a sentence: cut short, and without what terminals cannot show.
std::string in_quotes(std::string_view word);

/// All members throw Error `bad_input` where the file is not as it should be.
class Cursor {
 public:
  explicit Cursor(const InputFile& file) : file_(file), text_(capacity) {}

  /// The next word, valid until the next call; empty at the end of the file.
  std::string_view word();
  /// What is left of the line, without its end; valid until the next call.
  std::string_view line();
  /// Goes on behind the next place where these words stand.
  void skip_past(std::string_view words);

  template <class Number>
  Number number(const char* what) {
    const std::string_view next = word();
    if (next.empty()) file_.fail("it is cut off");
    Number value{};
    const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
    if (error != std::errc() || end != next.data() + next.size())
      file_.fail(in_quotes(next) + " is not " + what);
    return value;
  }

  void bytes(std::span<std::byte> out);
  template <class Number>
  Number binary() {
    Number value;
    bytes(std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }

  /// Bytes that are behind, and still to come.
  [[nodiscard]] std::uint64_t position() const { return offset_ - (end_ - at_); }
  [[nodiscard]] std::uint64_t remaining() const { return file_.size() - position(); }
  /// Goes on behind so many bytes.
  void skip(std::uint64_t bytes);
  /// Goes on at another place of the file.
  void go_to(std::uint64_t position);

  /// A count of things to come, each of so many bytes at least: not believed
  /// before the rest of the file is long enough for them.
  std::uint64_t checked(std::uint64_t count, std::uint64_t least_bytes, const char* things) const;

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  bool refill();

  static constexpr std::size_t capacity = std::size_t{1} << 20;

  const InputFile& file_;
  std::vector<char> text_;
  std::uint64_t offset_ = 0;      ///< in the file, of what follows the text at hand
  std::size_t at_ = 0, end_ = 0;  ///< in the text at hand
};

}  // namespace certet::formats
