#pragma once
/// \file
/// Regions, patches and interfaces of a format that numbers them from 1 on.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "output_file.hpp"
#include "sheets.hpp"

namespace certet::formats {

/// The greatest number of fields that are 8 characters wide.
inline constexpr std::int32_t greatest_of_8_digits = 99'999'999;

/// The number of each region, whose labels grow: the label where that is from 1 to `greatest`; for
/// the others numbers that no label is, from behind the greatest of those on.
std::vector<std::int32_t> group_numbers(const std::vector<Region>& regions,
                                        std::int32_t greatest = INT32_MAX);

/// What is told of labels that are no such numbers: which number each has, and how the file says
/// so; none where all are.  The sentence begins with `numbering`.
std::vector<std::string> told_of_labels(const Survey& survey, std::string_view numbering,
                                        std::string_view how_said,
                                        std::int32_t greatest = INT32_MAX);

/// A group's number is positive and its own among those of its dimension.
struct NumberedGroups {
  /// `survey` must live as long.
  explicit NumberedGroups(const Survey& survey, std::int32_t greatest = INT32_MAX,
                          NameRule rule = NameRule::quoted);

  /// 0 of a label that was not announced.
  [[nodiscard]] std::int32_t number_of(std::int32_t label) const;

  struct Group {
    std::int32_t label;
    std::int32_t number;  ///< as `group_numbers` has it
    std::string name;
    std::uint64_t tets;
  };
  std::vector<Group> regions;  ///< by growing labels
  Sheets sheets;               ///< with numbers of their own
};

/// The number of a tetrahedron's region; labels come in runs.
class LatestGroup {
 public:
  explicit LatestGroup(const NumberedGroups& groups) : groups_(groups) {}
  /// \throws Error `write_failed`, by `file`, for a label that was not announced.
  std::int32_t number_of(std::int32_t label, const OutputFile& file);

 private:
  const NumberedGroups& groups_;
  std::int32_t label_ = 0, number_ = 0;
};

}  // namespace certet::formats
