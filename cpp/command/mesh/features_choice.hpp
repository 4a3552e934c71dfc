#pragma once
/// \file
/// Sharp edges: whether vertices move onto them, why, and what became of that.

#include <CLI/App.hpp>
#include <optional>
#include <string>

#include "certet/features.hpp"
#include "certet/method.hpp"
#include "json.hpp"
#include "table.hpp"

namespace certet::command {

/// `text` is where that of --features goes.
void declare_features(CLI::App& app, std::string& text);
/// \throws Error `bad_option`.
FeatureChoice chosen_features(const std::string& text, Method method);

/// What is known of sharp edges in the end.
struct FeaturesReport {
  std::string asked;
  FeatureDecision decision;
  std::optional<FeatureFigures> figures;  ///< where vertices have moved
};

/// As --features has it.
std::string name(const FeatureChoice& choice);

void add_features(Lines& lines, const FeaturesReport& report, double size);
Json json_of(const FeaturesReport& report, double size);

}  // namespace certet::command
