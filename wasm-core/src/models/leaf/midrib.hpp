// A main vein of a leaf during its construction.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "models/particles/outline.hpp"
#include "models/particles/ribs.hpp"

namespace panicle::particles::leaf {

constexpr float before_tip = 0.985f;     // where a main vein ends, of its length
constexpr float stride = 0.02f;          // of a rib's pieces, leaf lengths
constexpr float before_margin = 0.012f;  // leaf lengths that ribs stay off the margin

// A point without its third coordinate, and with one of 0.
inline glm::vec2 flat(const glm::vec3& p) { return {p.x, p.y}; }
inline glm::vec3 deep(const glm::vec2& p) { return {p.x, p.y, 0}; }

// A main vein among the places of its ribs.
struct Midrib {
  std::vector<glm::vec3> places;
  std::vector<std::int32_t> numbers;  // in the ribs
  std::vector<float> lengths;         // from the base

  float length() const { return lengths.back(); }
  // The first place at least that far along it, or its last.
  std::size_t at(float length) const;
  glm::vec2 heading(std::size_t i) const;
};

// Adds a place that leads to the place `next`; returns its number.
std::int32_t add(Ribs& ribs, std::int32_t next, const glm::vec3& place);
// Builds a main vein from place 0 of the ribs, which is the first of `places`.
Midrib build_midrib(Ribs& ribs, std::vector<glm::vec3> places);

// Moves each place but the ends towards the middle of its neighbours, so many times, where there is room.
void round_off(std::vector<glm::vec3>& places, const Outline& outline, int passes);

// Whether the straight line from the base, which is on the margin itself, lies in the blade.
bool straight(const glm::vec3& base, const glm::vec3& end, const Outline& outline);
// A main vein from the base to a tip, in pieces: straight where that is open, else round the corners.
std::vector<glm::vec3> main_vein(const glm::vec3& base, const glm::vec3& tip, const Outline& outline);

}  // namespace panicle::particles::leaf
