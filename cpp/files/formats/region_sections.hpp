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

  /// Calls visit(record) for all records of a region, by its place among those that were opened, as
  /// they are in the file.  After `flush`.
  template <class Visit>
  void for_each_record(std::size_t region, std::uint64_t record_bytes, const Visit& visit) const {
    constexpr std::uint64_t records_at_once = 4096;
    const Part& part = parts_[region];
    std::vector<std::byte> bytes;
    for (std::uint64_t done = 0; done < part.tets;) {
      const std::uint64_t count = std::min(records_at_once, part.tets - done);
      bytes.resize(count * record_bytes);
      file_.read_at(part.begin + done * record_bytes, bytes);
      for (std::uint64_t i = 0; i < count; ++i)
        visit(std::span<const std::byte>(bytes).subspan(i * record_bytes, record_bytes));
      done += count;
    }
  }

 private:
  struct Part {
    std::int32_t label;
    std::uint64_t missing;  ///< records that have not come
    Section section;
    std::uint64_t begin, tets;  ///< where its records are, and how many
  };
  Part& part_of(std::int32_t label);

  OutputFile& file_;
  std::vector<Part> parts_;   ///< by growing labels
  std::size_t latest_ = 0;
};

}  // namespace certet::formats
