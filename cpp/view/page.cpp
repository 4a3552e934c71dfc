#include "certet/page.hpp"

#include <optional>
#include <utility>

#include "certet/tet_shape.hpp"
#include "page_parts.hpp"
#include "page_text.hpp"
#include "regions.hpp"
#include "scene.hpp"

namespace certet {
namespace {

using namespace view;

/// What has to be worked out, apart from the check.
struct Look {
  Regions regions;
  ShapeSurvey shapes;
  std::optional<Scene> scene;
};

Look look_at(const FileMesh& mesh) {
  Look look{Regions(mesh), survey_shapes(mesh.points, mesh.tets), std::nullopt};
  // No tetrahedron with corners, nothing to be seen; nor is what is far smaller than any
  // lattice, whose place in its box is lost to rounding.
  if (can_view_pages() && look.shapes.tets > 0 && look.shapes.longest_edge > least_seen)
    look.scene = make_scene(mesh, look.regions, {});
  return look;
}

/// Replaces {{name}} once; nothing in `text` is looked at again.
class Skeleton {
 public:
  Skeleton() : rest_(page_skeleton()) {}

  /// In the order in which they are in the skeleton.
  void fill(std::string_view name, std::string_view text) {
    const std::string mark = "{{" + std::string(name) + "}}";
    const std::size_t at = rest_.find(mark);
    done_ += rest_.substr(0, at);
    done_ += text;
    rest_ = rest_.substr(at + mark.size());
  }
  std::string finish() { return done_ += rest_; }

 private:
  std::string_view rest_;
  std::string done_;
};

/// Adds what the facts have against the mesh.
void compare_with_run(const PageFacts& facts, CheckReport& report) {
  report.failures.insert(report.failures.end(), facts.defects.begin(), facts.defects.end());
  if (facts.bounds.size() != 1) return;
  const AngleBounds& bounds = facts.bounds.front();
  std::string defect = angle_defect(
      report.quality, bounds,
      facts.is_of_run ? "theorem " + std::string(bounds.theorem) : "a mesh made as it is said");
  if (!defect.empty()) report.failures.push_back(std::move(defect));
}

}  // namespace

bool can_view_pages() { return !three_library().empty(); }

Page make_page(const FileMesh& mesh, const PageFacts& facts) {
  Context context;
  return make_page(mesh, facts,
                   examine(mesh.points, std::span<const Tet<std::uint64_t>>(mesh.tets),
                           mesh.labels, context));
}

Page make_page(const FileMesh& mesh, const PageFacts& facts, Examination found) {
  Page page{{}, std::move(found.report)};
  compare_with_run(facts, page.report);
  const Look look = look_at(mesh);
  const Scene* scene = look.scene ? &*look.scene : nullptr;
  Skeleton html;
  html.fill("title", title_text(facts));
  html.fill("style", page_style());
  html.fill("name", title_text(facts));
  html.fill("verdict", verdict_text(page.report));
  html.fill("view", scene ? view_text(look.regions, found.interfaces, mesh.names) : no_view_text());
  html.fill("view_note", scene ? view_note(*scene, page.report) : "");
  html.fill("counts", counts_text(page.report, look.shapes));
  html.fill("facts", facts_text(facts, page.report));
  html.fill("histograms", histograms_text(page.report, look.shapes, facts));
  html.fill("regions", regions_text(look.regions, found.regions, mesh.names));
  html.fill("interfaces", interfaces_text(look.regions, found.interfaces, mesh.names));
  html.fill("data", scene ? data_text(*scene, look.regions) : "");
  html.fill("three", scene ? three_library() : "");
  html.fill("controls", scene ? three_controls() : "");
  html.fill("script", scene ? page_script() : "");
  page.html = html.finish();
  return page;
}

}  // namespace certet
