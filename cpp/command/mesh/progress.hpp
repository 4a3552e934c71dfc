#pragma once
/// \file
/// How far a run is, and how long its stages took.

#include <array>
#include <cstdint>
#include <string_view>

#include "certet/context.hpp"
#include "certet/formats.hpp"
#include "stopwatch.hpp"

namespace certet::command {

/// Listens to a context.  Shows a line on stderr if that is a terminal and the
/// run takes longer than a second; wipes it away in the end.
class Progress {
 public:
  explicit Progress(Context& context);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Also for work that the engine does not report.
  void show(std::string_view stage, std::uint64_t done, std::uint64_t total);
  /// Ends the current stage of the engine.
  void stop();
  /// Wall seconds of a stage of the engine, all its passes together.
  [[nodiscard]] double seconds(Stage stage) const {
    return seconds_[static_cast<std::size_t>(stage)];
  }

 private:
  void enter(Stage stage);

  Context& context_;
  Stopwatch since_start_;
  std::array<double, 5> seconds_{};
  int stage_ = -1;
  double stage_start_ = 0, last_shown_ = 1;
  bool terminal_, visible_ = false;
};

/// A writer that tells how much has passed through it.
class WatchedWriter final : public MeshWriter {
 public:
  WatchedWriter(MeshWriter& writer, const MeshSize& size, Progress& progress)
      : writer_(writer), size_(size), progress_(progress) {}

  void points(std::span<const Point3> points) override;
  void tets(std::span<const Tet<std::uint32_t>> tets,
            std::span<const std::int32_t> labels) override;
  void tets(std::span<const Tet<std::uint64_t>> tets,
            std::span<const std::int32_t> labels) override;
  void finish() override { writer_.finish(); }

 private:
  MeshWriter& writer_;
  MeshSize size_;
  Progress& progress_;
  std::uint64_t done_ = 0;
};

}  // namespace certet::command
