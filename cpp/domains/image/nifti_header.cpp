#include "nifti_header.hpp"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>

#include "header_lines.hpp"
#include "image_file.hpp"

namespace certet {
namespace {

namespace fs = std::filesystem;

constexpr std::int32_t size_1 = 348, size_2 = 540;

/// The bytes of a header as they are stored, packed by gzip or not.
class Raw {
 public:
  explicit Raw(const fs::path& file) {
    const std::unique_ptr<gzFile_s, decltype(&gzclose)> stream(gzopen(file.c_str(), "rb"),
                                                               &gzclose);
    if (!stream) return;
    const int got = gzread(stream.get(), bytes_.data(), static_cast<unsigned>(bytes_.size()));
    length_ = std::max(got, 0);
    for (const bool swapped : {false, true}) {
      swapped_ = swapped;
      own_size_ = length_ < 4 ? 0 : number<std::int32_t>(0);
      if (own_size_ == size_1 || own_size_ == size_2) return;
    }
    own_size_ = 0;
  }

  /// 1 or 2 by its length; 0 for what is none of both.
  [[nodiscard]] int layout() const {
    return length_ < own_size_ || own_size_ == 0 ? 0 : own_size_ == size_1 ? 1 : 2;
  }
  [[nodiscard]] bool swapped() const { return swapped_; }
  [[nodiscard]] std::string_view text(std::size_t at, std::size_t length) const {
    return {reinterpret_cast<const char*>(bytes_.data()) + at, length};
  }

  template <class Number>
  [[nodiscard]] Number number(std::size_t at) const {
    std::array<unsigned char, sizeof(Number)> copy;
    std::memcpy(copy.data(), bytes_.data() + at, copy.size());
    if (swapped_) std::ranges::reverse(copy);
    return std::bit_cast<Number>(copy);
  }

 private:
  std::array<unsigned char, size_2> bytes_{};
  int length_ = 0;
  std::int32_t own_size_ = 0;
  bool swapped_ = false;
};

/// Where the fields of one version lie, and of what type they are.
class Fields {
 public:
  explicit Fields(const Raw& raw) : raw_(raw), second_(raw.layout() == 2) {}

  [[nodiscard]] std::int64_t dimension(std::size_t i) const {
    return second_ ? raw_.number<std::int64_t>(16 + 8 * i) : raw_.number<std::int16_t>(40 + 2 * i);
  }
  [[nodiscard]] int datatype() const { return raw_.number<std::int16_t>(second_ ? 12 : 70); }
  [[nodiscard]] int bits() const { return raw_.number<std::int16_t>(second_ ? 14 : 72); }
  [[nodiscard]] double pixdim(std::size_t i) const { return real(104, 76, i); }
  [[nodiscard]] double offset() const {
    return second_ ? static_cast<double>(raw_.number<std::int64_t>(168))
                   : raw_.number<float>(108);
  }
  [[nodiscard]] double slope() const { return real(176, 112, 0); }
  [[nodiscard]] double intercept() const { return real(184, 116, 0); }
  [[nodiscard]] int units() const {
    return second_ ? raw_.number<std::int32_t>(500) : raw_.text(123, 1)[0];
  }
  [[nodiscard]] int qform_code() const { return code(344, 252); }
  [[nodiscard]] int sform_code() const { return code(348, 254); }
  /// Three numbers of the quaternion, three of the offset, twelve of the matrix.
  [[nodiscard]] double placing(std::size_t i) const { return real(352, 256, i); }

 private:
  [[nodiscard]] double real(std::size_t at_2, std::size_t at_1, std::size_t i) const {
    return second_ ? raw_.number<double>(at_2 + 8 * i)
                   : double{raw_.number<float>(at_1 + 4 * i)};
  }
  [[nodiscard]] int code(std::size_t at_2, std::size_t at_1) const {
    return second_ ? raw_.number<std::int32_t>(at_2) : raw_.number<std::int16_t>(at_1);
  }
  const Raw& raw_;
  bool second_;
};

/// The file's name with its voxels' or its header's extension: .img and .hdr, in the
/// case that the name has, and packed or not.
fs::path partner(const fs::path& file, const char* extension) {
  const bool gz = lower(file.extension().string()) == ".gz";
  fs::path stem = gz ? file.stem() : file.filename();
  std::string other = extension;
  const std::string own = stem.extension().string();
  if (own.size() > 1 && own[1] >= 'A' && own[1] <= 'Z')
    for (char& c : other) c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  stem.replace_extension(other);
  const fs::path plain = file.parent_path() / stem;
  fs::path packed = plain;
  packed += ".gz";
  std::error_code failure;
  const bool other_way = gz ? !fs::exists(packed, failure) && fs::exists(plain, failure)
                            : !fs::exists(plain, failure) && fs::exists(packed, failure);
  return gz != other_way ? packed : plain;
}

bool has_extension(const fs::path& file, std::string_view extension) {
  const bool gz = lower(file.extension().string()) == ".gz";
  return lower((gz ? file.stem() : file).extension().string()) == extension;
}

fs::path header_file(const fs::path& file) {
  return has_extension(file, ".img") ? partner(file, ".hdr") : file;
}

/// \returns 0 for ANALYZE, -1 where the header is of no version that is known.
int version_of(const Raw& raw) {
  if (raw.layout() == 2) {
    const std::string_view word = raw.text(4, 8);
    const bool known = word.substr(0, 3) == "n+2" || word.substr(0, 3) == "ni2";
    return known && word.substr(3) == std::string_view("\0\r\n\032\n", 5) ? 2 : -1;
  }
  const std::string_view word = raw.text(344, 4);
  if (word == std::string_view("n+1\0", 4) || word == std::string_view("ni1\0", 4)) return 1;
  return word[0] == 'n' && (word[1] == '+' || word[1] == 'i') ? -1 : 0;
}

NumberType type_of(const fs::path& file, int datatype) {
  switch (datatype) {
    case 2: return NumberType::u8;
    case 4: return NumberType::i16;
    case 8: return NumberType::i32;
    case 16: return NumberType::f32;
    case 64: return NumberType::f64;
    case 256: return NumberType::i8;
    case 512: return NumberType::u16;
    case 768: return NumberType::u32;
    case 1024: return NumberType::i64;
    case 1280: return NumberType::u64;
    case 32: case 1792: case 2048: refuse(file, "has complex numbers for voxels");
    case 128: case 2304: refuse(file, "has colours for voxels, not 1 number each");
    default: refuse(file, "has voxels of a type that is not supported (NIfTI's number " +
                              std::to_string(datatype) + ")");
  }
}

/// Far from where a product of three of them leaves the range of a float.
constexpr double greatest = 1e12;

bool is_possible(double number) { return std::fabs(number) <= greatest; }

void check_coordinates(const fs::path& file, const Fields& fields) {
  bool possible = true;
  for (std::size_t i = 0; i < 4; ++i) possible = possible && is_possible(fields.pixdim(i));
  for (std::size_t i = 0; i < 18; ++i)  // what has no code is not looked at by anybody
    if (i < 6 ? fields.qform_code() > 0 : fields.sform_code() > 0)
      possible = possible && is_possible(fields.placing(i));
  if (!possible) refuse(file, "has a header with impossible coordinates");
}

void read_size(const fs::path& file, const Fields& fields, NiftiHeader& header) {
  const std::int64_t rank = fields.dimension(0);
  if (rank < 1 || rank > 7) refuse(file, "has an impossible number of dimensions");
  for (std::int64_t d = 1; d <= rank; ++d)
    if (const auto n = fields.dimension(static_cast<std::size_t>(d));
        n < 1 || n > std::int64_t{1} << 31)
      refuse(file, "has impossible dimensions");
  if (rank < 3) refuse(file, "has " + std::to_string(rank) + " dimensions, not 3");
  for (std::size_t a = 0; a < 3; ++a) header.size[a] = fields.dimension(a + 1);
  for (std::size_t d = 4; d <= static_cast<std::size_t>(rank); ++d) {
    header.volumes *= static_cast<std::uint64_t>(fields.dimension(d));
    if (header.volumes > std::uint64_t{1} << 31) refuse(file, "has impossible dimensions");
  }
}

NiftiPlace by_quaternion(const Fields& fields, double unit) {
  const double b = fields.placing(0), c = fields.placing(1), d = fields.placing(2);
  const double rest = 1 - (b * b + c * c + d * d);
  // A unit quaternion of less than the whole turn; what rounding leaves is cut off.
  const double norm = rest < 1e-7 ? 1 / std::sqrt(b * b + c * c + d * d) : 1;
  const double a = rest < 1e-7 ? 0 : std::sqrt(rest);
  const double x = b * norm, y = c * norm, z = d * norm;
  const double turn[3][3] = {
      {a * a + x * x - y * y - z * z, 2 * (x * y - a * z), 2 * (x * z + a * y)},
      {2 * (x * y + a * z), a * a + y * y - x * x - z * z, 2 * (y * z - a * x)},
      {2 * (x * z - a * y), 2 * (y * z + a * x), a * a + z * z - x * x - y * y}};
  const double mirrored = fields.pixdim(0) < 0 ? -1 : 1;
  NiftiPlace place;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t k = 0; k < 3; ++k)
      place.rows[r][k] =
          turn[r][k] * std::fabs(fields.pixdim(k + 1)) * unit * (k == 2 ? mirrored : 1);
    place.rows[r][3] = fields.placing(3 + r) * unit;
  }
  return place;
}

NiftiPlace by_matrix(const Fields& fields, double unit) {
  NiftiPlace place;
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t k = 0; k < 4; ++k) place.rows[r][k] = fields.placing(6 + 4 * r + k) * unit;
  return place;
}

/// Metres, millimetres or micrometres; other codes name no unit of length.
double unit_of(int units) {
  switch (units & 7) {
    case 1: return 1000;
    case 3: return 1e-3;
    default: return 1;
  }
}

void read_offset(const fs::path& file, const Fields& fields, bool single, NiftiHeader& header) {
  const double least = !single ? 0 : header.version == 2 ? size_2 + 4 : size_1 + 4;
  const double offset = fields.offset();
  if (!(offset >= 0 && offset <= greatest) || offset != std::floor(offset) ||
      (offset > 0 && offset < least))
    refuse(file, "has a header that says its voxels begin where they cannot");
  header.offset = static_cast<std::uint64_t>(offset == 0 ? least : offset);
}

/// No slope means that what is stored are the values.
void read_scale(const fs::path& file, const Fields& fields, NiftiHeader& header) {
  const double slope = fields.slope(), intercept = fields.intercept();
  if (header.version == 0 || slope == 0 || !std::isfinite(slope)) return;
  if (!std::isfinite(intercept)) refuse(file, "has an intercept of its values that is not finite");
  header.slope = slope;
  header.intercept = intercept;
}

}  // namespace

bool is_nifti(const fs::path& file) {
  const Raw raw(header_file(file));
  if (raw.layout() == 0) return false;
  return version_of(raw) != 0 || has_extension(file, ".hdr") || has_extension(file, ".img");
}

NiftiHeader read_nifti_header(const fs::path& file) {
  const fs::path place = header_file(file);
  const Raw raw(place);
  NiftiHeader header;
  header.version = version_of(raw);
  header.swapped = raw.swapped();
  if (header.version < 0) refuse(file, "is NIfTI of a version that is not known");
  const Fields fields(raw);
  check_coordinates(file, fields);
  read_size(file, fields, header);
  header.type = type_of(file, fields.datatype());
  if (fields.bits() != 0 && fields.bits() != static_cast<int>(8 * bytes_of(header.type)))
    refuse(file, "has a header that says " + std::to_string(fields.bits()) +
                     " bits per voxel, which do not fit its type of voxels");
  read_scale(file, fields, header);
  header.unit = header.version == 0 ? 1 : unit_of(fields.units());
  for (std::size_t a = 0; a < 3; ++a)
    header.spacing[a] = std::fabs(fields.pixdim(a + 1)) * header.unit;
  if (header.version > 0 && fields.qform_code() > 0)
    header.qform = by_quaternion(fields, header.unit);
  if (header.version > 0 && fields.sform_code() > 0) header.sform = by_matrix(fields, header.unit);
  const bool single = header.version > 0 && raw.text(header.version == 1 ? 344 : 4, 2) == "n+";
  read_offset(file, fields, single, header);
  header.voxel_file = single ? place : has_extension(file, ".img") ? file : partner(file, ".img");
  return header;
}

}  // namespace certet
