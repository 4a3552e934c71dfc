#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "cursor.hpp"
#include "middle_nodes_read.hpp"
#include "registry.hpp"
#include "vtu_bytes.hpp"
#include "vtu_header.hpp"
#include "vtu_layout.hpp"

namespace certet::formats {
namespace {

constexpr std::size_t numbers_at_once = 1 << 16;

struct NumberType {
  std::string_view name;
  std::uint64_t bytes;
  bool whole;
};
constexpr NumberType number_types[] = {
    {"Int8", 1, true},   {"UInt8", 1, true},  {"Int16", 2, true},   {"UInt16", 2, true},
    {"Int32", 4, true},  {"UInt32", 4, true}, {"Int64", 8, true},   {"UInt64", 8, true},
    {"Float32", 4, false}, {"Float64", 8, false}};

class VtuReader {
 public:
  VtuReader(const std::filesystem::path& path, const Context& context)
      : file_(path, &context), header_(read_vtu_header(file_)), data_end_(find_data_end()) {}

  FileMesh read();

 private:
  /// An array that can be what it should, as far as can be told from its type.
  struct Array {
    std::string name;
    VtuArrayEntry entry;
    NumberType type;
    std::uint64_t count;  ///< of its numbers
  };

  [[nodiscard]] std::uint64_t find_data_end() const;
  [[nodiscard]] Array find(const std::string& name, std::uint64_t elements,
                           std::uint64_t components, bool whole) const;
  void read_points(FileMesh& mesh) const;
  void read_cells(FileMesh& mesh) const;
  void read_mixed_cells(FileMesh& mesh, const std::vector<std::uint8_t>& types) const;
  void read_labels(FileMesh& mesh, const std::vector<std::uint8_t>& types) const;

  /// Calls work(number) for all numbers of an array in turn.
  template <class To, class Work>
  void for_each(const Array& array, Work work) const;
  template <class From, class To, class Work>
  void for_each_of(const Array& array, Work work) const;
  template <class To, class Work>
  void for_each_word(const Array& array, Work work) const;

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
  if ((end == tail.npos && header_.appended) || !tail.substr(0, last + 1).ends_with("</VTKFile>"))
    file_.fail("it is cut off: its last tag is missing");
  return header_.appended ? file_.size() - tail.size() + end : file_.size();
}

VtuReader::Array VtuReader::find(const std::string& name, std::uint64_t elements,
                                 std::uint64_t components, bool whole) const {
  const auto found = header_.arrays.find(name);
  if (found == header_.arrays.end()) file_.fail("it has no array " + name);
  const VtuArrayEntry& entry = found->second;
  const auto type = std::ranges::find(number_types, entry.type, &NumberType::name);
  if (type == std::end(number_types) || (whole && !type->whole))
    file_.fail("its array " + name + " is of type " + entry.type);
  // The file's length bounds every count before anything is multiplied: deflate
  // packs at most about a thousand bytes in one.
  const std::uint64_t greatest_ratio = header_.compressed ? 1040 : 1;
  // VTK leaves out the number of components where it follows from the name.
  const bool shaped = entry.components == components || name.starts_with("Cells/");
  const bool binary = entry.encoding != VtuEncoding::ascii;
  const std::uint64_t width = components * (binary ? type->bytes : 2);
  if (!shaped || elements / greatest_ratio / width > file_.size())
    file_.fail("the size of its array " + name +
               " does not agree with the numbers of points and cells");
  return {name, entry, *type, elements * components};
}

template <class From, class To, class Work>
void VtuReader::for_each_of(const Array& array, Work work) const {
  const std::uint64_t bytes = array.count * sizeof(From);
  const auto source = open_vtu_array(file_, header_, array.name, array.entry, bytes, data_end_);
  std::vector<From> numbers(std::min<std::uint64_t>(numbers_at_once, array.count));
  for (std::uint64_t first = 0; first < array.count; first += numbers_at_once) {
    const std::span<From> part =
        std::span(numbers).first(std::min<std::uint64_t>(numbers_at_once, array.count - first));
    source->read(std::as_writable_bytes(part));
    for (const From number : part) work(static_cast<To>(number));
  }
}

template <class To, class Work>
void VtuReader::for_each_word(const Array& array, Work work) const {
  Cursor words(file_);
  words.go_to(array.entry.place);
  words.checked(array.count, 2, "numbers");
  for (std::uint64_t i = 0; i < array.count; ++i) work(words.number<To>("a number"));
}

template <class To, class Work>
void VtuReader::for_each(const Array& array, Work work) const {
  const std::string_view type = array.type.name;
  if (array.entry.encoding == VtuEncoding::ascii) return for_each_word<To>(array, work);
  if (type == "Int8") return for_each_of<std::int8_t, To>(array, work);
  if (type == "UInt8") return for_each_of<std::uint8_t, To>(array, work);
  if (type == "Int16") return for_each_of<std::int16_t, To>(array, work);
  if (type == "UInt16") return for_each_of<std::uint16_t, To>(array, work);
  if (type == "Int32") return for_each_of<std::int32_t, To>(array, work);
  if (type == "UInt32") return for_each_of<std::uint32_t, To>(array, work);
  if (type == "Int64") return for_each_of<std::int64_t, To>(array, work);
  if (type == "UInt64") return for_each_of<std::uint64_t, To>(array, work);
  if (type == "Float32") return for_each_of<float, To>(array, work);
  return for_each_of<double, To>(array, work);
}

void VtuReader::read_points(FileMesh& mesh) const {
  const auto named = header_.arrays.lower_bound("Points/");
  const bool any = named != header_.arrays.end() && named->first.starts_with("Points/");
  const Array array = find(any ? named->first : "Points/Points", header_.points, 3, false);
  mesh.points.reserve(header_.points);
  std::size_t axis = 0;
  for_each<double>(array, [&](double coordinate) {
    if (axis == 0) mesh.points.emplace_back();
    mesh.points.back()[axis] = coordinate;
    axis = (axis + 1) % 3;
  });
}

/// Cells of no volume, which are passed over: points, lines, triangles, squares; the latter
/// three with middle nodes too.
bool is_flat(std::uint8_t type) { return (type >= 1 && type <= 9) || (type >= 21 && type <= 23); }

/// The nodes of a tetrahedron; 0 of all other cells.
std::uint64_t nodes_of(std::uint8_t type) {
  return type == vtk_tetra ? 4 : type == vtk_quadratic_tetra ? 10 : 0;
}

void VtuReader::read_cells(FileMesh& mesh) const {
  std::vector<std::uint8_t> types;
  for_each<std::int64_t>(find("Cells/types", header_.cells, 1, true), [&](std::int64_t type) {
    const auto known = static_cast<std::uint8_t>(std::clamp<std::int64_t>(type, 0, 255));
    if (nodes_of(known) == 0 && !is_flat(known)) file_.fail("it has cells other than tetrahedra");
    types.push_back(known);
  });
  const std::uint64_t nodes = types.empty() ? 4 : nodes_of(types.front());
  const bool mixed =
      nodes == 0 || !std::ranges::all_of(types, [&](auto type) { return type == types.front(); });
  if (mixed) {
    read_mixed_cells(mesh, types);
  } else {
    std::int64_t end = 0;
    for_each<std::int64_t>(find("Cells/offsets", header_.cells, 1, true), [&](std::int64_t at) {
      if (at != (end += static_cast<std::int64_t>(nodes)))
        file_.fail("its offsets are not those of tetrahedra");
    });
    mesh.tets.reserve(header_.cells);
    std::size_t place = 0;
    // A negative number becomes one that no point has.
    for_each<std::int64_t>(find("Cells/connectivity", header_.cells, nodes, true),
                           [&](std::int64_t point) {
                             take_node(mesh, place, static_cast<std::uint64_t>(point));
                             place = (place + 1) % nodes;
                           });
  }
  read_labels(mesh, types);
}

void VtuReader::read_mixed_cells(FileMesh& mesh, const std::vector<std::uint8_t>& types) const {
  std::vector<std::uint64_t> ends;
  for_each<std::int64_t>(find("Cells/offsets", header_.cells, 1, true), [&](std::int64_t at) {
    const std::uint64_t before = ends.empty() ? 0 : ends.back();
    const auto end = static_cast<std::uint64_t>(at);
    const std::uint64_t nodes = nodes_of(types[ends.size()]);
    if (at < 0 || end < before || (nodes != 0 && end - before != nodes))
      file_.fail("its offsets are not those of its cells");
    ends.push_back(end);
  });
  std::uint64_t cell = 0, at = 0;
  for_each<std::int64_t>(
      find("Cells/connectivity", ends.empty() ? 0 : ends.back(), 1, true),
      [&](std::int64_t point) {
        while (at == ends[cell]) ++cell;
        if (const std::uint64_t nodes = nodes_of(types[cell]); nodes != 0)
          take_node(mesh, nodes - (ends[cell] - at), static_cast<std::uint64_t>(point));
        ++at;
      });
}

/// By the name that this program gives them, or those that meshio does.
void VtuReader::read_labels(FileMesh& mesh, const std::vector<std::uint8_t>& types) const {
  for (const char* name : {"CellData/label", "CellData/medit:ref", "CellData/gmsh:physical"}) {
    if (!header_.arrays.contains(name)) continue;
    mesh.labels.reserve(mesh.tets.size());
    std::size_t cell = 0;
    for_each<std::int64_t>(find(name, header_.cells, 1, true), [&](std::int64_t label) {
      if (nodes_of(types[cell++]) == 0) return;
      if (!std::in_range<std::int32_t>(label)) file_.fail("it has a label beyond 32 bits");
      mesh.labels.push_back(static_cast<std::int32_t>(label));
    });
    return;
  }
}

FileMesh VtuReader::read() {
  FileMesh mesh;
  mesh.space = header_.space;
  read_points(mesh);
  read_cells(mesh);
  part_middle_nodes(mesh, usual_order, file_);
  return mesh;
}

}  // namespace

FileMesh read_vtu(const std::filesystem::path& file, const Context& context) {
  return VtuReader(file, context).read();
}

}  // namespace certet::formats
