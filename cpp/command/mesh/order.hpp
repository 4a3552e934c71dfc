#pragma once
/// \file
/// Tetrahedra of ten nodes: what is asked for, and what became of it.

#include <CLI/App.hpp>
#include <cstdint>
#include <memory>
#include <optional>

#include "certet/curve.hpp"
#include "certet/formats.hpp"
#include "certet/method.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// --order and --curved.
struct OrderChoice {
  int order = 1;        ///< of the elements: 1 for four nodes, 2 for ten
  bool curved = false;  ///< middle nodes of the surfaces lie on these
};

void declare_order(CLI::App& app, OrderChoice& choice);
/// \throws Error `bad_option` where the rest does not go with it.
void check_order(const OrderChoice& choice, Format format, Method method);

/// What is known of the middle nodes of a mesh.
struct OrderReport {
  std::uint64_t middle_nodes = 0;
  std::optional<CurveFigures> curved;  ///< if they were to be
};

/// The middle nodes of a mesh, which go into `size`; curved ones need its survey.  `moved` is the
/// mesh in memory once its vertices have moved, or null.
std::optional<OrderReport> add_middle_nodes(const OrderChoice& choice, const Domain& domain,
                                            const Stuffing& stuffing, const Mesh* moved,
                                            MeshSize& size, Context& context);

void add_order(Lines& lines, const OrderReport& report, double size);
Json json_of(const OrderReport& report, double size);

}  // namespace certet::command
