#include "certet/merge_labels.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <limits>
#include <map>
#include <type_traits>
#include <utility>

#include "certet/error.hpp"
#include "label_set.hpp"

namespace certet {
namespace {

constexpr std::string_view blanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);
}

/// Takes a number off the front of a text.
bool take(std::string_view& text, std::int64_t& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return error == std::errc() && std::in_range<std::int32_t>(number);
}

[[noreturn]] void refuse(std::string_view merge) {
  throw Error(ErrorCode::bad_option, "labels are merged like 1-5=bone or 7=9, not '" +
                                         std::string(merge.substr(0, 60)) + "'");
}

LabelMerge parse_merge(std::string_view text) {
  const std::size_t sign = std::min(text.find('='), text.size());
  std::string_view from = trimmed(text.substr(0, sign));
  const std::string_view to = trimmed(text.substr(std::min(sign + 1, text.size())));
  LabelMerge merge{};
  if (!take(from, merge.from.first)) refuse(text);
  merge.from.last = merge.from.first;
  if (from.starts_with('-') && (from.remove_prefix(1), !take(from, merge.from.last))) refuse(text);
  if (!from.empty() || merge.from.first > merge.from.last || to.empty()) refuse(text);
  std::int64_t label = 0;
  std::string_view rest = to;
  if (take(rest, label) && rest.empty()) {
    merge.to = static_cast<std::int32_t>(label);
  } else {
    merge.to = static_cast<std::int32_t>(merge.from.first);
    merge.name = to;
  }
  return merge;
}

/// What has one name is one label.
void join_names(std::vector<LabelMerge>& merges) {
  std::map<std::string, std::int32_t> named;
  for (LabelMerge& merge : merges)
    if (!merge.name.empty()) merge.to = named.emplace(merge.name, merge.to).first->second;
}

/// By growing ranges, so that the one that may have a label is found at once.
class Merger {
 public:
  explicit Merger(std::vector<LabelMerge> merges) : merges_(std::move(merges)) {
    std::ranges::sort(merges_, {}, [](const LabelMerge& merge) { return merge.from.first; });
    for (std::size_t i = 1; i < merges_.size(); ++i)
      if (merges_[i].from.first <= merges_[i - 1].from.last)
        throw Error(ErrorCode::bad_option, "label " + std::to_string(merges_[i].from.first) +
                                               " is merged twice");
  }

  /// The merge that has a label, or null.
  const LabelMerge* of(std::int64_t label) const {
    const auto after = std::ranges::upper_bound(
        merges_, label, {}, [](const LabelMerge& merge) { return merge.from.first; });
    if (after == merges_.begin() || std::prev(after)->from.last < label) return nullptr;
    return &*std::prev(after);
  }

  [[nodiscard]] std::int32_t target(std::int64_t label) {
    if (label != latest_ || !known_) {
      const LabelMerge* const merge = of(label);
      latest_ = label;
      target_ = merge == nullptr ? static_cast<std::int32_t>(label) : merge->to;
      known_ = true;
    }
    return target_;
  }

  [[nodiscard]] const std::vector<LabelMerge>& all() const { return merges_; }

 private:
  std::vector<LabelMerge> merges_;
  std::int64_t latest_ = 0;  ///< labels come in runs
  std::int32_t target_ = 0;
  bool known_ = false;
};

template <class T>
Voxels merged(const Image& image, const Buffer<T>& voxels, Merger& merger) {
  if constexpr (std::is_floating_point_v<T>) {
    throw Error(ErrorCode::bad_input, "the voxels of '" + image.name +
                                          "' are not whole numbers, so they are no labels");
  } else {
    refuse_wide_labels(image, voxels, LabelSet(std::vector<LabelRange>{
                                       {std::numeric_limits<std::int32_t>::min(),
                                        std::int64_t{1} << 32}}));
    Buffer<std::int32_t> result(voxels.size());
    std::ranges::transform(voxels, result.begin(), [&](T voxel) {
      return merger.target(static_cast<std::int64_t>(voxel));
    });
    return result;
  }
}

/// A label that goes away takes its name along.
void rename(LabelNames& names, const Merger& merger) {
  LabelNames kept;
  for (auto& [label, name] : names) {
    const LabelMerge* const merge = merger.of(label);
    if (merge == nullptr || merge->to == label) kept.emplace(label, std::move(name));
  }
  for (const LabelMerge& merge : merger.all())
    if (!merge.name.empty()) kept[merge.to] = merge.name;
  names = std::move(kept);
}

}  // namespace

std::vector<LabelMerge> parse_merges(std::string_view text) {
  std::vector<LabelMerge> merges;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    merges.push_back(parse_merge(trimmed(text.substr(begin, end - begin))));
    begin = end + 1;
  }
  join_names(merges);
  return merges;
}

std::vector<LabelMerge> read_merges(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::error_code failure;
  if (!stream || !std::filesystem::is_regular_file(file, failure))
    throw Error(ErrorCode::bad_input, "'" + file.string() + "' cannot be read");
  std::vector<LabelMerge> merges;
  std::string line;
  try {
    while (std::getline(stream, line)) {
      const std::string_view text = trimmed(std::string_view(line).substr(0, line.find('#')));
      if (!text.empty()) merges.push_back(parse_merge(text));
    }
  } catch (const Error& error) {
    throw Error(ErrorCode::bad_input, "in '" + file.string() + "' " + error.what());
  }
  if (merges.empty())
    throw Error(ErrorCode::bad_input, "'" + file.string() + "' merges no labels");
  join_names(merges);
  return merges;
}

void merge_labels(Image& image, std::vector<LabelMerge> merges) {
  Merger merger(std::move(merges));
  image.voxels = std::visit([&](const auto& voxels) { return merged(image, voxels, merger); },
                            image.voxels);
  rename(image.names, merger);
}

}  // namespace certet
