#pragma once
/// \file
/// A run from its beginning to the report of it.

#include "certet/context.hpp"
#include "report.hpp"
#include "signals.hpp"
#include "status.hpp"

namespace certet::command {

/// Of work that gives a report: what carries it out until a signal ends it, and tells the report,
/// the warnings first.
template <class Options, class Report>
auto run_and_tell(Report (*work)(const Options&, Context&)) {
  return [work](const Options& options) {
    Context context;
    context.threads = options.run.threads;
    const Signals signals(context);
    const Report report = work(options, context);
    warn(report.warnings);
    tell(report, options.run.json);
    return Status::ok;
  };
}

}  // namespace certet::command
