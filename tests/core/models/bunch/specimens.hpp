// Requests and checks that the bunch's tests share.
#pragma once

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "foundation/random.hpp"
#include "models/bunch/builtin.hpp"
#include "models/bunch/bunch.hpp"
#include "models/bunch/parameters.generated.hpp"
#include "models/bunch/table3.hpp"

namespace panicle::tests {

inline void set(bunch::BunchRequest& request, bunch::Parameter key, float value) {
  request.parameters.resize(bunch::parameter_count, std::numeric_limits<float>::quiet_NaN());
  request.parameters[static_cast<std::size_t>(key)] = value;
}

inline void set_profile(bunch::BunchRequest& request, const bunch::Profile& profile) {
  set(request, bunch::Parameter::l, profile.length);
  const auto first = static_cast<std::uint32_t>(bunch::Parameter::p3w);
  for (std::uint32_t i = 0; i < 4; ++i) {
    set(request, static_cast<bunch::Parameter>(first + 2 * i), profile.sides[i].width);
    set(request, static_cast<bunch::Parameter>(first + 2 * i + 1), profile.sides[i].drop);
  }
}

inline bunch::BunchRequest request_for(const bunch::Profile& profile, std::uint32_t seed = 1) {
  bunch::BunchRequest request;
  request.seed = seed;
  request.meshes = false;
  set(request, bunch::Parameter::procedure, 0);
  set_profile(request, profile);
  return request;
}

// The natural procedure.
inline bunch::BunchRequest natural_request(const bunch::Profile& profile, std::uint32_t seed = 1) {
  bunch::BunchRequest request = request_for(profile, seed);
  set(request, bunch::Parameter::procedure, 1);
  request.measures = false;
  return request;
}

inline bunch::GrownBunch grown(const bunch::BunchRequest& request) {
  auto result = bunch::grow(request);
  REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
  return std::move(result.value());
}

// The paper's exact method: whole segments, no variation.
inline bunch::BunchRequest as_printed(const bunch::Profile& profile, std::uint32_t seed = 1) {
  bunch::BunchRequest request = request_for(profile, seed);
  set(request, bunch::Parameter::fit, 0);
  set(request, bunch::Parameter::vary, 0);
  return request;
}

inline void set_radius(bunch::BunchRequest& request, float low, float high) {
  set(request, bunch::Parameter::rmin, low);
  set(request, bunch::Parameter::rmax, high);
}

inline bunch::Profile random_profile(std::uint64_t seed) {
  const auto pick = [seed](std::uint64_t k, std::int32_t low, std::int32_t high) {
    return static_cast<float>(random_integer(seed, hash_text("profile"), k, low, high));
  };
  bunch::Profile profile{pick(0, 29, 580), {}};
  for (std::uint64_t i = 0; i < 4; ++i) profile.sides[i] = {pick(1 + i, 0, 290), pick(5 + i, 0, 580)};
  return profile;
}

// A built-in grammar with all occurrences of a passage replaced; empty if there are none.
inline std::string edited(int number, std::string_view from, std::string_view to) {
  std::string text(bunch::builtin_grammar(number));
  bool found = false;
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
    found = true;
  }
  return found ? text : std::string();
}

// Greatest depth by which two berries overlap, in metres; 0 if none do.
inline double worst_overlap(const bunch::GrownBunch& grown) {
  double worst = 0;
  for (std::size_t a = 0; a < grown.berries.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const bunch::Berry &p = grown.berries[a], &q = grown.berries[b];
      const double x = double(p.centre.x) - q.centre.x, y = double(p.centre.y) - q.centre.y,
                   z = double(p.centre.z) - q.centre.z;
      worst = std::fmax(worst, double(p.radius) + q.radius - std::sqrt(x * x + y * y + z * z));
    }
  return worst;
}

}  // namespace panicle::tests
