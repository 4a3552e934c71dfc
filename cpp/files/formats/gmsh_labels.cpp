#include "gmsh_labels.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

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

std::vector<std::int32_t> gmsh_tags(const std::vector<Region>& regions) {
  const auto is_taken = [&](std::int32_t number) {
    const auto found = std::ranges::lower_bound(regions, number, {}, &Region::label);
    return found != regions.end() && found->label == number;
  };
  std::int32_t latest = regions.empty() ? 0 : std::max(regions.back().label, 0);
  const auto next_free = [&] {
    do latest = latest == std::numeric_limits<std::int32_t>::max() ? 1 : latest + 1;
    while (is_taken(latest));
    return latest;
  };
  std::vector<std::int32_t> tags;
  for (const Region& region : regions) tags.push_back(region.label > 0 ? region.label : next_free());
  return tags;
}

std::string gmsh_label_section(const std::vector<Region>& regions) {
  if (regions.empty() || regions.front().label > 0) return {};
  const std::vector<std::int32_t> tags = gmsh_tags(regions);
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
  constexpr std::size_t most_told = 8;
  const std::vector<std::int32_t> tags = gmsh_tags(survey.regions);
  std::string text;
  std::size_t i = 0;
  for (; i < tags.size() && survey.regions[i].label <= 0; ++i)
    if (i < most_told)
      text += (i == 0 ? "label " : ", label ") + std::to_string(survey.regions[i].label) +
              " has the number " + std::to_string(tags[i]);
  if (i == 0) return {};
  if (i > most_told) text += " and " + std::to_string(i - most_told) + " others have others";
  return {"Gmsh's physical groups are numbered from 1: " + text +
          "; a comment in the file says so, by which certet reads them back"};
}

}  // namespace certet::formats
