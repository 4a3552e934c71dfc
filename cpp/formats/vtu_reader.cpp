#include <algorithm>
#include <array>
#include <string>

#include "input_file.hpp"
#include "registry.hpp"
#include "vtu_header.hpp"
#include "vtu_layout.hpp"

namespace certet::formats {
namespace {

constexpr std::size_t batch = 1 << 16;

class VtuReader {
 public:
  explicit VtuReader(const std::filesystem::path& path)
      : file_(path), header_(read_vtu_header(file_)), data_end_(find_data_end()) {}

  FileMesh read() {
    FileMesh mesh;
    read_points(mesh);
    check_shape();
    read_connectivity(mesh);
    read_labels(mesh);
    return mesh;
  }

 private:
  /// An array that holds what it should, as far as can be told from its size.
  struct Array {
    std::uint64_t place;  ///< of its numbers in the file
    std::uint64_t count;  ///< of its numbers
    bool wide;            ///< Int64, where Int32 could be
  };

  [[nodiscard]] std::uint64_t find_data_end() const;
  [[nodiscard]] Array find(const std::string& name, std::uint64_t elements,
                           std::uint64_t components,
                           std::span<const std::string_view> types) const;
  void read_points(FileMesh& mesh) const;
  void check_shape() const;
  void read_connectivity(FileMesh& mesh) const;
  void read_labels(FileMesh& mesh) const;

  /// Calls work(first, numbers) for all numbers of an array in turn.
  template <class T, class Work>
  void for_batches(const Array& array, Work work) const;

  InputFile file_;
  VtuHeader header_;
  std::uint64_t data_end_;
};

/// A file that was cut off does not end with its last tag.
std::uint64_t VtuReader::find_data_end() const {
  constexpr std::uint64_t longest_footer = 256;
  std::string tail(std::min(file_.size(), longest_footer), '\0');
  file_.read_at(file_.size() - tail.size(), std::as_writable_bytes(std::span(tail)));
  const std::size_t end = tail.rfind("</AppendedData>");
  const std::size_t last = tail.find_last_not_of(" \t\r\n");
  if (end == tail.npos || !tail.substr(0, last + 1).ends_with("</VTKFile>"))
    file_.fail("it is cut off: its last tag is missing");
  return file_.size() - tail.size() + end;
}

constexpr std::string_view float64[] = {"Float64"};
constexpr std::string_view int32[] = {"Int32"};
constexpr std::string_view uint8[] = {"UInt8"};
constexpr std::string_view indices[] = {"Int32", "Int64"};

std::uint64_t bytes_of(std::string_view type) {
  if (type == "UInt8") return 1;
  return type == "Int32" ? 4 : 8;
}

VtuReader::Array VtuReader::find(const std::string& name, std::uint64_t elements,
                                 std::uint64_t components,
                                 std::span<const std::string_view> types) const {
  const auto found = header_.arrays.find(name);
  if (found == header_.arrays.end()) file_.fail("it has no array " + name);
  const VtuArrayEntry& entry = found->second;
  if (std::ranges::find(types, entry.type) == types.end())
    file_.fail("its array " + name + " is of type " + entry.type);
  const std::string damaged =
      "the size of its array " + name + " does not agree with the numbers of points and cells";
  // The file's length bounds every count before anything is multiplied.
  const std::uint64_t width = bytes_of(entry.type);
  if (elements > file_.size() || entry.place + sizeof(std::uint64_t) > data_end_)
    file_.fail(damaged);
  std::uint64_t bytes = 0;
  file_.read_at(entry.place, std::as_writable_bytes(std::span(&bytes, 1)));
  const std::uint64_t begin = entry.place + sizeof bytes;
  if (bytes > data_end_ - begin) file_.fail("its array " + name + " is cut off");
  // VTK leaves out the number of components where it follows from the name.
  const bool shaped = entry.components == components || name.starts_with("Cells/");
  if (!shaped || bytes != elements * components * width) file_.fail(damaged);
  return {begin, elements * components, width == 8};
}

void VtuReader::read_points(FileMesh& mesh) const {
  const Array array = find("Points/Points", header_.points, 3, float64);
  mesh.points.resize(header_.points);
  file_.read_at(array.place, std::as_writable_bytes(std::span(mesh.points)));
}

template <class T, class Work>
void VtuReader::for_batches(const Array& array, Work work) const {
  std::vector<T> numbers(std::min<std::uint64_t>(batch, array.count));
  for (std::uint64_t first = 0; first < array.count; first += batch) {
    const std::span<T> part =
        std::span(numbers).first(std::min<std::uint64_t>(batch, array.count - first));
    file_.read_at(array.place + first * sizeof(T), std::as_writable_bytes(part));
    work(first, std::span<const T>(part));
  }
}

/// Every cell must be a tetrahedron, and the fourfold of its number the end of
/// its points.
void VtuReader::check_shape() const {
  const Array types = find("Cells/types", header_.cells, 1, uint8);
  for_batches<std::uint8_t>(types, [&](std::uint64_t, std::span<const std::uint8_t> part) {
    if (!std::ranges::all_of(part, [](std::uint8_t type) { return type == vtk_tetra; }))
      file_.fail("it has cells other than tetrahedra");
  });
  const Array offsets = find("Cells/offsets", header_.cells, 1, indices);
  const auto check = [&](std::uint64_t first, auto part) {
    for (std::size_t i = 0; i < part.size(); ++i)
      if (static_cast<std::uint64_t>(part[i]) != 4 * (first + i + 1))
        file_.fail("its offsets are not those of tetrahedra");
  };
  if (offsets.wide)
    for_batches<std::int64_t>(offsets, check);
  else
    for_batches<std::int32_t>(offsets, check);
}

void VtuReader::read_connectivity(FileMesh& mesh) const {
  const Array array = find("Cells/connectivity", header_.cells, 4, indices);
  mesh.tets.resize(header_.cells);
  if (array.wide) {
    file_.read_at(array.place, std::as_writable_bytes(std::span(mesh.tets)));
    return;
  }
  // A negative number becomes one that no point has.
  for_batches<std::int32_t>(array, [&](std::uint64_t first, std::span<const std::int32_t> part) {
    for (std::size_t i = 0; i < part.size(); ++i)
      mesh.tets[(first + i) / 4][(first + i) % 4] = static_cast<std::uint64_t>(part[i]);
  });
}

void VtuReader::read_labels(FileMesh& mesh) const {
  if (!header_.arrays.contains("CellData/label")) return;
  const Array array = find("CellData/label", header_.cells, 1, int32);
  mesh.labels.resize(header_.cells);
  file_.read_at(array.place, std::as_writable_bytes(std::span(mesh.labels)));
}

}  // namespace

FileMesh read_vtu(const std::filesystem::path& file) { return VtuReader(file).read(); }

}  // namespace certet::formats
