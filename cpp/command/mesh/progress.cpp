#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

namespace certet::command {

Progress::Progress(Context& context)
    : context_(context), terminal_(isatty(STDERR_FILENO) == 1) {
  context.progress = [this](Stage stage, std::int64_t done, std::int64_t total) {
    if (static_cast<int>(stage) != stage_) enter(stage);
    if (stage != Stage::emit)
      show(name(stage), static_cast<std::uint64_t>(done), static_cast<std::uint64_t>(total));
  };
}

Progress::~Progress() {
  context_.progress = nullptr;
  if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::enter(Stage stage) {
  stop();
  stage_ = static_cast<int>(stage);
}

void Progress::stop() {
  const double now = since_start_.seconds();
  if (stage_ >= 0) seconds_[static_cast<std::size_t>(stage_)] += now - stage_start_;
  stage_start_ = now;
  stage_ = -1;
}

void Progress::show(std::string_view stage, std::uint64_t done, std::uint64_t total) {
  if (!terminal_ || total == 0) return;
  const double now = since_start_.seconds();
  if (now < last_shown_ + 0.1) return;  // which starts at a second
  last_shown_ = now;
  visible_ = true;
  std::fprintf(stderr, "\r\033[K%.*s %.0f %%", static_cast<int>(stage.size()), stage.data(),
               100.0 * static_cast<double>(done) / static_cast<double>(total));
  std::fflush(stderr);
}

void WatchedWriter::points(std::span<const Point3> points) {
  writer_.points(points);
  progress_.show("write", done_ += points.size(), size_.points + size_.tets);
}

void WatchedWriter::tets(std::span<const Tet<std::uint32_t>> tets,
                         std::span<const std::int32_t> labels) {
  writer_.tets(tets, labels);
  progress_.show("write", done_ += tets.size(), size_.points + size_.tets);
}

void WatchedWriter::tets(std::span<const Tet<std::uint64_t>> tets,
                         std::span<const std::int32_t> labels) {
  writer_.tets(tets, labels);
  progress_.show("write", done_ += tets.size(), size_.points + size_.tets);
}

}  // namespace certet::command
