// From the octahedral profile to the counts of the grammar (Huang et al. 2013, section 4.2, Table 3).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace panicle::bunch {

// Pixels to segments; the paper's constants for a 600 × 600 view (section 5).
inline constexpr float pixels_per_rachis_segment = 29.0f;  // C_l
inline constexpr float pixels_per_axis_segment = 25.0f;    // C_w
inline constexpr float axes_per_pixel_of_drop = 0.056f;    // C_r

// A side point of the profile, in pixels of the paper's 600 × 600 view.
struct SidePoint {
  float width = 0;  // w: distance from the axis
  float drop = 0;   // r: depth below p1
};

struct Profile {
  float length = 0;                     // l: depth of p2 below p1
  std::array<SidePoint, 4> sides = {};  // p3 right, p4 left, p5 front, p6 back
};

struct SidePlan {
  SidePoint point;
  std::int32_t n = 0;   // segments of the side's longest axis
  std::int32_t rd = 0;  // the axis at which the side has shrunk to one end structure
};

struct Plan {
  std::int32_t m = 1;  // rachis segments
  std::array<SidePlan, 4> sides = {};
  std::vector<std::int32_t> axes;  // n(0) … n(m−2), from the top
};

// Computes m, n_i, rd_i by nearest integers: reproduces 125 of the 126 derived values of Table 3. `m` other than 0
// replaces the profile's.
Plan make_plan(const Profile& profile, std::int32_t m = 0);

// The same outline scaled by `factor`: the second bunch of a double bunch.
Profile scaled(const Profile& profile, float factor);

// Stretch of lengths, so that every pixel of the profile counts and not only every whole segment. 1 is the paper's
// method.
struct Fit {
  float rachis = 1;
  std::array<float, 4> sides = {1, 1, 1, 1};
};

// `amount` 0 … 1 goes from the paper's whole segments to lengths that follow the profile.
Fit make_fit(const Profile& profile, const Plan& plan, float amount);

}  // namespace panicle::bunch
