#include "optimise_choice.hpp"

#include <CLI/CLI.hpp>

#include "option_values.hpp"
#include "refusal.hpp"
#include "report.hpp"

namespace certet::command {

void declare_optimise(CLI::App& app, OptimiseChoice& choice, std::string& to) {
  app.add_flag("--optimise", choice.wanted,
               "Moves vertices, those of surfaces along these, where the worst dihedral angle "
               "around grows by it; the mesh is held in memory");
  app.add_option("--optimise-to", to,
                 "With --optimise: the angle, in degrees, that none is to be nearer to 0 or to 180 "
                 "than (default: 25)")
      ->option_text("DEGREES");
}

void check_optimise(OptimiseChoice& choice, const std::string& to, Method method) {
  if (!to.empty()) {
    if (!choice.wanted) refuse("--optimise-to goes with --optimise");
    choice.goal.angle = parse_positive("--optimise-to", to);
    if (choice.goal.angle > greatest_goal)
      refuse(fmt::format("--optimise-to takes at most {} degrees, not '{}'", greatest_goal, to));
  }
  if (choice.wanted && facts(method).cuts == Cuts::midpoint)
    refuse("--optimise does not go with --method midpoint, whose surface has steps");
}

Mesh optimised(const OptimiseChoice& choice, const PlacedDomain& domain, const Stuffing& stuffing,
               Context& context, OptimiseFigures& figures) {
  Mesh made = mesh(domain, stuffing, context);
  figures = optimise(made, domain, choice.goal, context);
  return made;
}

std::uint64_t bytes_to_optimise(const Stuffing& stuffing) {
  constexpr std::uint64_t point = 2 * sizeof(Coord3) + 16;
  const std::uint64_t tet = 4 * (stuffing.point_count() >> 32 == 0 ? 4 : 8) + 4 + 4;
  return stuffing.point_count() * point + stuffing.tet_count() * tet;
}

void add_optimise(Lines& lines, const OptimiseFigures& figures, double size) {
  lines.add("optimised", "{} vertices moved in {} rounds, by at most {:.4f} edges ({:.4g})",
            grouped(figures.moved), figures.rounds, figures.greatest_move,
            figures.greatest_move * size);
  lines.add("", "{} of these along surfaces, by at most {:.4f} edges ({:.4g}){}",
            grouped(figures.moved_on_surface), figures.greatest_move_on_surface,
            figures.greatest_move_on_surface * size,
            figures.left_surface == 0
                ? ""
                : fmt::format("; {} left theirs, by at most {} edges", grouped(figures.left_surface),
                              loose_reach));
  lines.add("", "tetrahedra with an angle nearer than {}° to 0° or 180°: {}, {} before",
            figures.goal, grouped(figures.short_after), grouped(figures.short_before));
}

Json json_of(const OptimiseFigures& figures, double size) {
  return {{"goal", figures.goal},
          {"rounds", figures.rounds},
          {"moved", figures.moved},
          {"moved_on_surface", figures.moved_on_surface},
          {"moved_on_seams", figures.moved_on_seams},
          {"left_surface", figures.left_surface},
          {"greatest_move", figures.greatest_move * size},
          {"greatest_move_edges", figures.greatest_move},
          {"greatest_move_on_surface_edges", figures.greatest_move_on_surface},
          {"short_before", figures.short_before},
          {"short_after", figures.short_after}};
}

}  // namespace certet::command
