#include "check_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "files/formats/cursor.hpp"

namespace certet {
namespace {

using formats::Cursor;
using formats::InputFile;

/// Lines, cut into words.
class TextLines {
 public:
  explicit TextLines(const InputFile& file) : file_(file), text_(file) {}

  /// Whether there was one more; empty ones too.
  bool next() {
    if (text_.remaining() == 0) return false;
    ++number_;
    line_ = text_.line();
    at_ = 0;
    return true;
  }

  /// The next word of the line; empty at its end.
  std::string_view word() {
    constexpr const char* blanks = " \t\r\v\f";
    const std::size_t begin = std::min(line_.find_first_not_of(blanks, at_), line_.size());
    at_ = std::min(line_.find_first_of(blanks, begin), line_.size());
    return std::string_view(line_).substr(begin, at_ - begin);
  }

  /// Three numbers, or more.
  void check_point() {
    for (int n = 0; n < 3; ++n) {
      const std::string_view next = word();
      if (next.empty()) fail("has a point of fewer than three numbers");
      double value = 0;
      std::string_view digits = next.starts_with('+') ? next.substr(1) : next;
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), value);
      if (error == std::errc::invalid_argument || end != digits.data() + digits.size())
        fail("has a point with " + formats::in_quotes(next) + ", which is not a number");
    }
  }

  [[nodiscard]] std::uint64_t number() const { return number_; }
  [[noreturn]] void fail(const std::string& what) const { fail_at(number_, what); }
  [[noreturn]] void fail_at(std::uint64_t line, const std::string& what) const {
    file_.fail("its line " + std::to_string(line) + " " + what);
  }

 private:
  const InputFile& file_;
  Cursor text_;
  std::string line_;
  std::size_t at_ = 0;
  std::uint64_t number_ = 0;  ///< from 1
};

}  // namespace

void check_obj(const InputFile& file) {
  TextLines lines(file);
  std::int64_t points = 0, greatest = 0;
  std::uint64_t line_of_greatest = 0;
  while (lines.next()) {
    const std::string_view first = lines.word();
    if (first == "v") {
      ++points;
      lines.check_point();
    }
    if (first != "f") continue;
    for (;;) {
      const std::string_view word = lines.word();
      if (word.empty() || word.starts_with('#') || word.ends_with('\\')) break;
      std::int64_t index = 0;
      const auto [end, error] =
          std::from_chars(word.data(), word.data() + word.size(), index);
      const bool whole = error == std::errc() && (end == word.data() + word.size() || *end == '/');
      if (!whole) lines.fail("has a face with " + formats::in_quotes(word) + ", which is not the number of a point");
      if (index == 0) lines.fail("has a face with the point 0; they are numbered from 1");
      if (index < -points)
        lines.fail("has a face with the point " + std::to_string(index) + ", but only " +
                   std::to_string(points) + " are before it");
      if (index <= greatest) continue;
      greatest = index;
      line_of_greatest = lines.number();
    }
  }
  if (greatest > points)
    lines.fail_at(line_of_greatest, "has a face with the point " + std::to_string(greatest) +
                                        ", but there are " + std::to_string(points));
}

void check_text_stl(const InputFile& file) {
  TextLines lines(file);
  std::uint64_t corners = 0, begun = 0;
  while (lines.next()) {
    const std::string_view first = lines.word();
    if (first == "facet") {
      if (begun != 0) lines.fail_at(begun, "begins a triangle that has no end");
      corners = 0;
      begun = lines.number();
    }
    if (first == "vertex") {
      ++corners;
      lines.check_point();
    }
    if (first != "endfacet") continue;
    if (begun != 0 && corners < 3)
      lines.fail_at(begun, "begins a triangle of " + std::to_string(corners) + " points");
    begun = 0;
  }
  if (begun != 0) lines.fail_at(begun, "begins a triangle that has no end: the file is cut off");
}

}  // namespace certet
