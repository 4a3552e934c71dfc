#include "certet/patient_axes.hpp"

namespace certet {

std::string_view name(PatientAxes axes) { return axes == PatientAxes::lps ? "lps" : "ras"; }
std::string_view space(PatientAxes axes) { return axes == PatientAxes::lps ? "LPS" : "RAS"; }

Frame turned_over(const Frame& frame) {
  Frame turned = frame;
  for (std::size_t r = 0; r < 2; ++r) {
    turned.origin[r] = 0.0 - frame.origin[r];
    for (double& component : turned.axes[r]) component = 0.0 - component;
  }
  return turned;
}

}  // namespace certet
