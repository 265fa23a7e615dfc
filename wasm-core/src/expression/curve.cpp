#include <algorithm>

#include "expression/code.hpp"

namespace panicle::expression {

// Builds the monotone cubic curve (Fritsch & Butland 1984) through x0, y0, x1, y1, …: two points or more, by ascending
// x.
Curve::Curve(std::span<const float> points) {
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    x.push_back(points[i]);
    y.push_back(points[i + 1]);
  }
  const std::size_t last = x.size() - 1;
  const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  slope.assign(x.size(), 0);
  slope[0] = secant(0);
  slope[last] = secant(last - 1);
  // The harmonic mean of the secants beside a point, weighted by their widths; flat at a turning point.
  for (std::size_t i = 1; i < last; ++i) {
    const float before = secant(i - 1), behind = secant(i);
    if (before * behind <= 0) continue;
    const float h = x[i] - x[i - 1], k = x[i + 1] - x[i];
    slope[i] = 3 * (h + k) / ((h + 2 * k) / before + (2 * h + k) / behind);
  }
}

// The value of the curve (cubic Hermite); beyond its ends that of the nearest end, NaN for NaN.
float Curve::at(float value) const {
  if (!(value > x.front())) return value == value ? y.front() : value;
  if (value >= x.back()) return y.back();
  const std::size_t i = static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), value) - x.begin()) - 1;
  const float width = x[i + 1] - x[i], t = (value - x[i]) / width;
  const float rest = 1 - t;
  return y[i] * (1 + 2 * t) * rest * rest + y[i + 1] * t * t * (3 - 2 * t) +
         width * t * rest * (slope[i] * rest - slope[i + 1] * t);
}

}  // namespace panicle::expression
