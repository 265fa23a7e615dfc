#include "models/growth/moment.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "foundation/mathematics.hpp"
#include "models/growth/messages.generated.hpp"

namespace panicle::growth {
namespace {

constexpr std::uint32_t trunk_tag = 0, branch_tag = 1;
constexpr float tapered = 0.6f;  // radius at the end of a shoot over the radius of its last segment

// Builder of a tree as it is at a time, in steps: segments for all internodes that exist, numbered so that each comes
// after its parent. Shoots are numbered as in the population (`q`).
struct MomentBuilder {
  const Population& population;
  const Form& form;
  float time;
  const WoodHabit& habit;
  Moment moment;
  std::vector<std::uint32_t> children;  // of all shoots, consecutive by parent, in the order along it
  std::vector<std::uint32_t> first;     // of each shoot, the index of its first child in `children`; and the end

  // Whether a shoot has begun to grow.
  bool exists(std::uint32_t shoot) const {
    const ShootPath& path = form.paths[shoot];
    return path.count > 0 && grown_share(path.from, time) > 0;
  }

  // Lists the branches of each shoot, sorted by where they leave it from its foot up.
  void sort_children() {
    const std::size_t count = form.paths.size();
    first.assign(count + 1, 0);
    for (std::uint32_t q = 0; q < count; ++q)
      if (is_attached(q)) ++first[static_cast<std::size_t>(population.shoots[q].parent) + 1];
    for (std::size_t q = 0; q < count; ++q) first[q + 1] += first[q];
    children.resize(first[count]);
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t q = 0; q < count; ++q)
      if (is_attached(q)) children[next[static_cast<std::size_t>(population.shoots[q].parent)]++] = q;
    for (std::size_t q = 0; q < count; ++q)
      std::sort(children.begin() + first[q], children.begin() + first[q + 1], [&](std::uint32_t a, std::uint32_t b) {
        const ShootPath &one = form.paths[a], &other = form.paths[b];
        if (one.internode != other.internode) return one.internode < other.internode;
        return one.along != other.along ? one.along < other.along : a < b;
      });
  }

  // Whether a shoot exists and grows on another one.
  bool is_attached(std::uint32_t q) const {
    return population.shoots[q].parent >= 0 && !population.shoots[q].trunk && exists(q);
  }

  // Of each attached shoot, the segment that ends at its base.
  std::vector<std::int32_t> parent_segments;

  // Adds the segments of a shoot as far as it has grown, divided where branches leave it.
  void add_shoot(std::uint32_t q) {
    const Shoot& shoot = population.shoots[q];
    const ShootPath& path = form.paths[q];
    const bool standing = shoot.trunk;
    std::int32_t last = standing ? -1 : parent_segments[q];
    const glm::vec3* const nodes = &form.nodes[path.first];
    glm::vec3 at = last >= 0 ? moment.segments[static_cast<std::size_t>(last)].end : nodes[0];
    if (standing) moment.feet.push_back(at);
    if (!standing) ++moment.branches;
    std::uint32_t child = first[q];
    for (std::uint32_t i = 0; i < path.count; ++i) {
      const float share = grown_share(static_cast<std::uint16_t>(path.from + i), time);
      if (!(share > 0)) break;
      const glm::vec3 from = at, whole = share * (nodes[i + 1] - nodes[i]);
      for (; child < first[q + 1] && form.paths[children[child]].internode == i; ++child) {
        const glm::vec3 place = from + form.paths[children[child]].along * whole;
        if (glm::distance(place, at) > 0) add(q, last, at, place);
        parent_segments[children[child]] = last;
      }
      add(q, last, at, from + whole);
      moment.of_node[path.first + i + 1] = last;
    }
  }

  // Adds a segment of a shoot from `at` to `end` after the segment `last`; updates both.
  void add(std::uint32_t q, std::int32_t& last, glm::vec3& at, const glm::vec3& end) {
    Segment segment;
    segment.parent = last;
    segment.tag = population.shoots[q].trunk ? trunk_tag : branch_tag;
    segment.start = at;
    segment.end = end;
    last = static_cast<std::int32_t>(moment.segments.size());
    moment.segments.push_back(segment);
    moment.axes.push_back(static_cast<std::int32_t>(q));
    at = end;
  }

  // Computes the radii by the pipe model (Shinozaki 1964), from the tips down: radius^pipe is the sum over the shoots
  // above, of which young ones count in part.
  void thicken() {
    std::vector<float> sums(moment.segments.size(), 0);
    for (std::size_t i = moment.segments.size(); i-- > 0;) {
      const auto q = static_cast<std::uint32_t>(moment.axes[i]);
      if (!has_next(i)) sums[i] += grown_share(form.paths[q].from, time);
      if (moment.segments[i].parent >= 0) sums[static_cast<std::size_t>(moment.segments[i].parent)] += sums[i];
    }
    for (std::size_t i = 0; i < moment.segments.size(); ++i) {
      const Shoot& shoot = population.shoots[static_cast<std::size_t>(moment.axes[i])];
      const float twig = 0.5f * habit.twig * population.volumes[shoot.volume].height / 10;
      moment.segments[i].radius = twig * power(sums[i], 1 / habit.pipe);
    }
    for (std::size_t i = 0; i < moment.segments.size(); ++i)
      moment.segments[i].radius_end =
          has_next(i) ? moment.segments[next_[i]].radius : tapered * moment.segments[i].radius;
  }

  // Whether a segment's shoot has a segment after it.
  bool has_next(std::size_t i) {
    if (next_.empty()) {
      next_.assign(moment.segments.size(), none);
      for (std::size_t k = 0; k < moment.segments.size(); ++k) {
        const std::int32_t parent = moment.segments[k].parent;
        if (parent >= 0 && moment.axes[static_cast<std::size_t>(parent)] == moment.axes[k])
          next_[static_cast<std::size_t>(parent)] = k;
      }
    }
    return next_[i] != none;
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<std::size_t> next_ = {};
};

}  // namespace

// The share 0 … 1 of an internode of a step that is grown at a time.
float grown_share(std::uint16_t step, float time) {
  return std::clamp(time - static_cast<float>(step) + 1, 0.0f, 1.0f);
}

// Builds the segments of a tree at a time in steps. Returns an error if there are more than the limits allow.
Result<Moment> moment_of(const Population& population, const Form& form, float time, const WoodHabit& habit,
                         const Limits& limits) {
  MomentBuilder builder{population, form, time, habit, {}, {}, {}, {}};
  builder.moment.of_node.assign(form.nodes.size(), -1);
  builder.parent_segments.assign(form.paths.size(), -1);
  builder.sort_children();
  // Each shoot's internodes, and their parts where children are attached.
  builder.moment.segments.reserve(form.nodes.size());
  builder.moment.axes.reserve(form.nodes.size());
  for (std::uint32_t q = 0; q < form.paths.size(); ++q) {
    if (!builder.exists(q)) continue;
    builder.add_shoot(q);
    if (builder.moment.segments.size() > limits.segments)
      return Diagnostic{Reason::limit, message(messages::growth::too_many_shoots, limits.segments)};
  }
  builder.thicken();
  return std::move(builder.moment);
}

}  // namespace panicle::growth
