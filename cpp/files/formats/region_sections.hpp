#pragma once
/// \file
/// Tetrahedra come in the order of the lattice; some formats want them region by
/// region.

#include <algorithm>
#include <vector>

#include "certet/survey.hpp"
#include "section.hpp"

namespace certet::formats {

/// A stretch of the file for each region, which has a heading and then records
/// that are all of one length, so that all of them can grow at once.
class RegionSections {
 public:
  explicit RegionSections(OutputFile& file) : file_(file) {}

  /// Puts the heading of the next region and leaves room for its tetrahedra.
  /// \returns where the file goes on behind them.
  std::uint64_t open(const Region& region, std::uint64_t offset,
                     std::span<const std::byte> heading, std::uint64_t record_bytes);

  /// The next record of a region.
  void append(std::int32_t label, std::span<const std::byte> record);

  /// After the last record.  Fails if a region has fewer than announced.
  void flush();

 private:
  struct Part {
    std::int32_t label;
    std::uint64_t missing;  ///< records that have not come
    Section section;
  };
  Part& part_of(std::int32_t label);

  OutputFile& file_;
  std::vector<Part> parts_;   ///< by growing labels
  std::size_t latest_ = 0;
};

}  // namespace certet::formats
