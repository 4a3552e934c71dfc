// Gmsh 4.1 and 2.2, ASCII and binary.

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include "certet/survey.hpp"
#include "cursor.hpp"
#include "gmsh_elements.hpp"
#include "gmsh_labels.hpp"
#include "middle_nodes_read.hpp"
#include "names.hpp"
#include "registry.hpp"

namespace certet::formats {
namespace {

/// The points of each type of element, where they are known; 0 elsewhere.
constexpr std::array<std::uint8_t, 32> corners_of{0, 2, 3, 4, 4, 8, 6, 5, 3, 6, 9, 10, 27, 18, 14, 1,
                                                  8, 20, 15, 13, 9, 10, 12, 15, 15, 21, 4, 5, 6, 20,
                                                  35, 56};

/// Types that fill space.
constexpr bool is_solid(std::int32_t type) {
  return (type >= 4 && type <= 7) || (type >= 11 && type <= 14) ||
         (type >= 17 && type <= 19) || type >= 29;
}

constexpr bool is_tetrahedron(std::int32_t type) {
  return type == gmsh_tetrahedron || type == gmsh_tetrahedron_10;
}
constexpr bool is_triangle(std::int32_t type) {
  return type == gmsh_triangle || type == gmsh_triangle_6;
}

class GmshReader {
 public:
  GmshReader(const std::filesystem::path& path, const Context& context)
      : file_(path, &context), cursor_(file_) {}

  FileMesh read();

 private:
  void read_format();
  void read_names();
  void read_entities();
  void read_nodes();
  void read_nodes_22();
  void read_elements();
  void read_elements_22();
  void read_element_block_22(std::int32_t type, std::uint64_t count, std::uint64_t tags);
  void read_comments();
  void take_tet(std::uint64_t tag, std::int32_t group, std::int32_t entity);
  void check_type(std::int32_t type) const;
  std::int32_t read_entity(std::uint64_t coordinates);

  void order_points();
  void order_tets();
  void finish_labels();
  void finish_surfaces();
  [[nodiscard]] std::uint64_t index_of(std::uint64_t tag) const;

  /// Numbers as the file has them: in words or in binary.
  std::int32_t integer() {
    return binary_ ? cursor_.binary<std::int32_t>() : cursor_.number<std::int32_t>("a tag");
  }
  std::uint64_t size() {
    return binary_ ? cursor_.binary<std::uint64_t>() : cursor_.number<std::uint64_t>("a number");
  }
  double real() {
    return binary_ ? cursor_.binary<double>() : cursor_.number<double>("a coordinate");
  }
  /// In version 2.2, which counts with 32 bits.
  std::uint64_t tag_22() {
    return binary_ ? static_cast<std::uint64_t>(cursor_.binary<std::int32_t>())
                   : cursor_.number<std::uint64_t>("a tag");
  }
  std::uint64_t checked(std::uint64_t count, std::uint64_t words, std::uint64_t bytes,
                       const char* things) const {
    return cursor_.checked(count, binary_ ? bytes : 2 * words, things);
  }
  /// Binary numbers begin on the line after the words.
  void to_next_line() {
    if (binary_) cursor_.line();
  }

  InputFile file_;
  Cursor cursor_;
  bool binary_ = false, version_22_ = false;
  bool has_nodes_ = false, has_elements_ = false;
  std::map<std::int32_t, std::int32_t> group_of_volume_, group_of_surface_;
  std::map<std::int32_t, std::string> surface_names_;  ///< of groups
  std::map<std::int32_t, std::vector<std::array<std::uint64_t, 3>>> surfaces_;
  std::map<std::int32_t, std::int32_t> label_of_group_;  ///< where it is not the group's number
  std::vector<std::uint64_t> point_tags_, tet_tags_;
  std::vector<std::int32_t> entities_;  ///< of the tetrahedra
  FileMesh mesh_;
};

FileMesh GmshReader::read() {
  read_format();
  for (;;) {
    const std::string section(cursor_.word());
    if (section.empty()) break;
    if (section.front() != '$' || section.size() > 60)
      file_.fail("it is damaged: " + in_quotes(section) + " is not a section");
    if (section == "$PhysicalNames") read_names();
    if (section == "$Comments") read_comments();
    if (section == "$Entities" && !version_22_) read_entities();
    if (section == "$Nodes" && !std::exchange(has_nodes_, true))
      version_22_ ? read_nodes_22() : read_nodes();
    if (section == "$Elements" && !std::exchange(has_elements_, true))
      version_22_ ? read_elements_22() : read_elements();
    cursor_.skip_past("$End" + section.substr(1));
  }
  if (!has_nodes_ || !has_elements_) file_.fail("it has no nodes or no elements");
  order_points();
  order_tets();
  finish_surfaces();
  finish_labels();
  part_middle_nodes(mesh_, gmsh_order, file_);
  return std::move(mesh_);
}

void GmshReader::read_format() {
  if (cursor_.word() != "$MeshFormat") file_.fail("it is not a Gmsh mesh");
  const std::string version(cursor_.word());
  if (version != "4.1" && version != "2.2")
    file_.fail("version " + in_quotes(version) + " of Gmsh's format is not known; 4.1 and 2.2 are");
  version_22_ = version == "2.2";
  binary_ = cursor_.number<int>("0 or 1") != 0;
  if (cursor_.number<int>("a size") != 8) file_.fail("its numbers are not of 8 bytes");
  to_next_line();
  if (binary_ && cursor_.binary<std::int32_t>() != 1)
    file_.fail("its byte order is not this machine's");
  cursor_.skip_past("$EndMeshFormat");
}

/// Always in words; those of volumes and of surfaces are kept.
void GmshReader::read_names() {
  const auto count =
      cursor_.checked(cursor_.number<std::uint64_t>("a number"), 6, "physical names");
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto dimension = cursor_.number<int>("a dimension");
    const auto tag = cursor_.number<std::int32_t>("a tag");
    const std::string_view line = cursor_.line();
    const std::size_t begin = line.find('"'), end = line.rfind('"');
    if (begin == line.npos || end == begin) file_.fail("it has a physical name without quotes");
    const std::string_view name = line.substr(begin + 1, end - begin - 1);
    if (dimension == 3) mesh_.names[tag] = name;
    if (dimension == 2) surface_names_[tag] = name;
  }
}

/// Whatever they are; what this program has to say there is kept.
void GmshReader::read_comments() {
  cursor_.line();
  while (cursor_.remaining() > 0) {
    const std::uint64_t begin = cursor_.position();
    const std::string_view line = cursor_.line();
    if (line.find("$EndComments") != line.npos) return cursor_.go_to(begin);
    read_gmsh_label(line, label_of_group_);
  }
}

/// A box (or, of a point, its place), physical groups and the tags of what
/// bounds it.  \returns the first group, or 0.
std::int32_t GmshReader::read_entity(std::uint64_t coordinates) {
  for (std::uint64_t i = 0; i < coordinates; ++i) real();
  const std::uint64_t groups = checked(size(), 1, 4, "physical groups");
  std::int32_t first = 0;
  for (std::uint64_t i = 0; i < groups; ++i) {
    const std::int32_t group = integer();
    if (i == 0) first = group;
  }
  if (coordinates == 6) {
    const std::uint64_t bounds = checked(size(), 1, 4, "tags");
    for (std::uint64_t i = 0; i < bounds; ++i) integer();
  }
  return first;
}

void GmshReader::read_entities() {
  to_next_line();
  std::array<std::uint64_t, 4> counts;
  for (std::uint64_t& count : counts) count = checked(size(), 5, 4 + 24 + 8, "entities");
  for (std::size_t dimension = 0; dimension < 4; ++dimension)
    for (std::uint64_t i = 0; i < counts[dimension]; ++i) {
      const std::int32_t tag = integer();
      const std::int32_t group = read_entity(dimension == 0 ? 3 : 6);
      if (dimension == 3 && group != 0) group_of_volume_[tag] = group;
      if (dimension == 2 && group != 0) group_of_surface_[tag] = group;
    }
}

void GmshReader::read_nodes() {
  to_next_line();
  const std::uint64_t blocks = checked(size(), 4, 3 * 4 + 8, "blocks of nodes");
  const std::uint64_t total = checked(size(), 4, 8 + 24, "nodes");
  size(), size();  // the least and the greatest tag
  point_tags_.reserve(total);
  mesh_.points.reserve(total);
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::int32_t dimension = integer();
    integer();  // of the entity
    const bool parametric = integer() != 0;
    const std::uint64_t count = checked(size(), 4, 8 + 24, "nodes");
    if (count > total - point_tags_.size()) file_.fail("it has more nodes than it announces");
    for (std::uint64_t i = 0; i < count; ++i) point_tags_.push_back(size());
    for (std::uint64_t i = 0; i < count; ++i) {
      Point3& point = mesh_.points.emplace_back();
      for (double& coordinate : point) coordinate = real();
      for (std::int32_t p = 0; parametric && p < std::min(dimension, 3); ++p) real();
    }
  }
}

void GmshReader::read_nodes_22() {
  const std::uint64_t total =
      checked(cursor_.number<std::uint64_t>("a number"), 4, 4 + 24, "nodes");
  to_next_line();
  point_tags_.reserve(total);
  mesh_.points.reserve(total);
  for (std::uint64_t i = 0; i < total; ++i) {
    point_tags_.push_back(tag_22());
    Point3& point = mesh_.points.emplace_back();
    for (double& coordinate : point) coordinate = real();
  }
}

void GmshReader::check_type(std::int32_t type) const {
  if (type < 1 || type >= static_cast<std::int32_t>(corners_of.size()) ||
      corners_of[static_cast<std::size_t>(type)] == 0)
    file_.fail("it has elements of the type " + std::to_string(type) + ", which is not known");
  if (is_solid(type) && !is_tetrahedron(type))
    file_.fail("it has cells other than tetrahedra of four or ten nodes");
}

void GmshReader::read_elements() {
  to_next_line();
  const std::uint64_t blocks = checked(size(), 4, 3 * 4 + 8, "blocks of elements");
  checked(size(), 2, 16, "elements");
  size(), size();  // the least and the greatest tag
  for (std::uint64_t block = 0; block < blocks; ++block) {
    integer();  // the dimension
    const std::int32_t entity = integer();
    const std::int32_t type = integer();
    check_type(type);
    const auto corners = corners_of[static_cast<std::size_t>(type)];
    const std::uint64_t words = 1 + std::uint64_t{corners};
    const std::uint64_t count = checked(size(), words, 8 * words, "elements");
    const auto& groups = is_triangle(type) ? group_of_surface_ : group_of_volume_;
    const auto group = groups.find(entity);
    const std::int32_t physical = group == groups.end() ? 0 : group->second;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t tag = size();
      if (is_tetrahedron(type)) take_tet(tag, physical, entity);
      std::array<std::uint64_t, 3>* const face =
          is_triangle(type) ? &surfaces_[physical != 0 ? physical : entity].emplace_back()
                            : nullptr;
      for (std::size_t c = 0; c < corners; ++c) {
        const std::uint64_t point = size();
        if (is_tetrahedron(type)) take_node(mesh_, c, point);
        if (face != nullptr && c < 3) (*face)[c] = point;
      }
    }
  }
}

void GmshReader::read_elements_22() {
  const std::uint64_t total =
      checked(cursor_.number<std::uint64_t>("a number"), 4, 4 + 4, "elements");
  to_next_line();
  for (std::uint64_t done = 0; done < total;) {
    if (!binary_) {
      read_element_block_22(0, 1, 0);
      ++done;
      continue;
    }
    const std::int32_t type = integer();
    const std::uint64_t count = checked(tag_22(), 1, 8, "elements");
    const std::uint64_t tags = tag_22();
    if (count == 0 || count > total - done) file_.fail("it has more elements than it announces");
    read_element_block_22(type, count, tags);
    done += count;
  }
}

/// Elements of one type; in words each says its own type and number of tags.
void GmshReader::read_element_block_22(std::int32_t type, std::uint64_t count,
                                       std::uint64_t tags) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t number = tag_22();
    if (!binary_) {
      type = integer();
      tags = tag_22();
    }
    check_type(type);
    std::array<std::int32_t, 2> groups{};  // the physical one, the elementary one
    checked(tags, 1, 4, "tags");
    for (std::uint64_t t = 0; t < tags; ++t) {
      const std::int32_t tag = integer();
      if (t < groups.size()) groups[t] = tag;
    }
    if (is_tetrahedron(type)) take_tet(number, groups[0], groups[1]);
    std::array<std::uint64_t, 3>* const face =
        is_triangle(type)
            ? &surfaces_[groups[0] != 0 ? groups[0] : groups[1]].emplace_back() : nullptr;
    for (std::size_t c = 0; c < corners_of[static_cast<std::size_t>(type)]; ++c) {
      const std::uint64_t point = tag_22();
      if (is_tetrahedron(type)) take_node(mesh_, c, point);
      if (face != nullptr && c < 3) (*face)[c] = point;
    }
  }
}

void GmshReader::take_tet(std::uint64_t tag, std::int32_t group, std::int32_t entity) {
  mesh_.labels.push_back(group);
  entities_.push_back(entity);
  tet_tags_.push_back(tag);
}

/// The numbers of things in the order of their tags.
std::vector<std::uint64_t> order_of(const std::vector<std::uint64_t>& tags) {
  std::vector<std::uint64_t> order(tags.size());
  std::iota(order.begin(), order.end(), std::uint64_t{0});
  std::ranges::stable_sort(order, {}, [&](std::uint64_t i) { return tags[i]; });
  return order;
}

template <class T>
void reorder(std::vector<T>& things, const std::vector<std::uint64_t>& order) {
  std::vector<T> sorted;
  sorted.reserve(things.size());
  for (const std::uint64_t i : order) sorted.push_back(things[i]);
  things = std::move(sorted);
}

void GmshReader::order_points() {
  if (!std::ranges::is_sorted(point_tags_)) {
    const std::vector<std::uint64_t> order = order_of(point_tags_);
    reorder(mesh_.points, order);
    reorder(point_tags_, order);
  }
  const auto twice = std::ranges::adjacent_find(point_tags_);
  if (twice != point_tags_.end())
    file_.fail("it has two nodes with the tag " + std::to_string(*twice));
}

/// The number of the point with a tag; one that no point has where there is none.
std::uint64_t GmshReader::index_of(std::uint64_t tag) const {
  const std::uint64_t guess = point_tags_.empty() ? 0 : tag - point_tags_.front();
  if (guess < point_tags_.size() && point_tags_[guess] == tag) return guess;
  const auto found = std::ranges::lower_bound(point_tags_, tag);
  if (found == point_tags_.end() || *found != tag) return ~std::uint64_t{0};
  return static_cast<std::uint64_t>(found - point_tags_.begin());
}

void GmshReader::order_tets() {
  if (!std::ranges::is_sorted(tet_tags_)) {
    const std::vector<std::uint64_t> order = order_of(tet_tags_);
    reorder(mesh_.tets, order);
    if (mesh_.middles.size() == mesh_.tets.size()) reorder(mesh_.middles, order);
    reorder(mesh_.labels, order);
    reorder(entities_, order);
  }
  for (Tet<std::uint64_t>& tet : mesh_.tets)
    for (std::uint64_t& point : tet) point = index_of(point);
  for (auto& nodes : mesh_.middles)
    for (std::uint64_t& node : nodes) node = index_of(node);
}

void GmshReader::finish_surfaces() {
  for (auto& [group, faces] : surfaces_) {
    for (auto& face : faces)
      for (std::uint64_t& point : face) point = index_of(point);
    const auto name = surface_names_.find(group);
    FileSurface surface{group, name == surface_names_.end() ? "" : name->second, std::move(faces)};
    if (surface.name == patch_names[static_cast<std::size_t>(Patch::border)])
      mesh_.border = surface.faces;
    else if (!surface.name.empty() &&
             surface.name != patch_names[static_cast<std::size_t>(Patch::surface)])
      mesh_.patches.push_back(surface);
    mesh_.surfaces.push_back(std::move(surface));
  }
}

/// Labels are the physical groups, of which 0 is none; where no tetrahedron has one, the
/// entities, whose numbers would else be mistaken for those of groups.
void GmshReader::finish_labels() {
  const auto is_none = [](std::int32_t label) { return label == 0; };
  if (std::ranges::all_of(mesh_.labels, is_none)) mesh_.labels = std::move(entities_);
  if (std::ranges::all_of(mesh_.labels, is_none)) mesh_.labels = {};
  LabelNames names;
  const auto label_of = [&](std::int32_t group) {
    const auto found = label_of_group_.find(group);
    return found == label_of_group_.end() ? group : found->second;
  };
  for (std::int32_t& label : mesh_.labels) label = label_of(label);
  for (auto& [group, name] : mesh_.names)
    if (const std::int32_t label = label_of(group); name != default_name(label))
      names.emplace(label, std::move(name));
  mesh_.names = std::move(names);
}

}  // namespace

FileMesh read_gmsh(const std::filesystem::path& file, const Context& context) {
  return GmshReader(file, context).read();
}

}  // namespace certet::formats
