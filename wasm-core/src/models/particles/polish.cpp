#include "models/particles/polish.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

#include "foundation/easing.hpp"

namespace panicle::particles {

// The energy of a place is the sum over all particles that pass it.

namespace {

constexpr float least_passes = 2.5f, more_passes = 15;
// The share of all energy with which a trail is moved halfway onto its rib.
constexpr double bedded_energy = 0.004;
// This multiple of the reach applies where a trail goes on along a rib and other trails have drawn it away.
constexpr float back_from = 2;

// A place that is smoothed: its index, the run of places that lead to it, and the number of moves that are left.
struct Drawn {
  std::uint32_t place, first, count;
  float passes;
};

// The next point on the way to the target.
std::size_t next_of(const Trails& trails, std::size_t i) { return static_cast<std::size_t>(trails.next[i]); }

// For each place the run of places that lead to it: the first index and the count. In tree order they are side by side.
std::vector<std::pair<std::uint32_t, std::uint32_t>> leading_to(const Trails& trails) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> runs(trails.size(), {0, 0});
  for (std::uint32_t i = 1; i < trails.size(); ++i) {
    auto& [first, count] = runs[next_of(trails, i)];
    if (count == 0) first = i;
    ++count;
  }
  return runs;
}

// The distance of a point from the segment between `from` and `to`.
float distance_to_segment(const glm::vec3& p, const glm::vec3& from, const glm::vec3& to) {
  const glm::vec3 way = to - from;
  const float square = glm::dot(way, way);
  const float at = square > 0 ? glm::clamp(glm::dot(p - from, way) / square, 0.0f, 1.0f) : 0;
  return glm::distance(p, from + at * way);
}

// Whether place i may move to `to`: the point must be free and see the next place and the `run` of places that lead to
// i.
bool is_free(const Guide& guide, const Trails& trails, std::uint32_t i,
             const std::pair<std::uint32_t, std::uint32_t>& run, const glm::vec3& to) {
  const std::vector<glm::vec3>& places = trails.places;
  if (guide.sees_all()) return guide.passes(places[i], to);
  const auto [first, count] = run;
  const glm::vec3& next = places[next_of(trails, i)];
  if (const float room = guide.room(to); room > 0) {
    float longest = std::max(glm::distance(to, places[i]), glm::distance(to, next));
    for (std::uint32_t k = first; k < first + count; ++k) longest = std::max(longest, glm::distance(to, places[k]));
    if (longest < room) return true;
  }
  bool free = guide.open(to) && guide.passes(places[i], to) && guide.sees(to, next);
  for (std::uint32_t k = first; free && k < first + count; ++k) free = guide.sees(places[k], to);
  return free;
}

}  // namespace

// Smooths trails: moves each place towards the middle between its next place and the mean of those that lead to it.
// Places with more energy are moved more often; `share` 0 … 1 scales the number of moves.
void smooth(Trails& trails, const Guide& guide, float share) {
  const auto runs = leading_to(trails);
  std::vector<Drawn> moving;
  std::vector<float> weights(trails.size(), 1);  // of each among those that lead to the same place
  for (std::uint32_t i = 1; i < trails.size(); ++i) {
    const auto [first, count] = runs[i];
    if (count == 0 || trails.particle[i] >= 0) continue;
    const auto carried = static_cast<float>(std::sqrt(trails.energy[i] / trails.energy[0]));
    moving.push_back({i, first, count, share * (least_passes + more_passes * carried)});
    double sum = 0;
    for (std::uint32_t k = first; k < first + count; ++k) sum += trails.energy[k];
    for (std::uint32_t k = first; k < first + count; ++k) weights[k] = static_cast<float>(trails.energy[k] / sum);
  }
  std::vector<glm::vec3>& places = trails.places;
  // One after the other, so that a place still sees its neighbours when the next is moved.
  for (bool outwards = true; !moving.empty(); outwards = !outwards) {
    for (std::size_t m = 0; m < moving.size(); ++m) {
      Drawn& at = moving[outwards ? m : moving.size() - 1 - m];
      glm::vec3 mean(0);
      for (std::uint32_t k = at.first; k < at.first + at.count; ++k) mean += weights[k] * places[k];
      const glm::vec3 middle = 0.5f * (places[next_of(trails, at.place)] + mean);
      const glm::vec3 drawn = places[at.place] + std::min(at.passes, 1.0f) * (middle - places[at.place]);
      if (is_free(guide, trails, at.place, runs[at.place], drawn)) places[at.place] = drawn;
      at.passes -= 1;
    }
    std::erase_if(moving, [](const Drawn& at) { return !(at.passes > 0); });
  }
}

// Moves trails that run within `reach` of a rib (a leaf's main vein) onto it: the more, the more energy they carry. The
// heaviest trail continues on its line.
void move_onto_ribs(Trails& trails, const RibGrid& ribs, const Guide& guide, float reach) {
  constexpr std::uint32_t none = ~0u;
  const auto runs = leading_to(trails);
  // The heaviest trail stays on its line where another leaves it, else veins would step sideways there.
  std::vector<std::uint32_t> lines(trails.size(), 0), heaviest(trails.size(), 0);
  for (std::uint32_t i = 1; i < trails.size(); ++i) {
    std::uint32_t& child = heaviest[next_of(trails, i)];
    if (child == 0 || trails.energy[i] > trails.energy[child]) child = i;
  }
  for (std::size_t i = 1; i < trails.size(); ++i) {
    lines[i] = none;
    if (runs[i].second == 0) continue;
    Ribs::Foot foot = ribs.nearest(trails.places[i]);
    const std::size_t next = next_of(trails, i);
    const bool goes_on = heaviest[next] == i && lines[next] != none, same = ribs.line_of(foot.at) == lines[next];
    const float within = goes_on && same ? back_from * reach : reach;
    if (!(foot.distance < within)) continue;
    if (goes_on && !same)
      if (const Ribs::Foot along = ribs.nearest_on(lines[next], trails.places[i]); along.distance < reach) foot = along;
    lines[i] = ribs.line_of(foot.at);
    const auto carried = static_cast<float>(trails.energy[i] / (trails.energy[i] + bedded_energy * trails.energy[0]));
    const glm::vec3 moved = trails.places[i] + carried * smooth_step(within, 0.5f * within, foot.distance) *
                                                   (foot.place - trails.places[i]);
    // That far away there may be an obstacle in between.
    bool free = within == reach || guide.sees(moved, trails.places[next]);
    for (std::uint32_t k = runs[i].first; free && within > reach && k < runs[i].first + runs[i].second; ++k)
      free = guide.sees(trails.places[k], moved);
    if (free) trails.places[i] = moved;
  }
}

// Drops places that are closer than `tolerance` to the line between those that remain (Douglas-Peucker). Forks, starts
// and the target remain; with `arrivals` also the places that lead to the target.
Trails simplified(const Trails& trails, float tolerance, bool arrivals) {
  const auto runs = leading_to(trails);
  std::vector<std::uint8_t> retained(trails.size(), 0);
  std::vector<std::uint32_t> chain;
  std::vector<std::pair<std::size_t, std::size_t>> spans;
  for (std::uint32_t end = 0; end < trails.size(); ++end) {
    const bool arrival = arrivals && trails.next[end] == 0;
    if (end > 0 && runs[end].second == 1 && trails.particle[end] < 0 && !arrival) continue;
    retained[end] = 1;
    if (end == 0) continue;
    // From here to the next fork, start or target.
    chain = {end};
    for (std::size_t i = next_of(trails, end);; i = next_of(trails, i)) {
      chain.push_back(static_cast<std::uint32_t>(i));
      if (retained[i] || runs[i].second != 1 || trails.particle[i] >= 0) break;
    }
    spans = {{0, chain.size() - 1}};
    while (!spans.empty()) {
      const auto [first, last] = spans.back();
      spans.pop_back();
      float farthest = tolerance;
      std::size_t corner = 0;
      for (std::size_t k = first + 1; k < last; ++k) {
        const float off =
            distance_to_segment(trails.places[chain[k]], trails.places[chain[first]], trails.places[chain[last]]);
        if (!(off > farthest)) continue;
        farthest = off;
        corner = k;
      }
      if (corner == 0) continue;
      retained[chain[corner]] = 1;
      spans.push_back({first, corner});
      spans.push_back({corner, last});
    }
  }
  Trails result;
  std::vector<std::int32_t> new_index(trails.size(), -1);
  for (std::size_t i = 0; i < trails.size(); ++i) {
    if (i > 0 && !retained[i]) {
      new_index[i] = new_index[next_of(trails, i)];  // places that led to the removed place lead to its next
      continue;
    }
    const std::int32_t to = i == 0 ? -1 : new_index[next_of(trails, i)];
    new_index[i] = result.add(trails.places[i], to, trails.energy[i], trails.born[i], trails.particle[i]);
  }
  return result;
}

// Divides long pieces of trails with energies from `least` to below `most` into equal parts no longer than `longest`.
// `stride` is the way in a step.
Trails divided(const Trails& trails, float longest, double least, double most, float stride) {
  Trails result;
  result.reserve(2 * trails.size());
  std::vector<std::int32_t> new_index(trails.size(), -1);
  for (std::size_t i = 0; i < trails.size(); ++i) {
    std::int32_t to = -1;
    if (i > 0) {
      const std::size_t next = next_of(trails, i);
      to = new_index[next];
      const glm::vec3 way = trails.places[next] - trails.places[i];
      const float length = glm::length(way);
      const bool whole = next == 0 || trails.energy[i] < least || !(trails.energy[i] < most);
      const std::uint32_t pieces = whole ? 1 : 1 + static_cast<std::uint32_t>(length / longest);
      const auto left_at = static_cast<float>(trails.born[i]);
      const float arrives_at = arrival(trails, i, stride);
      for (std::uint32_t k = 1; k < pieces; ++k) {
        const float share = 1 - static_cast<float>(k) / static_cast<float>(pieces);
        to = result.add(trails.places[i] + share * way, to, trails.energy[i],
                        static_cast<std::uint32_t>(left_at + share * (arrives_at - left_at)), -1);
      }
    }
    new_index[i] = result.add(trails.places[i], to, trails.energy[i], trails.born[i], trails.particle[i]);
  }
  return result;
}

// Moves places back to where they were `before` until each place is free and sees its next one again.
void take_back_hidden(Trails& trails, const std::vector<glm::vec3>& before, const Guide& guide) {
  std::vector<glm::vec3>& places = trails.places;
  for (bool hidden = !guide.sees_all(); hidden;) {
    hidden = false;
    for (std::size_t i = 1; i < trails.size(); ++i) {
      const std::size_t next = next_of(trails, i);
      if (places[i] == before[i] && places[next] == before[next]) continue;
      if (guide.open(places[i]) && guide.sees(places[i], places[next])) continue;
      places[i] = before[i];
      places[next] = before[next];
      hidden = true;
    }
  }
}

}  // namespace panicle::particles
