#include "histogram.hpp"

#include <algorithm>
#include <numeric>

#include "packing.hpp"

namespace certet::view {
namespace {

// In the units of the drawing.
constexpr double width = 400, height = 210, left = 8, right = 8, top = 26, bottom = 24;

class Plot {
 public:
  explicit Plot(const Histogram& histogram) : h_(histogram) {
    total_ = std::accumulate(h_.counts.begin(), h_.counts.end(), std::uint64_t{0});
    greatest_ = h_.counts.empty() ? 0 : *std::ranges::max_element(h_.counts);
  }

  std::string svg() {
    text_ = "<svg class=\"histogram\" id=\"" + h_.id + "\" viewBox=\"0 0 400 210\" role=\"img\" "
            "aria-label=\"" + escaped(h_.title) + "\">\n";
    for (std::size_t bin = 0; bin < h_.counts.size(); ++bin) bar(bin);
    line(left, height - bottom, width - right, height - bottom, "axis");
    ticks();
    for (const Mark& mark : h_.marks) draw(mark);
    return text_ + "</svg>\n";
  }

 private:
  [[nodiscard]] double x(double value) const {
    const double range = h_.high > h_.low ? h_.high - h_.low : 1;
    return left + (width - left - right) * (value - h_.low) / range;
  }
  [[nodiscard]] double edge(std::size_t bin) const {
    return h_.low + (h_.high - h_.low) * static_cast<double>(bin) /
                        static_cast<double>(h_.counts.size());
  }
  [[nodiscard]] std::string value(double number) const { return shortened(number, 4) + h_.unit; }

  void bar(std::size_t bin) {
    const std::uint64_t count = h_.counts[bin];
    if (count == 0) return;
    const double share = static_cast<double>(count) / static_cast<double>(total_);
    // Whatever is there is seen.
    const double tall = std::max(1.5, (height - top - bottom) * static_cast<double>(count) /
                                          static_cast<double>(greatest_));
    const double step = (width - left - right) / static_cast<double>(h_.counts.size());
    const double from = left + step * static_cast<double>(bin);
    const bool last = h_.open_end && bin + 1 == h_.counts.size();
    text_ += "<rect x=\"" + shortened(from + 0.5) + "\" y=\"" +
             shortened(height - bottom - tall) + "\" width=\"" + shortened(step - 1) +
             "\" height=\"" + shortened(tall) + "\" data-count=\"" + std::to_string(count) +
             "\"><title>" + value(edge(bin)) +
             (last ? " and more" : " to " + value(edge(bin + 1))) + ": " +
             grouped_digits(count) + " (" + shortened(100 * share, 3) + " %)</title></rect>\n";
  }

  void line(double x0, double y0, double x1, double y1, const char* kind) {
    text_ += "<line class=\"" + std::string(kind) + "\" x1=\"" + shortened(x0) + "\" y1=\"" +
             shortened(y0) + "\" x2=\"" + shortened(x1) + "\" y2=\"" + shortened(y1) + "\"/>\n";
  }

  void label(double at, double y, const std::string& text, const char* kind) {
    const char* anchor = at < 40 ? "start" : at > width - 40 ? "end" : "middle";
    text_ += "<text class=\"" + std::string(kind) + "\" x=\"" + shortened(at) + "\" y=\"" +
             shortened(y) + "\" text-anchor=\"" + anchor + "\">" + text + "</text>\n";
  }

  void ticks() {
    const double step = h_.tick > 0 ? h_.tick : (h_.high - h_.low) / 2;
    if (!(step > 0)) return label(left, height - 7, value(h_.low), "tick");
    for (int i = 0; h_.low + i * step <= h_.high + 1e-9 * step; ++i)
      label(x(h_.low + i * step), height - 7, value(h_.low + i * step), "tick");
  }

  void draw(const Mark& mark) {
    const char* kind = mark.certain ? "bound" : "bound light";
    line(x(mark.at), top - 6, x(mark.at), height - bottom, kind);
    if (mark.certain) label(x(mark.at), top - 11, value(mark.at), kind);
  }

  const Histogram& h_;
  std::uint64_t total_ = 0, greatest_ = 0;
  std::string text_;
};

}  // namespace

std::string svg(const Histogram& histogram) { return Plot(histogram).svg(); }

}  // namespace certet::view
