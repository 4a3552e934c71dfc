#pragma once
/// \file
/// Which surface goes into a file that has but one.

#include <CLI/App.hpp>
#include <string>

#include "certet/formats.hpp"
#include "certet/survey.hpp"

namespace certet::command {

/// Declares --surface, which writes to `text`.
void declare_surface_choice(CLI::App& app, std::string& text);

/// \throws Error `bad_option` if a surface is chosen and the format holds tetrahedra.
void check_surface_choice(const std::string& text, Format format);

/// Leaves of a survey what --surface asks for: one label or two, or their names, or all
/// interfaces; all of the boundary if it is empty.  \throws Error `bad_option` if there is no such surface.
void choose_surface(const std::string& text, const LabelNames& names, Survey& survey);

}  // namespace certet::command
