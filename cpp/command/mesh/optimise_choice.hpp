#pragma once
/// \file
/// Vertices that move for better angles: what is asked for, and what became of them.

#include <CLI/App.hpp>
#include <cstdint>
#include <string>

#include "certet/method.hpp"
#include "certet/optimise.hpp"
#include "certet/placed_domain.hpp"
#include "certet/stuffing.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// --optimise and --optimise-to.
struct OptimiseChoice {
  bool wanted = false;
  OptimiseGoal goal;
};

/// `to` is where the text of --optimise-to goes.
void declare_optimise(CLI::App& app, OptimiseChoice& choice, std::string& to);
/// Reads that text.  \throws Error `bad_option` where the rest does not go with it.
void check_optimise(OptimiseChoice& choice, const std::string& to, Method method);

/// The counted mesh in memory, once its vertices have moved.
Mesh optimised(const OptimiseChoice& choice, const PlacedDomain& domain, const Stuffing& stuffing,
               Context& context, OptimiseFigures& figures);

/// Bytes that this takes at most, about.
std::uint64_t bytes_to_optimise(const Stuffing& stuffing);

void add_optimise(Lines& lines, const OptimiseFigures& figures, double size);
Json json_of(const OptimiseFigures& figures, double size);

}  // namespace certet::command
