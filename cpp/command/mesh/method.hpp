#pragma once
/// \file
/// The ways to mesh, by name.

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "certet/stuffing.hpp"

namespace certet::command {

enum class Method {
  embedded,  ///< vertices settle: the mesh embeds, is a manifold, and keeps pieces
  paper,     ///< every vertex too close to the surface moves onto it
  midpoint,  ///< none does; cuts in the middle of edges
};

Method method_of(const StuffingOptions& options);

std::string name(Method method);
std::string name(Cuts cuts);

/// What the user says of it, in one option or another.
struct MethodChoice {
  std::optional<Method> method;
  std::optional<Cuts> cuts;
  std::optional<Guarantee> guarantee;
};

/// Declares `--method`, and `--cuts` and `--guarantee`, which stand for some of them.
void declare_method(CLI::App& app, MethodChoice& choice);

/// \throws Error `bad_option` if the options contradict each other.
StuffingOptions stuffing_options(const MethodChoice& choice);

}  // namespace certet::command
