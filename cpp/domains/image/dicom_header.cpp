#include "dicom_header.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <string_view>
#include <vector>

#include "dicom_runs.hpp"
#include "dicom_types.hpp"
#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t undefined = 0xffffffff;
constexpr std::uint32_t item = 0xfffee000, item_end = 0xfffee00d, sequence_end = 0xfffee0dd;
constexpr std::uint32_t recognition_code = 0x00080010;  // of what was before DICOM
constexpr std::uint32_t meta_length = 0x00020000;

/// Types of values by whether 16 or 32 bits hold their length.
constexpr std::string_view short_types =
    "AE AS AT CS DA DS DT FL FD IS LO LT PN SH SL SS ST TM UI UL US";
constexpr std::string_view long_types = "OB OW OF OD OL OV SQ UC UR UT UN SV UV";

struct Element {
  std::uint32_t tag = 0, length = 0;
  bool sequence = false, unknown = false;
};

/// Elements from the beginning to the voxels, nested ones too.
class Walker {
 public:
  explicit Walker(const fs::path& file) : file_(file), stream_(file, std::ios::binary) {
    std::error_code failure;
    end_ = fs::file_size(file, failure);
    stream_.seekg(132);
  }

  std::optional<DicomHeader> walk() {
    if (!walk_meta()) return {};
    check_syntax();
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
    element.sequence = !explicit_ && is_known_sequence(element.tag);
    if (element.tag >> 16 == 0xfffe || !explicit_) return number(4, element.length);
    char type[3] = "";
    if (!stream_.read(type, 2)) return false;
    const std::string_view name(type, 2);
    if (name[0] < 'A' || name[0] > 'Z' || !is_of_its_type(element.tag, name)) return false;
    element.sequence = name == "SQ";
    element.unknown = name == "UN";
    if (short_types.find(name) != name.npos) return number(2, element.length);
    std::uint32_t reserved = 0;
    return long_types.find(name) != name.npos && number(2, reserved) && reserved == 0 &&
           number(4, element.length);
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

  bool keep_frames(const std::string& text) {
    header_.counts_frames = true;
    const char* const first = text.data() + std::min(text.find_first_not_of(" +"), text.size());
    const char* const end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(first, end, header_.frames);
    return text.empty() || (failure == std::errc() && stop == end && header_.frames >= 1 &&
                            header_.frames <= std::uint64_t{1} << 31);
  }

  bool keep(const Element& element) {
    switch (element.tag) {
      case recognition_code: return false;
      case 0x00020010: syntax_ = text(element); return true;
      case 0x00080016: header_.kind = text(element); return true;
      case 0x0020000e: header_.series = text(element); return true;
      case 0x00280002: return keep_number(header_.samples);
      case 0x00280004: header_.photometric = text(element); return true;
      case 0x00280008: return keep_frames(text(element));
      case 0x00280009: return header_.tells_increment = true;
      case 0x00280010: return keep_number(header_.rows);
      case 0x00280011: return keep_number(header_.columns);
      case 0x00280100: return keep_number(header_.bits);
      case 0x00280101: return keep_number(header_.bits_stored);
      case 0x00280102: return keep_number(header_.high_bit);
      case 0x00280103: return keep_number(header_.is_signed);
      default: return true;
    }
  }

  /// The elements of group 2, which are explicit whatever follows; the first one
  /// says how long the others are.
  bool walk_meta() {
    Element first;
    std::uint32_t length = 0;
    if (!head(first) || first.tag != meta_length || first.length != 4 || !number(4, length) ||
        length > end_ - here())
      return false;
    const std::uint64_t end = here() + length;
    for (std::uint32_t before = first.tag; here() < end;) {
      Element element;
      if (!head(element) || element.tag <= before || element.tag >> 16 != 2 || here() > end ||
          element.length > end - here() || !keep(element) || !skip(element, end))
        return false;
      before = element.tag;
    }
    return here() == end;
  }

  void check_syntax() const {
    constexpr std::string_view big_endian = "1.2.840.10008.1.2.2";
    constexpr std::string_view deflated = "1.2.840.10008.1.2.1.99";
    const auto refuse_syntax = [&](const std::string& what) {
      refuse(file_, "is DICOM " + what + ", which is not supported");
    };
    if (syntax_ == big_endian) refuse_syntax("with the highest byte first");
    if (syntax_ == deflated) refuse_syntax("that is deflated as a whole");
    if (syntax_.rfind("1.2.840.10008.1.2", 0) != 0)
      refuse_syntax("of an unknown transfer syntax, '" + syntax_ + "'");
  }

  /// Up to `end`, or to the mark that ends an item; their tags ascend.
  bool elements(std::uint64_t end, int depth) {
    for (std::uint32_t before = 0x0002ffff; here() < end;) {
      Element element;
      if (!head(element)) return false;
      if (element.tag == item_end) return depth > 0 && element.length == 0;
      if (element.tag <= before) return false;
      before = element.tag;
      const bool own_voxels = element.tag == pixel_data && depth == 0;
      const bool icon = element.tag == pixel_data && depth > 0 && element.length == undefined;
      if (!(own_voxels ? voxels(element)
            : icon     ? fragments(end, false)
                       : value(element, end, depth)))
        return false;
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
    if (!header_.packed) return skip(element, end_);
    return fragments(end_, syntax_ == "1.2.840.10008.1.2.5");
  }

  /// Of packed voxels, a fragment for each frame where these are in runs.  The first
  /// one says where frames begin.
  bool fragments(std::uint64_t end, bool in_runs) {
    for (std::uint64_t number = 0; here() < end; ++number) {
      Element fragment;
      if (!head(fragment)) return false;
      if (fragment.tag == sequence_end)
        return fragment.length == 0 && (!in_runs || number == header_.frames + 1);
      if (fragment.tag != item || here() > end || fragment.length > end - here()) return false;
      if (in_runs && number >= 1 ? !runs(fragment) : !skip(fragment, end)) return false;
    }
    return false;
  }

  bool runs(const Element& fragment) {
    std::vector<unsigned char> packed(fragment.length);
    return stream_.read(reinterpret_cast<char*>(packed.data()), fragment.length) &&
           whole_runs(packed, header_.samples * (header_.bits / 8), header_.rows * header_.columns);
  }

  fs::path file_;
  std::ifstream stream_;
  std::uint64_t end_ = 0;
  bool explicit_ = true;
  std::string syntax_;
  DicomHeader header_;
};

}  // namespace

bool DicomHeader::holds_voxels() const {
  if (rows == 0) return true;
  const bool single_bits = bits == 1 && bits_stored == 1 && is_segmentation();
  const bool whole_bytes = bits == 8 || bits == 16 || bits == 32 || bits == 64;
  return (whole_bytes || single_bits) && bits_stored > 0 && bits_stored <= bits &&
         high_bit + 1 == bits_stored && is_signed <= 1 && samples >= 1 && samples <= 4 &&
         (packed || (pixel_bytes >= (rows * columns * bits + 7) / 8 &&
                     pixel_bytes / frames >= rows * columns * samples * bits / 8));
}

bool DicomHeader::is_segmentation() const {
  return kind == "1.2.840.10008.5.1.4.1.1.66.4" || kind == "1.2.840.10008.5.1.4.1.1.66.7";
}

std::optional<DicomHeader> read_dicom_header(const fs::path& file) {
  return Walker(file).walk();
}

}  // namespace certet
