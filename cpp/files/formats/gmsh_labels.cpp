#include "gmsh_labels.hpp"

#include <charconv>

#include "numbered_groups.hpp"

namespace certet::formats {
namespace {

constexpr std::string_view before_group = "certet: group ", before_label = " is label ";

/// Takes words and then a number off the front of a line.
bool take(std::string_view& line, std::string_view words, std::int32_t& number) {
  if (!line.starts_with(words)) return false;
  line.remove_prefix(words.size());
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
  line.remove_prefix(static_cast<std::size_t>(end - line.data()));
  return error == std::errc();
}

}  // namespace

std::string gmsh_label_section(const std::vector<Region>& regions) {
  if (regions.empty() || regions.front().label > 0) return {};
  const std::vector<std::int32_t> tags = group_numbers(regions);
  std::string text = "$Comments\n";
  for (std::size_t i = 0; i < regions.size() && regions[i].label <= 0; ++i)
    text.append(before_group).append(std::to_string(tags[i])).append(before_label)
        .append(std::to_string(regions[i].label) + "\n");
  return text + "$EndComments\n";
}

void read_gmsh_label(std::string_view line, std::map<std::int32_t, std::int32_t>& label_of_group) {
  std::int32_t group = 0, label = 0;
  if (take(line, before_group, group) && take(line, before_label, label) && line.empty())
    label_of_group.emplace(group, label);
}

std::vector<std::string> gmsh_label_losses(const Survey& survey) {
  return told_of_labels(survey, "Gmsh's physical groups are numbered from 1",
                        "a comment in the file says so, by which certet reads them back");
}

}  // namespace certet::formats
