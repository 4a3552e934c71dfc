#pragma once
/// \file
/// How the end of a run is told.

#include <cstdio>
#include <string>
#include <vector>

#include "outputs.hpp"

namespace certet::command {

/// To stderr, a line each.
inline void warn(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences)
    std::fprintf(stderr, "certet: warning: %s\n", sentence.c_str());
}

/// To stdout and to where --json says; the table gives way to JSON on stdout.
/// A report has a `table` for people and a `json` for programs.
template <class Report>
void tell(const Report& report, const std::string& json_target) {
  if (!json_target.empty()) write_text(json_target, json(report));
  if (json_target == "-")
    std::fputs(table(report).c_str(), stderr);
  else
    write_text("-", table(report));
}

}  // namespace certet::command
