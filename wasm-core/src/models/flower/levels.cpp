#include "models/flower/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "environment/openness.hpp"
#include "models/flower/ranks.hpp"
#include "models/flower/skin.hpp"
#include "models/flower/thickness.hpp"
#include "models/flower/upright.hpp"

namespace panicle::flower {
namespace {

// Triangles, at the most, and how much of that may be what cannot be thinned further: the rest is for what shows.
constexpr std::array<std::size_t, level_count> most_triangles{6000, 2200, 800, 260};
constexpr float least_share = 0.65f;
constexpr std::array<const char*, level_count> names{"level0", "level1", "level2", "level3"};
// Of what stands close together one in so many is left, in this order.
constexpr std::array<std::uint32_t, 17> strides{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 128, 256, 512, 1024, 4096};
constexpr std::uint32_t crowd = 8, few = 4;  // organs of a form: those are a crowd, and so many are left of it
constexpr std::uint32_t bearing = 6;         // by a sixth of the stride those are thinned that bear others
constexpr std::uint32_t fewest = 8;          // triangles of what has more than a kite's sides
constexpr float flat = 0.3f;                 // what a kite is off by, as a share of half its width
constexpr float narrowest = 0.1f, fullest = 1.3f, widest_kite = 1.8f;  // how wide it may be for its area
constexpr std::uint8_t free_foot = 2;  // of what stands attached, and so may go like any vertex
constexpr float widest = 4;            // times as wide what is left may be
constexpr float crease = -0.25f;       // the cosine between two normals that are not smoothed into one
constexpr float sky_cells = 14;
constexpr std::uint32_t sky_directions = 14;
constexpr std::array<const char*, 7> kinds{"petal", "sepal", "leaf", "stem", "stamen", "pistil", "seed"};

std::size_t place_of(std::string_view kind) {
  return static_cast<std::size_t>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
}

// What sizes are that the same map always has: those of an open flower of seed 1, with what the map depends on.
bool usual_values(const Program& program, const Given& given, const Limits& limits, const Derived& derived,
                  std::vector<VolumeValues>& values) {
  Given usual;
  usual.steps = given.steps;
  Evaluation evaluation(program, given);
  if (!evaluation.bind(limits)) return false;
  for (std::size_t i = 0; i < program.variables.size(); ++i) {
    const Variable& variable = program.variables[i];
    if (variable.rebuilds && variable.grammar == 0) usual.values.push_back({variable.name, evaluation.variables()[i]});
  }
  auto reworked = flower::reworked(program, usual, derived, limits);
  if (!reworked) return false;
  values = std::move(reworked.value());
  return true;
}

float area_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return 0.5f * glm::length(glm::cross(b - a, c - a));
}

// How many of a list of collapses are within an error.
std::size_t within(const std::vector<Collapse>& thinning, float error) {
  return static_cast<std::size_t>(
      std::upper_bound(thinning.begin(), thinning.end(), error,
                       [](float value, const Collapse& each) { return value < each.error; }) -
      thinning.begin());
}

// Where each vertex has gone when so many of them have.
std::vector<std::uint32_t> targets(const std::vector<Collapse>& thinning, std::size_t count, std::size_t vertices) {
  std::vector<std::uint32_t> to(vertices);
  std::iota(to.begin(), to.end(), 0u);
  while (count-- > 0) to[thinning[count].vertex] = to[thinning[count].into];
  return to;
}

bool is_flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) { return a == b || b == c || c == a; }

}  // namespace

Levels::Levels(const Program& program, const Given& given, const Limits& limits, Derived& derived,
               generalized_map::Embedding& embedding)
    : boundary_(generalized_map::boundary_of(derived.map, embedding)), is_tube_(tubes_of(derived, boundary_)) {
  const ClosedSurface& surface = boundary_.surface;
  begin_.resize(surface.faces + 1, surface.half_edges());
  for (std::uint32_t h = surface.half_edges(); h-- > 0;) begin_[surface.face[h]] = h;

  std::vector<VolumeValues> usual;
  lasting_ = usual_values(program, given, limits, derived, usual);
  if (lasting_) std::swap(derived.values, usual);
  const std::vector<glm::vec3> places = rounded(derived, embedding);
  if (lasting_) std::swap(derived.values, usual);

  find_organs(derived);
  // What a vertex belongs to that several hold: what stood there first.
  std::vector<std::uint32_t> owner(surface.positions.size(), nobody);
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
    const std::uint32_t volume = boundary_.volume[surface.face[h]];
    std::uint32_t& of = owner[surface.origin[h]];
    of = std::min(of, derived.records[derived.record_of[volume]].instance);
  }
  local_.assign(surface.positions.size(), nobody);
  for (std::uint32_t organ = 0; organ < organs_.size(); ++organ) find_form(derived, organ, places, owner);
  known_ = {};
  local_ = {};
  for (Organ& organ : organs_) organ.number = forms_[organ.form].organs++;
  for (std::uint32_t i = 1; i < organs_.size(); ++i) forms_[organs_[organs_[i].maker].form].bears = true;
  levels_.resize(level_count);
  for (std::size_t k = 0; k < level_count; ++k) choose(levels_[k], most_triangles[k], places);
}

// Of each the faces, in their order.
void Levels::find_organs(const Derived& derived) {
  organs_.resize(derived.instances.size());
  for (const Record& record : derived.records)
    if (record.instance != record.maker) organs_[record.instance].maker = record.maker;
  std::vector<std::uint32_t> count(organs_.size() + 1, 0), of_face(boundary_.surface.faces);
  for (std::uint32_t f = 0; f < boundary_.surface.faces; ++f) {
    of_face[f] = derived.records[derived.record_of[boundary_.volume[f]]].instance;
    ++count[of_face[f]];
  }
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < organs_.size(); ++i) {
    organs_[i].faces = next;
    next += std::exchange(count[i], next);
  }
  own_faces_.resize(next);
  for (std::uint32_t f = 0; f < boundary_.surface.faces; ++f) own_faces_[count[of_face[f]]++] = f;
}

// Numbers an organ's vertices as its faces come to them, and says how it hangs together: its faces' corners, and which
// of its vertices belong to what bears it.
std::vector<std::uint32_t> Levels::number_vertices(std::uint32_t organ, const std::vector<std::uint32_t>& owner) {
  const ClosedSurface& surface = boundary_.surface;
  Organ& of = organs_[organ];
  of.vertices = static_cast<std::uint32_t>(own_vertices_.size());
  const std::size_t end = organ + 1 < organs_.size() ? organs_[organ + 1].faces : own_faces_.size();
  std::vector<std::uint32_t> sign;
  for (std::size_t i = of.faces; i < end; ++i) {
    const std::uint32_t face = own_faces_[i];
    sign.push_back(begin_[face + 1] - begin_[face]);
    for (std::uint32_t h = begin_[face]; h < begin_[face + 1]; ++h) {
      const std::uint32_t vertex = surface.origin[h];
      if (local_[vertex] == nobody) {
        local_[vertex] = static_cast<std::uint32_t>(own_vertices_.size()) - of.vertices;
        own_vertices_.push_back(vertex);
      }
      sign.push_back(2 * local_[vertex] + (owner[vertex] != organ));
    }
  }
  for (std::size_t i = of.vertices; i < own_vertices_.size(); ++i) local_[own_vertices_[i]] = nobody;
  return sign;
}

void Levels::find_form(const Derived& derived, std::uint32_t organ, const std::vector<glm::vec3>& places,
                       const std::vector<std::uint32_t>& owner) {
  std::vector<std::uint32_t> sign = number_vertices(organ, owner);
  Organ& of = organs_[organ];
  const auto own = std::span<const std::uint32_t>(own_vertices_).subspan(of.vertices);
  glm::vec3 low(std::numeric_limits<float>::max()), high(-low);
  for (const std::uint32_t vertex : own) {
    low = glm::min(low, places[vertex]);
    high = glm::max(high, places[vertex]);
  }
  // Twice as large is another form: what is left of a leaf is too much of a petal.
  int size = 0;
  if (!own.empty()) std::frexp(glm::length(high - low), &size);
  const std::size_t corners = sign.size();
  sign.push_back(static_cast<std::uint32_t>(size + 1024));
  const auto same = known_.find(sign);
  of.form = same != known_.end() ? same->second : static_cast<std::uint32_t>(forms_.size());
  if (same != known_.end()) return;

  Form& form = forms_.emplace_back();
  Patch patch;
  for (const std::uint32_t vertex : own) patch.positions.push_back(places[vertex]);
  patch.is_fixed.assign(own.size(), 0);
  std::set<std::pair<std::uint32_t, std::uint32_t>> open;  // edges that have no face on their other side
  for (std::size_t i = 0, face = 0; i < corners; ++face) {
    const std::size_t first = i + 1, end = first + sign[i];
    for (std::size_t c = first; c < end; ++c) {
      const std::uint32_t a = sign[c] / 2, b = sign[c + 1 < end ? c + 1 : first] / 2;
      patch.is_fixed[a] = sign[c] % 2;
      if (c >= first + 2) {
        patch.triangles.push_back({sign[first] / 2, sign[c - 1] / 2, a});
        form.faces.push_back(static_cast<std::uint32_t>(face));
      }
      const auto other = open.find({b, a});
      if (other != open.end()) {
        open.erase(other);
      } else {
        open.insert({a, b});
      }
    }
    i = end;
  }
  form.triangles = patch.triangles;
  patch.counted = static_cast<std::uint32_t>(patch.triangles.size());
  // What others grow from, and its own foot, are closed for as long: else a hole would have no shape.
  while (!open.empty()) {
    std::vector<std::uint32_t> ring;
    for (auto edge = open.begin(); edge != open.end(); edge = open.lower_bound({ring.back(), 0})) {
      if (!ring.empty() && edge->first != ring.back()) break;
      if (ring.empty()) ring.push_back(edge->first);
      ring.push_back(edge->second);
      open.erase(edge);
    }
    for (std::size_t i = 2; i < ring.size(); ++i)
      if (!is_flat(ring[0], ring[i], ring[i - 1])) patch.triangles.push_back({ring[0], ring[i], ring[i - 1]});
  }
  form.thinning = thinning_of(patch);
  while (!form.thinning.empty() && form.thinning.back().triangles < fewest) form.thinning.pop_back();
  // What stands attached has a base of its own.
  form.is_foot = std::move(patch.is_fixed);
  if (organ > 0 && std::find(form.is_foot.begin(), form.is_foot.end(), 1) == form.is_foot.end())
    for (std::size_t i = 0, face = of.faces; i < corners; i += 1 + sign[i], ++face)
      if (boundary_.face[own_faces_[face]] == generalized_map::base_face)
        for (std::size_t c = i + 1; c <= i + sign[i]; ++c) form.is_foot[sign[c] / 2] = free_foot;
  std::vector<std::uint32_t> labels;
  for (std::size_t i = 0, face = of.faces; i < corners; i += 1 + sign[i], ++face)
    labels.push_back(derived.map.volume(boundary_.volume[own_faces_[face]]).label);
  find_kite(form, patch.positions, labels);
  known_.emplace(std::move(sign), of.form);
}

void Levels::find_kite(Form& form, const std::vector<glm::vec3>& places, const std::vector<std::uint32_t>& labels) {
  glm::vec3 foot(0);
  float feet = 0;
  for (std::uint32_t v = 0; v < places.size(); ++v) {
    if (form.is_foot[v] == 0) continue;
    if (feet == 0) form.kite[0] = v;
    foot += places[v];
    feet += 1;
  }
  form.rooted = feet > 0;
  if (!form.rooted) return;
  foot /= feet;
  const auto farthest = [&](auto how_far) {
    std::uint32_t best = form.kite[0];
    float most = 0;
    for (std::uint32_t v = 0; v < places.size(); ++v) {
      const float far = form.is_foot[v] == 0 ? how_far(places[v] - foot) : 0;
      if (far > most) most = far, best = v;
    }
    return best;
  };
  form.kite[2] = farthest([](const glm::vec3& way) { return glm::dot(way, way); });
  const glm::vec3 way = places[form.kite[2]] - foot;
  const auto across = [&](const glm::vec3& place) {
    return place - glm::dot(place, way) / std::max(glm::dot(way, way), 1e-20f) * way;
  };
  form.kite[1] = farthest([&](const glm::vec3& place) { return glm::dot(across(place), across(place)); });
  const glm::vec3 side = across(places[form.kite[1]] - foot);
  form.kite[3] = farthest([&](const glm::vec3& place) { return -glm::dot(across(place), side); });
  const float half = glm::length(side), before = form.thinning.empty() ? 0 : form.thinning.back().error;
  form.kite_error = std::max(before, half * flat);

  // Each side is of what most of it is made of.
  const glm::vec3 normal = glm::cross(side, way);
  for (std::size_t k = 0; k < 2; ++k) {
    std::map<std::uint32_t, float> area;  // by label
    float most = 0;
    for (std::size_t t = 0; t < form.triangles.size(); ++t) {
      const auto& [a, b, c] = form.triangles[t];
      const float like = glm::dot(normal, glm::cross(places[b] - places[a], places[c] - places[a]));
      if (k == 0 ? like <= 0 : like >= 0) continue;
      float& all = area[labels[form.faces[t]]];
      all += std::abs(like);
      if (all > most) most = all, form.kite_faces[k] = form.faces[t];
    }
  }
}

std::uint32_t Levels::stride(const Organ& organ, std::uint32_t thin) const {
  const Form& form = forms_[organ.form];
  if (!form.rooted || form.organs < crowd) return 1;
  if (form.bears) return std::clamp(thin / bearing, 1u, form.organs / few);
  return std::min(thin, form.organs / few);
}

std::uint32_t Levels::stride_of_all(const Organ& organ, std::uint32_t thin) const {
  const Form& form = forms_[organ.form];
  return !form.rooted ? 1 : form.bears ? std::max(1u, thin / bearing) : thin;
}

std::vector<std::uint8_t> Levels::kept(const Sparse& sparse) const {
  std::vector<std::uint8_t> kept(organs_.size(), 1);
  // Of each form, those whose bearers are kept; and of those that are left, what bears and what does not.
  std::vector<std::uint32_t> count(forms_.size(), 0);
  std::array<std::uint32_t, 2> of_all{};
  for (std::size_t i = 1; i < organs_.size(); ++i) {
    const Organ& organ = organs_[i];
    const Form& form = forms_[organ.form];
    kept[i] = kept[organ.maker] != 0 && count[organ.form]++ % stride(organ, sparse.of_form) == 0 &&
              (!form.rooted || of_all[form.bears ? 1 : 0]++ % stride_of_all(organ, sparse.of_all) == 0);
  }
  return kept;
}

std::size_t Levels::triangles(const std::vector<std::uint8_t>& kept, float error) const {
  std::vector<std::size_t> of_form(forms_.size());
  for (std::size_t i = 0; i < forms_.size(); ++i) {
    const std::size_t gone = within(forms_[i].thinning, error);
    of_form[i] = forms_[i].is_kite(error) ? 4
                 : gone == 0              ? forms_[i].triangles.size()
                                          : forms_[i].thinning[gone - 1].triangles;
  }
  std::size_t all = 0;
  for (std::size_t i = 0; i < organs_.size(); ++i) all += kept[i] != 0 ? of_form[organs_[i].form] : 0;
  return all;
}

// Thins all organs to one error, and crowds only where that is not enough.
void Levels::choose(Level& level, std::size_t most, const std::vector<glm::vec3>& places) {
  constexpr float all = std::numeric_limits<float>::max();
  std::vector<std::uint8_t> there;
  Sparse sparse;
  for (const std::uint32_t each : strides) {
    sparse.of_form = each;
    there = kept(sparse);
    if (static_cast<float>(triangles(there, all)) <= least_share * static_cast<float>(most)) break;
  }
  // Organs that are all unlike are no crowds, and may still be too many.
  for (std::size_t i = 1; i < strides.size() && triangles(there, all) > most; ++i) {
    sparse.of_all = strides[i];
    there = kept(sparse);
  }
  std::vector<float> errors{0};
  for (const Form& form : forms_) {
    for (const Collapse& each : form.thinning) errors.push_back(each.error);
    errors.push_back(form.kite_error);
  }
  std::sort(errors.begin(), errors.end());
  const auto enough =
      std::partition_point(errors.begin(), errors.end(), [&](float error) { return triangles(there, error) > most; });
  const float error = enough == errors.end() ? all : *enough;

  std::vector<std::vector<std::uint32_t>> to(forms_.size());
  std::vector<float> fuller(forms_.size(), 1);  // what thinning has taken of an organ's area is made up for
  for (std::size_t i = 0; i < forms_.size(); ++i)
    to[i] = targets(forms_[i].thinning, within(forms_[i].thinning, error), forms_[i].is_foot.size());
  std::vector<std::uint32_t> gone(places.size());
  std::iota(gone.begin(), gone.end(), 0u);
  for (std::uint32_t i = 0; i < organs_.size(); ++i) {
    const Organ& organ = organs_[i];
    const Form& form = forms_[organ.form];
    const std::uint32_t* const own = &own_vertices_[organ.vertices];
    for (std::uint32_t v = 0; v < form.is_foot.size(); ++v)
      if (form.is_foot[v] != 1) gone[own[v]] = own[to[organ.form][v]];
    if (organ.number != 0 || !form.rooted) continue;
    float before = 0, behind = 0;
    const bool is_kite = form.is_kite(error);
    for (const auto& [a, b, c] : form.triangles) {
      const auto at = [&](std::uint32_t v) { return places[own[v]]; };
      const auto& target = to[organ.form];
      before += area_of(at(a), at(b), at(c));
      if (!is_kite) behind += area_of(at(target[a]), at(target[b]), at(target[c]));
    }
    if (is_kite) {
      const auto at = [&](std::size_t k) { return places[own[form.kite[k]]]; };
      behind = 2 * (area_of(at(0), at(1), at(2)) + area_of(at(0), at(2), at(3)));
    }
    fuller[organ.form] =
        behind > 0 ? std::clamp(before / behind, is_kite ? narrowest : 1.0f, is_kite ? widest_kite : fullest) : 1;
  }
  const auto last = [&](std::uint32_t vertex) {
    while (gone[vertex] != vertex) vertex = gone[vertex];
    return vertex;
  };
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t i = 0; i < organs_.size(); ++i) {
    if (there[i] == 0) continue;
    const Organ& organ = organs_[i];
    const Form& form = forms_[organ.form];
    const std::uint32_t* const own = &own_vertices_[organ.vertices];
    const bool is_kite = form.is_kite(error);
    for (std::size_t k = 0; k < 4 && is_kite; ++k) {
      // Left and right of the upper side, then of the lower.
      const std::array<std::size_t, 3> of = k == 0   ? std::array<std::size_t, 3>{0, 1, 2}
                                            : k == 1 ? std::array<std::size_t, 3>{0, 2, 3}
                                            : k == 2 ? std::array<std::size_t, 3>{0, 2, 1}
                                                     : std::array<std::size_t, 3>{0, 3, 2};
      std::array<std::uint32_t, 3> corner{};
      for (std::size_t c = 0; c < 3; ++c) corner[c] = of[c] == 0 ? last(own[form.kite[0]]) : own[form.kite[of[c]]];
      if (is_flat(corner[0], corner[1], corner[2])) continue;
      vertices.insert(vertices.end(), corner.begin(), corner.end());
      level.volumes.push_back(boundary_.volume[own_faces_[organ.faces + form.kite_faces[k / 2]]]);
    }
    for (std::size_t t = 0; t < form.triangles.size() && !is_kite; ++t) {
      std::array<std::uint32_t, 3> corner = form.triangles[t];
      for (std::uint32_t& each : corner) each = to[organ.form][each];
      if (is_flat(corner[0], corner[1], corner[2])) continue;
      for (std::uint32_t& each : corner) each = last(own[each]);
      if (is_flat(corner[0], corner[1], corner[2])) continue;
      vertices.insert(vertices.end(), corner.begin(), corner.end());
      level.volumes.push_back(boundary_.volume[own_faces_[organ.faces + form.faces[t]]]);
    }
    if (!form.rooted) continue;
    const float crowded =
        form.bears
            ? 1
            : std::min(widest, static_cast<float>(stride(organ, sparse.of_form) * stride_of_all(organ, sparse.of_all)));
    const float times = fuller[organ.form] * crowded;
    if (times != 1) level.wide.push_back({i, times});
  }
  smoothen(level, vertices, places);
}

// Parts vertices where the surface has an edge there.
void Levels::smoothen(Level& level, const std::vector<std::uint32_t>& vertices, const std::vector<glm::vec3>& places) {
  std::vector<glm::vec3> normals;  // of `smooth`, sums
  // Of each vertex the first of its sides, and of each side the next.
  std::vector<std::uint32_t> first(places.size(), nobody), next;
  for (std::size_t t = 0; t < vertices.size(); t += 3) {
    const glm::vec3 &a = places[vertices[t]], &b = places[vertices[t + 1]], &c = places[vertices[t + 2]];
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float length = glm::length(normal);
    for (std::size_t i = t; i < t + 3; ++i) {
      std::uint32_t* side = &first[vertices[i]];
      while (*side != nobody && glm::dot(normals[*side], normal) < crease * glm::length(normals[*side]) * length)
        side = &next[*side];
      if (*side == nobody) {
        *side = static_cast<std::uint32_t>(level.smooth.size());
        level.corners.push_back(*side);
        level.smooth.push_back(vertices[i]);
        normals.push_back(normal);
        // From here on `side` may point to what was.
        next.push_back(nobody);
      } else {
        normals[*side] += normal;
        level.corners.push_back(*side);
      }
    }
  }
}

// A run for each kind of material, and a vertex for each material that meets in it.
void Levels::dress(Level& level, const Program& program) {
  std::array<std::size_t, 256> kind{};
  for (std::uint32_t number = 0; number < kind.size(); ++number)
    kind[number] = place_of(material_of(program, number).kind);
  std::array<std::vector<std::uint32_t>, kinds.size()> triangles;
  for (std::uint32_t t = 0; t < level.volumes.size(); ++t) triangles[kind[numbers_[level.volumes[t]]]].push_back(t);
  level.runs.clear();
  level.indices.clear();
  level.drawn.clear();
  level.number.clear();
  // Of what has one normal the first of its vertices, and of each vertex the next: one a material.
  std::vector<std::uint32_t> first(level.smooth.size(), nobody), next;
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (triangles[k].empty()) continue;
    MeshRun run;
    run.name = kinds[k];
    run.first_vertex = static_cast<std::uint32_t>(level.drawn.size());
    run.first_index = static_cast<std::uint32_t>(level.indices.size());
    for (const std::uint32_t t : triangles[k])
      for (std::size_t i = 3 * std::size_t{t}; i < 3 * std::size_t{t} + 3; ++i) {
        const std::uint8_t number = numbers_[level.volumes[t]];
        std::uint32_t vertex = first[level.corners[i]], last = nobody;
        while (vertex != nobody && level.number[vertex] != number) vertex = next[last = vertex];
        if (vertex == nobody) {
          vertex = static_cast<std::uint32_t>(level.drawn.size());
          (last == nobody ? first[level.corners[i]] : next[last]) = vertex;
          next.push_back(nobody);
          level.drawn.push_back(level.corners[i]);
          level.number.push_back(number);
        }
        level.indices.push_back(vertex);
      }
    run.vertex_count = static_cast<std::uint32_t>(level.drawn.size()) - run.first_vertex;
    run.index_count = static_cast<std::uint32_t>(level.indices.size()) - run.first_index;
    level.runs.push_back(std::move(run));
  }
}

std::vector<glm::vec3> Levels::rounded(const Derived& derived, generalized_map::Embedding& embedding) {
  embedding.place(shapes_to_round(derived, is_tube_, 1));
  std::copy(embedding.positions().begin(), embedding.positions().end(), boundary_.surface.positions.begin());
  return rounded_vertices(boundary_.surface);
}

// Across the way from an organ's foot to its tip.
void Levels::widen(const Level& level, std::vector<glm::vec3>& places) const {
  for (const auto& [organ, times] : level.wide) {
    const Form& form = forms_[organs_[organ].form];
    const std::uint32_t* const own = &own_vertices_[organs_[organ].vertices];
    glm::vec3 foot(0);
    float feet = 0;
    for (std::size_t v = 0; v < form.is_foot.size(); ++v)
      if (form.is_foot[v] != 0) foot += places[own[v]], feet += 1;
    foot /= feet;
    const glm::vec3 way = places[own[form.tip()]] - foot;
    const float square = glm::dot(way, way);
    if (!(square > 0)) continue;
    for (std::size_t v = 0; v < form.is_foot.size(); ++v) {
      if (form.is_foot[v] != 0) continue;
      glm::vec3& place = places[own[v]];
      const glm::vec3 on = foot + glm::dot(place - foot, way) / square * way;
      place = on + times * (place - on);
    }
  }
}

void Levels::add_to(Plant& plant, const Program& program, const Derived& derived, generalized_map::Embedding& embedding,
                    std::vector<std::uint32_t>& numbers) {
  const ClosedSurface& surface = boundary_.surface;
  const std::vector<glm::vec3> places = rounded(derived, embedding);
  std::vector<std::uint8_t> own(derived.map.volumes());
  for (std::uint32_t v = 0; v < own.size(); ++v) {
    const float m = derived.values[derived.record_of[v]][static_cast<std::size_t>(Field::material)];
    own[v] = m >= 0 && m < 256 && std::floor(m) == m ? static_cast<std::uint8_t>(m) : 0;
  }
  if (own != numbers_) {
    numbers_ = std::move(own);
    for (Level& level : levels_) dress(level, program);
  }
  // Where in its organ each vertex is: the mean of the faces about it.
  const std::vector<glm::vec2> in_organs = places_in_organs(derived);
  std::vector<glm::vec3> about(places.size(), glm::vec3(0));
  for (std::uint32_t h = 0; h < surface.half_edges(); ++h)
    about[surface.origin[h]] += glm::vec3(in_organs[boundary_.volume[surface.face[h]]], 1);

  std::array<std::uint8_t, 256> index{};
  std::array<bool, 256> is_known{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    index[numbers[i]] = static_cast<std::uint8_t>(i), is_known[numbers[i]] = true;
  std::vector<Screen> screens;
  const std::size_t first = plant.meshes.size();
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const Level& level = levels_[k];
    std::vector<glm::vec3> wider = places, normals(level.smooth.size(), glm::vec3(0));
    widen(level, wider);
    for (std::size_t t = 0; t < level.corners.size(); t += 3) {
      const std::uint32_t* const corner = &level.corners[t];
      const glm::vec3 &a = wider[level.smooth[corner[0]]], &b = wider[level.smooth[corner[1]]],
                      &c = wider[level.smooth[corner[2]]];
      const glm::vec3 normal = glm::cross(b - a, c - a);
      for (std::size_t i = 0; i < 3; ++i) normals[corner[i]] += normal;
      if (k == 0)
        screens.push_back({metres * upright((a + b + c) / 3.0f), 0.25f * metres * metres * glm::length(normal)});
    }
    PlantMesh& out = plant.meshes.emplace_back();
    out.name = names[k];
    out.material = "level";
    out.runs = level.runs;
    out.mesh.indices = level.indices;
    out.mesh.positions.resize(3 * level.drawn.size());
    out.mesh.normals.resize(3 * level.drawn.size());
    out.mesh.uvs.resize(2 * level.drawn.size());
    std::vector<std::uint8_t> paint(level.drawn.size());
    for (std::size_t v = 0; v < level.drawn.size(); ++v) {
      const std::uint32_t vertex = level.smooth[level.drawn[v]];
      const glm::vec3& normal = normals[level.drawn[v]];
      const float length = glm::length(normal);
      put(metres * upright(wider[vertex]), &out.mesh.positions[3 * v]);
      put(upright(length > 1e-20f ? normal / length : glm::vec3(0, 0, 1)), &out.mesh.normals[3 * v]);
      out.mesh.uvs[2 * v] = about[vertex].x / about[vertex].z;
      out.mesh.uvs[2 * v + 1] = about[vertex].y / about[vertex].z;
      const std::uint8_t number = level.number[v];
      if (!is_known[number]) {
        is_known[number] = true;
        index[number] = static_cast<std::uint8_t>(numbers.size());
        numbers.push_back(number);
      }
      paint[v] = index[number];
    }
    out.columns.add("paint", std::move(paint));
  }
  const Openness open(plant.segments, screens, sky_cells, sky_directions);
  for (std::size_t i = first; i < plant.meshes.size(); ++i)
    plant.meshes[i].columns.add("sky", open.of(plant.meshes[i].mesh));
}

std::uint64_t Levels::bytes() const {
  const auto of = [](const auto& all) { return all.capacity() * std::uint64_t{sizeof(all[0])}; };
  std::uint64_t bytes = 16ull * boundary_.surface.half_edges() + of(boundary_.surface.positions) +
                        of(boundary_.volume) + of(boundary_.face) + of(begin_) + of(is_tube_) + of(organs_) +
                        of(own_vertices_) + of(own_faces_) + of(numbers_);
  for (const Form& form : forms_)
    bytes += sizeof form + of(form.triangles) + of(form.faces) + of(form.thinning) + of(form.is_foot);
  for (const Level& level : levels_)
    bytes += of(level.corners) + of(level.volumes) + of(level.smooth) + of(level.wide) + of(level.indices) +
             of(level.drawn) + of(level.number);
  return bytes;
}

}  // namespace panicle::flower
