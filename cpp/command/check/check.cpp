#include <CLI/CLI.hpp>
#include <utility>

#include "against/against.hpp"
#include "certet/error.hpp"
#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "check_report.hpp"
#include "commands.hpp"
#include "curved.hpp"
#include "memory.hpp"
#include "outputs.hpp"
#include "shared_options.hpp"
#include "signals.hpp"
#include "stopwatch.hpp"

namespace certet::command {
namespace {

constexpr const char* check_notes = R"(
Keys of the JSON: certet, command, file, ok, failures, mesh {points, tets, volume, checksum,
unused_points, nonfinite_points, duplicate_points, bad_indices, nonpositive_tets,
overfull_faces, misoriented_faces, boundary_faces, open_edges, pieces {by_faces,
by_vertices, largest_tets}, nonmanifold {edges, vertices, edge_places, vertex_places: of
the first 8}}, with labels: regions [{label, pieces, pieces_by_vertices}], dihedral {min,
max, histogram}, with --against: distance {against, exact, edge, to_shape and to_mesh
{greatest, rms, greatest_edges, rms_edges, at, points}}, bounds {min, max, and with --run:
theorem}, seconds {read, check, total}, memory {peak}.  mesh.checksum is what `certet mesh`
tells as mesh.file_checksum.

Of tetrahedra of ten nodes all this is of the corners, and order2 {middle_nodes, bent, torn_edges
(with several middle nodes), shared_nodes (of several edges), nonfinite_nodes, bad_indices,
nonpositive, least_jacobian, volume} of the curved elements.  Their Jacobian determinants
are bounded from below by Bernstein coefficients: one that is not bounded above 0 is a defect;
least_jacobian is the least bound, as a part of the straight element's determinant.

Pieces are what faces that two tetrahedra share, or points, join.  A surface that is no
manifold is told of, and is no defect: --method paper makes such, and where three labels
meet, or two and the outside, one may touch itself in a point.

Each region must have a closed surface.  Where two touch is their interface, which must end
where a third region or the outside is, and nowhere else.  Surfaces that a .msh, .mesh or
.meshb file holds are compared with them where they have the names, or without names the
numbers, that certet gives to interfaces: a triangle that is missing, or lies elsewhere, is
a defect.  Surfaces of other programs are only told of, in the JSON.

With --against the mesh is measured as `certet mesh --distance` does, in the coordinates of the
file, and edges are the long edges of the run with --run, else of the mean length of the edges of
the mesh's surface.  Surfaces of labels are as smooth as `certet mesh` makes them by default.

Angles are checked as they are shown, in thousandths of a degree.  With --run it is a
defect too where points or tetrahedra are not, bit by bit, those that the run wrote;
the theorem is named only where nothing is wrong.)";

/// What the user asks of `certet check`.
struct CheckOptions {
  std::filesystem::path mesh, run_file;
  std::string against;
  AngleBounds asked{0, 180, {}};
  RunOptions run;
};

/// The bounds asked for and those of the run, if there is one.
void check_angles(CheckedFile& checked) {
  const auto compare = [&report = checked.report](const AngleBounds& bounds,
                                                const std::string& whose) {
    std::string defect = angle_defect(report.quality, bounds, whose);
    if (!defect.empty()) report.failures.push_back(std::move(defect));
  };
  compare(checked.asked, "--min-angle and --max-angle");
  if (!checked.run) return;
  const AngleBounds& proven = checked.run->bounds;
  compare(proven, "theorem " + std::string(proven.theorem));
}

void check_options(const CheckOptions& options) {
  if (options.asked.min_dihedral > options.asked.max_dihedral)
    throw Error(ErrorCode::bad_option, "--min-angle is above --max-angle");
  if (!options.run.has_json_file()) return;
  for (const auto& [input, name] :
       {std::pair(options.mesh, "the mesh"), std::pair(options.run_file, "--run")})
    if (!input.empty() && same_file(input, options.run.json))
      throw Error(ErrorCode::bad_option, std::string(name) + " and --json are the same file '" +
                                             input.string() + "'");
  check_output(options.run.json);
}

/// The mesh, its regions and interfaces, and the surfaces that the file holds beside it.
void examine_file(const FileMesh& mesh, const std::string& against, CheckedFile& checked,
                  Context& context) {
  Examination found = certet::examine(
      mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets), mesh.labels, context);
  name_regions(found.survey, mesh.names);
  SurfaceComparison compared = compare_surfaces(mesh, found.survey);
  checked.report = std::move(found.report);
  for (std::string& failure : compared.failures)
    checked.report.failures.push_back(std::move(failure));
  checked.pieces = std::move(found.pieces);
  checked.regions = std::move(found.regions);
  checked.interfaces = std::move(found.interfaces);
  checked.surfaces = std::move(compared.surfaces);
  checked.names = mesh.names;
  if (!against.empty())
    checked.distance = distance_from(against, mesh, found.survey,
                                     checked.run ? checked.run->edge : 0, context);
  checked.curved = measure_curved(mesh, context);
  if (checked.curved)
    checked.report.failures.insert(checked.report.failures.end(), checked.curved->failures.begin(),
                                   checked.curved->failures.end());
}

Status check(const CheckOptions& options) {
  const Stopwatch clock;
  Context context;
  context.threads = options.run.threads;
  const Signals signals(context);
  check_options(options);
  CheckedFile checked;
  checked.file = options.mesh.string();
  checked.asked = options.asked;
  if (!options.run_file.empty()) checked.run = read_run(options.run_file);
  const FileMesh mesh = certet::read(options.mesh, context);
  checked.read_seconds = clock.seconds();
  examine_file(mesh, options.against, checked, context);
  checked.checksum = checksum(mesh);
  if (checked.run) {
    std::string defect = content_defect(*checked.run, options.mesh, mesh, checked.checksum);
    if (!defect.empty()) checked.report.failures.push_back(std::move(defect));
  }
  check_angles(checked);
  checked.total_seconds = clock.seconds();
  checked.check_seconds = checked.total_seconds - checked.read_seconds;
  checked.memory_peak = peak_memory();
  tell(checked, options.run.json);
  return checked.report.failures.empty() ? Status::ok : Status::check_failed;
}

void declare(CLI::App& app, CheckOptions& options) {
  declare_mesh_file(app, "mesh", "MESH", options.mesh);
  app.add_option("--run", options.run_file,
                 "What `certet mesh --json` told: the file must hold that mesh, with angles "
                 "within its theorem")
      ->option_text("FILE");
  declare_against(app, options.against);
  app.add_option("--min-angle", options.asked.min_dihedral,
                 "Least dihedral angle that will do, in degrees")
      ->check(CLI::Range(0.0, 180.0))
      ->option_text("A");
  app.add_option("--max-angle", options.asked.max_dihedral,
                 "Greatest dihedral angle that will do, in degrees")
      ->check(CLI::Range(0.0, 180.0))
      ->option_text("A");
  declare_run(app, options.run);
}

}  // namespace

Run declare_check(CLI::App& app) {
  return subcommand<CheckOptions>(app, declare, check_notes, check);
}

}  // namespace certet::command
