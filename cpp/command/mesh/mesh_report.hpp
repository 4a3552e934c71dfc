#pragma once
/// \file
/// What is known at the end of `certet mesh`.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certet/kept.hpp"
#include "certet/method.hpp"
#include "certet/patches.hpp"
#include "certet/patient_axes.hpp"
#include "certet/pieces.hpp"
#include "certet/quality.hpp"
#include "certet/warp_figures.hpp"
#include "certet/write_mesh.hpp"
#include "distance.hpp"
#include "features_choice.hpp"
#include "grade_choice.hpp"
#include "meshed_materials.hpp"
#include "optimise_choice.hpp"
#include "order.hpp"
#include "regions.hpp"
#include "report.hpp"
#include "together.hpp"

namespace certet::command {

/// What --keep dropped from a mesh, and how many pieces it left.
struct DroppedPieces {
  std::uint64_t pieces = 0, kept = 0, tets = 0;
  double volume = 0;  ///< world units cubed
};

struct MeshReport {
  bool dry_run = false;
  std::string input_kind;  ///< as `Source::kind`
  std::string input_name;
  std::vector<std::string> inside, without;  ///< what it was trimmed by
  std::string formula;  ///< whole, where the name is a part of it
  std::vector<std::string> input_notes;
  std::vector<std::string> warnings;
  std::optional<UncomparedPieces> uncompared;
  std::vector<MeshedRegion> regions;  ///< of an image
  std::vector<MeshedMaterial> materials;  ///< of several solids
  LabelNames names;                   ///< of regions, where they are known
  bool counted_pieces = false;
  std::optional<Smoothing> smoothing;
  std::string output, format;
  Point3 output_origin{};  ///< where the coordinates of the output have their 0 if --origin is 0
  std::optional<PatientAxes> axes;  ///< of the output, where they are known
  double scale = 1;                 ///< of the output; the volumes here are those of the input
  std::uint64_t output_bytes = 0;

  std::array<std::int32_t, 3> cells{};
  double size = 0;
  std::optional<double> room;     ///< as `PlacedSource` has it
  std::uint64_t target_tets = 0;  ///< 0: the size was not searched for
  int tries = 1;
  Method asked{}, used{};
  bool cut_apart = false;  ///< whether several materials are
  std::uint64_t inverted_tets = 0;
  WarpFigures warp;

  std::uint64_t points = 0, tets = 0;
  GradeReport graded;
  std::optional<OrderReport> order;  ///< of tetrahedra of ten nodes
  std::optional<OptimiseFigures> optimised;  ///< where vertices moved
  std::vector<PatchFigures> patches;  ///< of the boundary, where it has others than `surface`
  FeaturesReport features;
  bool knows_pieces = true;  ///< whether they were counted
  Pieces pieces;
  std::optional<DistanceReport> distance;  ///< if it was to be measured
  std::string keep;  ///< which pieces were to stay; empty: all
  DroppedPieces dropped;
  WrittenMesh written;  ///< empty after a dry run

  double read_seconds = 0, sample_seconds = 0, cut_seconds = 0, warp_seconds = 0,
         count_seconds = 0, pieces_seconds = 0, optimise_seconds = 0,
         features_seconds = 0, distance_seconds = 0,
         total_seconds = 0;
  std::uint64_t memory_limit = 0;   ///< what the run may use
  std::uint64_t memory_needed = 0;  ///< what it holds while writing
  std::uint64_t memory_least = 0;   ///< the smallest limit that would do
  std::uint64_t memory_peak = 0;    ///< what the process had in the end, or the one that had most
  std::vector<RankReport> ranks;    ///< of several processes

  /// Whether vertices moved after stuffing.
  [[nodiscard]] bool moved() const { return optimised || features.figures; }
  /// A volume in the units of the output.
  [[nodiscard]] double out(double volume) const { return volume * scale * scale * scale; }
};

/// What holds of the surfaces of several labels and of all together, tested and not proved.
inline constexpr std::string_view surface_of_several =
    "closed, and a manifold but for single points where labels meet";

/// How the mesh that was measured stands to its theorem.
Standing standing(const MeshReport& report);

/// The theorem that covers it.
inline AngleBounds bounds_of(const MeshReport& report) {
  return certet::bounds_of(report.used, report.cut_apart);
}

/// For people.
std::string table(const MeshReport& report);
/// For programs: one object, its keys as `--help` lists them.
std::string json(const MeshReport& report);

}  // namespace certet::command
