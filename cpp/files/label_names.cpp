#include "certet/label_names.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "certet/error.hpp"
#include "files/formats/input_file.hpp"

namespace certet {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";
constexpr std::uint64_t longest_file = 16 << 20;
constexpr std::size_t longest_name = 1000;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  text.remove_prefix(begin);
  text.remove_suffix(text.size() - (text.find_last_not_of(blanks) + 1));
  return text;
}

template <class Number>
std::optional<Number> number(std::string_view word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// Takes the last word off a text.
std::string_view take_last_word(std::string_view& text) {
  const std::size_t before = text.find_last_of(blanks);
  const std::size_t begin = before == text.npos ? 0 : before + 1;
  const std::string_view word = text.substr(begin);
  text = trimmed(text.substr(0, begin));
  return word;
}

/// What stands between quotation marks at the end of a line.
std::optional<std::string_view> quoted_name(std::string_view text) {
  const std::size_t begin = text.find('"');
  if (begin == text.npos || begin + 1 >= text.size() || text.back() != '"') return std::nullopt;
  return text.substr(begin + 1, text.size() - begin - 2);
}

/// The name before four numbers: red, green, blue and opacity.
std::optional<std::string_view> name_before_colour(std::string_view text) {
  for (int i = 0; i < 4; ++i)
    if (!number<double>(take_last_word(text))) return std::nullopt;
  if (text.empty()) return std::nullopt;
  return text;
}

/// One word before one number, which is another code of the label.
std::optional<std::string_view> name_before_code(std::string_view text) {
  if (!number<std::int64_t>(take_last_word(text))) return std::nullopt;
  if (text.empty() || text.find_first_of(blanks) != text.npos) return std::nullopt;
  return text;
}

std::string_view name_in(std::string_view text) {
  if (const auto name = quoted_name(text)) return *name;
  if (const auto name = name_before_colour(text)) return *name;
  if (const auto name = name_before_code(text)) return *name;
  return text;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : file_(path) {}

  LabelNames read() {
    if (file_.size() > longest_file) file_.fail("it is too long for a table of labels");
    std::string text(file_.size(), '\0');
    file_.read_at(0, std::as_writable_bytes(std::span(text)));
    for (std::string_view rest = text; !rest.empty();) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      ++line_;
      take(trimmed(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (names_.empty()) file_.fail("it names no label");
    return std::move(names_);
  }

 private:
  void take(std::string_view line) {
    if (line.empty() || line.front() == '#') return;
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    const auto label = number<std::int32_t>(line.substr(0, end));
    if (!label) fail("does not begin with a label");
    const std::string_view name = trimmed(name_in(trimmed(line.substr(end))));
    if (name.empty()) fail("has no name");
    if (name.size() > longest_name) fail("has too long a name");
    if (name.find('\0') != name.npos) fail("is not text");
    if (!names_.emplace(*label, name).second)
      fail("names label " + std::to_string(*label) + " again");
  }

  [[noreturn]] void fail(const std::string& what) const {
    file_.fail("its line " + std::to_string(line_) + " " + what);
  }

  formats::InputFile file_;
  std::uint64_t line_ = 0;
  LabelNames names_;
};

}  // namespace

LabelNames read_label_names(const std::filesystem::path& file) { return Reader(file).read(); }

}  // namespace certet
