#include "particles.hpp"

#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "models/particles/particle_system.hpp"
#include "models/particles/scatter.hpp"
#include "spatial/point_grid.hpp"

namespace panicle::bench {
namespace {

using namespace particles;

// A disc in the plane z = 0 or a ball, of radius 0.5 about the origin.
class Round final : public Region {
 public:
  explicit Round(bool flat) : deep_(flat ? 0.0f : 0.5f) {}
  glm::vec3 low() const override { return {-0.5f, -0.5f, -deep_}; }
  glm::vec3 high() const override { return {0.5f, 0.5f, deep_}; }
  bool contains(const glm::vec3& p) const override { return glm::dot(p, p) <= 0.25f; }

 private:
  float deep_;
};

const glm::vec3 target{0, -0.9f, 0};

struct Start {
  float spacing;
  std::vector<glm::vec3> places;
};

Start start_of(std::uint32_t count, bool flat) {
  const Round region(flat);
  const float spacing = spacing_of(region, count);
  return {spacing, scatter(region, Pattern::blue, count, spacing, 1)};
}

constexpr float step = 0.35f, merge = 0.7f, pull = 0.75f;  // of the spacing, and w

}  // namespace

double run_crowd(std::uint32_t particles, bool flat) {
  const Start start = start_of(particles, flat);
  const Straight guide(target);
  ParticleSystem crowd(start.places, 1, guide,
                       {.step = step * start.spacing, .merge = merge * start.spacing, .pull = pull});
  crowd.run();
  return crowd.trails().size() > 0 ? crowd.merges() : -1;
}

double run_brute_crowd(std::uint32_t particles, bool flat) {
  const Start start = start_of(particles, flat);
  const float s = step * start.spacing, r = merge * start.spacing;
  std::vector<glm::vec3> places = start.places, next;
  std::vector<double> energies(places.size(), 1);
  std::uint32_t merges = 0;
  while (!places.empty()) {
    next = places;
    for (std::size_t i = 0; i < places.size(); ++i) {
      float least = std::numeric_limits<float>::max();
      glm::vec3 near = places[i];
      for (std::size_t j = 0; j < places.size(); ++j) {
        const glm::vec3 d = places[j] - places[i];
        const float square = glm::dot(d, d);
        if (j == i || square >= least) continue;
        least = square;
        near = places[j];
      }
      const glm::vec3 ahead = glm::normalize(target - places[i]);
      const glm::vec3 towards_target = near == places[i] ? glm::vec3(0) : glm::normalize(near - places[i]);
      next[i] += places.size() < 2 ? s * ahead : s * (pull * towards_target + ahead) / (1 + pull);
    }
    std::vector<std::uint8_t> gone(places.size(), 0);
    for (std::size_t i = 0; i < places.size(); ++i) gone[i] = glm::distance(places[i], target) <= s;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = i + 1; j < places.size(); ++j) {
        if (gone[i] || gone[j] || glm::distance(next[i], next[j]) >= r) continue;
        next[i] += static_cast<float>(energies[j] / (energies[i] + energies[j])) * (next[j] - next[i]);
        energies[i] += energies[j];
        gone[j] = 1;
        ++merges;
      }
    std::size_t left = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (gone[i]) continue;
      places[left] = next[i];
      energies[left++] = energies[i];
    }
    places.resize(left);
    energies.resize(left);
  }
  return merges;
}

double colonise(std::uint32_t points, bool flat) {
  const Start start = start_of(points, flat);
  const float length = start.spacing, kill = 2 * length, reach = 8 * length;
  const PointGrid grid(start.places, reach / 2);
  struct Closest {
    std::uint32_t node = ~0u;
    float square = std::numeric_limits<float>::max();
  };
  std::vector<Closest> closest(start.places.size());
  std::vector<std::uint8_t> reached(start.places.size(), 0);
  std::vector<glm::vec3> nodes;
  // Adds a node: it may be the nearest one to some points, and reaches others.
  const auto add = [&](const glm::vec3& node) {
    const auto index = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(node);
    grid.within(node - reach, node + reach, [&](std::uint32_t first, std::uint32_t end) {
      for (std::uint32_t slot = first; slot < end; ++slot) {
        const std::uint32_t i = grid.ids()[slot];
        const glm::vec3 d = start.places[i] - node;
        const float square = glm::dot(d, d);
        if (square < closest[i].square) closest[i] = {index, square};
        if (square < kill * kill) reached[i] = 1;
      }
    });
  };
  for (glm::vec3 trunk = target; trunk.y < -0.5f + length; trunk.y += length) add(trunk);
  std::vector<glm::vec3> pulls, before_pulls;
  while (nodes.size() < 8 * static_cast<std::size_t>(points) + 1000) {
    before_pulls = pulls;
    before_pulls.resize(nodes.size(), glm::vec3(0));
    pulls.assign(nodes.size(), glm::vec3(0));
    for (std::size_t i = 0; i < closest.size(); ++i)
      if (!reached[i] && closest[i].square < reach * reach)
        pulls[closest[i].node] += glm::normalize(start.places[i] - nodes[closest[i].node]);
    const std::size_t before = nodes.size();
    for (std::size_t n = 0; n < before; ++n)
      // A node with the same pull as before would only grow the same node again.
      if (glm::dot(pulls[n], pulls[n]) > 1e-6f && pulls[n] != before_pulls[n])
        add(nodes[n] + length * glm::normalize(pulls[n]));
    if (nodes.size() == before) break;
  }
  return static_cast<double>(nodes.size());
}

}  // namespace panicle::bench
