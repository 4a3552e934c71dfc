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

class Reader {
 public:
  Reader(const InputFile& file, TriangleSurface& surface)
      : file_(file), text_(file), surface_(surface) {}

  void read() {
    header();
    for (const Element& element : elements_) {
      text_.judged(element.count, least_bytes(element), "elements");
      if (element.name == "vertex") judge_coordinates(element);
      for (std::uint64_t n = 0; n < element.count; ++n) one(element);
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

  void judge_coordinates(const Element& element) const {
    for (const char* name : {"x", "y", "z"})
      if (std::ranges::none_of(element.properties, [&](const Property& property) {
            return property.name == name && !property.count;
          }))
        file_.fail("its points have no coordinate " + std::string(name));
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
    if (form_ == Form::text) return text_.number<double>("a number");
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
  std::vector<Element> elements_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

void read_ply(const InputFile& file, TriangleSurface& surface) { Reader(file, surface).read(); }

}  // namespace certet
