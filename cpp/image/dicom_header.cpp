#include "dicom_header.hpp"

#include <array>
#include <fstream>
#include <string_view>

namespace certet {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t undefined = 0xffffffff;
constexpr std::uint32_t item = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd;

struct Element {
  std::uint32_t tag = 0, length = 0;
  bool sequence = false, unknown = false;
};

/// Elements from the beginning to the voxels, nested ones too.
class Walker {
 public:
  explicit Walker(const fs::path& file) : stream_(file, std::ios::binary) {
    std::error_code failure;
    end_ = fs::file_size(file, failure);
    stream_.seekg(132);
  }

  std::optional<DicomHeader> walk() {
    if (!walk_meta() || !syntax_is_known()) return {};
    explicit_ = syntax_ != "1.2.840.10008.1.2";
    return elements(end_, 0) ? std::optional(header_) : std::nullopt;
  }

 private:
  static constexpr int deepest = 32;

  [[nodiscard]] std::uint64_t here() { return static_cast<std::uint64_t>(stream_.tellg()); }

  bool number(int bytes, std::uint32_t& value) {
    std::array<unsigned char, 4> raw{};
    if (!stream_.read(reinterpret_cast<char*>(raw.data()), bytes)) return false;
    value = 0;
    for (int i = bytes; i-- > 0;) value = value << 8 | raw[static_cast<std::size_t>(i)];
    return true;
  }

  bool tag(std::uint32_t& value) {
    std::uint32_t group = 0, element = 0;
    if (!number(2, group) || !number(2, element)) return false;
    value = group << 16 | element;
    return true;
  }

  /// Tag, type and length.
  bool head(Element& element) {
    if (!tag(element.tag)) return false;
    if (element.tag >> 16 == 0xfffe || !explicit_) return number(4, element.length);
    char type[3] = "";
    if (!stream_.read(type, 2)) return false;
    const std::string_view name(type, 2);
    for (const char letter : name)
      if (letter < 'A' || letter > 'Z') return false;
    element.sequence = name == "SQ";
    element.unknown = name == "UN";
    constexpr std::string_view long_types = "OB OW OF OD OL OV SQ UC UR UT UN SV UV";
    if (long_types.find(name) == std::string_view::npos) return number(2, element.length);
    std::uint32_t reserved = 0;
    return number(2, reserved) && number(4, element.length);
  }

  bool skip(const Element& element, std::uint64_t end) {
    const std::uint64_t at = here();
    if (element.length > end - at) return false;
    stream_.seekg(static_cast<std::streamoff>(at + element.length));
    return true;
  }

  std::string text(const Element& element) {
    std::string value(std::min<std::uint32_t>(element.length, 64), '\0');
    const std::uint64_t at = here();
    stream_.read(value.data(), static_cast<std::streamsize>(value.size()));
    stream_.seekg(static_cast<std::streamoff>(at));
    while (!value.empty() && (value.back() == '\0' || value.back() == ' ')) value.pop_back();
    for (char& letter : value)
      if (letter < ' ' || letter > '~') letter = '?';
    return value;
  }

  bool keep_number(std::uint64_t& kept) {
    const std::uint64_t at = here();
    std::uint32_t value = 0;
    if (!number(2, value)) return false;
    stream_.seekg(static_cast<std::streamoff>(at));
    kept = value;
    return true;
  }

  bool keep(const Element& element) {
    switch (element.tag) {
      case 0x00020010: syntax_ = text(element); return true;
      case 0x0020000e: header_.series = text(element); return true;
      case 0x00280002: return keep_number(header_.samples);
      case 0x00280010: return keep_number(header_.rows);
      case 0x00280011: return keep_number(header_.columns);
      case 0x00280100: return keep_number(header_.bits);
      default: return true;
    }
  }

  /// The elements of group 2, which are explicit whatever follows.
  bool walk_meta() {
    for (;;) {
      const std::uint64_t at = here();
      Element element;
      if (!head(element)) return false;
      if (element.tag >> 16 != 2) {
        stream_.seekg(static_cast<std::streamoff>(at));
        return true;
      }
      if (element.length > end_ - here() || !keep(element) || !skip(element, end_)) return false;
    }
  }

  [[nodiscard]] bool syntax_is_known() const {
    constexpr std::string_view big_endian = "1.2.840.10008.1.2.2";
    constexpr std::string_view deflated = "1.2.840.10008.1.2.1.99";
    return syntax_.rfind("1.2.840.10008.1.2", 0) == 0 && syntax_ != big_endian &&
           syntax_ != deflated;
  }

  /// Up to `end`, to the mark that ends an item, or to the end of the voxels.
  bool elements(std::uint64_t end, int depth) {
    while (here() < end) {
      Element element;
      if (!head(element)) return false;
      if (element.tag == item_end) return depth > 0 && element.length == 0;
      if (element.tag == 0x7fe00010 && depth == 0) return voxels(element);
      if (!value(element, end, depth)) return false;
    }
    return here() == end;
  }

  bool value(const Element& element, std::uint64_t end, int depth) {
    if (element.tag >> 16 == 0xfffe || here() > end) return false;
    if (element.length == undefined) return nested(element, end, depth);
    if (element.length > end - here()) return false;
    if (element.sequence) return items(here() + element.length, depth + 1, false);
    if (depth == 0 && !keep(element)) return false;
    return skip(element, end);
  }

  /// Of unknown type, what is nested is implicit.
  bool nested(const Element& element, std::uint64_t end, int depth) {
    const bool kept = explicit_;
    if (element.unknown) explicit_ = false;
    const bool whole = items(end, depth + 1, true);
    explicit_ = kept;
    return whole;
  }

  bool items(std::uint64_t end, int depth, bool open_ended) {
    if (depth > deepest) return false;
    while (here() < end) {
      Element element;
      if (!head(element)) return false;
      if (element.tag == sequence_end) return open_ended && element.length == 0;
      if (element.tag != item || here() > end) return false;
      const bool open = element.length == undefined;
      if (!open && element.length > end - here()) return false;
      if (!elements(open ? end : here() + element.length, depth)) return false;
    }
    return !open_ended && here() == end;
  }

  bool voxels(const Element& element) {
    header_.packed = element.length == undefined;
    header_.pixel_bytes = header_.packed ? 0 : element.length;
    if (!header_.packed) return element.length <= end_ - here();
    while (here() < end_) {
      Element fragment;
      if (!head(fragment)) return false;
      if (fragment.tag == sequence_end) return true;
      if (fragment.tag != item || !skip(fragment, end_)) return false;
    }
    return false;
  }

  std::ifstream stream_;
  std::uint64_t end_ = 0;
  bool explicit_ = true;
  std::string syntax_;
  DicomHeader header_;
};

}  // namespace

std::optional<DicomHeader> read_dicom_header(const fs::path& file) {
  return Walker(file).walk();
}

}  // namespace certet
