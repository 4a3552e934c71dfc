#include "numbered_groups.hpp"

#include <algorithm>

#include "names.hpp"

namespace certet::formats {

std::vector<std::int32_t> group_numbers(const std::vector<Region>& regions,
                                        std::int32_t greatest) {
  const auto is_taken = [&](std::int32_t number) {
    const auto found = std::ranges::lower_bound(regions, number, {}, &Region::label);
    return found != regions.end() && found->label == number;
  };
  std::int32_t latest = 0;
  for (const Region& region : regions)
    if (region.label <= greatest) latest = std::max(latest, region.label);
  const auto next_free = [&] {
    do latest = latest >= greatest ? 1 : latest + 1;
    while (is_taken(latest));
    return latest;
  };
  std::vector<std::int32_t> numbers;
  for (const Region& region : regions)
    numbers.push_back(region.label > 0 && region.label <= greatest ? region.label : next_free());
  return numbers;
}

std::vector<std::string> told_of_labels(const Survey& survey, std::string_view numbering,
                                        std::string_view how_said, std::int32_t greatest) {
  constexpr std::size_t most_told = 8;
  const std::vector<std::int32_t> numbers = group_numbers(survey.regions, greatest);
  std::string text;
  std::size_t others = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::int32_t label = survey.regions[i].label;
    if (numbers[i] == label) continue;
    if (others++ < most_told)
      text += (others == 1 ? "label " : ", label ") + std::to_string(label) + " has the number " +
              std::to_string(numbers[i]);
  }
  if (others == 0) return {};
  if (others > most_told)
    text += " and " + std::to_string(others - most_told) + " others have others";
  return {std::string(numbering) + ": " + text + "; " + std::string(how_said)};
}

NumberedGroups::NumberedGroups(const Survey& survey, std::int32_t greatest, NameRule rule)
    : sheets(survey, rule) {
  const std::vector<std::string> names = names_of(survey.regions, rule);
  const std::vector<std::int32_t> numbers = group_numbers(survey.regions, greatest);
  for (std::size_t i = 0; i < names.size(); ++i)
    regions.push_back({survey.regions[i].label, numbers[i], names[i], survey.regions[i].tets});
}

std::int32_t NumberedGroups::number_of(std::int32_t label) const {
  const auto found = std::ranges::lower_bound(regions, label, {}, &Group::label);
  return found == regions.end() || found->label != label ? 0 : found->number;
}

std::int32_t LatestGroup::number_of(std::int32_t label, const OutputFile& file) {
  if (label != label_ || number_ == 0) number_ = groups_.number_of(label_ = label);
  if (number_ == 0) file.fail("a tetrahedron has a label that was not announced");
  return number_;
}

}  // namespace certet::formats
