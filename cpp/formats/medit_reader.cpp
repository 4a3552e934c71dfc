#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "input_file.hpp"
#include "registry.hpp"

namespace certet::formats {
namespace {

/// A word for a sentence: cut short, and without what terminals cannot show.
std::string quoted(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 40)) text += c > ' ' && c <= '~' ? c : '?';
  return text += '\'';
}

/// The words of a text file, one after the other.
class Words {
 public:
  explicit Words(const InputFile& file) : file_(file), text_(capacity) {}

  /// The next word, valid until the one after; empty at the end of the file.
  std::string_view next();

  /// Bytes that are still to come.
  [[nodiscard]] std::uint64_t remaining() const { return file_.size() - offset_ + (end_ - at_); }

  template <class Number>
  Number number(const char* what) {
    const std::string_view word = next();
    if (word.empty()) file_.fail("it is cut off");
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      file_.fail(quoted(word) + " is not " + what);
    return value;
  }

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  bool refill();

  static constexpr std::size_t capacity = std::size_t{1} << 20;

  const InputFile& file_;
  std::vector<char> text_;
  std::uint64_t offset_ = 0;       ///< in the file, of what follows the text at hand
  std::size_t at_ = 0, end_ = 0;   ///< in the text at hand
};

/// Moves what is left to the front and reads on; false at the end of the file.
bool Words::refill() {
  std::memmove(text_.data(), text_.data() + at_, end_ - at_);
  end_ -= at_;
  at_ = 0;
  const std::size_t room = text_.size() - end_;
  const auto size =
      static_cast<std::size_t>(std::min<std::uint64_t>(room, file_.size() - offset_));
  file_.read_at(offset_, std::as_writable_bytes(std::span(text_).subspan(end_, size)));
  offset_ += size;
  end_ += size;
  return size > 0;
}

std::string_view Words::next() {
  do {
    while (at_ < end_ && is_blank(text_[at_])) ++at_;
  } while (at_ == end_ && refill());
  std::size_t length = 0;
  do {
    while (at_ + length < end_ && !is_blank(text_[at_ + length])) ++length;
  } while (at_ + length == end_ && refill());
  const std::string_view word(text_.data() + at_, length);
  at_ += length;
  return word;
}

class MeditReader {
 public:
  explicit MeditReader(const std::filesystem::path& path) : file_(path), words_(file_) {}

  FileMesh read() {
    read_heading();
    bool has_points = false, has_tets = false;
    for (;;) {
      const std::string_view word = words_.next();
      if (word == "End") break;
      if (word == "Vertices" && !has_points) {
        read_points();
        has_points = true;
      } else if (word == "Tetrahedra" && !has_tets) {
        read_tets();
        has_tets = true;
      } else {
        refuse(word);
      }
    }
    if (!has_points || !has_tets) file_.fail("it has no vertices or no tetrahedra");
    if (!words_.next().empty()) file_.fail("it goes on behind its end");
    return std::move(mesh_);
  }

 private:
  void read_heading();
  void read_points();
  void read_tets();
  std::uint64_t count(std::uint64_t shortest_line);
  [[noreturn]] void refuse(std::string_view word) const;

  InputFile file_;
  Words words_;
  FileMesh mesh_;
};

void MeditReader::read_heading() {
  if (words_.next() != "MeshVersionFormatted") file_.fail("it is not an ASCII MEDIT file");
  const auto version = words_.number<int>("a version");
  if (version < 1 || version > 4)
    file_.fail("version " + std::to_string(version) + " of MEDIT is not known");
  if (words_.next() != "Dimension" || words_.number<int>("a dimension") != 3)
    file_.fail("its dimension is not 3");
}

/// The number of lines to come.  It is not believed before the rest of the file
/// is long enough for them.
std::uint64_t MeditReader::count(std::uint64_t shortest_line) {
  const auto lines = words_.number<std::uint64_t>("a count");
  if (lines > words_.remaining() / shortest_line)
    file_.fail("it is too short for the " + std::to_string(lines) + " lines that it announces");
  return lines;
}

void MeditReader::read_points() {
  mesh_.points.resize(count(std::string_view("0 0 0 0\n").size()));
  for (Point3& point : mesh_.points) {
    for (double& coordinate : point) coordinate = words_.number<double>("a coordinate");
    words_.number<std::int32_t>("a reference");
  }
}

void MeditReader::read_tets() {
  const std::uint64_t tets = count(std::string_view("1 1 1 1 0\n").size());
  mesh_.tets.resize(tets);
  mesh_.labels.resize(tets);
  bool labelled = false;
  for (std::uint64_t i = 0; i < tets; ++i) {
    for (std::uint64_t& index : mesh_.tets[i]) {
      index = words_.number<std::uint64_t>("the number of a vertex");
      if (index-- == 0) file_.fail("it names vertex 0, but vertices are counted from 1");
    }
    mesh_.labels[i] = words_.number<std::int32_t>("a reference");
    labelled = labelled || mesh_.labels[i] != 0;
  }
  if (!labelled) mesh_.labels = {};
}

void MeditReader::refuse(std::string_view word) const {
  if (word.empty()) file_.fail("it is cut off: its 'End' is missing");
  if (word == "Vertices" || word == "Tetrahedra")
    file_.fail("it has two sections " + quoted(word));
  file_.fail("its section " + quoted(word) + " is not known");
}

}  // namespace

FileMesh read_medit(const std::filesystem::path& file) { return MeditReader(file).read(); }

}  // namespace certet::formats
