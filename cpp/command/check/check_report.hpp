#pragma once
/// \file
/// What is known at the end of `certet check`.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certet/curved_quality.hpp"
#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "distance.hpp"
#include "report.hpp"
#include "run_file.hpp"

namespace certet::command {

struct CheckedFile {
  std::string file;
  CheckReport report;  ///< with what speaks against the run, the bounds asked for and the
                       ///< surfaces of the file
  Pieces pieces;
  std::vector<RegionReport> regions;
  std::vector<InterfaceReport> interfaces;
  std::vector<SurfaceReport> surfaces;  ///< that the file holds
  LabelNames names;                     ///< that the file has
  std::optional<CurvedQuality> curved;  ///< of tetrahedra of ten nodes
  std::optional<DistanceReport> distance;  ///< from --against
  std::optional<RunFile> run;
  AngleBounds asked{0, 180, {}};  ///< by --min-angle and --max-angle
  std::uint64_t checksum = 0;  ///< of the file's numbers, whatever its format
  double read_seconds = 0, check_seconds = 0, total_seconds = 0;
  std::uint64_t memory_peak = 0;
};

/// What a region is called: its name, or its label if it has none.
std::string name_of(std::int32_t label, const LabelNames& names);

/// For people.
std::string table(const CheckedFile& checked);
/// For programs: one object, its keys as `--help` lists them.
std::string json(const CheckedFile& checked);

}  // namespace certet::command
