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
constexpr float tapered = 0.6f;          // radius at the end of a shoot over the radius of its last segment
constexpr float shortest_piece = 0.35f;  // of a curve, after a branch, as a share of a whole one
constexpr float smoothed = 0.7f;         // half the length over which thickness is smoothed, in internodes of the shoot

// Builder of a tree as it is at a time, in steps: segments for all internodes that exist, numbered so that each comes
// after its parent. Shoots are numbered as in the population (`q`).
struct MomentBuilder {
  const Population& population;
  const Form& form;
  float time;
  const WoodHabit& habit;
  const CurveHabit& curves;
  Moment moment;
  std::vector<std::uint32_t> children;  // of all shoots, consecutive by parent, in the order along it
  std::vector<std::uint32_t> first;     // of each shoot, the index of its first child in `children`; and the end

  // Whether a shoot has begun to grow.
  bool exists(std::uint32_t shoot) const {
    const ShootPath& path = form.paths[shoot];
    if (!form.shed.empty() && time >= static_cast<float>(form.shed[shoot])) return false;
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
    moment.first_of_shoot[q] = static_cast<std::int32_t>(moment.segments.size());
    if (curves.pieces > 0) return add_curved(q, last, at);
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

  // The same as a smooth curve: each internode is divided into pieces, and where branches leave it.
  void add_curved(std::uint32_t q, std::int32_t last, glm::vec3 at) {
    const ShootPath& path = form.paths[q];
    curve_.set(population, form, curves, q);
    std::uint32_t child = first[q];
    for (std::uint32_t i = 0; i < path.count; ++i) {
      const float share = grown_share(static_cast<std::uint16_t>(path.from + i), time);
      if (!(share > 0)) break;
      const glm::vec3 from = at;
      const std::uint32_t pieces = curve_.pieces(i);
      const float piece = 1 / static_cast<float>(pieces);
      for (std::uint32_t k = 1; k <= pieces; ++k) {
        const float upto = k == pieces ? 1 : static_cast<float>(k) * piece;
        float begin = upto - piece;
        for (; child < first[q + 1] && form.paths[children[child]].internode == i &&
               (k == pieces || form.paths[children[child]].along <= upto);
             ++child) {
          const float along = form.paths[children[child]].along;
          const glm::vec3 place = from + curve_.at(i, share * along);
          if (along > begin && glm::distance(place, at) > 0) add(q, last, at, place);
          begin = along;
          parent_segments[children[child]] = last;
        }
        // A branch near the end of a piece ends it.
        if (k < pieces && upto - begin < shortest_piece * piece) continue;
        add(q, last, at, from + curve_.at(i, share * upto));
      }
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
    add_removed(sums);
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
      moment.segments[i].radius_end = has_next(i) ? moment.segments[next_[i]].radius
                                                  : tapered_end(moment.axes[i], tapered) * moment.segments[i].radius;
    if (curves.pieces > 0) smooth_thickness();
  }

  // Makes the thickness of every shoot decrease evenly instead of in steps at its forks: after the last fork to the
  // tip, before it as the mean over a stretch of the shoot. No branch is thicker than its parent where it leaves.
  void smooth_thickness() {
    const std::vector<Segment>& segments = moment.segments;
    std::vector<std::uint8_t> forks(segments.size(), 0);  // whether a branch leaves at the end of a segment
    for (std::size_t i = 0; i < segments.size(); ++i)
      if (segments[i].parent >= 0 && moment.axes[static_cast<std::size_t>(segments[i].parent)] != moment.axes[i])
        forks[static_cast<std::size_t>(segments[i].parent)] = 1;
    for (std::size_t begin = 0, end = 0; begin < segments.size(); begin = end) {
      for (end = begin + 1; end < segments.size() && moment.axes[end] == moment.axes[begin];) ++end;
      smooth_shoot(begin, end, forks);
    }
  }

  // Smooths the thickness of the shoot whose segments are from `begin` to `end`.
  void smooth_shoot(std::size_t begin, std::size_t end, const std::vector<std::uint8_t>& forks) {
    std::vector<Segment>& segments = moment.segments;
    const std::size_t count = end - begin;
    lengths_.assign(count + 1, 0);
    for (std::size_t k = 0; k < count; ++k)
      lengths_[k + 1] = lengths_[k] + glm::distance(segments[begin + k].start, segments[begin + k].end);
    const float whole = lengths_[count];
    std::size_t tail = 0;
    for (std::size_t k = 0; k < count; ++k)
      if (forks[begin + k]) tail = k + 1;
    // Radii at the ends of segments, with the tail tapered; and their sums along the shoot.
    radii_.resize(count + 1);
    sums_.assign(count + 1, 0);
    for (std::size_t k = 0; k <= count; ++k) {
      const float radius = segments[begin + std::min(k, count - 1)].radius;
      const float along_tail = k > tail ? (lengths_[k] - lengths_[tail]) / (whole - lengths_[tail]) : 0;
      radii_[k] = radius * (1 + (tapered_end(moment.axes[begin], curves.tip) - 1) * along_tail);
    }
    for (std::size_t k = 0; k < count; ++k)
      sums_[k + 1] = sums_[k] + 0.5f * (radii_[k] + radii_[k + 1]) * (lengths_[k + 1] - lengths_[k]);
    const float stretch = smoothed * whole / static_cast<float>(std::max<std::size_t>(internodes_of(begin), 1));
    const std::int32_t parent = segments[begin].parent;
    float limit = parent >= 0 ? segments[static_cast<std::size_t>(parent)].radius_end : radii_[0];
    for (std::size_t k = 0; k <= count; ++k) {
      // At both ends the stretch is shorter: a shoot begins and ends as thick as it was.
      const float reach = std::min({stretch, lengths_[k], whole - lengths_[k]});
      const float radius =
          reach > 0 ? (sum_to(lengths_[k] + reach) - sum_to(lengths_[k] - reach)) / (2 * reach) : radii_[k];
      limit = std::min(limit, radius);
      if (k < count) segments[begin + k].radius = limit;
      if (k > 0) segments[begin + k - 1].radius_end = limit;
    }
  }

  // The number of internodes of a segment's shoot that exist.
  std::size_t internodes_of(std::size_t segment) const {
    const ShootPath& path = form.paths[static_cast<std::size_t>(moment.axes[segment])];
    std::size_t count = 0;
    while (count < path.count && moment.of_node[path.first + count + 1] >= 0) ++count;
    return count;
  }

  // The integral of the current shoot's radius from its base to a distance along it.
  float sum_to(float distance) const {
    const std::size_t after =
        static_cast<std::size_t>(std::upper_bound(lengths_.begin(), lengths_.end(), distance) - lengths_.begin());
    if (after == 0) return 0;
    if (after == lengths_.size()) return sums_.back();
    const std::size_t k = after - 1;
    const float length = lengths_[k + 1] - lengths_[k], share = length > 0 ? (distance - lengths_[k]) / length : 0;
    const float radius = radii_[k] + share * (radii_[k + 1] - radii_[k]);
    return sums_[k] + 0.5f * (radii_[k] + radius) * (distance - lengths_[k]);
  }

  // The thickness at the end of a shoot over that before its tip, which is `taper` where it is not cut.
  float tapered_end(std::int32_t axis, float taper) const {
    return !form.edited.empty() && form.edited[static_cast<std::size_t>(axis)].cut ? 1 : taper;
  }

  // Adds the shoots that edits removed to the segments that would carry them: wood is as thick as it grew before.
  void add_removed(std::vector<float>& sums) const {
    for (std::uint32_t q = 0; q < form.edited.size(); ++q) {
      const EditedShoot& edited = form.edited[q];
      if (edited.carrier < 0) continue;
      const ShootPath& on = form.paths[static_cast<std::size_t>(edited.carrier)];
      std::uint32_t node = edited.carrier_node;
      while (node > 0 && moment.of_node[on.first + node] < 0) --node;
      if (node > 0)
        sums[static_cast<std::size_t>(moment.of_node[on.first + node])] += grown_share(form.paths[q].from, time);
    }
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
  ShootCurve curve_ = {};
  std::vector<float> lengths_ = {}, radii_ = {}, sums_ = {};  // of the shoot that is smoothed
};

}  // namespace

// The share 0 … 1 of an internode of a step that is grown at a time.
float grown_share(std::uint16_t step, float time) {
  return std::clamp(time - static_cast<float>(step) + 1, 0.0f, 1.0f);
}

// Builds the segments of a tree at a time in steps. Returns an error if there are more than the limits allow.
Result<Moment> moment_of(const Population& population, const Form& form, float time, const WoodHabit& habit,
                         const Limits& limits, const CurveHabit& curves) {
  MomentBuilder builder{population, form, time, habit, curves, {}, {}, {}, {}};
  builder.moment.of_node.assign(form.nodes.size(), -1);
  builder.moment.first_of_shoot.assign(form.paths.size(), -1);
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
  if (limits.budget != nullptr) limits.budget->spend(builder.moment.segments.size());
  return std::move(builder.moment);
}

// Returns the segments of the internode that ends in a shoot's node (1 … path.count).
SegmentRange segments_of(const Moment& moment, const ShootPath& path, std::uint32_t shoot, std::uint32_t node) {
  const std::int32_t last = moment.of_node[path.first + node];
  if (last < 0) return {};
  const std::int32_t first = node > 1 ? moment.of_node[path.first + node - 1] + 1 : moment.first_of_shoot[shoot];
  return {static_cast<std::size_t>(first), static_cast<std::size_t>(last) + 1};
}

}  // namespace panicle::growth
