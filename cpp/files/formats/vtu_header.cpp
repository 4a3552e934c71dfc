#include "vtu_header.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <vector>

#include "vtu_layout.hpp"

namespace certet::formats {
namespace {

constexpr std::string_view blanks = " \t\r\n";

/// A tag of an XML file.
struct Tag {
  std::string_view name;  ///< with the slash, if it closes
  std::map<std::string_view, std::string_view> attributes;
  std::size_t end = 0;  ///< behind its ">"

  [[nodiscard]] std::string_view operator[](std::string_view attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? std::string_view() : found->second;
  }
};

/// Tags one after the other; text between them is skipped, and so are comments
/// and declarations.  The few rules of XML that such files make use of.
class Tags {
 public:
  Tags(std::string_view text, const InputFile& file) : text_(text), file_(file) {}

  Tag next();

 private:
  void skip_declarations();
  void skip_blanks() { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); }
  std::string_view take_until(std::string_view stops);
  void read_attribute(Tag& tag);
  [[noreturn]] void fail() const { file_.fail("its XML header is damaged"); }

  std::string_view text_;
  const InputFile& file_;
  std::size_t at_ = 0;
};

void Tags::skip_declarations() {
  for (;;) {
    at_ = text_.find('<', at_);
    if (at_ == text_.npos) fail();
    const std::string_view rest = text_.substr(at_);
    const bool comment = rest.starts_with("<!--");
    if (!comment && !rest.starts_with("<?")) return;
    const std::string_view closing = comment ? "-->" : "?>";
    at_ = text_.find(closing, at_);
    if (at_ == text_.npos) fail();
    at_ += closing.size();
  }
}

std::string_view Tags::take_until(std::string_view stops) {
  const std::size_t end = text_.find_first_of(stops, at_);
  if (end == text_.npos) fail();
  const std::string_view taken = text_.substr(at_, end - at_);
  at_ = end;
  return taken;
}

void Tags::read_attribute(Tag& tag) {
  const std::string_view name = take_until("= \t\r\n>");
  if (text_[at_] != '=') fail();
  const std::size_t quote = ++at_;
  if (quote >= text_.size() || (text_[quote] != '"' && text_[quote] != '\'')) fail();
  ++at_;
  tag.attributes[name] = take_until(text_.substr(quote, 1));
  ++at_;
}

Tag Tags::next() {
  skip_declarations();
  ++at_;
  Tag tag;
  const std::size_t begin = at_;
  if (at_ < text_.size() && text_[at_] == '/') ++at_;
  take_until("/> \t\r\n");
  tag.name = text_.substr(begin, at_ - begin);
  for (;;) {
    skip_blanks();
    if (at_ == text_.size()) fail();
    if (text_[at_] == '>') break;
    if (text_[at_] == '/')
      ++at_;
    else
      read_attribute(tag);
  }
  tag.end = ++at_;
  return tag;
}

/// Understands the tags of a .vtu file.
class HeaderReader {
 public:
  HeaderReader(std::string_view text, const InputFile& file)
      : text_(text), file_(file), tags_(text, file) {}

  VtuHeader read();

 private:
  void take(const Tag& tag);
  void take_file(const Tag& tag);
  void take_data(const Tag& appended);
  void take_piece(const Tag& tag);
  void take_array(const Tag& tag);
  [[nodiscard]] std::uint64_t data_begin(const Tag& appended) const;
  [[nodiscard]] std::uint64_t number(const Tag& tag, std::string_view attribute) const;

  std::string_view text_;
  const InputFile& file_;
  Tags tags_;
  VtuHeader header_;
  std::string section_;  ///< the tag that arrays stand in
  std::vector<std::string> appended_;  ///< names of arrays
  bool has_piece_ = false;
};

/// What this program's comment before the first tag says.
std::string space_in(std::string_view text) {
  const std::string_view before = text.substr(0, text.find("<VTKFile"));
  for (const char* space : {"LPS", "RAS"})
    if (before.find(std::string("<!-- SPACE=") + space + " -->") != before.npos) return space;
  return {};
}

VtuHeader HeaderReader::read() {
  header_.space = space_in(text_);
  Tag tag = tags_.next();
  if (tag.name != "VTKFile") file_.fail("it is not a VTK XML file");
  take_file(tag);
  while (tag.name != "AppendedData" && tag.name != "/VTKFile") {
    tag = tags_.next();
    take(tag);
  }
  if (!has_piece_) file_.fail("it has no piece");
  if (tag.name == "AppendedData") take_data(tag);
  return std::move(header_);
}

/// Sections may have tags of other kinds in them.
void HeaderReader::take(const Tag& tag) {
  constexpr std::string_view sections[] = {"Points", "Cells", "PointData", "CellData", "FieldData"};
  if (tag.name == "Piece") take_piece(tag);
  else if (tag.name == "DataArray") take_array(tag);
  else if (std::ranges::find(sections, tag.name) != std::end(sections)) section_ = tag.name;
}

void HeaderReader::take_file(const Tag& tag) {
  if (tag["type"] != "UnstructuredGrid") file_.fail("it is not an unstructured grid");
  if (tag["byte_order"] != vtu_byte_order)
    file_.fail("its byte order is not " + std::string(vtu_byte_order));
  const std::string_view sizes = tag["header_type"], compressor = tag["compressor"];
  if (sizes != "UInt64" && sizes != "UInt32" && !sizes.empty())
    file_.fail("its header type is neither UInt64 nor UInt32");
  if (compressor != "vtkZLibDataCompressor" && !compressor.empty())
    file_.fail("it is compressed by another method than vtkZLibDataCompressor");
  header_.wide_sizes = sizes == "UInt64";
  header_.compressed = !compressor.empty();
}

void HeaderReader::take_piece(const Tag& tag) {
  if (has_piece_) file_.fail("it has several pieces");
  has_piece_ = true;
  header_.points = number(tag, "NumberOfPoints");
  header_.cells = number(tag, "NumberOfCells");
}

void HeaderReader::take_array(const Tag& tag) {
  const std::string name = section_ + "/" + std::string(tag["Name"]);
  VtuArrayEntry array{std::string(tag["type"])};
  if (!tag["NumberOfComponents"].empty()) array.components = number(tag, "NumberOfComponents");
  const std::string_view format = tag["format"];
  if (format == "appended") {
    appended_.push_back(name);
    array.place = number(tag, "offset");
  } else {
    array.encoding = format == "ascii" ? VtuEncoding::ascii : VtuEncoding::base64;
    array.place = tag.end;
  }
  if (!header_.arrays.emplace(name, array).second)
    file_.fail("it has two arrays " + name);
}

/// Offsets count from where the appended data begin.
void HeaderReader::take_data(const Tag& appended) {
  const std::string_view encoding = appended["encoding"];
  if (encoding != "raw" && encoding != "base64")
    file_.fail("its appended data is neither raw nor base64");
  header_.appended = true;
  const std::uint64_t begin = data_begin(appended);
  for (const std::string& name : appended_) {
    VtuArrayEntry& array = header_.arrays[name];
    if (array.place >= file_.size()) file_.fail("its array " + name + " lies beyond its end");
    array.place += begin;
    array.encoding = encoding == "raw" ? VtuEncoding::raw : VtuEncoding::base64;
  }
}

std::uint64_t HeaderReader::data_begin(const Tag& appended) const {
  const std::size_t underscore = text_.find_first_not_of(blanks, appended.end);
  if (underscore == text_.npos || text_[underscore] != '_')
    file_.fail("its appended data does not begin with an underscore");
  return underscore + 1;
}

std::uint64_t HeaderReader::number(const Tag& tag, std::string_view attribute) const {
  const std::string_view text = tag[attribute];
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    file_.fail("its " + std::string(attribute) + " is no number");
  return value;
}

}  // namespace

VtuHeader read_vtu_header(const InputFile& file) {
  constexpr std::uint64_t longest_header = 1 << 20;
  std::string text(std::min(file.size(), longest_header), '\0');
  file.read_at(0, std::as_writable_bytes(std::span(text)));
  // Where the data do not come behind the XML, they stand in it.
  if (text.size() < file.size() && text.find("<AppendedData") == text.npos) {
    text.resize(file.size());
    file.read_at(0, std::as_writable_bytes(std::span(text)));
  }
  return HeaderReader(text, file).read();
}

}  // namespace certet::formats
