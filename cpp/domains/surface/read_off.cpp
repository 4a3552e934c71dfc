#include <algorithm>
#include <string>
#include <vector>

#include "polygons.hpp"
#include "surface_file.hpp"

namespace certet {
namespace {

using formats::Cursor;
using formats::InputFile;

/// Words of lines that have some; `#` begins a remark.
class OffReader {
 public:
  OffReader(const InputFile& file, TriangleSurface& surface)
      : file_(file), text_(file), surface_(surface) {}

  void read() {
    next_line();
    check_keyword();
    if (rest_.find_first_not_of(blanks) == rest_.npos) next_line();
    const std::uint64_t points = text_.checked(count_in(word(), file_), 6, "points");
    const std::uint64_t faces = text_.checked(count_in(word(), file_), 4, "faces");
    surface_.points.reserve(points);
    for (std::uint64_t p = 0; p < points; ++p) point();
    for (std::uint64_t f = 0; f < faces; ++f) face();
  }

 private:
  static constexpr const char* blanks = " \t\r\v\f";

  /// The keyword may be missing; letters before OFF tell what follows coordinates.
  void check_keyword() {
    const std::string whole = rest_;
    const std::string_view keyword = word();
    if (keyword == "off") return;
    const std::size_t off = keyword.find("OFF");
    if (off == keyword.npos) {
      rest_ = whole;
      return;
    }
    if (off + 3 != keyword.size())
      file_.fail(formats::in_quotes(keyword) +
                 " is not a keyword of OFF: what follows OFF is not apart from it");
    std::string_view letters = keyword.substr(0, off);
    for (const std::string_view known : {"ST", "C", "N", "4", "n"})
      if (letters.starts_with(known)) {
        if (known == "4" || known == "n")
          file_.fail("it is a " + std::string(keyword) +
                     " file, whose points do not have three coordinates");
        letters.remove_prefix(known.size());
      }
    if (!letters.empty()) file_.fail(formats::in_quotes(keyword) + " is not a keyword of OFF");
    if (rest_.find("BINARY") != rest_.npos) file_.fail("it is a binary OFF file, not text");
  }

  void next_line() {
    do {
      if (text_.remaining() == 0) file_.fail("it is too short for what it announces");
      rest_ = text_.line();
      rest_.resize(std::min(rest_.find('#'), rest_.size()));
    } while (rest_.find_first_not_of(blanks) == rest_.npos);
  }

  /// The next one of the line; valid until the next call.
  std::string_view word() {
    rest_.erase(0, std::min(rest_.find_first_not_of(blanks), rest_.size()));
    const std::size_t length = std::min(rest_.find_first_of(blanks), rest_.size());
    if (length == 0) file_.fail("it has a line with too few numbers");
    word_ = rest_.substr(0, length);
    rest_.erase(0, length);
    return word_;
  }

  double number() {
    const std::string_view next = word();
    double value = 0;
    const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
    if (error != std::errc() || end != next.data() + next.size())
      file_.fail(formats::in_quotes(next) + " is not a number");
    return value;
  }

  void point() {
    next_line();
    Point3 point;
    for (double& value : point) value = coordinate(number(), file_);
    surface_.points.push_back(point);
  }

  void face() {
    next_line();
    const std::uint64_t count = count_in(word(), file_);
    if (count > most_corners) file_.fail("it has a face of too many corners");
    std::vector<std::uint32_t> corners(count);
    for (std::uint32_t& c : corners) c = corner(number(), surface_, file_);
    add_polygon(corners, surface_);
  }

  const InputFile& file_;
  Cursor text_;
  TriangleSurface& surface_;
  std::string rest_, word_;
};

}  // namespace

void read_off(const InputFile& file, TriangleSurface& surface) { OffReader(file, surface).read(); }

}  // namespace certet
