#include <CLI/CLI.hpp>
#include <map>
#include <optional>

#include "against/against.hpp"
#include "certet/error.hpp"
#include "certet/curved_quality.hpp"
#include "certet/examine.hpp"
#include "certet/formats.hpp"
#include "certet/page.hpp"
#include "commands.hpp"
#include "outputs.hpp"
#include "pieces.hpp"
#include "refusal.hpp"
#include "run_file.hpp"
#include "shared_options.hpp"
#include "table.hpp"

namespace certet::command {
namespace {

constexpr const char* report_notes = R"(
The page holds all it needs and never asks the network.  A mesh with a defect has a
page too, and the status is 1, as that of `certet check`.  All that is said of the
mesh is measured in the file.  A theorem is said to cover it only with --run, where
points and tetrahedra are, bit by bit, those that the run wrote, and the angles are
within its bounds; a file that is another, or angles outside of the bounds that --run,
--guarantee or --cuts stand for, are a defect.  Distances from the shape and back are told where
the run measured them (`certet mesh --distance`), or with --against.)";

/// What the user asks of `certet report`.
struct ReportOptions {
  std::filesystem::path mesh, output, run;
  std::string against;
  std::optional<Method> guarantee;
  std::optional<Cuts> cuts;
};

void validate(const ReportOptions& options) {
  if (same_file(options.mesh, options.output))
    refuse("the mesh and the page are the same file '" + options.mesh.string() + "'");
  if (!options.run.empty() && same_file(options.run, options.output))
    refuse("the page and --run are the same file '" + options.run.string() + "'");
  if (!options.run.empty() && (options.guarantee || options.cuts))
    refuse("--run tells --guarantee and --cuts already");
  check_output(options.output);
}

/// Whether the options leave open that a mesh was made by this method.
bool may_be(const MethodFacts& method, const ReportOptions& options) {
  if (options.cuts && method.cuts != *options.cuts) return false;
  return !options.guarantee || method.method == *options.guarantee ||
         options.cuts == Cuts::midpoint;  // where no vertex is warped, whatever the guarantee
}

/// All bounds that may hold, as far as the options tell.
std::vector<AngleBounds> possible_bounds(const ReportOptions& options) {
  std::vector<AngleBounds> bounds;
  for (const MethodFacts& method : methods)
    if (may_be(method, options)) bounds.push_back(method.bounds);
  return bounds;
}

PageRow size_row(const std::filesystem::path& mesh) {
  std::error_code failure;
  const auto size = std::filesystem::file_size(mesh, failure);
  return {"file", mesh.string() + (failure ? "" : " (" + bytes(size) + ")")};
}

/// What a run tells is told of its own mesh only.
void add_run(const RunFile& run, const std::filesystem::path& file, const FileMesh& mesh,
             PageFacts& facts) {
  const std::string defect = content_defect(run, file, mesh, checksum(mesh));
  if (!defect.empty()) {
    facts.defects.push_back(defect);
    return;
  }
  facts.is_of_run = true;
  facts.bounds = {run.bounds};
  facts.rows.insert(facts.rows.end(), run.rows.begin(), run.rows.end());
}

void add_pieces(const Examination& found, PageFacts& facts) {
  const Pieces& pieces = found.pieces;
  facts.rows.push_back({"pieces", sentence(pieces, found.report.quality.tets)});
  if (pieces.surface.vertices > 0) facts.rows.push_back({"surface", sentence(pieces.surface)});
}

/// What is said of tetrahedra of ten nodes, besides that of their corners.
void add_curved(const FileMesh& mesh, Context& context, PageFacts& facts) {
  const CurvedQuality curved = measure_curved(mesh.points, mesh.tets, mesh.middle_points,
                                              mesh.middles, context);
  facts.defects.insert(facts.defects.end(), curved.failures.begin(), curved.failures.end());
  facts.rows.push_back(
      {"order", fmt::format("2: {} middle nodes, {} of them beside the middles of their edges; "
                            "volume {:.9g}; Jacobian determinants at least {:.4f} of those of "
                            "straight elements",
                            grouped(curved.nodes), grouped(curved.bent), curved.volume,
                            curved.least_jacobian)});
}

/// The mesh, and the surfaces that its file holds beside it.
Examination examine_for_page(const FileMesh& mesh, PageFacts& facts) {
  Context context;
  Examination found = certet::examine(
      mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets), mesh.labels, context);
  name_regions(found.survey, mesh.names);
  for (std::string& failure : compare_surfaces(mesh, found.survey).failures)
    facts.defects.push_back(std::move(failure));
  if (!mesh.middles.empty()) add_curved(mesh, context, facts);
  return found;
}

Status report(const ReportOptions& options) {
  validate(options);
  PageFacts facts;
  facts.name = options.mesh.filename().string();
  facts.rows.push_back(size_row(options.mesh));
  std::optional<RunFile> run;
  if (!options.run.empty()) run = read_run(options.run);
  const FileMesh mesh = certet::read(options.mesh);
  if (run)
    add_run(*run, options.mesh, mesh, facts);
  else
    facts.bounds = possible_bounds(options);
  Examination found = examine_for_page(mesh, facts);
  if (!options.against.empty()) {
    Context context;
    const std::vector<PageRow> rows = page_rows(distance_from(
        options.against, mesh, found.survey, run ? run->edge : 0, context));
    facts.rows.insert(facts.rows.end(), rows.begin(), rows.end());
  }
  add_pieces(found, facts);
  const Page page = make_page(mesh, facts, std::move(found));
  write_text(options.output.string(), page.html);
  return page.report.failures.empty() ? Status::ok : Status::check_failed;
}

void declare(CLI::App& app, ReportOptions& options) {
  declare_mesh_file(app, "mesh", "MESH", options.mesh);
  app.add_option("-o,--output", options.output, "Page: .html")
      ->required()->option_text("FILE");
  app.add_option("--run", options.run, "What `certet mesh --json` told of this mesh")
      ->option_text("FILE");
  declare_against(app, options.against);
  app.add_option("--guarantee", options.guarantee,
                 "Of the run, where there is no --run: key, embedded, angles or embedding")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Method>{
          {"key", Method::key}, {"embedded", Method::embedded}, {"angles", Method::angles},
          {"embedding", Method::embedding}}))
      ->option_text("WHICH");
  app.add_option("--cuts", options.cuts, "Of the run, where there is no --run: bisect or midpoint")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Cuts>{
          {"bisect", Cuts::bisect}, {"midpoint", Cuts::midpoint}}))
      ->option_text("WHERE");
}

}  // namespace

Run declare_report(CLI::App& app) {
  return subcommand<ReportOptions>(app, declare, report_notes, report);
}

}  // namespace certet::command
