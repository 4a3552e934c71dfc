#include "certet/warp_figures.hpp"

#include <cmath>

#include "certet/lattice/structured_tet.hpp"

namespace certet {
namespace {

ShiftLengths lengths(const CutShift& l, const CutShift& s, double long_edge, double short_edge) {
  ShiftLengths found{l.cuts + s.cuts};
  if (found.cuts == 0) return found;
  const double long_step = long_edge / steps;
  const double short_step = short_edge / steps;
  found.greatest = std::max(long_step * l.greatest, short_step * s.greatest);
  found.rms = std::sqrt((long_step * long_step * static_cast<double>(l.sum_of_squares) +
                         short_step * short_step * static_cast<double>(s.sum_of_squares)) /
                        static_cast<double>(found.cuts));
  return found;
}

}  // namespace

ShiftLengths shift_in_edges(const WarpFigures& figures) {
  return lengths(figures.long_edges, figures.short_edges, 1, 1);
}

ShiftLengths shift_in_world(const WarpFigures& figures, double size) {
  return lengths(figures.long_edges, figures.short_edges, size, std::sqrt(0.75) * size);
}

ShiftLengths missed_by(const WarpFigures& figures, double long_edge) {
  return lengths(figures.missed, {}, long_edge, 0);
}

}  // namespace certet
