#pragma once
/// \file
/// The options of `certet mesh`.

#include <CLI/App.hpp>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "certet/formula.hpp"
#include "certet/formats.hpp"
#include "certet/image.hpp"
#include "certet/merge_labels.hpp"
#include "certet/method.hpp"
#include "certet/patch.hpp"
#include "certet/pieces.hpp"
#include "features_choice.hpp"
#include "grade_choice.hpp"
#include "material_options.hpp"
#include "optimise_choice.hpp"
#include "order.hpp"
#include "shared_options.hpp"

namespace certet::command {

struct Together;

/// What the coordinates of the output are relative to.
enum class OutputOrigin {
  world,    ///< the input's own origin
  lattice,  ///< where the lattice has its 0, which is at the solid
};

/// Which way the axes of the output go, where an image tells what its own do.
enum class OutputFrame {
  usual,  ///< LPS, or the input's where it does not tell
  lps,
  ras,
  input,  ///< the file's
};

/// What the user asks of `certet mesh`.
struct MeshOptions {
  std::filesystem::path input;  ///< of these four one is not empty
  std::string formula;
  std::string shape;
  std::vector<MaterialChoice> materials;
  std::vector<std::string> priority;  ///< of materials, the strongest first
  std::vector<SolidChoice> inside;    ///< of all that is meshed what is in these
  std::vector<SolidChoice> without;   ///< and not in these
  std::optional<Bounds> bounds;
  std::vector<LabelRange> labels;  ///< empty: all but 0
  std::optional<double> iso;   ///< -infinity where there is only what is `below`
  std::optional<double> below;  ///< the solid is where the image is less than this, too
  std::vector<LabelMerge> merges;
  ImageChoice image;         ///< what an image's file may leave open
  std::optional<double> nan;  ///< in the place of voxels that are NaN
  /// Of labels, in world units; 0: not at all; nothing: by one voxel, where the method cuts
  /// labels apart.
  std::optional<double> smooth;
  std::optional<Bounds> crop;
  std::string grid;          ///< of a volume; empty: the one that speaks for itself
  bool repair = false;       ///< closes the holes of a surface
  double size = 0;           ///< 0: chosen by one of the next two, or by the input
  double relative_size = 0;  ///< 0, or a fraction of the solid's longest side
  std::uint64_t target_tets = 0;
  std::int32_t margin = 2;
  Method method = default_method;
  GradeChoice grade;
  std::optional<KeepRule> keep;  ///< which pieces stay; nothing: all
  std::string keep_text;         ///< as the user wrote it
  bool label_pieces = false;     ///< counts the pieces of each label
  OrderChoice order;
  OptimiseChoice optimise;
  FeatureChoice features;
  RunOptions run;
  std::uint64_t max_memory = 0;  ///< 0: by what is available
  bool distance = false;  ///< to be measured
  bool dry_run = false;
  std::filesystem::path output;
  Format format = Format::vtu;
  OutputOrigin origin = OutputOrigin::world;
  OutputFrame frame{};
  double scale = 1;  ///< of coordinates that go out
  std::filesystem::path label_names;  ///< empty: labels have no names
  std::string surface;                ///< what --surface says; empty: all of the boundary
  std::vector<PatchChoice> patches;   ///< of the boundary, that get names
  const Together* together = nullptr;  ///< those who make the mesh, if they are several processes
};

/// Declares the options and gives what reads them once the command line has
/// been parsed.  \throws Error `bad_option` with one sentence (the result).
std::function<MeshOptions()> declare_mesh_options(CLI::App& mesh);

}  // namespace certet::command
