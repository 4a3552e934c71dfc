#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "polygons.hpp"
#include "surface_file.hpp"

namespace certet {
namespace {

using formats::Cursor;
using formats::InputFile;

enum class Form { text, little, big };

/// How a number is stored.
struct Type {
  std::size_t bytes;
  enum { sign, no_sign, real } kind;
};

struct Property {
  std::string name;
  Type type;
  std::optional<Type> count;  ///< of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

class PlyReader {
  static constexpr const char* blanks = " \t\r\v\f";

 public:
  PlyReader(const InputFile& file, TriangleSurface& surface)
      : file_(file), text_(file), surface_(surface) {}

  void read() {
    header();
    for (const Element& element : elements_) {
      text_.checked(element.count, least_bytes(element), "elements");
      if (element.name == "vertex") check_coordinates(element);
      for (std::uint64_t n = 0; n < element.count; ++n) {
        if (form_ == Form::text) next_row(element, n);
        one(element);
        if (form_ == Form::text && !word().empty()) refuse_row("more");
      }
    }
  }

 private:
  void header() {
    if (text_.word() != "ply") file_.fail("it does not begin with the word ply");
    for (;;) {
      const std::string word(text_.word());
      if (word.empty()) file_.fail("it has no end of its PLY header");
      if (word == "end_header") break;
      if (word == "format") form();
      else if (word == "element") element();
      else if (word == "property") property();
      else if (word != "comment" && word != "obj_info")
        file_.fail("its header has " + formats::in_quotes(word));
      text_.line();
    }
    text_.line();
  }

  void form() {
    const std::string word(text_.word());
    if (word == "ascii") form_ = Form::text;
    else if (word == "binary_little_endian") form_ = Form::little;
    else if (word == "binary_big_endian") form_ = Form::big;
    else file_.fail(formats::in_quotes(word) + " is not a form of PLY");
  }

  void element() {
    Element element;
    element.name = text_.word();
    element.count = count_in(text_.word(), file_);
    elements_.push_back(std::move(element));
  }

  void property() {
    if (elements_.empty()) file_.fail("its header has a property of nothing");
    Property property;
    std::string word(text_.word());
    if (word == "list") {
      property.count = type(std::string(text_.word()));
      word = text_.word();
    }
    property.type = type(word);
    property.name = text_.word();
    elements_.back().properties.push_back(std::move(property));
  }

  Type type(std::string_view word) const {
    static constexpr std::array<std::pair<std::string_view, Type>, 16> types{{
        {"char", {1, Type::sign}}, {"int8", {1, Type::sign}},
        {"uchar", {1, Type::no_sign}}, {"uint8", {1, Type::no_sign}},
        {"short", {2, Type::sign}}, {"int16", {2, Type::sign}},
        {"ushort", {2, Type::no_sign}}, {"uint16", {2, Type::no_sign}},
        {"int", {4, Type::sign}}, {"int32", {4, Type::sign}},
        {"uint", {4, Type::no_sign}}, {"uint32", {4, Type::no_sign}},
        {"float", {4, Type::real}}, {"float32", {4, Type::real}},
        {"double", {8, Type::real}}, {"float64", {8, Type::real}}}};
    for (const auto& [name, type] : types)
      if (name == word) return type;
    file_.fail(formats::in_quotes(word) + " is not a type of PLY");
  }

  /// Of a list the count alone must be there.  Elements without a property would
  /// take no bytes at all.
  std::uint64_t least_bytes(const Element& element) const {
    if (element.properties.empty()) file_.fail("its header has an element without a property");
    std::uint64_t bytes = 0;
    for (const auto& [name, type, count] : element.properties)
      bytes += form_ == Form::text ? 1 : count.value_or(type).bytes;
    return bytes;
  }

  void check_coordinates(const Element& element) const {
    for (const char* name : {"x", "y", "z"})
      if (std::ranges::none_of(element.properties, [&](const Property& property) {
            return property.name == name && !property.count;
          }))
        file_.fail("its points have no coordinate " + std::string(name));
  }

  /// Of a text: a line is one of an element.
  void next_row(const Element& element, std::uint64_t number) {
    row_of_ = &element;
    row_number_ = number + 1;
    do {
      if (text_.remaining() == 0) file_.fail("it is cut off");
      row_ = text_.line();
      at_ = 0;
    } while (row_.find_first_not_of(blanks) == row_.npos);
  }

  /// The next one of the row; empty at its end.
  std::string_view word() {
    const std::size_t begin = std::min(row_.find_first_not_of(blanks, at_), row_.size());
    at_ = std::min(row_.find_first_of(blanks, begin), row_.size());
    return std::string_view(row_).substr(begin, at_ - begin);
  }

  [[noreturn]] void refuse_row(const char* how) const {
    file_.fail("row " + std::to_string(row_number_) + " of the " +
               std::to_string(row_of_->count) + " of its element " +
               formats::in_quotes(row_of_->name) + " has " + how +
               " numbers than its header declares");
  }

  double number_of_row() {
    const std::string_view next = word();
    if (next.empty()) refuse_row("fewer");
    double value = 0;
    const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), value);
    if (error != std::errc() || end != next.data() + next.size())
      file_.fail(formats::in_quotes(next) + " is not a number");
    return value;
  }

  void one(const Element& element) {
    Point3 point{0, 0, 0};
    for (const Property& property : element.properties) {
      if (property.count) {
        list(element, property);
        continue;
      }
      const double value = number(property.type);
      if (element.name == "vertex" && property.name.size() == 1 && property.name >= "x" &&
          property.name <= "z")
        point[static_cast<std::size_t>(property.name[0] - 'x')] = coordinate(value, file_);
    }
    if (element.name == "vertex") surface_.points.push_back(point);
  }

  void list(const Element& element, const Property& property) {
    const double count = number(*property.count);
    const bool corners = element.name == "face" && (property.name == "vertex_indices" ||
                                                    property.name == "vertex_index");
    if (!(count >= 0 && count <= (corners ? most_corners : 1e9)) || count != std::floor(count))
      file_.fail("it has a list of an impossible length");
    corners_.clear();
    for (auto left = static_cast<std::uint64_t>(count); left > 0; --left) {
      const double index = number(property.type);
      if (corners) corners_.push_back(corner(index, surface_, file_));
    }
    add_polygon(corners_, surface_);
  }

  double number(Type type) {
    if (form_ == Form::text) return number_of_row();
    std::array<std::byte, 8> bytes{};
    text_.bytes(std::span(bytes).first(type.bytes));
    if ((form_ == Form::big) == (std::endian::native == std::endian::little))
      std::ranges::reverse(std::span(bytes).first(type.bytes));
    if (type.kind == Type::real)
      return type.bytes == 4 ? taken<float>(bytes) : taken<double>(bytes);
    const bool sign = type.kind == Type::sign;
    if (type.bytes == 1) return sign ? taken<std::int8_t>(bytes) : taken<std::uint8_t>(bytes);
    if (type.bytes == 2) return sign ? taken<std::int16_t>(bytes) : taken<std::uint16_t>(bytes);
    return sign ? taken<std::int32_t>(bytes) : taken<std::uint32_t>(bytes);
  }

  template <class Number>
  static double taken(const std::array<std::byte, 8>& bytes) {
    Number value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  }

  const InputFile& file_;
  Cursor text_;
  TriangleSurface& surface_;
  Form form_ = Form::text;
  std::string row_;     ///< of a text, and how far it is read
  std::size_t at_ = 0;
  const Element* row_of_ = nullptr;
  std::uint64_t row_number_ = 0;  ///< from 1
  std::vector<Element> elements_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

void read_ply(const InputFile& file, TriangleSurface& surface) { PlyReader(file, surface).read(); }

}  // namespace certet
