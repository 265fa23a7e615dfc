#include "models/flower/levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <utility>

#include "expression/diagnostics.hpp"
#include "foundation/bytes.hpp"
#include "light/sky_visibility.hpp"
#include "mesh/normals.hpp"
#include "models/flower/messages.generated.hpp"
#include "models/flower/skin.hpp"
#include "models/flower/thickness.hpp"
#include "models/flower/units.hpp"

namespace panicle::flower {
namespace {

// Most triangles of each level, and the share of them for parts that cannot be thinned further: the rest is for visible
// detail.
constexpr std::array<std::size_t, level_count> max_triangles{6000, 2200, 800, 260};
constexpr float least_share = 0.65f;
constexpr std::array<const char*, level_count> names{"level0", "level1", "level2", "level3"};
// Of organs close together one in this number remains; tried in this order.
constexpr std::array<std::uint32_t, 17> strides{1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 128, 256, 512, 1024, 4096};
// number of organs of a form that is a crowd, and of its organs that remain at least
constexpr std::uint32_t crowd = 8, few = 4;
// the stride of organs with others attached is this much smaller
constexpr std::uint32_t parent_stride_factor = 6;
constexpr float narrowest = 0.1f, fullest = 1.3f, widest_kite = 1.8f;  // bounds of a kite's width for its area
// greatest factor of the width of remaining organs
constexpr float widest = 4;
constexpr float sky_cells = 14;
constexpr std::uint32_t sky_directions = 14;

// Computes values that are the same for every flower of one map: those of an open flower of seed 1, with the variables
// that the map depends on. Returns false if they cannot be computed.
bool usual_values(const Program& program, const Given& given, const Limits& limits, const Derived& derived,
                  std::vector<VolumeValues>& values) {
  Given usual;
  usual.steps = given.steps;
  FlowerEvaluation evaluation(program, given);
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

// Texture coordinates of a boundary's vertices: the mean position in the organ over all corners of one material at a
// vertex. The entries of a vertex, one for each material, form a linked list.
class OrganCoordinates {
 public:
  // `numbers` are materials by volume; `corners` are the positions in organs by half-edge.
  OrganCoordinates(const generalized_map::Boundary& boundary, const std::vector<std::uint8_t>& numbers,
                   const std::vector<glm::vec2>& corners)
      : first_(boundary.surface.positions.size(), invalid) {
    const ClosedSurface& surface = boundary.surface;
    for (std::uint32_t h = 0; h < surface.half_edges(); ++h) {
      const std::uint8_t number = numbers[boundary.volume[surface.face[h]]];
      std::uint32_t* at = &first_[surface.origin[h]];
      while (*at != invalid && of_[*at].number != number) at = &of_[*at].next;
      if (*at == invalid) {
        *at = static_cast<std::uint32_t>(of_.size());
        of_.push_back({invalid, number, glm::vec3(corners[h], 1)});
      } else {
        of_[*at].sum += glm::vec3(corners[h], 1);
      }
    }
  }

  // The coordinates of a vertex for a material; the mean over all its materials if simplification brought the material
  // there.
  glm::vec2 at(std::uint32_t vertex, std::uint8_t number) const {
    glm::vec3 all(0);
    for (std::uint32_t i = first_[vertex]; i != invalid; i = of_[i].next) {
      if (of_[i].number == number) return glm::vec2(of_[i].sum) / of_[i].sum.z;
      all += of_[i].sum;
    }
    return glm::vec2(all) / all.z;
  }

 private:
  struct Entry {
    std::uint32_t next;
    std::uint8_t number;
    glm::vec3 sum;
  };
  std::vector<std::uint32_t> first_;  // by vertex
  std::vector<Entry> of_;
};

// Whether a triangle has two equal corners, and so no area.
bool is_flat(const std::array<std::uint32_t, 3>& triangle) {
  return triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0];
}

}  // namespace

// Builds all levels of detail of a flower: finds the forms of its organs and simplifies these.
FlowerLevels::FlowerLevels(const Program& program, const Given& given, const Limits& limits, Derived& derived,
                           generalized_map::Embedding& embedding)
    : boundary_(generalized_map::boundary_of(derived.map, embedding)),
      is_tube_(tubes_of(derived, boundary_)),
      corners_(derived, boundary_.surface, boundary_.volume) {
  // The vertices are placed by the values of an open flower of seed 1, so that all flowers of this map can share the
  // levels. `derived` has these values only for the call. Where they cannot be computed, this flower's own are used.
  std::vector<VolumeValues> usual;
  lasting_ = usual_values(program, given, limits, derived, usual);
  if (lasting_) std::swap(derived.values, usual);
  const std::vector<glm::vec3> places = rounded(derived, embedding);
  if (lasting_) std::swap(derived.values, usual);

  organs_.emplace(derived, boundary_, places);
  if (limits.budget != nullptr) limits.budget->spend(organs_->work());
  for (const std::size_t most : max_triangles) levels_.emplace_back(remains(choose(most), places), places);
}

// Of the organs of a form, one in this number remains.
std::uint32_t FlowerLevels::stride(const OrganForm& form, const Sparse& sparse) {
  const std::uint32_t thin = sparse.of_form;
  if (!form.rooted || form.organs < crowd) return 1;
  if (form.has_attached) return std::clamp(thin / parent_stride_factor, 1u, form.organs / few);
  return std::min(thin, form.organs / few);
}

// Of all organs that remain by their forms, one in this number remains.
std::uint32_t FlowerLevels::stride_of_all(const OrganForm& form, const Sparse& sparse) {
  return !form.rooted ? 1 : form.has_attached ? std::max(1u, sparse.of_all / parent_stride_factor) : sparse.of_all;
}

// Chooses the organs that remain: one in `stride` of each crowded form, of these one in `stride_of_all`. By organ, 1
// for those that remain; organs attached to one that does not are left out with it.
std::vector<std::uint8_t> FlowerLevels::retained_organs(const Sparse& sparse) const {
  const std::vector<FormedOrgan>& organs = organs_->organs();
  std::vector<std::uint8_t> retained(organs.size(), 1);
  // Counts of organs whose makers remain, by form; and of remaining organs with and without others attached.
  std::vector<std::uint32_t> count(organs_->forms().size(), 0);
  std::array<std::uint32_t, 2> of_all{};
  for (std::size_t i = 1; i < organs.size(); ++i) {
    const FormedOrgan& organ = organs[i];
    const OrganForm& form = organs_->form(organ);
    retained[i] = retained[organ.maker] != 0 && count[organ.form]++ % stride(form, sparse) == 0 &&
                  (!form.rooted || of_all[form.has_attached ? 1 : 0]++ % stride_of_all(form, sparse) == 0);
  }
  return retained;
}

// The number of triangles of the retained organs, simplified up to an error.
std::size_t FlowerLevels::triangles(const std::vector<std::uint8_t>& retained, float error) const {
  std::vector<std::size_t> of_form;
  for (const OrganForm& form : organs_->forms()) of_form.push_back(form.remaining(error));
  std::size_t sum = 0;
  for (std::size_t i = 0; i < retained.size(); ++i) sum += retained[i] != 0 ? of_form[organs_->organs()[i].form] : 0;
  return sum;
}

// Chooses organs and the error of simplification for at most `most` triangles. All organs are simplified to one error;
// crowds are thinned out only if that is not enough.
FlowerLevels::Choice FlowerLevels::choose(std::size_t most) const {
  constexpr float no_limit = std::numeric_limits<float>::max();
  Choice choice;
  std::vector<std::uint8_t>& retained = choice.organs;
  for (const std::uint32_t each : strides) {
    choice.sparse.of_form = each;
    retained = retained_organs(choice.sparse);
    if (static_cast<float>(triangles(retained, no_limit)) <= least_share * static_cast<float>(most)) break;
  }
  // Organs that are all different are no crowds, and may still be too many.
  for (std::size_t i = 1; i < strides.size() && triangles(retained, no_limit) > most; ++i) {
    choice.sparse.of_all = strides[i];
    retained = retained_organs(choice.sparse);
  }
  std::vector<float> errors{0};
  for (const OrganForm& form : organs_->forms()) {
    for (const Collapse& each : form.thinning) errors.push_back(each.error);
    errors.push_back(form.kite_error);
  }
  std::sort(errors.begin(), errors.end());
  const auto enough =
      std::partition_point(errors.begin(), errors.end(), [&](float each) { return triangles(retained, each) > most; });
  choice.error = enough == errors.end() ? no_limit : *enough;
  return choice;
}

// By form, the factor of width that gives a simplified organ the area that it had before.
std::vector<float> FlowerLevels::width_factors(float error, const std::vector<glm::vec3>& places) const {
  std::vector<float> width_factors(organs_->forms().size(), 1);
  for (const FormedOrgan& organ : organs_->organs()) {
    const OrganForm& form = organs_->form(organ);
    if (organ.number != 0 || !form.rooted) continue;
    const std::uint32_t* const own_vertices = organs_->vertices(organ);
    const auto at = [&](std::uint32_t v) { return places[own_vertices[v]]; };
    const std::vector<std::uint32_t> merged_into = form.targets(error);
    float area_before = 0, area_after = 0;
    const bool is_kite = form.is_kite(error);
    for (const auto& [a, b, c] : form.triangles) {
      area_before += triangle_area(at(a), at(b), at(c));
      if (!is_kite) area_after += triangle_area(at(merged_into[a]), at(merged_into[b]), at(merged_into[c]));
    }
    if (is_kite) {
      const auto& [foot, left, tip, right] = form.kite;
      area_after = 2 * (triangle_area(at(foot), at(left), at(tip)) + triangle_area(at(foot), at(tip), at(right)));
    }
    if (area_after > 0)
      width_factors[organ.form] =
          std::clamp(area_before / area_after, is_kite ? narrowest : 1.0f, is_kite ? widest_kite : fullest);
  }
  return width_factors;
}

// The triangles that remain in a level of detail: of each organ that remains, its simplified form or a kite of two
// triangles, connected to the organ that it is attached to.
Level::RemainingTriangles FlowerLevels::remains(const Choice& choice, const std::vector<glm::vec3>& places) const {
  const auto& [sparse, retained, error] = choice;
  const std::vector<FormedOrgan>& organs = organs_->organs();
  std::vector<std::vector<std::uint32_t>> merged_into;
  for (const OrganForm& form : organs_->forms()) merged_into.push_back(form.targets(error));
  const std::vector<float> width_factors = this->width_factors(error, places);

  // A vertex of a foot moves as in the organ that its organ is attached to.
  std::vector<std::uint32_t> moved_to(places.size());
  std::iota(moved_to.begin(), moved_to.end(), 0u);
  for (const FormedOrgan& organ : organs) {
    const OrganForm& form = organs_->form(organ);
    const std::uint32_t* const own_vertices = organs_->vertices(organ);
    for (std::uint32_t v = 0; v < form.is_foot.size(); ++v)
      if (form.is_foot[v] != 1) moved_to[own_vertices[v]] = own_vertices[merged_into[organ.form][v]];
  }
  const auto final_vertex = [&](std::uint32_t vertex) {
    while (moved_to[vertex] != vertex) vertex = moved_to[vertex];
    return vertex;
  };

  Level::RemainingTriangles remains;
  const auto add = [&](const std::array<std::uint32_t, 3>& corners, std::uint32_t face) {
    if (is_flat(corners)) return;
    remains.vertices.insert(remains.vertices.end(), corners.begin(), corners.end());
    remains.volumes.push_back(boundary_.volume[face]);
  };
  for (std::uint32_t i = 0; i < organs.size(); ++i) {
    if (retained[i] == 0) continue;
    const FormedOrgan& organ = organs[i];
    const OrganForm& form = organs_->form(organ);
    const std::uint32_t *const own_vertices = organs_->vertices(organ), *const faces = organs_->faces(organ);
    // A kite is a sheet of two triangles, each with both sides.
    if (form.is_kite(error)) {
      const std::uint32_t foot = final_vertex(own_vertices[form.kite[0]]), left = own_vertices[form.kite[1]],
                          tip = own_vertices[form.tip()], right = own_vertices[form.kite[3]];
      const auto [upper, lower] = form.kite_faces;
      add({foot, left, tip}, faces[upper]);
      add({foot, tip, right}, faces[upper]);
      add({foot, tip, left}, faces[lower]);
      add({foot, right, tip}, faces[lower]);
    } else {
      for (std::size_t t = 0; t < form.triangles.size(); ++t) {
        std::array<std::uint32_t, 3> corners = form.triangles[t];
        for (std::uint32_t& each : corners) each = merged_into[organ.form][each];
        if (is_flat(corners)) continue;
        for (std::uint32_t& each : corners) each = final_vertex(own_vertices[each]);
        add(corners, faces[form.faces[t]]);
      }
    }
    if (!form.rooted) continue;
    // Organs that remain of a crowd are wider by the number that each replaces, up to `widest`.
    const float crowded =
        form.has_attached ? 1
                          : std::min(widest, static_cast<float>(stride(form, sparse) * stride_of_all(form, sparse)));
    const float times = width_factors[organ.form] * crowded;
    if (times != 1) remains.wide.push_back({i, times});
  }
  return remains;
}

// Places the boundary by the flower's values and returns its vertices after one round of smoothing.
std::vector<glm::vec3> FlowerLevels::rounded(const Derived& derived, generalized_map::Embedding& embedding) {
  embedding.place(shapes_to_round(derived, is_tube_, 1));
  std::copy(embedding.positions().begin(), embedding.positions().end(), boundary_.surface.positions.begin());
  return rounded_vertices(boundary_.surface);
}

// Adds the meshes of all levels to a plant, with texture coordinates, materials and the visible share of the sky.
// `numbers` are the materials used so far; new ones are added.
void FlowerLevels::add_to(Plant& plant, const Program& program, const Derived& derived,
                          generalized_map::Embedding& embedding, std::vector<std::uint32_t>& numbers) {
  if (organs_->is_coarse()) plant.notes.push_back(message(messages::flower::levels_coarse, max_compared));
  const std::vector<glm::vec3> places = rounded(derived, embedding);
  // Numbers of materials by volume; an invalid one counts as 0. The levels are dressed anew only if any differs.
  std::vector<std::uint8_t> own(derived.map.volumes());
  for (std::uint32_t v = 0; v < own.size(); ++v) {
    const float m = derived.values[derived.record_of[v]][static_cast<std::size_t>(Field::material)];
    own[v] = m >= 0 && m < 256 && std::floor(m) == m ? static_cast<std::uint8_t>(m) : 0;
  }
  if (own != numbers_) {
    numbers_ = std::move(own);
    for (Level& level : levels_) level.dress(program, numbers_);
  }
  const OrganCoordinates coordinates(boundary_, numbers_, corners_.places(derived));

  // The index of each material among the plant's, for the column `paint`.
  std::array<std::uint8_t, 256> index{};
  std::array<bool, 256> is_known{};
  for (std::size_t i = 0; i < numbers.size(); ++i)
    index[numbers[i]] = static_cast<std::uint8_t>(i), is_known[numbers[i]] = true;
  std::vector<Occluder> occluders;
  const std::size_t first = plant.meshes.size();
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    const Level& level = levels_[k];
    std::vector<glm::vec3> wider = places;
    level.widen(*organs_, wider);
    // The nearest level's triangles occlude the sky of all levels.
    if (k == 0)
      for (std::size_t t = 0; t < level.triangles(); ++t) {
        const auto [a, b, c] = level.triangle(t);
        occluders.push_back({metres * y_up((wider[a] + wider[b] + wider[c]) / 3.0f),
                             metres * metres / 2 * triangle_area(wider[a], wider[b], wider[c])});
      }
    PlantMesh& out = plant.meshes.emplace_back(level.mesh(wider));
    out.name = names[k];
    out.material = "level";
    std::vector<std::uint8_t> paint;
    for (const std::uint8_t number : level.numbers()) {
      const glm::vec2 place = coordinates.at(level.vertex(paint.size()), number);
      out.mesh.uvs.insert(out.mesh.uvs.end(), {place.x, place.y});
      if (!is_known[number]) {
        is_known[number] = true;
        index[number] = static_cast<std::uint8_t>(numbers.size());
        numbers.push_back(number);
      }
      paint.push_back(index[number]);
    }
    out.columns.add("paint", std::move(paint));
  }
  const SkyVisibility open(plant.segments, occluders, sky_cells, sky_directions);
  for (std::size_t i = first; i < plant.meshes.size(); ++i)
    plant.meshes[i].columns.add("sky", open.of(plant.meshes[i].mesh));
}

// The memory that it holds, roughly.
std::uint64_t FlowerLevels::bytes() const {
  std::uint64_t bytes = 16ull * boundary_.surface.half_edges() + bytes_of(boundary_.surface.positions) +
                        bytes_of(boundary_.volume) + bytes_of(boundary_.face) + bytes_of(is_tube_) + corners_.bytes() +
                        bytes_of(numbers_) + organs_->bytes();
  for (const Level& level : levels_) bytes += level.bytes();
  return bytes;
}

}  // namespace panicle::flower
