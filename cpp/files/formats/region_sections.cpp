#include "region_sections.hpp"

namespace certet::formats {

std::uint64_t RegionSections::open(const Region& region, std::uint64_t offset,
                                   std::span<const std::byte> heading,
                                   std::uint64_t record_bytes) {
  file_.write_at(offset, heading);
  const std::uint64_t begin = offset + heading.size();
  // Images can have thousands of labels.
  constexpr std::size_t few_bytes = std::size_t{1} << 15;
  parts_.push_back({region.label, region.tets, Section(file_, begin, few_bytes), begin, region.tets});
  return begin + region.tets * record_bytes;
}

RegionSections::Part& RegionSections::part_of(std::int32_t label) {
  // Labels come in runs.
  if (latest_ >= parts_.size() || parts_[latest_].label != label) {
    const auto found = std::ranges::lower_bound(parts_, label, {}, &Part::label);
    if (found == parts_.end() || found->label != label)
      file_.fail("a tetrahedron has a label that was not announced");
    latest_ = static_cast<std::size_t>(found - parts_.begin());
  }
  return parts_[latest_];
}

void RegionSections::append(std::int32_t label, std::span<const std::byte> record) {
  Part& part = part_of(label);
  if (part.missing == 0) file_.fail("a region has more tetrahedra than were announced");
  --part.missing;
  part.section.append(record);
}

void RegionSections::flush() {
  for (Part& part : parts_) {
    if (part.missing != 0) file_.fail("a region has fewer tetrahedra than were announced");
    part.section.flush();
  }
}

}  // namespace certet::formats
