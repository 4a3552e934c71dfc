#pragma once
/// \file
/// Labels of an image that become one, or are called otherwise.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "certet/image.hpp"

namespace certet {

/// All labels of a range become one.
struct LabelMerge {
  LabelRange from;
  std::int32_t to = 0;
  std::string name = {};  ///< of that one; empty: it keeps its own, if it has any
};

/// Reads "1-5=bone,7=9,8=0": labels and ranges of them, then a label or a name, which stands for
/// the first label of the range; of several with one name, for the first of the first.
/// \throws Error `bad_option`.
std::vector<LabelMerge> parse_merges(std::string_view text);
/// The same from a file, a merge on each line; # begins a comment.
/// \throws Error `bad_input` with one sentence that names the file.
std::vector<LabelMerge> read_merges(const std::filesystem::path& file);

/// Labels that no range has stay.  Each label is looked up as it was: 1=2,2=1 changes both.
/// \throws Error `bad_input` for voxels that are no whole numbers or beyond 32 bits, `bad_option`
/// where ranges overlap.
void merge_labels(Image& image, std::vector<LabelMerge> merges);

}  // namespace certet
