#include "order.hpp"

#include <CLI/CLI.hpp>

#include "refusal.hpp"
#include "report.hpp"

namespace certet::command {

void declare_order(CLI::App& app, OrderChoice& choice) {
  app.add_option("--order", choice.order,
                 "2: tetrahedra of ten nodes, one in the middle of each edge (default: 1)")
      ->check(CLI::IsMember({1, 2}))
      ->option_text("1|2");
  app.add_flag("--curved", choice.curved,
               "With --order 2: middle nodes of the boundary and of interfaces lie on the surface, "
               "where no element is spoilt by it");
}

void check_order(const OrderChoice& choice, Format format, Method method) {
  if (choice.curved && choice.order != 2) refuse("--curved goes with --order 2");
  if (choice.order == 2 && !holds_middle_nodes(format))
    refuse("--order 2 does not go with --format " + std::string(name(format)) +
           ", which has no tetrahedra of ten nodes");
  if (choice.curved && facts(method).cuts == Cuts::midpoint)
    refuse("--curved does not go with --method midpoint, whose surface has steps");
}

std::optional<OrderReport> add_middle_nodes(const OrderChoice& choice, const Domain& domain,
                                            const Stuffing& stuffing, const Mesh* moved,
                                            MeshSize& size, Context& context) {
  if (choice.order != 2) return std::nullopt;
  const auto middles = std::make_shared<MiddleNodes>(middle_nodes(stuffing, context));
  OrderReport report{middles->count(), std::nullopt};
  if (choice.curved) {
    const std::shared_ptr<const Survey> found =
        size.survey != nullptr ? size.survey
                               : std::make_shared<const Survey>(survey(stuffing, context));
    report.curved = moved != nullptr ? curve(*middles, *moved, *found, domain, context)
                                     : curve(*middles, stuffing, *found, domain, context);
  }
  size.points += middles->count();
  size.middles = middles;
  return report;
}

void add_order(Lines& lines, const OrderReport& report, double size) {
  lines.add("order", "2: {} middle nodes{}", grouped(report.middle_nodes),
            report.curved ? "" : ", all in the middle of their edges");
  if (!report.curved) return;
  const CurveFigures& curved = *report.curved;
  lines.add("", "of {} surface edges {} moved onto the surface, by at most {:.4f} edges ({:.4g}), "
            "{} were on it",
            grouped(curved.edges), grouped(curved.moved), curved.greatest_move,
            curved.greatest_move * size, grouped(curved.on_surface));
  if (curved.guarded + curved.far + curved.seams > 0)
    lines.add("", "straight: {} that would spoil an element, {} far from the surface, {} where "
              "surfaces meet",
              grouped(curved.guarded), grouped(curved.far), grouped(curved.seams));
  lines.add("", "Jacobian determinants at least {:.4f} of those of straight elements",
            curved.least_jacobian);
}

Json json_of(const OrderReport& report, double size) {
  Json json{{"middle_nodes", report.middle_nodes}, {"curved", report.curved.has_value()}};
  if (!report.curved) return json;
  const CurveFigures& curved = *report.curved;
  json["surface_edges"] = curved.edges;
  json["moved"] = curved.moved;
  json["on_surface"] = curved.on_surface;
  json["straight"] = {
      {"guarded", curved.guarded}, {"far", curved.far}, {"seams", curved.seams}};
  json["greatest_move"] = curved.greatest_move * size;
  json["greatest_move_edges"] = curved.greatest_move;
  json["least_jacobian"] = curved.least_jacobian;
  return json;
}

}  // namespace certet::command
