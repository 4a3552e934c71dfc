#include "features_choice.hpp"

#include <CLI/CLI.hpp>

#include "option_values.hpp"
#include "refusal.hpp"
#include "report.hpp"

namespace certet::command {
void declare_features(CLI::App& app, std::string& text) {
  app.add_option("--features", text,
                 "Vertices move onto edges at which the normals of a surface differ by more than "
                 "ANGLE degrees, and onto the corners of these, as far as all angles stay within the "
                 "method's bounds; the mesh is held in memory.  Of surfaces, boxes and cylinders "
                 "they are known; elsewhere they are found on the mesh: where parts of a solid or of "
                 "a formula meet, and where it is cut off, of images the latter alone.  auto "
                 "(default): by 40 degrees, of surfaces, boxes and cylinders where "
                 "at least nine tenths of the length of the surface's edges are flat (20 degrees at "
                 "most) or sharp (more than 40), some are, and at most a tenth of the points of sharp ones "
                 "are loose ends; off: none")
      ->option_text("ANGLE|auto|off");
}

FeatureChoice chosen_features(const std::string& text, Method method) {
  if (text.empty() || text == "auto") return {};
  if (text == "off") return {false, {}};
  const double angle = parse_positive("--features", text);
  if (angle < 1 || angle > 179)
    refuse("--features takes an angle from 1 to 179 degrees, auto or off, not '" + text + "'");
  if (facts(method).cuts == Cuts::midpoint)
    refuse("--features does not go with --method midpoint, whose surface has steps");
  return {false, angle};
}

std::string name(const FeatureChoice& choice) {
  return choice.automatic ? "auto" : choice.angle ? fmt::format("{}", *choice.angle) : "off";
}

void add_features(Lines& lines, const FeaturesReport& report, double size) {
  // Where nothing was asked for and there is nothing to be known, there is nothing to be said.
  if (!report.decision.creases && report.asked == "auto") return;
  if (!report.decision.angle) {
    lines.add("features", "off: {}", report.decision.why);
    return;
  }
  lines.add("features", "edges of more than {}°, {}", *report.decision.angle, report.decision.why);
  if (!report.figures) return;
  const FeatureFigures& figures = *report.figures;
  lines.add("", "vertices on {} of {} corners, and along {:.2f} % of the length {:.6g}, of which "
            "{:.2f} % has edges within 2 % of a long one; the farthest is {:.5f} edges ({:.4g}) away",
            grouped(figures.kept_corners), grouped(figures.corners), figures.followed_percent(),
            figures.length * size, figures.kept_percent(), figures.greatest_distance,
            figures.greatest_distance * size);
  lines.add("", "{} vertices moved, by at most {:.4f} edges ({:.4g})", grouped(figures.moved),
            figures.greatest_move, figures.greatest_move * size);
}

Json json_of(const FeaturesReport& report, double size) {
  Json json{{"asked", report.asked}, {"why", report.decision.why}};
  if (report.decision.angle) json["chosen"] = *report.decision.angle;
  else json["chosen"] = "off";
  if (report.decision.creases) {
    json["flat"] = report.decision.creases->flat;
    json["sharp"] = report.decision.creases->sharp;
    json["loose_ends"] = report.decision.creases->loose_ends;
  }
  if (!report.figures) return json;
  const FeatureFigures& figures = *report.figures;
  json["length"] = figures.length * size;
  json["followed_length"] = figures.followed_length * size;
  json["followed_percent"] = figures.followed_percent();
  json["kept_length"] = figures.kept_length * size;
  json["kept_percent"] = figures.kept_percent();
  json["corners"] = figures.corners;
  json["kept_corners"] = figures.kept_corners;
  json["greatest_distance"] = figures.greatest_distance * size;
  json["greatest_distance_edges"] = figures.greatest_distance;
  json["moved"] = figures.moved;
  json["greatest_move_edges"] = figures.greatest_move;
  return json;
}

}  // namespace certet::command
