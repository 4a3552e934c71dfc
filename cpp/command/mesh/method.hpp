#pragma once
/// \file
/// The options that choose a method.

#include <CLI/App.hpp>
#include <optional>

#include "certet/method.hpp"

namespace certet::command {

/// What the user says of it, in one option or another.
struct MethodChoice {
  std::optional<Method> method;
  std::optional<Cuts> cuts;
  std::optional<Method> guarantee;
};

/// Declares `--method`, and `--cuts` and `--guarantee`, which stand for some of them.
void declare_method(CLI::App& app, MethodChoice& choice);

/// \throws Error `bad_option` if the options contradict each other.
Method chosen(const MethodChoice& choice);

}  // namespace certet::command
